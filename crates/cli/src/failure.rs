//! What can go wrong, as a person reads it.

use miette::{Diagnostic, NamedSource, SourceSpan};
use std::path::PathBuf;
use tribodyn_bearing::BearingError;
use tribodyn_case::CaseError;
use tribodyn_identify::IdentifyError;
use tribodyn_quasistatic::QuasiStaticError;

/// A failed command; its exit code says whether the input or the calculation is to blame.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum Failure {
    #[error("{}{}:{}:{}: {}", .0.options, .0.file, .0.error.line, .0.error.column, .0.error)]
    #[diagnostic(transparent)]
    Case(Box<CaseFailure>),
    #[error("{option}: {error}")]
    Change { option: String, error: Box<CaseError> },
    #[error("cannot read {}: {source}", path.display())]
    Read { path: PathBuf, source: std::io::Error },
    #[error("cannot write {}: {source}", path.display())]
    Write { path: PathBuf, source: std::io::Error },
    #[error("--{option} {value}: {message}")]
    Option { option: &'static str, value: String, message: String },
    #[error("{}:{line}:{column}: {message}", path.display())]
    Figures { path: PathBuf, line: usize, column: usize, message: String },
    #[error("{quantity} comes out as {value}: the numbers given are too large or too small to calculate with")]
    OutOfRange { quantity: &'static str, value: f64 },
    #[error("{file}: {source}")]
    Bearing { file: String, source: BearingError },
    #[error("{file}: {source}")]
    Solver { file: String, source: QuasiStaticError },
    #[error("{file}: {source}")]
    Identify { file: String, source: Box<IdentifyError> },
    #[error(transparent)]
    Contact(#[from] tribodyn_contact::ContactError),
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    #[error("{}", with_causes(.0))]
    Record(#[from] tribodyn_record::RecordError),
    #[error(transparent)]
    Plot(#[from] tribodyn_plot::PlotError),
    #[error(transparent)]
    Sweep(#[from] crate::sweep::SweepError),
    #[error(transparent)]
    Run(#[from] crate::run::RunError),
    #[error(transparent)]
    Wear(#[from] tribodyn_wear::WearError),
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    #[error("cannot write the answer: {0}")]
    Output(#[from] std::io::Error),
    #[error("cannot write the answer as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// A refused case file with the place to point at.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{error}")]
pub struct CaseFailure {
    pub file: String,
    /// The options that brought the value in, each with a colon; empty where it stands in the file.
    pub options: String,
    #[source_code]
    pub text: NamedSource<String>,
    #[label("here")]
    pub span: SourceSpan,
    pub error: CaseError,
}

impl Failure {
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Sweep(error) => error.exit_code(),
            Self::Run(error) => error.exit_code(),
            Self::Solver { source: QuasiStaticError::NotConverged { .. }, .. } => 1,
            Self::Identify { source, .. }
                if matches!(**source, IdentifyError::NoStart { .. } | IdentifyError::Solver(_)) =>
            {
                1
            }
            Self::Write { .. }
            | Self::Signal(_)
            | Self::Record(_)
            | Self::Plot(_)
            | Self::Output(_)
            | Self::Json(_) => 1,
            _ => 2,
        }
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
