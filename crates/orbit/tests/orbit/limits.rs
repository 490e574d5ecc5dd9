//! Limiting cases and balances of a steady orbit.

use crate::support::fixture;
use tribodyn_bearing::RingFreedom;
use tribodyn_orbit::{OrbitSettings, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, PatchRule, solve};

/// Under thrust alone all balls do the same, so that the quasi-static equilibrium is the orbit.
#[test]
fn limit_pure_thrust_is_the_quasi_static_equilibrium() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    point.ring[0] = RingFreedom::Loaded(0.0);
    // One rule for both: each would choose its own at the state it starts from.
    point.patch = Some(PatchRule::SplitStrip { across: 10, along: 5 }.into());
    let equilibrium = solve(&bearing, &point, Model::Traction).unwrap().solution;
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert!((orbit.cage_speed_rpm / equilibrium.cage_speed_rpm - 1.0).abs() < 1e-8);
    assert!((orbit.shaft_torque_nm / equilibrium.shaft_torque_nm.unwrap() - 1.0).abs() < 1e-6);
    let load = equilibrium.balls[0].contacts.inner.load_n;
    assert!(orbit.points.iter().all(|p| (p.contacts.inner.load_n / load - 1.0).abs() < 1e-7));
}

/// What the shaft gives is lost in contacts, fluid and pockets; the loads are carried.
#[test]
fn identity_power_and_loads_balance_over_the_turn() {
    let (_, bearing, point, cage) = fixture("paper-ag");
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    let lost = orbit.friction_w[0] + orbit.friction_w[1] + orbit.fluid_w + orbit.pocket_w;
    let given = orbit.shaft_torque_nm * point.inner_speed;
    assert!((given / lost - 1.0).abs() < 2e-3, "{given} {lost}");
    assert!(orbit.residual <= 1e-10);
    assert!((orbit.ring_load_n[0] - 22980.0).abs() < 1e-3 && (orbit.ring_load_n[2] - 54760.0).abs() < 1e-3);
}

/// A finer mesh and a neighbouring start give the same orbit.
#[test]
fn identity_of_meshes_and_of_warm_and_cold_start() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    let settings = OrbitSettings::default();
    let coarse = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    let fine = OrbitSettings { mesh_error: 1e-3, ..settings };
    let fine = steady_orbit(&bearing, &point, &cage, &fine).unwrap().solution;
    assert!((coarse.solution.cage_speed_rpm / fine.cage_speed_rpm - 1.0).abs() < 2e-6);
    point.inner_speed *= 1.01;
    let cold = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    let warm = steady_orbit_from(&bearing, &point, &cage, &settings, &coarse.start.unwrap()).unwrap().solution;
    assert!((warm.cage_speed_rpm / cold.cage_speed_rpm - 1.0).abs() < 2e-6);
}

#[test]
fn limit_at_rest_nothing_moves_and_the_loads_are_carried() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    (point.inner_speed, point.outer_speed) = (0.0, 0.0);
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert_eq!(orbit.cage_speed_rpm, 0.0);
    assert!((orbit.ring_load_n[2] / 54760.0 - 1.0).abs() < 1e-6, "{:?}", orbit.ring_load_n);
}

/// Turned the other way round, all is mirrored.
#[test]
fn identity_of_either_sense_of_rotation() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    let settings = OrbitSettings::default();
    let forward = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    point.inner_speed = -point.inner_speed;
    let back = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    assert!((forward.cage_speed_rpm / -back.cage_speed_rpm - 1.0).abs() < 1e-6);
    let (a, b) = (forward.points[10].contacts.inner.load_n, back.points[170].contacts.inner.load_n);
    assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
}
