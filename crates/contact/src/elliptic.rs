//! Complete elliptic integrals by the arithmetic-geometric mean, as functions of the axis ratio.

use crate::{ContactError, Real, Scalar};
use std::f64::consts::FRAC_PI_2;

/// Relative size of c_n at which two more steps of the mean reach the last bit, in value and in derivatives.
///
/// After one more step the remainder is c_n⁴/64: nothing in value and in two derivatives, but 24 c_n/64 times c_n′³ in
/// the third one. After two steps it is of eighth order. A remainder measured by its value alone would stop at k' = 1
/// at once, where every c_n is zero and its derivatives are not.
const MEAN_TOLERANCE: f64 = 1e-8;

/// The complete elliptic integrals that belong to one axis ratio k' = b/a, parameter m = 1 − k'².
///
/// ```text
/// K = ∫ dθ/sqrt(1 − m sin²θ)          E = ∫ sqrt(1 − m sin²θ) dθ            over 0 to π/2
/// B = ∫ cos²θ dθ/sqrt(1 − m sin²θ)    D = ∫ sin²θ dθ/sqrt(1 − m sin²θ)
/// ```
/// with K = B + D and E = B + k'² D. Source: NIST Digital Library of Mathematical Functions, 19.2 and 19.8.
///
/// The argument is k', not m, because forming m = 1 − 1/k² rounds away digits of 1/k² that K needs. Measured against
/// 40-digit arithmetic: called with that m, `ellip` 1.2.3 errs in K by 1.06e-14 at k = 50 (1.04e-14 of it the rounding
/// of m) and by up to 1.26e-14 over k from 20 to 50; this function errs by 1.7e-16 and 3.9e-16.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CompleteElliptic<D = f64> {
    /// First kind, K.
    pub first: D,
    /// Second kind, E.
    pub second: D,
    /// B = (E − k'² K)/m, π/4 at k' = 1.
    pub b: D,
    /// D = (K − E)/m, π/4 at k' = 1.
    pub d: D,
}

impl<D: Scalar> CompleteElliptic<D> {
    /// The integrals at axis ratio k' = b/a, 0 < k' ≤ 1. Measured relative errors: below 5e-16 for k' ≥ 0.02, 1.6e-15
    /// for k' ≥ 1e-4. With dual numbers dK/dk' is as good; E and B change little at small k' while the terms they are
    /// made of change as 1/k', so that their derivatives have an absolute error of about 2e-16/k'.
    ///
    /// # Errors
    /// [`ContactError::AxisRatio`] outside that range.
    pub fn new(axis_ratio: D) -> Result<Self, ContactError> {
        let value = axis_ratio.re();
        if value > 0.0 && value <= 1.0 { Ok(Self::by_mean(axis_ratio)) } else { Err(ContactError::AxisRatio { value }) }
    }
}

impl<D: Real> CompleteElliptic<D> {
    /// Arithmetic-geometric mean from (1, k'). With 1 − E/K = Σ 2^(n−1) c_n² and q_n = c_n²/m, D/K = Σ 2^(n−1) q_n
    /// needs no division by m: q_0 = 1, q_1 = (1 − k')/(4 (1 + k')), c_{n+1} = c_n²/(4 a_{n+1}).
    pub(crate) fn by_mean(axis_ratio: D) -> Self {
        let one = D::one();
        let mut a = (one + axis_ratio) * 0.5;
        let mut g = axis_ratio.sqrt();
        let mut c = (one - axis_ratio) * 0.5;
        let mut q = (one - axis_ratio) / ((one + axis_ratio) * 4.0);
        let mut weight = 1.0;
        let mut tail = q;
        let mut steps_left = 2;
        while steps_left > 0 {
            if c.re() <= MEAN_TOLERANCE * a.re() {
                steps_left -= 1;
            }
            (a, g) = ((a + g) * 0.5, (a * g).sqrt());
            let ratio = c / (a * 4.0);
            c *= ratio;
            q *= ratio * ratio;
            weight *= 2.0;
            tail += q * weight;
        }
        let first = a.recip() * FRAC_PI_2;
        let d = first * (tail + 0.5);
        let b = first * (-tail + 0.5);
        Self { first, second: b + axis_ratio * axis_ratio * d, b, d }
    }
}

/// Ratio of the greater to the smaller curvature sum that belongs to ellipticity k ≥ 1: λ = k² B/D, from 1 upwards.
///
/// The same as F(ρ) = [(k²+1) E − 2 K]/[(k²−1) E] by λ = (1 + F)/(1 − F), without cancellation at either end.
///
/// # Errors
/// [`ContactError::AxisRatio`] where 1/k is not above 0 and at most 1.
pub fn curvature_ratio<D: Scalar>(ellipticity: D) -> Result<D, ContactError> {
    let integrals = CompleteElliptic::new(ellipticity.recip())?;
    Ok(ellipticity * ellipticity * integrals.b / integrals.d)
}

/// Hertz's curvature difference F(ρ) = |ρx − ρy|/(ρx + ρy) that belongs to axis ratio k' = 1/k: F = (B − k'² D)/E, from
/// 0 at k' = 1 to 1.
///
/// The relative error grows as 1/F near k' = 1, the absolute one does not.
///
/// # Errors
/// [`ContactError::AxisRatio`] where k' is not above 0 and at most 1.
pub fn curvature_difference<D: Scalar>(axis_ratio: D) -> Result<D, ContactError> {
    let integrals = CompleteElliptic::new(axis_ratio)?;
    Ok((integrals.b - axis_ratio * axis_ratio * integrals.d) / integrals.second)
}
