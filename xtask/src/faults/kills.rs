//! Kills at random times: what is safe on disk then, how much wall time is lost, and whether the resumed run records
//! the messages of one that was never killed.

use super::lab::{Lab, Reference, beside, messages, names, same, told, words};
use super::row::{Row, ensure};
use crate::error::Failure;
use std::fs;
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Most wall time that a kill may cost.
const MOST_LOST: Duration = Duration::from_secs(1);
/// Kills of one recording, after which it may come to its end.
const IN_A_ROW: usize = 5;

/// Two rows: the kills with their recoveries, and the resumed runs.
pub fn rows(lab: &mut Lab, references: &[Reference], kills: usize) -> Result<Vec<Row>, Failure> {
    let mut killed = Row::new("kill at a random time, recovery");
    let mut lost = Row::new("wall time lost by a kill, 1 s allowed");
    let mut resumed = Row::new("killed runs, resumed to the end");
    let mut most = Duration::ZERO;
    while killed.tried < kills {
        let reference = &references[resumed.tried % references.len()];
        let folder = lab.scratch()?;
        let recording = folder.join("run.mcap");
        let mut in_a_row = 0;
        let outcome = loop {
            let words = lab.run_words(reference.plan, &recording, next_step(&recording));
            let mut child = lab.spawn(&words)?;
            let patience = if killed.tried < kills && in_a_row < IN_A_ROW {
                reference.wall.mul_f64(lab.random.fraction())
            } else {
                Duration::MAX
            };
            if patience < Duration::MAX {
                std::thread::sleep(patience);
                // One that has ended is killed in vain.
                let _ = child.kill();
            }
            let at = SystemTime::now();
            let output = child.wait_with_output().map_err(|source| lab.no_start(source))?;
            if output.status.code().is_some() {
                break ensure(output.status.success(), || told(&output));
            }
            in_a_row += 1;
            let gone = since_safe(&recording, at);
            most = most.max(gone);
            lost.count(ensure(gone <= MOST_LOST, || format!("{:.2} s are lost", gone.as_secs_f64())));
            killed.count(recovers(lab, &recording, reference)?);
        };
        resumed.count(outcome.and_then(|()| is_whole(&recording, reference)));
        // What failed may be looked at, but not for all time.
        let _ = fs::remove_dir_all(&folder);
    }
    lost.worst = format!("{:.2} s", most.as_secs_f64());
    Ok(vec![killed, lost, resumed])
}

/// Arguments that a user must add to go on; nothing is lost by leaving them out.
fn next_step(recording: &Path) -> &'static [&'static str] {
    let there = |suffix: &str| beside(recording, suffix).exists();
    match (there(".checkpoint"), there(".active") || there(".earlier")) {
        (true, _) => &["--resume"],
        (false, true) => &["--restart"],
        (false, false) => &[],
    }
}

/// Wall time between the last moment that is safe and the kill. Before the recording there is nothing to lose, and none
/// while a resumed run still copies: it makes no step before its own first checkpoint.
fn since_safe(recording: &Path, at: SystemTime) -> Duration {
    let checkpoint = fs::metadata(beside(recording, ".checkpoint")).and_then(|m| m.modified()).ok();
    let begun = fs::metadata(beside(recording, ".active")).and_then(|m| m.created()).ok();
    let last = match (checkpoint, begun) {
        (Some(checkpoint), Some(begun)) if begun > checkpoint => None,
        (checkpoint, begun) => checkpoint.max(begun),
    };
    last.and_then(|last| at.duration_since(last).ok()).unwrap_or_default()
}

/// Messages that a checkpoint counts on.
fn counted(recording: &Path) -> Option<usize> {
    let checkpoint = fs::read_to_string(beside(recording, ".checkpoint")).ok()?;
    let rest = checkpoint.split_once("\"safe_messages\":")?.1;
    rest.chars().take_while(char::is_ascii_digit).collect::<String>().parse().ok()
}

/// Checks that the files on disk can be recovered: a beginning of the undisturbed recording with all that the
/// checkpoint counts on.
fn recovers(lab: &mut Lab, recording: &Path, reference: &Reference) -> Result<Result<(), String>, Failure> {
    let safe = counted(recording);
    let files = ["", ".earlier", ".active"].map(|suffix| beside(recording, suffix));
    let mut most = 0;
    for torn in files.iter().filter(|file| file.exists()) {
        let saved = lab.scratch()?.join("saved.mcap");
        let output = lab.output(&words([&"recover", torn, &"-o", &saved]))?;
        let verdict = match output.status.code() {
            Some(0) => messages(&saved).and_then(|found| {
                most = most.max(found.len());
                same(&found, &reference.messages, true)
            }),
            // Killed before the first message was written.
            Some(1) if !saved.exists() && !output.stderr.is_empty() => Ok(()),
            _ => Err(told(&output)),
        };
        if verdict.is_err() {
            return Ok(verdict.map_err(|why| format!("recovery of {}: {why}", torn.display())));
        }
    }
    Ok(ensure(most >= safe.unwrap_or(0), || format!("{most} messages are saved, the checkpoint counts on {safe:?}")))
}

/// The recording is that of the undisturbed run, and nothing is beside it.
pub fn is_whole(recording: &Path, reference: &Reference) -> Result<(), String> {
    let folder = recording.parent().unwrap_or(recording);
    let left: Vec<String> = names(folder).into_iter().filter(|name| name.starts_with("run.mcap.")).collect();
    ensure(left.is_empty(), || format!("left behind: {}", left.join(", ")))?;
    same(&messages(recording)?, &reference.messages, false)
}
