//! Orbits that are found by long ways are those of the bearing, and their stiffness is the slope of their loads.

use crate::support::fixture_with;
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, RingFreedom};
use tribodyn_orbit::{OrbitSettings, SolvedOrbit, orbit_stiffness, steady_orbit, steady_orbit_from};

/// Load that is added and taken away, over the load itself.
const SHARE: f64 = 2e-3;

/// The radial displacement per radial load against a difference of orbits under a little more and less of it.
fn compliance_along_x(bearing: &Bearing, point: &OperatingPoint, cage: &CageBody, solved: &SolvedOrbit) -> [f64; 2] {
    let settings = OrbitSettings::default();
    let start = solved.start.as_ref().unwrap();
    let RingFreedom::Loaded(load) = point.ring[0] else { panic!("the ring is loaded along x") };
    let change = SHARE * load;
    let displacement = |load: f64| {
        let mut point = point.clone();
        point.ring[0] = RingFreedom::Loaded(load);
        steady_orbit_from(bearing, &point, cage, &settings, start).unwrap().solution.ring_displacement_m[0]
    };
    let difference = (displacement(load + change) - displacement(load - change)) / (2.0 * change);
    let k = orbit_stiffness(bearing, point, cage, &settings, start).unwrap();
    assert!(k.error_estimate < 1e-2, "{k:?}");
    // The loads of free freedoms alone are given.
    let free: Vec<usize> = (0..5).filter(|n| matches!(point.ring[*n], RingFreedom::Loaded(_))).collect();
    let own = nalgebra::DMatrix::from_fn(free.len(), free.len(), |i, j| k.stiffness[free[i]][free[j]]);
    [own.try_inverse().unwrap()[(0, 0)], difference]
}

/// A 7210 whose outer ring turns against the inner one: the search ends in pockets that are softened on the way, and
/// had called them the bearing's own. The orbit's cage then ran at 699.4 r/min, untouched by any ball, with 0.178 N m,
/// and F_x/x was 1.37e8 N/m.
#[test]
fn identity_an_orbit_is_that_of_its_bearing_and_its_stiffness_the_slope_of_its_load() {
    let changes = [("speed.outer", "Constant(rpm(-3000))"), ("ring.z", "Force(kN(1))")];
    let (bearing, point, cage) = fixture_with("angular-7210", &changes);
    let solved = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap();
    let orbit = &solved.solution;
    let regularized = [orbit.ball_mass_factor, orbit.pocket_stiffness_share, orbit.raised_contact_damping];
    assert!(regularized.iter().all(Option::is_none), "{:?}", orbit.warnings());
    assert!((orbit.cage_speed_rpm / 693.0 - 1.0).abs() < 1e-3, "{}", orbit.cage_speed_rpm);
    assert!((orbit.shaft_torque_nm / 0.1425 - 1.0).abs() < 5e-3, "{}", orbit.shaft_torque_nm);
    let [slope, difference] = compliance_along_x(&bearing, &point, &cage, &solved);
    assert!((slope / difference - 1.0).abs() < 1e-2, "{slope:e} {difference:e}");
}

/// Rings that turn slowly against each other, balls held by next to nothing: F_x/x had been −5e8 N/m.
#[test]
fn identity_stiffness_of_slow_rings_that_turn_against_each_other_is_that_of_differences() {
    let (bearing, point, cage) = fixture_with("counter-rotating", &[]);
    let solved = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap();
    // What was changed to find it is said, in numbers a reader can say aloud.
    let warnings = solved.solution.warnings();
    let regularized = solved.solution.ball_mass_factor.is_some();
    assert_eq!(regularized, warnings.iter().any(|w| w.contains("times heavier than given") && !w.contains("e2")));
    let [slope, difference] = compliance_along_x(&bearing, &point, &cage, &solved);
    assert!(difference > 0.0 && (slope / difference - 1.0).abs() < 1e-2, "{slope:e} {difference:e}");
}
