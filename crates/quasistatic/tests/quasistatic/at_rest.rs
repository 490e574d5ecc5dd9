//! Bearings at rest: the limit of slow turning, balls without load, rings pressed on, shoulders.

use crate::{assert_near, solution, variant};
use tribodyn_bearing::{Bearing, Side};
use tribodyn_quasistatic::Model::{self, JonesHarris, Traction};
use tribodyn_quasistatic::{
    OperatingPoint, QuasiStaticError, RingFreedom, Seated, jones_harris_stiffness, shaft_at_rest, solve,
    traction_stiffness,
};

/// The 7210 of 40 degrees under 4 kN radial, 3 kN axial load.
const ANGULAR: &str = include_str!("../../../../fixtures/cases/angular-7210.ron");
const AT_REST: (&str, &str) = ("speed.inner", "Constant(rpm(0))");
/// A 6205: nine balls of 7.94 mm, some of which carry nothing under 500 N of radial load.
const DEEP_GROOVE: [(&str, &str); 7] = [
    ("geometry.ball_count", "9"),
    ("geometry.ball_diameter", "mm(7.94)"),
    ("geometry.pitch_diameter", "mm(38.5)"),
    ("geometry.fit", "RadialClearance(um(12.5))"),
    ("ring.x", "Force(N(500))"),
    ("ring.z", "Force(N(0))"),
    ("cage.pocket_gap", "mm(0.15)"),
];

fn problem(changes: &[(&str, &str)]) -> (Bearing, OperatingPoint) {
    let case = variant(ANGULAR, changes);
    (case.bearing().unwrap(), case.operating_point())
}

fn deep_groove(changes: &[(&str, &str)]) -> (Bearing, OperatingPoint) {
    problem(&[&DEEP_GROOVE[..], changes].concat())
}

/// Stiffness by a model at its solution.
fn stiffness((bearing, point): &(Bearing, OperatingPoint), model: Model) -> [[f64; 5]; 5] {
    match model {
        JonesHarris => jones_harris_stiffness(bearing, point).unwrap(),
        Traction => {
            let at = solve(bearing, point, Traction).unwrap().warm_start.unwrap();
            traction_stiffness(bearing, point, &at).unwrap()
        }
    }
}

/// Balls that carry nothing are at rest what they are in slow turning: nothing.
#[test]
fn limit_a_standstill_is_the_limit_of_slow_turning() {
    let slow = ("speed.inner", "Constant(rpm(0.1))");
    for changes in [&DEEP_GROOVE[..], &[]] {
        let [still, turning] = [AT_REST, slow].map(|speed| problem(&[changes, &[speed]].concat()));
        let [a, b] = [&still, &turning].map(|(bearing, point)| solve(bearing, point, JonesHarris).unwrap().solution);
        assert!(a.balls.iter().any(|ball| ball.contacts.inner.load_n == 0.0));
        let most = a.balls.iter().fold(0.0, |most: f64, ball| most.max(ball.contacts.inner.load_n));
        for (still, turning) in a.balls.iter().zip(&b.balls) {
            for side in Side::BOTH {
                let loads = [still, turning].map(|ball| ball.contacts[side].load_n);
                assert!((loads[0] - loads[1]).abs() < 1e-6 * most, "{loads:?}");
            }
        }
        for k in [0, 2] {
            let moved = [&a, &b].map(|s| s.ring_displacement_m[k]);
            assert!((moved[0] - moved[1]).abs() < 1e-5 * a.ring_displacement_m[0].abs(), "{k} {moved:?}");
        }
        let [k, slow] = [&still, &turning].map(|problem| stiffness(problem, JonesHarris));
        for axis in 0..5 {
            assert_near("stiffness", k[axis][axis], slow[axis][axis], 1e-3);
        }
        let by_traction = stiffness(&still, Traction);
        for axis in 0..5 {
            // Moments about the displaced ring's centre differ from those about the axis by what approaches are of
            // distances, which counts where little resists a tilt.
            let apart = if axis < 3 { 1e-9 } else { 5e-2 };
            assert_near("stiffness by traction", by_traction[axis][axis], k[axis][axis], apart);
        }
    }
}

/// Where half of the balls carry nothing the stiffness is still that of differences.
#[test]
fn identity_stiffness_beside_unloaded_balls_is_that_of_differences() {
    for actual in ["false", "true"] {
        let (bearing, point) = deep_groove(&[AT_REST, ("modelling.contact_at_actual_angle", actual)]);
        let s = solve(&bearing, &point, JonesHarris).unwrap().solution;
        let k = jones_harris_stiffness(&bearing, &point).unwrap();
        let ([x, y, z], tilt) = (s.ring_displacement_m, s.ring_tilt_rad);
        for (axis, step) in [(0, 2e-9), (1, 2e-9), (2, 2e-9), (3, 1e-7), (4, 1e-7)] {
            let moved = |by: f64| {
                let mut ring = [x, y, z, tilt[0], tilt[1]];
                ring[axis] += by;
                let held = OperatingPoint { ring: ring.map(RingFreedom::Held), ..point.clone() };
                let s = solve(&bearing, &held, JonesHarris).unwrap().solution;
                let ([x, y, z], [mx, my]) = (s.ring_load_n, s.ring_moment_nm);
                [x, y, z, mx, my]
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..5 {
                let difference = (up[row] - down[row]) / (2.0 * step);
                let size = (k[row][row] * k[axis][axis]).sqrt();
                assert!(
                    (difference - k[row][axis]).abs() < 1e-4 * size,
                    "{row} {axis}: {difference:e} {:e}",
                    k[row][axis]
                );
            }
        }
    }
}

/// Rings that press on the balls without a load: each approach is half the interference, shared by two springs.
#[test]
fn limit_an_interference_presses_every_ball_alike() {
    let interference = 8e-6;
    let tight = ("geometry.fit", "RadialClearance(um(-8))");
    let (bearing, point) = deep_groove(&[AT_REST, tight, ("ring.x", "Force(N(0))")]);
    let compliance = |side| bearing.races[side].frozen::<f64>().stiffness().powf(-2.0 / 3.0);
    let expected = (0.5 * interference / (compliance(Side::Inner) + compliance(Side::Outer))).powf(1.5);
    for model in [JonesHarris, Traction] {
        for ball in solve(&bearing, &point, model).unwrap().solution.balls {
            assert_near("preload", ball.contacts.inner.load_n, expected, 1e-8);
            assert!(ball.contacts.inner.angle_rad.abs() < 1e-9, "{}", ball.contacts.inner.angle_rad);
        }
    }
}

/// Preloaded by their fit, with and without clearance, bearings turn and carry thrust; the contact angle grows out of
/// the approaches: F = Z Q sin α.
#[test]
fn limit_tight_bearings_turn_and_carry_thrust() {
    for fit in ["RadialClearance(um(-6))", "RadialClearance(um(0))", "ContactAngle(deg(0))"] {
        let changes = [("geometry.fit", fit), ("ring.x", "Force(N(0))"), ("ring.z", "Force(N(800))")];
        for model in [JonesHarris, Traction] {
            let (bearing, point) = deep_groove(&changes);
            let s = solve(&bearing, &point, model).unwrap_or_else(|e| panic!("{fit} {model:?}: {e}")).solution;
            assert_near("thrust", s.ring_load_n[2], 800.0, 1e-8);
            let carried: f64 = s.balls.iter().map(|b| b.contacts.inner.load_n * b.contacts.inner.angle_rad.sin()).sum();
            assert_near("thrust of the balls", carried, 800.0, 0.01);
            assert!(s.balls[0].contacts.inner.angle_rad.to_degrees() > 5.0);
        }
    }
}

/// A shaft in two bearings that are held to be one and the same is that bearing with half the load.
#[test]
fn identity_two_bearings_in_one_place_share_the_load() {
    let (bearing, point) = deep_groove(&[AT_REST, ("ring.z", "Force(N(300))")]);
    let one = solve(&bearing, &point, JonesHarris).unwrap().solution;
    let halved = |freedom| match freedom {
        RingFreedom::Loaded(load) => RingFreedom::Loaded(2.0 * load),
        held @ RingFreedom::Held(_) => held,
    };
    let twice = OperatingPoint { ring: point.ring.map(halved), ..point.clone() };
    let shaft = shaft_at_rest(vec![Seated::alone(&bearing); 2], &twice).unwrap();
    for k in 0..3 {
        assert!((shaft[k] - one.ring_displacement_m[k]).abs() < 1e-12, "{shaft:?} {:?}", one.ring_displacement_m);
    }
}

/// An angular-contact bearing whose outer ring is relieved carries thrust one way, whatever the model.
#[test]
fn limit_thrust_from_the_wrong_side_is_refused() {
    let sides = ("geometry.shoulders", "(inner: Both, outer: One)");
    for model in [JonesHarris, Traction] {
        for (axial, hint) in [("Force(N(-3000))", "turn its sign"), ("Force(N(0))", "give it an axial load")] {
            let (bearing, point) = problem(&[sides, ("ring.z", axial)]);
            let error = solve(&bearing, &point, model).unwrap_err();
            assert!(matches!(error, QuasiStaticError::NoShoulder { .. }), "{error}");
            assert!(error.to_string().contains(hint), "{error}");
        }
    }
    for shoulders in ["(inner: Both, outer: Both)", "(inner: Both, outer: One)"] {
        let s = solution(ANGULAR, &[("geometry.shoulders", shoulders)], JonesHarris);
        assert_near("thrust", s.ring_load_n[2], 3000.0, 1e-8);
    }
    let both = ("geometry.shoulders", "(inner: Both, outer: Both)");
    let s = solution(ANGULAR, &[both, ("ring.z", "Force(N(-3000))")], JonesHarris);
    assert_near("thrust", s.ring_load_n[2], -3000.0, 1e-8);
}
