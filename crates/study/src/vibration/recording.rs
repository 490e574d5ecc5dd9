//! Signals of a recorded run: accelerations and speeds of the rings.

use super::signal_file::{Column, SignalFile, damaged};
use crate::error::StudyError;
use crate::run::{KnownAtEnd, KnownAtStart, Summary, unresolved};
use std::path::Path;
use tribodyn::{CaseFile, Limits};
use tribodyn_record::{Run, StateRow, read_recording_within};

/// Names and values of the columns; the first is the one that is evaluated where none is asked for.
type Get = fn(&StateRow) -> f64;
const COLUMNS: [(&str, Get); 8] = [
    ("outer_acceleration_x_m_s2", |row| row.outer_acceleration_x_m_s2),
    ("outer_acceleration_y_m_s2", |row| row.outer_acceleration_y_m_s2),
    ("outer_acceleration_z_m_s2", |row| row.outer_acceleration_z_m_s2),
    ("inner_acceleration_x_m_s2", |row| row.inner_acceleration_x_m_s2),
    ("inner_acceleration_y_m_s2", |row| row.inner_acceleration_y_m_s2),
    ("inner_acceleration_z_m_s2", |row| row.inner_acceleration_z_m_s2),
    ("inner_speed_rpm", |row| row.inner_speed_rpm),
    ("outer_speed_rpm", |row| row.outer_speed_rpm),
];

/// Largest deviation of a sample from its place, in distances of samples.
const UNEVEN: f64 = 0.01;

pub(super) fn read(path: &Path, limits: &Limits) -> Result<SignalFile, StudyError> {
    let run = read_recording_within(path, limits.recording_bytes)
        .map_err(|source| StudyError::NoRecording { source: Box::new(source) })?;
    let (Some(first), Some(last)) = (run.states.first(), run.states.last()) else {
        return Err(StudyError::NoRun { path: path.to_owned() });
    };
    let step = (last.time_s - first.time_s) / (run.states.len() - 1).max(1) as f64;
    let off = |(k, row): (usize, &StateRow)| (row.time_s - first.time_s - step * k as f64).abs() >= UNEVEN * step;
    if step <= 0.0 || run.states.iter().enumerate().any(off) {
        return Err(damaged(path, "samples are missing, so that they are not evenly spaced"));
    }
    let column =
        |(name, get): &(&str, Get)| Column { name: (*name).to_owned(), values: run.states.iter().map(get).collect() };
    let columns = COLUMNS.iter().map(column).collect();
    let warnings = warnings(&run, limits);
    Ok(SignalFile { case_text: run.case_text, warnings, ..SignalFile::of(columns, Some(1.0 / step)) })
}

/// Warnings of a recorded run, and one where its accelerations are not resolved.
fn warnings(run: &Run, limits: &Limits) -> Vec<String> {
    let Some(summary) = Summary::of(&run.states, run.wear.last(), &run.events) else { return Vec::new() };
    let text = run.case_text.clone().unwrap_or_default();
    // A recording of another version may hold a case that is no longer read.
    let case = CaseFile::from_text("", text, &[], limits).ok();
    let summary = case.iter().fold(summary, |summary, file| summary.judged(&file.case));
    let (known, outcome) = (KnownAtStart::read(run), KnownAtEnd::read(run));
    let mut all = known.warnings_at_start.clone();
    all.extend(summary.warnings.iter().cloned());
    all.extend(unresolved(&summary, &known, outcome.as_ref()));
    all
}
