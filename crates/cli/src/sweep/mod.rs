//! `tribodyn sweep`: equilibria, or steady orbits, over a grid of case values.

mod figures;
mod long;
mod plan;

use crate::failure::Failure;
use crate::input::{LimitArguments, ReplaceArguments, pool};
use crate::search::TimeArguments;
use crate::solve::ModelName;
use crate::table::{number, print_json, print_line, print_pairs};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tribodyn_study::sweep::{Format, Grid, Merged, Options, Plan, Setting, Shard, Sweep, merge};
use tribodyn_study::{Ours, StagedFiles, read_text};

/// Solve the equilibrium, or the steady orbit, for every combination of case values.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn sweep 7210B.ron --set 'ring.z.Force=kN(1..6 by 1)' -o table.parquet
  tribodyn sweep 7210B.ron --set 'speed.inner.Constant=rpm(1000..9000 in 17)' -o speed.csv --plot figures")]
pub struct Arguments {
    /// Case file (RON)
    #[arg(value_name = "CASE", required_unless_present = "merge")]
    case: Option<PathBuf>,
    /// Values of one path of the case: kN(10),kN(20) or kN(10..60 by 5), kN(10..60 in 11), kN(1..100 log 21); several
    /// options give every combination, the last varying fastest
    #[arg(long = "set", value_name = "PATH=VALUES", value_parser = setting)]
    settings: Vec<Setting>,
    /// Table to write, .parquet or .csv by its name
    #[arg(short, long, value_name = "TABLE", required_unless_present = "plan")]
    output: Option<PathBuf>,
    #[command(flatten)]
    replace: ReplaceArguments,
    #[command(flatten)]
    limits: LimitArguments,
    /// Solve only part I of N (from 0), for several machines
    #[arg(long, value_name = "I/N", value_parser = Shard::parse, default_value_t = Shard::ALL)]
    shard: Shard,
    /// Merge the tables of all shards into one, in the order of the sweep
    #[arg(long, value_name = "TABLE", num_args = 1.., requires = "output",
          conflicts_with_all = ["case", "settings", "shard", "model", "threads", "cold", "restart", "plot", "plan"])]
    merge: Vec<PathBuf>,
    /// Equations to solve
    #[arg(long, value_enum, default_value_t)]
    model: ModelName,
    #[command(flatten)]
    time: TimeArguments,
    /// Threads to use [default: one per core]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Solve every row from its own initial guess instead of a neighbour's solution (several times slower)
    #[arg(long)]
    cold: bool,
    /// Discard the finished rows of a stopped sweep
    #[arg(long)]
    restart: bool,
    /// Write figures of the rows (SVG and PNG) to this folder: curves over one swept value, maps over two
    #[arg(long, value_name = "DIR")]
    plot: Option<PathBuf>,
    /// Print the plan and an estimate of the time, and write nothing
    #[arg(long)]
    plan: bool,
    /// Allow a sweep of more than ten million rows, or of an estimated day or more
    #[arg(long)]
    yes: bool,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
    /// Print the summary as JSON
    #[arg(long)]
    json: bool,
}

fn setting(text: &str) -> Result<Setting, String> {
    Ok(Setting::parse(text)?.prefixed("--set "))
}

/// Summary of a sweep.
#[derive(Serialize)]
struct Summary {
    output: PathBuf,
    /// Folder of the figures.
    #[serde(skip_serializing_if = "Option::is_none")]
    plot: Option<PathBuf>,
    /// Rows of the whole grid.
    grid_rows: usize,
    /// Rows of the table: those of the shard.
    rows: usize,
    /// Rows that an earlier run had finished.
    resumed_rows: usize,
    failed_rows: usize,
    /// Rows that name what no bearing does.
    implausible_rows: usize,
    time_s: f64,
    rows_per_s: f64,
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match (&arguments.case, &arguments.output) {
        (None, Some(output)) => put_together(arguments, output),
        // Without a case there are tables to put together, and for those a table to write.
        (case, _) => solve(arguments, case.as_deref().unwrap_or(Path::new(""))),
    }
}

/// The whole table from those of the shards.
fn put_together(arguments: &Arguments, output: &Path) -> Result<(), Failure> {
    arguments.replace.check(output, Path::new(""), Ours::Table)?;
    let merged = merge(&arguments.merge, output, arguments.replace.force)?;
    if arguments.json {
        let Merged { tables, rows, failed, implausible } = merged;
        return print_json(&serde_json::json!({
            "output": output, "tables": tables, "rows": rows, "failed_rows": failed, "implausible_rows": implausible,
        }));
    }
    print_pairs(&[
        ("tables", merged.tables.to_string(), ""),
        ("rows", merged.rows.to_string(), ""),
        ("without solution", merged.failed.to_string(), ""),
        ("implausible", merged.implausible.to_string(), ""),
    ])?;
    print_line(&format!("\n{} is written", output.display()))
}

fn solve(arguments: &Arguments, case: &Path) -> Result<(), Failure> {
    let pool = pool(arguments.threads)?;
    arguments.output.as_deref().map(Format::of).transpose()?;
    let limits = arguments.limits.limits();
    let text = read_text(case, &limits)?;
    let (name, model) = (case.display().to_string(), arguments.model.equations());
    let mut grid = pool.install(|| Grid::new(&name, text, &arguments.settings, (model, &limits)))?;
    grid.time_limit_s = arguments.time.limit_s;
    if let Some(path) = &arguments.output {
        arguments.replace.check(path, case, Ours::Table)?;
    }
    arguments.plot.as_ref().map_or(Ok(()), |_| figures::check(&grid))?;
    let plan = || Plan::new(&grid, arguments.shard, arguments.cold, pool.current_num_threads());
    match &arguments.output {
        Some(path) if !arguments.plan => {
            // One that was begun and stopped has been asked about.
            let begun = Path::new(&format!("{}.rows", path.display())).exists();
            if !arguments.yes && !begun {
                long::check(grid.rows, || plan().estimated_time_s)?;
            }
            sweep(arguments, &grid, path.clone(), &pool)
        }
        _ => plan::print(&plan(), arguments.json),
    }
}

fn sweep(arguments: &Arguments, grid: &Grid, table: PathBuf, pool: &rayon::ThreadPool) -> Result<(), Failure> {
    let began = Instant::now();
    let Arguments { shard, cold, restart, .. } = *arguments;
    let mut sweep = Sweep::open(grid, &Options { table: table.clone(), shard, cold, restart })?;
    let resumed = sweep.finished_rows();
    let progress = if arguments.quiet { ProgressBar::hidden() } else { progress_bar(sweep.row_count(), resumed) };
    let solved = pool.install(|| {
        sweep.solve(|rows| {
            progress.inc(rows as u64);
            ControlFlow::Continue(())
        })
    });
    progress.finish_and_clear();
    solved?;
    let plots = arguments
        .plot
        .as_ref()
        .map(|folder| figures::stage(folder, arguments.replace.force, grid, &sweep.rows()))
        .transpose()?;
    let count = sweep.write_table()?;
    plots.map_or(Ok(()), StagedFiles::publish)?;
    sweep.forget_rows()?;
    let time_s = began.elapsed().as_secs_f64();
    let summary = Summary {
        output: table.clone(),
        plot: arguments.plot.clone(),
        grid_rows: grid.rows,
        rows: count.rows,
        resumed_rows: resumed,
        failed_rows: count.failed,
        implausible_rows: count.implausible,
        time_s,
        rows_per_s: (count.rows - resumed) as f64 / time_s,
    };
    if arguments.json {
        print_json(&summary)?
    } else {
        print(&summary)?;
        if let Some(warning) = count.warning(grid.model) {
            print_line(&format!("warning: {warning}"))?;
        }
    }
    match count.failed {
        0 => Ok(()),
        failed => Err(Failure::Unsolved { failed, rows: count.rows, path: table }),
    }
}

/// On standard error; it hides itself where that is no terminal.
fn progress_bar(rows: usize, resumed: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} rows, {per_sec}, {eta} left");
    let bar = ProgressBar::new(rows as u64).with_position(resumed as u64);
    bar.reset_eta();
    if let Ok(style) = style { bar.with_style(style) } else { bar }
}

fn print(summary: &Summary) -> Result<(), Failure> {
    let mut rows = vec![("rows", summary.rows.to_string(), "")];
    if summary.resumed_rows > 0 {
        rows.push(("of an earlier run", summary.resumed_rows.to_string(), ""));
    }
    rows.push(("without solution", summary.failed_rows.to_string(), ""));
    if summary.implausible_rows > 0 {
        rows.push(("implausible", summary.implausible_rows.to_string(), ""));
    }
    rows.push(("time", number(summary.time_s, 1), "s"));
    rows.push(("rate", number(summary.rows_per_s, 0), "rows/s"));
    print_pairs(&rows)?;
    let plot = summary.plot.as_ref().map_or(String::new(), |folder| format!(", figures are in {}", folder.display()));
    print_line(&format!("\n{} is written{plot}", summary.output.display()))
}
