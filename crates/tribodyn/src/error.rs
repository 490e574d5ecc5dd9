//! Why a question has no answer.

use crate::pair::PairError;
use crate::refused::RefusedCase;
use tribodyn_bearing::BearingError;
use tribodyn_case::{CaseError, Lacking};
use tribodyn_orbit::OrbitError;
use tribodyn_quasistatic::QuasiStaticError;

/// A question that has no answer.
#[derive(Debug, thiserror::Error)]
pub enum AnswerError {
    /// A case that is refused.
    #[error("{}{}:{}:{}: {}", .0.options, .0.file, .0.error.line, .0.error.column, .0.error)]
    Case(Box<RefusedCase>),
    /// A change of a case that cannot be made.
    #[error("{option}: {error}")]
    Change {
        /// The change as its author named it.
        option: String,
        /// Reason.
        error: Box<CaseError>,
    },
    /// A value that a question cannot have.
    #[error("{name} = {value}: {message}")]
    Argument {
        /// The value's name: that of the command's option.
        name: &'static str,
        /// The value.
        value: String,
        /// The allowed values, or why it is refused.
        message: String,
    },
    /// An answer beyond what can be calculated with.
    #[error("{quantity} is {value}: the given numbers are too large or too small to calculate with")]
    OutOfRange {
        /// The quantity.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// Bodies that make no contact.
    #[error(transparent)]
    Contact(#[from] tribodyn_contact::ContactError),
    /// A lubricant or a film that is refused.
    #[error(transparent)]
    Lubricant(#[from] tribodyn_lubricant::LubricantError),
    /// A coating or a law that is refused.
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    /// Dimensions that have no defect frequencies.
    #[error(transparent)]
    Frequencies(#[from] tribodyn_signal::SignalError),
    /// A bearing that the built-in list does not have.
    #[error(transparent)]
    Catalogue(#[from] tribodyn_catalogue::CatalogueError),
    /// A case that makes no bearing.
    #[error("{file}: {source}")]
    Bearing {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: BearingError,
    },
    /// A case without what a model needs.
    #[error("{file}: {source}")]
    Lacking {
        /// Name of the case file.
        file: String,
        /// All that is missing.
        source: Lacking,
    },
    /// A pair that has no equilibrium.
    #[error("{file}: {source}")]
    Pair {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: PairError,
    },
    /// An equilibrium that is not found.
    #[error("{file}: {source}")]
    Solver {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: QuasiStaticError,
    },
    /// A steady orbit that is not found.
    #[error("{file}: {source}; the model `{}` {}", other_model(.source).0, other_model(.source).1)]
    Orbit {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: OrbitError,
    },
    /// A case of which such a question cannot be asked.
    #[error("{file}: {why}")]
    NotAsked {
        /// Name of the case file.
        file: String,
        /// Reason: a thing that the case would need.
        why: String,
    },
    /// Temperatures that friction and cooling do not agree on, or at which the bearing clamps.
    #[error("{file}: {why}")]
    Runaway {
        /// Name of the case file.
        file: String,
        /// How far they went.
        why: String,
    },
    /// Conductances that are none.
    #[error(transparent)]
    Thermal(#[from] tribodyn_thermal::ThermalError),
    /// Loads far beyond what the bearing carries.
    #[error("{file}: {why}")]
    Overload {
        /// Name of the case file.
        file: String,
        /// A first estimate in words.
        why: String,
    },
    /// A bearing at rest, where a motion is asked for.
    #[error(
        "{0}: the rings do not turn against each other: a bearing at rest has no orbit to swing about; \
         `speed.inner` or `speed.outer` other than the same gives it one"
    )]
    AtRest(String),
    /// A bearing that the standards do not rate.
    #[error("{file}: {source}")]
    Rating {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: tribodyn_rating::RatingError,
    },
}

/// The model that has an answer where the orbit has none, and why.
fn other_model(error: &OrbitError) -> (&'static str, &'static str) {
    match error {
        OrbitError::TurnsAsOne { .. } => ("jones-harris", "has the loads of the balls"),
        _ => ("traction", "solves each ball by itself and needs less"),
    }
}

impl AnswerError {
    /// True where an operating point was not found, or is none: what the standards say of the loads stands all the
    /// same.
    pub fn leaves_a_rating(&self) -> bool {
        matches!(
            self,
            Self::Overload { .. }
                | Self::Solver { source: QuasiStaticError::NotConverged { .. } | QuasiStaticError::Ended, .. }
                | Self::Orbit {
                    source: OrbitError::NotConverged { .. } | OrbitError::Ended | OrbitError::TurnsAsOne { .. },
                    ..
                }
        )
    }

    /// True where the caller ended a search.
    pub fn is_ended(&self) -> bool {
        matches!(
            self,
            Self::Solver { source: QuasiStaticError::Ended, .. }
                | Self::Orbit { source: OrbitError::Ended, .. }
                | Self::Pair { source: PairError::Ended, .. }
        )
    }

    /// A case of which such a question cannot be asked: it would need what `why` says.
    pub(crate) fn not_asked(file: &str, why: &str) -> Self {
        Self::NotAsked { file: file.to_owned(), why: why.to_owned() }
    }

    /// A value that a question cannot have.
    pub fn argument(name: &'static str, value: impl ToString, message: impl Into<String>) -> Self {
        Self::Argument { name, value: value.to_string(), message: message.into() }
    }
}
