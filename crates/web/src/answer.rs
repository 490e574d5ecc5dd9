//! Answers to the page.

use crate::curve::curve;
use crate::question::{Form, Question, operation};
use crate::vibration::vibration;
use serde::Serialize;
use serde_json::{Value, json};
use tribodyn::answers::{Equations, OrbitAnswer, derived, equilibrium, films, torque};
use tribodyn::sheet::sheet;
use tribodyn::{AnswerError, Case, CaseFile, Model, SearchWatch, search_bearings};

/// Answers a question in JSON; a failure is `{"error": …}`. Searches are followed by a watch.
pub fn ask(question: &str, watch: &SearchWatch) -> String {
    let answered = serde_json::from_str(question)
        .map_err(|error| json!({ "error": format!("a question that is not understood: {error}") }))
        .and_then(|question| answer(question, watch).map_err(|error| failure(&error)));
    answered.unwrap_or_else(|failure| failure).to_string()
}

fn answer(question: Question, watch: &SearchWatch) -> Result<Value, AnswerError> {
    match question {
        Question::Catalogue { pattern } => Ok(catalogue(&pattern)),
        Question::Case(form) => Ok(json!({ "text": form.text()? })),
        Question::Quick(form) => quick(&form, watch),
        Question::Full(form) => {
            let file = form.case()?;
            let equations = shown(&file.case);
            full(&file, equations, watch)
        }
        Question::Orbit(form) => full(&form.case()?, Equations::SteadyOrbit, watch),
        Question::Vibration { form, signal } => vibration(&form, &signal),
        Question::Curve { form, range } => Ok(written(curve(&form.case()?, &range)?)),
    }
}

/// Equations of the answer with friction: in oil the equilibrium, which has the films; the orbit follows on request.
fn shown(case: &Case) -> Equations {
    if case.lubricant.is_some() { Equations::Traction } else { Equations::usual(case) }
}

/// A failure, with the field of the form that it is about where there is one.
fn failure(error: &AnswerError) -> Value {
    match error {
        AnswerError::Argument { name, .. } => json!({ "error": error.to_string(), "field": name }),
        AnswerError::Catalogue(_) => json!({ "error": error.to_string(), "field": "designation" }),
        _ => json!({ "error": error.to_string() }),
    }
}

fn written(value: impl Serialize) -> Value {
    serde_json::to_value(value).unwrap_or_else(|error| json!({ "error": error.to_string() }))
}

/// A part of an answer: others stand where it fails.
fn part(value: Result<impl Serialize, AnswerError>) -> Value {
    match value {
        Ok(value) => written(value),
        Err(error) => failure(&error),
    }
}

fn catalogue(pattern: &str) -> Value {
    let found = search_bearings(pattern).into_iter().map(|bearing| {
        let mm = |metres: f64| (metres * 1e7).round() * 1e-4;
        let size = bearing.envelope;
        json!({
            "designation": bearing.designation,
            "bore": mm(size.bore),
            "outside": mm(size.outside),
            "width": mm(size.width),
            "angle": size.contact_angle.to_degrees(),
        })
    });
    Value::Array(found.collect())
}

/// Answers that take milliseconds, by raceway control.
fn quick(form: &Form, watch: &SearchWatch) -> Result<Value, AnswerError> {
    let file = form.case()?;
    let question = file.question(watch.clone());
    Ok(json!({
        "text": file.text,
        "usual_model": shown(&file.case).name(),
        "derived": part(derived(&question)),
        "solution": part(equilibrium(&question, Model::JonesHarris, false)),
        "sheet": part(sheet(&file.name, &file.case, &operation(&file))),
    }))
}

/// By a model with friction.
fn full(file: &CaseFile, equations: Equations, watch: &SearchWatch) -> Result<Value, AnswerError> {
    let question = file.question(watch.clone());
    let Some(model) = equations.equilibrium() else {
        return Ok(json!({ "solution": OrbitAnswer::of(&question)? }));
    };
    let solution = equilibrium(&question, model, false)?;
    if model == Model::JonesHarris {
        return Ok(json!({ "solution": solution }));
    }
    let films = file.case.lubricant.is_some().then(|| part(films(&question, equations)));
    Ok(json!({ "solution": solution, "films": films, "torque": part(torque(&question, equations)) }))
}
