#![doc = include_str!("../README.md")]

mod compare;
mod compare_figures;
mod content;
mod figures;
mod html;
mod live;
mod markdown;
mod opening;
mod orbit;
mod page_table;
mod solution;
mod spectra;
mod tables;
mod values;
pub mod words;

use content::Content;
use live::Live;
use serde::Serialize;
use solution::SolutionAnswer;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use tribodyn::{AnswerError, CaseFile, Limits};
use tribodyn_plot::Figure;
use tribodyn_record::{Damage, RecordError, Run, read_recording_within};
use tribodyn_signal::BearingFrequencies;
use tribodyn_study::evaluation::facts::{self, BallWear, Rolling, said};
use tribodyn_study::evaluation::published::{Compared, compared};
use tribodyn_study::evaluation::quantities::{self, Quantities};
use tribodyn_study::run::{KnownAtEnd, KnownAtStart, Summary, carries_accelerations};
use tribodyn_study::{StagedFiles, StudyError};
use values::CaseValue;

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;

/// Why a report is not made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A recording without anything to report, an argument that is refused, a file that cannot be read or written.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// A recording that cannot be read.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// Signals that cannot be evaluated.
    #[error(transparent)]
    Signal(#[from] tribodyn_signal::SignalError),
    /// A figure that cannot be drawn.
    #[error(transparent)]
    Plot(#[from] tribodyn_plot::PlotError),
    /// Numbers that cannot be written as JSON.
    #[error("cannot write JSON: {0}")]
    Json(#[from] serde_json::Error),
}

/// How a report is made.
#[derive(Debug, Clone, Copy, Default)]
pub struct ReportOptions<'a> {
    /// Published or measured figures to set beside those of a run: a CSV file with the columns id, quantity,
    /// published, tolerance, source.
    pub against: Option<&'a Path>,
    /// True if files of somebody else are replaced.
    pub force: bool,
}

/// A report that was written.
#[derive(Debug, Clone)]
pub struct Report {
    /// The numbers of `summary.json`.
    pub summary: serde_json::Value,
    /// The same for a terminal.
    pub text: String,
    /// The page.
    pub page: PathBuf,
}

/// Contents of `summary.json` and of `--json` for a run.
#[derive(Debug, Serialize)]
pub(crate) struct Answer {
    recording: PathBuf,
    bearing: String,
    generator: String,
    #[serde(flatten)]
    damage: Damage,
    /// Simulated time of the whole run, s; none where the file does not say it.
    duration_s: Option<f64>,
    /// Facts known before the first step.
    #[serde(flatten)]
    known: KnownAtStart,
    /// Facts known at the end; absent where the recording was cut off before it.
    #[serde(flatten)]
    outcome: Option<KnownAtEnd>,
    /// True if the errors of patch and scheme are small enough for accelerations.
    accelerations_supported: bool,
    frequencies: BearingFrequencies,
    rolling: Option<Rolling>,
    #[serde(flatten)]
    summary: Summary,
    /// Of the part that the means are of.
    operation: Quantities,
    /// Of what came before it.
    #[serde(rename = "start_transient")]
    start: Quantities,
    /// Integrated over the samples of the balls.
    ball_wear: Vec<BallWear>,
    /// Every value of the case.
    case_values: Vec<CaseValue>,
    /// Of the solution from which the run started.
    warnings_at_start: Vec<String>,
    /// Races whose pressures left the range in which the coating was tested.
    untested_pressures: Vec<String>,
    /// The figures of `--against` beside those of the run.
    validation: Vec<Compared>,
    figures: Vec<String>,
    /// Figures that could not be made, and why.
    notes: Vec<String>,
}

impl Answer {
    /// Error of the accelerations, rms, m/s², where the recording says it.
    fn acceleration_error(&self) -> Option<f64> {
        self.outcome.and_then(|outcome| outcome.acceleration_error_m_s2)
    }
}

/// A recording, evaluated.
pub(crate) struct Evaluated {
    run: Run,
    case: Option<CaseFile>,
    kind: Kind,
    figures: Vec<Figure>,
    /// Data of the interactive figures.
    live: Live,
}

/// Kind of a recording, with its numbers.
pub(crate) enum Kind {
    Run(Box<Answer>),
    Solution(Box<SolutionAnswer>),
}

/// Writes figures, spectra and a summary of a recorded run or solution into a folder: `report.html`, `summary.md`,
/// `summary.json`, `foxglove-layout.json` and the figures as SVG and PNG. With a second recording: what they differ in.
///
/// # Errors
/// [`ReportError`]; then nothing is written.
pub fn report(
    (recording, other): (&Path, Option<&Path>),
    output: &Path,
    options: ReportOptions<'_>,
    limits: &Limits,
) -> Result<Report, ReportError> {
    let (summary, content, figures, live, layout) = match (other, options.against) {
        (Some(_), Some(path)) => {
            let message = "figures are set beside one recording, not beside two";
            return Err(StudyError::from(AnswerError::argument("against", path.display(), message)).into());
        }
        (Some(other), None) => {
            let both = (Evaluated::read(recording, limits)?, Evaluated::read(other, limits)?);
            let (answer, content, figures) = compare::compared(&both.0, &both.1)?;
            (serde_json::to_value(&answer)?, content, figures, Live::default(), None)
        }
        (None, against) => {
            let mut evaluated = Evaluated::read(recording, limits)?;
            let (answer, content) = evaluated.say(against, limits)?;
            (answer, content, evaluated.figures, evaluated.live, evaluated.run.layout_text)
        }
    };
    let mut staged = StagedFiles::new(output, options.force)?;
    staged.write(PAGE.to_owned(), html::page(&content, &figures, &live)?.as_bytes())?;
    staged.write("summary.md".to_owned(), markdown::page(&content, &figures).as_bytes())?;
    staged.write("summary.json".to_owned(), format!("{}\n", serde_json::to_string_pretty(&summary)?).as_bytes())?;
    if let Some(layout) = layout {
        staged.write("foxglove-layout.json".to_owned(), layout.as_bytes())?;
    }
    figures.iter().try_for_each(|figure| stage(&mut staged, figure))?;
    staged.publish()?;
    Ok(Report { summary, text: markdown::plain(&content), page: output.join(PAGE) })
}

/// Name of the page.
const PAGE: &str = "report.html";

/// Writes a figure as SVG and PNG, which get their names with the other files.
///
/// # Errors
/// A figure that cannot be drawn, a file that cannot be written.
pub fn stage(staged: &mut StagedFiles, figure: &Figure) -> Result<(), ReportError> {
    staged.write(format!("{}.svg", figure.name), figure.svg().as_bytes())?;
    Ok(staged.write(format!("{}.png", figure.name), &figure.png(PNG_WIDTH)?)?)
}

impl Evaluated {
    /// Reads and evaluates a recording; one that is neither of a run nor of a solution is refused.
    fn read(path: &Path, limits: &Limits) -> Result<Self, ReportError> {
        let foreign = |source| StudyError::NoRecording { source: Box::new(source) };
        let run = match read_recording_within(path, limits.recording_bytes) {
            Err(RecordError::NothingToRecover { .. }) => return Err(StudyError::NoRun { path: path.to_owned() }.into()),
            Err(
                error @ (RecordError::NotMcap { .. }
                | RecordError::OnlyBegun { .. }
                | RecordError::File { action: "open", .. }),
            ) => {
                return Err(foreign(error).into());
            }
            read => read?,
        };
        // A damaged or older file may lack its case, or hold one that is refused now: the numbers are there all the
        // same.
        let name = path.display().to_string();
        let case = run.case_text.as_ref().and_then(|text| CaseFile::from_text(&name, text.clone(), &[], limits).ok());
        let case_values = case.as_ref().map_or_else(Vec::new, |file| values::all(&file.text, &file.case));
        let no_run = || StudyError::NoRun { path: path.to_owned() };
        let (kind, figures, live) = match (&run.solution, run.states.is_empty()) {
            (Some(_), false) => return Err(StudyError::Mixed { path: path.to_owned() }.into()),
            (Some(row), true) if run.balls.is_empty() || row.cage_speed_rpm == 0.0 => return Err(no_run().into()),
            (Some(row), true) => {
                let (mut answer, figures) = solution::evaluate(path, &run, row, (case.as_ref(), case_values))?;
                answer.notes.extend(no_case(case.is_none()));
                (Kind::Solution(Box::new(answer)), figures, Live::default())
            }
            (None, _) => {
                let summary = Summary::of(&run.states, run.wear.last(), &run.events).ok_or_else(no_run)?;
                let (answer, figures, live) = evaluate(path, &run, summary, (case.as_ref(), case_values))?;
                (Kind::Run(Box::new(answer)), figures, live)
            }
        };
        Ok(Self { run, case, kind, figures, live })
    }

    /// The report of this recording alone.
    fn say(&mut self, against: Option<&Path>, limits: &Limits) -> Result<(serde_json::Value, Content), ReportError> {
        let case = self.case.as_ref();
        match &mut self.kind {
            Kind::Run(answer) => {
                if let Some(path) = against {
                    answer.validation = compared(path, &serde_json::to_value(&*answer)?, limits)?;
                }
                Ok((serde_json::to_value(&*answer)?, Content::of_run(answer, case, &self.run)))
            }
            Kind::Solution(answer) => {
                let value = serde_json::to_value(&*answer)?;
                let mut content = solution::content(answer, case, &self.run);
                if let Some(path) = against {
                    content.tables.insert(0, tables::validation(&compared(path, &value, limits)?));
                }
                Ok((value, content))
            }
        }
    }
}

fn no_case(missing: bool) -> Option<String> {
    missing.then(|| "The recording has no readable case: its values are missing here.".to_owned())
}

fn evaluate(
    path: &Path,
    run: &Run,
    summary: Summary,
    (case, case_values): (Option<&CaseFile>, Vec<CaseValue>),
) -> Result<(Answer, Vec<Figure>, Live), ReportError> {
    let summary = case.iter().fold(summary, |summary, file| summary.judged(&file.case));
    let (known, outcome) = (KnownAtStart::read(run), KnownAtEnd::read(run));
    let from_s = summary.averaged_from_s;
    let speeds = facts::ring_speeds(run, from_s);
    let frequencies = facts::frequencies(run, from_s, summary.cage_speed_mean_rpm * TAU / 60.0, speeds)?;
    let operation = quantities::of_run(run, from_s, facts::ball_radius_m(run));
    let ball_wear = facts::ball_wear(&run.balls);
    let mut notes: Vec<String> = no_case(case.is_none()).into_iter().collect();
    let mut live = Live::default();
    let mut figures: Vec<Figure> = figures::bearing(run, figures::load(run)).into_iter().collect();
    let error_m_s2 = outcome.and_then(|outcome| outcome.acceleration_error_m_s2);
    figures.extend(figures::histories(run, &summary, error_m_s2, &mut live)?);
    figures.extend(spectra::figures(run, (&summary, error_m_s2), &frequencies, &mut notes, &mut live)?);
    figures.extend(orbit::figures(run, &mut notes, &mut live)?);
    figures.extend(figures::balances(&summary, &ball_wear)?);
    let said = |key: &str| said(run, key).unwrap_or_default().to_owned();
    let answer = Answer {
        recording: path.to_owned(),
        bearing: said("bearing"),
        generator: said("generator"),
        damage: run.damage,
        duration_s: facts::said(run, "duration_s").and_then(|text| text.parse().ok()),
        accelerations_supported: carries_accelerations(&summary, &known, outcome.as_ref()),
        outcome,
        rolling: facts::rolling(run, &operation, speeds),
        frequencies,
        summary,
        operation,
        start: quantities::of_start(run, from_s),
        ball_wear,
        case_values,
        warnings_at_start: known.warnings_at_start.clone(),
        known,
        untested_pressures: case.map_or_else(Vec::new, |file| facts::untested(&file.case, run)),
        validation: Vec::new(),
        figures: figures.iter().map(|figure| figure.name.clone()).collect(),
        notes,
    };
    Ok((answer, figures, live))
}
