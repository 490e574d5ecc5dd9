//! `tribodyn report`: figures, spectra and a summary of a recorded run.

mod against;
mod content;
mod facts;
mod figures;
mod html;
mod live;
mod markdown;
mod orbit;
mod spectra;

use crate::failure::Failure;
use crate::input::CaseFile;
use crate::output::StagedFiles;
use crate::run::{RunError, Summary, carries_accelerations};
use crate::table;
use against::{Compared, compared};
use content::Content;
use facts::{BallWear, Start};
use live::Live;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_plot::Figure;
use tribodyn_record::{RecordError, Run, read_run};
use tribodyn_signal::BearingFrequencies;

/// Make figures, spectra and a summary of a recorded run.
#[derive(clap::Args)]
pub struct Arguments {
    /// Recording, whole or not: RUN.mcap or RUN.mcap.active
    #[arg(value_name = "RUN.mcap")]
    recording: PathBuf,
    /// Folder for report.html, summary.md, summary.json, foxglove-layout.json and the figures (SVG and PNG)
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Published or measured figures to set beside those of the run: a CSV file with the columns
    /// id,quantity,published,tolerance,source; a quantity is a field of summary.json
    #[arg(long, value_name = "FIGURES.csv")]
    against: Option<PathBuf>,
    /// Print the summary as JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

/// What `summary.json` and `--json` say.
#[derive(Debug, Serialize)]
pub struct Answer {
    recording: PathBuf,
    bearing: String,
    generator: String,
    /// The file ends before its end mark: the run was killed or is still going on.
    truncated: bool,
    chunks_bad: u64,
    cage_speed_quasi_static_rpm: Option<f64>,
    patch_error_estimate: Option<f64>,
    /// Whether that error is small enough for accelerations.
    accelerations_supported: bool,
    frequencies: BearingFrequencies,
    #[serde(flatten)]
    summary: Summary,
    /// Integrated over the samples of the balls.
    ball_wear: Vec<BallWear>,
    /// Of the quasi-static solution of the same case.
    warnings_at_start: Vec<String>,
    /// Races whose pressures left the range in which the coating was tested.
    untested_pressures: Vec<String>,
    /// The figures of `--against` beside those of the run.
    validation: Vec<Compared>,
    figures: Vec<String>,
    /// Figures that could not be made, and why.
    notes: Vec<String>,
}

/// Wide enough for a page at 200 dots per inch.
const PNG_WIDTH: u32 = 1600;

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let no_run = || RunError::NoRun { path: arguments.recording.clone() };
    let run = match read_run(&arguments.recording) {
        Err(RecordError::NothingToRecover { .. }) => return Err(no_run().into()),
        read => read?,
    };
    let summary = Summary::of(&run.states, run.wear.last(), &run.events).ok_or_else(no_run)?;
    let (mut answer, case, figures, live) = evaluate(&arguments.recording, &run, summary)?;
    if let Some(path) = &arguments.against {
        answer.validation = compared(path, &serde_json::to_value(&answer)?)?;
    }
    let content = Content::new(&answer, case.as_ref(), &run);
    let mut staged = StagedFiles::new(&arguments.output)?;
    staged.write("report.html".to_owned(), html::page(&content, &figures, &live)?.as_bytes())?;
    staged.write("summary.md".to_owned(), markdown::page(&content, &figures).as_bytes())?;
    staged.write("summary.json".to_owned(), format!("{}\n", serde_json::to_string_pretty(&answer)?).as_bytes())?;
    if let Some(layout) = &run.layout_text {
        staged.write("foxglove-layout.json".to_owned(), layout.as_bytes())?;
    }
    for figure in &figures {
        staged.write(format!("{}.svg", figure.name), figure.svg().as_bytes())?;
        staged.write(format!("{}.png", figure.name), &figure.png(PNG_WIDTH)?)?;
    }
    staged.publish()?;
    if arguments.json {
        return table::print_json(&answer);
    }
    table::print_line(&markdown::plain(&content))?;
    table::print_line(&format!("report: {}", arguments.output.join("report.html").display()))
}

type Evaluated = (Answer, Option<CaseFile>, Vec<Figure>, Live);

fn evaluate(path: &Path, run: &Run, summary: Summary) -> Result<Evaluated, Failure> {
    // A damaged or older file may lack its case, or hold one that is refused now: the numbers are there all the same.
    let name = path.display().to_string();
    let case = run.case_text.as_ref().and_then(|text| CaseFile::from_text(&name, text.clone(), &[]).ok());
    let summary = case.iter().fold(summary, |summary, file| summary.judged(&file.case));
    let start = case.as_ref().map_or_else(Start::default, Start::of);
    let frequencies = facts::frequencies(run, &summary)?;
    let ball_wear = facts::ball_wear(&run.balls);
    let mut notes = Vec::new();
    if case.is_none() {
        notes.push("The recording has no readable case: its values and the start are missing here.".to_owned());
    }
    let mut live = Live::default();
    let mut figures = figures::histories(run, &summary, &mut live)?;
    figures.extend(spectra::figures(run, &summary, &frequencies, &mut notes, &mut live)?);
    figures.extend(orbit::figures(run, &mut notes, &mut live)?);
    figures.extend(figures::balances(&summary, &ball_wear)?);
    let simulation = run.metadata.get("simulation");
    let said = |key: &str| simulation.and_then(|entries| entries.get(key)).cloned().unwrap_or_default();
    let answer = Answer {
        recording: path.to_owned(),
        bearing: said("bearing"),
        generator: said("generator"),
        truncated: run.truncated,
        chunks_bad: run.chunks_bad,
        cage_speed_quasi_static_rpm: start.cage_speed_rpm,
        patch_error_estimate: start.patch_error_estimate,
        accelerations_supported: carries_accelerations(start.patch_error_estimate),
        frequencies,
        summary,
        ball_wear,
        warnings_at_start: start.warnings,
        untested_pressures: case.as_ref().map_or_else(Vec::new, |file| facts::untested(&file.case, run)),
        validation: Vec::new(),
        figures: figures.iter().map(|figure| figure.name.clone()).collect(),
        notes,
    };
    Ok((answer, case, figures, live))
}
