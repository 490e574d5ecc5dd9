//! Weighted least squares with priors, from one start: Levenberg–Marquardt inside bounds, driven by argmin.

use crate::IdentifyError;
use crate::model::{Evaluation, ForwardModel, free};
use crate::problem::{Hypothesis, Parameter, Problem, Scale};
use argmin::core::{Error, Executor, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus};
use nalgebra::{DMatrix, DVector};

/// A problem under one hypothesis, in the coordinates of the fit: bounds at 0 and 1, log scales taken.
#[derive(Debug, Clone)]
pub struct LeastSquares<'a> {
    /// The problem.
    pub problem: &'a Problem,
    /// The model.
    pub model: ForwardModel,
    /// Free parameters, with the priors of the hypothesis.
    pub free: Vec<Parameter>,
}

/// Residuals over their uncertainties at a point, with the solutions behind them.
#[derive(Debug, Clone)]
pub struct Point {
    /// Coordinates between 0 and 1.
    pub coordinates: DVector<f64>,
    /// (model − datum)/uncertainty for each datum, then (value − prior)/spread for each prior.
    pub residuals: DVector<f64>,
    /// The solutions.
    pub evaluation: Evaluation,
}

impl Point {
    /// Sum of squared residuals.
    pub fn cost(&self) -> f64 {
        self.residuals.norm_squared()
    }
}

impl Parameter {
    /// The value at a coordinate between 0 and 1.
    pub fn value(&self, coordinate: f64) -> f64 {
        let (low, high) = self.bounds;
        match self.scale {
            Scale::Linear => low + coordinate * (high - low),
            Scale::Log => low * (coordinate * (high / low).ln()).exp(),
        }
    }

    /// The coordinate of a value.
    pub fn coordinate(&self, value: f64) -> f64 {
        let (low, high) = self.bounds;
        match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log => (value / low).ln() / (high / low).ln(),
        }
    }

    /// Change of the value per coordinate.
    pub(crate) fn slope(&self, value: f64) -> f64 {
        let (low, high) = self.bounds;
        match self.scale {
            Scale::Linear => high - low,
            Scale::Log => value * (high / low).ln(),
        }
    }

    /// (value − prior mean)/spread; on a log scale of the logarithms.
    pub(crate) fn prior_residual(&self, value: f64) -> Option<f64> {
        self.prior.map(|p| match self.scale {
            Scale::Linear => (value - p.mean) / p.spread,
            Scale::Log => (value / p.mean).ln() / p.spread,
        })
    }
}

impl<'a> LeastSquares<'a> {
    /// Prepares a problem under a hypothesis.
    ///
    /// # Errors
    /// Those of [`ForwardModel::new`].
    pub fn new(problem: &'a Problem, case: &str, hypothesis: Option<&Hypothesis>) -> Result<Self, IdentifyError> {
        let own = |index: usize| {
            let parameter = &problem.parameters[index];
            let prior = hypothesis.and_then(|h| h.priors.get(&parameter.name)).copied().or(parameter.prior);
            Parameter { prior, ..parameter.clone() }
        };
        let free = free(problem, hypothesis).into_iter().map(own).collect();
        Ok(Self { problem, model: ForwardModel::new(problem, case, hypothesis)?, free })
    }

    /// The free parameters.
    pub fn parameters(&self) -> impl Iterator<Item = &Parameter> {
        self.free.iter()
    }

    /// Values in the units of the file.
    pub fn values(&self, coordinates: &DVector<f64>) -> Vec<f64> {
        self.parameters().zip(coordinates.iter()).map(|(p, &c)| p.value(c)).collect()
    }

    /// Residuals at a point.
    ///
    /// # Errors
    /// Those of [`ForwardModel::evaluate`].
    pub fn point(&self, coordinates: DVector<f64>, near: Option<&Evaluation>) -> Result<Point, IdentifyError> {
        let values = self.values(&coordinates);
        let evaluation = self.model.evaluate(&values, near)?;
        let data = self.problem.data.iter().map(|d| d.deviation(d.computed(&evaluation)) / d.uncertainty);
        let priors = self.parameters().zip(&values).filter_map(|(p, &v)| p.prior_residual(v));
        let residuals: Vec<f64> = data.chain(priors).map(|r| if r.is_nan() { NOTHING } else { r }).collect();
        Ok(Point { coordinates, residuals: DVector::from_vec(residuals), evaluation })
    }

    /// Sensitivities of the residuals to the coordinates by one-sided differences.
    ///
    /// # Errors
    /// Those of [`ForwardModel::evaluate`].
    pub fn jacobian(&self, at: &Point) -> Result<DMatrix<f64>, IdentifyError> {
        self.differences(at, self.problem.difference, false, |point| point.residuals.clone())
    }

    /// Derivatives of a function of the solutions with respect to the coordinates, by differences of `step`, two-sided
    /// where `central` and the bounds allow it.
    ///
    /// # Errors
    /// Those of [`ForwardModel::evaluate`].
    pub fn differences(
        &self,
        at: &Point,
        step: f64,
        central: bool,
        of: impl Fn(&Point) -> DVector<f64>,
    ) -> Result<DMatrix<f64>, IdentifyError> {
        let here = of(at);
        let mut slopes = DMatrix::zeros(here.len(), self.free.len());
        for k in 0..self.free.len() {
            let moved = |by: f64| {
                let mut coordinates = at.coordinates.clone();
                coordinates[k] += by;
                self.point(coordinates, Some(&at.evaluation)).map(|point| of(&point))
            };
            let (up, down) = (at.coordinates[k] + step <= 1.0, at.coordinates[k] - step >= 0.0);
            let column = match (up, down) {
                (true, true) if central => (moved(step)? - moved(-step)?) / (2.0 * step),
                (true, _) => (moved(step)? - &here) / step,
                (false, _) => (moved(-step)? - &here) / -step,
            };
            slopes.set_column(k, &column);
        }
        Ok(slopes)
    }
}

/// Residual of a figure that a run does not have, such as the place of impacts without any: that of ten uncertainties.
const NOTHING: f64 = 10.0;
/// Iterations of one fit.
const MAX_ITERATIONS: u64 = 60;
/// A fit ends when a step promises less than this share of the cost.
const LITTLE: f64 = 1e-5;

struct LevenbergMarquardt {
    point: Point,
    damping: f64,
    done: bool,
}

impl Solver<&LeastSquares<'_>, IterState<Vec<f64>, (), (), (), (), f64>> for LevenbergMarquardt {
    fn name(&self) -> &str {
        "Levenberg–Marquardt in bounds"
    }

    fn next_iter(
        &mut self,
        problem: &mut Counted<&LeastSquares<'_>>,
        state: IterState<Vec<f64>, (), (), (), (), f64>,
    ) -> Result<(IterState<Vec<f64>, (), (), (), (), f64>, Option<KV>), Error> {
        problem.problem("steps", |squares| Ok(self.step(squares)))??;
        Ok((state.cost(self.point.cost()), None))
    }

    fn terminate(&mut self, _: &IterState<Vec<f64>, (), (), (), (), f64>) -> TerminationStatus {
        if self.done {
            TerminationStatus::Terminated(TerminationReason::SolverConverged)
        } else {
            TerminationStatus::NotTerminated
        }
    }
}

impl LevenbergMarquardt {
    fn step(&mut self, squares: &LeastSquares<'_>) -> Result<(), IdentifyError> {
        let jacobian = squares.jacobian(&self.point)?;
        let cost = self.point.cost();
        for _ in 0..12 {
            let change = bounded_step(&jacobian, &self.point, self.damping);
            let promised = cost - (&self.point.residuals + &jacobian * &change).norm_squared();
            if promised < LITTLE * cost {
                self.done = true;
                return Ok(());
            }
            let trial = squares.point(&self.point.coordinates + &change, Some(&self.point.evaluation));
            match trial {
                Ok(trial) if trial.cost() < cost => {
                    let gain = (cost - trial.cost()) / promised;
                    self.damping *= if gain > 0.75 {
                        0.2
                    } else if gain > 0.25 {
                        1.0
                    } else {
                        3.0
                    };
                    self.point = trial;
                    return Ok(());
                }
                // Uphill, or no equilibrium there: a shorter step.
                _ => self.damping *= 5.0,
            }
        }
        self.done = true;
        Ok(())
    }
}

/// The damped least-squares step that stays within 0…1: coordinates that would leave are fixed at their bound.
fn bounded_step(jacobian: &DMatrix<f64>, at: &Point, damping: f64) -> DVector<f64> {
    let count = jacobian.ncols();
    let mut change = DVector::zeros(count);
    let mut open: Vec<usize> = (0..count).collect();
    while !open.is_empty() {
        let part = jacobian.select_columns(&open);
        let residuals = &at.residuals + jacobian * &change;
        let mut normal = part.transpose() * &part;
        for k in 0..open.len() {
            normal[(k, k)] += damping * (normal[(k, k)] + 1e-6);
        }
        let Some(factor) = normal.cholesky() else { break };
        let step = -factor.solve(&(part.transpose() * residuals));
        let leaving = open.iter().zip(step.iter()).position(|(&k, s)| {
            let target = at.coordinates[k] + change[k] + s;
            !(-1e-12..=1.0 + 1e-12).contains(&target)
        });
        match leaving {
            None => {
                open.iter().zip(step.iter()).for_each(|(&k, s)| change[k] += s);
                break;
            }
            Some(position) => {
                let k = open.remove(position);
                let bound = if step[position] > 0.0 { 1.0 } else { 0.0 };
                change[k] = bound - at.coordinates[k];
            }
        }
    }
    change
}

/// Fits from one start.
///
/// # Errors
/// A start without equilibrium.
pub fn fit(squares: &LeastSquares<'_>, start: DVector<f64>) -> Result<Point, IdentifyError> {
    let point = squares.point(start, None)?;
    let solver = LevenbergMarquardt { point: point.clone(), damping: 1e-2, done: false };
    let result = Executor::new(squares, solver).configure(|s| s.max_iters(MAX_ITERATIONS)).timer(false).run();
    Ok(result.map_or(point, |r| r.solver.point))
}
