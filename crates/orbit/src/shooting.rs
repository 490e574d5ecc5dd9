//! Newton's method on the start of the turn, cage speed and ring, the ball sent round after each step: no ball has to
//! follow a slope over a contact that it loses (U. M. Ascher, R. M. M. Mattheij, R. D. Russell, Numerical Solution of
//! Boundary Value Problems, 1995, chapter 4).

use crate::OrbitError;
use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::Residual;
use crate::system::{BALL, RING};

/// Shortest share of a step, and by how much it is shortened.
const LEAST_SHARE: f64 = 0.02;
const SHORTER: f64 = 0.35;
/// Steps in which what is off must halve.
const STALLED: usize = 5;
/// Weight of the gap between end and start of the turn, over the scales, against what cage and ring lack.
const OF_GAP: f64 = 0.1;

/// A turn from a start.
pub(crate) struct Turn {
    pub orbit: Orbit,
    pub residual: Residual,
    /// What cage and ring lack, with the gap between end and start.
    pub off: f64,
}

impl Newton<'_> {
    fn turn(&mut self, from: &[f64; BALL], border: (f64, [f64; RING]), allowed: f64) -> Turn {
        let orbit = self.march(from, border, allowed);
        let residual = self.residual(&orbit);
        let end = orbit.last();
        let gap: f64 = (0..BALL).map(|k| ((end[k] - from[k]) / self.scales.ball[k]).powi(2)).sum();
        let border: f64 = residual.border.iter().map(|v| v * v).sum();
        let off = (border + OF_GAP * OF_GAP * gap).sqrt();
        Turn { orbit, residual, off: if off.is_finite() { off } else { f64::INFINITY } }
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
            if turn.off < close || round > halved.1 + STALLED {
                break;
            }
            let step = self.linearise(&turn.orbit)?.step(&turn.residual);
            let mut share = self.longest_of_border(&step.border);
            loop {
                let moved = self.apply(&turn.orbit, &step, share);
                let start = self.moved_start(turn.orbit.last(), &step, share);
                let next = self.turn(&start, (moved.cage_speed, moved.ring), allowed);
                if next.off < (1.0 - 0.1 * share) * turn.off || share < LEAST_SHARE {
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
