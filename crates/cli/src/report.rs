//! `tribodyn report`: figures, spectra and a summary of a recorded run or solution, or what two of them differ in.

use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments};
use crate::table;
use std::path::PathBuf;
use tribodyn_report::{ReportOptions, report};

/// Make figures, spectra and a summary of a recorded run or solution, or compare two recordings.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn report run.mcap -o report
  tribodyn report before.mcap after.mcap -o difference")]
pub struct Arguments {
    /// Recording of `run` or `solve -o`, complete or not: RUN.mcap or RUN.mcap.active. Two are compared
    #[arg(value_name = "RUN.mcap", required = true, num_args = 1..=2)]
    recordings: Vec<PathBuf>,
    /// Folder for report.html, summary.md, summary.json, foxglove-layout.json and the figures (SVG and PNG)
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Compare a run with published or measured figures: a CSV file with the columns
    /// id,quantity,published,tolerance,source; a quantity is a field of summary.json
    #[arg(long, value_name = "FIGURES.csv")]
    against: Option<PathBuf>,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let options = ReportOptions { against: arguments.against.as_deref(), force: arguments.replace.force };
    // Clap has seen to it that there are one or two.
    let recordings = (arguments.recordings[0].as_path(), arguments.recordings.get(1).map(PathBuf::as_path));
    let made = report(recordings, &arguments.output, options, &arguments.limits.limits())?;
    if arguments.json {
        return table::print_json(&made.summary);
    }
    table::print_line(&made.text)?;
    table::print_line(&format!("report: {}", made.page.display()))
}
