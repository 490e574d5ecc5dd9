//! The recordings, read by a program that shares no code with ours; one of them also torn and recovered.

use super::Outcome;
use crate::error::Failure;
use crate::python;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tribodyn_paper::{PaperError, files};

/// The readers, pinned.
const PACKAGES: [&str; 2] = ["mcap==1.6.0", "mcap-protobuf-support==0.6.0"];
/// First letters of the recordings of transient runs; there are none where the runs were not asked for.
const RUN_PREFIX: &str = "dynamic-";
/// Folder of what was torn and recovered, below that of the recordings.
pub const RECOVERED: &str = "recovered";

pub fn check(folder: &Path) -> Result<Outcome, Failure> {
    let mut recordings = mcap_files(folder)?;
    if recordings.is_empty() {
        let findings = vec![format!("no recording in {}", folder.display())];
        return Err(Failure::Check { what: "the validation step has left nothing to read", findings });
    }
    let environment = files::root().join("target/python-reader");
    let python = match python::environment(&environment, &PACKAGES) {
        Ok(python) => python,
        Err(reason) => return Ok(Outcome::Skipped(reason)),
    };
    recordings.extend(recovered(folder, &recordings)?);
    let mut command = Command::new(python);
    command.arg(files::root().join("xtask/checks/read_mcap.py")).args(&recordings);
    let status = command.status().map_err(|source| Failure::Start { program: "python".to_owned(), source })?;
    if status.success() {
        return Ok(Outcome::Done);
    }
    Err(Failure::Command { command: "xtask/checks/read_mcap.py".to_owned(), status })
}

pub fn mcap_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = fs::read_dir(folder).map_err(|source| PaperError::Read { path: folder.to_owned(), source })?;
    let paths = entries.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let mut found: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|e| e == "mcap")).collect();
    found.sort();
    Ok(found)
}

/// Recoveries of the first recording of each kind, cut at three fifths of its bytes, for a run and a solution.
fn recovered(folder: &Path, recordings: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let is_run = |path: &Path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with(RUN_PREFIX));
    let folder = folder.join(RECOVERED);
    fs::create_dir_all(&folder).map_err(|source| PaperError::Write { path: folder.clone(), source })?;
    let mut made = Vec::new();
    for kind in [true, false] {
        let Some(whole) = recordings.iter().find(|path| is_run(path) == kind) else { continue };
        let name = if kind { "run.mcap" } else { "solution.mcap" };
        let (torn, saved) = (folder.join(format!("{name}.active")), folder.join(name));
        let mut bytes = fs::read(whole).map_err(|source| PaperError::Read { path: whole.clone(), source })?;
        bytes.truncate(bytes.len() / 5 * 3);
        fs::write(&torn, &bytes).map_err(|source| PaperError::Write { path: torn.clone(), source })?;
        let report = tribodyn_record::recover(&torn, &saved)?;
        if !report.damage.truncated {
            let findings = vec![format!("{}: the end was not missed", torn.display())];
            return Err(Failure::Check { what: "a torn recording was taken for a whole one", findings });
        }
        made.push(saved);
    }
    Ok(made)
}
