//! Symmetry and conservation.

use crate::{BEARING_218, PAPER_AG, STRIPS, assert_near, assert_same_ball, solution, variant};
use std::f64::consts::TAU;
use tribodyn_quasistatic::Model::{self, JonesHarris, Traction};
use tribodyn_quasistatic::{BallResult, OperatingPoint, RingFreedom, Solution, solve};

const MODELS: [Model; 2] = [JonesHarris, Traction];

/// The paper's bearing with changed ring freedoms.
fn with_ring(changes: &[(&str, &str)], ring: [RingFreedom; 5], model: Model) -> Solution {
    let case = variant(PAPER_AG, &[&[STRIPS], changes].concat());
    let point = OperatingPoint { ring, ..case.operating_point() };
    solve(&case.bearing().unwrap(), &point, model).unwrap_or_else(|e| panic!("{e}")).solution
}

fn paper_ring(x: f64, y: f64, z: f64) -> [RingFreedom; 5] {
    use RingFreedom::{Held, Loaded};
    [Loaded(x), Loaded(y), Loaded(z), Held(0.0), Held(0.0)]
}

/// Torque of the shaft, 0 where the model has none.
fn torque(s: &Solution) -> f64 {
    s.shaft_torque_nm.unwrap_or_default()
}

#[test]
fn identity_jones_harris_is_symmetric_about_the_load() {
    let s = solution(PAPER_AG, &[], JonesHarris);
    for k in 1..13 {
        assert_same_ball("mirror images", &s.balls[k], &s.balls[13 - k], 1e-8);
    }
    assert!(s.ring_displacement_m[1].abs() < 1e-12);
}

#[test]
fn identity_load_turned_by_a_pitch_permutes_the_balls() {
    for model in MODELS {
        let (sin, cos) = (TAU / 13.0).sin_cos();
        let along = with_ring(&[], paper_ring(20e3, 0.0, 44e3), model);
        let turned = with_ring(&[], paper_ring(20e3 * cos, 20e3 * sin, 44e3), model);
        for k in 0..13 {
            assert_same_ball("turned load", &along.balls[k], &turned.balls[(k + 1) % 13], 1e-8);
        }
        let [x, y, _] = along.ring_displacement_m;
        assert_near("x", turned.ring_displacement_m[0], x * cos - y * sin, 1e-8);
        assert_near("shaft torque", torque(&turned), torque(&along), 1e-8);
    }
}

/// In the mirror y → −y the shaft turns the other way, ball k becomes ball N − k, and so does everything tangential.
#[test]
fn identity_mirrored_rotation_mirrors_the_solution() {
    for model in MODELS {
        let forward = with_ring(&[], paper_ring(20e3, 3e3, 44e3), model);
        let back = with_ring(&[("speed.inner", "Constant(rpm(-14000))")], paper_ring(20e3, -3e3, 44e3), model);
        for k in 0..13 {
            let ball = &forward.balls[k];
            let [axial, radial, tangential] = ball.angular_velocity_rad_s;
            let mut expected = BallResult {
                orbital_speed_rad_s: -ball.orbital_speed_rad_s,
                // An axial vector keeps its component across the mirror and turns the others round.
                angular_velocity_rad_s: [-axial, -radial, tangential],
                ..*ball
            };
            if let Some(friction) = &mut expected.contacts.inner.friction {
                friction.traction_n[0] *= -1.0;
            }
            let image = &back.balls[(13 - k) % 13];
            assert_same_ball("mirrored", &expected, image, 1e-8);
            let slide = |b: &BallResult| b.contacts.inner.friction.map_or(0.0, |f| f.slide_to_roll[0]);
            let difference = (slide(ball) - slide(image)).abs();
            assert!(difference < 1e-8, "slide-to-roll ratios have no handedness");
        }
        assert_near("shaft torque", torque(&back), -torque(&forward), 1e-8);
        assert_near("y", back.ring_displacement_m[1], -forward.ring_displacement_m[1], 1e-7);
    }
}

#[test]
fn identity_thrust_alone_makes_all_balls_alike() {
    for model in MODELS {
        let s = with_ring(&[], paper_ring(0.0, 0.0, 44e3), model);
        for ball in &s.balls {
            assert_same_ball("alike", ball, &s.balls[0], 1e-8);
        }
        assert!(s.balls[0].contacts.inner.load_n > 1e3);
    }
}

/// The force of the ring on the balls is the load; summed over the balls, where traction takes no part, it is too.
#[test]
fn identity_balls_carry_the_load_of_the_ring() {
    for model in MODELS {
        let s = with_ring(&[], paper_ring(20e3, 5e3, 44e3), model);
        for (carried, load) in s.ring_load_n.iter().zip([20e3, 5e3, 44e3]) {
            assert_near("ring load", *carried, load, 1e-8);
        }
    }
    let dry = [("modelling.race_control", "Inner"), ("materials.ball.density", "kg_per_m3(1e-6)")];
    let s = with_ring(&dry, paper_ring(20e3, 5e3, 44e3), JonesHarris);
    let sum = |part: fn(&BallResult) -> f64| -> f64 { s.balls.iter().map(part).sum() };
    let radial =
        |ball: &BallResult| ball.contacts.inner.load_n * ball.contacts.inner.angle_rad.to_degrees().to_radians().cos();
    assert_near(
        "z",
        sum(|b| b.contacts.inner.load_n * b.contacts.inner.angle_rad.to_degrees().to_radians().sin()),
        44e3,
        1e-8,
    );
    let x: f64 = s.balls.iter().map(|b| radial(b) * b.azimuth_rad.cos()).sum();
    let y: f64 = s.balls.iter().map(|b| radial(b) * b.azimuth_rad.sin()).sum();
    assert_near("x", x, 20e3, 1e-8);
    assert_near("y", y, 5e3, 1e-8);
}

/// Power in at the shaft is lost in friction and fluid. Only under thrust alone is each ball in a steady state along
/// its whole orbit, so that nothing is stored.
#[test]
fn identity_shaft_power_is_lost_in_friction_and_fluid() {
    for (path, value) in [
        STRIPS,
        ("fluid.drag_coefficient", "0.01"),
        ("fluid.swirl", "0.4"),
        ("traction.differential_slip", "false"),
        ("traction.pressure", "Local"),
        ("traction.slip_unit", "PercentOfRolling"),
    ] {
        let s = with_ring(&[(path, value)], paper_ring(0.0, 0.0, 44e3), Traction);
        let loss = |b: &BallResult| {
            b.contacts.inner.friction_or_nan().power_loss_w
                + b.contacts.outer.friction_or_nan().power_loss_w
                + b.fluid.unwrap().power_loss_w
        };
        let friction: f64 = s
            .balls
            .iter()
            .map(|b| b.contacts.inner.friction_or_nan().power_loss_w + b.contacts.outer.friction_or_nan().power_loss_w)
            .sum();
        let lost: f64 = s.balls.iter().map(loss).sum();
        // Drag also works on the stream that swirls along: force times the fluid's speed, not lost at the ball.
        let swirl = if path == "fluid.swirl" { 0.4 * s.inner_speed_rad_s } else { 0.0 };
        let on_stream: f64 = s.balls.iter().map(|b| b.fluid.unwrap().drag_n * swirl * b.orbit_radius_m).sum();
        assert!(friction > 100.0, "{path}: {friction} W of friction");
        assert_near(path, s.shaft_torque_nm.unwrap() * s.inner_speed_rad_s, lost + on_stream, 1e-9);
    }
}

/// The same speed added to both rings, dry, changes nothing but the orbit where balls have no inertia; with inertia
/// the centrifugal force follows the orbit.
#[test]
fn identity_common_rotation_matters_by_inertia_alone() {
    let dry = |changes: &[(&str, &str)]| {
        let case = variant(PAPER_AG, &[&[STRIPS], changes].concat());
        let mut bearing = case.bearing().unwrap();
        bearing.fluid = None;
        let point = OperatingPoint { ring: paper_ring(0.0, 0.0, 44e3), ..case.operating_point() };
        solve(&bearing, &point, Traction).unwrap_or_else(|e| panic!("{e}")).solution.balls[0]
    };
    let light = ("materials.ball.density", "kg_per_m3(1e-6)");
    let both = [("speed.inner", "Constant(rpm(17000))"), ("speed.outer", "Constant(rpm(3000))")];
    let (fixed, turning) = (dry(&[light]), dry(&[&[light], &both[..]].concat()));
    let common = 3000.0 * TAU / 60.0;
    let shifted = BallResult { orbital_speed_rad_s: fixed.orbital_speed_rad_s + common, ..fixed };
    assert_same_ball("no inertia", &shifted, &turning, 1e-8);
    let (fixed, turning) = (dry(&[]), dry(&both));
    assert!(
        turning.contacts.outer.load_n - turning.contacts.inner.load_n
            > 1.5 * (fixed.contacts.outer.load_n - fixed.contacts.inner.load_n)
    );
}

#[test]
fn identity_held_displacement_brings_the_load_back() {
    for model in MODELS {
        let loaded = with_ring(&[], paper_ring(20e3, 3e3, 44e3), model);
        let [x, y, z] = loaded.ring_displacement_m.map(RingFreedom::Held);
        let held = with_ring(&[], [x, y, z, RingFreedom::Held(0.0), RingFreedom::Held(0.0)], model);
        for (back, load) in held.ring_load_n.iter().zip([20e3, 3e3, 44e3]) {
            assert_near("load", *back, load, 1e-7);
        }
        for (a, b) in loaded.balls.iter().zip(&held.balls) {
            assert_same_ball("held", a, b, 1e-7);
        }
    }
}

#[test]
fn identity_moment_of_a_held_tilt_brings_the_tilt_back() {
    use RingFreedom::{Held, Loaded};
    for model in MODELS {
        let tilts = [4e-4, -7e-4];
        let force = [Loaded(20e3), Loaded(0.0), Loaded(44e3)];
        let held = with_ring(&[], [force[0], force[1], force[2], Held(tilts[0]), Held(tilts[1])], model);
        let [mx, my] = held.ring_moment_nm;
        let loaded = with_ring(&[], [force[0], force[1], force[2], Loaded(mx), Loaded(my)], model);
        for (back, tilt) in loaded.ring_tilt_rad.iter().zip(tilts) {
            assert_near("tilt", *back, tilt, 1e-6);
        }
        for (a, b) in loaded.balls.iter().zip(&held.balls) {
            assert_same_ball("tilted", a, b, 1e-6);
        }
    }
}

/// A tilt of the ring loads one side of the 218 bearing: the moment it takes has the sign of the tilt.
#[test]
fn identity_tilt_is_resisted() {
    for (path, component) in [("ring.tilt_x", 0), ("ring.tilt_y", 1)] {
        let s = solution(BEARING_218, &[(path, "Held(deg(0.05))")], JonesHarris);
        assert!(s.ring_moment_nm[component] > 1.0, "{path}: {:?} N m", s.ring_moment_nm);
        assert!(s.ring_moment_nm[1 - component].abs() < 1e-6 * s.ring_moment_nm[component]);
    }
}
