//! Spreads, correlations and what determines what, from the curvature at a minimum.
//!
//! With J the sensitivities of the normalised residuals, C = (JᵀJ + P)⁻¹ is the covariance of the coordinates; P holds
//! 12 for parameters without a prior (the variance 1/12 of a uniform one over the bounds), so that C always exists and
//! an undetermined parameter shows as one whose spread is that of its prior.

use crate::IdentifyError;
use crate::fit::{DIFFERENCE, LeastSquares, Point};
use crate::problem::Quantity;
use nalgebra::{DMatrix, DVector};

/// A parameter counts as determined when the data make its variance at least this much smaller than its prior's.
const INFORMATIVE: f64 = 0.5;
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
    /// Whether the data determine it.
    pub determined: Vec<bool>,
    /// Whether it lies at one of its bounds, where the spread is not that of a normal distribution.
    pub at_bound: Vec<bool>,
    /// For each parameter the share of each residual (data, then priors) in its variance.
    pub shares: DMatrix<f64>,
    /// For each undetermined parameter the figure that would determine it best: run, quantity, spread with it.
    pub wanted: Vec<Option<(String, Quantity, f64)>>,
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
    let slopes = squares.differences(at, DIFFERENCE, true, all)?;
    let finer = squares.differences(at, 0.5 * DIFFERENCE, true, all)?;
    let jacobian = slopes.rows(0, residual_count).into_owned();
    let scale = jacobian.amax().max(f64::MIN_POSITIVE);
    let sensitivity_check = (jacobian.clone() - finer.rows(0, residual_count)).amax() / scale;

    let count = squares.free.len();
    let mut normal = jacobian.transpose() * &jacobian;
    let prior_variance: Vec<f64> = squares
        .parameters()
        .zip(squares.values(&at.coordinates))
        .map(|(p, value)| match p.prior {
            Some(prior) => {
                let spread = if p.scale == crate::Scale::Log { prior.spread * value } else { prior.spread };
                (spread / p.slope(value)).powi(2).min(1.0 / 12.0)
            }
            None => 1.0 / 12.0,
        })
        .collect();
    for (k, parameter) in squares.parameters().enumerate() {
        if parameter.prior.is_none() {
            normal[(k, k)] += 12.0;
        }
    }
    let covariance = normal.cholesky().map_or_else(|| DMatrix::identity(count, count), |c| c.inverse());
    let deviation = |k: usize| covariance[(k, k)].sqrt();
    let values = squares.values(&at.coordinates);
    let spread = squares.parameters().zip(&values).enumerate().map(|(k, (p, &v))| deviation(k) * p.slope(v)).collect();
    let correlation = DMatrix::from_fn(count, count, |i, j| covariance[(i, j)] / (deviation(i) * deviation(j)));
    let information: Vec<f64> =
        (0..count).map(|k| (1.0 - covariance[(k, k)] / prior_variance[k]).clamp(0.0, 1.0)).collect();
    let determined: Vec<bool> = information.iter().map(|i| *i > INFORMATIVE).collect();
    let gain = &covariance * jacobian.transpose();
    let shares = DMatrix::from_fn(count, residual_count, |k, j| gain[(k, j)].powi(2) / covariance[(k, k)]);
    let wanted = (0..count)
        .map(|k| {
            if determined[k] {
                return None;
            }
            let best = (0..runs.len() * wishes.len())
                .map(|row| {
                    let slope = slopes.row(residual_count + row).transpose();
                    let gain = &covariance * &slope;
                    let left = covariance[(k, k)] - gain[k].powi(2) / (1.0 + slope.dot(&gain));
                    (row, left.max(0.0).sqrt())
                })
                .min_by(|a, b| a.1.total_cmp(&b.1))?;
            let (row, left) = best;
            let parameter = squares.parameters().nth(k)?;
            let (run, wish) = (runs[row / wishes.len()], wishes[row % wishes.len()].0);
            Some((run.clone(), wish, left * parameter.slope(values[k])))
        })
        .collect();
    let at_bound = at.coordinates.iter().map(|c| *c < AT_BOUND || *c > 1.0 - AT_BOUND).collect();
    Ok(Uncertainty { spread, correlation, information, determined, at_bound, shares, wanted, sensitivity_check })
}
