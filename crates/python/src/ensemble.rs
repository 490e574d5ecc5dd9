//! Ensembles: transient runs with values drawn at random.

use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error;
use crate::runs::pool;
use crate::sweep::table_arrays;
use crate::watch::watched;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tribodyn::Change;
use tribodyn_study::ensemble::{Ensemble, EnsembleOptions, Sampling, Spread};
use tribodyn_study::{Ours, StudyError};

/// The settings of an ensemble.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct EnsembleRequest {
    spreads: Vec<(String, String)>,
    grid: Vec<(String, String)>,
    members: usize,
    seed: u64,
    latin_hypercube: bool,
    duration: Option<f64>,
    threads: usize,
    output: Option<PathBuf>,
    restart: bool,
    force: bool,
}

/// The summary, and the columns of all members by name.
type Finished<'py> = (Bound<'py, PyAny>, Bound<'py, PyDict>);

/// Runs all members; `progress` gets the number of those that are finished. An interrupt leaves out members that have
/// not begun and keeps the finished ones beside the table.
#[pyfunction]
pub fn ensemble<'py>(
    py: Python<'py>,
    case: &NativeCase,
    request: EnsembleRequest,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Finished<'py>> {
    let mut spreads = Vec::with_capacity(request.spreads.len());
    for (path, spread) in &request.spreads {
        let refused = |allowed: String| error::argument(py, path, spread, &allowed);
        spreads.push(Spread::parse(&format!("{path}={spread}")).map_err(refused)?);
    }
    for (path, values) in &request.grid {
        let refused = |allowed: String| error::argument(py, path, values, &allowed);
        spreads.push(Spread::each(&format!("{path}={values}")).map_err(refused)?);
    }
    let (file, limits, pool) = (Arc::clone(&case.file), case.limits, pool(py, request.threads)?);
    let (finished, stopped) = watched(py, progress, true, move |watch| {
        let sampling = match request.latin_hypercube {
            _ if !request.grid.is_empty() => Sampling::Grid,
            true => Sampling::LatinHypercube,
            false => Sampling::Independent,
        };
        let options = EnsembleOptions { members: request.members, seed: request.seed, sampling };
        let duration =
            |seconds: f64| Change::new(format!("duration = {seconds}"), "transient.duration", &format!("s({seconds})"));
        let fixed: Vec<Change> = request.duration.map(duration).into_iter().collect();
        let ensemble = Ensemble::new((&file.name, file.text.clone()), &fixed, &spreads, options, &limits)?;
        let stop = AtomicBool::new(false);
        let counted = || {
            watch.add(1.0);
            stop.fetch_or(watch.stopped(), Ordering::Relaxed);
        };
        let outcome = match &request.output {
            None => pool.install(|| ensemble.run(&stop, |_| counted())),
            Some(path) => {
                Ours::Table.may_replace(path, file.name.as_ref(), request.force)?;
                let mut table = ensemble.table(path, request.restart)?;
                watch.add(table.resumed() as f64);
                let outcome = pool.install(|| table.run(&stop, |_| counted()))?;
                table.write(&outcome.members)?;
                outcome
            }
        };
        let columns = ensemble.columns();
        let rows = outcome.members.iter().map(|member| ensemble.row(member)).collect();
        Ok::<_, StudyError>((serde_json::to_value(ensemble.report(&outcome))?, columns, rows))
    })?;
    match (finished, stopped) {
        (_, Some(stopped)) => Err(stopped),
        (Ok((report, columns, rows)), None) => Ok((to_python(py, &report)?, table_arrays(py, &columns, rows)?)),
        (Err(failure), None) => Err(error::study(py, failure)),
    }
}
