//! Spectra over time: how the lines of a run-up move.

use serde::Serialize;

use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::{LEAST_SAMPLES, amplitudes};
use crate::window::Window;

/// Levels of a signal over time and frequency.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Spectrogram {
    /// Middles of the pieces of time, s.
    pub time_s: Vec<f64>,
    /// Middles of the bands, Hz.
    pub frequency_hz: Vec<f64>,
    /// Root mean square amplitude of each band at each time in dB below the highest one, band by band from the lowest:
    /// 0 at most, −120 at least.
    pub level_db: Vec<f64>,
}

/// Least level, dB.
const LEAST_DB: f64 = -120.0;

/// The spectrogram of a signal up to a frequency, in so many pieces of time (Hann windows, twice as long as their
/// distance) and at most so many bands.
///
/// # Errors
///
/// Fewer than 4 samples in a piece, a sample that is not finite, a rate (Hz) or frequency that is not positive.
pub fn spectrogram(
    samples: &[f64],
    rate_hz: f64,
    up_to_hz: f64,
    [pieces, bands]: [usize; 2],
) -> Result<Spectrogram, SignalError> {
    check_rate(rate_hz)?;
    crate::error::check_setting("highest frequency in Hz", up_to_hz, false)?;
    check_samples(samples, LEAST_SAMPLES * (pieces.max(1) + 1))?;
    let hop = samples.len() / (pieces.max(1) + 1);
    let length = 2 * hop;
    let spacing = rate_hz / length as f64;
    let lines = ((up_to_hz / spacing) as usize).clamp(1, length / 2);
    let bands = bands.clamp(1, lines);
    let edge = |band: usize| 1 + band * lines / bands;
    let mut columns = Vec::new();
    for piece in 0..pieces.max(1) {
        let (amplitude, _) = amplitudes(&samples[piece * hop..piece * hop + length], Window::Hann)?;
        let power = |band: usize| {
            let lines = &amplitude[edge(band)..edge(band + 1).min(amplitude.len())];
            lines.iter().map(|a| a * a).sum::<f64>() / lines.len().max(1) as f64
        };
        columns.push((0..bands).map(power).collect::<Vec<f64>>());
    }
    let most = columns.iter().flatten().fold(0.0, |most: f64, p| most.max(*p));
    let level = |p: f64| if most > 0.0 && p > 0.0 { (10.0 * (p / most).log10()).max(LEAST_DB) } else { LEAST_DB };
    Ok(Spectrogram {
        time_s: (0..columns.len()).map(|piece| (piece + 1) as f64 * hop as f64 / rate_hz).collect(),
        frequency_hz: (0..bands).map(|b| 0.5 * (edge(b) + edge(b + 1) - 1) as f64 * spacing).collect(),
        level_db: (0..bands).flat_map(|band| columns.iter().map(move |c| level(c[band]))).collect(),
    })
}
