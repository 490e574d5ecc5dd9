//! Velocity of vibration in the three bands of bearing testers.
//!
//! ISO 15242-1 measures the radial velocity of the outer ring in bands that belong to 1800 r/min of the inner ring, 50
//! to 300, 300 to 1800 and 1800 to 10 000 Hz. The velocity is the integral of the acceleration, line by line: A/2πf.

use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

use crate::diagnosis::without_trend;
use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::LEAST_SAMPLES;
use crate::transform::{forward, inverse};
use crate::welch::{Segments, welch};

/// Bands of bearing testers at 1800 r/min, Hz.
pub const TESTER_BANDS_HZ: [[f64; 2]; 3] = [[50.0, 300.0], [300.0, 1800.0], [1800.0, 10_000.0]];
/// Least lines of a segment within the lowest frequency of a band, and what they are apart where there are samples
/// enough, Hz: tones of other bands stay in theirs.
const LINES: f64 = 8.0;
const APART_HZ: f64 = 12.5;
/// Share of the samples at either end at which a band of a signal that is not periodic is wrong.
const ENDS: f64 = 0.05;

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
    let segment = |low_hz: f64| (LINES * rate_hz / low_hz) as usize;
    let reached = |[low_hz, high_hz]: &[f64; 2]| high_hz <= &(0.5 * rate_hz) && segment(*low_hz) <= acceleration.len();
    let lines = forward(without_trend(acceleration))?;
    bands.iter().filter(|band| reached(band)).map(|band| of_band(acceleration, &lines, (rate_hz, *band))).collect()
}

fn of_band(
    acceleration: &[f64],
    lines: &[Complex<f64>],
    (rate_hz, [low_hz, high_hz]): (f64, [f64; 2]),
) -> Result<BandVelocity, SignalError> {
    let segment = (LINES * rate_hz / low_hz).max(rate_hz / APART_HZ) as usize;
    let density = welch(acceleration, rate_hz, Segments::half_overlapping(segment.min(acceleration.len())))?;
    let spacing = density.frequency_hz[1];
    let inside =
        density.frequency_hz.iter().zip(&density.density_per_hz).filter(|(f, _)| (low_hz..high_hz).contains(*f));
    let variance: f64 = inside.map(|(f, s)| s * spacing / (TAU * f).powi(2)).sum();
    let count = acceleration.len();
    let integrated = lines.iter().enumerate().map(|(k, line)| {
        let frequency = k as f64 * rate_hz / count as f64;
        if (low_hz..high_hz).contains(&frequency) { line / Complex::new(0.0, TAU * frequency) } else { Complex::ZERO }
    });
    let velocity = inverse(integrated.collect(), count)?;
    let end = (ENDS * count as f64) as usize;
    let peak_m_s = velocity[end..count - end].iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    Ok(BandVelocity { low_hz, high_hz, rms_m_s: variance.sqrt(), peak_m_s })
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
