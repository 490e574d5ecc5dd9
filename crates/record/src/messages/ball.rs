//! A ball as it is recorded: one mapping for balls of runs and balls of solutions.

use crate::units::{CUBIC_MICROMETRE, GIGA, MICRO_PER_UNIT, MILLI_PER_UNIT, PERCENT, RPM_PER_RAD_S, degrees};
use crate::wire::tribodyn::ball::{Motion, Pocket};
use crate::wire::tribodyn::{AroundBearing, Ball};
use prost_types::Timestamp;
use tribodyn_dynamics::{BallSample, ContactSample};
use tribodyn_quasistatic::BallSolution;

/// What a run leaves to be worked out from a sample, and a solution says itself, by its model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Derived {
    /// Centrifugal force, N.
    pub(crate) centrifugal_n: f64,
    /// Magnitude of the gyroscopic moment, N m.
    pub(crate) gyroscopic_nm: f64,
    /// Power taken by drag and churning, W.
    pub(crate) fluid_w: f64,
}

/// A ball of a solution at an azimuth, rad, as a run would show it. What a solution does not say is 0.
pub(crate) fn of_solution(azimuth: f64, b: &BallSolution) -> (BallSample, Derived) {
    let inner = ContactSample {
        angle_rad: b.contact_angle_inner_deg.to_radians(),
        approach_m: b.approach_inner_m,
        load_n: b.load_inner_n,
        normal_force_n: b.load_inner_n,
        semi_axes_m: b.semi_axes_inner_m,
        peak_pressure_pa: b.peak_pressure_inner_pa,
        traction_n: [b.traction_inner_n, b.lateral_traction_inner_n],
        slide_to_roll: [b.slide_to_roll_inner, b.lateral_slide_to_roll_inner],
        spin_ratio_per_m: b.spin_ratio_inner,
        rolling_speed_m_s: b.rolling_speed_inner_m_s,
        power_loss_w: b.power_loss_inner_w,
        wear_rate_m3_s: b.wear_rate_inner_m3_s,
        ..ContactSample::default()
    };
    let outer = ContactSample {
        angle_rad: b.contact_angle_outer_deg.to_radians(),
        approach_m: b.approach_outer_m,
        load_n: b.load_outer_n,
        normal_force_n: b.load_outer_n,
        semi_axes_m: b.semi_axes_outer_m,
        peak_pressure_pa: b.peak_pressure_outer_pa,
        traction_n: [b.traction_outer_n, b.lateral_traction_outer_n],
        slide_to_roll: [b.slide_to_roll_outer, b.lateral_slide_to_roll_outer],
        spin_ratio_per_m: b.spin_ratio_outer,
        rolling_speed_m_s: b.rolling_speed_outer_m_s,
        power_loss_w: b.power_loss_outer_w,
        wear_rate_m3_s: b.wear_rate_outer_m3_s,
        ..ContactSample::default()
    };
    let sample = BallSample {
        azimuth_rad: azimuth,
        orbital_speed_rad_s: b.orbital_speed_rad_s,
        orbit_radius_m: b.orbit_radius_m,
        axial_displacement_m: b.axial_displacement_m,
        spin_rad_s: b.spin_rad_s,
        inner,
        outer,
        drag_n: b.drag_n,
        pocket_lead_rad: b.pocket_lead_rad,
        pocket_force_n: b.cage_force_n,
        wear_rate_cage_m3_s: b.wear_rate_cage_m3_s,
        ..BallSample::default()
    };
    let derived = Derived {
        centrifugal_n: b.centrifugal_force_n,
        gyroscopic_nm: b.gyroscopic_moment_nm,
        fluid_w: b.power_loss_fluid_w,
    };
    (sample, derived)
}

fn narrow(x: f64) -> f32 {
    x as f32
}

/// Damping on top of the contact load, N.
fn damping(c: &ContactSample) -> f32 {
    narrow(c.normal_force_n - c.load_n)
}

/// One ball; f32 halves the file and keeps seven digits.
pub(crate) fn message(index: usize, pitch_radius: f64, b: &BallSample, derived: &Derived) -> Ball {
    let (i, o) = (&b.inner, &b.outer);
    let [spin_axial_rad_s, spin_radial_rad_s, spin_tangential_rad_s] = b.spin_rad_s.map(narrow);
    let [across_inner, rolling_inner] = i.semi_axes_m.map(|x| narrow(x * MILLI_PER_UNIT));
    let [across_outer, rolling_outer] = o.semi_axes_m.map(|x| narrow(x * MILLI_PER_UNIT));
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
        orbital_speed_rpm: narrow(b.orbital_speed_rad_s * RPM_PER_RAD_S),
        radial_displacement_um: narrow((b.orbit_radius_m - pitch_radius) * MICRO_PER_UNIT),
        axial_displacement_um: narrow(b.axial_displacement_m * MICRO_PER_UNIT),
        spin_axial_rad_s,
        spin_radial_rad_s,
        spin_tangential_rad_s,
        centrifugal_force_n: narrow(derived.centrifugal_n),
        gyroscopic_moment_nmm: narrow(derived.gyroscopic_nm * MILLI_PER_UNIT),
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
        power_loss_fluid_w: narrow(derived.fluid_w),
        wear_rate_inner_um3_s: narrow(i.wear_rate_m3_s * CUBIC_MICROMETRE),
        wear_rate_outer_um3_s: narrow(o.wear_rate_m3_s * CUBIC_MICROMETRE),
        pocket_lead_mrad: narrow(b.pocket_lead_rad * MILLI_PER_UNIT),
        cage_force_n: narrow(b.pocket_force_n),
        wear_rate_cage_um3_s: narrow(b.wear_rate_cage_m3_s * CUBIC_MICROMETRE),
        motion: motion(b).into(),
        pocket: pocket(b).into(),
        ..run_fields(b)
    }
}

/// Slide-to-roll ratio above which a loaded ball skids: micro-slip of a rolling ball stays well below.
const SKIDDING: f64 = 0.05;

fn motion(b: &BallSample) -> Motion {
    let slide = b.inner.slide_to_roll[0].abs().max(b.outer.slide_to_roll[0].abs());
    match (b.inner.load_n > 0.0, b.outer.load_n > 0.0) {
        (true, true) if slide > SKIDDING => Motion::Skidding,
        (true, true) => Motion::Rolling,
        (false, true) => Motion::InnerLost,
        (true, false) => Motion::OuterLost,
        (false, false) => Motion::Free,
    }
}

/// The force of the pocket on the ball drives the ball where it points along the orbit.
fn pocket(b: &BallSample) -> Pocket {
    let along = b.pocket_force_n * b.orbital_speed_rad_s;
    match along {
        _ if along > 0.0 => Pocket::CagePushes,
        _ if along < 0.0 => Pocket::BallPushes,
        _ => Pocket::Clear,
    }
}

/// Balls sorted by azimuth.
pub(crate) fn around(stamp: Timestamp, time_s: f64, balls: &[&BallSample]) -> AroundBearing {
    let mut order: Vec<(f64, usize)> = balls.iter().enumerate().map(|(i, b)| (degrees(b.azimuth_rad), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let of = |get: fn(&BallSample) -> f64| order.iter().map(|&(_, ball)| narrow(get(balls[ball]))).collect();
    AroundBearing {
        timestamp: Some(stamp),
        time_s,
        azimuth_deg: order.iter().map(|&(azimuth, _)| narrow(azimuth)).collect(),
        ball: order.iter().map(|&(_, ball)| ball as u32).collect(),
        load_inner_n: of(|b| b.inner.load_n),
        load_outer_n: of(|b| b.outer.load_n),
        pressure_inner_gpa: of(|b| b.inner.peak_pressure_pa * GIGA),
        pressure_outer_gpa: of(|b| b.outer.peak_pressure_pa * GIGA),
        contact_angle_inner_deg: of(|b| b.inner.angle_rad.to_degrees()),
        contact_angle_outer_deg: of(|b| b.outer.angle_rad.to_degrees()),
        slide_to_roll_inner_percent: of(|b| b.inner.slide_to_roll[0] * PERCENT),
        slide_to_roll_outer_percent: of(|b| b.outer.slide_to_roll[0] * PERCENT),
        orbital_speed_rpm: of(|b| b.orbital_speed_rad_s * RPM_PER_RAD_S),
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
        churning_w: narrow(b.churning_w),
        depth_outer_um: narrow(o.depth_m * MICRO_PER_UNIT),
        ..Ball::default()
    }
}
