//! Jones–Harris against another program's output and against the published formulas.

use crate::{BEARING_218, PAPER_AG, assert_near, solution};
use std::f64::consts::PI;
use tribodyn_quasistatic::Model::JonesHarris;

/// An independent double-precision program for the equations of Jones and Harris, outer raceway control, contact
/// constants at the actual angle, centrifugal force at d_m/2: 22250 N of thrust, 10000 r/min.
#[test]
fn code_jones_harris_218_bearing_under_thrust() {
    let s = solution(BEARING_218, &[], JonesHarris);
    for ball in &s.balls {
        assert_near("α_i", ball.contacts.inner.angle_rad.to_degrees(), 48.702286, 1e-5);
        assert_near("α_o", ball.contacts.outer.angle_rad.to_degrees(), 33.613374, 1e-5);
        assert_near("Q_i", ball.contacts.inner.load_n, 1850.98183, 1e-5);
        assert_near("Q_o", ball.contacts.outer.load_n, 2304.92649, 1e-5);
        assert_near("ω_m", ball.orbital_speed_rad_s, 470.38053, 1e-5);
        let [axial, radial, _] = ball.angular_velocity_rad_s;
        assert_near("ω_R", axial.hypot(radial), 3053.31935, 1e-5);
        assert_near("β", radial.atan2(-axial).to_degrees(), 28.72108, 1e-5);
        assert_near("p_i", ball.contacts.inner.peak_pressure_pa, 1.560601e9, 1e-5);
        assert_near("p_o", ball.contacts.outer.peak_pressure_pa, 1.491434e9, 1e-5);
        assert_near("F_c", ball.centrifugal_force_n, 621.71693, 1e-5);
        assert_near("M_g", ball.gyroscopic_moment_nm, 1.53019654, 1e-5);
    }
}

/// ω_m = [ω_i (1 − γ' cos α_i) + ω_o (cos(α_i − α_o) + γ' cos α_i)]/(1 + cos(α_i − α_o)) and
/// tan β = sin α_o/(cos α_o + γ'): outer control, both rings turning.
#[test]
fn paper_orbit_and_pitch_angle_under_outer_control() {
    for (inner, outer) in [("rpm(14000)", "rpm(0)"), ("rpm(14000)", "rpm(-3000)"), ("rpm(2000)", "rpm(9000)")] {
        let changes = [("speed.inner", wrap(inner)), ("speed.outer", wrap(outer))];
        let changes = changes.each_ref().map(|(path, value)| (*path, value.as_str()));
        let s = solution(PAPER_AG, &changes, JonesHarris);
        let ratio = 0.03016 / 0.165;
        for ball in &s.balls {
            let (i, o) = (
                ball.contacts.inner.angle_rad.to_degrees().to_radians(),
                ball.contacts.outer.angle_rad.to_degrees().to_radians(),
            );
            let (turn, near) = ((i - o).cos(), ratio * i.cos());
            let expected = (s.inner_speed_rad_s * (1.0 - near) + s.outer_speed_rad_s * (turn + near)) / (1.0 + turn);
            assert_near("ω_m", ball.orbital_speed_rad_s, expected, 1e-10);
            let [axial, radial, _] = ball.angular_velocity_rad_s;
            assert_near("tan β", radial / -axial, o.sin() / (o.cos() + ratio), 1e-8);
        }
    }
}

/// Under inner control the pitch angle follows the inner contact: tan β = sin α_i/(cos α_i − γ').
#[test]
fn paper_pitch_angle_under_inner_control() {
    let s = solution(PAPER_AG, &[("modelling.race_control", "Inner")], JonesHarris);
    let ratio = 0.03016 / 0.165;
    for ball in &s.balls {
        let i = ball.contacts.inner.angle_rad.to_degrees().to_radians();
        assert_near(
            "tan β",
            ball.angular_velocity_rad_s[1] / -ball.angular_velocity_rad_s[0],
            i.sin() / (i.cos() - ratio),
            1e-8,
        );
    }
}

/// At low speed both contacts carry the same load at the same angle, so Harris's criterion follows the longer ellipse:
/// the closer groove controls. At high speed the outer race carries the centrifugal force too, and controls.
#[test]
fn limit_criterion_follows_the_longer_contact() {
    let ratio = 22.23 / 125.26;
    let controls_inner = |inner_groove: &str, outer_groove: &str, speed: &str| {
        let changes = [
            ("geometry.inner_groove", inner_groove),
            ("geometry.outer_groove", outer_groove),
            ("speed.inner", speed),
            ("modelling.race_control", "Criterion"),
        ];
        let ball = &solution(BEARING_218, &changes, JonesHarris).balls[0];
        let (i, o) = (
            ball.contacts.inner.angle_rad.to_degrees().to_radians(),
            ball.contacts.outer.angle_rad.to_degrees().to_radians(),
        );
        let tangent = ball.angular_velocity_rad_s[1] / -ball.angular_velocity_rad_s[0];
        let (by_inner, by_outer) = (i.sin() / (i.cos() - ratio), o.sin() / (o.cos() + ratio));
        let inner = (tangent - by_inner).abs() < 1e-8;
        assert!(inner != ((tangent - by_outer).abs() < 1e-8), "one race controls: {tangent} {by_inner} {by_outer}");
        inner
    };
    let (slow, fast) = ("Constant(rpm(100))", "Constant(rpm(10000))");
    assert!(controls_inner("Coefficient(0.515)", "Coefficient(0.54)", slow));
    assert!(!controls_inner("Coefficient(0.54)", "Coefficient(0.515)", slow));
    assert!(!controls_inner("Coefficient(0.5232)", "Coefficient(0.5232)", fast));
}

/// The gyroscopic moment J ω_m ω_R sin β from the solution's own speeds, the ball's inertia from its density.
#[test]
fn identity_gyroscopic_moment_and_centrifugal_force_from_speeds() {
    let s = solution(BEARING_218, &[], JonesHarris);
    let mass = 7800.0 * PI / 6.0 * 0.02223f64.powi(3);
    let inertia = 0.1 * mass * 0.02223f64.powi(2);
    for ball in &s.balls {
        let speed = ball.orbital_speed_rad_s;
        assert_near("M_g", ball.gyroscopic_moment_nm, inertia * speed * ball.angular_velocity_rad_s[1], 1e-12);
        assert_near("F_c", ball.centrifugal_force_n, mass * 0.5 * 0.12526 * speed * speed, 1e-12);
    }
}

fn wrap(speed: &str) -> String {
    format!("Constant({speed})")
}

/// The friction that holds the gyroscopic moment, λ M_g/D across the groove, is what a ball's balance lacks of its
/// normal forces: from both races at each reading of λ.
#[test]
fn paper_gyroscopic_friction_by_its_readings() {
    for (reading, inner, outer) in
        [("Controlling", 0.0, 2.0), ("Shared", 1.0, 1.0), ("Absent", 0.0, 0.0), ("ControllingAsPrinted", 0.0, -2.0)]
    {
        let s = solution(PAPER_AG, &[("modelling.gyroscopic_friction", reading)], JonesHarris);
        for ball in &s.balls {
            let (i, o) = (&ball.contacts.inner, &ball.contacts.outer);
            let friction = ball.gyroscopic_moment_nm / 0.03016;
            let axial = i.load_n * i.angle_rad.sin() - o.load_n * o.angle_rad.sin();
            let held = friction * (inner * i.angle_rad.cos() - outer * o.angle_rad.cos());
            assert!((axial + held).abs() < 1e-7 * o.load_n, "{reading}: {axial} {held}");
        }
    }
}
