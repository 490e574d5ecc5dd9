//! Spreads, correlations, and the data that determine each parameter, from the curvature at a minimum.
//!
//! With J the sensitivities of the normalised residuals, C = (JᵀJ + P)⁻¹ is the covariance of the coordinates; P holds
//! 12 for parameters without a prior (the variance 1/12 of a uniform one over the bounds), so that C always exists and
//! an undetermined parameter shows as one whose spread is that of its prior.

use crate::IdentifyError;
use crate::fit::{LeastSquares, Point};
use crate::problem::{Parameter, Scale};
use crate::quantity::Quantity;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

/// A parameter counts as determined when the data make its variance at least this much smaller than its prior's.
const INFORMATIVE: f64 = 0.5;
/// Variance of a uniform distribution over the bounds, which the coordinates 0 and 1 stand for.
const UNIFORM_VARIANCE: f64 = 1.0 / 12.0;
/// A coordinate this close to 0 or 1 is at its bound.
const AT_BOUND: f64 = 1e-6;

/// Curvature at a minimum.
#[derive(Debug, Clone)]
pub struct Uncertainty {
    /// Standard deviation of each parameter in the unit of the file.
    pub spread: Vec<f64>,
    /// Correlation coefficients.
    pub correlation: DMatrix<f64>,
    /// Share of the prior's variance that the data remove, 0 to 1.
    pub information: Vec<f64>,
    /// True where the data determine a parameter.
    pub determined: Vec<bool>,
    /// True at one of its bounds, where the spread is not that of a normal distribution.
    pub at_bound: Vec<bool>,
    /// For each parameter the share of each residual (data, then priors) in its variance.
    pub shares: DMatrix<f64>,
    /// For each undetermined parameter the figure that would determine it best: run, quantity, spread with it.
    pub wanted: Vec<Option<(String, Quantity, f64)>>,
    /// Natural logarithm of the evidence by Laplace's approximation, without the constant −Σ ln(σ √2π) of the data:
    /// −½ Σ r² + Σ ln π(x) + ½ n ln 2π − ½ ln det(JᵀJ + P), π the prior density in the coordinates, 1 without a prior.
    pub log_evidence: f64,
    /// Largest relative difference of the sensitivities when the step is halved.
    pub sensitivity_check: f64,
}

/// Figures that might be measured, with the uncertainty of a good measurement.
fn candidates() -> Vec<(Quantity, f64)> {
    let mut out = vec![
        (Quantity::CageSpeed, 1.0),
        (Quantity::ShaftTorque, 0.5),
        (Quantity::RingDisplacementAxial, 1.0),
        (Quantity::RingDisplacementRadial, 1.0),
    ];
    for azimuth in [0.0, 180.0] {
        out.push((Quantity::PeakPressureInner { azimuth }, 0.005));
        out.push((Quantity::PeakPressureOuter { azimuth }, 0.005));
        out.push((Quantity::ContactAngleInner { azimuth }, 0.1));
        out.push((Quantity::ContactAngleOuter { azimuth }, 0.1));
        out.push((Quantity::LoadInner { azimuth }, 50.0));
        out.push((Quantity::LoadOuter { azimuth }, 50.0));
    }
    out
}

/// Works out spreads and information at a point.
///
/// # Errors
/// A neighbour without equilibrium.
pub fn uncertainty(squares: &LeastSquares<'_>, at: &Point) -> Result<Uncertainty, IdentifyError> {
    let wishes = candidates();
    let runs: Vec<&String> = at.evaluation.solutions.keys().collect();
    let residual_count = at.residuals.len();
    let all = |point: &Point| {
        let extra = runs.iter().flat_map(|run| {
            wishes.iter().map(|(q, uncertainty)| q.of(&point.evaluation.solutions[*run]) / uncertainty)
        });
        DVector::from_iterator(residual_count + runs.len() * wishes.len(), point.residuals.iter().copied().chain(extra))
    };
    let slopes = squares.differences(at, squares.problem.difference, true, all)?;
    let finer = squares.differences(at, 0.5 * squares.problem.difference, true, all)?;
    let jacobian = slopes.rows(0, residual_count).into_owned();
    let scale = jacobian.amax().max(f64::MIN_POSITIVE);
    let sensitivity_check = (jacobian.clone() - finer.rows(0, residual_count)).amax() / scale;

    let (normal, prior_variance) = normal_matrix(squares, at, &jacobian);
    let count = squares.free.len();
    let factor = normal.cholesky();
    let log_determinant = factor.as_ref().map_or(0.0, |c| 2.0 * c.l_dirty().diagonal().map(f64::ln).sum());
    let log_evidence = log_prior_density(squares, at) + 0.5 * (count as f64 * TAU.ln() - log_determinant - at.cost());
    let covariance = factor.map_or_else(|| DMatrix::identity(count, count), |c| c.inverse());
    let deviation = |k: usize| covariance[(k, k)].sqrt();
    let values = squares.values(&at.coordinates);
    let slope = |k: usize| squares.parameters().nth(k).map_or(1.0, |p| p.slope(values[k]));
    let information: Vec<f64> =
        (0..count).map(|k| (1.0 - covariance[(k, k)] / prior_variance[k]).clamp(0.0, 1.0)).collect();
    let determined: Vec<bool> = information.iter().map(|i| *i > INFORMATIVE).collect();
    let gain = &covariance * jacobian.transpose();
    let wanted = (0..count).map(|k| {
        if determined[k] {
            return None;
        }
        let (row, left) = best_measurement(k, &covariance, &slopes.rows_range(residual_count..).into_owned())?;
        Some((runs[row / wishes.len()].clone(), wishes[row % wishes.len()].0, left * slope(k)))
    });
    Ok(Uncertainty {
        spread: (0..count).map(|k| deviation(k) * slope(k)).collect(),
        correlation: DMatrix::from_fn(count, count, |i, j| covariance[(i, j)] / (deviation(i) * deviation(j))),
        shares: DMatrix::from_fn(count, residual_count, |k, j| gain[(k, j)].powi(2) / covariance[(k, k)]),
        wanted: wanted.collect(),
        at_bound: at.coordinates.iter().map(|c| *c < AT_BOUND || *c > 1.0 - AT_BOUND).collect(),
        information,
        determined,
        log_evidence,
        sensitivity_check,
    })
}

/// JᵀJ + P, and the variance of each coordinate before there were data.
fn normal_matrix(squares: &LeastSquares<'_>, at: &Point, jacobian: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let mut normal = jacobian.transpose() * jacobian;
    let values = squares.values(&at.coordinates);
    let variance = |(k, p): (usize, &Parameter)| match p.prior {
        Some(prior) => {
            let spread = if p.scale == Scale::Log { prior.spread * values[k] } else { prior.spread };
            (spread / p.slope(values[k])).powi(2).min(UNIFORM_VARIANCE)
        }
        None => UNIFORM_VARIANCE,
    };
    let prior_variance = squares.parameters().enumerate().map(variance).collect();
    for (k, parameter) in squares.parameters().enumerate() {
        if parameter.prior.is_none() {
            normal[(k, k)] += 1.0 / UNIFORM_VARIANCE;
        }
    }
    (normal, prior_variance)
}

/// Σ ln of the normal priors' densities at their means, in coordinates; the exponents are in the residuals.
fn log_prior_density(squares: &LeastSquares<'_>, at: &Point) -> f64 {
    let density = |(p, value): (&Parameter, f64)| {
        let spread = p.prior.map(|prior| if p.scale == Scale::Log { prior.spread * value } else { prior.spread });
        spread.map_or(0.0, |spread| (p.slope(value) / spread).ln() - 0.5 * TAU.ln())
    };
    squares.parameters().zip(squares.values(&at.coordinates)).map(density).sum()
}

/// The row of `slopes` (a measurement each, over its uncertainty) that would leave coordinate `k` the smallest standard
/// deviation, and that deviation.
fn best_measurement(k: usize, covariance: &DMatrix<f64>, slopes: &DMatrix<f64>) -> Option<(usize, f64)> {
    let left = |row: usize| {
        let slope = slopes.row(row).transpose();
        let gain = covariance * &slope;
        (covariance[(k, k)] - gain[k].powi(2) / (1.0 + slope.dot(&gain))).max(0.0).sqrt()
    };
    (0..slopes.nrows()).map(|row| (row, left(row))).min_by(|a, b| a.1.total_cmp(&b.1))
}
