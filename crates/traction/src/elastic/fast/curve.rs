//! The curve at a sliding speed, in single or double precision.

use super::setup::Law;
use crate::Kragelskii;
use crate::fast::elementary::{exp_m1, exp_m1_single};
use crate::fast::lanes::{Fuse, Lanes, Pairs, Singles, fused};
use fearless_simd::prelude::*;

/// Vectors of one precision or the other.
pub(super) trait Real<S: Simd>: SimdFloat<S, Element: Fuse + From<f32>> {
    #[inline(always)]
    fn number(x: f32) -> Self::Element {
        x.into()
    }

    /// exp(x) − 1 for x ≤ 0.
    fn exp_m1(self) -> Self;
}

impl<S: Simd> Real<S> for Lanes<S> {
    #[inline(always)]
    fn exp_m1(self) -> Self {
        exp_m1(self.max(-700.0))
    }
}

impl<S: Simd> Real<S> for Singles<S> {
    #[inline(always)]
    fn exp_m1(self) -> Self {
        exp_m1_single(self)
    }
}

impl<S: Simd> Real<S> for Pairs<S> {
    #[inline(always)]
    fn exp_m1(self) -> Self {
        exp_m1_single(self)
    }
}

/// The curve at a sliding speed.
#[derive(Clone, Copy)]
pub(super) struct At<S: Simd, V: Real<S> = Lanes<S>> {
    /// exp(−C s) − 1 and exp(−C s).
    pub(super) e: V,
    pub(super) decay: V,
    /// κ and dκ/dσ, without memory.
    pub(super) plain: V,
    pub(super) slope: V,
    /// d²κ/dσ².
    pub(super) bend: V,
    /// σ, m/s.
    pub(super) speed: V,
    /// Lanes beyond the peak.
    pub(super) past: V::Mask,
}

impl<S: Simd, V: Real<S>> At<S, V> {
    #[inline(always)]
    pub(super) fn new(law: &Law<V::Element>, speed: V) -> Self {
        let Kragelskii { a, b, c } = law.curve;
        let rate = -c * law.scale;
        let rising = b * law.scale;
        let e = (speed * rate).exp_m1();
        let decay = e + V::number(1.0);
        // What does not wait for the exponential in brackets.
        let plain = fused(decay, speed * rising, e * a);
        let slope = decay * fused(speed, rate * rising, V::splat(e.token(), a * rate + rising));
        let bend = fused(decay, rising, slope) * rate;
        Self { e, decay, plain, slope, bend, speed, past: speed.simd_gt(law.knee) }
    }

    /// κ_r on the rising branch or at the peak, and the share d of it that is lost.
    #[inline(always)]
    pub(super) fn rising_and_lost(&self, law: &Law<V::Element>) -> [V; 2] {
        let (simd, zero) = (self.e.token(), V::number(0.0));
        let lost = fused(self.plain, -law.over_peak, V::number(1.0));
        [self.past.select(V::splat(simd, law.peak), self.plain), self.past.select(lost, V::splat(simd, zero))]
    }

    /// κ in a cell that keeps the share `keep` of the weakening `last`: as it stands on the rising branch, and with the
    /// new share of what is lost beyond the peak.
    #[inline(always)]
    pub(super) fn coefficient(&self, law: &Law<V::Element>, last: V, keep: V::Element) -> Coefficient<V> {
        let (simd, zero, one) = (self.e.token(), V::number(0.0), V::number(1.0));
        let left = fused(last, -keep, one);
        let new = V::splat(simd, one - keep);
        let part = self.past.select(new, left);
        let peak = self.past.select((left - new) * law.peak, V::splat(simd, zero));
        Coefficient { value: fused(self.plain, part, peak), slope: self.slope * part, bend: self.bend * part }
    }
}

impl<S: Simd> At<S> {
    /// At a speed so near that the exponential need not be taken again: within [`super::cell::SETTLED`].
    #[inline(always)]
    pub(super) fn moved_to(&self, law: &Law, speed: Lanes<S>) -> Self {
        let far = speed - self.speed;
        let x = far * (law.scale * law.curve.c);
        let less = self.decay * fused(x * x, -0.5, x);
        Self {
            e: self.e - less,
            decay: self.decay - less,
            plain: fused(fused(self.bend, far * 0.5, self.slope), far, self.plain),
            slope: fused(self.bend, far, self.slope),
            speed,
            ..*self
        }
    }
}

/// κ and its derivatives over σ.
#[derive(Clone, Copy)]
pub(super) struct Coefficient<V> {
    pub(super) value: V,
    pub(super) slope: V,
    pub(super) bend: V,
}
