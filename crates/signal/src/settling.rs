//! The time at which a signal has become steady, by its running mean and ripple.

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_rate, check_samples, check_setting};

/// Criterion of a steady signal.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SettlingRule {
    /// Length of the running window, s: a whole period of the ripple, or the mean itself swings.
    pub window_s: f64,
    /// Greatest distance of the running mean from its final value, in the unit of the samples.
    pub mean_tolerance: f64,
    /// Greatest distance of the running rms (about the running mean) from its final value, in the unit of the samples.
    pub rms_tolerance: f64,
}

/// The time at which a signal settled, and the value it settled to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settling {
    /// Start of the first window from which on all are within the tolerances, s from the first sample; nothing where
    /// the windows of the last quarter still leave them.
    pub time_s: Option<f64>,
    /// Average of the running mean over the last quarter of the windows, in the unit of the samples.
    pub final_mean: f64,
    /// Average of the running rms over the last quarter of the windows, in the unit of the samples.
    pub final_rms: f64,
}

/// Part of the windows, at the end, that gives the final values.
const FINAL_PART: usize = 4;

/// Finds the time after which the running mean and rms stay within their tolerances.
///
/// # Errors
///
/// A window that is not positive, or of which fewer than four fit; negative tolerances; a sample that is not finite; a
/// rate (Hz) that is not positive.
pub fn settling(samples: &[f64], rate_hz: f64, rule: SettlingRule) -> Result<Settling, SignalError> {
    check_rate(rate_hz)?;
    check_setting("running window in s", rule.window_s, false)?;
    check_setting("tolerance of the mean", rule.mean_tolerance, true)?;
    check_setting("tolerance of the rms", rule.rms_tolerance, true)?;
    let window = ((rule.window_s * rate_hz).round() as usize).max(2);
    check_samples(samples, window.saturating_mul(4))?;
    let (means, rms) = running(samples, window);
    let tail = means.len() - (means.len() / FINAL_PART).max(1);
    let average = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let (final_mean, final_rms) = (average(&means[tail..]), average(&rms[tail..]));
    let outside = |k: &usize| {
        let far_mean = (means[*k] - final_mean).abs() > rule.mean_tolerance;
        far_mean || (rms[*k] - final_rms).abs() > rule.rms_tolerance
    };
    let first = (0..means.len()).rev().find(outside).map_or(0, |last_outside| last_outside + 1);
    let time_s = (first <= tail).then_some(first as f64 / rate_hz);
    Ok(Settling { time_s, final_mean, final_rms })
}

/// Mean and rms about it of every window of the samples.
fn running(samples: &[f64], window: usize) -> (Vec<f64>, Vec<f64>) {
    // Sums of deviations from the overall mean: those of the samples would cancel where the ripple is small.
    let centre = samples.iter().sum::<f64>() / samples.len() as f64;
    let mut sums = [0.0, 0.0];
    let mut cumulative = vec![sums];
    for x in samples {
        let d = x - centre;
        sums = [sums[0] + d, sums[1] + d * d];
        cumulative.push(sums);
    }
    let of = |pair: (&[f64; 2], &[f64; 2])| {
        let [mean, square] = [0, 1].map(|k| (pair.1[k] - pair.0[k]) / window as f64);
        (centre + mean, (square - mean * mean).max(0.0).sqrt())
    };
    cumulative.iter().zip(&cumulative[window..]).map(of).unzip()
}
