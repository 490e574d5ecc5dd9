//! One member: its case, its run, and what that took.

use super::figures::figures;
use crate::error::StudyError;
use crate::run::run_unrecorded;
use crate::sweep::Cell;
use cpu_time::ThreadTime;
use std::sync::atomic::AtomicBool;
use std::time::Instant;
use tribodyn::CaseFile;

/// A member that is finished.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// Its number, from 0.
    pub number: usize,
    /// Its figures in the order of their columns, or why it has none.
    pub figures: Result<Vec<Cell>, String>,
    /// Simulated time, s; 0 without figures.
    pub simulated_s: f64,
    /// Wall time of its thread, s.
    pub wall_s: f64,
    /// Processor time of its thread, s; none where the system does not tell it.
    pub processor_s: Option<f64>,
    /// True if an earlier run had finished it.
    pub resumed: bool,
}

/// Runs a member on this thread; none where `stop` was set before its end.
pub(super) fn run_member(
    number: usize,
    case: impl FnOnce() -> Result<CaseFile, StudyError>,
    stop: &AtomicBool,
) -> Option<Member> {
    let (began, processor) = (Instant::now(), ThreadTime::try_now().ok());
    let (figures, simulated_s) = match outcome(case, stop) {
        Ok(Some((figures, simulated_s))) => (Ok(figures), simulated_s),
        Ok(None) => return None,
        Err(message) => (Err(message), 0.0),
    };
    let wall_s = began.elapsed().as_secs_f64();
    let processor_s = processor.and_then(|start| Some(start.try_elapsed().ok()?.as_secs_f64()));
    Some(Member { number, figures, simulated_s, wall_s, processor_s, resumed: false })
}

/// Figures and simulated time (s), or why there are none.
fn outcome(
    case: impl FnOnce() -> Result<CaseFile, StudyError>,
    stop: &AtomicBool,
) -> Result<Option<(Vec<Cell>, f64)>, String> {
    let file = case().map_err(|error| error.to_string())?;
    let Some(report) = run_unrecorded(&file, stop).map_err(|error| error.to_string())? else { return Ok(None) };
    let simulated_s = report.summary.as_ref().map_or(0.0, |summary| summary.simulated_s);
    let figures = figures(&report).map_err(|error| error.to_string())?;
    Ok(Some((figures, simulated_s)))
}
