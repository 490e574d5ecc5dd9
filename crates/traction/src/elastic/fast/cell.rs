//! The equation of a cell in eight strips at a time.

use super::setup::{Law, Rise};
use crate::fast::elementary::exp_m1;
use crate::fast::lanes::{Lanes, Mask};
use fearless_simd::prelude::*;

/// Square of a trial slip below which nothing moves, (m/s)²: as in the plain cell.
const AT_REST: f64 = 1e-50;

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
    low: Lanes<S>,
    high: Lanes<S>,
    /// Size of the last step.
    step: Lanes<S>,
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
            low: z,
            high: z,
            step: z,
            at: At::nothing(simd),
            done: none,
            rest: none,
        }
    }

    /// Sets the trial slip, and a speed to start from.
    #[inline(always)]
    pub(super) fn open(&mut self, law: &Law, (yielding, keep): ([f64; 2], f64), trial: [Lanes<S>; 2], last: Lanes<S>) {
        let lanes = |x: f64| Lanes::splat(last.token(), x);
        let [u, v] = trial;
        let square = u * u + v * v;
        self.rest = square.simd_lt(AT_REST);
        // Any number but zero, so that the lane runs through without harm.
        self.trial = [self.rest.select(lanes(1.0), u), v];
        self.high = self.rest.select(lanes(1.0), square.sqrt());
        (self.low, self.step, self.last) = (lanes(0.0), lanes(f64::INFINITY), last);
        let guess = self.guess(law, yielding, keep);
        let fits = guess.simd_gt(0.0) & guess.simd_lt(self.high);
        self.speed = fits.select(guess, self.high);
        self.done = self.rest;
    }

    /// The root with [`super::setup::Rise`] for the curve, and with one C for both directions: on the rising branch
    /// that of
    /// ```text
    /// x + c K_m (1 − r w) (n x − x²)/(1 + (n − 2) x)/σ_m = |s_t|/σ_m,   c = Σ C_k s_t,k²/|s_t|²
    /// ```
    /// else one step from the peak's κ of σ = |s_t| − c κ + 3/2 κ² (C_x − C_y)² s_t,x² s_t,y²/|s_t|⁵, whose last term
    /// has both C to second order.
    #[inline(always)]
    fn guess(&self, law: &Law, yielding: [f64; 2], keep: f64) -> Lanes<S> {
        let lanes = |x: f64| Lanes::splat(self.last.token(), x);
        let Rise { most, knee, bow, lost, rate } = law.rise;
        let [cx, cy] = yielding;
        let [u2, v2] = [self.trial[0] * self.trial[0], self.trial[1] * self.trial[1]];
        let over = lanes(1.0) / (u2 + v2);
        let c = (u2 * cx + v2 * cy) * over;
        let peak = (self.last * -keep + 1.0) * most;
        let whole = self.high * knee.recip();
        let pull = c * peak * knee.recip();
        let half = (pull * bow - whole * (bow - 2.0) + 1.0) * 0.5;
        let root = half + (half * half + (-pull + (bow - 2.0)) * whole).max(0.0).sqrt();
        let rising = whole.simd_lt(root);
        // Beyond the peak.
        let z = ((self.high - c * peak - knee) * rate).max(0.0);
        let z2 = z * z;
        let series = (z + 1.0) + z2 * (z * (1.0 / 6.0) + 0.5) + z2 * z2 * (1.0 / 24.0);
        let share = rising.select(whole, z + 1.0) / rising.select(root, series);
        let kappa = peak - (-share + 1.0) * (most * lost * (1.0 - keep));
        let aside = kappa * (cx - cy) * over;
        let apart = aside * aside * (u2 * v2) * (self.high * over * 1.5);
        let sliding = (self.high - c * kappa).max(0.5 * knee) + apart;
        rising.select(share * knee, sliding)
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
        (at, of)
    }

    /// One step of Halley's method within the bracket, for 1/S − 1 with S = Σ a²:
    /// ```text
    /// S' = −2 R,   R = Σ a² D'/D,   R' = Σ a² (D''/D − 3 (D'/D)²),   P = S (1 − S)/2
    /// δσ = −P R/(S R² − P R'/2)
    /// ```
    /// with the powers of D_x D_y multiplied out, so that it is divided once.
    #[inline(always)]
    pub(super) fn improve(&mut self, law: &Law, [cx, cy]: [f64; 2], keep: f64) {
        self.at = At::new(law, self.speed);
        let at = &self.at;
        let of = self.coefficient(law, at, keep);
        let (dx, dy) = (of.value * cx + self.speed, of.value * cy + self.speed);
        let (gx, gy) = (of.slope * cx + 1.0, of.slope * cy + 1.0);
        let (dx2, dy2, product) = (dx * dx, dy * dy, dx * dy);
        let (nx, ny) = (self.trial[0] * self.trial[0] * dy2, self.trial[1] * self.trial[1] * dx2);
        let short = product * product - (nx + ny);
        let below = short.simd_lt(0.0);
        let rise = nx * dy * gx + ny * dx * gy;
        let left = at.past.select(Lanes::splat(rise.token(), 1.0 - keep), -of.weakening + 1.0);
        let bend = at.bend * left;
        let part_x = nx * dy2 * (bend * dx * cx - gx * gx * 3.0);
        let part_y = ny * dx2 * (bend * dy * cy - gy * gy * 3.0);
        let rise2 = rise * rise;
        let slope = (rise2 - short * (part_x + part_y) * 0.25).max(rise2 * 0.25);
        let change = short * rise * product * 0.5 / slope;
        let next = self.speed - change;
        let step = change.abs();
        let low = below.select(self.speed, self.low);
        let high = below.select(self.high, self.speed);
        // Rounding may leave the root at the very end of the bracket.
        let newton = next.simd_ge(low) & next.simd_le(high) & step.simd_lt(self.step * 0.5);
        let settled = newton & step.simd_le(self.speed * SETTLED);
        let narrow = (high - low).simd_le(high * 4e-16);
        let moved = newton.select(next, narrow.select(self.speed, (low + high) * 0.5));
        self.speed = self.done.select(self.speed, moved);
        (self.low, self.high, self.step) = (low, high, step);
        self.done |= settled | narrow;
    }
}
