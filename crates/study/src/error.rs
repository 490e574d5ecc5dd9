//! Why a procedure does not start, or ends before its time.

use crate::difference::SweepDifference;
use crate::holder::{Holder, by};
use std::path::PathBuf;
use tribodyn::AnswerError;
use tribodyn_dynamics::DynamicsError;
use tribodyn_orbit::OrbitError;
use tribodyn_record::RecordError;

/// A procedure that cannot start, go on or finish.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A question to the case without an answer.
    #[error(transparent)]
    Answer(#[from] AnswerError),
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
    /// No steady orbit for a run to start from.
    #[error(
        "{file}: no steady orbit to start from: {source}; `transient.start: QuasiStatic` starts from the equilibrium"
    )]
    NoOrbitToStart {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: OrbitError,
    },
    /// A bearing that makes no FMU.
    #[error("{file}: {source}")]
    Fmu {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: tribodyn_fmu::FmuError,
    },
    /// A shaft without an answer.
    #[error("{file}: {source}")]
    Shaft {
        /// Name of the shaft's file, and of the bearing where it is about one.
        file: String,
        /// Reason.
        source: tribodyn_shaft::ShaftError,
    },
    /// A matrix that cannot be read.
    #[error("{}:{line}: {message}", path.display())]
    Matrix {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// The fault and what is allowed.
        message: String,
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
    /// A file of signals that is refused: the file, then the place in it, where there is one, and the reason.
    #[error("{}:{}", .0.display(), .1)]
    Signals(PathBuf, String),
    /// Finished rows of another sweep.
    #[error("{}: {difference}", path.display())]
    OtherSweep {
        /// File of finished rows.
        path: PathBuf,
        /// First difference from this sweep.
        difference: SweepDifference,
    },
    /// A table that is no part of the same sweep, or rows that are missing or there twice.
    #[error("{}: {why}", path.display())]
    Merge {
        /// The table.
        path: PathBuf,
        /// Reason.
        why: String,
    },
    /// Two processes with one output.
    #[error("{}: another process is writing it{}", output.display(), by(holder))]
    Busy {
        /// The recording or table.
        output: PathBuf,
        /// Who writes it, where that is known.
        holder: Option<Holder>,
    },
    /// A file where a lock should be.
    #[error("{} is not a lock of this program: move it away, or choose another output", path.display())]
    NoLock {
        /// The file.
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
    Wear(#[from] tribodyn_wear::WearError),
    /// A life without an end.
    #[error("{0}: no coating wears through in this case: give a time at which its life ends")]
    NoWear(String),
    /// A life of races without coating, and without another end.
    #[error(
        "{0}: neither race has a coating to wear through: give a limit of clearance or a time at which the life ends"
    )]
    NoCoating(String),
    /// A file of somebody else's that would be lost.
    #[error("{} exists and is not {wanted} that tribodyn wrote: it is not replaced", path.display())]
    NotOurs {
        /// The file.
        path: PathBuf,
        /// Kind of file that may be replaced.
        wanted: &'static str,
    },
    /// A recording of another bearing that would be lost.
    #[error("{} is a recording of another bearing, {found}: it is not replaced", path.display())]
    OtherRecording {
        /// The recording.
        path: PathBuf,
        /// Name of its bearing.
        found: String,
    },
    /// An earlier run that would be lost.
    #[error("{} is of a run that was not finished", path.display())]
    Unfinished {
        /// File of the earlier run.
        path: PathBuf,
    },
    /// No earlier run to go on with.
    #[error("no run to continue: {} does not exist", path.display())]
    NothingToResume {
        /// The checkpoint.
        path: PathBuf,
    },
    /// A checkpoint of another version, or of another format.
    #[error(
        "{} is of version {found}, format {format}; this is version {}, format {}",
        path.display(), env!("CARGO_PKG_VERSION"), crate::run::CHECKPOINT_FORMAT
    )]
    OtherVersion {
        /// The checkpoint.
        path: PathBuf,
        /// Its version.
        found: String,
        /// Its format.
        format: u32,
    },
    /// A checkpoint that is not as it was written.
    #[error("{} is damaged: its checksum does not match ({found} of {expected} bytes)", path.display())]
    Altered {
        /// The checkpoint.
        path: PathBuf,
        /// Bytes of the run in it.
        found: u64,
        /// Bytes that were written.
        expected: u64,
    },
    /// A checkpoint of another case.
    #[error("{} belongs to another case, which differs at line {line}", path.display())]
    OtherCase {
        /// The checkpoint.
        path: PathBuf,
        /// First line of the case, from 1, that differs.
        line: usize,
    },
    /// A checkpoint that cannot be read.
    #[error("{} is not a checkpoint: {source}", path.display())]
    Damaged {
        /// The checkpoint.
        path: PathBuf,
        /// Reason.
        source: serde_json::Error,
    },
    /// A recording that ends before its checkpoint.
    #[error("{} holds {found} of the {expected} messages up to the checkpoint", path.display())]
    Incomplete {
        /// The recording.
        path: PathBuf,
        /// Messages in it.
        found: u64,
        /// Messages up to the checkpoint.
        expected: u64,
    },
    /// A recording of something else.
    #[error("{} holds no sample of a transient run or of a solution that can be read", path.display())]
    NoRun {
        /// The recording.
        path: PathBuf,
    },
    /// A recording of two things.
    #[error("{} holds a run and a solution: a report is of one of them", path.display())]
    Mixed {
        /// The recording.
        path: PathBuf,
    },
    /// A file that is no recording.
    #[error("{}", with_causes(source))]
    NoRecording {
        /// Reason.
        source: Box<RecordError>,
    },
    /// A case that cannot be run.
    #[error("{file}: {source}")]
    CannotStart {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: DynamicsError,
    },
    /// A run that the solver cannot finish.
    #[error("{file}: {source}; what was recorded before is in {}", recording.display())]
    BrokenOff {
        /// Name of the case file.
        file: String,
        /// Reason.
        source: Box<DynamicsError>,
        /// The recording up to there.
        recording: PathBuf,
    },
    /// A run that cannot be recorded any more.
    #[error("after {simulated_s} s: {}", with_causes(source))]
    NotRecorded {
        /// Simulated time, s.
        simulated_s: f64,
        /// Reason.
        source: Box<RecordError>,
        /// The recording up to there, not closed.
        active: PathBuf,
    },
    /// A system that gives the recording no thread.
    #[error("cannot start a thread for the recording: {source}")]
    NoThread {
        /// Reason.
        source: std::io::Error,
    },
    /// A run that cannot write its checkpoint.
    #[error("after {simulated_s} s: cannot write {}: {source}", checkpoint.display())]
    NoCheckpoint {
        /// Simulated time, s.
        simulated_s: f64,
        /// The checkpoint.
        checkpoint: PathBuf,
        /// Reason.
        source: std::io::Error,
        /// The recording up to there, not closed.
        active: PathBuf,
    },
    /// A figure of a file that is refused.
    #[error("{}:{line}:{column}: {message}", path.display())]
    Figures {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// Reason, with the value and what is allowed.
        message: String,
    },
    /// Signals or speeds that cannot be evaluated.
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    /// A recording that cannot be written or read.
    #[error("{}", with_causes(.0))]
    Record(#[from] RecordError),
    /// Something that cannot be written as JSON.
    #[error("cannot write JSON: {0}")]
    Json(#[from] serde_json::Error),
}

impl StudyError {
    /// True where the caller ended a search.
    pub fn is_ended(&self) -> bool {
        matches!(self, Self::Answer(error) if error.is_ended())
    }

    /// A value that a procedure cannot have.
    pub(crate) fn argument(name: &'static str, value: impl ToString, message: impl Into<String>) -> Self {
        Self::Answer(AnswerError::argument(name, value, message))
    }
}

/// The message of an error with those of its causes that it does not repeat: a full disk lies deep.
pub fn with_causes(error: &dyn std::error::Error) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let text = error.to_string();
        if !message.contains(&text) {
            message = format!("{message}: {text}");
        }
        cause = error.source();
    }
    message
}
