//! Power spectral density by averaged periodograms (Welch).

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::{LEAST_SAMPLES, amplitudes};
use crate::transform::has_partner;
use crate::window::Window;

/// Segments into which the samples are cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Segments {
    /// Samples in a segment: the line spacing is the rate divided by it.
    pub length: usize,
    /// Samples that neighbouring segments share.
    pub overlap: usize,
    /// Window of each segment.
    pub window: Window,
}

impl Segments {
    /// Hann-weighted segments that overlap by half, where that window leaves no sample with little weight.
    pub fn half_overlapping(length: usize) -> Self {
        Self { length, overlap: length / 2, window: Window::Hann }
    }
}

/// Single-sided power spectral density.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PowerDensity {
    /// Frequencies of the lines, Hz.
    pub frequency_hz: Vec<f64>,
    /// Density in the squared unit of the samples per Hz.
    pub density_per_hz: Vec<f64>,
    /// Number of segments averaged.
    pub segment_count: usize,
}

impl PowerDensity {
    /// Variance between two frequencies, Hz, both included: the sum over the lines, in the squared unit of the samples.
    pub fn variance(&self, low_hz: f64, high_hz: f64) -> f64 {
        let spacing = self.frequency_hz.get(1).copied().unwrap_or(0.0);
        let inside =
            self.frequency_hz.iter().zip(&self.density_per_hz).filter(|(f, _)| (low_hz..=high_hz).contains(*f));
        inside.map(|(_, s)| s * spacing).sum()
    }
}

/// Power spectral density of evenly spaced samples; the mean of each segment is removed. Samples after the last whole
/// segment are not used.
///
/// # Errors
///
/// Fewer than 4 samples in a segment, segments longer than the signal or that overlap wholly, a sample that is not
/// finite, a rate (Hz) that is not positive.
pub fn welch(samples: &[f64], rate_hz: f64, segments: Segments) -> Result<PowerDensity, SignalError> {
    let Segments { length, overlap, window } = segments;
    check_rate(rate_hz)?;
    check_samples(samples, LEAST_SAMPLES)?;
    if length < LEAST_SAMPLES || length > samples.len() || overlap >= length {
        return Err(SignalError::Segments { segment: length, overlap, count: samples.len() });
    }
    let spacing = rate_hz / length as f64;
    let mut density_per_hz = vec![0.0; length / 2 + 1];
    let starts = (0..samples.len() - length + 1).step_by(length - overlap);
    let segment_count = starts.len();
    for start in starts {
        let (amplitude, _) = amplitudes(&samples[start..start + length], window)?;
        density_per_hz.iter_mut().zip(&amplitude).for_each(|(sum, a)| *sum += a * a);
    }
    for (k, density) in density_per_hz.iter_mut().enumerate() {
        let half = if has_partner(k, length) { 0.5 } else { 1.0 };
        *density *= half / (segment_count as f64 * window.noise_bandwidth_lines() * spacing);
    }
    let frequency_hz = (0..density_per_hz.len()).map(|k| k as f64 * spacing).collect();
    Ok(PowerDensity { frequency_hz, density_per_hz, segment_count })
}
