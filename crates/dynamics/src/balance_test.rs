//! The power balance of a run, and what happens to it when a term is left out.

use crate::forces::System;
use crate::machine::Terms;
use crate::rk4::Rk4;
use crate::start::{Started, start};
use tribodyn_bearing::Bearing;
use tribodyn_bearing::case::{Case, set_value};

/// Steps of 5e-6 s from the quasi-static solution with the terms given: what is missing over what is put in.
fn imbalance(terms: Terms, changes: &[(&str, &str)]) -> f64 {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let patch = [("traction.patch", "SplitStrip(across: 5, along: 3)")];
    let text = patch.iter().chain(changes).fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let Started { mut machine, mut state, .. } = start(&case, Bearing::new(&case).unwrap()).unwrap();
    machine.terms = terms;
    let (h, n) = (5e-6, machine.layout.len());
    let before = machine.energy(0.0, &state);
    let (mut derivative, mut next, mut method) = (vec![0.0; n], vec![0.0; n], Rk4::default());
    for step in 0..600 {
        let t = h * f64::from(step);
        machine.derivative(t, &state, &mut derivative);
        method.step(&mut machine, t, (&state, &derivative), h, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    let after = machine.energy(600.0 * h, &state);
    let w = machine.layout.work();
    ((state[w] - state[w + 1] - (after - before)) / state[w + 2]).abs()
}

/// Tight pockets, so that the balls push their cage from the start.
const PUSHING: [(&str, &str); 1] = [("cage.pocket_gap", "mm(0.01)")];

#[test]
fn identity_power_balances_and_every_term_is_needed() {
    let whole = imbalance(Terms::ALL, &PUSHING);
    assert!(whole < 1e-9, "{whole:e}");
    let without = [
        ("spin transport", Terms { spin_transport: false, ..Terms::ALL }),
        ("eccentricity", Terms { eccentricity: false, ..Terms::ALL }),
        ("translation of the balls", Terms { ball_translation: false, ..Terms::ALL }),
        ("translation of the rings", Terms { ring_translation: false, ..Terms::ALL }),
        ("equal pocket arms", Terms { equal_pocket_arms: false, ..Terms::ALL }),
    ];
    for (name, terms) in without {
        let off = imbalance(terms, &PUSHING);
        assert!(off > 1e-7 && off > 30.0 * whole, "without {name}: {off:e}, whole {whole:e}");
    }
}
