//! Why a procedure does not start, or ends before its time.

use crate::sweep::SweepDifference;
use std::path::PathBuf;
use tribodyn_bearing::BearingError;
use tribodyn_bearing::case::CaseError;
use tribodyn_quasistatic::QuasiStaticError;

/// A procedure that cannot start, go on or finish.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
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
    /// A file that cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Reason.
        source: std::io::Error,
    },
    /// A file that cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Reason.
        source: std::io::Error,
    },
    /// A case that makes no bearing.
    #[error("{file}: {source}")]
    Bearing {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: BearingError,
    },
    /// An equilibrium that is not found.
    #[error("{file}: {source}")]
    Solver {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: QuasiStaticError,
    },
    /// Two lists of values for one place of the case.
    #[error("{first} and {second} sweep the same value")]
    Overlap {
        /// Path of the first list.
        first: String,
        /// Path of the second list.
        second: String,
    },
    /// A grid beyond all calculation.
    #[error("the grid has more than {limit} rows")]
    TooManyRows {
        /// Most rows of a grid.
        limit: usize,
    },
    /// A row of the grid that was refused once and then accepted.
    #[error("row {row}: a refused case was accepted when read again")]
    RefusalLost {
        /// Number of the row, from 0.
        row: usize,
    },
    /// A table that is neither Parquet nor CSV.
    #[error("{}: allowed is a name that ends in {allowed}", path.display())]
    TableFormat {
        /// The table.
        path: PathBuf,
        /// Endings that are known.
        allowed: &'static str,
    },
    /// Finished rows of another sweep.
    #[error("{}: {difference}", path.display())]
    OtherSweep {
        /// File of finished rows.
        path: PathBuf,
        /// First difference from this sweep.
        difference: SweepDifference,
    },
    /// Two sweeps with one table.
    #[error("{}: another sweep is writing there", path.display())]
    Busy {
        /// File of finished rows.
        path: PathBuf,
    },
    /// A sweep that its caller stopped; what is finished is kept.
    #[error("the sweep was stopped; finished rows are in {}", path.display())]
    SweepStopped {
        /// File of finished rows.
        path: PathBuf,
    },
    /// Wear that cannot be followed.
    #[error(transparent)]
    Wear(#[from] tribodyn_bearing::wear::WearError),
    /// A life without an end.
    #[error("{file}: nothing wears a coating through in this case: a time is needed at which its life ends")]
    NoWear {
        /// Name of the case file.
        file: String,
    },
    /// Something that cannot be written as JSON.
    #[error("cannot write JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// A refused case with the place to point at.
#[derive(Debug)]
pub struct RefusedCase {
    /// Name of the case file.
    pub file: String,
    /// The changes that brought the value in, each with a colon; empty where it stands in the file.
    pub options: String,
    /// The text that was read, changes made.
    pub text: String,
    /// Reason, with the place in the text.
    pub error: CaseError,
}
