//! Sums, ranges and zones over the balls of a run.

use super::runs::{Run, Runs};
use crate::mean::mean;
use tribodyn_quasistatic::BallResult;

/// A number of a ball.
pub type Quantity = fn(&BallResult) -> f64;

/// The paper's heavy zone, −90° to 90°.
pub fn heavy(ball: &BallResult) -> bool {
    ball.azimuth_rad.cos() > 0.0
}

pub fn values(run: &Run, get: Quantity) -> impl Iterator<Item = f64> {
    run.solution.balls.iter().map(get)
}

pub fn total(run: &Run, get: Quantity) -> f64 {
    values(run, get).sum()
}

/// Greatest less least value.
pub fn range(run: &Run, get: Quantity) -> f64 {
    let [low, high] = limits(values(run, get));
    high - low
}

/// Least and greatest.
pub fn limits(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)])
}

pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    limits(values)[1]
}

pub fn least(values: impl Iterator<Item = f64>) -> f64 {
    limits(values)[0]
}

/// The value that half of the balls exceed: a skidding ball does not move it.
pub fn median(run: &Run, get: Quantity) -> f64 {
    let mut sorted: Vec<f64> = values(run, get).collect();
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (sorted[(sorted.len() - 1) / 2], sorted[sorted.len() / 2]);
    0.5 * (low + high)
}

/// Mean over one zone.
pub fn zone_mean(run: &Run, in_heavy: bool, get: Quantity) -> f64 {
    mean(run.solution.balls.iter().filter(|b| heavy(b) == in_heavy).map(get))
}

/// `case 1 0.912, case 2 …`, for the notes.
pub fn by_case(runs: &Runs, decimals: usize, value: impl Fn(&Run) -> f64) -> String {
    let one = |run: &Run| format!("{} {:.decimals$}", run.label, value(run));
    runs.cases.iter().map(one).collect::<Vec<_>>().join(", ")
}
