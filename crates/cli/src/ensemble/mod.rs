//! `tribodyn ensemble`: transient runs with values drawn at random.

mod figures;
mod outcome;

use crate::failure::Failure;
use crate::input::{CaseArguments, ReplaceArguments, pool};
use crate::run::stop_flag;
use crate::table::print_json;
use crate::units::in_unit;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use tribodyn_study::ensemble::{Ensemble, EnsembleOptions, EnsembleReport, EnsembleTable, Outcome, Sampling, Spread};
use tribodyn_study::sweep::Format;
use tribodyn_study::{Ours, StagedFiles};

/// Simulate a bearing in time many times, with values of the case drawn at random, and give the quantiles of what comes
/// of it. Nothing is recorded: `tribodyn run` with the values of a row makes the recording of that member.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn ensemble 7210B.ron --vary 'cage.pocket_gap=mm(0.1 ± 0.02)' --members 16 --duration 0.02")]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Draw a value of the case for each member: mm(0.2 ± 0.02), or mm(0.2 +- 0.02), from a normal distribution with
    /// that standard deviation, mm(0.18..0.22) evenly from a range; may be repeated
    #[arg(long = "vary", value_name = "PATH=SPREAD", value_parser = spread, required_unless_present = "grid")]
    spreads: Vec<Spread>,
    /// Run a member for each combination of these values instead of drawing, such as 'defects[0].depth=um(0..20 in 5)';
    /// may be repeated. Figures are over the first
    #[arg(long, value_name = "PATH=VALUES", value_parser = each, conflicts_with_all = ["spreads", "members", "latin_hypercube"])]
    grid: Vec<Spread>,
    /// Number of members
    #[arg(long, value_name = "N", required_unless_present = "grid")]
    members: Option<usize>,
    /// Seed of the draws: seed and number of a member give the same values on every machine
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Draw by Latin hypercube: one member in each of equally likely parts of every spread, so that quantiles scatter
    /// less
    #[arg(long)]
    latin_hypercube: bool,
    /// Simulated time of each member in s; short for --set transient.duration=s(…)
    #[arg(long, value_name = "SECONDS", value_parser = in_unit("s"))]
    duration: Option<f64>,
    /// Threads to use [default: one per core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Table to write, .parquet or .csv by its name: a row for each member. The same command continues a stopped one
    #[arg(short, long, value_name = "TABLE")]
    output: Option<PathBuf>,
    /// Discard the finished members of a stopped ensemble
    #[arg(long, requires = "output")]
    restart: bool,
    /// Write figures of the distributions (SVG and PNG) to this folder
    #[arg(long, value_name = "DIR")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
}

fn spread(text: &str) -> Result<Spread, String> {
    Ok(Spread::parse(text)?.prefixed("--vary "))
}

fn each(text: &str) -> Result<Spread, String> {
    Ok(Spread::each(text)?.prefixed("--grid "))
}

/// The answer with the files that were written.
#[derive(Serialize)]
struct Answer {
    #[serde(flatten)]
    report: EnsembleReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    output: Option<PathBuf>,
    /// Folder of the figures.
    #[serde(skip_serializing_if = "Option::is_none")]
    plot: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let pool = pool(arguments.threads)?;
    arguments.output.as_deref().map(Format::of).transpose()?;
    let ensemble = arguments.ensemble()?;
    if let Some(path) = &arguments.output {
        arguments.replace.check(path, &arguments.case.path, Ours::Table)?;
    }
    // Who else writes the table, and where no figures can be, is told now and not after hours.
    let mut table = arguments.output.as_deref().map(|path| ensemble.table(path, arguments.restart)).transpose()?;
    let plots =
        arguments.plot.as_deref().map(|folder| StagedFiles::new(folder, arguments.replace.force)).transpose()?;
    let stop = stop_flag()?;
    let outcome = members(arguments, (&ensemble, table.as_mut()), &pool, &stop)?;
    let finished = outcome.members.len();
    let stopped = || {
        let table = arguments.output.clone();
        Failure::EnsembleStopped { finished, members: ensemble.members(), table }
    };
    if finished == 0 {
        return Err(stopped());
    }
    // A figure that fails takes no table with it.
    table.map_or(Ok(()), |table| table.write(&outcome.members))?;
    if let Some(mut staged) = plots {
        figures::draw(&mut staged, &ensemble, &outcome)?;
        staged.publish()?;
    }
    let report = ensemble.report(&outcome);
    let failed = report.failed;
    let answer = Answer { report, output: arguments.output.clone(), plot: arguments.plot.clone() };
    if arguments.json {
        print_json(&answer)?
    } else {
        outcome::print(&answer)?
    }
    match failed {
        _ if finished < ensemble.members() => Err(stopped()),
        0 => Ok(()),
        failed => Err(Failure::FailedMembers { failed, members: finished }),
    }
}

impl Arguments {
    fn ensemble(&self) -> Result<Ensemble, Failure> {
        let (sampling, spreads) = match self.latin_hypercube {
            _ if !self.grid.is_empty() => (Sampling::Grid, &self.grid),
            true => (Sampling::LatinHypercube, &self.spreads),
            false => (Sampling::Independent, &self.spreads),
        };
        let options = EnsembleOptions { members: self.members.unwrap_or(1), seed: self.seed, sampling };
        let (fixed, limits) = (self.case.run_changes(self.duration)?, self.case.limits());
        let text = tribodyn_study::read_text(&self.case.path, &limits)?;
        let name = self.case.path.display().to_string();
        Ok(Ensemble::new((&name, text), &fixed, spreads, options, &limits)?)
    }
}

/// Runs the members on a pool, with a bar that shows how many are finished.
fn members(
    arguments: &Arguments,
    (ensemble, table): (&Ensemble, Option<&mut EnsembleTable<'_>>),
    pool: &rayon::ThreadPool,
    stop: &AtomicBool,
) -> Result<Outcome, Failure> {
    let bar = if arguments.quiet { ProgressBar::hidden() } else { ProgressBar::new(ensemble.members() as u64) };
    bar.set_position(table.as_ref().map_or(0, |table| table.resumed() as u64));
    bar.reset_eta();
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} members, {eta} left") {
        bar.set_style(style);
    }
    bar.tick();
    let outcome = pool.install(|| match table {
        Some(table) => table.run(stop, |_| bar.inc(1)),
        None => Ok(ensemble.run(stop, |_| bar.inc(1))),
    });
    bar.finish_and_clear();
    Ok(outcome?)
}
