//! Unknown bearing parameters from published or measured figures, with spreads.
//!
//! # Equations
//! ```text
//! minimise Σ ((model(x) − datum)/σ)² + Σ ((x − prior mean)/prior spread)²  within bounds
//! (JᵀJ + μ diag JᵀJ) Δ = −Jᵀ r                                              Levenberg–Marquardt
//! C = (JᵀJ)⁻¹,  spread = √C_kk,  correlation = C_ij/√(C_ii C_jj)             curvature at the minimum
//! share of residual j in parameter k = (C Jᵀ)_kj² / C_kk
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | x | free parameters, in coordinates 0…1 between their bounds | – |
//! | σ | standard uncertainty of a datum | that of the datum |
//! | J | sensitivities of the residuals to the coordinates | – |
//! | C | covariance of the coordinates | – |
//!
//! Sources: K. Levenberg 1944, doi:10.1090/qam/10666; D. W. Marquardt 1963, doi:10.1137/0111030; Latin hypercube
//! starts: McKay, Beckman, Conover 1979, doi:10.1080/00401706.1979.10489755.
//!
//! Limits: the spreads are those of the linearised problem and mean little at a bound; sensitivities are differences
//! of converged solutions, checked by halving the step. The crate reads no files and prints nothing.

mod fit;
mod model;
mod problem;
mod report;
mod search;
mod uncertainty;

pub use fit::{LeastSquares, Point, fit};
pub use model::{Evaluation, ForwardModel};
pub use problem::{Datum, Hypothesis, ModelName, Parameter, Prior, Problem, Quantity, Run, Scale};
pub use report::{DatumResult, Identification, MinimumResult, ParameterResult, identify};
pub use search::{Minimum, Search, search};
pub use uncertainty::{Uncertainty, uncertainty};

use tribodyn_bearing::BearingError;
use tribodyn_case::CaseError;
use tribodyn_quasistatic::QuasiStaticError;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IdentifyError {
    /// The problem file is not RON of the right shape.
    #[error("line {line}, column {column}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        message: String,
    },
    /// A value of the problem file that makes no sense.
    #[error("{field} = {value}: allowed is {allowed}")]
    Value {
        /// The field.
        field: String,
        /// Its value.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A path that leads nowhere in the case.
    #[error("the case has nothing at {path}")]
    Path {
        /// The path.
        path: String,
    },
    /// A free parameter that is no number.
    #[error("{path} = {value} is no number: end the path inside the unit, as in geometry.pitch_diameter.mm")]
    NotANumber {
        /// The path.
        path: String,
        /// What stands there.
        value: String,
    },
    /// Nothing to begin with.
    #[error("none of {count} starts has an equilibrium in every run: {reason}")]
    NoStart {
        /// Starts tried.
        count: usize,
        /// Why the first failed.
        reason: String,
    },
    /// The case.
    #[error("the case, {0}")]
    Case(#[from] CaseError),
    /// The bearing.
    #[error(transparent)]
    Bearing(#[from] BearingError),
    /// The solver.
    #[error(transparent)]
    Solver(#[from] QuasiStaticError),
}
