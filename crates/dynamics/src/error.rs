//! Why a run cannot start or go on.

use crate::blame::Blame;
use tribodyn_quasistatic::QuasiStaticError;
use tribodyn_signal::SignalError;
use tribodyn_traction::TractionError;
use tribodyn_wear::WearError;

/// Why a run cannot start or go on.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DynamicsError {
    /// Nothing holds a ring that is free to move.
    #[error("`{path}` is 0: the outer ring carries the load and needs a support")]
    Unsupported {
        /// Path of the value.
        path: &'static str,
    },
    /// The start from the quasi-static solution.
    #[error("no quasi-static solution to start from: {0}")]
    Start(#[from] QuasiStaticError),
    /// A start from the steady orbit without its motion.
    #[error("to start from the steady orbit, give its motion to `Run::moving`")]
    NoMotion,
    /// Balls of another bearing to start from.
    #[error("{found} balls to start from: the bearing has {expected}")]
    Balls {
        /// Balls that there are.
        found: usize,
        /// Balls of the bearing.
        expected: usize,
    },
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
    #[error("{what} became infinite or not a number after {time_s} s: {}", beyond(blame))]
    NotFinite {
        /// Which unknown.
        what: String,
        /// Simulated time, s.
        time_s: f64,
        /// Why.
        blame: Blame,
    },
    /// A ball has left its races.
    #[error("ball {ball} left its groove after {time_s} s: it is {distance_mm:.3} mm from its place; {}", lost(blame))]
    BallLost {
        /// The ball.
        ball: usize,
        /// Simulated time, s.
        time_s: f64,
        /// How far it is from where an unloaded ball stands, mm.
        distance_mm: f64,
        /// Why.
        blame: Blame,
    },
    /// A step that is too short, or lost in the rounding of the time.
    #[error("the run stopped after {time_s} s: its step fell to {step_s:.1e} s, too short to reach the end")]
    NoProgress {
        /// Simulated time, s.
        time_s: f64,
        /// The step, s.
        step_s: f64,
    },
    /// Friction that the fast scheme has to take explicitly, and a step that is too long for it.
    #[error(
        "after {time_s} s the step of {step_s:.2e} s is too long: with this traction law the fast scheme takes friction explicitly, and that of ball {ball} is stable up to {limit_s:.2e} s only; shorten the step"
    )]
    UnstableFriction {
        /// Simulated time, s.
        time_s: f64,
        /// The step, s.
        step_s: f64,
        /// The longest stable step, s.
        limit_s: f64,
        /// The ball with the fastest decay.
        ball: usize,
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
        /// The allowed values.
        allowed: String,
    },
}

/// Why a motion left all numbers.
fn beyond(blame: &Blame) -> String {
    match blame {
        Blame::Step { step_s, bound } => format!(
            "the step of {step_s:.2e} s is too long for {}, stable up to about {:.2e} s here",
            bound.motion, bound.limit_s
        ),
        Blame::Case { step_s } => format!(
            "not for the step, {step_s:.2e} s is below all bounds of stability; see the loads, speeds, supports and damping of the case"
        ),
    }
}

/// Why a ball left its place.
fn lost(blame: &Blame) -> String {
    match blame {
        Blame::Step { step_s, bound } => format!(
            "the step of {step_s:.2e} s may be too long for {} (stable up to about {:.2e} s here) or the loads too low to hold the ball",
            bound.motion, bound.limit_s
        ),
        Blame::Case { .. } => {
            "the loads are too low to hold the ball, or the supports too soft to hold the rings: no motion asks for a shorter step".to_owned()
        }
    }
}
