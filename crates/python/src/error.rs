//! Failures as the exceptions of the package, with the places and numbers that they are about.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::Path;
use tribodyn::{AnswerError, RefusedCase};
use tribodyn_case::CaseError;
use tribodyn_identify::IdentifyError;
use tribodyn_orbit::OrbitError;
use tribodyn_quasistatic::QuasiStaticError;
use tribodyn_record::RecordError;
use tribodyn_report::ReportError;
use tribodyn_study::{StudyError, with_causes};

/// An exception of `tribodyn._errors` by its name.
fn exception(py: Python<'_>, name: &str, message: &str, facts: &Bound<'_, PyDict>) -> PyErr {
    let made = py
        .import("tribodyn._errors")
        .and_then(|module| module.getattr(name))
        .and_then(|class| class.call((message,), Some(facts)));
    match made {
        Ok(exception) => PyErr::from_value(exception),
        Err(error) => error,
    }
}

/// An exception with facts that are set one by one.
fn with_facts(
    py: Python<'_>,
    name: &str,
    message: &str,
    set: impl FnOnce(&Bound<'_, PyDict>) -> PyResult<()>,
) -> PyErr {
    let facts = PyDict::new(py);
    match set(&facts) {
        Ok(()) => exception(py, name, message, &facts),
        Err(error) => error,
    }
}

/// An argument that is refused.
pub fn argument(py: Python<'_>, name: &str, value: &str, allowed: &str) -> PyErr {
    with_facts(py, "InputError", &format!("{name} = {value}: {allowed}"), |facts| {
        facts.set_item("path", name)?;
        facts.set_item("value", value)?;
        facts.set_item("allowed", allowed)
    })
}

/// Something that should not happen: a fault of the program.
pub fn internal(py: Python<'_>, message: &str) -> PyErr {
    exception(py, "TribodynError", &format!("a fault of the program: {message}"), &PyDict::new(py))
}

/// The part of a message that says what is allowed; all of it where no part does.
fn allowed(message: &str) -> &str {
    message.find("allowed").map_or(message, |at| &message[at..])
}

fn case_facts(facts: &Bound<'_, PyDict>, file: Option<&str>, error: &CaseError) -> PyResult<()> {
    facts.set_item("file", file)?;
    facts.set_item("line", error.line)?;
    facts.set_item("column", error.column)?;
    facts.set_item("path", &error.path)?;
    facts.set_item("value", &error.value)?;
    facts.set_item("allowed", allowed(&error.message))
}

/// A failure of a procedure.
pub fn study(py: Python<'_>, error: impl Into<StudyError>) -> PyErr {
    let error = error.into();
    let message = error.to_string();
    match &error {
        StudyError::Answer(error) => answer(py, &message, error),
        StudyError::Read { path, .. }
        | StudyError::Write { path, .. }
        | StudyError::NoCheckpoint { checkpoint: path, .. }
        | StudyError::Busy { output: path, .. }
        | StudyError::NotOurs { path, .. }
        | StudyError::OtherRecording { path, .. }
        | StudyError::Merge { path, .. }
        | StudyError::Incomplete { path, .. } => {
            with_facts(py, "FileError", &message, |facts| facts.set_item("file", path.display().to_string()))
        }
        StudyError::NotRecorded { active: path, .. } => {
            with_facts(py, "FileError", &message, |facts| facts.set_item("file", path.display().to_string()))
        }
        StudyError::BrokenOff { file, .. } => {
            with_facts(py, "SolveError", &message, |facts| facts.set_item("file", file))
        }
        StudyError::Json(_) | StudyError::RefusalLost { .. } => internal(py, &message),
        _ => with_facts(py, "InputError", &message, |facts| facts.set_item("allowed", allowed(&message))),
    }
}

/// A report that is not made, of a recording at a path.
pub fn report(py: Python<'_>, path: &Path, error: ReportError) -> PyErr {
    match error {
        ReportError::Study(error) => study(py, error),
        ReportError::Record(error) => record(py, path, &error),
        ReportError::Signal(error) => study(py, error),
        ReportError::Json(error) => study(py, error),
        ReportError::Plot(error) => internal(py, &error.to_string()),
    }
}

/// A question without an answer.
fn answer(py: Python<'_>, message: &str, error: &AnswerError) -> PyErr {
    match error {
        AnswerError::Case(refused) => {
            let RefusedCase { file, error, text, .. } = &**refused;
            with_facts(py, "CaseError", message, |facts| {
                case_facts(facts, Some(file), error)?;
                facts.set_item("text", line_of(text, error.line))
            })
        }
        AnswerError::Change { error, .. } => {
            with_facts(py, "CaseError", message, |facts| case_facts(facts, None, error))
        }
        AnswerError::Argument { name, value, message } => argument(py, name, value, message),
        error if error.is_ended() => exception(py, "SolveError", message, &PyDict::new(py)),
        AnswerError::Solver { file, source } => solver(py, message, file, source),
        AnswerError::Orbit { file, source } => orbit(py, message, file, source),
        _ => with_facts(py, "InputError", message, |facts| facts.set_item("allowed", allowed(message))),
    }
}

/// An equilibrium that is not found, or a case that has none.
fn solver(py: Python<'_>, message: &str, file: &str, source: &QuasiStaticError) -> PyErr {
    match source {
        QuasiStaticError::NotConverged { residual, iterations, .. } => with_facts(py, "SolveError", message, |facts| {
            facts.set_item("file", file)?;
            facts.set_item("residual", *residual)?;
            facts.set_item("iterations", *iterations)
        }),
        QuasiStaticError::Uncertain { .. } => {
            with_facts(py, "SolveError", message, |facts| facts.set_item("file", file))
        }
        _ => with_facts(py, "InputError", message, |facts| facts.set_item("file", file)),
    }
}

fn orbit(py: Python<'_>, message: &str, file: &str, source: &OrbitError) -> PyErr {
    let name = match source {
        OrbitError::NotConverged { .. }
        | OrbitError::Singular
        | OrbitError::Uncertain { .. }
        | OrbitError::Eigenvalues => "SolveError",
        _ => "InputError",
    };
    with_facts(py, name, message, |facts| facts.set_item("file", file))
}

/// A recording that cannot be read.
pub fn record(py: Python<'_>, path: &Path, error: &RecordError) -> PyErr {
    let message = with_causes(error);
    let message =
        if message.contains(&path.display().to_string()) { message } else { format!("{}: {message}", path.display()) };
    with_facts(py, "FileError", &message, |facts| facts.set_item("file", path.display().to_string()))
}

/// A failed identification.
pub fn identify(py: Python<'_>, file: &str, error: &IdentifyError) -> PyErr {
    let message = format!("{file}: {error}");
    let name = match error {
        IdentifyError::NoStart { .. } | IdentifyError::Solver(_) => "SolveError",
        IdentifyError::Case(_) => "CaseError",
        _ => "InputError",
    };
    with_facts(py, name, &message, |facts| match error {
        IdentifyError::Syntax { line, column, message } => {
            facts.set_item("file", file)?;
            facts.set_item("line", *line)?;
            facts.set_item("column", *column)?;
            facts.set_item("allowed", allowed(message))
        }
        IdentifyError::Value { field, value, allowed } => {
            facts.set_item("file", file)?;
            facts.set_item("path", field)?;
            facts.set_item("value", value)?;
            facts.set_item("allowed", *allowed)
        }
        IdentifyError::Path { path } | IdentifyError::NotANumber { path, .. } => {
            facts.set_item("file", file)?;
            facts.set_item("path", path)
        }
        IdentifyError::Case(error) => case_facts(facts, Some(file), error),
        _ => facts.set_item("file", file),
    })
}

/// A line of a text, from 1, short enough for a message.
fn line_of(text: &str, line: usize) -> Option<String> {
    let line = text.lines().nth(line.checked_sub(1)?)?;
    Some(line.chars().take(200).collect())
}
