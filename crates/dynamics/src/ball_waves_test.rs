//! Waves of balls: power, their frequencies, what even and odd ones do, and whether all schemes have them.

use crate::layout::{OMEGA, ORBIT};
use crate::machine::Machine;
use crate::start::{Started, start};
use crate::stepping_test::{Scheme, imbalance, run, run_watched};
use std::f64::consts::TAU;
use tribodyn_bearing::Side;
use tribodyn_case::{Case, set_value};

/// All balls, each with a form of its own.
const ALL: &str = "(spectrum: (first: 2, last: 12, amplitude: um(1), exponent: 1, seed: 3))";

/// The paper's bearing under thrust with waves of its balls.
fn with(waves: &str) -> (Machine, Vec<f64>) {
    let changes = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 8)"),
        ("deviations.ball_waves", waves),
        ("ring.x", "Force(N(0))"),
    ];
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let Started { machine, state, .. } = start(Case::from_ron(&text).unwrap().run_inputs().unwrap(), None).unwrap();
    (machine, state)
}

/// The same wave on all balls.
fn alike(order: u32) -> String {
    let wave = |ball| format!("(ball: {ball}, order: {order}, amplitude: um(1), phase: deg(0))");
    format!("(waves: [{}])", (0..13).map(wave).collect::<Vec<_>>().join(", "))
}

#[test]
fn identity_power_balances_over_waves_of_balls() {
    for scheme in [Scheme::RungeKutta, Scheme::DormandPrince] {
        let (mut machine, mut state) = with(ALL);
        let before = machine.energy(0.0, &state);
        run(scheme, (&mut machine, &mut state), 1e-6, 300);
        let missing = imbalance(&machine, (300e-6, &state), before);
        assert!(missing < 1e-10, "{scheme:?} {missing:e}");
    }
}

/// A wave of order n passes a contact n times in a turn of the ball against the line to the bearing's axis.
#[test]
fn limit_a_wave_passes_a_contact_in_each_turn_as_often_as_its_order() {
    let (mut machine, mut state) = with("(waves: [(ball: 4, order: 6, amplitude: um(0.1), phase: deg(90))])");
    let b = machine.unknowns(4, &state);
    let (rate, h, steps) = ((b[OMEGA] - b[ORBIT]).hypot(b[OMEGA + 1]) / TAU, 2e-6, 1500);
    let (mut last, mut crossings, mut most) = ([0.0f64; 2], [0u32; 2], [0.0f64; 2]);
    run_watched(Scheme::RungeKutta, (&mut machine, &mut state), (h, steps), |machine, t, state| {
        let surfaces = machine.place(4, machine.unknowns(4, state), &machine.frame(t, state)).2;
        for side in Side::BOTH {
            let (k, depth) = (side as usize, surfaces[side].depth);
            crossings[k] += u32::from(depth * last[k] < 0.0);
            (last[k], most[k]) = (depth, most[k].max(depth));
        }
    });
    // Twice in each wave the depth changes its sign.
    let expected = 2.0 * 6.0 * rate * h * f64::from(steps);
    for k in 0..2 {
        assert!((f64::from(crossings[k]) - expected).abs() < 0.06 * expected, "{crossings:?} {expected}");
        assert!((0.9e-7..=1.0001e-7).contains(&most[k]), "{most:?}");
    }
}

/// An even wave makes a ball thick and thin and moves the ring along the axis; one of odd order leaves its diameter as
/// it is, and moves the ball alone.
#[test]
fn symmetry_waves_of_odd_order_keep_the_diameter_of_a_ball() {
    let swing = |order: u32| {
        let (mut machine, mut state) = with(&alike(order));
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        run_watched(Scheme::Fast, (&mut machine, &mut state), (4e-6, 1000), |machine, _, state| {
            let z = state[machine.layout.inner() + 2];
            (least, most) = (least.min(z), most.max(z));
        });
        most - least
    };
    let [even, odd] = [2, 3].map(swing);
    assert!(even > 2e-6 && odd < 0.2 * even, "{even:e} {odd:e} m");
}

/// Orbits, angular velocities and orientations by the fast scheme are those of the Runge–Kutta method, to its second
/// order.
#[test]
fn identity_the_fast_scheme_has_the_same_waves_of_balls() {
    let end = |scheme, h: f64, steps: u32| {
        let (mut machine, mut state) = with(ALL);
        run(scheme, (&mut machine, &mut state), h, steps);
        let (i, turned) = (machine.layout.inner(), machine.layout.orientations());
        let speeds = (0..13).flat_map(|ball| machine.unknowns(ball, &state)[OMEGA..].to_vec()).collect::<Vec<_>>();
        (state[i..i + 3].to_vec(), speeds, state[turned].to_vec())
    };
    let exact = end(Scheme::RungeKutta, 0.5e-6, 800);
    let errors = [4e-6, 2e-6].map(|h: f64| {
        let fast = end(Scheme::Fast, h, (4e-4 / h).round() as u32);
        let most = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
        [most(&exact.0, &fast.0), most(&exact.1, &fast.1), most(&exact.2, &fast.2)]
    });
    let [coarse, fine] = errors;
    assert!(coarse[0] < 2e-9 && coarse[1] < 0.2 && coarse[2] < 1e-4, "{errors:?}");
    assert!((0..3).all(|k| fine[k] < 0.5 * coarse[k]), "{errors:?}");
}

/// Waves without amplitude leave the run what it is to the last bit, and add no unknowns.
#[test]
fn limit_waves_without_amplitude_do_nothing() {
    let end = |waves: &str| {
        let (mut machine, mut state) = with(waves);
        run(Scheme::Fast, (&mut machine, &mut state), 2e-6, 50);
        state
    };
    let flat = end("(waves: [(ball: 1, order: 2, amplitude: um(0), phase: deg(0))])");
    assert!(flat.iter().zip(&end("()")).all(|(a, b)| a.to_bits() == b.to_bits()));
}
