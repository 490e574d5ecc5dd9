//! Several bearings: pairs, sets, shafts; and one bearing under one load on one page.

use crate::answers::equations;
use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error::{self, internal};
use crate::watch::{searching, watched};
use pyo3::prelude::*;
use serde::Serialize;
use std::path::PathBuf;
use std::sync::Arc;
use tribodyn::answers::{Equations, PairSetting, pair as solved_pair};
use tribodyn::pair::{Arrangement, Preload};
use tribodyn::sheet::{SheetQuestion, sheet as bearing_sheet};
use tribodyn::{Change, Limits};
use tribodyn_study::StudyError;
use tribodyn_study::preload::{SetPreload, SetQuestion, bearing_set, pressed, sides};
use tribodyn_study::shaft::{ShaftFile, shaft_outcome};

/// A finite number that a rule allows.
fn number(py: Python<'_>, name: &str, value: f64, rule: impl Fn(f64) -> bool, allowed: &str) -> PyResult<f64> {
    if value.is_finite() && rule(value) {
        return Ok(value);
    }
    Err(error::argument(py, name, &value.to_string(), &format!("allowed is {allowed}")))
}

/// Work that no search watches, on a thread of its own.
fn answer<'py, T: Serialize + Send + 'static>(
    py: Python<'py>,
    work: impl FnOnce() -> Result<T, StudyError> + Send + 'static,
) -> PyResult<Bound<'py, PyAny>> {
    let (answer, _) = watched(py, None, false, move |_| work())?;
    to_python(py, &answer.map_err(|failure| error::study(py, failure))?)
}

/// The preload of two bearings: the gap that clamping closes, um, or the force of a spring, N.
type Pressed = (Option<f64>, Option<f64>);

/// Two like bearings on one rigid shaft.
#[pyfunction]
pub fn pair<'py>(
    py: Python<'py>,
    case: &NativeCase,
    arrangement: &str,
    distance_mm: f64,
    pressed: Pressed,
    model: Option<&str>,
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let arrangement = match arrangement.to_ascii_lowercase().as_str() {
        "db" => Arrangement::BackToBack,
        "df" => Arrangement::FaceToFace,
        "dt" => Arrangement::Tandem,
        _ => return Err(error::argument(py, "arrangement", arrangement, "allowed are DB, DF, DT")),
    };
    let preload = match pressed {
        (Some(um), None) => Preload::OffsetM(1e-6 * number(py, "offset", um, |_| true, "a finite number of um")?),
        (None, Some(n)) => Preload::SpringN(number(py, "spring", n, |n| n >= 0.0, "0 N or more")?),
        _ => return Err(error::argument(py, "offset", "None", "allowed is one of offset and spring")),
    };
    let distance = 1e-3 * number(py, "distance", distance_mm, |mm| mm >= 0.0, "0 mm or more")?;
    let setting = PairSetting { arrangement, distance, preload };
    let file = Arc::clone(&case.file);
    let equations = model.map_or(Ok(Equations::usual(&file.case)), |model| equations(py, model))?;
    let found = searching(py, time_limit, move |watch| {
        let answer = solved_pair(&file.question(watch), equations, setting)?;
        Ok::<_, StudyError>(serde_json::to_value(&answer)?)
    })?;
    to_python(py, &found.map_err(|failure| error::study(py, failure))?)
}

/// Bearings side by side, pressed against each other: preload and the condition in which it is given, or an offset in
/// um, or the force of a spring in N.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SetRequest {
    arrangement: Option<String>,
    sides: Option<String>,
    preload: Option<f64>,
    given: String,
    offset: Option<f64>,
    spring: Option<f64>,
    loads: Vec<f64>,
    speeds: Vec<f64>,
    warmer: Vec<f64>,
}

impl SetRequest {
    fn pressed(&self, py: Python<'_>, sides: &[bool]) -> PyResult<SetPreload> {
        let condition = match self.given.as_str() {
            "unmounted" => SetPreload::UnmountedN,
            "mounted" => SetPreload::MountedN,
            "running" => SetPreload::RunningN,
            other => return Err(error::argument(py, "given", other, "allowed are unmounted, mounted, running")),
        };
        let force = self.preload.map(|force| (force, condition));
        pressed(sides, force, self.offset, self.spring).map_err(|failure| error::study(py, failure))
    }
}

/// A set of like bearings.
#[pyfunction]
pub fn set<'py>(py: Python<'py>, case: &NativeCase, request: SetRequest) -> PyResult<Bound<'py, PyAny>> {
    let sides = sides(request.arrangement.as_deref(), request.sides.as_deref());
    let sides = sides.map_err(|failure| error::study(py, failure))?;
    let pressed = request.pressed(py, &sides)?;
    for load in &request.loads {
        number(py, "loads", *load, |_| true, "finite loads in N")?;
    }
    for speed in &request.speeds {
        number(py, "speeds", *speed, |rpm| rpm >= 0.0, "speeds of 0 r/min or more")?;
    }
    for kelvin in &request.warmer {
        number(py, "warmer", *kelvin, |_| true, "finite temperatures in K")?;
    }
    let SetRequest { loads, speeds: speeds_rpm, warmer: warmer_k, .. } = request;
    let question = SetQuestion { sides, preload: pressed, loads, speeds_rpm, warmer_k };
    let file = Arc::clone(&case.file);
    answer(py, move || bearing_set(&file.name, &file.case, &question))
}

/// A bearing under a radial and an axial load, N, at a speed, r/min.
#[pyfunction]
pub fn sheet<'py>(
    py: Python<'py>,
    case: &NativeCase,
    radial: f64,
    axial: f64,
    speed: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let question = SheetQuestion {
        radial: number(py, "radial", radial, |n| n >= 0.0, "0 N or more")?,
        axial: number(py, "axial", axial, |_| true, "a finite force in N")?,
        speed: number(py, "speed", speed, |_| true, "a finite speed in r/min")? * std::f64::consts::PI / 30.0,
    };
    let file = Arc::clone(&case.file);
    answer(py, move || bearing_sheet(&file.name, &file.case, &question).map_err(StudyError::from))
}

/// A shaft in its bearings, by its file with changes; modes at some speeds, r/min, up to a frequency, Hz.
#[pyfunction]
pub fn shaft<'py>(
    py: Python<'py>,
    path: PathBuf,
    changes: Vec<(String, String)>,
    modes: Vec<f64>,
    up_to: f64,
) -> PyResult<Bound<'py, PyAny>> {
    number(py, "up_to", up_to, |hz| hz > 0.0, "a frequency above 0 Hz")?;
    let change = |(path, value): (String, String)| Change::new(format!("{path} = {value}"), &path, &value);
    let changes: Vec<Change> = changes.into_iter().map(change).collect();
    answer(py, move || {
        let file = ShaftFile::read(&path, &changes, &Limits::NORMAL)?;
        shaft_outcome(&file, &modes, up_to)
    })
}

/// The bearings of the built-in list with a part of a designation, or a pattern.
#[pyfunction]
pub fn catalogue<'py>(py: Python<'py>, pattern: &str) -> PyResult<Bound<'py, PyAny>> {
    let found = tribodyn_study::listed(pattern).map_err(|failure| error::study(py, failure))?;
    let value = serde_json::to_value(&found).map_err(|failure| internal(py, &failure.to_string()))?;
    to_python(py, &value)
}
