//! Failures of a task.

use tribodyn_paper::{PaperError, listed};

/// A failed task; its exit code says whether a check or the input is to blame.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error(transparent)]
    Paper(#[from] PaperError),
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    #[error(transparent)]
    Record(#[from] tribodyn_record::RecordError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    #[error("an input to begin with cannot be made: {0}")]
    Seed(String),
    #[error("cannot print: {0}")]
    Print(std::io::Error),
    #[error("cannot run {program}: {source}")]
    Start { program: String, source: std::io::Error },
    #[error("{command} failed ({status})")]
    Command { command: String, status: std::process::ExitStatus },
    #[error("{what}: {}", listed(findings))]
    Check { what: &'static str, findings: Vec<String> },
}

impl Failure {
    /// 2 where the input is wrong, 1 where a check or a calculation failed.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Paper(error) if error.is_bad_input() => 2,
            _ => 1,
        }
    }
}
