//! Requests to stop: how long a run takes to obey, stiff ones too, and whether it goes on to the same messages.

use super::kills::is_whole;
use super::lab::{Lab, Plan, Reference, beside, names, signal, told};
use super::row::{Row, ensure};
use crate::error::Failure;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// Most wall time between the request and the end of the program.
const MOST: Duration = Duration::from_millis(500);
/// Runs that take minutes for a millisecond.
const STIFF: [Plan; 2] = [
    Plan { name: "nanoseconds", scheme: "RungeKutta4(step: us(0.001))", duration_s: 1.0 },
    Plan { name: "tight", scheme: "DormandPrince(tolerance: 1e-13, longest: us(0.01))", duration_s: 1.0 },
];

pub fn rows(lab: &mut Lab, references: &[Reference], stops: usize) -> Result<Vec<Row>, Failure> {
    let mut obeyed = Row::new("SIGTERM or SIGINT at a random time, 0.5 s allowed");
    let mut resumed = Row::new("stopped runs, resumed to the end");
    let mut stiff = Row::new("stiff run: checkpoint within 1 s, stop within 0.5 s, resumption");
    let mut most = [Duration::ZERO; 2];
    for trial in 0..stops {
        let reference = &references[trial % references.len()];
        let folder = lab.scratch()?;
        let recording = folder.join("run.mcap");
        // After the start, so that there is something to stop.
        let patience = reference.wall.mul_f64(0.2 + 0.6 * lab.random.fraction());
        let name = if trial % 2 == 0 { "TERM" } else { "INT" };
        let Some(took) = stop(lab, reference.plan, &recording, patience, name)? else { continue };
        most[0] = most[0].max(took);
        obeyed.count(ensure(took <= MOST, || format!("it took {:.2} s", took.as_secs_f64())));
        let rest = if beside(&recording, ".checkpoint").exists() { &["--resume"][..] } else { &["--restart"] };
        let output = lab.output(&lab.run_words(reference.plan, &recording, rest))?;
        let went_on = ensure(output.status.success(), || told(&output));
        resumed.count(went_on.and_then(|()| is_whole(&recording, reference)));
        let _ = fs::remove_dir_all(&folder);
    }
    for trial in 0..stops.div_ceil(3) {
        let plan = STIFF[trial % STIFF.len()];
        let recording = lab.scratch()?.join("run.mcap");
        let (outcome, took) = hardly_moves(lab, plan, &recording)?;
        most[1] = most[1].max(took);
        stiff.count(outcome);
    }
    obeyed.worst = format!("{:.2} s", most[0].as_secs_f64());
    stiff.worst = format!("{:.2} s to stop", most[1].as_secs_f64());
    Ok(vec![obeyed, resumed, stiff])
}

/// Starts a run and asks it to stop; how long it took to end, none where it had ended before.
fn stop(lab: &Lab, plan: Plan, recording: &Path, patience: Duration, name: &str) -> Result<Option<Duration>, Failure> {
    let rest = if beside(recording, ".checkpoint").exists() { &["--resume"][..] } else { &[] };
    let mut child = lab.spawn(&lab.run_words(plan, recording, rest))?;
    std::thread::sleep(patience);
    let ended = child.try_wait().map_err(|source| lab.no_start(source))?.is_some();
    let asked = Instant::now();
    if !ended {
        signal(&child, name)?;
    }
    let output = child.wait_with_output().map_err(|source| lab.no_start(source))?;
    // 0 where the end came first.
    Ok((!ended && output.status.code() != Some(0)).then(|| asked.elapsed()))
}

/// A stiff run is saved, stops, and moves on when it is resumed.
fn hardly_moves(lab: &Lab, plan: Plan, recording: &Path) -> Result<(Result<(), String>, Duration), Failure> {
    let checkpoint = beside(recording, ".checkpoint");
    let simulated = || {
        let text = fs::read_to_string(&checkpoint).ok()?;
        let rest = text.split_once("\"simulated_s\":")?.1;
        rest.split([',', '}']).next()?.parse::<f64>().ok()
    };
    let mut child = lab.spawn(&lab.run_words(plan, recording, &[]))?;
    let begun = Instant::now();
    let active = beside(recording, ".active");
    while !active.exists() && begun.elapsed() < Duration::from_secs(30) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let recorded = Instant::now();
    while !checkpoint.exists() && recorded.elapsed() < Duration::from_secs(5) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let saved_in = recorded.elapsed();
    let first = simulated();
    let asked = Instant::now();
    signal(&child, "TERM")?;
    let status = child.wait().map_err(|source| lab.no_start(source))?;
    let mut took = asked.elapsed();
    let stopped = simulated();
    let resumed = stop(lab, plan, recording, Duration::from_millis(1500), "INT")?;
    took = took.max(resumed.unwrap_or_default());
    let outcome =
        ensure(saved_in <= Duration::from_secs(1), || format!("the first checkpoint came after {saved_in:?}"))
            .and_then(|()| ensure(status.code() == Some(1), || format!("the stopped run ended with {status}")))
            .and_then(|()| ensure(took <= MOST, || format!("it took {took:?} to stop")))
            .and_then(|()| ensure(first <= stopped && stopped < simulated(), || "it does not move".to_owned()))
            .and_then(|()| {
                let left = names(recording.parent().unwrap_or(recording));
                ensure(left == ["run.mcap", "run.mcap.checkpoint"], || format!("left behind: {}", left.join(", ")))
            });
    Ok((outcome, took))
}
