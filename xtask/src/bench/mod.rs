//! `cargo xtask bench`: what the kernels, the transient schemes, the quasi-static solver and ensembles of runs cost,
//! and what the fast scheme gets wrong for it.
//!
//! Times are processor time of the thread that works, the least of several repetitions; what is to be compared runs in
//! turn in one process. Rows over several threads are wall time and say so.

mod accuracy;
mod catalogue;
mod clock;
mod document;
mod ensemble;
mod equilibrium;
pub mod instructions;
mod oil;
mod orbit;
mod patch;
mod peers;
mod row;
mod speed;

use crate::error::Failure;
use crate::terminal::print;
use row::Row;
use serde::Serialize;
use std::process::Command;
use tribodyn::{CaseFile, Change, Limits};
use tribodyn_dynamics::Run;
use tribodyn_paper::{files, table};
use tribodyn_study::run::start_run;

/// The case on which everything is measured.
const CASE: &str = "fixtures/cases/paper-ag.ron";

/// Options of `cargo xtask bench`.
#[derive(Debug, Clone, Copy, clap::Args)]
pub struct Arguments {
    /// Print JSON instead of a table
    #[arg(long)]
    json: bool,
    /// Fewer repetitions and shorter runs
    #[arg(long)]
    quick: bool,
    /// Rewrite the table in docs/performance.md
    #[arg(long)]
    write: bool,
    /// Also run another program, in turn with ours: Exudyn, from the Python package index
    #[arg(long)]
    peers: bool,
}

/// Everything measured.
#[derive(Debug, Serialize)]
struct Report {
    machine: Machine,
    case: &'static str,
    rows: Vec<Row>,
}

/// The machine of the measurement.
#[derive(Debug, Serialize)]
struct Machine {
    processor: String,
    threads: usize,
    rustc: String,
    profile: &'static str,
    /// Processes waiting per thread, the mean of the last minute; none where the system does not tell.
    load: Option<f64>,
}

/// Measures and prints.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let text = files::read(&files::root().join(CASE))?;
    let quick = arguments.quick;
    let mut rows = patch::rows(quick)?;
    rows.extend(instructions::rows()?);
    rows.extend(speed::rows(&text, quick)?);
    rows.extend(catalogue::rows(quick)?);
    rows.extend(accuracy::rows(&text, quick)?);
    rows.extend(equilibrium::rows(&text, quick)?);
    rows.extend(orbit::rows(&text, quick)?);
    rows.extend(oil::rows(quick)?);
    rows.extend(ensemble::rows(&text, quick)?);
    if arguments.peers {
        rows.extend(peers::rows(&text, quick)?);
    }
    let report = Report { machine: machine(), case: CASE, rows };
    let mut out = if arguments.json {
        serde_json::to_string_pretty(&report)?
    } else {
        format!("{}\n\n{}", report.machine.line(), table::aligned(&row::HEAD, &row::cells(&report.rows)))
    };
    out.push('\n');
    print(&out)?;
    if arguments.write { document::rewrite(&report) } else { Ok(()) }
}

fn refused(error: &dyn std::fmt::Display) -> Failure {
    Failure::Check { what: "bench", findings: vec![error.to_string()] }
}

/// The case with some of its values replaced.
fn changed<V: AsRef<str>>(text: &str, changes: &[(&str, V)]) -> Result<CaseFile, Failure> {
    let changes: Vec<_> =
        changes.iter().map(|(path, value)| Change::new("bench".to_owned(), path, value.as_ref())).collect();
    CaseFile::from_text("bench", text.to_owned(), &changes, &Limits::default()).map_err(|error| refused(&error))
}

/// The run of the case with changes at its start, as the command begins it.
fn started<V: AsRef<str>>(text: &str, changes: &[(&str, V)]) -> Result<Run, Failure> {
    let (run, _) = start_run(&changed(text, changes)?).map_err(|error| refused(&error))?;
    Ok(run)
}

fn machine() -> Machine {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let info = read("/proc/cpuinfo");
    let model = info.lines().find(|line| line.starts_with("model name")).and_then(|line| line.split_once(':'));
    let rustc = Command::new("rustc").arg("--version").output();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let load = read("/proc/loadavg").split(' ').next().and_then(|first| first.parse::<f64>().ok());
    Machine {
        processor: model.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned()),
        threads,
        rustc: rustc
            .map_or_else(|_| "rustc unknown".to_owned(), |o| String::from_utf8_lossy(&o.stdout).trim().to_owned()),
        profile: if cfg!(debug_assertions) { "development" } else { "release" },
        load: load.map(|load| load / threads as f64),
    }
}

impl Machine {
    fn line(&self) -> String {
        let Self { processor, threads, rustc, profile, load } = self;
        let load = load.map_or_else(String::new, |load| format!(", load {load:.1} per thread"));
        format!("{processor}, {threads} threads, {rustc}, profile {profile}{load}")
    }
}
