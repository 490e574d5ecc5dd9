//! `/bearing/state` and `/bearing/balls`: the solution's numbers in the units that a plot wants.

use crate::timeline::{Timeline, timestamp};
use crate::wire::tribodyn::{Ball, Balls, BearingState};
use std::f64::consts::TAU;
use tribodyn_quasistatic::{BallSolution, Solution};

const RPM_PER_RAD_S: f64 = 60.0 / TAU;
const MICRO_PER_UNIT: f64 = 1e6;
const MILLI_PER_UNIT: f64 = 1e3;
const GIGA: f64 = 1e-9;
const PERCENT: f64 = 100.0;
const CUBIC_MICROMETRE: f64 = 1e18;

/// Ring, cage and sums over the balls at one sample.
pub(crate) fn state(
    solution: &Solution,
    timeline: &Timeline,
    sample: usize,
    balls: &[(f64, BallSolution)],
) -> BearingState {
    let sum = |get: fn(&BallSolution) -> f64| balls.iter().map(|(_, b)| get(b)).sum::<f64>();
    let largest = |get: fn(&BallSolution) -> f64| balls.iter().map(|(_, b)| get(b)).fold(f64::MIN, f64::max);
    let smallest = |get: fn(&BallSolution) -> f64| balls.iter().map(|(_, b)| get(b)).fold(f64::MAX, f64::min);
    let degrees = |angle: f64| angle.rem_euclid(TAU).to_degrees();
    let time_s = timeline.seconds(sample);
    let [shaft_x_um, shaft_y_um, shaft_z_um] = solution.ring_displacement_m.map(|x| x * MICRO_PER_UNIT);
    let [tilt_x_mrad, tilt_y_mrad] = solution.ring_tilt_rad.map(|x| x * MILLI_PER_UNIT);
    let [load_x_n, load_y_n, load_z_n] = solution.ring_load_n;
    let [moment_x_nm, moment_y_nm] = solution.ring_moment_nm;
    let loaded = |(_, b): &&(f64, BallSolution)| b.load_inner_n > 0.0 && b.load_outer_n > 0.0;
    BearingState {
        timestamp: Some(timestamp(timeline.log_time(sample))),
        time_s,
        cage_angle_deg: degrees(timeline.cage_angle(sample)),
        shaft_angle_deg: degrees(solution.inner_speed_rad_s * time_s),
        shaft_x_um,
        shaft_y_um,
        shaft_z_um,
        tilt_x_mrad,
        tilt_y_mrad,
        cage_speed_rpm: solution.cage_speed_rpm,
        inner_speed_rpm: solution.inner_speed_rad_s * RPM_PER_RAD_S,
        outer_speed_rpm: solution.outer_speed_rad_s * RPM_PER_RAD_S,
        shaft_torque_nm: solution.shaft_torque_nm,
        load_x_n,
        load_y_n,
        load_z_n,
        moment_x_nm,
        moment_y_nm,
        power_loss_inner_w: sum(|b| b.power_loss_inner_w),
        power_loss_outer_w: sum(|b| b.power_loss_outer_w),
        power_loss_fluid_w: sum(|b| b.power_loss_fluid_w),
        load_inner_max_n: largest(|b| b.load_inner_n),
        load_outer_max_n: largest(|b| b.load_outer_n),
        pressure_inner_max_gpa: largest(|b| b.peak_pressure_inner_pa) * GIGA,
        pressure_outer_max_gpa: largest(|b| b.peak_pressure_outer_pa) * GIGA,
        orbital_speed_min_rpm: smallest(|b| b.orbital_speed_rad_s) * RPM_PER_RAD_S,
        orbital_speed_max_rpm: largest(|b| b.orbital_speed_rad_s) * RPM_PER_RAD_S,
        wear_rate_inner_um3_s: sum(|b| b.wear_rate_inner_m3_s) * CUBIC_MICROMETRE,
        wear_rate_outer_um3_s: sum(|b| b.wear_rate_outer_m3_s) * CUBIC_MICROMETRE,
        wear_rate_cage_um3_s: sum(|b| b.wear_rate_cage_m3_s) * CUBIC_MICROMETRE,
        balls_in_contact: balls.iter().filter(loaded).count() as u32,
    }
}

/// All balls at one sample.
pub(crate) fn balls(pitch_diameter: f64, timeline: &Timeline, sample: usize, balls: &[(f64, BallSolution)]) -> Balls {
    Balls {
        timestamp: Some(timestamp(timeline.log_time(sample))),
        time_s: timeline.seconds(sample),
        balls: balls.iter().enumerate().map(|(i, (_, state))| ball(i, pitch_diameter, state)).collect(),
    }
}

/// One ball; f32 halves the file and keeps seven digits.
fn ball(index: usize, pitch_diameter: f64, b: &BallSolution) -> Ball {
    let radial_displacement = b.orbit_radius_m - 0.5 * pitch_diameter;
    let narrow = |x: f64| x as f32;
    let [spin_axial_rad_s, spin_radial_rad_s, spin_tangential_rad_s] = b.spin_rad_s.map(narrow);
    let [across_inner, rolling_inner] = b.semi_axes_inner_m.map(|x| narrow(x * MILLI_PER_UNIT));
    let [across_outer, rolling_outer] = b.semi_axes_outer_m.map(|x| narrow(x * MILLI_PER_UNIT));
    Ball {
        index: index as u32,
        azimuth_deg: narrow(b.azimuth_deg),
        contact_inner: b.load_inner_n > 0.0,
        contact_outer: b.load_outer_n > 0.0,
        contact_angle_inner_deg: narrow(b.contact_angle_inner_deg),
        contact_angle_outer_deg: narrow(b.contact_angle_outer_deg),
        load_inner_n: narrow(b.load_inner_n),
        load_outer_n: narrow(b.load_outer_n),
        approach_inner_um: narrow(b.approach_inner_m * MICRO_PER_UNIT),
        approach_outer_um: narrow(b.approach_outer_m * MICRO_PER_UNIT),
        pressure_inner_gpa: narrow(b.peak_pressure_inner_pa * GIGA),
        pressure_outer_gpa: narrow(b.peak_pressure_outer_pa * GIGA),
        semi_axis_across_inner_mm: across_inner,
        semi_axis_rolling_inner_mm: rolling_inner,
        semi_axis_across_outer_mm: across_outer,
        semi_axis_rolling_outer_mm: rolling_outer,
        orbital_speed_rpm: narrow(b.orbital_speed_rad_s * RPM_PER_RAD_S),
        radial_displacement_um: narrow(radial_displacement * MICRO_PER_UNIT),
        axial_displacement_um: narrow(b.axial_displacement_m * MICRO_PER_UNIT),
        spin_axial_rad_s,
        spin_radial_rad_s,
        spin_tangential_rad_s,
        centrifugal_force_n: narrow(b.centrifugal_force_n),
        gyroscopic_moment_nmm: narrow(b.gyroscopic_moment_nm * MILLI_PER_UNIT),
        drag_n: narrow(b.drag_n),
        traction_inner_n: narrow(b.traction_inner_n),
        traction_outer_n: narrow(b.traction_outer_n),
        lateral_traction_inner_n: narrow(b.lateral_traction_inner_n),
        lateral_traction_outer_n: narrow(b.lateral_traction_outer_n),
        slide_to_roll_inner_percent: narrow(b.slide_to_roll_inner * PERCENT),
        slide_to_roll_outer_percent: narrow(b.slide_to_roll_outer * PERCENT),
        lateral_slide_to_roll_inner_percent: narrow(b.lateral_slide_to_roll_inner * PERCENT),
        lateral_slide_to_roll_outer_percent: narrow(b.lateral_slide_to_roll_outer * PERCENT),
        spin_ratio_inner_per_m: narrow(b.spin_ratio_inner),
        spin_ratio_outer_per_m: narrow(b.spin_ratio_outer),
        rolling_speed_inner_m_s: narrow(b.rolling_speed_inner_m_s),
        rolling_speed_outer_m_s: narrow(b.rolling_speed_outer_m_s),
        power_loss_inner_w: narrow(b.power_loss_inner_w),
        power_loss_outer_w: narrow(b.power_loss_outer_w),
        power_loss_fluid_w: narrow(b.power_loss_fluid_w),
        wear_rate_inner_um3_s: narrow(b.wear_rate_inner_m3_s * CUBIC_MICROMETRE),
        wear_rate_outer_um3_s: narrow(b.wear_rate_outer_m3_s * CUBIC_MICROMETRE),
        pocket_lead_mrad: narrow(b.pocket_lead_rad * MILLI_PER_UNIT),
        cage_force_n: narrow(b.cage_force_n),
        wear_rate_cage_um3_s: narrow(b.wear_rate_cage_m3_s * CUBIC_MICROMETRE),
        // What only a transient run has.
        ..Ball::default()
    }
}
