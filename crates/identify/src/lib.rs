#![doc = include_str!("../README.md")]

mod fit;
mod model;
mod problem;
mod quantity;
mod report;
mod search;
mod settled;
mod uncertainty;

pub use fit::{LeastSquares, Point, fit};
pub use model::{Adapt, Evaluation, ForwardModel};
pub use problem::{Datum, Hypothesis, ModelName, Parameter, Prior, Problem, Relation, Run, Scale};
pub use quantity::{Quantity, Zone};
pub use report::{DatumResult, Identification, MinimumResult, ParameterResult, identify, identify_one};
pub use search::{Minimum, Search, search};
pub use settled::Settled;
pub use uncertainty::{Uncertainty, uncertainty};

use tribodyn_bearing::BearingError;
use tribodyn_case::{CaseError, InputError, Lacking};
use tribodyn_dynamics::DynamicsError;
use tribodyn_quasistatic::QuasiStaticError;

/// Errors of an identification.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IdentifyError {
    /// The problem file is not RON of the right shape.
    #[error("line {line}, column {column}: {message}")]
    Syntax {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// The fault.
        message: String,
    },
    /// A value of the problem file that makes no sense.
    #[error("{field} = {value}: allowed is {allowed}")]
    Value {
        /// The field.
        field: String,
        /// Its value.
        value: String,
        /// The allowed values.
        allowed: &'static str,
    },
    /// A path that leads nowhere in the case.
    #[error("the case has nothing at {path}")]
    Path {
        /// The path.
        path: String,
    },
    /// A free parameter that is no number.
    #[error("{path} = {value} is not a number: end the path inside the unit, as in geometry.pitch_diameter.mm")]
    NotANumber {
        /// The path.
        path: String,
        /// The text in that place.
        value: String,
    },
    /// Nothing to begin with.
    #[error("none of {count} starts has an equilibrium in every run: {reason}")]
    NoStart {
        /// Starts tried.
        count: usize,
        /// Error of the first.
        reason: String,
    },
    /// The case.
    #[error("the case, {0}")]
    Case(#[from] CaseError),
    /// A case without what a model needs.
    #[error(transparent)]
    Lacking(#[from] Lacking),
    /// The bearing.
    #[error(transparent)]
    Bearing(#[from] BearingError),
    /// The solver.
    #[error(transparent)]
    Solver(#[from] QuasiStaticError),
    /// A case that gives no inputs for a run.
    #[error(transparent)]
    Inputs(#[from] InputError),
    /// A transient run.
    #[error(transparent)]
    Run(#[from] DynamicsError),
    /// A run whose numbers may be wrong without another sign.
    #[error("a run's step of {step_s:.2e} s is beyond the stability of its scheme, {limit_s:.2e} s: shorten the step")]
    Unstable {
        /// The step, s.
        step_s: f64,
        /// The longest stable step, s.
        limit_s: f64,
    },
}
