//! Operating point, and the errors of a solution.

use crate::Model;
use crate::block::{RING, RingFreedom};
use tribodyn_bearing::case::{CageSpec, Case, Numerics, Tilt, Translation};
use tribodyn_bearing::traction::{PatchRule, TractionError};

/// A bearing at an operating point, with the solver's settings.
#[derive(Debug, Clone, PartialEq)]
pub struct OperatingPoint {
    /// Load or held position of x, y, z, tilt about X, tilt about Y of the inner ring.
    pub ring: [RingFreedom; RING],
    /// Speed of the inner ring, rad/s.
    pub inner_speed: f64,
    /// Speed of the outer ring, rad/s.
    pub outer_speed: f64,
    /// Quadrature over the contact patches.
    pub patch: PatchRule,
    /// The cage, for the pocket forces.
    pub cage: CageSpec,
    /// Solver settings.
    pub numerics: Numerics,
}

impl OperatingPoint {
    /// The case's operating point; where loads or speeds are tables in time, their last row, the steady state.
    pub fn new(case: &Case) -> Self {
        Self::at(case, f64::INFINITY)
    }

    /// The case's operating point with the loads and speeds of a time in s.
    pub fn at(case: &Case, time: f64) -> Self {
        let translation = |t: &Translation| match t {
            Translation::Held(x) => RingFreedom::Held(*x),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        let tilt = |t: &Tilt| match t {
            Tilt::Held(angle) => RingFreedom::Held(*angle),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        let r = &case.ring;
        Self {
            ring: [translation(&r.x), translation(&r.y), translation(&r.z), tilt(&r.tilt_x), tilt(&r.tilt_y)],
            inner_speed: case.speed.inner.at(time),
            outer_speed: case.speed.outer.at(time),
            patch: case.traction.patch,
            cage: case.cage.clone(),
            numerics: case.numerics.clone(),
        }
    }
}

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
    /// Patch quadrature.
    #[error(transparent)]
    Traction(#[from] TractionError),
}
