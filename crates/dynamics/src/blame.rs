//! The cause of a motion beyond all bounds: the step, or the case.

/// A motion and the longest step at which it is stable.
#[derive(Debug, Clone, PartialEq)]
pub struct StepBound {
    /// The motion, such as "friction of ball 3".
    pub motion: String,
    /// Longest stable step, s.
    pub limit_s: f64,
}

/// Cause of a motion beyond all bounds.
#[derive(Debug, Clone, PartialEq)]
pub enum Blame {
    /// The step is longer than a motion allows.
    Step {
        /// The step, s.
        step_s: f64,
        /// The motion with its bound, which is below the step.
        bound: Box<StepBound>,
    },
    /// Loads, speeds, supports or damping of the case: no motion asks for a shorter step.
    Case {
        /// The step, s.
        step_s: f64,
    },
}
