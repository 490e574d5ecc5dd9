//! One ball alone: its equilibrium with the ring held, found by following its own dynamics in pseudo-time.
//!
//! Rotation and orbit move with their inertia (the orbit's acceleration left out of the axial rotation's), the
//! position follows at once. A ball that starts rolling therefore ends in the stable root that drag and friction would
//! bring it to: rolling where that exists, skidding where it does not.

use crate::block::{BALL, BlockSystem, RING};
use nalgebra::{SMatrix, SVector};
use num_dual::DualSVec64;

/// A ball's state with the worst relative residual of its balances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Settled {
    pub ball: [f64; BALL],
    pub residual: f64,
    pub steps: usize,
}

/// First pseudo-time step from afar, s: shorter than the fastest traction mode at steep slip scales (1e6 1/s).
pub(crate) const FROM_AFAR: f64 = 1e-6;
/// First pseudo-time step near an equilibrium, s: longer than the slowest traction mode, so all but Newton's method.
pub(crate) const FROM_NEAR: f64 = 1e-1;
/// Past this step the iteration is Newton's.
const LAST_STEP: f64 = 1e6;
/// Below this a step no longer moves anything: the ball is stuck.
const SHORTEST_STEP: f64 = 1e-13;
/// Steps before a ball counts as not settling; a fall from rolling to rest takes about a hundred.
const MAX_STEPS: usize = 400;
/// Newton corrections within one implicit step.
const CORRECTIONS: usize = 5;
/// A step is solved when its own residual has fallen this far: it only has to stay near the trajectory.
const STEP_ACCURACY: f64 = 1e-2;

/// Follows ball `index` from `start` until all its balances are within `tolerance`, with a first step in s.
pub(crate) fn settle_ball<S: BlockSystem>(
    system: &S,
    index: usize,
    start: [f64; BALL],
    ring: [f64; RING],
    tolerance: f64,
    first_step: f64,
) -> Settled {
    let mut current = Evaluated::new(system, index, start, ring);
    let mut best = current.clone();
    let mut tau = first_step;
    for steps in 0..MAX_STEPS {
        if current.relative <= tolerance || tau < SHORTEST_STEP || !system.goes_on() {
            return Settled { ball: current.ball, residual: current.relative, steps };
        }
        match implicit_step(system, index, &current, ring, tau) {
            Some((next, corrections)) => {
                // Solved at once: the trajectory is smooth here. Solved with effort: all but keep the step. The slopes
                // of a cheap rule need three corrections where exact ones need one or two.
                let growth = [10.0, 10.0, 4.0, 2.5, 2.0].get(corrections).unwrap_or(&1.2);
                tau = (tau * growth).min(LAST_STEP);
                current = next;
                if current.relative < best.relative {
                    best = current.clone();
                }
            }
            None => tau *= 0.2,
        }
    }
    Settled { ball: best.ball, residual: best.relative, steps: MAX_STEPS }
}

/// Forces on a ball with their derivatives, scaled to relative residuals.
#[derive(Debug, Clone)]
pub(crate) struct Evaluated {
    ball: [f64; BALL],
    force: SVector<f64, BALL>,
    scale: SVector<f64, BALL>,
    pub slope: SMatrix<f64, BALL, BALL>,
    relative: f64,
}

impl Evaluated {
    pub fn new<S: BlockSystem>(system: &S, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> Self {
        type Dual = DualSVec64<BALL>;
        let unknowns: [Dual; BALL] = std::array::from_fn(|k| {
            let mut direction = SVector::<f64, BALL>::zeros();
            direction[k] = 1.0;
            Dual::new(ball[k], num_dual::Derivative::some(direction))
        });
        let balance = system.ball(index, unknowns, ring.map(Dual::from_re));
        let mut slope = SMatrix::<f64, BALL, BALL>::zeros();
        for (k, r) in balance.residual.iter().enumerate() {
            slope.set_row(k, &r.eps.unwrap_generic(nalgebra::Const::<BALL>, nalgebra::Const::<1>).transpose());
        }
        let force = SVector::from_fn(|k, _| balance.residual[k].re);
        let scale = SVector::from(balance.scale);
        let relative = relative(&force, &scale);
        Self { ball, force, scale, slope, relative }
    }
}

fn relative(force: &SVector<f64, BALL>, scale: &SVector<f64, BALL>) -> f64 {
    let worst = force.iter().zip(scale.iter()).fold(0.0f64, |w, (f, s)| {
        let r = if *f == 0.0 { 0.0 } else { f.abs() / s };
        if r.is_nan() { f64::INFINITY } else { w.max(r) }
    });
    if worst.is_nan() { f64::INFINITY } else { worst }
}

/// One implicit Euler step: F(u) − M (u − u0)/τ = 0 by a few Newton corrections. Says how many.
fn implicit_step<S: BlockSystem>(
    system: &S,
    index: usize,
    from: &Evaluated,
    ring: [f64; RING],
    tau: f64,
) -> Option<(Evaluated, usize)> {
    let (limits, _) = system.step_limits();
    let inertia = SVector::from(system.inertia());
    let mut at = from.clone();
    let mut previous = f64::INFINITY;
    for correction in 0..=CORRECTIONS {
        let travelled = SVector::from_fn(|k, _| at.ball[k] - from.ball[k]);
        let residual = at.force - inertia.component_mul(&travelled) / tau;
        let size = relative(&residual, &at.scale);
        if correction > 0 && size <= (STEP_ACCURACY * from.relative).max(1e-13) {
            return Some((at, correction));
        }
        if correction == CORRECTIONS || size > 2.0 * previous || !size.is_finite() {
            return None;
        }
        previous = size;
        let mut matrix = at.slope;
        for k in 0..BALL {
            matrix[(k, k)] -= inertia[k] / tau;
        }
        let change = -matrix.lu().solve(&residual)?;
        let share = change.iter().zip(limits).fold(1.0f64, |s, (c, limit)| s.min(limit / c.abs().max(1e-300)));
        let ball = std::array::from_fn(|k| at.ball[k] + share * change[k]);
        at = Evaluated::new(system, index, ball, ring);
        if !at.relative.is_finite() {
            return None;
        }
    }
    None
}

/// Follows a ball from `start` with steps of `tau` seconds, none of them longer, until its balances are within
/// `tolerance` or `duration` is over: the course that [`settle_ball`] shortens.
#[cfg(test)]
pub(crate) fn follow_ball<S: BlockSystem>(
    system: &S,
    index: usize,
    start: [f64; BALL],
    ring: [f64; RING],
    [tau, duration]: [f64; 2],
    tolerance: f64,
) -> Settled {
    let mut current = Evaluated::new(system, index, start, ring);
    let (mut time, mut step, mut steps) = (0.0, tau, 0);
    while time < duration && current.relative > tolerance && step > SHORTEST_STEP {
        match implicit_step(system, index, &current, ring, step) {
            Some((next, _)) => {
                current = next;
                time += step;
                step = (2.0 * step).min(tau);
            }
            None => step *= 0.2,
        }
        steps += 1;
    }
    Settled { ball: current.ball, residual: current.relative, steps }
}
