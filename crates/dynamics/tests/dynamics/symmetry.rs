//! Turned and mirrored problems have turned and mirrored solutions.

use crate::{case, run};
use std::f64::consts::TAU;
use tribodyn_dynamics::Sample;

const SHORT: [(&str, &str); 4] = [
    ("transient.duration", "s(0.001)"),
    ("transient.scheme", "RungeKutta4(step: us(10))"),
    ("recording.state_rate", "kHz(1)"),
    ("recording.ball_rate", "kHz(1)"),
];

fn end(changes: &[(&str, &str)]) -> Sample {
    run(&case(&[&SHORT[..], changes].concat())).1.samples.pop().unwrap()
}

fn near(what: &str, a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{what}: {a:.12e} against {b:.12e}");
}

/// The powers that the fluid takes from the single balls sum to those in the balance of power.
#[test]
fn identity_drag_and_churning_of_the_balls_sum_to_the_powers() {
    for scheme in ["RungeKutta4(step: us(5))", "Fast(step: us(20))"] {
        let last = end(&[("transient.scheme", scheme)]);
        let churning: f64 = last.balls.iter().map(|b| b.fluid.unwrap().churning_w).sum();
        near("churning", churning, last.power.churning_w, 1e-12 * churning);
        let drag: f64 =
            last.balls.iter().map(|b| b.fluid.unwrap().drag_n * b.orbit_radius_m * b.orbital_speed_rad_s).sum();
        near("drag", drag, last.power.drag_w, 1e-12 * drag.abs());
        // The moment is against the rotation: each ball loses power, by each of its axes.
        for ball in &last.balls {
            let [_, radial, _] = ball.fluid.unwrap().churning_nm;
            assert!(ball.fluid.unwrap().churning_w > 0.0 && radial * ball.angular_velocity_rad_s[1] < 0.0, "{ball:?}");
        }
    }
}

#[test]
fn identity_loads_turned_by_one_pitch_permute_the_balls() {
    let turned = TAU / 13.0;
    let (x, y) = (22.98 * turned.cos(), 22.98 * turned.sin());
    let (x, y) = (format!("Force(kN({x}))"), format!("Force(kN({y}))"));
    let (plain, other) = (end(&[]), end(&[("ring.x", &x), ("ring.y", &y)]));
    for ball in 0..13 {
        let (a, b) = (&plain.balls[ball], &other.balls[(ball + 1) % 13]);
        near("orbital speed", a.orbital_speed_rad_s, b.orbital_speed_rad_s, 1e-7);
        near("inner load", a.contacts.inner.load_n, b.contacts.inner.load_n, 1e-5);
        near("angular velocity", a.angular_velocity_rad_s[0], b.angular_velocity_rad_s[0], 1e-6);
        near(
            "traction",
            a.contacts.outer.friction_or_nan().traction_n[0],
            b.contacts.outer.friction_or_nan().traction_n[0],
            1e-4,
        );
    }
    near("cage", plain.cage.speed_rad_s, other.cage.speed_rad_s, 1e-8);
}

#[test]
fn identity_mirrored_rotation_mirrors_the_run() {
    let (plain, mirrored) = (end(&[]), end(&[("speed.inner", "Constant(rpm(-14000))")]));
    for ball in 0..13 {
        let (a, b) = (&plain.balls[ball], &mirrored.balls[(13 - ball) % 13]);
        near("orbital speed", a.orbital_speed_rad_s, -b.orbital_speed_rad_s, 1e-7);
        near("angular velocity", a.angular_velocity_rad_s[0], -b.angular_velocity_rad_s[0], 1e-6);
        near("inner load", a.contacts.inner.load_n, b.contacts.inner.load_n, 1e-5);
        near(
            "traction",
            a.contacts.inner.friction_or_nan().traction_n[0],
            -b.contacts.inner.friction_or_nan().traction_n[0],
            1e-4,
        );
    }
    near("cage", plain.cage.speed_rad_s, -mirrored.cage.speed_rad_s, 1e-8);
    near("ring across the load", plain.inner.displacement_m[1], -mirrored.inner.displacement_m[1], 1e-15);
}
