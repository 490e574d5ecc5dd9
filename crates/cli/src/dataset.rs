//! `tribodyn dataset`: vibration signals with labels, from a plan.

use crate::failure::Failure;
use crate::input::{ReplaceArguments, pool};
use crate::run::stop_flag;
use crate::table::{number, print_json, print_line, print_pairs};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use tribodyn::Limits;
use tribodyn_study::Ours;
use tribodyn_study::dataset::{Dataset, DatasetReport, TABLE};

/// Simulate bearings with and without spalls under several loads and speeds, and write what sensors on the housing see:
/// a row a member in Parquet, with class, spall and loads, and the times at which each ball was over each edge.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn dataset fixtures/datasets/6206.ron -o set")]
pub struct Arguments {
    /// Plan of the data set (RON)
    plan: PathBuf,
    /// Folder to write. The same command continues a stopped set
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Write a MATLAB file (level 5) for each member too
    #[arg(long)]
    mat: bool,
    /// Threads to use [default: one per core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Discard the finished members of a stopped set
    #[arg(long)]
    restart: bool,
    #[command(flatten)]
    replace: ReplaceArguments,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let pool = pool(arguments.threads)?;
    let dataset = Dataset::read(&arguments.plan, &Limits::NORMAL)?;
    let table = arguments.output.join(TABLE);
    arguments.replace.check(&table, &arguments.plan, Ours::Table)?;
    let stop = stop_flag()?;
    let bar = if arguments.quiet { ProgressBar::hidden() } else { ProgressBar::new(dataset.members() as u64) };
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} members, {eta} left") {
        bar.set_style(style);
    }
    let choices = (arguments.mat, arguments.restart);
    let report = pool.install(|| dataset.make(&arguments.output, choices, &stop, |count| bar.inc(count as u64)));
    bar.finish_and_clear();
    let report = report?;
    let (finished, members, failed) = (report.finished, report.members, report.failed);
    if arguments.json {
        print_json(&report)?
    } else {
        print(&report)?
    }
    if let Some(first) = &report.first_warnings {
        let (warned, column) = (report.warned, table.display());
        let text = format!("warning: {warned} of {finished} members warn, see `warnings` in {column}; first: {first}");
        let _ = writeln!(std::io::stderr(), "{}", crate::harmless::harmless(&text));
    }
    match failed {
        _ if finished < members => Err(Failure::EnsembleStopped { finished, members, table: Some(table) }),
        0 => Ok(()),
        failed => Err(Failure::FailedMembers { failed, members }),
    }
}

fn print(r: &DatasetReport) -> Result<(), Failure> {
    let mut rows = vec![
        ("members", r.members.to_string(), ""),
        ("bearings for training", r.bearings_train.to_string(), ""),
        ("bearings for tests", r.bearings_test.to_string(), ""),
        ("members without a signal", r.failed.to_string(), ""),
        ("members with warnings", r.warned.to_string(), ""),
        ("run now", r.run.to_string(), ""),
        ("wall time", number(r.wall_s, 1), "s"),
        ("threads", r.threads.to_string(), ""),
    ];
    rows.extend(r.members_per_s_and_thread.map(|rate| ("members a second and thread", number(rate, 3), "")));
    print_pairs(&rows)?;
    if let Some(why) = &r.first_failure {
        print_line(&format!("first member without a signal: {why}"))?;
    }
    for path in r.table.iter().chain(&r.mat) {
        print_line(&format!("written: {}", path.display()))?;
    }
    Ok(())
}
