//! Order of the fast scheme where traction is linearised anew at every step.

use crate::fast::Fast;
use crate::forces::System;
use crate::layout::{BALL, ORBIT, SPIN};
use crate::rk4::Rk4;
use crate::start::{Started, start};
use tribodyn_case::{Case, set_value};

const END: f64 = 1.6e-3;

fn started() -> Started {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let changes = [
        ("traction.patch", "GaussJacobi(radial: 3, angles: 12)"),
        ("traction.slip_unit", "MeterPerSecond"),
        ("cage.pocket_stiffness", "N_per_um(0)"),
    ];
    let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    start(case.run_inputs().unwrap(), None).unwrap()
}

fn fast(steps: u32) -> Vec<f64> {
    let Started { mut machine, mut state, .. } = started();
    let mut scheme = Fast::with_linear_error(1e-9);
    let h = END / f64::from(steps);
    for step in 0..steps {
        scheme.step(&mut machine, h * f64::from(step), &mut state, h, 14_000.0);
    }
    state
}

fn reference() -> Vec<f64> {
    let Started { mut machine, mut state, .. } = started();
    let (mut derivative, mut next, mut method) = (state.clone(), state.clone(), Rk4::default());
    let h = END / 800.0;
    for step in 0..800 {
        let t = h * f64::from(step);
        machine.derivative(t, &state, &mut derivative);
        method.step(&mut machine, t, (&state, &derivative), h, &mut next);
        std::mem::swap(&mut state, &mut next);
    }
    state
}

/// Of second order, right after the start too.
#[test]
fn identity_the_fast_scheme_converges() {
    let exact = reference();
    let error = |steps| {
        let state = fast(steps);
        let speeds = (0..13).flat_map(|k| [BALL * k + ORBIT, BALL * k + SPIN, BALL * k + SPIN + 1]);
        speeds.map(|i| (state[i] - exact[i]).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(160), error(320));
    let order = (coarse / fine).log2();
    assert!(order > 1.8, "order {order:.2}: {coarse:e}, {fine:e}");
}
