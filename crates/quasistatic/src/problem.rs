//! The errors of a solution.

use crate::Model;
use tribodyn_traction::TractionError;

/// Where a residual is left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A ball.
    Ball {
        /// Its index.
        index: usize,
        /// Its azimuth, degrees.
        azimuth_deg: f64,
    },
    /// The inner ring.
    Ring,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Ball { index, azimuth_deg } => write!(f, "ball {index} at {azimuth_deg:.1}°"),
            Self::Ring => f.write_str("the inner ring"),
        }
    }
}

/// Why there is no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuasiStaticError {
    /// The iteration stopped above the tolerance.
    #[error(
        "{model:?} model did not converge: {equation} of {place} has a relative residual of {residual:.3e} after {iterations} steps (tolerance {tolerance:.1e})"
    )]
    NotConverged {
        /// Which equations.
        model: Model,
        /// The worst balance.
        equation: &'static str,
        /// Where it is.
        place: Place,
        /// Its relative residual.
        residual: f64,
        /// Newton steps taken.
        iterations: usize,
        /// The tolerance asked for.
        tolerance: f64,
    },
    /// The bearing or the operating point lacks what the model uses.
    #[error("{model:?} model needs what is not given: {}", missing.join(", "))]
    Missing {
        /// Which equations.
        model: Model,
        /// All that is missing.
        missing: Vec<&'static str>,
    },
    /// Patch quadrature.
    #[error(transparent)]
    Traction(#[from] TractionError),
}
