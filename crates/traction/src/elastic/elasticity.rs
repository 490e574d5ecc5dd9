//! Tangential flexibility of two bodies under an elliptical contact.

use super::kalker::{CreepCoefficients, KalkerCoefficients};
use crate::{Patch, RelativeMotion, Scalar, TractionError};
use std::f64::consts::PI;
use tribodyn_contact::ElasticBody;

/// Creepage below which the lateral flexibility is the one of lateral creep, whatever the ratio of spin to creep:
/// without it the flexibility would have no limit at rest. Far below any creepage that carries a force of interest, so
/// that Kalker's slope over spin comes out at spin ratios φ c from about 1e-7 up.
const SMALLEST_CREEP: f64 = 1e-8;
/// Keeps 0/0 away where nothing moves, (m/s)².
const SMALLEST_SQUARE: f64 = 1e-60;

/// Elastic constants of the two bodies in shear, as one pair of equal bodies.
///
/// 1/G is the mean of both bodies' 1/G, ν/G the mean of their ν/G (Kalker 1990). For unlike bodies that
/// leaves out the coupling of normal and tangential problem.
#[derive(Debug, Clone, PartialEq)]
pub struct TangentialElasticity {
    shear_modulus: f64,
    poisson_ratio: f64,
    coefficients: KalkerCoefficients,
}

/// Surface displacement of the ball against the race per shear traction on the ball, m/Pa.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flexibility<D = f64> {
    /// Along rolling.
    pub longitudinal: D,
    /// Across the groove.
    pub lateral: D,
}

impl TangentialElasticity {
    /// Two bodies of shear modulus G in Pa and Poisson's ratio.
    ///
    /// # Errors
    /// [`TractionError::ShearModulus`] unless it is finite and above 0, [`TractionError::PoissonRatio`] outside 0 to
    /// 0.5.
    pub fn new(shear_modulus: f64, poisson_ratio: f64) -> Result<Self, TractionError> {
        if !(shear_modulus > 0.0 && shear_modulus.is_finite()) {
            return Err(TractionError::ShearModulus { value: shear_modulus });
        }
        Ok(Self { shear_modulus, poisson_ratio, coefficients: KalkerCoefficients::new(poisson_ratio)? })
    }

    /// Two bodies of their own elastic constants.
    ///
    /// # Errors
    /// As [`TangentialElasticity::new`], of the mean constants.
    pub fn of_bodies(bodies: [ElasticBody; 2]) -> Result<Self, TractionError> {
        let compliances = bodies.map(|body| 2.0 * (1.0 + body.poisson) / body.young);
        let [first, second] = compliances;
        let shear_modulus = 2.0 / (first + second);
        let poisson_ratio = 0.5 * shear_modulus * (bodies[0].poisson * first + bodies[1].poisson * second);
        Self::new(shear_modulus, poisson_ratio)
    }

    /// Shear modulus, Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.shear_modulus
    }

    /// Poisson's ratio.
    pub fn poisson_ratio(&self) -> f64 {
        self.poisson_ratio
    }

    /// The table of creep coefficients at this Poisson's ratio.
    pub fn coefficients(&self) -> &KalkerCoefficients {
        &self.coefficients
    }

    /// The flexibilities with which the strips reproduce Kalker's slopes: with b the semi-axis along rolling and
    /// c = sqrt(ab), L_1 = 8b/(3 C11 G) along rolling and, across it, L_2 = 8b/(3 C22 G) for lateral creep and
    /// L_3 = πb²/(4 c C23 G) for spin, weighted by ξ_y² and (φc)².
    pub fn flexibility<D: Scalar>(
        &self,
        patch: &Patch<D>,
        motion: &RelativeMotion<D>,
        rolling_speed: D,
    ) -> Flexibility<D> {
        let coefficients = self.coefficients.at(patch.semi_rolling / patch.semi_lateral);
        self.flexibility_by(&coefficients, patch, motion, rolling_speed)
    }

    /// [`Self::flexibility`] by the coefficients of the patch's axis ratio.
    pub(super) fn flexibility_by<D: Scalar>(
        &self,
        c: &CreepCoefficients<D>,
        patch: &Patch<D>,
        motion: &RelativeMotion<D>,
        rolling_speed: D,
    ) -> Flexibility<D> {
        let (a, b) = (patch.semi_lateral, patch.semi_rolling);
        let flexibility = b * (8.0 / 3.0 / self.shear_modulus);
        let (creep, size) = (flexibility / c.lateral, a * b);
        let turn = b * b * (0.25 * PI / self.shear_modulus) / (size.sqrt() * c.spin);
        let [_, across] = motion.centre_slip(patch.ball_radius);
        let floor = rolling_speed * SMALLEST_CREEP;
        let by_creep = across * across + floor * floor + SMALLEST_SQUARE;
        let by_spin = motion.spin * motion.spin * size;
        Flexibility {
            longitudinal: flexibility / c.longitudinal,
            lateral: (by_creep * creep + by_spin * turn) / (by_creep + by_spin),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_equal_and_rigid_bodies() {
        let steel = ElasticBody { young: 208e9, poisson: 0.3 };
        let pair = TangentialElasticity::of_bodies([steel, steel]).unwrap();
        assert!((pair.shear_modulus() / 80e9 - 1.0).abs() < 1e-15 && (pair.poisson_ratio() - 0.3).abs() < 1e-15);
        let stiff = ElasticBody { young: 208e15, poisson: 0.1 };
        let half = TangentialElasticity::of_bodies([steel, stiff]).unwrap();
        assert!((half.shear_modulus() / 160e9 - 1.0).abs() < 1e-5 && (half.poisson_ratio() - 0.3).abs() < 1e-5);
    }

    #[test]
    fn limit_impossible_moduli_are_refused() {
        for value in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            assert!(matches!(TangentialElasticity::new(value, 0.3), Err(TractionError::ShearModulus { .. })));
        }
    }
}
