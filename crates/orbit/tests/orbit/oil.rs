//! Orbits in oil, where balls without load lag behind and brake the cage.

use crate::support::fixture_with;
use tribodyn_bearing::{CageBody, Pocket};
use tribodyn_orbit::{OrbitSettings, steady_orbit};

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

/// A 6206 like that of `tribodyn new 6206`, in an Eyring fluid, its pockets dry and its steel without losses. A run of
/// 0.4 s from the equilibrium needs 13.4 W on average over its last quarter, 0.0320 N m, its balls bouncing in their
/// pockets at 1590.5 r/min of the cage.
#[test]
fn identity_a_6206_in_oil_has_an_orbit_with_the_torque_of_its_runs() {
    let lossless = [&AS_NEW[..], &[("lubricant.hysteresis", "0")]].concat();
    let (bearing, point, cage) = fixture_with("oil-6206", &lossless);
    let cage = CageBody { pocket: Pocket { film: None, ..cage.pocket }, ..cage };
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert!(orbit.ball_mass_factor.is_none() && !orbit.is_eased(), "not of the case: {:?}", orbit.warnings());
    assert!((orbit.shaft_torque_nm - 0.0320).abs() < 0.0005, "{} N m", orbit.shaft_torque_nm);
    assert!((1585.0..1592.0).contains(&orbit.cage_speed_rpm), "{} r/min", orbit.cage_speed_rpm);
}
