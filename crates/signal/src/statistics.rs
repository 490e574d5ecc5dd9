//! Moments and extremes of a signal.

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_samples};

/// Deviations below this part of the greatest magnitude are rounding: the signal is a constant.
const ROUNDING: f64 = 1e-14;

/// Statistics of a signal that do not depend on the order of its samples. In the unit of the samples where nothing else
/// is said.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    /// Number of samples.
    pub count: usize,
    /// Mean.
    pub mean: f64,
    /// Root of the mean square of the samples, mean included.
    pub rms_total: f64,
    /// Root of the mean square about the mean: standard deviation with divisor N.
    pub rms: f64,
    /// Least sample.
    pub minimum: f64,
    /// Greatest sample.
    pub maximum: f64,
    /// Greatest distance of a sample from the mean.
    pub peak: f64,
    /// Greatest less least sample.
    pub peak_to_peak: f64,
    /// Peak divided by rms, both about the mean (sine √2); nothing for a constant.
    pub crest_factor: Option<f64>,
    /// Fourth central moment divided by the square of the second (sine 1.5, Gauss 3); nothing for a constant.
    pub kurtosis: Option<f64>,
    /// Third central moment divided by the 3/2 power of the second; nothing for a constant.
    pub skewness: Option<f64>,
}

impl Statistics {
    /// Statistics of samples.
    ///
    /// # Errors
    ///
    /// No sample, a sample that is not finite.
    pub fn of(samples: &[f64]) -> Result<Self, SignalError> {
        check_samples(samples, 1)?;
        let count = samples.len() as f64;
        let average = |f: &dyn Fn(f64) -> f64| samples.iter().map(|x| f(*x)).sum::<f64>() / count;
        let mean = average(&|x| x);
        let rms_total = average(&|x| x * x).sqrt();
        let minimum = samples.iter().fold(f64::INFINITY, |least: f64, x| least.min(*x));
        let maximum = samples.iter().fold(f64::NEG_INFINITY, |most: f64, x| most.max(*x));
        let peak = (maximum - mean).max(mean - minimum);
        let constant = peak <= ROUNDING * minimum.abs().max(maximum.abs());
        // Moments of deviations scaled by the peak neither overflow nor vanish.
        let moment = |power: i32| if constant { 0.0 } else { average(&|x| ((x - mean) / peak).powi(power)) };
        let second = moment(2);
        let ratio = |of: f64| (!constant).then_some(of);
        Ok(Self {
            count: samples.len(),
            mean,
            rms_total,
            rms: peak * second.sqrt(),
            minimum,
            maximum,
            peak,
            peak_to_peak: maximum - minimum,
            crest_factor: ratio(1.0 / second.sqrt()),
            kurtosis: ratio(moment(4) / (second * second)),
            skewness: ratio(moment(3) / second.powf(1.5)),
        })
    }
}
