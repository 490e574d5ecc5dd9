//! Ensembles of runs: the cost of a member, and what a second thread gives.

use super::CASE;
use super::row::{Limit, Row};
use crate::error::Failure;
use std::sync::atomic::AtomicBool;
use tribodyn::Limits;
use tribodyn_case::set_value;
use tribodyn_study::ensemble::{Cost, Ensemble, EnsembleOptions, Sampling, Spread};

const GROUP: &str = "ensemble";
const SPREAD: &str = "cage.pocket_gap=mm(0.71 ± 0.02)";
const SCHEME: (&str, &str) = ("transient.scheme", "Fast(step: us(20))");

/// One thread and two in turn, the better of some repetitions each.
pub fn rows(text: &str, quick: bool) -> Result<Vec<Row>, Failure> {
    let (members, duration, repetitions) = if quick { (4, "s(0.02)", 1) } else { (16, "s(0.2)", 5) };
    let ensemble = ensemble(text, members, duration)?;
    let mut best: [Option<Cost>; 2] = [None, None];
    for _ in 0..repetitions {
        for (threads, best) in [1, 2].into_iter().zip(&mut best) {
            let cost = cost(&ensemble, threads)?;
            if best.as_ref().is_none_or(|least| cost.wall_s < least.wall_s) {
                *best = Some(cost);
            }
        }
    }
    let [Some(one), Some(two)] = best else { return Ok(Vec::new()) };
    let of = format!("{members} members of {}", duration.replace("s(", "").replace(')', " s"));
    let mut rows = Vec::new();
    for (name, cost) in [("a member, 1 thread", &one), ("a member, 2 threads", &two)] {
        let row = match cost.processor_per_member_s {
            Some(seconds) => Row::new(GROUP, name, 1e3 * seconds, "ms").note(of.clone()),
            None => Row::skipped(GROUP, name, "the system tells no processor time"),
        };
        rows.push(row);
    }
    let faster = Row::new(GROUP, "2 threads over 1", one.wall_s / two.wall_s, "times");
    rows.push(faster.must_be(Limit::AtLeast(1.9)).note(format!("wall time, {of}; needs two idle cores")));
    Ok(rows)
}

fn ensemble(text: &str, members: usize, duration: &str) -> Result<Ensemble, Failure> {
    let changes = [SCHEME, ("transient.duration", duration)];
    let set = |text: String, (path, value)| set_value(&text, path, value);
    let text = changes.into_iter().try_fold(text.to_owned(), set).map_err(|error| Failure::Seed(error.to_string()))?;
    let spread = Spread::parse(SPREAD).map_err(Failure::Seed)?;
    let options = EnsembleOptions { members, seed: 1, sampling: Sampling::Independent };
    let made = Ensemble::new((CASE, text), &[], &[spread], options, &Limits::NORMAL);
    made.map_err(|error| Failure::Seed(error.to_string()))
}

fn cost(ensemble: &Ensemble, threads: usize) -> Result<Cost, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| Failure::Seed(error.to_string()))?;
    let outcome = pool.install(|| ensemble.run(&AtomicBool::new(false), |_| ()));
    let report = ensemble.report(&outcome);
    match report.failures.first() {
        Some(failed) => Err(Failure::Seed(failed.error.clone())),
        None => Ok(report.cost),
    }
}
