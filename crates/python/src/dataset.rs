//! Data sets of vibration signals with labels.

use crate::convert::to_python;
use crate::error;
use crate::runs::pool;
use crate::watch::watched_by;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tribodyn::Limits;
use tribodyn_study::Ours;
use tribodyn_study::dataset::{Dataset, TABLE};

/// A plan with its cases.
fn planned(py: Python<'_>, plan: &Path) -> PyResult<Dataset> {
    Dataset::read(plan, &Limits::NORMAL).map_err(|failure| error::study(py, failure))
}

/// Number of members of a plan.
#[pyfunction]
pub fn dataset_members(py: Python<'_>, plan: PathBuf) -> PyResult<usize> {
    Ok(planned(py, &plan)?.members())
}

/// How a data set is written: MATLAB files too, finished members forgotten, a table of others replaced.
type Choices = (bool, bool, bool);

/// Makes a data set; `progress` gets the number of finished members. An interrupt keeps those.
#[pyfunction]
pub fn dataset<'py>(
    py: Python<'py>,
    plan: PathBuf,
    output: PathBuf,
    choices: Choices,
    threads: usize,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (mat, restart, force) = choices;
    let (set, pool) = (planned(py, &plan)?, pool(py, threads)?);
    let stop = Arc::new(AtomicBool::new(false));
    let asked = Arc::clone(&stop);
    let (report, stopped) = watched_by(py, progress, (true, stop), move |watch| {
        Ours::Table.may_replace(&output.join(TABLE), &plan, force)?;
        let counted = |count: usize| watch.add(count as f64);
        pool.install(|| set.make(&output, (mat, restart), &asked, counted))
    })?;
    match stopped {
        Some(stopped) => Err(stopped),
        None => to_python(py, &report.map_err(|failure| error::study(py, failure))?),
    }
}
