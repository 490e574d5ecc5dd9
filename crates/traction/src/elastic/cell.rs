//! The equation of one cell of a strip: how far it slips, and the traction that follows.

use crate::{Fall, Scalar, SlipCurve};
use num_dual::Dual64;

/// Square of a trial slip below which nothing moves, (m/s)².
const AT_REST: f64 = 1e-50;
/// Mismatch, relative to the trial slip, above which the law jumps at the root: the cell sticks.
const JUMP: f64 = 1e-6;

/// Length of the friction memory over the shortest with which every cell has one root. At the shortest the root's
/// derivative over the trial slip is unbounded as cells get finer; twice the length keeps it below 2, but for the first
/// cell, in which the memory reaches twice as far as the difference of traction.
pub(super) const MEMORY: f64 = 2.0;

/// The traction coefficient over the true slip, as the peak of the curve up to that slip and the share lost beyond it.
pub(super) struct Friction<C, D> {
    pub(super) curve: C,
    /// The falling branch, in the curve's unit of slip.
    pub(super) fall: Option<Fall<D>>,
    /// λ, slip over sliding speed, s/m.
    pub(super) scale: D,
}

impl<D: Scalar, C: SlipCurve<D>> Friction<C, D> {
    /// Coefficient κ_r on the rising branch or at the peak, and the share d of it that is lost: κ = κ_r (1 − d).
    pub(super) fn at(&self, speed: D) -> [D; 2] {
        let slip = speed * self.scale;
        match &self.fall {
            Some(fall) if slip.re() > fall.slip.re() => {
                let peak = self.curve.coefficient(fall.slip);
                [peak, D::one() - self.curve.coefficient(slip) / peak]
            }
            _ => [self.curve.coefficient(slip), D::zero()],
        }
    }
}

/// One cell of one strip. With σ the true sliding speed, s = s_t σ/(σ + C κ) along each axis.
pub(super) struct Cell<'a, C, D> {
    pub(super) friction: &'a Friction<C, D>,
    /// Slip without traction in this cell s_t, m/s.
    pub(super) trial: [D; 2],
    /// C: change of slip by the pressure as traction, m/s.
    pub(super) yielding: [D; 2],
    /// Share of the last cell's weakening that is kept, and that weakening.
    pub(super) memory: [D; 2],
}

/// The state of a cell.
pub(super) struct Solved<D> {
    /// Traction over the strip's pressure; the force on the ball.
    pub(super) traction: [D; 2],
    /// σ, m/s.
    pub(super) speed: D,
    /// κ.
    pub(super) coefficient: D,
    /// d as the memory has it.
    pub(super) weakening: D,
}

impl<D: Scalar, C: SlipCurve<D>> Cell<'_, C, D> {
    fn coefficient(&self, speed: D) -> [D; 2] {
        let [rising, lost] = self.friction.at(speed);
        let [keep, last] = self.memory;
        let weakening = last * keep + lost * (-keep + 1.0);
        [rising * (-weakening + 1.0), weakening]
    }

    /// 1/√Σ(s_t/(σ + C κ))² − 1, which rises with σ and vanishes at the root.
    fn excess(&self, speed: D) -> D {
        let [kappa, _] = self.coefficient(speed);
        let share = |k: usize| {
            let part = self.trial[k] / (speed + self.yielding[k] * kappa);
            part * part
        };
        (share(0) + share(1)).sqrt().recip() - 1.0
    }

    /// Traction and slip, given the same cell in first-order dual numbers and a guess of the speed.
    pub(super) fn solve<B: SlipCurve<Dual64>>(&self, slope: &Cell<'_, B, Dual64>, guess: f64) -> Solved<D> {
        let square = self.trial[0] * self.trial[0] + self.trial[1] * self.trial[1];
        if square.re() < AT_REST {
            return self.at_rest();
        }
        let (root, rise, mismatch) = slope.root(square.re().sqrt(), guess);
        if mismatch.abs() > JUMP {
            return self.stuck(D::from(root));
        }
        // One Newton step carries the derivatives into the root.
        let start = D::from(root);
        let speed = start - self.excess(start) / rise;
        let [coefficient, weakening] = self.coefficient(speed);
        let traction = [0, 1].map(|k| -self.trial[k] * coefficient / (speed + self.yielding[k] * coefficient));
        Solved { traction, speed, coefficient, weakening }
    }

    /// Nothing slips, and traction follows slip by the initial slope of the law.
    fn at_rest(&self) -> Solved<D> {
        let [keep, last] = self.memory;
        let weakening = last * keep;
        let scale = self.friction.scale;
        let slope = self.friction.curve.over_slip(D::zero()) * scale * (-weakening + 1.0);
        let traction = [0, 1].map(|k| -self.trial[k] * slope / (self.yielding[k] * slope + 1.0));
        Solved { traction, speed: D::zero(), coefficient: D::zero(), weakening }
    }

    /// The law holds the cell at every traction up to the one here: Coulomb's below its bound.
    fn stuck(&self, speed: D) -> Solved<D> {
        let [keep, last] = self.memory;
        let traction = [0, 1].map(|k| -self.trial[k] / self.yielding[k]);
        Solved { traction, speed, coefficient: D::zero(), weakening: last * keep }
    }
}

impl<C: SlipCurve<Dual64>> Cell<'_, C, Dual64> {
    /// Root of the excess, its slope, and what is left of the excess, by Newton's method within a bracket.
    fn root(&self, trial: f64, guess: f64) -> (f64, f64, f64) {
        let (mut low, mut high) = (0.0, trial);
        let mut speed = if guess > 0.0 && guess < trial { guess } else { trial };
        let mut last = f64::INFINITY;
        for _ in 0..300 {
            let excess = self.excess(Dual64::from(speed).derivative());
            if excess.re < 0.0 {
                low = speed
            } else {
                high = speed
            }
            let next = speed - excess.re / excess.eps;
            let newton = next > low && next < high && excess.re.abs() < 0.5 * last;
            last = excess.re.abs();
            if excess.re == 0.0 || high - low <= 4e-16 * high {
                return (speed, excess.eps, excess.re);
            }
            if newton && (next - speed).abs() <= 1e-9 * speed {
                return (next, excess.eps, 0.0);
            }
            speed = if newton { next } else { 0.5 * (low + high) };
        }
        let excess = self.excess(Dual64::from(speed).derivative());
        (speed, excess.eps, excess.re)
    }
}
