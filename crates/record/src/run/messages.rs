//! `/bearing/state`, `/bearing/balls` and `/bearing/wear` of a run: a sample in the units that a plot wants.

use crate::timeline::timestamp;
use crate::wire::tribodyn::{Ball, Balls, TransientState, Wear};
use std::f64::consts::{PI, TAU};
use tribodyn_bearing::Geometry;
use tribodyn_dynamics::{BallSample, ContactSample, Sample};

const RPM_PER_RAD_S: f64 = 60.0 / TAU;
const MICRO_PER_UNIT: f64 = 1e6;
const MILLI_PER_UNIT: f64 = 1e3;
const GIGA: f64 = 1e-9;
const PERCENT: f64 = 100.0;
const CUBIC_MICROMETRE: f64 = 1e18;
const BILLION: f64 = 1e9;

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
}

/// An angle from 0 to 360 degrees.
fn degrees(angle: f64) -> f64 {
    angle.rem_euclid(TAU).to_degrees()
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

/// What has worn off.
pub(crate) fn wear(sample: &Sample, log_time: u64) -> Wear {
    let wear = &sample.wear;
    Wear {
        timestamp: Some(timestamp(log_time)),
        time_s: sample.time_s,
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
        balls: sample.balls.iter().enumerate().map(|(i, state)| ball(constants, i, state)).collect(),
    }
}

fn narrow(x: f64) -> f32 {
    x as f32
}

/// Damping on top of the contact load, N.
fn damping(c: &ContactSample) -> f32 {
    narrow(c.normal_force_n - c.load_n)
}

/// One ball; f32 halves the file and keeps seven digits.
fn ball(constants: &BallConstants, index: usize, b: &BallSample) -> Ball {
    let (i, o) = (&b.inner, &b.outer);
    let orbit = b.orbital_speed_rad_s;
    let [spin_axial_rad_s, spin_radial_rad_s, spin_tangential_rad_s] = b.spin_rad_s.map(narrow);
    let [across_inner, rolling_inner] = i.semi_axes_m.map(|x| narrow(x * MILLI_PER_UNIT));
    let [across_outer, rolling_outer] = o.semi_axes_m.map(|x| narrow(x * MILLI_PER_UNIT));
    // J |ω_m e_a × Ω|: the axial part of the spin drops out.
    let gyroscopic = constants.inertia * orbit.abs() * b.spin_rad_s[1].hypot(b.spin_rad_s[2]);
    Ball {
        index: index as u32,
        azimuth_deg: narrow(degrees(b.azimuth_rad)),
        contact_inner: i.load_n > 0.0,
        contact_outer: o.load_n > 0.0,
        contact_angle_inner_deg: narrow(i.angle_rad.to_degrees()),
        contact_angle_outer_deg: narrow(o.angle_rad.to_degrees()),
        load_inner_n: narrow(i.load_n),
        load_outer_n: narrow(o.load_n),
        approach_inner_um: narrow(i.approach_m * MICRO_PER_UNIT),
        approach_outer_um: narrow(o.approach_m * MICRO_PER_UNIT),
        pressure_inner_gpa: narrow(i.peak_pressure_pa * GIGA),
        pressure_outer_gpa: narrow(o.peak_pressure_pa * GIGA),
        semi_axis_across_inner_mm: across_inner,
        semi_axis_rolling_inner_mm: rolling_inner,
        semi_axis_across_outer_mm: across_outer,
        semi_axis_rolling_outer_mm: rolling_outer,
        orbital_speed_rpm: narrow(orbit * RPM_PER_RAD_S),
        radial_displacement_um: narrow((b.orbit_radius_m - constants.pitch_radius) * MICRO_PER_UNIT),
        axial_displacement_um: narrow(b.axial_displacement_m * MICRO_PER_UNIT),
        spin_axial_rad_s,
        spin_radial_rad_s,
        spin_tangential_rad_s,
        centrifugal_force_n: narrow(constants.mass * b.orbit_radius_m * orbit * orbit),
        gyroscopic_moment_nmm: narrow(gyroscopic * MILLI_PER_UNIT),
        drag_n: narrow(b.drag_n),
        traction_inner_n: narrow(i.traction_n[0]),
        traction_outer_n: narrow(o.traction_n[0]),
        lateral_traction_inner_n: narrow(i.traction_n[1]),
        lateral_traction_outer_n: narrow(o.traction_n[1]),
        slide_to_roll_inner_percent: narrow(i.slide_to_roll[0] * PERCENT),
        slide_to_roll_outer_percent: narrow(o.slide_to_roll[0] * PERCENT),
        lateral_slide_to_roll_inner_percent: narrow(i.slide_to_roll[1] * PERCENT),
        lateral_slide_to_roll_outer_percent: narrow(o.slide_to_roll[1] * PERCENT),
        spin_ratio_inner_per_m: narrow(i.spin_ratio_per_m),
        spin_ratio_outer_per_m: narrow(o.spin_ratio_per_m),
        rolling_speed_inner_m_s: narrow(i.rolling_speed_m_s),
        rolling_speed_outer_m_s: narrow(o.rolling_speed_m_s),
        power_loss_inner_w: narrow(i.power_loss_w),
        power_loss_outer_w: narrow(o.power_loss_w),
        // The churning of single balls is not in a sample.
        power_loss_fluid_w: narrow(b.drag_n * b.orbit_radius_m * orbit),
        wear_rate_inner_um3_s: narrow(i.wear_rate_m3_s * CUBIC_MICROMETRE),
        wear_rate_outer_um3_s: narrow(o.wear_rate_m3_s * CUBIC_MICROMETRE),
        pocket_lead_mrad: narrow(b.pocket_lead_rad * MILLI_PER_UNIT),
        cage_force_n: narrow(b.pocket_force_n),
        wear_rate_cage_um3_s: narrow(b.wear_rate_cage_m3_s * CUBIC_MICROMETRE),
        ..run_fields(b)
    }
}

/// The fields that a solution does not have.
fn run_fields(b: &BallSample) -> Ball {
    let (i, o) = (&b.inner, &b.outer);
    Ball {
        orbital_acceleration_rad_s2: narrow(b.orbital_acceleration_rad_s2),
        axial_velocity_mm_s: narrow(b.velocity_m_s[0] * MILLI_PER_UNIT),
        radial_velocity_mm_s: narrow(b.velocity_m_s[1] * MILLI_PER_UNIT),
        damping_inner_n: damping(i),
        damping_outer_n: damping(o),
        pocket_friction_axial_n: narrow(b.pocket_friction_n[0]),
        pocket_friction_radial_n: narrow(b.pocket_friction_n[1]),
        bare_inner_percent: narrow(i.bare * PERCENT),
        bare_outer_percent: narrow(o.bare * PERCENT),
        depth_inner_um: narrow(i.depth_m * MICRO_PER_UNIT),
        depth_outer_um: narrow(o.depth_m * MICRO_PER_UNIT),
        ..Ball::default()
    }
}
