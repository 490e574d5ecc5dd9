//! Single questions about a case or a contact.

use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error::{self, internal};
use crate::solution::{Plain, Solved};
use crate::watch::searching;
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::sync::Arc;
use tribodyn::CaseFile;
use tribodyn::answers::{self, ContactFilmQuestion, Equations, HertzQuestion, OrbitAnswer, Question};
use tribodyn_bearing::SearchWatch;
use tribodyn_bearing::quantities::{Facts, OfBall, Scope, joined};
use tribodyn_contact::Body;
use tribodyn_quasistatic::SOLUTION;
use tribodyn_study::StudyError;

/// Equations by their name.
pub fn equations(py: Python<'_>, model: &str) -> PyResult<Equations> {
    Equations::parse(model).map_err(|failure| error::study(py, failure))
}

/// The equilibrium or the steady orbit of a case.
#[pyfunction]
pub fn solve<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: &str,
    roots: bool,
    time_limit: f64,
) -> PyResult<Plain<'py>> {
    limit(py, time_limit)?;
    let file = Arc::clone(&case.file);
    let solved = match equations(py, model)?.equilibrium() {
        Some(model) => searching(py, time_limit, move |watch| equilibrium(&file, (model, roots), watch))?,
        None if roots => {
            return Err(error::argument(
                py,
                "roots",
                "True",
                "the steady orbit is not searched for other equilibria; the model \"traction\" is",
            ));
        }
        None => searching(py, time_limit, move |watch| orbit(&file, watch))?,
    };
    solved.map_err(|failure| error::study(py, failure))?.plain(py)
}

/// A limit on processor time, s.
fn limit(py: Python<'_>, seconds: f64) -> PyResult<()> {
    if seconds > 0.0 {
        return Ok(());
    }
    Err(error::argument(py, "time_limit", &seconds.to_string(), "allowed are seconds above 0, or inf"))
}

fn equilibrium(
    file: &CaseFile,
    (model, roots): (tribodyn_quasistatic::Model, bool),
    watch: SearchWatch,
) -> Result<Solved, StudyError> {
    let mut answer = answers::equilibrium(&file.question(watch), model, roots)?;
    // The head is what the command prints; balls are handed out as an array.
    let balls = std::mem::take(&mut answer.solution.balls);
    let head = serde_json::to_value(&answer)?;
    let mut solution = answer.solution;
    solution.balls = balls;
    Ok(Solved::new(head, solution, None))
}

fn orbit(file: &CaseFile, watch: SearchWatch) -> Result<Solved, StudyError> {
    let answer = OrbitAnswer::with_sensitivities(&file.question(watch))?;
    let head = serde_json::to_value(&answer)?;
    Ok(Solved::new(head, answer.solution, Some(answer.round)))
}

/// A question whose answer is plain data, asked on a thread of its own that an interrupt ends.
fn ask<'py>(
    py: Python<'py>,
    (case, time_limit): (&NativeCase, f64),
    question: impl FnOnce(&Question<'_>) -> Result<Value, StudyError> + Send + 'static,
) -> PyResult<Bound<'py, PyAny>> {
    limit(py, time_limit)?;
    let file = Arc::clone(&case.file);
    let answer = searching(py, time_limit, move |watch| question(&file.question(watch)))?;
    to_python(py, &answer.map_err(|failure| error::study(py, failure))?)
}

/// Numbers that follow from a case before anything is solved, and what becomes of a flow (kg/s) that takes up a heat
/// (W).
#[pyfunction]
pub fn check<'py>(py: Python<'py>, case: &NativeCase, flow: Option<[f64; 2]>) -> PyResult<Bound<'py, PyAny>> {
    if let Some(value) = flow.into_iter().flatten().find(|value| !(*value > 0.0 && value.is_finite())) {
        return Err(crate::error::argument(py, "flow", &value.to_string(), "flow and power are numbers above 0"));
    }
    ask(py, (case, f64::INFINITY), move |question| {
        let mut derived = answers::derived(question)?;
        if let Some([flow, power]) = flow {
            derived.heated_flow = Some(answers::heated_flow(question, flow, power)?);
        }
        Ok(serde_json::to_value(derived)?)
    })
}

/// Rating life and static safety.
#[pyfunction]
pub fn rating<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: Option<&str>,
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let equations = model.map(|model| equations(py, model)).transpose()?;
    ask(py, (case, time_limit), move |question| Ok(serde_json::to_value(answers::rated(question, equations)?)?))
}

/// Stiffness at each of some speeds, r/min.
#[pyfunction]
pub fn stiffness<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: &str,
    speeds: Vec<f64>,
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let equations = equations(py, model)?;
    ask(py, (case, time_limit), move |question| {
        Ok(serde_json::to_value(answers::stiffness(question, equations, &speeds)?)?)
    })
}

/// Natural modes up to a frequency, Hz.
#[pyfunction]
pub fn modes<'py>(
    py: Python<'py>,
    case: &NativeCase,
    up_to: f64,
    all: bool,
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    ask(py, (case, time_limit), move |question| Ok(serde_json::to_value(answers::modes(question, up_to, all)?)?))
}

/// Friction torque by cause.
#[pyfunction]
pub fn torque<'py>(py: Python<'py>, case: &NativeCase, model: &str, time_limit: f64) -> PyResult<Bound<'py, PyAny>> {
    let equations = equations(py, model)?;
    ask(py, (case, time_limit), move |question| Ok(serde_json::to_value(answers::torque(question, equations)?)?))
}

/// Temperatures from friction: of the surroundings (°C), cooling over the usual one, width (mm), oil flow (l/min).
#[pyfunction]
pub fn heat<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: &str,
    surroundings: (f64, f64, Option<f64>, f64),
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let equations = equations(py, model)?;
    let (temperature_deg_c, cooling, width_mm, oil_flow_l_min) = surroundings;
    let surroundings = answers::Surroundings { temperature_deg_c, cooling, width_mm, oil_flow_l_min };
    ask(py, (case, time_limit), move |question| {
        Ok(serde_json::to_value(answers::heat(question, equations, &surroundings)?)?)
    })
}

/// Lubricant films of all contacts of a case.
#[pyfunction]
pub fn films<'py>(py: Python<'py>, case: &NativeCase, model: &str, time_limit: f64) -> PyResult<Bound<'py, PyAny>> {
    let equations = equations(py, model)?;
    ask(py, (case, time_limit), move |question| Ok(serde_json::to_value(answers::films(question, equations)?)?))
}

/// One lubricated contact of two like bodies.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct FilmRequest {
    oil: String,
    temperature: f64,
    load: f64,
    speed: f64,
    radius: f64,
    across: f64,
    slide_to_roll: f64,
    roughness: f64,
    starvation: f64,
    young: f64,
    poisson: f64,
}

/// The lubricant film of one contact; radii in mm, temperature in °C, roughness in um.
#[pyfunction]
pub fn contact_film<'py>(py: Python<'py>, request: FilmRequest) -> PyResult<Bound<'py, PyAny>> {
    let question = ContactFilmQuestion {
        oil: request.oil,
        temperature_deg_c: request.temperature,
        starvation: request.starvation,
        roughness_um: request.roughness,
        load_n: request.load,
        speed_m_s: request.speed,
        slide_to_roll: request.slide_to_roll,
        rolling_radius_mm: request.radius,
        lateral_radius_mm: request.across,
        young_gpa: request.young,
        poisson: request.poisson,
    };
    let (oil, film) = answers::contact_film(&question).map_err(|failure| error::study(py, failure))?;
    let mut answer = serde_json::to_value(&film).map_err(|failure| internal(py, &failure.to_string()))?;
    answer["oil"] = serde_json::to_value(oil).map_err(|failure| internal(py, &failure.to_string()))?;
    to_python(py, &answer)
}

/// One Hertz contact; radii in mm, moduli in GPa.
#[pyfunction]
pub fn hertz<'py>(
    py: Python<'py>,
    radii: [[f64; 2]; 2],
    load: f64,
    young: [f64; 2],
    poisson: [f64; 2],
    angle: f64,
    length: Option<f64>,
) -> PyResult<Bound<'py, PyAny>> {
    for (name, radii) in ["body1", "body2"].into_iter().zip(radii) {
        if radii.iter().any(|r| r.is_nan() || *r == 0.0) {
            let allowed = "allowed are two radii in mm, each a number other than 0 (negative for concave) or inf";
            return Err(error::argument(py, name, &format!("{radii:?}"), allowed));
        }
    }
    let bodies = radii.map(|[x, y]| Body { radius_x: x / 1000.0, radius_y: y / 1000.0 });
    let question = HertzQuestion { bodies, load_n: load, young_gpa: young, poisson, angle_deg: angle };
    let refused = |failure| error::study(py, failure);
    match length {
        Some(length) => to_python(py, &answers::hertz_line(&question, length / 1000.0).map_err(refused)?),
        None => to_python(py, &answers::hertz(&question).map_err(refused)?),
    }
}

/// The traction curve of a coating at a pressure in GPa.
#[pyfunction]
pub fn traction_curve<'py>(
    py: Python<'py>,
    coating: &str,
    pressure: f64,
    slip: Vec<f64>,
    order: usize,
) -> PyResult<Bound<'py, PyAny>> {
    let curve = answers::traction_curve(coating, pressure, &slip, order);
    let curve = curve.map_err(|failure| error::study(py, failure))?;
    let mut answer = serde_json::to_value(&curve).map_err(|failure| internal(py, &failure.to_string()))?;
    answer["note"] = json!(curve.note);
    to_python(py, &answer)
}

/// The table of quantities: of the bearing in equilibrium, and of a ball with its contacts.
#[pyfunction]
pub fn quantities<'py>(py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
    let row = |name: String, shown: String, facts: &Facts| {
        let models = match facts.scope {
            Scope::All => "all",
            Scope::Traction => "traction",
            Scope::Lubricated => "lubricated",
            Scope::Run => "run",
        };
        json!({
            "name": name, "unit": facts.unit.symbol, "about": facts.about, "models": models,
            "recorded_name": shown, "recorded_unit": facts.shown.symbol,
        })
    };
    let bearing = SOLUTION.iter().map(|q| {
        let f = &q.facts;
        row(joined(&[f.name, f.unit.suffix]), joined(&[f.name, f.shown.suffix]), f)
    });
    let ball = OfBall::all().map(|q| row(q.name_in(q.facts().unit), q.name_in(q.facts().shown), q.facts()));
    to_python(py, &json!({ "bearing": bearing.collect::<Vec<_>>(), "ball": ball.collect::<Vec<_>>() }))
}
