//! Two ways to step: downhill in a convex energy, and Newton with the balls settled one by one where it fails.

use crate::block::{BlockState, BlockSystem, Iterate, Linearised, Residuals, Step, apply, linearise, step};
use crate::driver::{Method, Stuck};
use crate::settle::{FROM_AFAR, settle_ball};

/// Levenberg–Marquardt in a convex energy: every accepted step goes downhill, so it ends in the one minimum.
#[derive(Debug, Clone)]
pub(crate) struct Downhill {
    pub mu: f64,
}

/// Regularisation beyond which a step is too small to matter.
const HOPELESS: f64 = 1e12;
/// Below this it is switched off.
const NEGLIGIBLE: f64 = 1e-7;

impl Method for Downhill {
    fn advance<S: BlockSystem>(&mut self, system: &S, iterate: &mut Iterate) -> Result<(), Stuck> {
        let linear = linearise(system, &iterate.state);
        iterate.statistics.jacobians += 1;
        let energy = system.energy(&iterate.state);
        while self.mu < HOPELESS {
            let mu = if self.mu < NEGLIGIBLE { 0.0 } else { self.mu };
            if let Ok(step) = step(system, &linear, mu) {
                let trial = apply(system, &iterate.state, &step, 1.0);
                // Rounding of a sum of a few hundred terms must not stop the last steps.
                if system.energy(&trial) <= energy + 1e-13 * energy.abs() {
                    let residuals = Residuals::new(system, &trial);
                    iterate.keep(trial, residuals);
                    self.mu *= 0.1;
                    return Ok(());
                }
            }
            iterate.statistics.rejected += 1;
            self.mu = (self.mu * 8.0).max(1e-5);
        }
        Err(Stuck)
    }
}

/// Newton on everything at once; where that does not help, Newton on the ring with each ball settled anew.
#[derive(Debug, Clone)]
pub(crate) struct NewtonOrNested {
    /// Relative residual to which balls are settled.
    pub settle_to: f64,
    /// Steps that may still be taken although the residual rises.
    pub jumps: usize,
    /// Halvings of the ring's step with the balls settled, before giving up; none where balls are not settled one by
    /// one.
    halvings: i32,
    /// Slopes of an earlier step, while they still serve.
    chord: Option<Linearised>,
}

impl NewtonOrNested {
    pub fn new(settle_to: f64, jumps: usize) -> Self {
        Self { settle_to, jumps, halvings: HALVINGS, chord: None }
    }

    /// Newton alone, for states that are near already.
    pub fn newton_alone() -> Self {
        Self { settle_to: 0.0, jumps: 0, halvings: 0, chord: None }
    }

    /// A step with the slopes of an earlier one and what the steps since have taught.
    fn chord_step<S: BlockSystem>(&mut self, system: &S, iterate: &mut Iterate) -> bool {
        let Some(linear) = self.chord.take() else { return false };
        let Ok(step) = step(system, &linear, 0.0) else { return false };
        self.try_step(system, iterate, linear, &step)
    }

    /// Keeps a trial that is worth it, and the slopes too where they serve well.
    fn try_step<S: BlockSystem>(
        &mut self,
        system: &S,
        iterate: &mut Iterate,
        mut linear: Linearised,
        step: &Step,
    ) -> bool {
        let trial = apply(system, &iterate.state, step, 1.0);
        let residuals = Residuals::new(system, &trial);
        let (before, after) = (iterate.worst().residual, residuals.worst.residual);
        if after > WORTHWHILE * before {
            return after <= RISE * before && after <= NEAR && self.second_step(system, iterate, trial, residuals);
        }
        if after <= CHORD * before {
            linear.learn((&iterate.state, &iterate.residuals), (&trial, &residuals));
            self.chord = Some(linear);
        }
        iterate.keep(trial, residuals);
        iterate.stiffness = Some(step.stiffness);
        true
    }

    /// One more step from a trial that is no better than the state before: what a long step leaves is the square of the
    /// change of rolling, slip of the width of the traction curve's peak, and a second step takes that away. Both are
    /// kept where they are worth it together.
    fn second_step<S: BlockSystem>(
        &mut self,
        system: &S,
        iterate: &mut Iterate,
        from: BlockState,
        residuals: Residuals,
    ) -> bool {
        let linear = linearise(system, &from);
        iterate.statistics.jacobians += 1;
        let Ok(step) = step(system, &linear, 0.0) else { return false };
        let trial = apply(system, &from, &step, 1.0);
        let reached = Residuals::new(system, &trial);
        let worth = reached.worst.residual <= WORTHWHILE * iterate.worst().residual;
        if worth {
            let mut linear = linear;
            linear.learn((&from, &residuals), (&trial, &reached));
            self.chord = Some(linear);
            iterate.keep(from, residuals);
            iterate.keep(trial, reached);
            iterate.stiffness = Some(step.stiffness);
        }
        worth
    }
}

/// A step may raise the residual this much, and to no more than this relative residual, for a second one to be tried
/// from there. The bound keeps a ball from being thrown over the peak of the traction curve: there the residual is of
/// the order of one.
const RISE: f64 = 3.0;
const NEAR: f64 = 0.05;

/// A step must bring the residual down to this share for its slopes to be used again: a new Jacobian costs about three
/// such steps.
const CHORD: f64 = 0.2;

/// A simultaneous step must bring the worst residual down to this share, or the nested step is tried.
const WORTHWHILE: f64 = 0.5;
/// Halvings of the ring's step before giving up.
const HALVINGS: i32 = 10;

impl Method for NewtonOrNested {
    fn advance<S: BlockSystem>(&mut self, system: &S, iterate: &mut Iterate) -> Result<(), Stuck> {
        if self.chord_step(system, iterate) {
            return Ok(());
        }
        let linear = linearise(system, &iterate.state);
        iterate.statistics.jacobians += 1;
        // A tiny weight keeps a ball that touches nothing solvable.
        let step = step(system, &linear, 0.0).or_else(|_| step(system, &linear, 1e-9)).map_err(|_| Stuck)?;
        if self.try_step(system, iterate, linear, &step) {
            return Ok(());
        }
        iterate.stiffness = None;
        let before = iterate.worst().residual;
        let mut least: Option<(BlockState, Residuals)> = None;
        for halving in 0..self.halvings {
            let share = 0.5f64.powi(halving);
            let predicted = apply(system, &iterate.state, &step, share);
            let settled = settle(system, &predicted, self.settle_to, FROM_AFAR);
            let residuals = Residuals::new(system, &settled);
            let reached = residuals.worst.residual;
            if reached < before {
                iterate.keep(settled, residuals);
                return Ok(());
            }
            iterate.statistics.rejected += 1;
            if least.as_ref().is_none_or(|(_, least)| reached < least.worst.residual) {
                least = Some((settled, residuals));
            }
        }
        // A ball that loses its rolling equilibrium falls into skidding: its force on the ring jumps, and so does the
        // residual. Go on from there, but not for ever.
        match least {
            Some((state, residuals)) if self.jumps > 0 && residuals.worst.residual.is_finite() => {
                self.jumps -= 1;
                iterate.keep(state, residuals);
                Ok(())
            }
            _ => Err(Stuck),
        }
    }
}

/// All balls in equilibrium, each in its own pseudo-time from a first step in s, the ring held where it is.
pub(crate) fn settle<S: BlockSystem>(system: &S, start: &BlockState, tolerance: f64, first_step: f64) -> BlockState {
    let ball = |(index, &ball)| settle_ball(system, index, ball, start.ring, tolerance, first_step).ball;
    BlockState { balls: start.balls.iter().enumerate().map(ball).collect(), ring: start.ring }
}
