//! Files of measured and recorded signals: what they say of a bearing, what can be saved of them, how they are shown.

use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error;
use crate::watch::watched;
use numpy::PyArray1;
use pyo3::prelude::*;
use std::path::PathBuf;
use tribodyn::Limits;
use tribodyn_record::{Layout, LayoutKind};
use tribodyn_study::layout_of;
use tribodyn_study::vibration::{SignalQuestion, Window, diagnosed};

/// A signal and the questions about it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SignalRequest {
    file: PathBuf,
    channel: Option<String>,
    rate: Option<f64>,
    bearing: Option<String>,
    angle: Option<f64>,
    speed: Option<String>,
    key_phase: Option<String>,
    pulses: f64,
    start: Option<f64>,
    end: Option<f64>,
    speed_tolerance: f64,
    slip: f64,
}

/// Frequencies, Hz, and amplitudes of a spectrum.
type Lines<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

/// Verdict of a signal on its bearing, the samples that were evaluated, and the spectrum of their squared envelope.
#[pyfunction]
pub fn vibration<'py>(
    py: Python<'py>,
    request: SignalRequest,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyArray1<f64>>, Lines<'py>)> {
    let question = SignalQuestion {
        file: request.file,
        channel: request.channel,
        rate_hz: request.rate,
        bearing: request.bearing,
        angle_deg: request.angle,
        speed: request.speed,
        key_phase: request.key_phase.map(|column| (column, request.pulses)),
        window: Window { from_s: request.start, to_s: request.end },
        speed_tolerance_percent: request.speed_tolerance,
        slip_percent: request.slip,
    };
    let (found, _) = watched(py, None, false, move |_| diagnosed(&question, &Limits::NORMAL))?;
    let found = found.map_err(|failure| error::study(py, failure))?;
    let (answer, spectrum) = (to_python(py, &found)?, found.diagnosis.envelope);
    let lines = (PyArray1::from_vec(py, spectrum.frequency_hz), PyArray1::from_vec(py, spectrum.amplitude));
    Ok((answer, PyArray1::from_vec(py, found.samples), lines))
}

/// Makes a whole recording of a damaged one.
#[pyfunction]
pub fn recover<'py>(py: Python<'py>, recording: PathBuf, output: PathBuf, force: bool) -> PyResult<Bound<'py, PyAny>> {
    let (done, _) = watched(py, None, true, move |_| tribodyn_study::recover(&recording, &output, force))?;
    to_python(py, &done.map_err(|failure| error::study(py, failure))?)
}

/// The Foxglove layout for recordings of a case, or for any.
#[pyfunction]
pub fn layout(py: Python<'_>, case: Option<&NativeCase>, solution: bool) -> PyResult<String> {
    let kind = if solution { LayoutKind::Solution } else { LayoutKind::Run };
    let layout = match case {
        Some(case) => layout_of(&case.file, kind).map_err(|failure| error::study(py, failure))?,
        None => Layout::general(kind),
    };
    Ok(layout.json())
}
