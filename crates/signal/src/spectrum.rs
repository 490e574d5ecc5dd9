//! Single-sided amplitude spectra and their peaks.

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_rate, check_samples};
use crate::transform::{forward, has_partner};
use crate::window::Window;

/// Least number of samples of a spectrum: a line with two neighbours.
pub(crate) const LEAST_SAMPLES: usize = 4;

/// Single-sided amplitude spectrum: a sine of amplitude 1 on a line gives 1 there, with every window.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spectrum {
    /// Frequencies of the lines, from 0 to half the sampling rate in even steps, Hz.
    pub frequency_hz: Vec<f64>,
    /// Peak amplitudes, in the unit of the samples.
    pub amplitude: Vec<f64>,
    /// Window used.
    pub window: Window,
    /// Number of samples.
    pub sample_count: usize,
    /// The mean that was subtracted: that of the weighted samples, so that line 0 is zero. In the unit of the samples.
    pub mean: f64,
}

/// A peak of a spectrum, its place interpolated between lines.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Peak {
    /// Frequency of the sine that would make these lines, Hz.
    pub frequency_hz: f64,
    /// Its amplitude, in the unit of the samples.
    pub amplitude: f64,
    /// Index of the highest line.
    pub line: usize,
}

/// Amplitudes of the lines of evenly spaced samples, and the mean taken off.
pub(crate) fn amplitudes(samples: &[f64], window: Window) -> Result<(Vec<f64>, f64), SignalError> {
    let weights = window.weights(samples.len());
    let total: f64 = weights.iter().sum();
    let mean = samples.iter().zip(&weights).map(|(x, w)| x * w).sum::<f64>() / total;
    let lines = forward(samples.iter().zip(&weights).map(|(x, w)| (x - mean) * w).collect())?;
    let scale = |k: usize| if has_partner(k, samples.len()) { 2.0 / total } else { 1.0 / total };
    Ok((lines.iter().enumerate().map(|(k, x)| scale(k) * x.norm()).collect(), mean))
}

/// Place in lines and amplitude of the peak at a line that is higher than the one before and not lower than the one
/// after.
pub(crate) fn refine(amplitude: &[f64], window: Window, line: usize) -> Option<(f64, f64)> {
    let (left, top, right) = (*amplitude.get(line.checked_sub(1)?)?, *amplitude.get(line)?, *amplitude.get(line + 1)?);
    if !(top > left && top >= right) {
        return None;
    }
    let offset = window.offset([left, top, right]);
    Some((line as f64 + offset, top / window.lobe(offset)))
}

/// The `count` highest peaks at least `separation` lines apart, highest first: place in lines, amplitude, line.
pub(crate) fn highest(amplitude: &[f64], window: Window, count: usize, separation: f64) -> Vec<(f64, f64, usize)> {
    let refined = |k: usize| refine(amplitude, window, k).map(|(place, height)| (place, height, k));
    let mut all: Vec<(f64, f64, usize)> = (1..amplitude.len()).filter_map(refined).collect();
    all.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.2.cmp(&b.2)));
    let mut kept: Vec<(f64, f64, usize)> = Vec::new();
    for peak in all {
        if kept.len() == count {
            break;
        }
        if kept.iter().all(|other| (other.0 - peak.0).abs() >= separation) {
            kept.push(peak);
        }
    }
    kept
}

impl Spectrum {
    /// The spectrum of evenly spaced samples, their mean removed.
    ///
    /// # Errors
    ///
    /// Fewer than 4 samples, a sample that is not finite, a rate (Hz) that is not positive.
    pub fn of(samples: &[f64], rate_hz: f64, window: Window) -> Result<Self, SignalError> {
        check_rate(rate_hz)?;
        check_samples(samples, LEAST_SAMPLES)?;
        let (amplitude, mean) = amplitudes(samples, window)?;
        let spacing = rate_hz / samples.len() as f64;
        let frequency_hz = (0..amplitude.len()).map(|k| k as f64 * spacing).collect();
        Ok(Self { frequency_hz, amplitude, window, sample_count: samples.len(), mean })
    }

    /// Distance between lines, Hz: one over the duration of the samples.
    pub fn line_spacing_hz(&self) -> f64 {
        self.frequency_hz.get(1).copied().unwrap_or(0.0)
    }

    /// Half the sampling rate, Hz.
    pub fn nyquist_hz(&self) -> f64 {
        0.5 * self.line_spacing_hz() * self.sample_count as f64
    }

    /// The `count` highest peaks, highest first, at least `min_separation_hz` apart.
    ///
    /// Line 0 and the last line are never peaks. Of a sine with noise or leakage around it the separation should be at
    /// least the width of the lobe, [`Window::lobe_lines`] lines.
    pub fn peaks(&self, count: usize, min_separation_hz: f64) -> Vec<Peak> {
        let spacing = self.line_spacing_hz();
        highest(&self.amplitude, self.window, count, min_separation_hz / spacing)
            .into_iter()
            .map(|(place, amplitude, line)| Peak { frequency_hz: place * spacing, amplitude, line })
            .collect()
    }

    /// The highest peak between two places given in lines, if there is one.
    pub(crate) fn peak_between(&self, low: f64, high: f64) -> Option<Peak> {
        let spacing = self.line_spacing_hz();
        // The peak of a sine up to half a line outside belongs to a line inside.
        let from = (low - 0.5).ceil().max(1.0) as usize;
        let to = ((high + 0.5).floor().max(0.0) as usize).min(self.amplitude.len().saturating_sub(1));
        let inside = (from..=to).filter_map(|line| {
            let (place, amplitude) = refine(&self.amplitude, self.window, line)?;
            (low..=high).contains(&place).then_some(Peak { frequency_hz: place * spacing, amplitude, line })
        });
        inside.max_by(|a, b| a.amplitude.total_cmp(&b.amplitude))
    }

    /// The highest peak within a distance of a frequency, both Hz; nothing where no line rises above its neighbours
    /// there.
    pub fn peak_near(&self, frequency_hz: f64, distance_hz: f64) -> Option<Peak> {
        let spacing = self.line_spacing_hz();
        self.peak_between((frequency_hz - distance_hz) / spacing, (frequency_hz + distance_hz) / spacing)
    }

    /// The amplitude at a frequency within a distance, both Hz: that of the highest peak there, and without a peak that
    /// of the nearest line. Zero outside the spectrum.
    pub fn amplitude_near(&self, frequency_hz: f64, distance_hz: f64) -> f64 {
        if let Some(peak) = self.peak_near(frequency_hz, distance_hz) {
            return peak.amplitude;
        }
        let line = (frequency_hz / self.line_spacing_hz()).round();
        if line < 0.0 { 0.0 } else { self.amplitude.get(line as usize).copied().unwrap_or(0.0) }
    }

    /// Share of a line in the mean square of the weighted samples, in the squared unit of the samples.
    pub(crate) fn line_power(&self, line: usize) -> f64 {
        let half = if has_partner(line, self.sample_count) { 0.5 } else { 1.0 };
        half * self.amplitude[line].powi(2) / self.window.noise_bandwidth_lines()
    }

    /// Variance of the signal, in the squared unit of the samples: all lines' powers.
    ///
    /// Exactly (Parseval) `Σ w² (x − mean)²/Σ w²` with the window's weights w: without window the variance of the
    /// samples.
    pub fn variance(&self) -> f64 {
        (0..self.amplitude.len()).map(|line| self.line_power(line)).sum()
    }
}
