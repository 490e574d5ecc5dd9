//! `/bearing/state`, `/bearing/balls` and `/bearing/wear` of a run: a sample in the units that a plot wants.

use super::overview::Overview;
use crate::ball;
use crate::messages::{fields, fill};
use crate::timeline::timestamp;
use crate::units::{BILLION, CUBIC_MICROMETRE, MICRO_PER_UNIT, MILLI_PER_UNIT, degrees};
use crate::wire::Numbers;
use crate::wire::tribodyn::{Balls, TransientState, Wear};
use std::sync::LazyLock;
use tribodyn_bearing::quantities::{Quantity, RPM_PER_RAD_S};
use tribodyn_bearing::{BallResult, Races};
use tribodyn_dynamics::{FreeCageSample, POWER_IN, POWER_LOST, PowerSample, RingSample, WearSample};

static IN: LazyLock<Vec<(&Quantity<PowerSample>, usize)>> = LazyLock::new(|| fields::<TransientState, _>(&POWER_IN));
static LOST: LazyLock<Vec<(&Quantity<PowerSample>, usize)>> =
    LazyLock::new(|| fields::<TransientState, _>(&POWER_LOST));

/// Rings, cage, powers and extremes of the balls.
pub(crate) fn state(overview: &Overview, log_time: u64, impacts: u64) -> TransientState {
    let sample = &overview.sample;
    let (inner, outer, cage) = (&sample.inner, &sample.outer, &sample.cage);
    let [inner_x, inner_y, inner_z] = inner.displacement_m.map(|x| x * MICRO_PER_UNIT);
    let [outer_x, outer_y, outer_z] = outer.displacement_m.map(|x| x * MICRO_PER_UNIT);
    let [inner_vx, inner_vy, inner_vz] = inner.velocity_m_s.map(|x| x * MILLI_PER_UNIT);
    let [outer_vx, outer_vy, outer_vz] = outer.velocity_m_s.map(|x| x * MILLI_PER_UNIT);
    let mut message = TransientState {
        timestamp: Some(timestamp(log_time)),
        time_s: sample.time_s,
        cage_angle_deg: degrees(cage.angle_rad),
        shaft_angle_deg: degrees(inner.angle_rad),
        inner_displacement_x_um: inner_x,
        inner_displacement_y_um: inner_y,
        inner_displacement_z_um: inner_z,
        inner_velocity_x_mm_s: inner_vx,
        inner_velocity_y_mm_s: inner_vy,
        inner_velocity_z_mm_s: inner_vz,
        inner_acceleration_x_m_s2: inner.acceleration_m_s2[0],
        inner_acceleration_y_m_s2: inner.acceleration_m_s2[1],
        inner_acceleration_z_m_s2: inner.acceleration_m_s2[2],
        inner_ball_force_x_n: inner.ball_force_n[0],
        inner_ball_force_y_n: inner.ball_force_n[1],
        inner_ball_force_z_n: inner.ball_force_n[2],
        outer_displacement_x_um: outer_x,
        outer_displacement_y_um: outer_y,
        outer_displacement_z_um: outer_z,
        outer_velocity_x_mm_s: outer_vx,
        outer_velocity_y_mm_s: outer_vy,
        outer_velocity_z_mm_s: outer_vz,
        outer_acceleration_x_m_s2: outer.acceleration_m_s2[0],
        outer_acceleration_y_m_s2: outer.acceleration_m_s2[1],
        outer_acceleration_z_m_s2: outer.acceleration_m_s2[2],
        outer_ball_force_x_n: outer.ball_force_n[0],
        outer_ball_force_y_n: outer.ball_force_n[1],
        outer_ball_force_z_n: outer.ball_force_n[2],
        inner_speed_rpm: inner.speed_rad_s * RPM_PER_RAD_S,
        outer_speed_rpm: outer.speed_rad_s * RPM_PER_RAD_S,
        inner_torque_nm: inner.torque_nm,
        outer_torque_nm: outer.torque_nm,
        cage_speed_rpm: cage.speed_rad_s * RPM_PER_RAD_S,
        orbital_speed_mean_rpm: overview.orbital_speed_rad_s * RPM_PER_RAD_S,
        cage_acceleration_rad_s2: cage.acceleration_rad_s2,
        cage_ball_torque_nmm: cage.ball_torque_nm * MILLI_PER_UNIT,
        cage_fluid_torque_nmm: cage.fluid_torque_nm * MILLI_PER_UNIT,
        balls_in_contact: overview.in_contact,
        impacts: u32::try_from(impacts).unwrap_or(u32::MAX),
        energy_j: sample.power.energy_j,
        imbalance_ppb: imbalance_ppb(sample.power.imbalance_j, sample.power.throughput_j),
        ..TransientState::default()
    };
    tilts(&mut message, [inner, outer]);
    cage.free.iter().for_each(|free| free_cage(&mut message, free));
    fill(&mut message, &IN, &sample.power);
    fill(&mut message, &LOST, &sample.power);
    for (quantity, place, value) in overview.over_balls() {
        message.set_number(place, value * quantity.facts().shown.per_si);
    }
    message
}

fn tilts(message: &mut TransientState, rings: [&RingSample; 2]) {
    let [inner, outer] = rings.map(|ring| ring.tilt_rad.map(|tilt| tilt * MILLI_PER_UNIT));
    [message.inner_tilt_x_mrad, message.inner_tilt_y_mrad] = inner;
    [message.outer_tilt_x_mrad, message.outer_tilt_y_mrad] = outer;
}

/// Where a free cage is, and what its lands do.
fn free_cage(message: &mut TransientState, cage: &FreeCageSample) {
    message.cage_free = true;
    [message.cage_x_um, message.cage_y_um, message.cage_z_um] = cage.centre_m.map(|x| x * MICRO_PER_UNIT);
    [message.cage_tilt_x_mrad, message.cage_tilt_y_mrad] = cage.tilt_rad.map(|tilt| tilt * MILLI_PER_UNIT);
    let Races { inner, outer } = &cage.land_force_n;
    [message.land_inner_x_n, message.land_inner_y_n] = [inner[0], inner[1]];
    [message.land_outer_x_n, message.land_outer_y_n] = [outer[0], outer[1]];
    let gaps = cage.land_gap_m.iter().filter_map(|(_, gap)| *gap);
    message.land_gap_um = gaps.reduce(f64::min).map_or(0.0, |gap| gap * MICRO_PER_UNIT);
    (message.land_friction_w, message.land_film_w) = (cage.land_friction_w, cage.land_film_w);
}

/// At the start nothing has been put in and nothing can be missing.
fn imbalance_ppb(imbalance: f64, throughput: f64) -> f64 {
    if throughput > 0.0 { imbalance / throughput * BILLION } else { 0.0 }
}

/// Wear up to a time, s.
pub(crate) fn wear(wear: &WearSample, time_s: f64, log_time: u64) -> Wear {
    Wear {
        timestamp: Some(timestamp(log_time)),
        time_s,
        volume_inner_um3: wear.volume_inner_m3 * CUBIC_MICROMETRE,
        volume_outer_um3: wear.volume_outer_m3 * CUBIC_MICROMETRE,
        volume_cage_um3: wear.volume_cage_m3 * CUBIC_MICROMETRE,
        coating_inner_min_um: wear.coating_inner_min_m * MICRO_PER_UNIT,
        coating_outer_min_um: wear.coating_outer_min_m * MICRO_PER_UNIT,
    }
}

/// All balls.
pub(crate) fn balls(balls: &[BallResult], time_s: f64, log_time: u64) -> Balls {
    Balls {
        timestamp: Some(timestamp(log_time)),
        time_s,
        balls: balls.iter().enumerate().map(|(i, ball)| ball::message(i, ball)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_every_power_has_a_field() {
        assert_eq!((IN.len(), LOST.len()), (POWER_IN.len(), POWER_LOST.len()));
    }
}
