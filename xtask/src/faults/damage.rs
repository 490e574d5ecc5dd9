//! Recordings that were cut, flipped or overwritten: what is recovered is a part of the original and every loss is
//! said.

use super::lab::{Lab, Message, Reference, beside, messages, told, words};
use super::random::Random;
use super::row::{Row, ensure};
use crate::error::Failure;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Output;
use std::time::{Duration, Instant};
use tribodyn_paper::files;

/// Of so many damaged recordings one is also given to `report`, which draws all figures.
const REPORT_EVERY: usize = 5;
/// A command that takes longer hangs.
const HANGS: Duration = Duration::from_secs(60);

/// Metadata of a recording by name, and the bytes of its attachments.
type Rest = (BTreeMap<String, BTreeMap<String, String>>, BTreeMap<String, Vec<u8>>);

pub fn rows(lab: &mut Lab, reference: &Reference, count: usize) -> Result<Vec<Row>, Failure> {
    let mut recovered = Row::new("cut or flipped recording: recover");
    let mut reported = Row::new("cut or flipped recording: report");
    let folder = lab.scratch()?;
    let whole = fs::read(&reference.recording).map_err(|source| lab.no_start(source))?;
    let rest = rest(&whole);
    let expected = report(lab, &reference.recording, &folder.join("whole"))?;
    let expected: Option<Value> = serde_json::from_slice(&expected.stdout).ok();
    let mut slowest = Duration::ZERO;
    for trial in 0..count {
        let damaged = folder.join("damaged.mcap");
        let (how, bytes) = damage(&whole, &mut lab.random);
        files::write(&damaged, &bytes)?;
        let saved = folder.join("saved.mcap");
        let _ = fs::remove_file(&saved);
        let begun = Instant::now();
        let output = lab.output(&words([&"recover", &damaged, &"-o", &saved, &"--json"]))?;
        slowest = slowest.max(begun.elapsed());
        let outcome = ends_well(&output, begun.elapsed(), &saved).and_then(|whole| match whole {
            true => of_the_original(&output, &saved, reference, &rest),
            false => Ok(()),
        });
        recovered.count(outcome.map_err(|why| format!("{how}: {why}")));
        if trial % REPORT_EVERY == 0 {
            let target = folder.join("report");
            let _ = fs::remove_dir_all(&target);
            let begun = Instant::now();
            let output = report(lab, &damaged, &target)?;
            let outcome = ends_well(&output, begun.elapsed(), &target).and_then(|whole| match whole {
                true => reports_the_same(&output, expected.as_ref()),
                false => Ok(()),
            });
            reported.count(outcome.map_err(|why| format!("{how}: {why}")));
        }
    }
    recovered.worst = format!("{:.2} s", slowest.as_secs_f64());
    let _ = fs::remove_dir_all(&folder);
    Ok(vec![recovered, reported])
}

/// A damaged copy, and what was done to it.
fn damage(whole: &[u8], random: &mut Random) -> (String, Vec<u8>) {
    let mut bytes = whole.to_vec();
    let at = random.below(bytes.len());
    match random.below(8) {
        0..3 => {
            bytes.truncate(at);
            (format!("cut at {at}"), bytes)
        }
        3..6 => {
            let bit = random.below(8);
            bytes[at] ^= 1 << bit;
            (format!("bit {bit} of byte {at} flipped"), bytes)
        }
        6 => {
            let count = 1 + random.below(64);
            (at..(at + count).min(whole.len())).for_each(|k| bytes[k] = random.next() as u8);
            (format!("{count} bytes at {at} overwritten"), bytes)
        }
        _ => {
            // A block that a disk has lost.
            let (from, to) = (at / 4096 * 4096, (at / 4096 * 4096 + 4096).min(whole.len()));
            bytes[from..to].fill(0);
            (format!("zeros from {from} to {to}"), bytes)
        }
    }
}

/// True if a command has made its output, false if it ended with a clear error; an error if it panics, hangs or leaves
/// half of the output.
fn ends_well(output: &Output, took: Duration, made: &Path) -> Result<bool, String> {
    ensure(took < HANGS, || format!("it took {took:?}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    match output.status.code() {
        Some(0) => Ok(true),
        Some(1 | 2) if !text.trim().is_empty() && !text.contains("panicked") && !made.exists() => Ok(false),
        _ => Err(told(output)),
    }
}

/// Checks that the saved messages are of the original, in its order, and that the command reported any loss or change.
fn of_the_original(output: &Output, saved: &Path, reference: &Reference, rest: &Rest) -> Result<(), String> {
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let found = messages(saved)?;
    // Sequences may be those of a file with other parts left out.
    let same = |a: &Message, b: &Message| (&a.0, &a.2, &a.3) == (&b.0, &b.2, &b.3);
    let mut originals = reference.messages.iter();
    // Messages before a fault that no checksum vouches for may be others; they are counted.
    let unchecked = answer["messages_unchecked"].as_u64().unwrap_or(0);
    let stranger = found.iter().find(|message| !originals.any(|original| same(message, original)));
    if let Some(stranger) = stranger.filter(|_| unchecked == 0) {
        return Err(format!("a message of {} at {} ns is not of the original", stranger.0, stranger.2[0]));
    }
    let number = |name: &str| answer[name].as_u64().unwrap_or(0);
    let lost = ["chunks_bad", "bytes_lost", "messages_lost", "messages_unchecked"].map(number);
    let wrong = ["truncated", "summary_bad", "checksum_bad"].map(|name| answer[name] == true);
    let said = lost.iter().any(|count| *count > 0) || wrong.contains(&true);
    let bytes = fs::read(saved).map_err(|error| error.to_string())?;
    let (mut metadata, attachments) = self::rest(&bytes);
    metadata.remove("recovery");
    ensure(said || found.len() == reference.messages.len(), || {
        format!(
            "{} of {} messages are missing, and nothing is said",
            reference.messages.len() - found.len(),
            found.len()
        )
    })?;
    ensure(said || metadata == rest.0, || "metadata are others, and nothing is said".to_owned())?;
    ensure(said || attachments == rest.1, || "attachments are others, and nothing is said".to_owned())
}

/// Metadata and attachments of a recording.
fn rest(bytes: &[u8]) -> Rest {
    let (mut metadata, mut attachments) = Rest::default();
    let Ok(Some(summary)) = mcap::Summary::read(bytes) else { return (metadata, attachments) };
    for index in &summary.metadata_indexes {
        if let Ok(record) = mcap::read::metadata(bytes, index) {
            metadata.insert(record.name, record.metadata);
        }
    }
    for index in &summary.attachment_indexes {
        if let Ok(attachment) = mcap::read::attachment(bytes, index) {
            attachments.insert(attachment.name, attachment.data.into_owned());
        }
    }
    (metadata, attachments)
}

fn report(lab: &Lab, recording: &Path, folder: &Path) -> Result<Output, Failure> {
    lab.output(&words([&"report", &recording, &"-o", &folder, &"--json"]))
}

/// The numbers of a report that names no damage are those of the whole recording.
fn reports_the_same(output: &Output, expected: Option<&Value>) -> Result<(), String> {
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let wrong = ["truncated", "summary_bad", "checksum_bad"].map(|name| answer[name] == true);
    let said =
        wrong.contains(&true) || answer["chunks_bad"].as_u64() != Some(0) || answer["bytes_lost"].as_u64() != Some(0);
    let differs = |expected: &Value| {
        let fields = expected.as_object()?.iter().filter(|(name, _)| *name != "recording");
        fields.into_iter().find(|(name, value)| answer[name.as_str()] != **value).map(|(name, _)| name.clone())
    };
    match expected.and_then(differs) {
        Some(name) if !said => Err(format!("{name} is another one, and nothing is said")),
        _ => Ok(()),
    }
}

/// A checkpoint that was cut or flipped is refused, or the run that goes on from it is that of the original.
pub fn checkpoints(lab: &mut Lab, reference: &Reference, count: usize) -> Result<Vec<Row>, Failure> {
    let mut row = Row::new("cut or flipped checkpoint: refused, or the run is whole");
    let folder = lab.scratch()?;
    let recording = folder.join("run.mcap");
    let mut child = lab.spawn(&lab.run_words(reference.plan, &recording, &[]))?;
    let checkpoint = beside(&recording, ".checkpoint");
    let begun = Instant::now();
    while !checkpoint.exists() && begun.elapsed() < HANGS {
        std::thread::sleep(Duration::from_millis(10));
    }
    // One that has ended has left nothing to resume.
    let _ = child.kill();
    child.wait().map_err(|source| lab.no_start(source))?;
    let active = beside(&recording, ".active");
    let (Ok(torn), Ok(whole)) = (fs::read(&active), fs::read(&checkpoint)) else {
        return Ok(vec![Row::skipped(row.fault, "the run ended before its first checkpoint")]);
    };
    for _ in 0..count {
        let (how, bytes) = damage(&whole, &mut lab.random);
        let before: Vec<_> = [(&active, &torn), (&checkpoint, &bytes)].into();
        for (path, bytes) in &before {
            files::write(path, bytes)?;
        }
        let output = lab.output(&lab.run_words(reference.plan, &recording, &["--resume"]))?;
        let outcome = match output.status.code() {
            Some(0) => super::kills::is_whole(&recording, reference),
            Some(1 | 2) => {
                let kept = fs::read(&active).is_ok_and(|bytes| bytes == torn);
                ensure(kept && !told(&output).contains("panicked"), || format!("not kept: {}", told(&output)))
            }
            _ => Err(told(&output)),
        };
        row.count(outcome.map_err(|why| format!("{how}: {why}")));
        let _ = fs::remove_file(&recording);
    }
    Ok(vec![row])
}
