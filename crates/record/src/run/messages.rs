//! `/bearing/state`, `/bearing/balls` and `/bearing/wear` of a run: a sample in the units that a plot wants.

use crate::ball::{self, Derived};
use crate::timeline::timestamp;
use crate::units::{BILLION, CUBIC_MICROMETRE, GIGA, MICRO_PER_UNIT, MILLI_PER_UNIT, RPM_PER_RAD_S, degrees};
use crate::wire::tribodyn::{Balls, TransientState, Wear};
use std::f64::consts::PI;
use tribodyn_bearing::Geometry;
use tribodyn_dynamics::{BallSample, Sample, WearSample};

/// What of the balls is the same all through a run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BallConstants {
    /// Half the pitch diameter, m.
    pitch_radius: f64,
    /// Mass, kg.
    mass: f64,
    /// Moment of inertia, kg m².
    inertia: f64,
}

impl BallConstants {
    /// Homogeneous spheres of the density, kg/m³.
    pub(crate) fn new(geometry: &Geometry, density: f64) -> Self {
        let diameter = geometry.ball_diameter;
        let mass = density * PI / 6.0 * diameter.powi(3);
        Self { pitch_radius: 0.5 * geometry.pitch_diameter, mass, inertia: 0.1 * mass * diameter * diameter }
    }

    fn derived(&self, b: &BallSample) -> Derived {
        let orbit = b.orbital_speed_rad_s;
        Derived {
            centrifugal_n: self.mass * b.orbit_radius_m * orbit * orbit,
            // J |ω_m e_a × Ω|: the axial part of the spin drops out.
            gyroscopic_nm: self.inertia * orbit.abs() * b.spin_rad_s[1].hypot(b.spin_rad_s[2]),
            fluid_w: b.drag_n * b.orbit_radius_m * orbit + b.churning_w,
        }
    }
}

/// Rings, cage, powers and extremes of the balls.
pub(crate) fn state(sample: &Sample, log_time: u64, impacts: u64) -> TransientState {
    let (inner, outer, cage) = (&sample.inner, &sample.outer, &sample.cage);
    let largest = |get: fn(&BallSample) -> f64| sample.balls.iter().map(get).fold(f64::MIN, f64::max);
    let smallest = |get: fn(&BallSample) -> f64| sample.balls.iter().map(get).fold(f64::MAX, f64::min);
    let mean_orbital = sample.balls.iter().map(|b| b.orbital_speed_rad_s).sum::<f64>() / sample.balls.len() as f64;
    let loaded = |b: &&BallSample| b.inner.load_n > 0.0 && b.outer.load_n > 0.0;
    let [inner_x_um, inner_y_um, inner_z_um] = inner.displacement_m.map(|x| x * MICRO_PER_UNIT);
    let [outer_x_um, outer_y_um, outer_z_um] = outer.displacement_m.map(|x| x * MICRO_PER_UNIT);
    let [inner_vx, inner_vy, inner_vz] = inner.velocity_m_s.map(|x| x * MILLI_PER_UNIT);
    let [outer_vx, outer_vy, outer_vz] = outer.velocity_m_s.map(|x| x * MILLI_PER_UNIT);
    TransientState {
        timestamp: Some(timestamp(log_time)),
        time_s: sample.time_s,
        cage_angle_deg: degrees(cage.angle_rad),
        shaft_angle_deg: degrees(inner.angle_rad),
        inner_x_um,
        inner_y_um,
        inner_z_um,
        inner_velocity_x_mm_s: inner_vx,
        inner_velocity_y_mm_s: inner_vy,
        inner_velocity_z_mm_s: inner_vz,
        inner_acceleration_x_m_s2: inner.acceleration_m_s2[0],
        inner_acceleration_y_m_s2: inner.acceleration_m_s2[1],
        inner_acceleration_z_m_s2: inner.acceleration_m_s2[2],
        inner_ball_force_x_n: inner.ball_force_n[0],
        inner_ball_force_y_n: inner.ball_force_n[1],
        inner_ball_force_z_n: inner.ball_force_n[2],
        outer_x_um,
        outer_y_um,
        outer_z_um,
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
        orbital_speed_mean_rpm: mean_orbital * RPM_PER_RAD_S,
        orbital_speed_min_rpm: smallest(|b| b.orbital_speed_rad_s) * RPM_PER_RAD_S,
        orbital_speed_max_rpm: largest(|b| b.orbital_speed_rad_s) * RPM_PER_RAD_S,
        cage_acceleration_rad_s2: cage.acceleration_rad_s2,
        cage_ball_torque_nmm: cage.ball_torque_nm * MILLI_PER_UNIT,
        cage_fluid_torque_nmm: cage.fluid_torque_nm * MILLI_PER_UNIT,
        balls_in_contact: sample.balls.iter().filter(loaded).count() as u32,
        impacts: u32::try_from(impacts).unwrap_or(u32::MAX),
        ..powers(sample)
    }
}

/// The fields of powers, and the largest loads of any ball.
fn powers(sample: &Sample) -> TransientState {
    let power = &sample.power;
    let largest = |get: fn(&BallSample) -> f64| sample.balls.iter().map(get).fold(f64::MIN, f64::max);
    TransientState {
        shaft_power_w: power.shaft_w,
        load_power_w: power.load_w,
        friction_inner_w: power.friction_inner_w,
        friction_outer_w: power.friction_outer_w,
        drag_w: power.drag_w,
        churning_w: power.churning_w,
        contact_damping_w: power.contact_damping_w,
        pocket_friction_w: power.pocket_friction_w,
        pocket_damping_w: power.pocket_damping_w,
        cage_w: power.cage_w,
        support_w: power.support_w,
        energy_j: power.energy_j,
        imbalance_ppb: imbalance_ppb(power.imbalance_j, power.throughput_j),
        load_inner_max_n: largest(|b| b.inner.load_n),
        load_outer_max_n: largest(|b| b.outer.load_n),
        pressure_inner_max_gpa: largest(|b| b.inner.peak_pressure_pa) * GIGA,
        pressure_outer_max_gpa: largest(|b| b.outer.peak_pressure_pa) * GIGA,
        pocket_force_max_n: largest(|b| b.pocket_force_n.abs()),
        ..TransientState::default()
    }
}

/// At the start nothing has been put in and nothing can be missing.
fn imbalance_ppb(imbalance: f64, throughput: f64) -> f64 {
    if throughput > 0.0 { imbalance / throughput * BILLION } else { 0.0 }
}

/// What had worn off by a time, s.
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
pub(crate) fn balls(constants: &BallConstants, sample: &Sample, log_time: u64) -> Balls {
    Balls {
        timestamp: Some(timestamp(log_time)),
        time_s: sample.time_s,
        balls: sample
            .balls
            .iter()
            .enumerate()
            .map(|(i, b)| ball::message(i, constants.pitch_radius, b, &constants.derived(b)))
            .collect(),
    }
}
