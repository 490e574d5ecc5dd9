//! `cargo xtask ci`: everything that continuous integration checks, in one build profile.

mod circles;
mod examples;
mod figures;
mod hygiene;
mod instructions;
mod layers;
mod licences;
mod listed;
pub mod metadata;
mod named;
mod node;
mod package;
mod published;
mod recording;
mod supply;
mod unused;

use crate::built::cargo_program;
use crate::error::Failure;
use crate::page::{self, Checked};
use crate::quantities;
use crate::validate;
use crate::web;
use std::path::PathBuf;
use std::process::Command;
use std::time::Instant;
use tribodyn_paper::files;

/// End of a step that did not fail.
pub enum Outcome {
    Done,
    /// Not run, with the reason.
    Skipped(String),
}

type Step = (&'static str, fn() -> Result<Outcome, Failure>);

const STEPS: [Step; 22] = [
    ("format", || cargo(&["fmt", "--all", "--check"], &[])),
    ("clippy", || cargo(&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])),
    ("tests", || cargo(&["test", "--workspace"], &[])),
    ("examples", examples::check),
    ("instructions", instructions::check),
    ("documentation", || cargo(&["doc", "--workspace", "--no-deps"], &[("RUSTDOCFLAGS", "-D warnings")])),
    ("layers", layers::check),
    ("circles", circles::check),
    ("unused dependencies", unused::check),
    ("hygiene", hygiene::check),
    ("licences", licences::check),
    ("supply chain", supply::check),
    ("packages of crates", published::check),
    ("page of quantities", || quantities::check().map(|()| Outcome::Done)),
    ("validation", || validate::check(recordings()).map(|()| Outcome::Done)),
    ("figures", figures::check),
    ("recording read by Python", || recording::check(&recordings())),
    ("report in a browser", || page::check_usual().map(outcome)),
    // The front door and all below it compile for a browser.
    ("wasm32", || web::build().map(outcome)),
    ("page in a browser", || web::check().map(outcome)),
    ("recording read by Node", || node::check(&recordings())),
    ("Python package", package::check),
];

fn recordings() -> PathBuf {
    files::root().join("target/validation")
}

/// Names of the steps, in the order in which they run.
pub fn names() -> [&'static str; STEPS.len()] {
    STEPS.map(|(name, _)| name)
}

/// Runs the steps of these names, all of them where none is named, also after one has failed; says how each ended.
pub fn run(wanted: &[String]) -> Result<(), Failure> {
    let start = Instant::now();
    let (mut failed, mut skipped) = (Vec::new(), Vec::new());
    let steps = STEPS.iter().filter(|(name, _)| wanted.is_empty() || wanted.iter().any(|w| w == name));
    let count = steps.clone().count();
    for (name, step) in steps {
        println!("\n== {name}");
        let begun = Instant::now();
        let outcome = step();
        let seconds = begun.elapsed().as_secs_f64();
        match outcome {
            Ok(Outcome::Done) => println!("== {name}: passed in {seconds:.1} s"),
            Ok(Outcome::Skipped(reason)) => {
                println!("== {name}: SKIPPED after {seconds:.1} s: {reason}");
                skipped.push(*name);
            }
            Err(failure) => {
                println!("== {name}: FAILED after {seconds:.1} s: {failure}");
                failed.push((*name).to_owned());
            }
        }
    }
    let list = |names: &[&str]| if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    let passed = count - failed.len() - skipped.len();
    let seconds = start.elapsed().as_secs_f64();
    if failed.is_empty() {
        println!("\nci: {passed} of {count} steps passed in {seconds:.0} s, skipped: {}", list(&skipped));
        return Ok(());
    }
    println!(
        "\nci: {passed} of {count} steps passed in {seconds:.0} s, skipped: {}, FAILED: {}",
        list(&skipped),
        failed.join(", ")
    );
    Err(Failure::Check { what: "continuous integration failed", findings: failed })
}

fn outcome(checked: Checked) -> Outcome {
    match checked {
        Checked::Passed => Outcome::Done,
        Checked::Skipped(reason) => Outcome::Skipped(reason),
    }
}

/// Runs Cargo in the workspace, its output shown.
fn cargo(arguments: &[&str], environment: &[(&str, &str)]) -> Result<Outcome, Failure> {
    let mut command = Command::new(cargo_program());
    command.current_dir(files::root()).args(arguments).envs(environment.iter().copied());
    let status = command.status().map_err(|source| Failure::Start { program: "cargo".to_owned(), source })?;
    if status.success() {
        return Ok(Outcome::Done);
    }
    Err(Failure::Command { command: format!("cargo {}", arguments.join(" ")), status })
}

fn finish(what: &'static str, findings: Vec<String>) -> Result<Outcome, Failure> {
    if findings.is_empty() { Ok(Outcome::Done) } else { Err(Failure::Check { what, findings }) }
}
