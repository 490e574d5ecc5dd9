//! Random bearings, tried at scale: do all models converge, do runs of every scheme stay finite, balance their work and
//! say where they do not?
//!
//! A bearing is drawn as the text of a case file, so that each failure is a file that can be looked at by itself.

mod at_rest;
mod bearing;
mod differences;
mod momentum;
mod table;
mod trial;

pub use at_rest::{AtRest, loads_returned, solve_at_rest, survey_at_rest};
pub use bearing::{Kind, RandomBearing, random_bearing};
pub use differences::{Compared, compare_stiffness, survey_stiffness};
pub use table::{Counts, ModelCounts, Regime, SchemeCounts, Tally};
pub use trial::{Running, Solving, Verdict, run_short, solve_by};
pub use tribodyn_wear::Random;

use rayon::prelude::*;
use std::time::Duration;
use tribodyn::answers::Equations;
use tribodyn_case::CaseError;

/// Options of a survey.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Seed of the family of bearings.
    pub seed: u64,
    /// Number of the first bearing.
    pub first: u64,
    /// Bearings to solve.
    pub cases: u64,
    /// Models to solve them by.
    pub models: Vec<Equations>,
    /// Bearings to run, from the first on.
    pub runs: u64,
    /// Wall time after which a run is stopped.
    pub longest_run: Duration,
}

/// One bearing with what was tried on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// The bearing.
    pub bearing: RandomBearing,
    /// By each model; empty where only a run was asked for.
    pub solvings: Vec<Solving>,
    /// The run, where one was asked for.
    pub running: Option<Running>,
}

/// Bearings tried at a time, between calls of `progress`.
const CHUNK: u64 = 16;

/// Tries bearings by the threads of the current rayon pool; `progress` gets each chunk of finished trials, in order.
///
/// # Errors
/// A bearing that the reader of case files refuses.
pub fn survey(options: &Options, mut progress: impl FnMut(&[Trial])) -> Result<Vec<Trial>, CaseError> {
    let end = options.cases.max(options.runs);
    let mut trials = Vec::new();
    for from in (0..end).step_by(CHUNK as usize) {
        let chunk: Result<Vec<Trial>, CaseError> =
            (from..end.min(from + CHUNK)).into_par_iter().map(|offset| try_one(options, offset)).collect();
        let chunk = chunk?;
        progress(&chunk);
        trials.extend(chunk);
    }
    Ok(trials)
}

fn try_one(options: &Options, offset: u64) -> Result<Trial, CaseError> {
    let bearing = random_bearing(options.seed, options.first + offset)?;
    let models = if offset < options.cases { &options.models[..] } else { &[] };
    let solvings = models.iter().map(|model| solve_by(&bearing, *model)).collect();
    let running = (offset < options.runs).then(|| run_short(&bearing, options.longest_run));
    Ok(Trial { bearing, solvings, running })
}
