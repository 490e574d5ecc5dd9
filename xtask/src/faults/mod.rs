//! `cargo xtask faults`: what the command survives, tried many times with what a machine and its users do to it:
//! kills, stops, full disks, folders without permission, two commands at once, clocks that jump, damaged files,
//! hostile viewers.
//!
//! The command under test is the program as it is built, not the library: each trial is a process of its own.

mod clock;
mod damage;
mod disk;
pub mod document;
mod kills;
mod lab;
mod live;
mod random;
mod row;
mod stops;
mod together;
mod viewer;

use crate::built;
use crate::error::Failure;
use crate::terminal::{print, progress};
use lab::{Lab, PLANS, Reference, SHORT};
use row::{HEAD, Row};
use std::path::PathBuf;
use std::time::Instant;
use tribodyn_paper::table;

/// Options of `cargo xtask faults`.
#[derive(Debug, Clone, clap::Args)]
pub struct Arguments {
    /// Kills at random times
    #[arg(long, default_value_t = 100)]
    kills: usize,
    /// Stops at random times
    #[arg(long, default_value_t = 24)]
    stops: usize,
    /// Recordings that are cut or flipped; a tenth as many checkpoints
    #[arg(long, default_value_t = 500)]
    damaged: usize,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only these groups of faults; may be repeated
    #[arg(long, value_enum)]
    only: Vec<Group>,
    /// The command to try; without it, that of the dev profile is built
    #[arg(long, value_name = "PROGRAM")]
    program: Option<PathBuf>,
    /// Put the rows into the table in docs/reliability.md; those of other groups stay
    #[arg(long)]
    write: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Group {
    Kills,
    Stops,
    Disk,
    Together,
    Clock,
    Damage,
    Live,
}

const GROUPS: [Group; 7] =
    [Group::Kills, Group::Stops, Group::Disk, Group::Together, Group::Clock, Group::Damage, Group::Live];

/// Tries all faults, prints the table, and fails if one of them did harm.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let program = match &arguments.program {
        Some(program) => program.clone(),
        None => built::programs()?.join("tribodyn"),
    };
    let mut lab = Lab::new(&program, arguments.seed)?;
    let mut references = Vec::new();
    for plan in PLANS {
        let reference = lab.reference(plan)?;
        progress(&format!("{}: {:.1} s undisturbed", plan.name, reference.wall.as_secs_f64()));
        references.push(reference);
    }
    let mut rows = Vec::new();
    for group in GROUPS.into_iter().filter(|group| arguments.only.is_empty() || arguments.only.contains(group)) {
        let begun = Instant::now();
        rows.extend(rows_of(group, arguments, &mut lab, &references)?);
        progress(&format!("{group:?}: {:.0} s", begun.elapsed().as_secs_f64()));
    }
    let cells: Vec<Vec<String>> = rows.iter().map(Row::cells).collect();
    print(&format!("{}\n", table::aligned(&HEAD, &cells)))?;
    if arguments.write {
        document::rewrite(&rows)?;
    }
    let failed = rows.iter().filter(|row| row.failed());
    let findings: Vec<String> =
        failed.flat_map(|row| row.failures.iter().map(move |why| format!("{}: {why}", row.fault))).collect();
    if findings.is_empty() { Ok(()) } else { Err(Failure::Check { what: "not everything was survived", findings }) }
}

fn rows_of(group: Group, arguments: &Arguments, lab: &mut Lab, runs: &[Reference]) -> Result<Vec<Row>, Failure> {
    match group {
        Group::Kills => kills::rows(lab, runs, arguments.kills),
        Group::Stops => stops::rows(lab, runs, arguments.stops),
        Group::Disk => {
            let mut rows = disk::full(lab, runs)?;
            rows.extend(disk::read_only(lab, runs)?);
            Ok(rows)
        }
        Group::Together => together::rows(lab, runs),
        Group::Clock => clock::rows(lab, runs),
        Group::Damage => {
            let short = lab.reference(SHORT)?;
            let mut rows = damage::rows(lab, &short, arguments.damaged)?;
            rows.extend(damage::checkpoints(lab, &runs[0], arguments.damaged / 10)?);
            Ok(rows)
        }
        Group::Live => live::rows(lab, runs),
    }
}
