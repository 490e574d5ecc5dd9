//! Limiting cases and balances of a steady orbit.

use crate::support::{fixture, fixture_with};
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, Races, RingFreedom};
use tribodyn_orbit::{
    OrbitError, OrbitSettings, OrbitStart, SolvedOrbit, orbit_stiffness, steady_orbit, steady_orbit_from,
    steady_orbit_near,
};
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

/// The power of the shaft is lost in contacts, fluid and pockets; the loads are carried.
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

/// A cage in the land of the inner ring is driven by the shaft, which was left out of its torque.
#[test]
fn identity_power_balances_where_a_ring_guides_the_cage() {
    for (land, radius) in [("Inner", 74.0), ("Outer", 90.25)] {
        let guidance = format!("(land: {land}, radius: mm({radius}), width: mm(12), gap: mm(0.25))");
        let (bearing, point, cage) = fixture_with("paper-ag", &[("cage.guidance", &guidance)]);
        let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
        let cage_speed = orbit.cage_speed_rpm * std::f64::consts::TAU / 60.0;
        let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
        let [guided, drag] = cage.fluid_torques(cage_speed, speeds);
        let land_speed = if land == "Inner" { point.inner_speed } else { point.outer_speed };
        let by_cage = guided * (land_speed - cage_speed) - drag * cage_speed;
        let lost = orbit.friction_w[0] + orbit.friction_w[1] + orbit.fluid_w + orbit.pocket_w + by_cage;
        let given = orbit.shaft_torque_nm * point.inner_speed;
        assert!(by_cage > 0.004 * given, "{land}: {by_cage} {given}");
        assert!((given / lost - 1.0).abs() < 2e-3, "{land}: {given} {lost}");
    }
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

/// A neighbour's mesh, rule and Jacobian lead to the same orbit, the nearer the sooner; from afar they lead nowhere.
#[test]
fn limit_only_the_nearest_neighbours_lead_to_an_orbit_next_door() {
    let (_, bearing, point, cage) = fixture("paper-ag");
    let settings = OrbitSettings::default();
    let at = |load: f64| {
        let mut point = point.clone();
        point.ring[0] = RingFreedom::Loaded(load);
        point
    };
    let near = |load: f64, start: &OrbitStart| steady_orbit_near(&bearing, &at(load), &cage, &settings, start).unwrap();
    let [first, second] = [20e3, 20.1e3].map(|load| steady_orbit(&bearing, &at(load), &cage, &settings).unwrap());
    let start = first.start.unwrap();
    assert!(near(40e3, &start).is_none());
    let beside = near(20.1e3, &start).unwrap();
    assert!((beside.solution.cage_speed_rpm / second.solution.cage_speed_rpm - 1.0).abs() < 2e-6);
    let from = beside.start.unwrap();
    let straight = from.moved(&start, &from).unwrap();
    let [plain, moved] = [&from, &straight].map(|start| near(20.2e3, start).unwrap());
    assert!((plain.solution.cage_speed_rpm / moved.solution.cage_speed_rpm - 1.0).abs() < 1e-9);
    assert!(moved.statistics.residuals < plain.statistics.residuals, "{:?}", moved.statistics);
    assert_eq!(moved.statistics.jacobians, 0);
    // An orbit on another mesh is as good to move by, but for what the meshes err by.
    let finer = OrbitSettings { mesh_error: 1e-3, ..settings };
    let other = steady_orbit(&bearing, &at(20e3), &cage, &finer).unwrap().start.unwrap();
    let across = near(20.2e3, &from.moved(&other, &from).unwrap()).unwrap();
    assert!((across.solution.cage_speed_rpm / moved.solution.cage_speed_rpm - 1.0).abs() < 2e-6);
}

/// Where pockets close and open elsewhere than at the neighbour, a ball is sent round from the start of its turn.
#[test]
fn identity_of_orbits_whose_contacts_are_elsewhere_and_of_cold_starts() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    let settings = OrbitSettings::default();
    let first = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    point.inner_speed *= 1.05;
    let cold = steady_orbit(&bearing, &point, &cage, &settings).unwrap();
    let near = steady_orbit_near(&bearing, &point, &cage, &settings, &first.start.unwrap()).unwrap().unwrap();
    let of = |solved: &SolvedOrbit| [solved.solution.cage_speed_rpm, solved.solution.shaft_torque_nm];
    let ([speed, torque], [cold_speed, cold_torque]) = (of(&near), of(&cold));
    assert!((speed / cold_speed - 1.0).abs() < 5e-6 && (torque / cold_torque - 1.0).abs() < 2e-3);
    assert!((1..=3).contains(&near.statistics.turns), "{:?}", near.statistics);
    assert!(2 * near.statistics.intervals < cold.statistics.intervals, "{:?}", cold.statistics);
}

/// Orbits that differ by rounding go on doing so, from neighbour to neighbour, where balls lose contacts too: no mesh
/// hangs on a last digit.
#[test]
fn identity_rounding_does_not_grow_from_neighbour_to_neighbour() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    point.ring[2] = RingFreedom::Loaded(30e3);
    for load in [9e3, 12e3, 15e3, 18e3, 21e3, 24e3] {
        point.ring[0] = RingFreedom::Loaded(load);
        compare_chains(&point, (&bearing, &cage));
    }
}

fn compare_chains(point: &OperatingPoint, (bearing, cage): (&Bearing, &CageBody)) {
    let settings = OrbitSettings::default();
    let chain = |share: f64| {
        let mut start: Option<OrbitStart> = None;
        let speeds = (0..12).map(|k| share * (840.0 + 70.0 * f64::from(k)));
        let solved = speeds.map(|inner_speed| {
            let point = OperatingPoint { inner_speed, ..point.clone() };
            let near =
                start.take().and_then(|near| steady_orbit_near(bearing, &point, cage, &settings, &near).unwrap());
            let solved = near.unwrap_or_else(|| steady_orbit(bearing, &point, cage, &settings).unwrap());
            start = solved.start;
            let s = solved.solution;
            (s.intervals, [s.cage_speed_rpm, s.shaft_torque_nm, s.pocket_force_max_n, s.friction_w[0]])
        });
        solved.collect::<Vec<_>>()
    };
    for ((intervals, values), (others, others_values)) in chain(1.0).into_iter().zip(chain(1.0 + 1e-13)) {
        assert_eq!(intervals, others);
        for (a, b) in values.into_iter().zip(others_values) {
            assert!((a - b).abs() <= 1e-9 * b.abs(), "{a} {b}");
        }
    }
}

#[test]
fn limit_at_rest_nothing_moves_and_the_loads_are_carried() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    (point.inner_speed, point.outer_speed) = (0.0, 0.0);
    let orbit = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap().solution;
    assert_eq!(orbit.cage_speed_rpm, 0.0);
    assert!((orbit.ring_load_n[2] / 54760.0 - 1.0).abs() < 1e-6, "{:?}", orbit.ring_load_n);
}

/// Rings that turn together are refused at once, to rounding; a hair beside it they turn against each other.
#[test]
fn limit_rings_that_turn_together_have_no_orbit() {
    let (_, bearing, mut point, cage) = fixture("paper-ag");
    for share in [1.0, 1.0 + f64::EPSILON, 1.0 - f64::EPSILON] {
        point.outer_speed = share * point.inner_speed;
        let refused = steady_orbit(&bearing, &point, &cage, &OrbitSettings::default()).unwrap_err();
        assert!(matches!(refused, OrbitError::TurnsAsOne { .. }), "{share}: {refused}");
    }
    for outer_speed in [0.0, -point.inner_speed, point.inner_speed * (1.0 + 1e-6)] {
        assert!(!OperatingPoint { outer_speed, ..point.clone() }.turns_as_one(), "{outer_speed}");
    }
}

#[test]
fn limit_an_inner_ring_that_touches_no_ball_turns_alone() {
    let (_, bearing, mut point, mut cage) = fixture("paper-ag");
    point.ring = [0.0, 0.0, -20e-6, 0.0, 0.0].map(RingFreedom::Held);
    cage.guidance = None;
    let settings = OrbitSettings::default();
    let orbit = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    assert!(orbit.undriven);
    assert_eq!((orbit.cage_speed_rpm, orbit.ring_load_n, orbit.shaft_torque_nm), (0.0, [0.0; 3], 0.0));
    assert!(orbit.warnings()[0].contains("turns alone"), "{:?}", orbit.warnings());
    // Pressed by 2 µm, it drives them.
    point.ring[2] = RingFreedom::Held(2e-6);
    let driven = steady_orbit(&bearing, &point, &cage, &settings).unwrap().solution;
    assert!(!driven.undriven && driven.cage_speed_rpm > 0.0);
}

/// Balls that the fluid alone drives: a ring that touches none of them has no place of its own, and no part in their
/// orbit.
#[test]
fn limit_an_inner_ring_that_floats_has_no_part_in_the_orbit() {
    let (_, mut bearing, mut point, mut cage) = fixture("paper-ag");
    bearing.fluid.as_mut().unwrap().swirl = 0.3;
    cage.drag_torque = 1.0;
    let settings = OrbitSettings::default();
    let mut at = |across: RingFreedom| {
        point.ring = [across, across, RingFreedom::Held(-400e-6), RingFreedom::Held(0.0), RingFreedom::Held(0.0)];
        (steady_orbit(&bearing, &point, &cage, &settings).unwrap(), point.clone())
    };
    let (held, _) = at(RingFreedom::Held(0.0));
    let (floating, point) = at(RingFreedom::Loaded(0.0));
    let orbit = floating.solution;
    assert!(!orbit.undriven && orbit.ring_load_n == [0.0; 3]);
    assert!((orbit.cage_speed_rpm / held.solution.cage_speed_rpm - 1.0).abs() < 1e-8);
    assert!(orbit.warnings()[0].contains("no ball touches the inner race"), "{:?}", orbit.warnings());
    // What brakes the cage, the balls make up for in their pockets.
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let given: f64 = cage.fluid_torques(orbit.cage_speed_rpm * std::f64::consts::TAU / 60.0, speeds).iter().sum();
    let force = orbit.points[0].pocket.unwrap().force_n;
    let taken = force * cage.pocket.radius * bearing.geometry.ball_count as f64;
    assert!((given.abs() / taken.abs() - 1.0).abs() < 0.02, "{given} {taken}");
    let stiffness = orbit_stiffness(&bearing, &point, &cage, &settings, &floating.start.unwrap());
    assert_eq!(stiffness.unwrap_err(), OrbitError::Singular);
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
