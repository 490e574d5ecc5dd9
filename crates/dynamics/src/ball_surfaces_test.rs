//! Spalls of balls: power, momentum, the way of the spall, and whether all schemes have it.

use crate::layout::{AZIMUTH, OMEGA, ORBIT};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{Scheme, imbalance, run_watched};
use tribodyn_bearing::Side;
use tribodyn_case::{Case, set_value};

/// The paper's bearing with spalls of its balls.
fn with(spalls: &str) -> (Machine, Vec<f64>) {
    let changes =
        [("traction.patch", "GaussJacobi(radial: 3, angles: 8)"), ("ball_spalls", spalls), ("ring.x", "Force(N(0))")];
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let Started { machine, state, .. } = start(Case::from_ron(&text).unwrap().run_inputs().unwrap(), None).unwrap();
    (machine, state)
}

/// Both races meet spalls of ball 3 and 5 within the first tenth of a millisecond.
fn machine(depth: &str) -> (Machine, Vec<f64>) {
    with(&format!(
        "[(ball: 3, angle: deg(8), length: mm(1.5), width: mm(4), depth: {depth}, edge_radius: um(20)),
          (ball: 5, angle: deg(188), latitude: deg(3), length: mm(1.5), width: mm(4), depth: {depth})]"
    ))
}

/// Runs on and returns the largest depths under the balls at inner and outer race.
fn run(scheme: Scheme, (machine, state): (&mut Machine, &mut Vec<f64>), h: f64, steps: u32) -> [f64; 2] {
    let mut deepest = [0.0f64; 2];
    run_watched(scheme, (machine, state), (h, steps), |machine, t, state| {
        let frame = machine.frame(t, state);
        for ball in 0..machine.layout.balls {
            let surfaces = machine.place(ball, machine.unknowns(ball, state), &frame).2;
            for side in Side::BOTH {
                let depth = &mut deepest[side as usize];
                *depth = depth.max(surfaces[side].depth);
            }
        }
    });
    deepest
}

/// A ball crosses the places of a depth's table in 0.4 µs each: what is missing falls with the step.
#[test]
fn identity_power_balances_over_spalls_of_balls() {
    let missing = |scheme, angle: u32, (h, steps): (f64, u32)| {
        let (mut machine, mut state) = with(&format!(
            "[(ball: 5, angle: deg({angle}), length: mm(1.5), width: mm(4), depth: um(200), edge_radius: um(20))]"
        ));
        let before = machine.energy(0.0, &state);
        let [inner, outer] = run(scheme, (&mut machine, &mut state), h, steps);
        assert!(inner.max(outer) > 5e-6, "{inner:e} {outer:e}");
        imbalance(&machine, (h * f64::from(steps), &state), before)
    };
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        for angle in [8, 188] {
            let [coarse, fine] = [1, 16].map(|part| missing(scheme, angle, (0.2e-6 / f64::from(part), 600 * part)));
            assert!(fine < 0.1 * coarse && fine < 2e-9, "{scheme:?} {angle}: {coarse:e} {fine:e}");
        }
    }
}

/// The fast scheme goes where the Runge–Kutta method goes: orbital speeds and angular velocities of the struck balls,
/// and where their spalls stand.
#[test]
fn identity_the_fast_scheme_has_the_same_spalls_of_balls() {
    let end = |scheme, h: f64, steps: u32| {
        let (mut machine, mut state) = machine("um(200)");
        run(scheme, (&mut machine, &mut state), h, steps);
        let b = machine.unknowns(3, &state);
        let speeds = [b[ORBIT], b[OMEGA], b[OMEGA + 1], b[OMEGA + 2]];
        let turned: Vec<f64> = state[machine.layout.orientations()].to_vec();
        assert!((turned[0..4].iter().map(|q| q * q).sum::<f64>() - 1.0).abs() < 1e-9 && b[AZIMUTH] > 0.0);
        (speeds, turned)
    };
    let (start, _) = end(Scheme::RungeKutta, 1e-6, 0);
    let (exact, turned) = end(Scheme::RungeKutta, 0.5e-6, 320);
    let (fast, turned_of_fast) = end(Scheme::Fast, 2e-6, 80);
    for k in 0..4 {
        let way = (exact[k] - start[k]).abs().max(1.0);
        assert!((fast[k] - exact[k]).abs() < 0.05 * way, "{k}: {} {} of {way}", fast[k], exact[k]);
    }
    let off = turned.iter().zip(&turned_of_fast).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(off < 1e-4, "{off:e}");
}

/// A spall without depth leaves the run what it is to the last bit.
#[test]
fn limit_a_spall_without_depth_does_nothing() {
    let (mut flat, mut state) = machine("um(0)");
    let (mut whole, mut plain) = (flat.clone(), state.clone());
    whole.ball_surfaces = crate::ball_surfaces::BallSurfaces::default();
    whole.layout.marked = 0;
    plain.truncate(whole.layout.len());
    run(Scheme::RungeKutta, (&mut flat, &mut state), 2e-6, 50);
    run(Scheme::RungeKutta, (&mut whole, &mut plain), 2e-6, 50);
    let same = state[..plain.len()].iter().zip(&plain).all(|(a, b)| a.to_bits() == b.to_bits());
    assert!(same && state.len() == plain.len() + 8);
}
