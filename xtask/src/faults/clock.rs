//! A clock of the wall that jumps by days while a run goes on, by libfaketime where that is installed.

use super::kills::is_whole;
use super::lab::{Lab, Reference, beside, told};
use super::row::{Row, ensure};
use crate::error::Failure;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tribodyn_paper::files;

const FAULT: &str = "clock of the wall jumps by days and years: the run is whole";
const LIBRARY: &str = "libfaketime.so.1";
/// Folders of systems that have it, and those below them.
const FOLDERS: [&str; 3] = ["/usr/lib", "/usr/lib64", "/usr/local/lib"];
/// Where the clock jumps to, in turn; the first is there from the start on.
const JUMPS: [&str; 5] = ["+3650d", "-1d", "+1d", "-3650d", "+0"];
const TRIALS: usize = 6;

pub fn rows(lab: &mut Lab, references: &[Reference]) -> Result<Vec<Row>, Failure> {
    let Some(library) = library() else {
        return Ok(vec![Row::skipped(FAULT, format!("{LIBRARY} is not installed"))]);
    };
    let mut row = Row::new(FAULT);
    for trial in 0..TRIALS {
        let reference = &references[trial % references.len()];
        let folder = lab.scratch()?;
        let recording = folder.join("run.mcap");
        let time = folder.join("clock");
        files::write(&time, JUMPS[0].as_bytes())?;
        let mut command = lab.command(&lab.run_words(reference.plan, &recording, &[]));
        command.env("LD_PRELOAD", &library).env("FAKETIME_TIMESTAMP_FILE", &time);
        // Intervals are measured by the clock that no system sets.
        command.env("FAKETIME_NO_CACHE", "1").env("FAKETIME_DONT_FAKE_MONOTONIC", "1");
        let child = command.spawn().map_err(|source| lab.no_start(source))?;
        let mut since = String::new();
        for jump in &JUMPS[1..] {
            std::thread::sleep(reference.wall.div_f64(8.0) + Duration::from_millis(lab.random.below(200) as u64));
            let lock = fs::read_to_string(beside(&recording, ".lock")).unwrap_or_default();
            since = if since.is_empty() { lock } else { since };
            files::write(&time, jump.as_bytes())?;
        }
        let output = child.wait_with_output().map_err(|source| lab.no_start(source))?;
        let outcome = ensure(output.status.success(), || told(&output));
        row.count(outcome.and_then(|()| jumped(&since)).and_then(|()| is_whole(&recording, reference)));
    }
    Ok(vec![row])
}

/// The lock has the time of the faked clock, ten years ahead: the library works.
fn jumped(lock: &str) -> Result<(), String> {
    let year = lock.split_once("\"since\":\"").and_then(|(_, rest)| rest.split('-').next()?.parse::<u32>().ok());
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).unwrap_or_default();
    let this_year = 1970 + (now.as_secs() / 31_556_952) as u32;
    ensure(year.is_some_and(|year| year > this_year + 5), || format!("the clock did not jump: {lock}"))
}

fn library() -> Option<PathBuf> {
    let below = |folder: &Path| fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let folders = FOLDERS.iter().flat_map(|folder| below(Path::new(folder)).chain([PathBuf::from(folder)]));
    folders.flat_map(|folder| [folder.join(LIBRARY), folder.join("faketime").join(LIBRARY)]).find(|path| path.exists())
}
