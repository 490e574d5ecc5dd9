//! Curves of traction over sliding speed, at eight nodes at a time.

use super::elementary::exp_m1;
use super::lanes::{Lanes, fused};
use crate::Kragelskii;
use fearless_simd::prelude::*;

/// Least C λ, s/m: at rest 0/0 is avoided.
const SMALLEST_RATE: f64 = 1e-100;

/// The curve of one contact.
pub(crate) trait LaneCurve {
    /// True for a curve that can change with the entrainment speed.
    const ENTRAINED: bool;

    /// κ/s at sliding speeds in m/s.
    fn over_slip<S: Simd>(&self, speed: Lanes<S>) -> Lanes<S>;

    /// κ/s with its slopes at sliding speeds in m/s.
    fn slopes<S: Simd>(&self, speed: Lanes<S>) -> Slopes<S>;
}

/// κ/s with its slopes at eight nodes.
pub(crate) struct Slopes<S: Simd> {
    pub over_slip: Lanes<S>,
    /// s d(κ/s)/ds.
    pub bend: Lanes<S>,
    /// p d(κ/s)/dp.
    pub by_pressure: Lanes<S>,
    /// d(κ/s)/dV, s/m; none of a curve that does not ask for the entrainment speed.
    pub by_entrainment: Option<Lanes<S>>,
}

/// Kragelskii's curve over the sliding speed.
pub(super) struct Sliding {
    /// C λ.
    rate: f64,
    /// B.
    b: f64,
    /// A C.
    a_c: f64,
    /// p d/dp of κ/s as e^(−x) (first + second |Δv|) + third (e^(−x) − 1)/x.
    by_pressure: [f64; 3],
}

impl Sliding {
    /// Without slopes by the pressure.
    pub(super) fn new(curve: &Kragelskii, scale: f64) -> Self {
        Self { rate: (curve.c * scale).max(SMALLEST_RATE), b: curve.b, a_c: curve.a * curve.c, by_pressure: [0.0; 3] }
    }

    /// With dA/dp, dB/dp and dC/dp, per Pa, at a pressure in Pa.
    pub(super) fn sloped(curve: &Kragelskii, slope: &Kragelskii, scale: f64, p: f64) -> Self {
        let by_pressure = [p * (slope.b - slope.c * curve.a), -p * slope.c * curve.b * scale, p * slope.a * curve.c];
        Self { by_pressure, ..Self::new(curve, scale) }
    }
}

impl LaneCurve for Sliding {
    const ENTRAINED: bool = false;

    #[inline(always)]
    fn over_slip<S: Simd>(&self, speed: Lanes<S>) -> Lanes<S> {
        let argument = speed * -self.rate;
        let e = exp_m1(argument.max(-700.0));
        // e/(−C s) tends to one at rest.
        let ratio = Lanes::splat(speed.token(), -self.a_c) / argument;
        fused(e + 1.0, self.b, e * ratio)
    }

    #[inline(always)]
    fn slopes<S: Simd>(&self, speed: Lanes<S>) -> Slopes<S> {
        let argument = speed * self.rate;
        let e = exp_m1((-argument).max(-700.0));
        let (decay, ratio) = (e + 1.0, e / argument);
        let [first, second, third] = self.by_pressure;
        Slopes {
            over_slip: fused(decay, self.b, ratio * self.a_c),
            // Below rounding of κ/s where decay + ratio cancels at small slip.
            bend: fused(decay * argument, -self.b, (decay + ratio) * -self.a_c),
            by_pressure: fused(decay, fused(speed, second, first), ratio * third),
            by_entrainment: None,
        }
    }
}
