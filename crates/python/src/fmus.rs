//! Cases as functional mock-up units.

use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error;
use crate::watch::searching;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tribodyn_study::{FmuOptions, StudyError, export_fmu};

/// Writes the FMU of a case.
#[pyfunction]
pub fn fmu<'py>(
    py: Python<'py>,
    case: &NativeCase,
    output: PathBuf,
    compile_and_force: (bool, bool),
    time_limit: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let file = Arc::clone(&case.file);
    let (compile, force) = compile_and_force;
    let options = FmuOptions { compile, force };
    let made = searching(py, time_limit, move |watch| {
        let answer = export_fmu(&file.question(watch), Path::new(&file.name), &output, &options)?;
        Ok::<_, StudyError>(serde_json::to_value(&answer)?)
    })?;
    to_python(py, &made.map_err(|failure| error::study(py, failure))?)
}
