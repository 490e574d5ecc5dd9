//! Limits with a closed form or a one-equation solution of their own.

use crate::{BEARING_218, PAPER_AG, assert_near, solution, variant};
use std::f64::consts::TAU;
use tribodyn_bearing::{Bearing, Side};
use tribodyn_quasistatic::Model::{JonesHarris, Traction};

const AT_REST: (&str, &str) = ("speed.inner", "Constant(rpm(0))");
const FROZEN: (&str, &str) = ("modelling.contact_at_actual_angle", "false");

/// Stiffness of both contacts of a ball in series, N/m^1.5: δ_i + δ_o = (Q/K)^(2/3).
fn series_stiffness(bearing: &Bearing) -> f64 {
    let compliance = |side| bearing.races[side].frozen::<f64>().stiffness().powf(-2.0 / 3.0);
    (compliance(Side::Inner) + compliance(Side::Outer)).powf(-1.5)
}

/// Root of a rising function.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// At rest under thrust all balls share one contact angle: F = N K [A (cos α0/cos α − 1)]^1.5 sin α.
#[test]
fn limit_thrust_at_rest_is_one_equation_for_the_contact_angle() {
    for thrust in [100.0, 22250.0, 80000.0] {
        let load = format!("Force(N({thrust}))");
        let changes = [AT_REST, FROZEN, ("ring.z", load.as_str())];
        let bearing = variant(BEARING_218, &changes).bearing().unwrap();
        let (free, distance) = (bearing.geometry.contact_angle(), bearing.geometry.centre_distance());
        let ball_load =
            |angle: f64| series_stiffness(&bearing) * (distance * (free.cos() / angle.cos() - 1.0)).powf(1.5);
        let angle = bisect(free, 1.4, |angle| 16.0 * ball_load(angle) * angle.sin() - thrust);
        let s = solution(BEARING_218, &changes, JonesHarris);
        for ball in &s.balls {
            assert_near("α_i", ball.contacts.inner.angle_rad.to_degrees(), angle.to_degrees(), 1e-9);
            assert_near("α_o", ball.contacts.outer.angle_rad.to_degrees(), angle.to_degrees(), 1e-9);
            assert_near("Q_i", ball.contacts.inner.load_n, ball_load(angle), 1e-9);
            assert_near("Q_o", ball.contacts.outer.load_n, ball_load(angle), 1e-9);
        }
        let shift = distance * (free.cos() * angle.tan() - free.sin());
        assert_near("axial displacement", s.ring_displacement_m[2], shift, 1e-8);
    }
}

/// At rest with the ring centred axially, a radial load F = Σ K max(0, x cos φ − P_d/2)^1.5 cos φ.
#[test]
fn limit_radial_load_at_rest_is_a_sum_over_balls_in_the_load_zone() {
    let clearance = 20e-6;
    let fit = ("geometry.fit", "RadialClearance(um(20))");
    let bearing = variant(BEARING_218, &[fit]).bearing().unwrap();
    let centred = format!("Held(um({}))", -0.5e6 * bearing.geometry.axial_play());
    let changes = [fit, AT_REST, FROZEN, ("ring.x", "Force(kN(10))"), ("ring.z", centred.as_str())];
    // Contact constants belong to the free contact angle, of which these frozen ones know.
    let stiffness = series_stiffness(&bearing);
    let approach = |x: f64, ball: usize| (x * (TAU * ball as f64 / 16.0).cos() - 0.5 * clearance).max(0.0);
    let carried = |x: f64| -> f64 {
        (0..16).map(|ball| stiffness * approach(x, ball).powf(1.5) * (TAU * ball as f64 / 16.0).cos()).sum()
    };
    let x = bisect(0.0, 1e-3, |x| carried(x) - 10e3);
    let s = solution(BEARING_218, &changes, JonesHarris);
    assert_near("x", s.ring_displacement_m[0], x, 1e-9);
    for (index, ball) in s.balls.iter().enumerate() {
        let expected = stiffness * approach(x, index).powf(1.5);
        assert!(
            (ball.contacts.inner.load_n - expected).abs() < 1e-6 * 10e3,
            "ball {index}: {} {expected}",
            ball.contacts.inner.load_n
        );
    }
    assert!(s.balls.iter().any(|ball| ball.contacts.inner.load_n == 0.0), "half of the balls are out of the load zone");
}

/// At rest nothing tells the inner from the outer contact of a ball.
#[test]
fn limit_at_rest_both_contacts_of_a_ball_carry_the_same() {
    for model in [JonesHarris, Traction] {
        let s = solution(PAPER_AG, &[AT_REST], model);
        for ball in &s.balls {
            assert_near("load", ball.contacts.inner.load_n, ball.contacts.outer.load_n, 1e-8);
            assert_near(
                "angle",
                ball.contacts.inner.angle_rad.to_degrees(),
                ball.contacts.outer.angle_rad.to_degrees(),
                1e-8,
            );
            assert!(ball.centrifugal_force_n < 1e-6, "{} N", ball.centrifugal_force_n);
        }
    }
}

/// Without any load each ball is thrown against the outer race by m (d_m/2) ω_m², at zero contact angle.
#[test]
fn limit_without_load_the_outer_race_carries_the_centrifugal_force() {
    let s = solution(BEARING_218, &[("ring.z", "Force(N(0))"), FROZEN], JonesHarris);
    for ball in &s.balls {
        assert!(
            ball.contacts.inner.load_n < 1e-6 * ball.contacts.outer.load_n,
            "inner load {}",
            ball.contacts.inner.load_n
        );
        assert_near("Q_o", ball.contacts.outer.load_n, ball.centrifugal_force_n, 1e-9);
        assert!(
            ball.contacts.outer.angle_rad.to_degrees().abs() < 1e-4,
            "outer angle {}",
            ball.contacts.outer.angle_rad.to_degrees()
        );
    }
}

/// A cage with drag is pushed round by balls that lead their pockets: the forces on them retard and sum to the drag.
#[test]
fn identity_pocket_forces_carry_the_drag_of_the_cage() {
    for torque in [3.0, -3.0] {
        let drag = format!("Nm({torque})");
        let s = solution(PAPER_AG, &[("cage.drag_torque", drag.as_str())], JonesHarris);
        let on_cage: f64 = s.balls.iter().map(|ball| -ball.pocket.unwrap_or_default().force_n * 0.5 * 0.165).sum();
        assert_near("torque on the cage", on_cage, torque, 1e-6);
        for ball in s.balls.iter().filter(|ball| ball.pocket.unwrap_or_default().force_n != 0.0) {
            assert!(
                ball.pocket.unwrap_or_default().force_n * ball.pocket.unwrap_or_default().lead_rad < 0.0,
                "a leading ball is retarded"
            );
        }
    }
}

/// Where nothing turns balls have neither a speed nor a pocket force, and nothing is said about their sliding.
#[test]
fn limit_a_bearing_at_rest_says_nothing_of_speeds() {
    for equations in [JonesHarris, Traction] {
        let s = solution(PAPER_AG, &[AT_REST], equations);
        assert!(!s.turns() && s.cage_speed_rpm == 0.0, "{}", s.cage_speed_rpm);
        assert!(s.balls.iter().all(|ball| ball.pocket.is_none()));
        assert!(s.warnings.iter().all(|warning| !warning.contains("skids")), "{:?}", s.warnings);
    }
}
