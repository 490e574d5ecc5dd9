//! Errors of the study.

use std::path::PathBuf;

/// A result that could not be made, or that differs from what is committed.
#[derive(Debug, thiserror::Error)]
pub enum PaperError {
    /// A file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Reason of the system.
        source: std::io::Error,
    },
    /// A file or its folder cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file or folder.
        path: PathBuf,
        /// Reason of the system.
        source: std::io::Error,
    },
    /// A CSV file is malformed.
    #[error("{file}:{line}: {message}")]
    Table {
        /// The file, relative to the workspace.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// The value and what is allowed.
        message: String,
    },
    /// A case file is refused.
    #[error("{file}:{}:{}: {source}", source.line, source.column)]
    Case {
        /// The file.
        file: String,
        /// Place, field and value.
        source: Box<tribodyn_case::CaseError>,
    },
    /// A case does not describe a bearing.
    #[error("{run}: {source}")]
    Bearing {
        /// Name of the run.
        run: &'static str,
        /// The values that exclude each other.
        source: tribodyn_bearing::BearingError,
    },
    /// A case does not describe a run.
    #[error("run {run}: {source}")]
    Inputs {
        /// Name of the run.
        run: String,
        /// The value that is missing or impossible.
        source: Box<tribodyn_case::InputError>,
    },
    /// A quasi-static solution is not found.
    #[error("{run}: {source}")]
    Solver {
        /// Name of the run.
        run: &'static str,
        /// Residual and iterations.
        source: tribodyn_quasistatic::QuasiStaticError,
    },
    /// A steady orbit is not found.
    #[error("{run}: {source}")]
    Orbit {
        /// Name of the run.
        run: &'static str,
        /// The balance that is not met.
        source: Box<tribodyn_orbit::OrbitError>,
    },
    /// A hypothesis cannot be fitted.
    #[error("{hypothesis}: {source}")]
    Identify {
        /// Its name, or the problem file.
        hypothesis: String,
        /// The reason.
        source: Box<tribodyn_identify::IdentifyError>,
    },
    /// A transient run stops before its end.
    #[error("run {run}: {source}")]
    Transient {
        /// Name of the run.
        run: String,
        /// Time and reason.
        source: Box<tribodyn_dynamics::DynamicsError>,
    },
    /// A spectrum or a statistic cannot be worked out.
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    /// A traction curve is not possible.
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    /// A recording cannot be written.
    #[error(transparent)]
    Record(#[from] tribodyn_record::RecordError),
    /// A figure cannot be drawn.
    #[error(transparent)]
    Plot(#[from] tribodyn_plot::PlotError),
    /// A result cannot be written as JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
    /// A document lacks the place of its generated block.
    #[error("{document} lacks the lines `{begin}` and `{end}`, in this order, each once")]
    Markers {
        /// The document, relative to the workspace.
        document: String,
        /// Line before the block.
        begin: &'static str,
        /// Line after it.
        end: &'static str,
    },
    /// Results that are not as they must be.
    #[error("{what}: {}", listed(findings))]
    Check {
        /// The check.
        what: &'static str,
        /// Each difference, in words.
        findings: Vec<String>,
    },
}

/// Each finding on an indented line of its own.
pub fn listed(findings: &[String]) -> String {
    findings.iter().map(|f| format!("\n  {f}")).collect()
}

impl PaperError {
    /// The input is wrong, not a check or a calculation.
    pub fn is_bad_input(&self) -> bool {
        matches!(self, Self::Read { .. } | Self::Table { .. } | Self::Case { .. } | Self::Bearing { .. })
    }
}
