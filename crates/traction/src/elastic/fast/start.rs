//! Where the search for a cell's root starts: within about 1e-5 of it, in single precision, for two lots at once.

use super::curve::{At, halley};
use super::setup::Law;
use crate::fast::lanes::{Singles, fused};
use fearless_simd::prelude::*;

/// Square of a trial slip that single precision can work with, (m/s)².
const LEAST: f32 = 1e-30;

/// Numbers of a patch that the start needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    law: Law<f32>,
    rise: Rise,
}

/// A curve without transcendental functions, a few per cent off: with x = σ/σ_m and z = Cλ (σ − σ_m)
/// ```text
/// κ = K_m (n x − x²)/(1 + (n − 2) x),   x < 1,   κ = K_m (1 − d_∞ (1 − (1 + z) e^(−z))),   x > 1
/// ```
/// exact at either end of the rising branch and in its slope there; the second is the curve itself, in which
/// e^(−z) gives way to the reciprocal of five terms of its series.
#[derive(Debug, Clone, Copy)]
struct Rise {
    /// K_m, or where nothing falls the coefficient at infinite slip.
    most: f32,
    /// σ_m, m/s.
    knee: f32,
    /// n, σ_m times the initial slope over K_m.
    bow: f32,
    /// d_∞, the share that is lost at infinite slip.
    lost: f32,
    /// Cλ, s/m.
    rate: f32,
}

impl Rise {
    fn new(law: &Law<f32>, slope: f32) -> Self {
        /// Of a curve that has no peak: where an exponential has come within 5 %.
        const BOW: f32 = 3.0;
        let (knee, most, rate) = (law.peak_slip / law.scale, law.peak, law.curve.c * law.scale);
        // D of the curve, its coefficient at infinite slip.
        let residual = -law.curve.a;
        if knee.is_finite() {
            Self { most, knee, bow: slope * knee / most, lost: 1.0 - residual / most, rate }
        } else {
            Self { most: residual, knee: BOW * residual / slope, bow: BOW, lost: 0.0, rate }
        }
    }
}

impl Start {
    #[expect(clippy::cast_possible_truncation, reason = "what is found here is improved in double precision")]
    pub(super) fn new(law: &Law) -> Self {
        let single = law.map(|x| x as f32);
        Self { rise: Rise::new(&single, law.initial_slope() as f32), law: single }
    }

    /// A speed for every lane, from its trial slip and its last weakening.
    #[inline(always)]
    pub(super) fn speed<S: Simd>(
        &self,
        trial: [Singles<S>; 2],
        last: Singles<S>,
        (yielding, keep): ([f32; 2], f32),
    ) -> Singles<S> {
        let square = fused(trial[0], trial[0], trial[1] * trial[1]).max(LEAST);
        let over = Singles::splat(square.token(), 1.0) / square.sqrt();
        let high = square * over;
        // In units of the trial slip, so that no power of it leaves the range.
        let shares = [trial[0] * over, trial[1] * over];
        let squares = [shares[0] * shares[0], shares[1] * shares[1]];
        let guess = self.guess((high, over, squares), last, (yielding, keep));
        let fits = guess.simd_gt(0.0) & guess.simd_lt(high);
        let guess = fits.select(guess, high);
        let of = At::new(&self.law, guess).coefficient(&self.law, last, keep);
        let bend = of.bend * high;
        let d = [fused(of.value, yielding[0], guess) * over, fused(of.value, yielding[1], guess) * over];
        let grow = [fused(of.slope, yielding[0], 1.0), fused(of.slope, yielding[1], 1.0)];
        let [change, _] = halley(squares, d, grow, [bend * yielding[0], bend * yielding[1]]);
        let next = fused(-change, high, guess);
        let fits = next.simd_gt(0.0) & next.simd_lt(high);
        fits.select(next, guess)
    }

    /// The root with [`Rise`] for the curve, and with one C for both directions: on the rising branch that of
    /// ```text
    /// x + c K_m (1 − r w) (n x − x²)/(1 + (n − 2) x)/σ_m = |s_t|/σ_m,   c = Σ C_k s_t,k²/|s_t|²
    /// ```
    /// else one step from the peak's κ of σ = |s_t| − c κ + 3/2 κ² (C_x − C_y)² s_t,x² s_t,y²/|s_t|⁵, whose last term
    /// has both C to second order.
    #[inline(always)]
    fn guess<S: Simd>(
        &self,
        (high, over, [u2, v2]): (Singles<S>, Singles<S>, [Singles<S>; 2]),
        last: Singles<S>,
        ([cx, cy], keep): ([f32; 2], f32),
    ) -> Singles<S> {
        let Rise { most, knee, bow, lost, rate } = self.rise;
        let over_knee = knee.recip();
        let c = fused(u2, cx, v2 * cy);
        let peak = fused(last, -keep, 1.0) * most;
        let whole = high * over_knee;
        let pull = c * peak * over_knee;
        let half = fused(pull, 0.5 * bow, fused(whole, 1.0 - 0.5 * bow, 0.5));
        let root = half + fused(-pull + (bow - 2.0), whole, half * half).max(0.0).sqrt();
        let rising = whole.simd_lt(root);
        // Beyond the peak.
        let z = ((fused(-c, peak, high) - knee) * rate).max(0.0);
        let z2 = z * z;
        let series = fused(z2, fused(z2, 1.0 / 24.0, fused(z, 1.0 / 6.0, 0.5)), z + 1.0);
        let share = rising.select(whole, z + 1.0) / rising.select(root, series);
        let kappa = fused(share - 1.0, most * lost * (1.0 - keep), peak);
        let aside = kappa * (cx - cy);
        let apart = aside * aside * (u2 * v2) * (over * 1.5);
        let sliding = fused(-c, kappa, high).max(0.5 * knee) + apart;
        rising.select(share * knee, sliding)
    }
}
