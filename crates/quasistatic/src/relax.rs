//! Ring and balls together in pseudo-time: where Newton's method finds no way, all that drag and friction would do.
//!
//! Implicit Euler steps of M du/dt = F(u). Rotation and orbit move with their inertia, the balls' positions follow at
//! once, the ring creeps. A bearing whose balls lose their rolling equilibrium together, each with the load that the
//! others leave it, thus falls into the state that it would come to rest in: rolling where the inner race drives,
//! skidding where drag is stronger. [`crate::settle`] does the same for one ball with the ring held, and cannot follow
//! such a fall.

use crate::block::{
    BALL, BlockState, BlockSystem, Linearised, RING, Residuals, Shift, Worst, apply, linearise, step_with,
};
use nalgebra::SVector;
use tribodyn_bearing::RingFreedom;

/// Time in which the ring creeps to its balance, s of pseudo-time: shorter than what rotation and orbit take.
const CREEP: f64 = 1e-5;
/// Past this step the iteration is Newton's.
const LAST_STEP: f64 = 1e6;
/// Below this a step no longer moves anything.
const SHORTEST_STEP: f64 = 1e-12;
/// Newton corrections within one implicit step.
const CORRECTIONS: usize = 6;
/// A step is solved when its own residual has fallen this far: it only has to stay near the course.
const STEP_ACCURACY: f64 = 1e-2;
/// Growth of the step by the number of corrections that it took.
const GROWTH: [f64; 5] = [10.0, 5.0, 2.5, 2.0, 1.5];

/// A state with its residuals.
#[derive(Debug, Clone)]
struct At {
    state: BlockState,
    residuals: Residuals,
}

impl At {
    fn new<S: BlockSystem>(system: &S, state: BlockState) -> Self {
        let residuals = Residuals::new(system, &state);
        Self { state, residuals }
    }

    fn worst(&self) -> Worst {
        self.residuals.worst
    }
}

/// Follows ring and balls from `start` until all balances are within `tolerance` or `max_steps` are taken, with a first
/// step in s. Gives the state that came nearest to balance.
pub(crate) fn relax<S: BlockSystem>(
    system: &S,
    start: BlockState,
    tolerance: f64,
    first_step: f64,
    max_steps: usize,
) -> BlockState {
    let mut at = At::new(system, start);
    let mut best = at.clone();
    let mut tau = first_step;
    for _ in 0..max_steps {
        if at.worst().residual <= tolerance || tau < SHORTEST_STEP || !system.goes_on() {
            break;
        }
        match implicit_step(system, &at, tau) {
            Some((next, corrections)) => {
                tau = (tau * GROWTH.get(corrections - 1).unwrap_or(&1.0)).min(LAST_STEP);
                at = next;
                if at.worst().residual < best.worst().residual {
                    best = at.clone();
                }
            }
            None => tau *= 0.2,
        }
    }
    best.state
}

/// One implicit Euler step by a few Newton corrections. Says how many.
fn implicit_step<S: BlockSystem>(system: &S, from: &At, tau: f64) -> Option<(At, usize)> {
    let shift = Shift {
        ball: system.inertia().map(|inertia| inertia / tau),
        ring: system.weights().1.map(|weight| weight * (CREEP / tau)),
    };
    let aim = (STEP_ACCURACY * from.worst().residual).max(1e-13);
    let mut at = from.clone();
    let mut previous = f64::INFINITY;
    for correction in 0..=CORRECTIONS {
        let (pull, size) = pull(system, from, &at, &shift);
        if correction > 0 && size <= aim {
            return Some((at, correction));
        }
        if correction == CORRECTIONS || size > 3.0 * previous || !size.is_finite() {
            return None;
        }
        previous = size;
        let mut linear = linearise(system, &at.state);
        pull.add_to(&mut linear);
        let step = step_with(system, &linear, &shift).ok()?;
        at = At::new(system, apply(system, &at.state, &step, 1.0));
        if !at.worst().residual.is_finite() {
            return None;
        }
    }
    None
}

/// Forces of inertia and creep: −M (u − u0)/τ.
struct Pull {
    balls: Vec<SVector<f64, BALL>>,
    ring: SVector<f64, RING>,
}

impl Pull {
    fn add_to(&self, linear: &mut Linearised) {
        for (block, pull) in linear.balls.iter_mut().zip(&self.balls) {
            block.residual += pull;
        }
        linear.ring_residual += self.ring;
    }
}

/// The pull between two states, and the largest residual that it leaves over the size of its terms.
fn pull<S: BlockSystem>(system: &S, from: &At, at: &At, shift: &Shift) -> (Pull, f64) {
    let mut size = 0.0f64;
    let mut take = |value: f64, scale: f64| {
        let relative = if value == 0.0 { 0.0 } else { value.abs() / scale };
        size = size.max(if relative.is_nan() { f64::INFINITY } else { relative });
    };
    let (was, is) = (&from.state, &at.state);
    let mut balls = Vec::with_capacity(is.balls.len());
    for (index, (now, before)) in is.balls.iter().zip(&was.balls).enumerate() {
        let pull = SVector::<f64, BALL>::from_fn(|k, _| -shift.ball[k] * (now[k] - before[k]));
        let (force, scale) = (&at.residuals.balls[index].0, &at.residuals.ball_scales[index]);
        (0..BALL).for_each(|k| take(force[k] + pull[k], scale[k]));
        balls.push(pull);
    }
    let ring = SVector::<f64, RING>::from_fn(|k, _| -shift.ring[k] * (is.ring[k] - was.ring[k]));
    for (k, freedom) in system.ring().iter().enumerate() {
        if matches!(freedom, RingFreedom::Loaded(_)) {
            take(at.residuals.ring[k] + ring[k], at.residuals.ring_scale[k]);
        }
    }
    (Pull { balls, ring }, size)
}
