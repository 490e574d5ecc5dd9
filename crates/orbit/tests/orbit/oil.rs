//! Orbits in oil, where balls without load lag behind and brake the cage.

use crate::support::fixture_with;
use std::f64::consts::PI;
use tribodyn_bearing::{CageBody, OperatingPoint, Pocket};
use tribodyn_orbit::{OrbitSettings, steady_orbit, steady_orbit_from};

/// Oil in the pockets carries balls without load along with the cage. A run of 0.1 s from this orbit has 1588.69 r/min
/// and 14.31 W on average over its last half.
#[test]
fn identity_oil_in_the_pockets_carries_idle_balls_along() {
    let (bearing, point, cage) = fixture_with("oil-6206", &AS_NEW);
    let solved = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap();
    let orbit = &solved.solution;
    assert!(solved.statistics.jacobians < 60 && solved.statistics.turns < 30, "{:?}", solved.statistics);
    assert!((orbit.cage_speed_rpm - 1588.69).abs() < 0.1, "{} r/min", orbit.cage_speed_rpm);
    let power = orbit.shaft_torque_nm * point.inner_speed;
    assert!((power - 14.31).abs() < 0.05, "{power} W");
    // Nothing is pressed into a wall, and what the film takes is next to nothing.
    assert!(orbit.pocket_force_max_n < 0.1 && orbit.pocket_w < 1e-3, "{orbit:?}");
}

const AS_NEW: [(&str, &str); 9] = [
    ("geometry.outer_groove", "Coefficient(0.53)"),
    ("geometry.fit", "RadialClearance(um(12.5))"),
    ("geometry.inner_shoulder", "Height(mm(1.91))"),
    ("geometry.outer_shoulder", "Height(mm(1.91))"),
    ("lubricant.oil", "Library(\"mineral-vg68\")"),
    ("ring.x", "Force(kN(2))"),
    ("ring.z", "Force(N(390))"),
    ("speed.inner", "Constant(rpm(4000))"),
    ("cage.inertia", "kg_m2(2.1e-6)"),
];

/// The losses in oil and contacts of a bearing that `tribodyn new` writes, and their accuracy.
const LOSSES: [(&str, &str); 3] = [
    ("lubricant.shear", "LimitingShear"),
    ("lubricant.patch", "TargetError(relative: 1e-4)"),
    ("transient.contact_damping", "0.25"),
];

/// A 6206 like that of `tribodyn new 6206`, in an Eyring fluid, its pockets dry and its steel without losses. A run of
/// 0.4 s from the equilibrium needs 13.4 W on average over its last quarter, 0.0320 N m, its balls bouncing in their
/// pockets at 1590.5 r/min of the cage.
#[test]
fn identity_a_6206_in_oil_has_an_orbit_with_the_torque_of_its_runs() {
    let lossless = [&AS_NEW[..], &[("lubricant.hysteresis", "0")]].concat();
    let (bearing, point, cage) = fixture_with("oil-6206", &lossless);
    let cage = CageBody { pocket: Pocket { film: None, ..cage.pocket }, ..cage };
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert!(orbit.is_of_the_case(), "not of the case: {:?}", orbit.warnings());
    assert!((orbit.shaft_torque_nm - 0.0320).abs() < 0.0005, "{} N m", orbit.shaft_torque_nm);
    assert!((1585.0..1592.0).contains(&orbit.cage_speed_rpm), "{} r/min", orbit.cage_speed_rpm);
}

/// A 6024 whose idle balls swing faster than its mesh can be made fine: a neighbour's orbit is found on the same mesh,
/// and says that it errs. It was sought on finer ones in vain, for some seconds each.
#[test]
fn regress_a_neighbour_is_served_by_a_mesh_that_could_not_be_made_finer() {
    let changes = [
        ("geometry.ball_count", "14"),
        ("geometry.ball_diameter", "mm(19.05)"),
        ("geometry.pitch_diameter", "mm(150)"),
        ("geometry.inner_shoulder", "Height(mm(3.81))"),
        ("geometry.outer_shoulder", "Height(mm(3.81))"),
        ("geometry.fit", "RadialClearance(um(28))"),
        ("ring.x", "Force(N(8800))"),
        ("ring.z", "Force(N(1800))"),
        ("speed.inner", "Constant(rpm(1000))"),
        ("cage.inertia", "kg_m2(2.6e-4)"),
        ("cage.pocket_gap", "mm(0.2)"),
    ];
    let (bearing, point, cage) = fixture_with("oil-6206", &[&AS_NEW[..], &LOSSES, &changes].concat());
    let settings = OrbitSettings::default();
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    assert!(solved.solution.mesh_error.is_some_and(|error| error > 2.0), "{:?}", solved.solution.mesh_error);
    let rougher = CageBody { pocket: Pocket { friction: 2.0 * cage.pocket.friction, ..cage.pocket }, ..cage };
    let next = steady_orbit_from(&bearing, &point, &rougher, &settings, &solved.start.unwrap()).unwrap();
    assert!(next.statistics.jacobians <= 3, "{:?}", next.statistics);
    assert!(next.solution.mesh_error.is_some_and(|error| error > 2.0), "{:?}", next.solution.mesh_error);
    assert!((next.solution.shaft_torque_nm / solved.solution.shaft_torque_nm - 1.0).abs() < 1e-3);
}

/// A slow 6206, whose idle balls weigh next to nothing: with heavier ones an orbit is found that nothing damps, and
/// neighbours go on with it. It took four times as long, by damped swinging.
#[test]
fn regress_idle_balls_of_a_slow_bearing_are_heavier_and_not_damped() {
    let changes = [&AS_NEW[..], &LOSSES, &[("speed.inner", "Constant(rpm(300))")]].concat();
    let (bearing, point, cage) = fixture_with("oil-6206", &changes);
    let settings = OrbitSettings::default();
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    let orbit = &solved.solution;
    assert!(!orbit.is_regularized(), "{:?}", orbit.warnings());
    let speed = orbit.cage_speed_rpm * PI / 30.0;
    let factor = orbit.ball_mass_factor.unwrap();
    let centrifugal = factor * bearing.ball_mass * 0.5 * bearing.geometry.pitch_diameter * speed * speed;
    let mean = orbit.points.iter().map(|p| p.contacts.inner.load_n).sum::<f64>() / orbit.points.len() as f64;
    assert!((5e-4..2e-3).contains(&(centrifugal / mean)), "{centrifugal} of {mean} N");
    // Balls roll, as the loaded ones would by their contact angle of some 9°.
    let rolling =
        0.5 * (1.0 - bearing.geometry.ball_diameter * 9.1f64.to_radians().cos() / bearing.geometry.pitch_diameter);
    assert!((orbit.cage_speed_rpm / 300.0 / rolling - 1.0).abs() < 1e-3, "{} r/min", orbit.cage_speed_rpm);
    let faster = OperatingPoint { inner_speed: 1.01 * point.inner_speed, ..point.clone() };
    let next = steady_orbit_from(&bearing, &faster, &cage, &settings, &solved.start.unwrap()).unwrap().solution;
    assert_eq!(next.ball_mass_factor, Some(factor));
    assert!((next.cage_speed_rpm / orbit.cage_speed_rpm / 1.01 - 1.0).abs() < 1e-4);
}
