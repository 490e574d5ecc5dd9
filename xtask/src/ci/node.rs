//! The recordings, read by the reader that viewers have inside; skipped where Node or its packages are not to be had.

use super::Outcome;
use super::recording::mcap_files;
use crate::error::Failure;
use crate::python::quiet;
use std::fs;
use std::path::Path;
use std::process::Command;
use tribodyn_paper::{PaperError, files};

/// The reader, pinned.
const PACKAGES: [&str; 3] = ["@mcap/core@2.2.2", "@mcap/support@1.1.0", "@mcap/nodejs@1.0.2"];
const SCRIPT: &str = "read_mcap.mjs";

/// Reads what the validation step and the check by Python have left in the folder.
pub fn check(folder: &Path) -> Result<Outcome, Failure> {
    let mut recordings = mcap_files(folder)?;
    let recovered = folder.join(super::recording::RECOVERED);
    if recovered.exists() {
        recordings.extend(mcap_files(&recovered)?);
    }
    if recordings.is_empty() {
        return Ok(Outcome::Skipped(format!("no recording in {}", folder.display())));
    }
    let environment = files::root().join("target/node-reader");
    if let Err(reason) = install(&environment)? {
        return Ok(Outcome::Skipped(reason));
    }
    // Packages are looked for where the script stands.
    let script = environment.join(SCRIPT);
    let source = files::root().join("xtask/checks").join(SCRIPT);
    fs::copy(source, &script).map_err(|source| PaperError::Write { path: script.clone(), source })?;
    let mut command = Command::new("node");
    command.arg(script).args(&recordings);
    let status = command.status().map_err(|source| Failure::Start { program: "node".to_owned(), source })?;
    if status.success() {
        return Ok(Outcome::Done);
    }
    Err(Failure::Command { command: format!("xtask/checks/{SCRIPT}"), status })
}

/// Puts the packages into a folder of their own; the inner error says why they are not there.
fn install(environment: &Path) -> Result<Result<(), String>, Failure> {
    fs::create_dir_all(environment).map_err(|source| PaperError::Write { path: environment.to_owned(), source })?;
    if let Err(reason) = quiet(Command::new("node").arg("--version")) {
        return Ok(Err(format!("no Node: {reason}")));
    }
    let mut npm = Command::new("npm");
    npm.current_dir(environment).args(["install", "--no-save", "--no-audit", "--no-fund", "--ignore-scripts"]);
    let installed = quiet(npm.args(["--fetch-retries", "1", "--prefix", "."]).args(PACKAGES));
    Ok(installed.map(drop).map_err(|reason| format!("{} not installed: {reason}", PACKAGES.join(", "))))
}
