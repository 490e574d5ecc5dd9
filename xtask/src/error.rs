//! What can stop a task.

use std::path::PathBuf;

/// A failed task; its exit code says whether a check or the input is to blame.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("cannot read {}: {source}", path.display())]
    Read { path: PathBuf, source: std::io::Error },
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: std::io::Error },
    #[error("{file}:{line}: {message}")]
    Table { file: String, line: usize, message: String },
    #[error("{file}:{}:{}: {source}", source.line, source.column)]
    Case { file: String, source: Box<tribodyn_case::CaseError> },
    #[error("{run}: {source}")]
    Bearing { run: &'static str, source: tribodyn_bearing::BearingError },
    #[error("{run}: {source}")]
    Solver { run: &'static str, source: tribodyn_quasistatic::QuasiStaticError },
    #[error("run {run}: {source}")]
    Transient { run: String, source: Box<tribodyn_dynamics::DynamicsError> },
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    #[error(transparent)]
    Record(#[from] tribodyn_record::RecordError),
    #[error(transparent)]
    Plot(#[from] tribodyn_plot::PlotError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    #[error("cannot print: {0}")]
    Print(std::io::Error),
    #[error("cannot run {program}: {source}")]
    Start { program: String, source: std::io::Error },
    #[error("{command} failed ({status})")]
    Command { command: String, status: std::process::ExitStatus },
    #[error("{document} lacks the lines `{begin}` and `{end}`, in this order, each once")]
    Markers { document: String, begin: &'static str, end: &'static str },
    #[error("{what}: {}", list(findings))]
    Check { what: &'static str, findings: Vec<String> },
}

fn list(findings: &[String]) -> String {
    findings.iter().map(|f| format!("\n  {f}")).collect()
}

impl Failure {
    /// 2 where the input is wrong, 1 where a check or a calculation failed.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Read { .. } | Self::Table { .. } | Self::Case { .. } | Self::Bearing { .. } => 2,
            _ => 1,
        }
    }
}
