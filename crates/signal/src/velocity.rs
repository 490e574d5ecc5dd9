//! Velocity of vibration in the three bands of bearing testers.
//!
//! ISO 15242-1 measures the radial velocity of the outer ring in bands that belong to 1800 r/min of the inner ring, 50
//! to 300, 300 to 1800 and 1800 to 10 000 Hz. The velocity is the integral of the acceleration, line by line: A/2πf.
//! The bands have edges of finite width, 3 dB down at the frequencies that they are named by, so that neighbours add up
//! to the whole power and a line elsewhere is not spread over the record.

use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::diagnosis::{faded, without_trend};
use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::LEAST_SAMPLES;
use crate::transform::{forward, inverse};

/// Bands of bearing testers at 1800 r/min, Hz.
pub const TESTER_BANDS_HZ: [[f64; 2]; 3] = [[50.0, 300.0], [300.0, 1800.0], [1800.0, 10_000.0]];
/// Fewest periods of the lowest frequency of a band in a record.
const PERIODS: f64 = 8.0;
/// Share of the samples at either end over which they fade, and which is in neither rms nor peak: the transform takes
/// the record for periodic, and the step from its end to its beginning would be in every band.
const ENDS: f64 = 0.125;
/// Half the width of the edge of a band over its frequency.
const EDGE: f64 = 0.1;

/// Velocity in a band.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BandVelocity {
    /// Low edge, Hz.
    pub low_hz: f64,
    /// High edge, Hz.
    pub high_hz: f64,
    /// Root mean square, m/s.
    pub rms_m_s: f64,
    /// Largest magnitude, m/s.
    pub peak_m_s: f64,
}

/// Velocities of an acceleration (m/s²) in bands (low and high edge, Hz). Bands that the samples do not reach, by their
/// rate (Hz) or their length, are left out.
///
/// # Errors
/// Fewer than 4 samples, a sample that is not finite, a rate that is not positive.
pub fn band_velocities(
    acceleration: &[f64],
    rate_hz: f64,
    bands: &[[f64; 2]],
) -> Result<Vec<BandVelocity>, SignalError> {
    check_rate(rate_hz)?;
    check_samples(acceleration, LEAST_SAMPLES)?;
    let count = acceleration.len();
    let lasts = |low_hz: f64| PERIODS * rate_hz / low_hz <= count as f64;
    let reached = |[low_hz, high_hz]: &&[f64; 2]| *high_hz <= 0.5 * rate_hz && lasts(*low_hz);
    let ends = ((ENDS * count as f64) as usize).max(1);
    let lines = forward(faded(&without_trend(acceleration), ends))?;
    bands.iter().filter(reached).map(|band| of_band(&lines, (count, ends), rate_hz, *band)).collect()
}

/// Velocity in a band by the lines of so many samples, without so many at either end.
fn of_band(
    lines: &[Complex<f64>],
    (count, ends): (usize, usize),
    rate_hz: f64,
    [low_hz, high_hz]: [f64; 2],
) -> Result<BandVelocity, SignalError> {
    let integrated = lines.iter().enumerate().map(|(k, line)| {
        let frequency = k as f64 * rate_hz / count as f64;
        let gain = rise(frequency, low_hz).sin() * rise(frequency, high_hz).cos();
        if gain > 0.0 { line * gain / Complex::new(0.0, TAU * frequency) } else { Complex::ZERO }
    });
    let velocity = inverse(integrated.collect(), count)?;
    let whole = &velocity[ends..count - ends];
    let square = whole.iter().map(|v| v * v).sum::<f64>() / whole.len() as f64;
    let peak_m_s = whole.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    Ok(BandVelocity { low_hz, high_hz, rms_m_s: square.sqrt(), peak_m_s })
}

/// Angle from 0 to a right one across an edge, a half of it at its frequency: its sine and cosine are the gains above
/// and below the edge.
fn rise(frequency_hz: f64, edge_hz: f64) -> f64 {
    let across = 0.5 * (1.0 + (frequency_hz / edge_hz).ln() / EDGE.ln_1p());
    FRAC_PI_2 * (FRAC_PI_2 * across.clamp(0.0, 1.0)).sin().powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f64 = 25_600.0;

    fn tones(tones: &[(f64, f64)]) -> Vec<f64> {
        let at = |t: f64| tones.iter().map(|(amplitude, hz)| amplitude * (TAU * hz * t).sin()).sum();
        (0..25_600).map(|n| at(n as f64 / RATE)).collect()
    }

    #[test]
    fn limit_a_tone_has_the_velocity_of_its_frequency_in_its_band_alone() {
        let found = band_velocities(&tones(&[(2.0, 120.3), (5.0, 1000.0)]), RATE, &TESTER_BANDS_HZ).unwrap();
        let expected = [2.0 / (TAU * 120.3), 5.0 / (TAU * 1000.0)];
        for (band, amplitude) in found.iter().zip(expected) {
            assert!((band.rms_m_s * 2f64.sqrt() / amplitude - 1.0).abs() < 0.01, "{band:?}");
            assert!((band.peak_m_s / amplitude - 1.0).abs() < 0.04, "{band:?}");
        }
        assert!(found[2].rms_m_s < 1e-3 * expected[1], "{found:?}");
    }

    /// A line that is a thousand times as strong and falls between the lines of the record stays in its own band.
    #[test]
    fn limit_a_strong_line_of_another_band_leaves_rms_and_peak_as_they_are() {
        let found = band_velocities(&tones(&[(500.0, 2800.37), (0.5, 120.0)]), RATE, &TESTER_BANDS_HZ).unwrap();
        let amplitude = 0.5 / (TAU * 120.0);
        assert!((found[0].peak_m_s / amplitude - 1.0).abs() < 0.01, "{found:?}");
        assert!((found[0].rms_m_s * 2f64.sqrt() / amplitude - 1.0).abs() < 0.01, "{found:?}");
        assert!(found[1].peak_m_s < 1e-3 * amplitude, "{found:?}");
        assert!((found[2].peak_m_s * TAU * 2800.37 / 500.0 - 1.0).abs() < 0.01, "{found:?}");
    }

    /// Half of the power of a line at an edge is on either side of it.
    #[test]
    fn identity_bands_share_the_power_of_a_line_at_their_edge() {
        for frequency in [287.3, 300.0, 318.9] {
            let found = band_velocities(&tones(&[(1.0, frequency)]), RATE, &TESTER_BANDS_HZ).unwrap();
            let square = found[0].rms_m_s.powi(2) + found[1].rms_m_s.powi(2);
            assert!((2.0 * square * (TAU * frequency).powi(2) - 1.0).abs() < 0.01, "{found:?}");
            assert!(frequency != 300.0 || (found[0].rms_m_s / found[1].rms_m_s - 1.0).abs() < 0.02, "{found:?}");
        }
    }

    #[test]
    fn limit_bands_that_samples_do_not_reach_are_left_out() {
        let whole = tones(&[(1.0, 500.0)]);
        assert_eq!(band_velocities(&whole, RATE, &TESTER_BANDS_HZ).unwrap().len(), 3);
        assert_eq!(band_velocities(&whole, 12_800.0, &TESTER_BANDS_HZ).unwrap().len(), 2);
        assert_eq!(band_velocities(&whole[..2560], RATE, &TESTER_BANDS_HZ).unwrap().len(), 2);
    }

    #[test]
    fn identity_white_acceleration_has_the_velocity_of_its_density() {
        // A fixed sequence that looks like noise: squares modulo a prime.
        let noise: Vec<f64> = (0..102_400u64).map(|n| ((n * n * n) % 99_991) as f64 / 99_991.0 - 0.5).collect();
        let variance = noise.iter().map(|x| x * x).sum::<f64>() / noise.len() as f64;
        let density = 2.0 * variance / RATE;
        for band in band_velocities(&noise, RATE, &TESTER_BANDS_HZ).unwrap() {
            let expected = (density * (band.low_hz.recip() - band.high_hz.recip())).sqrt() / TAU;
            assert!((band.rms_m_s / expected - 1.0).abs() < 0.1, "{band:?} {expected}");
        }
    }
}
