//! Steps of all schemes without a run around them, for the tests of the equations.

use crate::equations::Equations;
use crate::fast::Fast;
use crate::forces::System;
use crate::machine::Machine;
use tribodyn_numerics::{DormandPrince, Rk4};

#[derive(Debug, Clone, Copy)]
pub(crate) enum Scheme {
    RungeKutta,
    DormandPrince,
    Fast,
}

/// From a state at time 0 over a number of steps.
pub(crate) fn run<E: Equations>(scheme: Scheme, (equations, state): (&mut E, &mut Vec<f64>), h: f64, steps: u32) {
    run_watched(scheme, (equations, state), (h, steps), |_, _, _| {});
}

/// The same with a look at equations, time and state after each step.
pub(crate) fn run_watched<E: Equations>(
    scheme: Scheme,
    (equations, state): (&mut E, &mut Vec<f64>),
    (h, steps): (f64, u32),
    mut look: impl FnMut(&E, f64, &[f64]),
) {
    let n = state.len();
    let (mut derivative, mut next, scale) = (vec![0.0; n], vec![0.0; n], vec![1.0; n]);
    let (mut rk4, mut dp54, mut fast) = (Rk4::default(), DormandPrince::default(), Fast::with_linear_error(1e-9));
    for step in 0..steps {
        let t = h * f64::from(step);
        equations.derivative(t, state, &mut derivative);
        match scheme {
            Scheme::RungeKutta => rk4.step(equations.rates(), t, (state, &derivative), h, &mut next),
            Scheme::DormandPrince => {
                dp54.step(equations.rates(), t, (state, &derivative), h, &scale, &mut next);
            }
            Scheme::Fast => {
                next.copy_from_slice(state);
                fast.step(equations, t, &mut next, h);
            }
        }
        std::mem::swap(state, &mut next);
        look(equations, t + h, state);
    }
}

/// Work put in that was neither lost nor stored since the energy was `before`, over all that went through.
pub(crate) fn imbalance(machine: &Machine, (t, state): (f64, &[f64]), before: f64) -> f64 {
    let (after, w) = (machine.energy(t, state), machine.layout.work());
    ((state[w] - state[w + 1] - (after - before)) / state[w + 2]).abs()
}
