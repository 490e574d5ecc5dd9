//! The power balance of a run, and what happens to it when a term is left out.

use crate::forces::System;
use crate::layout::SPIN;
use crate::machine::Terms;
use crate::rk4::Rk4;
use crate::start::{Started, start};
use tribodyn_bearing::Bearing;
use tribodyn_bearing::case::{Case, set_value};

/// Short against the contact modes of 14 kHz that the start excites: the error of the scheme must stay below the balance's.
const STEP: f64 = 2e-6;
const STEPS: u32 = 1000;

/// Runs from the quasi-static solution with the terms given: what is missing over what is put in.
fn imbalance(terms: Terms, changes: &[(&str, &str)]) -> f64 {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let patch = [("traction.patch", "SplitStrip(across: 5, along: 3)")];
    let text = patch.iter().chain(changes).fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let Started { mut machine, mut state, .. } = start(&case, Bearing::new(&case).unwrap()).unwrap();
    machine.terms = terms;
    let (h, n) = (STEP, machine.layout.len());
    let before = machine.energy(0.0, &state);
    let (mut derivative, mut next, mut method) = (vec![0.0; n], vec![0.0; n], Rk4::default());
    for step in 0..STEPS {
        let t = h * f64::from(step);
        machine.derivative(t, &state, &mut derivative);
        method.step(&mut machine, t, (&state, &derivative), h, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    let after = machine.energy(f64::from(STEPS) * h, &state);
    let w = machine.layout.work();
    ((state[w] - state[w + 1] - (after - before)) / state[w + 2]).abs()
}

/// Tight pockets, so that the balls push their cage from the start.
const PUSHING: [(&str, &str); 1] = [("cage.pocket_gap", "mm(0.01)")];

#[test]
fn identity_power_balances_and_every_term_is_needed() {
    let whole = imbalance(Terms::ALL, &PUSHING);
    assert!(whole < 1e-8, "{whole:e}");
    let without = [
        ("absolute spin", Terms { absolute_spin: false, ..Terms::ALL }),
        ("eccentricity", Terms { eccentricity: false, ..Terms::ALL }),
        ("translation of the balls", Terms { ball_translation: false, ..Terms::ALL }),
        ("translation of the rings", Terms { ring_translation: false, ..Terms::ALL }),
        ("equal pocket arms", Terms { equal_pocket_arms: false, ..Terms::ALL }),
    ];
    for (name, terms) in without {
        let off = imbalance(terms, &PUSHING);
        assert!(off > 30.0 * whole, "without {name}: {off:e}, whole {whole:e}");
    }
}

/// ω_m e_a × Ω is at right angles to Ω and leaves the power alone: the quasi-static state, which has it, tells whether it
/// is there.
#[test]
fn identity_without_spin_transport_the_quasistatic_state_does_not_stay() {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron");
    let text = set_value(text, "ring.x", "Force(N(0))").unwrap();
    let text = set_value(&text, "traction.patch", "SplitStrip(across: 5, along: 3)").unwrap();
    let case = Case::from_ron(&text).unwrap();
    let Started { mut machine, state, .. } = start(&case, Bearing::new(&case).unwrap()).unwrap();
    let mut spin_up = |terms: Terms| {
        machine.terms = terms;
        let mut derivative = vec![0.0; state.len()];
        machine.derivative(0.0, &state, &mut derivative);
        derivative[SPIN + 1].hypot(derivative[SPIN + 2])
    };
    let (with, without) = (spin_up(Terms::ALL), spin_up(Terms { spin_transport: false, ..Terms::ALL }));
    // ω_m Ω_r is some 600 × 800 rad/s².
    assert!(with < 1.0 && without > 1e5, "{with:e} {without:e}");
}
