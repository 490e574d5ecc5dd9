//! Where the search for a cell's root starts: within about 1e-5 of it, in single precision, for one lot or two.

use super::curve::{At, Real};
use super::setup::Law;
use crate::Kragelskii;
use crate::fast::lanes::fused;
use fearless_simd::prelude::*;

/// Square of a trial slip that single precision can work with, (m/s)².
const LEAST: f32 = 1e-30;

/// Numbers of a patch that the start needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    law: Law<f32>,
    rise: Rise,
}

/// A curve without transcendental functions, a per cent off: with x = σ/σ_m and z = Cλ (σ − σ_m)
/// ```text
/// κ = K_m (n x − m x²)/(1 + (n − m − 1) x),   x < 1,   κ = K_m (1 − d_∞ (1 − (1 + z) e^(−z))),   x > 1
/// ```
/// exact at either end and in the middle of the rising branch and in its initial slope; the second is the curve itself,
/// in which e^(−z) gives way to the reciprocal of five terms of its series.
#[derive(Debug, Clone, Copy)]
struct Rise {
    /// K_m, or where nothing falls the coefficient at infinite slip.
    most: f32,
    /// σ_m, m/s.
    knee: f32,
    /// n, σ_m times the initial slope over K_m.
    bow: f32,
    /// m.
    fall: f32,
    /// d_∞, the share that is lost at infinite slip.
    lost: f32,
    /// Cλ, s/m.
    rate: f32,
}

impl Rise {
    fn new(law: &Law<f32>, slope: f32) -> Self {
        /// Of a curve that has no peak: where an exponential has come within 5 %.
        const BOW: f32 = 3.0;
        let (knee, most, rate) = (law.knee, law.peak, law.curve.c * law.scale);
        // D of the curve, its coefficient at infinite slip.
        let residual = -law.curve.a;
        if knee.is_finite() {
            let bow = slope * knee / most;
            // (A + B s/2) exp(−C s/2) + D at the peak's s, whose exponential is in K_m.
            let Kragelskii { a, b, c } = law.curve;
            let decay = ((most - residual) * c / b).max(0.0).sqrt();
            let middle = ((a + 0.5 * b * knee * law.scale) * decay + residual) / most;
            let fall = (middle * (1.0 + bow) - bow) / (middle - 0.5);
            Self { most, knee, bow, fall, lost: 1.0 - residual / most, rate }
        } else {
            Self { most: residual, knee: BOW * residual / slope, bow: BOW, fall: 1.0, lost: 0.0, rate }
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
    pub(super) fn speed<S: Simd, V: Real<S, Element = f32>>(
        &self,
        trial: [V; 2],
        last: V,
        (yielding, keep): ([f32; 2], f32),
    ) -> V {
        let squares = [trial[0] * trial[0], trial[1] * trial[1]];
        let square = (squares[0] + squares[1]).max(LEAST);
        // The root and the division side by side, not one after the other.
        let (high, over2) = (square.sqrt(), V::splat(square.token(), 1.0) / square);
        let guess = self.guess((high, over2, squares), last, (yielding, keep));
        let of = At::new(&self.law, guess).coefficient(&self.law, last, keep);
        // In units of the trial slip, so that no power of it leaves the range.
        let (over, bend) = (high * over2, of.bend * high);
        let squares = [squares[0] * over2, squares[1] * over2];
        let d = [fused(of.value, yielding[0], guess) * over, fused(of.value, yielding[1], guess) * over];
        let grow = [fused(of.slope, yielding[0], 1.0), fused(of.slope, yielding[1], 1.0)];
        fused(step(squares, d, grow, [bend * yielding[0], bend * yielding[1]]), high, guess)
    }

    /// The root with [`Rise`] for the curve, and with one C for both directions: on the rising branch that of
    /// ```text
    /// x + c K_m (1 − r w) (n x − m x²)/(1 + (n − m − 1) x)/σ_m = |s_t|/σ_m
    /// ```
    /// else one step from the peak's κ of σ = |s_t| − c κ. c is that of a cell that sticks, |s_t|/√Σ (s_t,k/C_k)², to
    /// second order in the difference of both C: what slips far hardly feels it.
    #[inline(always)]
    fn guess<S: Simd, V: Real<S, Element = f32>>(
        &self,
        (high, over2, [u2, v2]): (V, V, [V; 2]),
        last: V,
        ([cx, cy], keep): ([f32; 2], f32),
    ) -> V {
        let Rise { most, knee, bow, fall, lost, rate } = self.rise;
        let pole = bow - fall - 1.0;
        let over_knee = knee.recip();
        let apart = 3.0 * (cx - cy) * (cx - cy) / (cx + cy);
        let c = fused(u2 * v2 * -apart, over2, fused(u2, cx, v2 * cy)) * over2;
        let peak = fused(last, -keep, 1.0) * most;
        let whole = high * over_knee;
        let pull = c * (peak * over_knee);
        let half = fused(pull, 0.5 * bow, fused(whole, -0.5 * pole, 0.5));
        let root = half + fused(fused(pull, -fall, pole), whole, half * half).max(0.0).sqrt();
        let rising = whole / root * knee;
        // Beyond the peak.
        let z = ((fused(-c, peak, high) - knee) * rate).max(0.0);
        let z2 = z * z;
        let series = fused(z2, fused(z2, 1.0 / 24.0, fused(z, 1.0 / 6.0, 0.5)), z + 1.0);
        let kappa = fused((z + 1.0) / series - 1.0, most * lost * (1.0 - keep), peak);
        let sliding = fused(-c, kappa, high).max(0.5 * knee);
        whole.simd_lt(root).select(rising, sliding).min(high)
    }
}

/// δσ of [`super::cell::Cell::near`] with the powers of D_x D_y multiplied out, so that it is divided once: here the
/// chain is what takes time, not the number of products. Takes s_t² and D with its derivatives.
#[inline(always)]
fn step<S: Simd, V: Real<S, Element = f32>>(square: [V; 2], [dx, dy]: [V; 2], [gx, gy]: [V; 2], bend: [V; 2]) -> V {
    let (dx2, dy2, product) = (dx * dx, dy * dy, dx * dy);
    let (nx, ny) = (square[0] * dy2, square[1] * dx2);
    let short = fused(product, product, -(nx + ny));
    let rise = fused(nx, dy * gx, ny * (dx * gy));
    let part = nx * dy2 * fused(bend[0], dx, gx * gx * -3.0);
    let turn = fused(ny * dx2, fused(bend[1], dy, gy * gy * -3.0), part);
    let rise2 = rise * rise;
    let slope = fused(short * turn, -0.25, rise2).max(rise2 * 0.25);
    short * rise * product * -0.5 / slope
}
