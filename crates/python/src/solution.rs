//! A solution that stays in Rust until its numbers are asked for.

use crate::convert::to_python;
use crate::error::internal;
use crate::figures;
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use tribodyn_bearing::quantities::OfBall;
use tribodyn_quasistatic::Solution;

/// Numbers of balls: names, and an array with a row for each ball.
pub type Table<'py> = (Vec<String>, Bound<'py, PyArray2<f64>>);

/// An equilibrium or a steady orbit.
#[pyclass(frozen, name = "Solution", module = "tribodyn._native")]
pub struct NativeSolution {
    /// What the command prints, without the balls.
    pub head: serde_json::Value,
    /// The balls where an equilibrium has them.
    pub solution: Solution,
    /// A ball round its orbit, for a steady orbit.
    pub points: Option<Solution>,
}

impl NativeSolution {
    /// From what the command prints.
    pub fn new(mut head: serde_json::Value, solution: Solution, points: Option<Solution>) -> Self {
        if let Some(fields) = head.as_object_mut() {
            fields.remove("balls");
            fields.remove("points");
        }
        Self { head, solution, points }
    }
}

#[pymethods]
impl NativeSolution {
    /// All but the balls, by name.
    fn head<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.head)
    }

    /// The balls.
    fn balls<'py>(&self, py: Python<'py>) -> PyResult<Table<'py>> {
        table(py, &self.solution)
    }

    /// A ball round its orbit; None for an equilibrium.
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Option<Table<'py>>> {
        self.points.as_ref().map(|points| table(py, points)).transpose()
    }

    /// Figures over the azimuth as SVG, by name.
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        figures::of_solution(py, self.points.as_ref().unwrap_or(&self.solution))
    }
}

fn table<'py>(py: Python<'py>, solution: &Solution) -> PyResult<Table<'py>> {
    let held = |q: &OfBall| solution.balls.first().is_some_and(|ball| q.get(ball).is_some());
    let quantities: Vec<OfBall> = OfBall::all().filter(held).collect();
    let names: Vec<String> = quantities.iter().map(|q| q.name_in(q.facts().unit)).collect();
    let value = |q: &OfBall, ball| q.get(ball).map_or(f64::NAN, |value| value * q.facts().unit.per_si);
    let rows: Vec<Vec<f64>> =
        solution.balls.iter().map(|ball| quantities.iter().map(|q| value(q, ball)).collect()).collect();
    let array = PyArray2::from_vec2(py, &rows).map_err(|error| internal(py, &error.to_string()))?;
    Ok((names, array))
}
