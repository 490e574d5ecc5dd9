//! The equation of a cell in eight strips at a time.

use super::setup::Law;
use crate::fast::elementary::exp_m1;
use crate::fast::lanes::{Lanes, Mask};
use fearless_simd::prelude::*;

/// Square of a trial slip below which nothing moves, (m/s)²: as in the plain cell.
const AT_REST: f64 = 1e-60;

/// Relative step behind which the root is as good as rounding lets it be: the next step would be about its cube.
const SETTLED: f64 = 3e-5;

/// The curve at a sliding speed.
#[derive(Clone, Copy)]
pub(super) struct At<S: Simd> {
    /// exp(−C s) − 1, exp(−C s) and s.
    pub(super) e: Lanes<S>,
    pub(super) decay: Lanes<S>,
    pub(super) slip: Lanes<S>,
    /// κ and dκ/dσ, without memory.
    pub(super) plain: Lanes<S>,
    pub(super) slope: Lanes<S>,
    /// d²κ/dσ².
    bend: Lanes<S>,
    /// σ, m/s.
    speed: Lanes<S>,
    /// Lanes beyond the peak.
    pub(super) past: Mask<S>,
}

impl<S: Simd> At<S> {
    #[inline(always)]
    pub(super) fn new(law: &Law, speed: Lanes<S>) -> Self {
        let slip = speed * law.scale;
        let e = exp_m1((slip * -law.curve.c).max(-700.0));
        let decay = e + 1.0;
        let plain = slip * decay * law.curve.b + e * law.curve.a;
        let inner = (slip * law.curve.b + law.curve.a) * -law.curve.c + law.curve.b;
        let slope = decay * inner * law.scale;
        let bend = (slope + decay * (law.curve.b * law.scale)) * (-law.curve.c * law.scale);
        Self { e, decay, slip, plain, slope, bend, speed, past: slip.simd_gt(law.peak_slip) }
    }

    #[inline(always)]
    fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        Self { e: z, decay: z, slip: z, plain: z, slope: z, bend: z, speed: z, past: z.simd_lt(z) }
    }

    /// At a speed so near that the exponential need not be taken again: within [`SETTLED`].
    #[inline(always)]
    fn moved_to(&self, law: &Law, speed: Lanes<S>) -> Self {
        let far = speed - self.speed;
        let slip = far * law.scale;
        let x = slip * law.curve.c;
        let less = self.decay * (x - x * x * 0.5);
        Self {
            e: self.e - less,
            decay: self.decay - less,
            slip: self.slip + slip,
            plain: self.plain + (self.slope + self.bend * far * 0.5) * far,
            slope: self.slope + self.bend * far,
            speed,
            ..*self
        }
    }

    /// κ_r on the rising branch or at the peak, and the share d of it that is lost.
    #[inline(always)]
    pub(super) fn rising_and_lost(&self, law: &Law) -> [Lanes<S>; 2] {
        let lanes = |x: f64| Lanes::splat(self.e.token(), x);
        let lost = lanes(1.0) - self.plain * law.over_peak;
        [self.past.select(lanes(law.peak), self.plain), self.past.select(lost, lanes(0.0))]
    }
}

/// One cell of eight strips.
#[derive(Clone, Copy)]
pub(super) struct Cell<S: Simd> {
    pub(super) trial: [Lanes<S>; 2],
    /// The last cell's weakening.
    pub(super) last: Lanes<S>,
    pub(super) speed: Lanes<S>,
    /// κ of the cell before.
    coefficient: Lanes<S>,
    low: Lanes<S>,
    high: Lanes<S>,
    mismatch: Lanes<S>,
    /// The curve where it was taken last.
    at: At<S>,
    done: Mask<S>,
    pub(super) rest: Mask<S>,
}

/// κ, its derivative over σ, and the weakening.
#[derive(Clone, Copy)]
pub(super) struct Coefficient<S: Simd> {
    pub(super) value: Lanes<S>,
    pub(super) slope: Lanes<S>,
    pub(super) weakening: Lanes<S>,
}

/// a = s_t/(σ + C κ), the same over the denominators D, dD/dσ, and Σ a² (dD/dσ)/D.
#[derive(Clone, Copy)]
pub(super) struct Direction<S: Simd> {
    pub(super) a: [Lanes<S>; 2],
    pub(super) inverse: [Lanes<S>; 2],
    pub(super) grow: [Lanes<S>; 2],
    pub(super) rise: Lanes<S>,
}

impl<S: Simd> Cell<S> {
    #[inline(always)]
    pub(super) fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let none = z.simd_lt(z);
        Self {
            trial: [z; 2],
            last: z,
            speed: z,
            coefficient: z,
            low: z,
            high: z,
            mismatch: z,
            at: At::nothing(simd),
            done: none,
            rest: none,
        }
    }

    /// Forgets the cell before.
    #[inline(always)]
    pub(super) fn enter(&mut self) {
        self.at.past = self.speed.simd_lt(self.speed);
    }

    /// Sets the trial slip, and a speed to start from.
    ///
    /// Where C times the most that the curve carries exceeds the trial slip the cell sticks, with a speed from the
    /// rising branch that carries it; else it slides against the last κ, or against the peak.
    #[inline(always)]
    pub(super) fn open(&mut self, law: &Law, yielding: [f64; 2], trial: [Lanes<S>; 2], last: Lanes<S>) {
        let lanes = |x: f64| Lanes::splat(last.token(), x);
        let [u, v] = trial;
        let (u2, v2) = (u * u, v * v);
        let square = u2 + v2;
        self.rest = square.simd_lt(AT_REST);
        // Any number but zero, so that the lane runs through without harm.
        self.trial = [self.rest.select(lanes(1.0), u), v];
        self.high = self.rest.select(lanes(1.0), square.sqrt());
        let yielded = u2 * yielding[0] + v2 * yielding[1];
        let most = (-last + 1.0) * law.rise.most;
        let (bound, slip) = (yielded * most, square * self.high);
        let sticking = slip * bound * law.rise.knee
            / (bound * bound * law.rise.bow - slip * slip * (law.rise.bow - 1.0)).max(AT_REST);
        let against = self.at.past.select(self.coefficient, most);
        let sliding = self.high - yielded * against / square.max(AT_REST);
        let speed = slip.simd_lt(bound).select(sticking, sliding);
        let fits = speed.simd_gt(0.0) & speed.simd_lt(self.high);
        self.speed = fits.select(speed, self.high);
        (self.low, self.mismatch, self.last) = (lanes(0.0), lanes(f64::INFINITY), last);
        self.done = self.rest;
    }

    /// True when every lane has its root.
    #[inline(always)]
    pub(super) fn is_done(&self) -> bool {
        self.done.all_true()
    }

    #[inline(always)]
    fn coefficient(&self, law: &Law, at: &At<S>, keep: f64) -> Coefficient<S> {
        let [rising, lost] = at.rising_and_lost(law);
        let weakening = self.last * keep + lost * (1.0 - keep);
        let left = -weakening + 1.0;
        let slope = at.past.select(at.slope * (1.0 - keep), at.slope * left);
        Coefficient { value: rising * left, slope, weakening }
    }

    #[inline(always)]
    pub(super) fn direction(&self, of: &Coefficient<S>, yielding: [f64; 2]) -> Direction<S> {
        let [dx, dy] = yielding.map(|c| of.value * c + self.speed);
        let product = Lanes::splat(dx.token(), 1.0) / (dx * dy);
        let inverse = [dy * product, dx * product];
        let a = [self.trial[0] * inverse[0], self.trial[1] * inverse[1]];
        let grow = yielding.map(|c| of.slope * c + 1.0);
        let rise = a[0] * a[0] * inverse[0] * grow[0] + a[1] * a[1] * inverse[1] * grow[1];
        Direction { a, inverse, grow, rise }
    }

    /// The curve and κ at the root.
    #[inline(always)]
    pub(super) fn close(&mut self, law: &Law, keep: f64) -> (At<S>, Coefficient<S>) {
        let at = if self.rest.any_true() {
            self.speed = self.rest.select(Lanes::splat(self.speed.token(), 0.0), self.speed);
            At::new(law, self.speed)
        } else {
            self.at.moved_to(law, self.speed)
        };
        let of = self.coefficient(law, &at, keep);
        self.coefficient = of.value;
        (at, of)
    }

    /// One step of Halley's method within the bracket, for 1/S − 1 with S = Σ a²:
    /// ```text
    /// S' = −2 R,   R = Σ a² D'/D,   R' = Σ a² (D''/D − 3 (D'/D)²),   P = S (1 − S)/2
    /// δσ = −P R/(S R² − P R'/2)
    /// ```
    #[inline(always)]
    pub(super) fn improve(&mut self, law: &Law, yielding: [f64; 2], keep: f64) {
        self.at = At::new(law, self.speed);
        let at = &self.at;
        let of = self.coefficient(law, at, keep);
        let Direction { a, inverse, grow, rise } = self.direction(&of, yielding);
        let squares = [a[0] * a[0], a[1] * a[1]];
        let square = squares[0] + squares[1];
        let short = -square + 1.0;
        let below = short.simd_lt(0.0);
        let product = square * short * 0.5;
        let left = at.past.select(Lanes::splat(rise.token(), 1.0 - keep), -of.weakening + 1.0);
        let bend = at.bend * left;
        let part = |k: usize| {
            let growing = inverse[k] * grow[k];
            squares[k] * (bend * inverse[k] * yielding[k] - growing * growing * 3.0)
        };
        let rise2 = square * rise * rise;
        let slope = rise2 - product * (part(0) + part(1)) * 0.5;
        let next = self.speed - product * rise / slope.max(rise2 * 0.25);
        let mismatch = short.abs();
        let low = below.select(self.speed, self.low);
        let high = below.select(self.high, self.speed);
        // Rounding may leave the root at the very end of the bracket.
        let newton = next.simd_ge(low) & next.simd_le(high) & mismatch.simd_lt(self.mismatch * 0.5);
        let settled = newton & (next - self.speed).abs().simd_le(self.speed * SETTLED);
        let narrow = (high - low).simd_le(high * 4e-16);
        let step = newton.select(next, narrow.select(self.speed, (low + high) * 0.5));
        self.speed = self.done.select(self.speed, step);
        (self.low, self.high, self.mismatch) = (low, high, mismatch);
        self.done |= settled | narrow;
    }
}
