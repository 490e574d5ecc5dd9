//! `cargo xtask verdicts`: what `vibration` says of signals of sound and damaged bearings, `docs/faults.md`.
//!
//! The signals are those of data sets with seeds and loads that no rule of the diagnosis was chosen on.

use crate::built;
use crate::error::Failure;
use crate::terminal::{print, progress};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use tribodyn::{CaseFile, Limits};
use tribodyn_case::set_value;
use tribodyn_paper::{files, markers};
use tribodyn_signal::{Fault, Kinematics, Search};
use tribodyn_study::vibration::{QUIET, SignalFile, Speed, Window, analysis, bearing_of_case};

const PAGE: &str = "docs/faults.md";
const MARKS: [&str; 2] = ["<!-- verdicts:begin -->", "<!-- verdicts:end -->"];
const CASE: &str = "fixtures/cases/oil-6206.ron";
/// Damping ratios of the contacts.
const DAMPING: [f64; 3] = [0.02, 0.25, 0.8];
/// Classes of the data sets, and their names in the table.
const CLASSES: [(&str, &str); 4] =
    [("Sound", "none"), ("Outer", "outer race"), ("Inner", "inner race"), ("Ball", "ball")];
/// Speeds of the inner ring, r/min.
const SPEEDS: [f64; 2] = [2100.0, 3600.0];

/// Samples a second.
const RATE_HZ: f64 = 25_600.0;

/// Options of `cargo xtask verdicts`.
#[derive(Debug, Clone, clap::Args)]
pub struct Arguments {
    /// Rewrite the table in docs/faults.md
    #[arg(long)]
    write: bool,
    /// Draw bearings and phases by this number
    #[arg(long, default_value_t = 2026)]
    seed: u64,
}

/// Verdicts on the signals of a class: none told, outer, inner, ball, cage.
type Counts = [usize; 5];

/// Prints the table, and writes it where asked to.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (folder, tribodyn) = (files::root().join("target/verdicts"), built::command()?);
    let bearing = bearing()?;
    // As of runs, whose low blows are let pass, and as of files of machines.
    let mut counts = [[Counts::default(); CLASSES.len()]; 2];
    for waves in [false, true] {
        for (class, (name, _)) in CLASSES.iter().enumerate() {
            progress(&format!("{name}, {} waves", if waves { "with" } else { "without" }));
            let plan = plan(&folder, (name, waves), arguments.seed)?;
            let set = folder.join(format!("{}-{waves}", name.to_lowercase()));
            let mut dataset = Command::new(&tribodyn);
            dataset.arg("dataset").arg(&plan).arg("-o").arg(&set).args(["--mat", "--restart", "--force", "--quiet"]);
            built::run(&mut dataset, "tribodyn dataset")?;
            // Three cases, and of spalls two lengths, under two loads at two speeds.
            let members = if *name == "Sound" { 12 } else { 24 };
            for member in 0..members {
                judge((&set.join(format!("mat/{member:06}.mat")), member), &bearing, |quiet, verdict| {
                    counts[quiet][class][verdict] += 1;
                })?;
            }
        }
    }
    let table = table(&counts);
    print(&table)?;
    if arguments.write {
        let path = files::root().join(PAGE);
        let page = markers::replaced(PAGE, &files::read(&path)?, &table, MARKS)?;
        files::write(&path, page.as_bytes())?;
    }
    Ok(())
}

fn failed(error: &dyn std::fmt::Display) -> Failure {
    Failure::Seed(error.to_string())
}

/// Writes the plan of a class, with its cases beside it.
fn plan(folder: &Path, (class, waves): (&str, bool), seed: u64) -> Result<PathBuf, Failure> {
    std::fs::create_dir_all(folder).map_err(|e| failed(&e))?;
    let text = files::read(&files::root().join(CASE))?;
    let mut cases = Vec::new();
    for ratio in DAMPING {
        let (name, value) = (format!("6206-{ratio}.ron"), ratio.to_string());
        let case = set_value(&text, "transient.contact_damping", &value).map_err(|e| failed(&e))?;
        files::write(&folder.join(&name), case.as_bytes())?;
        cases.push(format!("{name:?}"));
    }
    let spectrum = "(first: 2, last: 100, amplitude: um(0.5), exponent: 1.5, seed: 0)";
    let deviations =
        if waves { format!("deviations: (inner: {spectrum}, outer: {spectrum}, balls: 10),") } else { String::new() };
    let speeds = SPEEDS.map(|rpm| format!("rpm({rpm})")).join(", ");
    let plan = format!(
        "(name: \"verdicts\", cases: [{}], faults: [{class}], lengths: [mm(0.7), mm(1.4)],
        loads: [(radial: N(600)), (radial: N(1300))], speeds: [{speeds}], bearings: 1,
        spall: (depth: um(150), width: mm(3), edge_radius: um(20), zone: deg(20)), {deviations}
        settle: ms(30), duration: ms(330), rate: Hz({RATE_HZ}),
        sensors: [
            (name: \"ring\", direction: deg(0), direct: 1, modes: [], noise: 0),
            (name: \"housing\", direction: deg(0), direct: 0.5, modes: [
                (frequency: Hz(2800), damping: 0.03, gain: 0.5), (frequency: Hz(6100), damping: 0.02, gain: 0.3),
            ], noise: 1),
        ], test_share: 0, seed: {seed})\n",
        cases.join(", ")
    );
    let path = folder.join(format!("{}-{waves}.ron", class.to_lowercase()));
    files::write(&path, plan.as_bytes())?;
    Ok(path)
}

fn bearing() -> Result<Kinematics, Failure> {
    let text = files::read(&files::root().join(CASE))?;
    let file = CaseFile::from_text(CASE, text, &[], &Limits::NORMAL).map_err(|e| failed(&e))?;
    Ok(bearing_of_case(&file).map_err(|e| failed(&e))?.0)
}

/// The verdicts on both sensors of a member, with low blows let pass and not.
fn judge(
    (path, member): (&Path, usize),
    bearing: &Kinematics,
    mut count: impl FnMut(usize, usize),
) -> Result<(), Failure> {
    let signals = SignalFile::read(path, &Limits::NORMAL).map_err(|e| failed(&e))?;
    let speed = Speed::Near(SPEEDS[member % SPEEDS.len()] / 60.0);
    for sensor in ["ring", "housing"] {
        for (k, quiet) in [QUIET, 0.0].into_iter().enumerate() {
            let (from, search) = ((Some(sensor), Some(RATE_HZ)), Search { quiet, ..Search::default() });
            let found = analysis(path, &signals, from, Window::default(), &speed, (bearing, None), search);
            let verdict = match found.map_err(|e| failed(&e))?.diagnosis.verdict.fault {
                None => 0,
                Some(Fault::Outer) => 1,
                Some(Fault::Inner) => 2,
                Some(Fault::Ball) => 3,
                Some(Fault::Cage) => 4,
            };
            count(k, verdict);
        }
    }
    Ok(())
}

/// The table of both ways, and the sums.
fn table(counts: &[[Counts; CLASSES.len()]; 2]) -> String {
    let mut text = "| fault | none told | outer | inner | ball | cage |\n|---|---|---|---|---|---|\n".to_owned();
    let cell = |count: usize| if count == 0 { String::new() } else { count.to_string() };
    for (k, kind) in ["", ", low blows counted"].into_iter().enumerate() {
        for ((_, name), counts) in CLASSES.iter().zip(counts[k]) {
            let _ = writeln!(text, "| {name}{kind} | {} |", counts.map(cell).join(" | "));
        }
    }
    let right = |k: usize| (0..CLASSES.len()).map(|class| counts[k][class][class]).sum::<usize>();
    let all: usize = counts[0].iter().flatten().sum();
    let _ = writeln!(text, "\nRight are {} of {all}, and {} where low blows count.", right(0), right(1));
    text
}
