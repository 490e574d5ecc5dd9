//! `/bearing/state` and `/bearing/balls`: the solution's numbers in the units that a plot wants.

use crate::ball::{self, Derived};
use crate::timeline::{Timeline, timestamp};
use crate::units::{CUBIC_MICROMETRE, GIGA, MICRO_PER_UNIT, MILLI_PER_UNIT, RPM_PER_RAD_S, degrees};
use crate::wire::tribodyn::{Balls, BearingState};
use tribodyn_dynamics::BallSample;
use tribodyn_quasistatic::{BallSolution, Solution};

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
pub(crate) fn balls(pitch_diameter: f64, timeline: &Timeline, sample: usize, balls: &[(BallSample, Derived)]) -> Balls {
    let message =
        |(i, (b, derived)): (usize, &(BallSample, Derived))| ball::message(i, 0.5 * pitch_diameter, b, derived);
    Balls {
        timestamp: Some(timestamp(timeline.log_time(sample))),
        time_s: timeline.seconds(sample),
        balls: balls.iter().enumerate().map(message).collect(),
    }
}
