//! Figures as text, for notebooks.

use crate::error::internal;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribodyn_quasistatic::Solution;

/// Figures of a solution over the azimuth, by name, as SVG.
pub fn of_solution<'py>(py: Python<'py>, solution: &Solution) -> PyResult<Bound<'py, PyDict>> {
    let drawn = py.detach(|| tribodyn_plot::solution_figures(&[("this case", solution)], &[]));
    let figures = drawn.map_err(|error| internal(py, &error.to_string()))?;
    let dict = PyDict::new(py);
    figures.iter().try_for_each(|figure| dict.set_item(&figure.name, figure.svg()))?;
    Ok(dict)
}
