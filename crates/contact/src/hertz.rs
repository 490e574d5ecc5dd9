//! Hertz's elliptical point contact.

use crate::scalar::Sloped;
use crate::{CompleteElliptic, ContactError, Scalar};
use std::f64::consts::PI;

/// Largest ellipticity that [`HertzContact::new`] takes: beyond it the contact is a line for every practical purpose.
pub const MAX_ELLIPTICITY: f64 = 1e4;

/// Approaches (m), loads (N) and pressures (Pa) up to this count as no contact, with zero results and derivatives.
///
/// Dual numbers divide by their argument in roots: below 1e-123 the third derivative overflows and turns into NaN.
pub const NEGLIGIBLE: f64 = 1e-100;

/// Direction of the longer axis of a contact ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MajorAxis {
    /// Across the rolling direction, y: curvature is smaller there (or equal). Ball in groove.
    Lateral,
    /// Along the rolling direction, x.
    Rolling,
}

/// Contact ellipse and peak pressure under one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ellipse<D = f64> {
    /// Longer semi-axis a, m.
    pub semi_major: D,
    /// Shorter semi-axis b, m.
    pub semi_minor: D,
    /// Peak pressure, Pa.
    pub peak_pressure: D,
    /// Direction of the longer axis.
    pub major_axis: MajorAxis,
}

impl<D: Scalar> Ellipse<D> {
    /// That of bodies which do not touch.
    #[inline(always)]
    fn none(major_axis: MajorAxis) -> Self {
        let zero = D::zero();
        Self { semi_major: zero, semi_minor: zero, peak_pressure: zero, major_axis }
    }

    /// Semi-axis across the rolling direction (y), m.
    #[inline(always)]
    pub fn semi_lateral(&self) -> D {
        match self.major_axis {
            MajorAxis::Lateral => self.semi_major,
            MajorAxis::Rolling => self.semi_minor,
        }
    }

    /// Semi-axis along the rolling direction (x), m.
    #[inline(always)]
    pub fn semi_rolling(&self) -> D {
        match self.major_axis {
            MajorAxis::Lateral => self.semi_minor,
            MajorAxis::Rolling => self.semi_major,
        }
    }

    /// Area of the ellipse π a b, m².
    pub fn area(&self) -> D {
        self.semi_major * self.semi_minor * PI
    }
}

/// A Hertz contact: what follows from curvatures and elasticity, whatever the load.
///
/// The fields are for reading. Constants derived from them are stored beside them, so make a new contact rather than
/// change a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzContact<D = f64> {
    /// Ellipticity k = a/b ≥ 1.
    pub ellipticity: D,
    /// Complete elliptic integral of the first kind K at m = 1 − 1/k².
    pub first_integral: D,
    /// Complete elliptic integral of the second kind E at m = 1 − 1/k².
    pub second_integral: D,
    /// Sum of all curvatures Σρ = 1/R, 1/m.
    pub curvature_sum: D,
    /// Effective modulus E', Pa.
    pub effective_modulus: f64,
    /// Direction of the longer axis.
    pub major_axis: MajorAxis,
    /// K_n, N/m^1.5.
    stiffness: D,
    /// a³/Q, m³/N.
    major_cubed: D,
    /// a²/δ, m.
    major_squared: D,
}

impl<D: Scalar> HertzContact<D> {
    /// The contact with the given sums of the two bodies' curvatures in the x (rolling) and y (lateral) planes, 1/m,
    /// and effective modulus E', Pa.
    ///
    /// # Errors
    /// [`ContactError::Curvature`] unless both sums are finite and above 0, [`ContactError::Modulus`] likewise,
    /// [`ContactError::Ellipticity`] for an ellipse longer than [`MAX_ELLIPTICITY`].
    pub fn new(curvature_x: D, curvature_y: D, effective_modulus: f64) -> Result<Self, ContactError> {
        for (plane, value) in [("x", curvature_x.re()), ("y", curvature_y.re())] {
            if !positive(value) {
                return Err(ContactError::Curvature { plane, value });
            }
        }
        if !positive(effective_modulus) {
            return Err(ContactError::Modulus { value: effective_modulus });
        }
        let (ratio, major_axis) = if curvature_x.re() >= curvature_y.re() {
            (curvature_x / curvature_y, MajorAxis::Lateral)
        } else {
            (curvature_y / curvature_x, MajorAxis::Rolling)
        };
        let k = solve_ellipticity(ratio).ok_or(ContactError::Ellipticity {
            curvature_x: curvature_x.re(),
            curvature_y: curvature_y.re(),
            limit: MAX_ELLIPTICITY,
        })?;
        let integrals = CompleteElliptic::by_mean(k.recip());
        let (first, second) = (integrals.first, integrals.second);
        let curvature_sum = curvature_x + curvature_y;
        // K_n = π k E' sqrt(2 E R/(9 K³)): the approach δ(Q) solved for Q.
        let root = (second / (curvature_sum * first * first * first * 4.5)).sqrt();
        Ok(Self {
            ellipticity: k,
            first_integral: first,
            second_integral: second,
            curvature_sum,
            effective_modulus,
            major_axis,
            stiffness: k * root * (PI * effective_modulus),
            major_cubed: k * k * second / curvature_sum * (6.0 / (PI * effective_modulus)),
            major_squared: k * k * second / (curvature_sum * first) * 2.0,
        })
    }

    /// Contact stiffness K_n in Q = K_n δ^1.5, N/m^1.5.
    pub fn stiffness(&self) -> D {
        self.stiffness
    }

    /// Normal load at an elastic approach δ (m), N; 0 with zero derivative where the bodies are apart.
    #[inline(always)]
    pub fn load(&self, approach: D) -> D {
        if approach.re() <= NEGLIGIBLE {
            return D::zero();
        }
        self.stiffness * approach * approach.sqrt()
    }

    /// Elastic approach under a normal load (N), m; 0 with zero derivative for no load, although the derivative of
    /// Q^(2/3) grows without bound towards it.
    pub fn approach(&self, load: D) -> D {
        if load.re() <= NEGLIGIBLE {
            return D::zero();
        }
        let root = (load / self.stiffness).cbrt();
        root * root
    }

    /// dQ/dδ = 1.5 K_n δ^0.5 at an elastic approach (m), N/m; 0 where the bodies are apart.
    #[inline(always)]
    pub fn tangent_stiffness(&self, approach: D) -> D {
        if approach.re() <= NEGLIGIBLE {
            return D::zero();
        }
        self.stiffness * approach.sqrt() * 1.5
    }

    /// Contact ellipse and peak pressure under a normal load (N); all zero with zero derivatives for no load.
    #[inline]
    pub fn ellipse(&self, load: D) -> Ellipse<D> {
        if load.re() <= NEGLIGIBLE {
            return Ellipse::none(self.major_axis);
        }
        self.ellipse_of((self.major_cubed * load).cbrt(), load)
    }

    /// Contact ellipse and peak pressure at an elastic approach (m): that under the load of the approach, for a square
    /// root instead of a cube root.
    #[inline(always)]
    pub fn ellipse_at(&self, approach: D) -> Ellipse<D> {
        let load = self.load(approach);
        if load.re() <= NEGLIGIBLE {
            return Ellipse::none(self.major_axis);
        }
        self.ellipse_of((self.major_squared * approach).sqrt(), load)
    }

    #[inline(always)]
    fn ellipse_of(&self, semi_major: D, load: D) -> Ellipse<D> {
        let semi_minor = semi_major / self.ellipticity;
        let peak_pressure = load / (semi_major * semi_minor) * (1.5 / PI);
        Ellipse { semi_major, semi_minor, peak_pressure, major_axis: self.major_axis }
    }

    /// Normal load that gives a peak pressure (Pa), N: Q = (a³/Q)² (2π p_max/(3k))³.
    pub fn load_from_peak_pressure(&self, peak_pressure: D) -> D {
        if peak_pressure.re() <= NEGLIGIBLE {
            return D::zero();
        }
        let scaled = peak_pressure / self.ellipticity * (2.0 * PI / 3.0);
        let product = self.major_cubed * scaled;
        product * product * scaled
    }
}

impl HertzContact {
    /// The same contact as dual numbers without derivatives.
    #[inline(always)]
    pub fn lift<D: Scalar>(&self) -> HertzContact<D> {
        HertzContact {
            ellipticity: self.ellipticity.into(),
            first_integral: self.first_integral.into(),
            second_integral: self.second_integral.into(),
            curvature_sum: self.curvature_sum.into(),
            effective_modulus: self.effective_modulus,
            major_axis: self.major_axis,
            stiffness: self.stiffness.into(),
            major_cubed: self.major_cubed.into(),
            major_squared: self.major_squared.into(),
        }
    }
}

fn positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}

/// Ellipticity for a ratio λ ≥ 1 of the curvature sums, from λ = k² B/D; none above [`MAX_ELLIPTICITY`].
fn solve_ellipticity<D: Scalar>(ratio: D) -> Option<D> {
    // B ≤ D, so k is at least the square root of λ: a test that needs no solution.
    if ratio.re().sqrt() > MAX_ELLIPTICITY {
        return None;
    }
    let (value, _) = real_ellipticity(ratio.re());
    if value > MAX_ELLIPTICITY {
        return None;
    }
    let mut k = D::from(value);
    if D::NDERIV > 0 {
        let (_, slope) = ratio_and_slope(value);
        // A Newton step with the real slope makes one more order of derivatives exact; the real part is exact already.
        for _ in 0..D::NDERIV {
            let integrals = CompleteElliptic::by_mean(k.recip());
            let found = k * k * integrals.b / integrals.d;
            let correction = (found - ratio) / slope;
            k -= correction - correction.re();
        }
    }
    Some(k)
}

/// Ellipticity for a real λ by Newton's method in ln k, and the number of steps taken.
///
/// d ln λ/d ln k rises slowly from 3/2 at k = 1 towards 2, so that the iteration cannot fail. Its start value has the
/// exponent of Hamrock and Brewe 1983, k ≈ 1.03 λ^0.636.
fn real_ellipticity(ratio: f64) -> (f64, usize) {
    let mut k = ratio.powf(0.636);
    let mut steps = 0;
    loop {
        steps += 1;
        let (found, slope) = ratio_and_slope(k);
        let step = ((found - ratio) / ratio).ln_1p() / (slope * k / found);
        k = (k * (-step).exp()).max(1.0);
        // Quadratic convergence: the error left after a step of 1e-9 is below 1e-18.
        if step.abs() < 1e-9 {
            return (k, steps);
        }
    }
}

/// λ = k² B/D and dλ/dk.
fn ratio_and_slope(ellipticity: f64) -> (f64, f64) {
    let k = Sloped { value: ellipticity, slope: 1.0 };
    let integrals = CompleteElliptic::by_mean(Sloped::from(1.0) / k);
    let ratio = k * k * integrals.b / integrals.d;
    (ratio.value, ratio.slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_the_ellipse_at_an_approach_is_that_under_its_load() {
        for curvatures in [[60.0, 60.0], [66.0, 3.0], [3.0, 66.0]] {
            let contact = HertzContact::<f64>::new(curvatures[0], curvatures[1], 2.2e11).unwrap();
            for approach in [0.0, -1e-5, 1e-9, 1e-6, 5e-5] {
                let (at, under) = (contact.ellipse_at(approach), contact.ellipse(contact.load(approach)));
                for (a, b) in [(at.semi_major, under.semi_major), (at.peak_pressure, under.peak_pressure)] {
                    assert!((a - b).abs() <= 1e-14 * b, "{curvatures:?} {approach}: {a} {b}");
                }
            }
        }
    }

    #[test]
    fn regress_newton_steps_to_the_ellipticity() {
        let ratios = [1.0, 1.0 + 1e-12, 1.001, 1.2, 3.0, 20.0, 579.0, 1e4, 1e7];
        assert_eq!(ratios.map(|ratio| real_ellipticity(ratio).1), [1, 1, 2, 3, 3, 3, 3, 4, 4]);
    }

    /// The slope is that of dual numbers, to the last bit.
    #[cfg(feature = "dual")]
    #[test]
    fn identity_the_slope_of_the_ratio_equals_dual_numbers() {
        for ellipticity in [1.0, 1.0 + 1e-9, 1.3, 7.0, 50.0, 9e3] {
            let k = num_dual::Dual64::new(ellipticity, 1.0);
            let integrals = CompleteElliptic::by_mean(num_dual::Dual64::from(1.0) / k);
            let exact = k * k * integrals.b / integrals.d;
            assert_eq!(ratio_and_slope(ellipticity), (exact.re, exact.eps), "{ellipticity}");
        }
    }

    #[test]
    fn identity_newton_needs_few_steps_everywhere() {
        let most = (0..=4000).map(|i| real_ellipticity(10f64.powf(7.0 * i as f64 / 4000.0)).1).max();
        assert!(most <= Some(4), "{most:?}");
    }
}
