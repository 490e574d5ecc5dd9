//! Orbits with the pockets' own damping beside those with what a search gives them.

use crate::support::fixture_with;
use tribodyn_orbit::{OrbitSettings, less_damped_orbit, steady_orbit};

/// A 6312 under 10 kN radial and 2 kN axial load at 3000 r/min. Runs of the case as it is, begun on the orbit with
/// raised damping (1159.9 r/min, 0.535 N m), left it for 1157.3 to 1158.5 r/min and 0.507 to 0.546 N m: the orbit with
/// the damping of the case is there, and a ball does not keep to it.
#[test]
fn identity_the_orbit_with_the_damping_of_the_case_is_where_its_runs_go() {
    let changes = [
        ("geometry.ball_count", "8"),
        ("geometry.ball_diameter", "mm(22.225)"),
        ("geometry.pitch_diameter", "mm(95)"),
        ("geometry.inner_groove", "Coefficient(0.515)"),
        ("geometry.outer_groove", "Coefficient(0.525)"),
        ("geometry.fit", "RadialClearance(um(20))"),
        ("ring.x", "Force(kN(10))"),
        ("ring.z", "Force(kN(2))"),
        ("speed.inner", "Constant(rpm(3000))"),
        ("cage.pocket_gap", "mm(0.3)"),
        ("cage.pocket_stiffness", "N_per_um(4)"),
        ("cage.pocket_damping", "s_per_m(0.3)"),
    ];
    let (bearing, point, cage) = fixture_with("angular-7210", &changes);
    let settings = OrbitSettings::default();
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    let mut orbit = solved.solution;
    let [raised, given] = orbit.raised_pocket_damping_s_per_m.unwrap();
    assert!(raised > 500.0 * given, "{raised} {given}");
    let less = less_damped_orbit(&bearing, &point, &cage, &settings, &solved.start.unwrap()).unwrap().unwrap();
    assert!(less.is_given() && less.multiplier > 1.0, "{less:?}");
    assert!((1157.3..1158.5).contains(&less.cage_speed_rpm), "{less:?}");
    assert!((0.507..0.546).contains(&less.shaft_torque_nm), "{less:?}");
    assert!((40.0..90.0).contains(&less.pocket_force_max_n), "{less:?}");
    orbit.less_damped = Some(less);
    let sentence = orbit.damping_sentence().unwrap();
    for part in ["with the damping of the case the cage turns at 1157.5", "a run swings about it"] {
        assert!(sentence.contains(part), "{sentence}");
    }
}

/// Where no ball touches its pocket its damping has no part.
#[test]
fn limit_damping_of_pockets_that_no_ball_touches_changes_nothing() {
    let (bearing, point, cage) = fixture_with("angular-7210", &[("ring.x", "Force(kN(0))")]);
    let settings = OrbitSettings::default();
    let solved = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    assert_eq!(solved.solution.raised_pocket_damping_s_per_m, None);
    let less = less_damped_orbit(&bearing, &point, &cage, &settings, &solved.start.unwrap()).unwrap();
    assert_eq!(less, None);
}

/// Where no mesh resolves the pocket forces the answer says so, and else not.
#[test]
fn limit_pocket_forces_that_no_mesh_resolves_are_told() {
    let tight = [
        ("ring.x", "Force(kN(3))"),
        ("ring.z", "Force(kN(3.8))"),
        ("speed.inner", "Constant(rpm(300))"),
        ("cage.pocket_gap", "mm(0.02)"),
    ];
    for (changes, unresolved) in [(&tight[..], true), (&tight[..3], false)] {
        let (bearing, point, cage) = fixture_with("angular-7210", changes);
        let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
        let told = orbit.warnings().iter().any(|warning| warning.contains("fine enough for the pocket forces"));
        assert_eq!((orbit.pocket_force_unresolved, told), (unresolved, unresolved), "{:?}", orbit.warnings());
    }
}
