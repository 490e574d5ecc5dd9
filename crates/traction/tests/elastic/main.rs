//! Evidence for the elastic patch: exact rolling contact, linear theory, limits, symmetries, continuity, convergence.

#[path = "../patch_rules/contacts.rs"]
#[allow(dead_code, reason = "shared with the tests of the rigid patch, which use more of it")]
mod contacts;
mod convergence;
mod exact;
mod fast;
mod limits;

use tribodyn_traction::{Scalar, SlipCurve, TangentialElasticity, TractionLaw};

/// Coulomb friction, or friction that falls from `coefficient` to `residual` over the slip `falling_over`.
#[derive(Debug, Clone, Copy)]
pub struct Dry {
    /// Coefficient at no slip.
    pub coefficient: f64,
    /// Coefficient at infinite slip.
    pub residual: f64,
    /// Slip over which most of the fall happens.
    pub falling_over: f64,
}

impl Dry {
    /// The same coefficient at every slip.
    pub fn coulomb(coefficient: f64) -> Self {
        Self { coefficient, residual: coefficient, falling_over: 1.0 }
    }
}

impl<D: Scalar> SlipCurve<D> for Dry {
    fn over_slip(&self, slip: D) -> D {
        if slip.re() <= 1e-12 {
            return D::zero();
        }
        let fall = (-slip / self.falling_over).exp() * (self.coefficient - self.residual);
        (fall + self.residual) / slip
    }
}

impl TractionLaw for Dry {
    type Curve<D: Scalar> = Self;

    fn at<D: Scalar>(&self, _pressure: D) -> Self {
        *self
    }

    fn clamps(&self, _pressure: f64) -> bool {
        false
    }
}

/// The elastic constants behind the exact solutions: G 80 GPa, ν 0.3.
pub fn steel() -> TangentialElasticity {
    TangentialElasticity::new(80e9, 0.3).unwrap()
}
