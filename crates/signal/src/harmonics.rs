//! Families of harmonics: which multiples of a frequency a spectrum has, and how much of the signal they make up.

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_setting};
use crate::spectrum::Spectrum;

/// One harmonic that was found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct HarmonicLine {
    /// Multiple of the fundamental, from 1.
    pub order: usize,
    /// Interpolated frequency of the peak, Hz.
    pub frequency_hz: f64,
    /// Its amplitude, in the unit of the samples.
    pub amplitude: f64,
    /// Distance of the peak above (positive) or below the exact multiple, in lines.
    pub off_lines: f64,
    /// Median amplitude of the lines around, half a fundamental to each side without the lobe: what noise would give.
    pub floor_amplitude: f64,
}

/// The harmonics of one frequency.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct HarmonicFamily {
    /// Frequency whose multiples were looked for, Hz.
    pub fundamental_hz: f64,
    /// Peaks that were found, by order; orders without a peak in reach are missing.
    pub lines: Vec<HarmonicLine>,
    /// Orders looked for: those below half the sampling rate.
    pub orders: usize,
    /// Part of the variance within one lobe of the multiples, 0 to 1; 0 for a constant signal.
    pub variance_share: f64,
    /// Part of all lines that these are: the share that white noise would give.
    pub line_share: f64,
}

impl Spectrum {
    /// Looks for the multiples 1 to `count` of a frequency, each within `tolerance_lines` of its place.
    ///
    /// Every peak in reach is listed, also one of noise: compare with its floor. The share of the variance takes all
    /// lines within the tolerance and half a lobe of each multiple, whether there is a peak or not. A family makes up a
    /// signal when its share is near 1 and its share of the lines is not.
    ///
    /// # Errors
    ///
    /// A fundamental above half the sampling rate or so low that neighbouring multiples run into each other (record a
    /// longer time); a negative tolerance.
    pub fn harmonic_family(
        &self,
        fundamental_hz: f64,
        count: usize,
        tolerance_lines: f64,
    ) -> Result<HarmonicFamily, SignalError> {
        check_setting("tolerance in lines", tolerance_lines, true)?;
        let reach = tolerance_lines + self.window.lobe_lines() as f64;
        let (spacing, nyquist_hz) = (self.line_spacing_hz(), self.nyquist_hz());
        let least_hz = 2.0 * reach * spacing;
        if !(least_hz..=nyquist_hz).contains(&fundamental_hz) {
            return Err(SignalError::Fundamental { fundamental_hz, least_hz, nyquist_hz });
        }
        let step = fundamental_hz / spacing;
        let orders = count.min((nyquist_hz / fundamental_hz) as usize);
        let (mut lines, mut power, mut members) = (Vec::new(), 0.0, 0);
        for order in 1..=orders {
            let place = order as f64 * step;
            for line in self.lines_between(place - reach, place + reach) {
                power += self.line_power(line);
                members += 1;
            }
            if let Some(peak) = self.peak_between(place - tolerance_lines, place + tolerance_lines) {
                let off_lines = peak.frequency_hz / spacing - place;
                let floor_amplitude = self.floor(place, 0.5 * step, reach);
                let (frequency_hz, amplitude) = (peak.frequency_hz, peak.amplitude);
                lines.push(HarmonicLine { order, frequency_hz, amplitude, off_lines, floor_amplitude });
            }
        }
        let variance = self.variance();
        let variance_share = if variance > 0.0 { (power / variance).min(1.0) } else { 0.0 };
        let line_share = members as f64 / self.amplitude.len() as f64;
        Ok(HarmonicFamily { fundamental_hz, lines, orders, variance_share, line_share })
    }

    /// Indices of the lines strictly between two places given in lines, line 0 (the mean) left out.
    fn lines_between(&self, low: f64, high: f64) -> std::ops::Range<usize> {
        let from = (low.floor() + 1.0).max(1.0) as usize;
        let to = (high.ceil().max(1.0) as usize).min(self.amplitude.len());
        from..to.max(from)
    }

    /// Median amplitude of the lines within `half` of a place but not within `lobe`.
    fn floor(&self, place: f64, half: f64, lobe: f64) -> f64 {
        let around = self.lines_between(place - half, place + half).filter(|k| (*k as f64 - place).abs() >= lobe);
        let mut amplitudes: Vec<f64> = around.map(|k| self.amplitude[k]).collect();
        amplitudes.sort_by(f64::total_cmp);
        amplitudes.get(amplitudes.len() / 2).copied().unwrap_or(0.0)
    }
}
