//! Why a run does not start, or ends before its time.

use std::path::PathBuf;
use tribodyn_dynamics::DynamicsError;

/// What can go wrong with a run besides its case and its files.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// A run of before would be lost.
    #[error(
        "{} is of a run that was not finished: --resume goes on with it, --restart forgets it",
        path.display()
    )]
    Unfinished { path: PathBuf },
    #[error("there is no run to go on with: {} does not exist", path.display())]
    NothingToResume { path: PathBuf },
    #[error("{} is of version {found}, this is {}: start anew with --restart", path.display(), super::checkpoint::VERSION)]
    OtherVersion { path: PathBuf, found: String },
    #[error(
        "{} is of another case, which differs from line {line} of this one: give the same file and the same --set and --duration, or start anew with --restart",
        path.display()
    )]
    OtherCase { path: PathBuf, line: usize },
    #[error("{} is no checkpoint: {source}", path.display())]
    Damaged { path: PathBuf, source: serde_json::Error },
    #[error("{} holds {found} of the {expected} messages up to the checkpoint: start anew with --restart", path.display())]
    Incomplete { path: PathBuf, found: u64, expected: u64 },
    #[error("{} holds no sample of a transient run or of a solution that can be read", path.display())]
    NoRun { path: PathBuf },
    #[error("{} holds a run and a solution: a report is of one of them", path.display())]
    Mixed { path: PathBuf },
    #[error("{}", crate::failure::with_causes(source))]
    NoRecording { source: Box<tribodyn_record::RecordError> },
    #[error("{file}: {source}{}", hint(source))]
    CannotStart { file: String, source: DynamicsError },
    #[error("{file}: {source}; what was recorded before is in {}", recording.display())]
    BrokenOff { file: String, source: DynamicsError, recording: PathBuf },
    #[error(
        "after {simulated_s} s: {}; `tribodyn recover {}` makes a whole recording of what was written",
        crate::failure::with_causes(source), active.display()
    )]
    NotRecorded { simulated_s: f64, source: Box<tribodyn_record::RecordError>, active: PathBuf },
    #[error(
        "after {simulated_s} s: cannot write {}: {source}; `tribodyn recover {}` makes a whole recording of what was written", checkpoint.display(), active.display()
    )]
    NoCheckpoint { simulated_s: f64, checkpoint: PathBuf, source: std::io::Error, active: PathBuf },
    #[error("stopped after {simulated_s} of {duration_s} s; --resume goes on from there")]
    Stopped { simulated_s: f64, duration_s: f64 },
}

/// Where a reader finds what a case for `solve` does not need.
fn hint(error: &DynamicsError) -> &'static str {
    match error {
        DynamicsError::Missing { .. } => {
            "; docs/case-file.md has the fields, fixtures/cases/paper-ag-worn.ron an example of each"
        }
        _ => "",
    }
}

impl RunError {
    /// 2 where the input is to blame, 1 where the calculation or the disk is.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::NoCheckpoint { .. }
            | Self::Incomplete { .. }
            | Self::BrokenOff { .. }
            | Self::NotRecorded { .. }
            | Self::Stopped { .. } => 1,
            Self::CannotStart { source: DynamicsError::Start(_), .. } => 1,
            _ => 2,
        }
    }
}
