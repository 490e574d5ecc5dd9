//! Order tracking: samples evenly spaced in shaft angle, and their spectrum over orders (events per turn).

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::{amplitudes, highest};
use crate::window::Window;

/// Points of the interpolating polynomial. Its error at a frequency f is about 35/32768 (2πf/rate)⁸ of the amplitude:
/// 3e-5 at a tenth, 0.7 % at a fifth of the sampling rate.
const STENCIL: usize = 8;
/// Greatest growth of the number of samples, and so the greatest ratio of the mean to the slowest speed.
const MOST_GROWTH: usize = 64;

/// Samples evenly spaced in angle over whole turns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AngleSamples {
    /// Samples in the unit of the signal, from angle 0.
    pub values: Vec<f64>,
    /// Samples in one turn.
    pub samples_per_turn: usize,
    /// Whole turns.
    pub turns: usize,
}

/// Amplitude spectrum over orders.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OrderSpectrum {
    /// Events per turn; whole orders lie on lines.
    pub order: Vec<f64>,
    /// Peak amplitudes, in the unit of the samples.
    pub amplitude: Vec<f64>,
    /// Window used.
    pub window: Window,
}

/// A peak of an order spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct OrderPeak {
    /// Interpolated order.
    pub order: f64,
    /// Amplitude, in the unit of the samples.
    pub amplitude: f64,
}

impl OrderSpectrum {
    /// The `count` highest peaks, highest first, at least `min_separation` orders apart.
    pub fn peaks(&self, count: usize, min_separation: f64) -> Vec<OrderPeak> {
        let spacing = self.order.get(1).copied().unwrap_or(0.0);
        highest(&self.amplitude, self.window, count, min_separation / spacing)
            .into_iter()
            .map(|(place, amplitude, _)| OrderPeak { order: place * spacing, amplitude })
            .collect()
    }
}

/// Shaft angle at each sample, rad, from 0: the speed is taken as linear between samples.
fn angles(speed_rad_s: &[f64], rate_hz: f64) -> Result<Vec<f64>, SignalError> {
    let direction = speed_rad_s[0].signum();
    if let Some(index) = speed_rad_s.iter().position(|w| w * direction <= 0.0) {
        return Err(SignalError::Speed { index, speed_rad_s: speed_rad_s[index] });
    }
    let mut angle = 0.0;
    let mut all = vec![0.0];
    all.extend(speed_rad_s.windows(2).map(|pair| {
        angle += 0.5 * (pair[0] + pair[1]).abs() / rate_hz;
        angle
    }));
    Ok(all)
}

/// Samples per turn that keep the density of the slowest turn.
fn enough_per_turn(speed_rad_s: &[f64], rate_hz: f64) -> Result<usize, SignalError> {
    let slowest = speed_rad_s.iter().fold(f64::INFINITY, |least: f64, w| least.min(w.abs()));
    let mean = speed_rad_s.iter().map(|w| w.abs()).sum::<f64>() / speed_rad_s.len() as f64;
    if mean > MOST_GROWTH as f64 * slowest {
        return Err(SignalError::SpeedRange { slowest_rad_s: slowest, mean_rad_s: mean, limit: MOST_GROWTH });
    }
    Ok(2 * (0.5 * rate_hz * TAU / slowest).ceil() as usize)
}

/// Value at a place between samples by the polynomial through the nearest [`STENCIL`] of them.
fn interpolate(samples: &[f64], place: f64) -> f64 {
    let first = (place as usize + 1).saturating_sub(STENCIL / 2).min(samples.len() - STENCIL);
    let at = place - first as f64;
    let near = &samples[first..first + STENCIL];
    let weight = |j: usize| {
        let others = (0..STENCIL).filter(|k| *k != j);
        others.map(|k| (at - k as f64) / (j as f64 - k as f64)).product::<f64>()
    };
    near.iter().enumerate().map(|(j, x)| x * weight(j)).sum()
}

/// Resamples a signal evenly in shaft angle, over the whole turns that it spans.
///
/// `speed_rad_s` is the shaft speed at each sample, of one sign. Without a number of samples per turn the density of
/// the slowest part is kept, so that nothing folds; with one that is lower, frequencies above half of it per turn fold
/// down, and the caller must know that there are none.
///
/// # Errors
///
/// Fewer than 8 samples, less than one turn, samples or speeds that are not finite, a number of speeds other than that
/// of the samples, a speed that is zero or changes sign, fewer than 4 samples per turn, and without a number of samples
/// per turn a slowest speed below a 64th of the mean.
pub fn resample_by_angle(
    samples: &[f64],
    rate_hz: f64,
    speed_rad_s: &[f64],
    samples_per_turn: Option<usize>,
) -> Result<AngleSamples, SignalError> {
    check_rate(rate_hz)?;
    check_samples(samples, STENCIL)?;
    if speed_rad_s.len() != samples.len() {
        return Err(SignalError::SpeedCount { speeds: speed_rad_s.len(), count: samples.len() });
    }
    check_samples(speed_rad_s, STENCIL)?;
    let angles = angles(speed_rad_s, rate_hz)?;
    let per_turn = match samples_per_turn {
        Some(given) if given < 4 => return Err(SignalError::TooFewSamples { count: given, needed: 4 }),
        Some(given) => given,
        None => enough_per_turn(speed_rad_s, rate_hz)?,
    };
    let spanned = angles[angles.len() - 1] / TAU;
    // A sum of many intervals that should be whole turns may end a rounding short of them.
    let turns = (spanned * (1.0 + 1e-12)).floor() as usize;
    if turns == 0 {
        return Err(SignalError::TooFewTurns { turns: spanned });
    }
    let mut interval = 0;
    let value = |n: usize| {
        let angle = TAU * n as f64 / per_turn as f64;
        while interval + 2 < angles.len() && angles[interval + 1] <= angle {
            interval += 1;
        }
        let (from, to) = (speed_rad_s[interval].abs(), speed_rad_s[interval + 1].abs());
        // Root of `from s + ½ (to − from) s² = Δθ rate` in the part s of the interval, in the form that does not
        // cancel.
        let ahead = (angle - angles[interval]) * rate_hz;
        let root = (from * from + 2.0 * (to - from) * ahead).max(0.0).sqrt();
        interpolate(samples, interval as f64 + 2.0 * ahead / (from + root))
    };
    let values = (0..turns * per_turn).map(value).collect();
    Ok(AngleSamples { values, samples_per_turn: per_turn, turns })
}

/// Order spectrum of a signal at varying shaft speed; arguments as in [`resample_by_angle`].
///
/// # Errors
///
/// Those of [`resample_by_angle`].
pub fn order_spectrum(
    samples: &[f64],
    rate_hz: f64,
    speed_rad_s: &[f64],
    samples_per_turn: Option<usize>,
    window: Window,
) -> Result<OrderSpectrum, SignalError> {
    let resampled = resample_by_angle(samples, rate_hz, speed_rad_s, samples_per_turn)?;
    let (amplitude, _) = amplitudes(&resampled.values, window)?;
    let order = (0..amplitude.len()).map(|k| k as f64 / resampled.turns as f64).collect();
    Ok(OrderSpectrum { order, amplitude, window })
}
