//! Failures of commands, as messages for people.

use crate::excerpt::Excerpt;
use crate::harmless::harmless;
use miette::{Diagnostic, MietteDiagnostic, SourceSpan};
use std::path::{Path, PathBuf};
use tribodyn::pair::PairError;
use tribodyn::{AnswerError, RefusedCase};
use tribodyn_case::CaseError;
use tribodyn_dynamics::DynamicsError;
use tribodyn_identify::IdentifyError;
use tribodyn_orbit::OrbitError;
use tribodyn_quasistatic::QuasiStaticError;
use tribodyn_record::RecordError;
use tribodyn_report::ReportError;
use tribodyn_shaft::ShaftError;
use tribodyn_study::{StudyError, SweepDifference, with_causes};

/// A failed command; its exit code says whether the input or the calculation is to blame.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum Failure {
    #[error("{}", .0.line())]
    #[diagnostic(transparent)]
    Case(Box<CaseFailure>),
    #[error("{}", in_options(.0))]
    Study(StudyError),
    #[error("--{option} {value}: {message}")]
    Option { option: &'static str, value: String, message: String },
    /// A value that stands on its place without an option's name.
    #[error("{value}: {message}")]
    Place { value: String, message: String },
    #[error("{file}: {source}")]
    Identify { file: String, source: Box<IdentifyError> },
    #[error(transparent)]
    Catalogue(#[from] tribodyn_catalogue::CatalogueError),
    #[error("{}{}", with_causes(.0), lifts(.0))]
    Record(#[from] tribodyn_record::RecordError),
    #[error(transparent)]
    Plot(#[from] tribodyn_plot::PlotError),
    /// Figures of a sweep that has none.
    #[error("--plot: {why}")]
    NoFigures { why: String },
    /// The table is written, but not every row is a solution.
    #[error("{failed} of {rows} rows have no solution; the column `error` of {} says why", path.display())]
    Unsolved { failed: usize, rows: usize, path: PathBuf },
    /// A new case where a file stands.
    #[error("{} exists already: name another file with -o, or replace it with --force", path.display())]
    Exists { path: PathBuf },
    /// A search that was given up.
    #[error(
        "{file}: no answer after {limit_s} s of processor time{stage}; allow more with --time-limit, or take `--model \
         traction`"
    )]
    OutOfTime { file: String, limit_s: f64, stage: String },
    /// A run that was stopped before its end.
    #[error("stopped after {} of {} s; --resume goes on from there", plain(*simulated_s), plain(*duration_s))]
    Stopped { simulated_s: f64, duration_s: f64 },
    /// An ensemble that was stopped before all members were finished.
    #[error("stopped: {finished} of {members} members are finished{}", goes_on(.table.as_deref()))]
    EnsembleStopped { finished: usize, members: usize, table: Option<PathBuf> },
    /// The answer is given, but not every member has a part in it.
    #[error("{failed} of {members} members have no result; the answer says why")]
    FailedMembers { failed: usize, members: usize },
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    #[error("cannot write the answer: {0}")]
    Output(#[from] std::io::Error),
    #[error("cannot write the answer as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// A number with six digits and no more than it needs.
fn plain(value: f64) -> String {
    let text = format!("{value:.5e}");
    text.parse::<f64>().map_or(text, |rounded| rounded.to_string())
}

/// A refused case file with the place to point at.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{error}")]
pub struct CaseFailure {
    pub file: String,
    /// The options that brought the value in, each with a colon; empty where it stands in the file.
    pub options: String,
    #[source_code]
    pub excerpt: Excerpt,
    #[label("here")]
    pub span: SourceSpan,
    pub error: CaseError,
}

impl CaseFailure {
    /// The message on one line.
    fn line(&self) -> String {
        let Self { file, options, error, .. } = self;
        shown(&format!("{options}{file}:{}:{}: {error}", error.line, error.column))
    }
}

/// Characters of a message that are shown: names and values in it come from files.
const LONGEST: usize = 2000;

/// A message that cannot steer a terminal, its middle left out where it is too long.
fn shown(message: &str) -> String {
    let message = harmless(message);
    let count = message.chars().count();
    if count <= LONGEST {
        return message;
    }
    let start: String = message.chars().take(LONGEST / 2).collect();
    let end: String = message.chars().skip(count - LONGEST / 2).collect();
    format!("{start} … {end}")
}

impl Failure {
    /// The failure as it is shown: with the place in the case file, or its message alone.
    pub fn into_report(self) -> miette::Report {
        match self {
            Self::Case(_) => miette::Report::new(self),
            other => miette::Report::new(MietteDiagnostic::new(shown(&other.to_string()))),
        }
    }

    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Study(error) => study_exit_code(error),
            Self::Identify { source, .. }
                if matches!(**source, IdentifyError::NoStart { .. } | IdentifyError::Solver(_)) =>
            {
                1
            }
            Self::Unsolved { .. }
            | Self::OutOfTime { .. }
            | Self::Stopped { .. }
            | Self::Exists { .. }
            | Self::EnsembleStopped { .. }
            | Self::FailedMembers { .. }
            | Self::Signal(_)
            | Self::Record(_)
            | Self::Plot(_)
            | Self::Output(_)
            | Self::Json(_) => 1,
            _ => 2,
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Answer(AnswerError::Case(refused)) => {
                let RefusedCase { file, options, text, error } = *refused;
                let excerpt = Excerpt::new(&file, &text, error.offset, error.length);
                let span = excerpt.span;
                Self::Case(Box::new(CaseFailure { file, options, excerpt, span, error }))
            }
            other => Self::Study(other),
        }
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Study(error) => error.into(),
            ReportError::Record(error) => error.into(),
            ReportError::Signal(error) => error.into(),
            ReportError::Plot(error) => error.into(),
            ReportError::Json(error) => error.into(),
        }
    }
}

impl From<AnswerError> for Failure {
    fn from(error: AnswerError) -> Self {
        StudyError::from(error).into()
    }
}

/// How a study that was stopped goes on.
fn goes_on(table: Option<&Path>) -> String {
    match table {
        Some(table) => format!("; they are kept in {}.rows, and the same command goes on with them", table.display()),
        None => "; with -o TABLE they would be kept, and the same command would go on with them".to_owned(),
    }
}

/// The option that a failed reading may need.
fn lifts(error: &RecordError) -> &'static str {
    if matches!(error, RecordError::TooLong { .. }) {
        ", the limit for files that may come from elsewhere; --no-limits lifts it"
    } else {
        ""
    }
}

/// 2 where the input is to blame, 1 where the calculation or the disk is.
fn study_exit_code(error: &StudyError) -> u8 {
    match error {
        StudyError::Answer(error) => answer_exit_code(error),
        StudyError::NoOrbitToStart { source, .. } => orbit_exit_code(source),
        StudyError::Busy { .. }
        | StudyError::NoThread { .. }
        | StudyError::Shaft {
            source:
                ShaftError::NotConverged { .. }
                | ShaftError::Loose { .. }
                | ShaftError::Eigenvalues
                | ShaftError::Bearing { source: QuasiStaticError::NotConverged { .. }, .. },
            ..
        }
        | StudyError::Write { .. }
        | StudyError::RefusalLost { .. }
        | StudyError::SweepStopped { .. }
        | StudyError::NoCheckpoint { .. }
        | StudyError::Incomplete { .. }
        | StudyError::BrokenOff { .. }
        | StudyError::NotRecorded { .. }
        | StudyError::CannotStart { source: DynamicsError::Start(_), .. }
        | StudyError::Signal(_)
        | StudyError::Record(_)
        | StudyError::Json(_) => 1,
        _ => 2,
    }
}

fn answer_exit_code(error: &AnswerError) -> u8 {
    match error {
        AnswerError::Solver { source, .. } | AnswerError::Pair { source: PairError::Equilibrium(source), .. } => {
            equilibrium_exit_code(source)
        }
        AnswerError::Orbit { source, .. } | AnswerError::Pair { source: PairError::Orbit(source), .. } => {
            orbit_exit_code(source)
        }
        AnswerError::Pair { source: PairError::NotConverged { .. } | PairError::Loose | PairError::Ended, .. }
        | AnswerError::Runaway { .. }
        | AnswerError::Frequencies(_) => 1,
        _ => 2,
    }
}

fn equilibrium_exit_code(error: &QuasiStaticError) -> u8 {
    match error {
        QuasiStaticError::Missing { .. } | QuasiStaticError::Traction(_) | QuasiStaticError::NoShoulder { .. } => 2,
        _ => 1,
    }
}

fn orbit_exit_code(error: &OrbitError) -> u8 {
    match error {
        OrbitError::Start(source) => equilibrium_exit_code(source),
        OrbitError::CageStands | OrbitError::TurnsAsOne { .. } | OrbitError::AtRest | OrbitError::Traction(_) => 2,
        _ => 1,
    }
}

/// The message with the options of the command that it is about.
fn in_options(error: &StudyError) -> String {
    match error {
        StudyError::Answer(AnswerError::Argument { name, value, message }) if value.is_empty() => {
            format!("--{name}: {message}")
        }
        StudyError::Answer(AnswerError::Argument { name, value, message }) => format!("--{name} {value}: {message}"),
        StudyError::Overlap { first, second } => format!("--set {first} and --set {second} sweep the same value"),
        StudyError::TableFormat { .. } => format!("--output {error}"),
        StudyError::OtherSweep { path, difference } => {
            let difference = match difference {
                SweepDifference::Values => "these finished rows are of other --set values".to_owned(),
                SweepDifference::Model { found } => format!("these finished rows are of another --model, {found}"),
                SweepDifference::Cold => "these finished rows are of a sweep with another --cold".to_owned(),
                other => other.to_string(),
            };
            format!("{}: {difference}; delete it, or use --restart to begin anew", path.display())
        }
        StudyError::NoWear(_) => {
            "--until is missing: no coating wears through in this case: give a time in h".to_owned()
        }
        StudyError::NoCoating(_) => format!("{error}: give --clearance-limit in um, or --until in h"),
        StudyError::NotOurs { .. } | StudyError::OtherRecording { .. } => format!("{error} without --force"),
        StudyError::Unfinished { .. } => format!("{error}: --resume goes on with it, --restart forgets it"),
        StudyError::OtherVersion { .. }
        | StudyError::Altered { .. }
        | StudyError::Damaged { .. }
        | StudyError::Incomplete { .. } => {
            format!("{error}: start anew with --restart")
        }
        StudyError::OtherCase { .. } => {
            format!("{error}: give the same file and the same --set and --duration, or start anew with --restart")
        }
        // Where a reader finds what the case does not have.
        StudyError::Answer(AnswerError::Lacking { .. }) => {
            format!("{error}; docs/case-file.md has the fields, fixtures/cases/paper-ag-worn.ron an example of each")
        }
        StudyError::NotRecorded { active, .. } | StudyError::NoCheckpoint { active, .. } => {
            format!("{error}; `tribodyn recover {}` makes a whole recording of what was written", active.display())
        }
        other => other.to_string(),
    }
}
