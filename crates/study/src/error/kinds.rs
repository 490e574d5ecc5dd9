//! What callers ask of a failure.

use super::StudyError;
use tribodyn_orbit::OrbitError;
use tribodyn_quasistatic::QuasiStaticError;

impl StudyError {
    /// True where an operating point was not found, or is none: what the standards say of the loads stands all the
    /// same.
    pub fn leaves_a_rating(&self) -> bool {
        matches!(
            self,
            Self::Overload { .. }
                | Self::Solver { source: QuasiStaticError::NotConverged { .. } | QuasiStaticError::Ended, .. }
                | Self::Orbit { source: OrbitError::NotConverged { .. } | OrbitError::Ended, .. }
        )
    }

    /// True where the caller ended a search.
    pub fn is_ended(&self) -> bool {
        matches!(
            self,
            Self::Solver { source: QuasiStaticError::Ended, .. }
                | Self::Orbit { source: OrbitError::Ended, .. }
                | Self::Pair { source: crate::pair::PairError::Ended, .. }
        )
    }

    /// A value that a question cannot have.
    pub fn argument(name: &'static str, value: impl ToString, message: impl Into<String>) -> Self {
        Self::Argument { name, value: value.to_string(), message: message.into() }
    }
}
