//! The recordings, read by a program that shares no code with ours.

use super::Outcome;
use crate::error::Failure;
use crate::files;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The readers, pinned.
const PACKAGES: [&str; 2] = ["mcap==1.6.0", "mcap-protobuf-support==0.6.0"];

pub fn check(folder: &Path) -> Result<Outcome, Failure> {
    let recordings = mcap_files(folder)?;
    if recordings.is_empty() {
        let findings = vec![format!("no recording in {}", folder.display())];
        return Err(Failure::Check { what: "the validation step has left nothing to read", findings });
    }
    let environment = files::root().join("target/python-reader");
    let python = match interpreter(&environment) {
        Ok(python) => python,
        Err(reason) => return Ok(Outcome::Skipped(reason)),
    };
    let mut command = Command::new(python);
    command.arg(files::root().join("xtask/checks/read_mcap.py")).args(&recordings);
    let status = command.status().map_err(|source| Failure::Start { program: "python".to_owned(), source })?;
    if status.success() {
        return Ok(Outcome::Done);
    }
    Err(Failure::Command { command: "xtask/checks/read_mcap.py".to_owned(), status })
}

fn mcap_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(|source| Failure::Read { path: folder.to_owned(), source })?;
    let paths = entries.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let mut found: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|e| e == "mcap")).collect();
    found.sort();
    Ok(found)
}

/// A Python with the readers, in a folder of its own; or why there is none.
fn interpreter(environment: &Path) -> Result<PathBuf, String> {
    let python = environment.join("bin/python");
    if !python.exists() {
        quiet(Command::new("python3").args(["-m", "venv"]).arg(environment))
            .map_err(|reason| format!("no Python environment: {reason}"))?;
    }
    let mut install = Command::new(&python);
    install.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--retries", "1"]).args(PACKAGES);
    quiet(&mut install).map_err(|reason| format!("{} not installed: {reason}", PACKAGES.join(", ")))?;
    Ok(python)
}

fn quiet(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| error.to_string())?;
    if output.status.success() {
        return Ok(());
    }
    let text = String::from_utf8_lossy(&output.stderr);
    Err(text.trim().lines().last().unwrap_or("no reason given").to_owned())
}
