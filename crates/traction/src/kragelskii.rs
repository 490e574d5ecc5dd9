//! The Kragelskii traction curve (the paper's Eq. 1) and its inverse from measured peak data.

use crate::{Scalar, TractionError};

/// A traction coefficient κ as a function of slip s ≥ 0.
pub trait SlipCurve<D: Scalar> {
    /// κ(s)/s, finite at s = 0 where it is the initial slope. The patch integral needs nothing else.
    fn over_slip(&self, slip: D) -> D;

    /// κ(s).
    fn coefficient(&self, slip: D) -> D {
        self.over_slip(slip) * slip
    }

    /// The slip at which the curve turns to falling, and its steepness there; None if it never falls.
    ///
    /// Unless a curve knows better, from a scan of κ(s) at 16 slips a decade from 1e-6 to 1e6, without derivatives.
    fn fall(&self) -> Option<Fall<D>> {
        scan_for_fall(|slip| self.coefficient(D::from(slip)).re())
    }
}

/// The falling branch of a traction curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall<D = f64> {
    /// Slip at the peak, from which the curve falls.
    pub slip: D,
    /// Largest −dκ/ds beyond it.
    pub steepness: D,
}

pub(crate) fn scan_for_fall<D: Scalar>(coefficient: impl Fn(f64) -> f64) -> Option<Fall<D>> {
    /// Less is rounding.
    const NOTICEABLE: f64 = 1e-9;
    let points = (-96..=96).map(|i| {
        let slip = 10f64.powf(f64::from(i) / 16.0);
        (slip, coefficient(slip))
    });
    let (mut peak, mut previous, mut steepness, mut last) = ((0.0, 0.0), (0.0, 0.0), 0.0f64, 0.0);
    for (slip, value) in points {
        if value > peak.1 * (1.0 + NOTICEABLE) {
            (peak, steepness) = ((slip, value), 0.0);
        } else {
            steepness = steepness.max((previous.1 - value) / (slip - previous.0));
        }
        (previous, last) = ((slip, value), value);
    }
    (last < peak.1 * (1.0 - NOTICEABLE)).then(|| Fall { slip: D::from(peak.0), steepness: D::from(steepness) })
}

/// κ(s) = (A + B s) exp(−C s) + D with κ(0) = 0, so D = −A.
///
/// Units: A, D dimensionless; B and C per unit of slip (see [`crate::SlipUnit`]).
/// Source: Kragelskii's curve as used by Gupta; Lubricants 2025, 13(8), 352, Eq. 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kragelskii<D = f64> {
    /// A, the negative of the coefficient at infinite slip.
    pub a: D,
    /// B.
    pub b: D,
    /// C.
    pub c: D,
}

/// The three measured numbers that fix a Kragelskii curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak<D = f64> {
    /// Slip at the largest traction, S_m.
    pub slip: D,
    /// Largest traction coefficient, K_m.
    pub coefficient: D,
    /// Traction coefficient at infinite slip, K.
    pub residual: D,
}

impl<D: Scalar> Kragelskii<D> {
    /// D, the coefficient at infinite slip.
    pub fn d(&self) -> D {
        -self.a
    }

    /// dκ/ds at s = 0, which is B − A C.
    pub fn initial_slope(&self) -> D {
        self.b - self.a * self.c
    }

    /// Peak slip S_m = 1/C − A/B, peak coefficient K_m and residual coefficient K.
    pub fn peak(&self) -> Peak<D> {
        let slip = self.c.recip() - self.a / self.b;
        let coefficient = self.b / self.c * (-self.c * slip).exp() + self.d();
        Peak { slip, coefficient, residual: self.d() }
    }

    /// The curve with the given peak: with x = C S_m > 1 the root of e^(−x)/(x−1) = (K_m − K)/K,
    /// C = x/S_m and B = K C/(x−1).
    ///
    /// # Errors
    /// [`TractionError::Peak`] unless K_m > K > 0 and S_m > 0.
    pub fn from_peak(peak: Peak<D>) -> Result<Self, TractionError> {
        let (slip, top, residual) = (peak.slip.re(), peak.coefficient.re(), peak.residual.re());
        if !(slip > 0.0 && residual > 0.0 && top > residual && top.is_finite() && slip.is_finite()) {
            return Err(TractionError::Peak { slip, coefficient: top, residual });
        }
        let ratio = (peak.coefficient - peak.residual) / peak.residual;
        let x0 = solve_peak_product(ratio.re());
        // One Newton step with ln f(x) = −x − ln(x − 1) carries the derivatives of the ratio into x.
        let x = D::from(x0);
        let x = x + (-x - (x - 1.0).ln() - ratio.ln()) / (D::one() + (x - 1.0).recip());
        let c = x / peak.slip;
        Ok(Self { a: -peak.residual, b: peak.residual * c / (x - 1.0), c })
    }
}

/// The root x > 1 of −x − ln(x − 1) = ln(ratio); the left side falls from +∞ to −∞, so it is unique.
fn solve_peak_product(ratio: f64) -> f64 {
    let target = ratio.ln();
    // In y = ln(x − 1) the function −1 − e^y − y is concave and falling: Newton converges from any start.
    let bound = -1.0 - target;
    let mut y = if bound > 1.0 { bound.ln() } else { bound };
    for _ in 0..60 {
        let e = y.exp();
        let step = (-1.0 - e - y - target) / (1.0 + e);
        y += step;
        if step.abs() <= 1e-16 * y.abs().max(1.0) {
            break;
        }
    }
    1.0 + y.exp()
}

impl<D: Scalar> SlipCurve<D> for Kragelskii<D> {
    fn over_slip(&self, slip: D) -> D {
        let cs = self.c * slip;
        if cs.re() < 1e-6 {
            // Two terms of the series; the third is below rounding here and 0/0 is avoided.
            return self.initial_slope() + self.c * (self.a * self.c * 0.5 - self.b) * slip;
        }
        // exp(−x) − 1 loses digits only where x is small.
        let e = if cs.re() < 0.5 { (-cs).exp_m1() } else { (-cs).exp() - 1.0 };
        self.b * (e + 1.0) + self.a * e / slip
    }

    /// The peak at S_m = 1/C − A/B, and the point of inflection 1/C beyond it, where dκ/ds = −B exp(−C S_m − 1).
    fn fall(&self) -> Option<Fall<D>> {
        if self.b.re() <= 0.0 || self.c.re() <= 0.0 {
            return None;
        }
        let slip = self.c.recip() - self.a / self.b;
        Some(Fall { slip, steepness: self.b * (-self.c * slip - 1.0).exp() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;
    use proptest::prelude::*;

    const AG: Kragelskii = Kragelskii { a: -0.124, b: 0.079, c: 0.698 };

    #[test]
    fn limit_zero_and_infinite_slip() {
        assert_eq!(AG.coefficient(0.0), 0.0);
        assert!((AG.over_slip(0.0) - AG.initial_slope()).abs() < 1e-16);
        assert!((AG.coefficient(1e3) - 0.124).abs() < 1e-15);
    }

    #[test]
    fn identity_curve_against_its_written_form() {
        for s in [1e-9, 1e-7, 1.4e-6, 1.5e-6, 1e-3, 0.3, 0.71, 0.72, 3.0, 20.0] {
            // Written with expm1 so that the reference itself keeps its digits at small slip.
            let e = (-AG.c * s).exp_m1();
            let reference = AG.b * s * (e + 1.0) + AG.a * e;
            assert!((AG.coefficient(s) - reference).abs() < 2e-12 * reference, "s = {s}");
        }
    }

    #[test]
    fn identity_derivative_of_ratio_at_zero_slip_is_finite() {
        let curve = Kragelskii::<Dual64> { a: (-0.124).into(), b: 0.079.into(), c: 0.698.into() };
        let at = |s: f64| curve.over_slip(Dual64::from(s).derivative()).eps;
        assert!((at(0.0) - at(2e-6)).abs() < 1e-6);
        let h = 1e-4;
        let difference = (AG.over_slip(1.0 + h) - AG.over_slip(1.0 - h)) / (2.0 * h);
        assert!((at(1.0) - difference).abs() < 1e-9);
    }

    proptest! {
        #[test]
        fn identity_peak_and_back(slip in 0.01..50.0f64, residual in 0.01..1.0f64, excess in 1e-4..3.0f64) {
            let peak = Peak { slip, coefficient: residual * (1.0 + excess), residual };
            let back = Kragelskii::from_peak(peak).unwrap().peak();
            prop_assert!((back.slip - slip).abs() < 1e-12 * slip);
            prop_assert!((back.coefficient - peak.coefficient).abs() < 1e-13 * peak.coefficient);
        }
    }

    #[test]
    fn identity_inverse_has_exact_derivatives() {
        let parameter = |t: f64| Peak { slip: 3.0 + t, coefficient: 0.138 - 0.1 * t, residual: 0.124 - 0.05 * t };
        let t = Dual64::from(0.1).derivative();
        let dual =
            Kragelskii::from_peak(Peak { slip: t + 3.0, coefficient: -t * 0.1 + 0.138, residual: -t * 0.05 + 0.124 })
                .unwrap();
        let h = 1e-5;
        let up = Kragelskii::from_peak(parameter(0.1 + h)).unwrap();
        let down = Kragelskii::from_peak(parameter(0.1 - h)).unwrap();
        assert!((dual.b.eps - (up.b - down.b) / (2.0 * h)).abs() < 1e-8);
        assert!((dual.c.eps - (up.c - down.c) / (2.0 * h)).abs() < 1e-8);
    }

    #[test]
    fn identity_fall_against_a_scan() {
        let exact = AG.fall().unwrap();
        let scanned: Fall = scan_for_fall(|slip| AG.coefficient(slip)).unwrap();
        // Sixteen slips a decade lie 15 % apart.
        assert!((scanned.slip / exact.slip - 1.0).abs() < 0.08, "{scanned:?} {exact:?}");
        assert!((scanned.steepness / exact.steepness - 1.0).abs() < 0.02, "{scanned:?} {exact:?}");
        assert!((exact.slip - AG.peak().slip).abs() < 1e-15);
        assert_eq!(scan_for_fall::<f64>(|_| 0.1), None);
        assert_eq!(scan_for_fall::<f64>(|slip| slip / (1.0 + slip)), None);
    }

    #[test]
    fn limit_peak_below_residual_is_refused() {
        let peak = Peak { slip: 3.0, coefficient: 0.1, residual: 0.12 };
        assert!(matches!(Kragelskii::from_peak(peak), Err(TractionError::Peak { .. })));
    }
}
