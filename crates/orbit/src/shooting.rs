//! Newton's method on the start of the turn, cage speed and ring, the ball sent round after each step: no ball has to
//! follow a slope over a contact that it loses (U. M. Ascher, R. M. M. Mattheij, R. D. Russell, Numerical Solution of
//! Boundary Value Problems, 1995, chapter 4).

use crate::OrbitError;
use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::{Found, Residual};
use crate::system::{BALL, RING};

/// Shortest share of a step, and by how much it is shortened.
const LEAST_SHARE: f64 = 0.02;
const SHORTER: f64 = 0.35;
/// Steps in which what is off must halve.
const STALLED: usize = 5;
/// Weight of the gap between end and start of the turn, over the scales, against what cage and ring lack.
const OF_GAP: f64 = 0.1;

/// Rounds that close a turn on a given mesh, and the residual at which Newton's method on all unknowns takes over.
const CLOSING: usize = 20;
const NEARLY: f64 = 1e-5;

/// The closing from a neighbour where Newton's method on all unknowns takes over: it needs no more steps than from a
/// nearer turn.
pub(crate) const CLOSE_BY: f64 = 1e-2;
/// The lack of a turn above which that is not tried.
pub(crate) const FAR: f64 = 0.1;
/// Steps from turn to turn.
pub(crate) const ROUNDS: usize = 12;

/// A turn from a start.
pub(crate) struct Turn {
    pub orbit: Orbit,
    pub residual: Residual,
    /// Size of the residual: of cage and ring, and of the gap between end and start.
    pub off: f64,
}

impl Newton<'_> {
    /// The turn from a start, with what it lacks.
    pub fn turn(&mut self, from: &[f64; BALL], border: (f64, [f64; RING]), allowed: f64) -> Turn {
        let orbit = self.march(from, border, allowed);
        let whole = orbit.last_end() == 1.0;
        let residual = self.residual(&orbit);
        let end = orbit.last();
        let gap: f64 = (0..BALL).map(|k| ((end[k] - from[k]) / self.scales.ball[k]).powi(2)).sum();
        let border: f64 = residual.border.iter().map(|v| v * v).sum();
        let off = (border + OF_GAP * OF_GAP * gap).sqrt();
        Turn { orbit, residual, off: if off.is_finite() && whole { off } else { f64::INFINITY } }
    }

    /// Closes the turn on the mesh of an orbit near by, the ball traced over its intervals after each step, until
    /// Newton's method on all unknowns takes over; none where it does not close.
    pub fn closed(&mut self, near: Orbit, tolerance: f64) -> Option<Found> {
        let mut orbit = self.traced(&near.last().clone(), &near)?;
        let mut residual = self.residual(&orbit);
        let mut off = self.off(&residual);
        for _ in 0..CLOSING {
            if residual.worst.relative < NEARLY {
                break;
            }
            let step = self.linearise(&orbit).ok()?.step(&residual.intervals, &residual.border);
            let mut share = self.longest_of_start(&step).min(self.longest_of_border(&step.border));
            loop {
                let moved = self.apply(&orbit, &step, share);
                let start = self.moved_start(orbit.last(), &step, share);
                let next = self.traced(&start, &moved).map(|next| (self.residual(&next), next));
                if let Some((after, next)) = next {
                    let left = self.off(&after);
                    if left < (1.0 - 0.1 * share) * off || share < LEAST_SHARE {
                        (orbit, residual, off) = (next, after, left);
                        break;
                    }
                }
                if share < LEAST_SHARE {
                    return None;
                }
                self.statistics.rejected += 1;
                share *= SHORTER;
            }
        }
        self.met(orbit, (tolerance, CLOSING))
    }

    /// Size of all that is off.
    fn off(&self, residual: &Residual) -> f64 {
        let points: f64 = residual.intervals.iter().flatten().map(|r| r * r).sum();
        (points * OF_GAP * OF_GAP + residual.border.iter().map(|v| v * v).sum::<f64>()).sqrt()
    }

    /// Goes on from a start until what is off is below `close`, at most a number of steps.
    pub fn shoot(
        &mut self,
        from: &[f64; BALL],
        border: (f64, [f64; RING]),
        (allowed, close, rounds): (f64, f64, usize),
    ) -> Result<Turn, OrbitError> {
        let mut turn = self.turn(from, border, allowed);
        let mut halved = (turn.off, 0);
        for round in 0..rounds {
            if turn.off < 0.5 * halved.0 {
                halved = (turn.off, round);
            }
            if turn.off.is_infinite() || turn.off < close || round > halved.1 + STALLED || self.is_spent() {
                break;
            }
            let step = self.linearise(&turn.orbit)?.step(&turn.residual.intervals, &turn.residual.border);
            let mut share = self.longest_of_border(&step.border);
            loop {
                let moved = self.apply(&turn.orbit, &step, share);
                let start = self.moved_start(turn.orbit.last(), &step, share);
                let next = self.turn(&start, (moved.cage_speed, moved.ring), allowed);
                let stop = share < LEAST_SHARE || self.is_spent();
                if next.off < (1.0 - 0.1 * share) * turn.off || stop {
                    turn = next;
                    break;
                }
                self.statistics.rejected += 1;
                share *= SHORTER;
            }
        }
        Ok(turn)
    }
}
