//! Why a run cannot start or go on.

use tribodyn_quasistatic::QuasiStaticError;
use tribodyn_signal::SignalError;
use tribodyn_traction::TractionError;
use tribodyn_wear::WearError;

/// Why a run cannot start or go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DynamicsError {
    /// Nothing holds a ring that is free to move.
    #[error("`{path}` is 0: nothing would hold the outer ring, which carries the load")]
    Unsupported {
        /// Path of the value.
        path: &'static str,
    },
    /// The start from the quasi-static solution.
    #[error("no quasi-static solution to start from: {0}")]
    Start(#[from] QuasiStaticError),
    /// Patch quadrature.
    #[error(transparent)]
    Traction(#[from] TractionError),
    /// Raceways and their wear.
    #[error(transparent)]
    Wear(#[from] WearError),
    /// A checkpoint of another state rate or step.
    #[error(
        "the filter in the checkpoint is not that of the run, {internal_rate_hz} values a second: state rate or step differ"
    )]
    CheckpointFilter {
        /// Internal rate of the run, Hz.
        internal_rate_hz: f64,
    },
    /// The filter of the samples.
    #[error(transparent)]
    Filter(#[from] SignalError),
    /// A value that is not finite.
    #[error(
        "{what} became infinite or not a number after {time_s} s: the step of {step_s:.2e} s is too long; fixed steps are stable up to about {limit_s:.2e} s here"
    )]
    NotFinite {
        /// Which unknown.
        what: String,
        /// Simulated time, s.
        time_s: f64,
        /// Step, s.
        step_s: f64,
        /// Longest stable step by the bound on the stiffness at the start, s.
        limit_s: f64,
    },
    /// A ball has left its races.
    #[error(
        "ball {ball} was thrown out after {time_s} s: it stands {distance_mm:.3} mm off its place; the step of {step_s:.2e} s may be too long (stable up to about {limit_s:.2e} s here) or the loads too low to hold it"
    )]
    BallLost {
        /// The ball.
        ball: usize,
        /// Simulated time, s.
        time_s: f64,
        /// How far it is from where an unloaded ball stands, mm.
        distance_mm: f64,
        /// Step, s.
        step_s: f64,
        /// Longest stable step by the bound on the stiffness at the start, s.
        limit_s: f64,
    },
    /// The adaptive scheme cannot hold its tolerance.
    #[error("the step fell below {step_s:.1e} s after {time_s} s without meeting the tolerance {tolerance:.1e}")]
    StepTooSmall {
        /// Simulated time, s.
        time_s: f64,
        /// The step, s.
        step_s: f64,
        /// The tolerance.
        tolerance: f64,
    },
    /// A checkpoint of another bearing.
    #[error("the checkpoint has {found} unknowns, the case {expected}: it belongs to another case")]
    Checkpoint {
        /// Unknowns of the checkpoint.
        found: usize,
        /// Unknowns of the run.
        expected: usize,
    },
    /// A checkpoint with a value that no run of the case has.
    #[error("the checkpoint is damaged: {field} is {value}, allowed is {allowed}")]
    CheckpointValue {
        /// Which value.
        field: &'static str,
        /// The value, SI.
        value: f64,
        /// What is allowed.
        allowed: String,
    },
}
