//! Solutions as plain values: what the command prints, and the numbers of the balls as tables.

use crate::convert::{from_python, to_python};
use crate::error::internal;
use crate::figures;
use numpy::{PyArray2, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::Value;
use tribodyn_bearing::BallResult;
use tribodyn_bearing::quantities::{OfBall, joined};
use tribodyn_quasistatic::{Model, SOLUTION, Solution};

/// Numbers of balls: names, and an array with a row for each ball.
pub type Table<'py> = (Vec<String>, Bound<'py, PyArray2<f64>>);

/// All but the balls, the balls, and for a steady orbit a ball round it.
pub type Plain<'py> = (Bound<'py, PyAny>, Table<'py>, Option<Table<'py>>);

/// An equilibrium or a steady orbit.
pub struct Solved {
    /// The answer that the command prints, without the balls.
    head: Value,
    /// The balls where an equilibrium has them.
    solution: Solution,
    /// A ball round its orbit, for a steady orbit.
    points: Option<Solution>,
}

impl Solved {
    /// From what the command prints.
    pub fn new(mut head: Value, solution: Solution, points: Option<Solution>) -> Self {
        if let Some(fields) = head.as_object_mut() {
            fields.remove("balls");
            fields.remove("points");
        }
        Self { head, solution, points }
    }

    /// As Python has it.
    pub fn plain<'py>(&self, py: Python<'py>) -> PyResult<Plain<'py>> {
        let points = self.points.as_ref().map(|points| table(py, points)).transpose()?;
        Ok((to_python(py, &self.head)?, table(py, &self.solution)?, points))
    }
}

/// The table of all balls; NaN where a ball does not have what others have.
fn table<'py>(py: Python<'py>, solution: &Solution) -> PyResult<Table<'py>> {
    let held = |q: &OfBall| solution.balls.iter().any(|ball| q.get(ball).is_some());
    let quantities: Vec<OfBall> = OfBall::all().filter(held).collect();
    let names: Vec<String> = quantities.iter().map(|q| q.name_in(q.facts().unit)).collect();
    let value = |q: &OfBall, ball| q.get(ball).map_or(f64::NAN, |value| value * q.facts().unit.per_si);
    let rows: Vec<Vec<f64>> =
        solution.balls.iter().map(|ball| quantities.iter().map(|q| value(q, ball)).collect()).collect();
    let array = PyArray2::from_vec2(py, &rows).map_err(|error| internal(py, &error.to_string()))?;
    Ok((names, array))
}

/// Figures over the azimuth as SVG, by name: of the numbers that [`Solved::plain`] gave.
#[pyfunction]
pub fn solution_figures<'py>(
    py: Python<'py>,
    head: &Bound<'py, PyDict>,
    names: Vec<String>,
    values: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let head = from_python(head)?;
    let rows = values.as_array();
    let solution = solution(&head, &names, rows.rows().into_iter().map(|row| row.to_vec()));
    figures::of_solution(py, &solution)
}

/// A solution from its numbers by name.
fn solution(head: &Value, names: &[String], rows: impl Iterator<Item = Vec<f64>>) -> Solution {
    let number = |name: &str| head.get(name).and_then(Value::as_f64);
    let quantities: Vec<Option<OfBall>> =
        names.iter().map(|name| OfBall::all().find(|q| q.name_in(q.facts().unit) == *name)).collect();
    let ball = |row: Vec<f64>| {
        let mut ball = BallResult::default();
        for (q, value) in quantities.iter().zip(row) {
            if let Some(q) = q.as_ref().filter(|_| !value.is_nan()) {
                q.set(&mut ball, value / q.facts().unit.per_si);
            }
        }
        ball
    };
    let raceway_control = head.get("model").and_then(Value::as_str) == Some(Model::JonesHarris.name());
    let model = if raceway_control { Model::JonesHarris } else { Model::Traction };
    let mut solution = Solution {
        converged: head.get("converged").and_then(Value::as_bool).unwrap_or(false),
        stable: head.get("stable").and_then(Value::as_bool),
        residual: number("residual").unwrap_or(f64::NAN),
        ..Solution::of_balls(model, rows.map(ball).collect())
    };
    for q in &SOLUTION {
        if let Some(value) = number(&joined(&[q.facts.name, q.facts.unit.suffix])) {
            (q.set)(&mut solution, value / q.facts.unit.per_si);
        }
    }
    solution
}
