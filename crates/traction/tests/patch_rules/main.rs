//! Evidence for the patch integral: convergence on the contacts of a solved bearing, limits and identities.

mod contacts;
mod convergence;
mod derivatives;
mod fast;
mod kinematics;
mod limits;
mod slopes;

use tribodyn_traction::{PatchRule, Scalar, SlipCurve, TractionLaw};

/// Coulomb friction: the law of a crate that brings its own.
#[derive(Debug, Clone, Copy)]
pub struct Coulomb {
    /// The coefficient at every slip and pressure.
    pub coefficient: f64,
}

impl<D: Scalar> SlipCurve<D> for Coulomb {
    fn over_slip(&self, slip: D) -> D {
        // A point at rest carries no traction: its direction is unknown.
        if slip.re() > 1e-12 { slip.recip() * self.coefficient } else { D::zero() }
    }
}

impl TractionLaw for Coulomb {
    type Curve<D: Scalar> = Self;

    fn at<D: Scalar>(&self, _pressure: D) -> Self {
        *self
    }

    fn clamps(&self, _pressure: f64) -> bool {
        false
    }
}

/// One coarse rule of each kind, for what must hold at any number of points.
pub const COARSE: [PatchRule; 3] = [
    PatchRule::PolarMidpoint { radial: 5, circumferential: 20 },
    PatchRule::GaussJacobi { radial: 3, angles: 8 },
    PatchRule::SplitStrip { across: 5, along: 3 },
];
