//! Recordings read back: time series as arrays that Rust has made and NumPy owns.

use crate::convert::to_python;
use crate::error::{self, internal, record};
use crate::watch::watched;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::json;
use std::path::PathBuf;
use tribodyn::Limits;
use tribodyn_record::wire::Numbers;
use tribodyn_record::{BallRow, LogRow, Run, SolutionRow, StateRow, WearRow, read_recording_within};
use tribodyn_report::{Report, ReportOptions};

/// Names, and a row for each time.
type Series<'py> = (&'static [&'static str], Bound<'py, PyArray2<f64>>);

fn series<'py, R: Numbers>(py: Python<'py>, rows: &[R]) -> PyResult<Series<'py>> {
    let width = R::NAMES.len();
    let numbers: Vec<f64> = rows.iter().flat_map(|row| (0..width).map(|place| row.number(place))).collect();
    Ok((R::NAMES, PyArray1::from_vec(py, numbers).reshape([rows.len(), width])?))
}

/// All numbers of a recording: a dictionary of series, texts and events.
#[pyfunction]
pub fn read_recording<'py>(py: Python<'py>, path: PathBuf, no_limits: bool) -> PyResult<Bound<'py, PyDict>> {
    let limits = if no_limits { Limits::NONE } else { Limits::NORMAL };
    let read = py.detach(|| read_recording_within(&path, limits.recording_bytes));
    let run = read.map_err(|failure| record(py, &path, &failure))?;
    let recording = PyDict::new(py);
    recording.set_item("case_text", &run.case_text)?;
    recording.set_item("metadata", to_python(py, &run.metadata)?)?;
    recording.set_item("states", series::<StateRow>(py, &run.states)?)?;
    let solution: Vec<SolutionRow> = run.solution.iter().cloned().collect();
    recording.set_item("solution", series::<SolutionRow>(py, &solution)?)?;
    recording.set_item("wear", worn(py, &run.wear)?)?;
    recording.set_item("balls", balls(py, &run)?)?;
    let event = |e: &LogRow| json!({ "time_s": e.time_s, "warning": e.warning, "kind": e.kind, "message": e.message });
    recording.set_item("events", to_python(py, &run.events.iter().map(event).collect::<Vec<_>>())?)?;
    recording.set_item("whole", run.damage.is_none())?;
    Ok(recording)
}

/// The numbers of `summary.json`, the same for a terminal, and the page.
type Reported<'py> = (Bound<'py, PyAny>, String, PathBuf);

/// Writes the report of a recording, or of what two of them differ in.
#[pyfunction]
pub fn report<'py>(
    py: Python<'py>,
    recordings: (PathBuf, Option<PathBuf>),
    output: PathBuf,
    against: Option<PathBuf>,
    force_and_no_limits: (bool, bool),
) -> PyResult<Reported<'py>> {
    let (force, no_limits) = force_and_no_limits;
    let limits = if no_limits { Limits::NONE } else { Limits::NORMAL };
    let first = recordings.0.clone();
    let (made, _) = watched(py, None, true, move |_| {
        let options = ReportOptions { against: against.as_deref(), force };
        tribodyn_report::report((&recordings.0, recordings.1.as_deref()), &output, options, &limits)
    })?;
    let Report { summary, text, page } = made.map_err(|failure| error::report(py, &first, failure))?;
    Ok((to_python(py, &summary)?, text, page))
}

/// Single numbers of what has worn off.
const WORN: [&str; 6] = [
    "time_s",
    "volume_inner_um3",
    "volume_outer_um3",
    "volume_cage_um3",
    "coating_inner_min_um",
    "coating_outer_min_um",
];

fn worn<'py>(py: Python<'py>, rows: &[WearRow]) -> PyResult<Series<'py>> {
    let numbers = |row: &WearRow| {
        [
            row.time_s,
            row.volume_inner_um3,
            row.volume_outer_um3,
            row.volume_cage_um3,
            row.coating_inner_min_um,
            row.coating_outer_min_um,
        ]
    };
    let all: Vec<f64> = rows.iter().flat_map(numbers).collect();
    Ok((&WORN, PyArray1::from_vec(py, all).reshape([rows.len(), WORN.len()])?))
}

/// Times, names, and numbers by time, ball and name.
type BallSeries<'py> = (Bound<'py, PyArray1<f64>>, &'static [&'static str], Bound<'py, PyArray3<f32>>);

fn balls<'py>(py: Python<'py>, run: &Run) -> PyResult<BallSeries<'py>> {
    let (width, count) = (BallRow::NAMES.len(), run.balls.first().map_or(0, |(_, balls)| balls.len()));
    if run.balls.iter().any(|(_, balls)| balls.len() != count) {
        return Err(internal(py, "the number of balls changes within the recording"));
    }
    let times: Vec<f64> = run.balls.iter().map(|(time_s, _)| *time_s).collect();
    let rows = run.balls.iter().flat_map(|(_, balls)| balls);
    // Recorded in single precision.
    let numbers: Vec<f32> = rows.flat_map(|ball| (0..width).map(|place| ball.number(place) as f32)).collect();
    let numbers = PyArray1::from_vec(py, numbers).reshape([times.len(), count, width])?;
    Ok((PyArray1::from_vec(py, times), BallRow::NAMES, numbers))
}

/// Names of all numbers of a recording, by the series that they are in.
#[pyfunction]
pub fn recorded_names(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let names = PyDict::new(py);
    names.set_item("states", StateRow::NAMES)?;
    names.set_item("solution", SolutionRow::NAMES)?;
    names.set_item("wear", WORN)?;
    names.set_item("balls", BallRow::NAMES)?;
    Ok(names)
}
