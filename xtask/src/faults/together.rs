//! Two commands with one output, started at the same time or one beside the other.

use super::kills::is_whole;
use super::lab::{Lab, Reference, beside, told, words};
use super::row::{Row, ensure};
use crate::error::Failure;
use std::ffi::OsString;
use std::fs;
use std::process::Output;

const PAIRS: usize = 20;
const PAIRS_OF_SWEEPS: usize = 5;

pub fn rows(lab: &mut Lab, references: &[Reference]) -> Result<Vec<Row>, Failure> {
    let mut runs = Row::new("two runs of one recording at once: one is refused, one is whole");
    let mut beside_living = Row::new("--resume and --restart beside a living run: refused, the run is whole");
    let mut sweeps = Row::new("two sweeps of one table at once: one is refused, one is whole");
    for trial in 0..PAIRS {
        let reference = &references[trial % references.len()];
        let folder = lab.scratch()?;
        let recording = folder.join("run.mcap");
        let rest: &[&str] = if trial % 2 == 0 { &[] } else { &["--restart"] };
        let lines = [&[][..], rest].map(|rest| lab.run_words(reference.plan, &recording, rest));
        runs.count(one_of_two(lab, &lines)?.and_then(|()| is_whole(&recording, reference)));
        let _ = fs::remove_dir_all(&folder);
    }
    for reference in references {
        let folder = lab.scratch()?;
        let recording = folder.join("run.mcap");
        let child = lab.spawn(&lab.run_words(reference.plan, &recording, &[]))?;
        let pid = format!("pid {}", child.id());
        while !fs::read_to_string(beside(&recording, ".lock")).is_ok_and(|text| text.ends_with('}')) {
            std::thread::sleep(std::time::Duration::from_millis(5));
        }
        for rest in ["--resume", "--restart"] {
            let output = lab.output(&lab.run_words(reference.plan, &recording, &[rest]))?;
            beside_living.count(is_refused(&output, &pid));
        }
        let output = child.wait_with_output().map_err(|source| lab.no_start(source))?;
        let ended = ensure(output.status.success(), || told(&output));
        beside_living.count(ended.and_then(|()| is_whole(&recording, reference)));
    }
    let mut expected = None;
    for _ in 0..PAIRS_OF_SWEEPS {
        let table = lab.scratch()?.join("table.csv");
        let [axial, radial] = ["ring.z.Force=kN(40..60 in 12)", "ring.x.Force=kN(5..20 in 6)"];
        let line = words([&"sweep", &lab.case(), &"--set", &axial, &"--set", &radial, &"-o", &table]);
        let outcome = one_of_two(lab, &[line.clone(), line])?.and_then(|()| {
            let found = fs::read(&table).map_err(|error| error.to_string())?;
            let whole = expected.get_or_insert_with(|| found.clone());
            ensure(found == *whole, || "the table is another one".to_owned())
        });
        sweeps.count(outcome);
    }
    Ok(vec![runs, beside_living, sweeps])
}

/// Starts both at once: one succeeds, the other is refused with the number of the first.
fn one_of_two(lab: &Lab, lines: &[Vec<OsString>; 2]) -> Result<Result<(), String>, Failure> {
    let children = [lab.spawn(&lines[0])?, lab.spawn(&lines[1])?];
    let pids = [0, 1].map(|k: usize| format!("pid {}", children[k].id()));
    let mut outputs = Vec::new();
    for child in children {
        outputs.push(child.wait_with_output().map_err(|source| lab.no_start(source))?);
    }
    let winner = outputs.iter().position(|output| output.status.success());
    Ok(match winner {
        None => Err(format!("both failed: {}; {}", told(&outputs[0]), told(&outputs[1]))),
        Some(winner) => is_refused(&outputs[1 - winner], &pids[winner]),
    })
}

fn is_refused(output: &Output, pid: &str) -> Result<(), String> {
    let text = String::from_utf8_lossy(&output.stderr);
    let right = output.status.code() == Some(2) && text.contains("another process is writing it") && text.contains(pid);
    ensure(right, || format!("not refused with {pid}: {}", told(output)))
}
