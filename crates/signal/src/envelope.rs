//! Envelopes of amplitude-modulated signals by the analytic signal.

use realfft::num_complex::Complex;

use crate::error::{SignalError, check_rate, check_samples};
use crate::spectrum::{LEAST_SAMPLES, Spectrum};
use crate::transform::{forward, inverse};
use crate::window::Window;

/// Magnitude of the analytic signal `x + i H{x}` of the samples in a band, in their unit.
///
/// The band (low and high edge, Hz) passes whole lines of the transform and nothing else; without a band all but the
/// mean passes. Signals are taken as periodic: within about the inverse of the band's width from both ends the envelope
/// of a signal that is not periodic is wrong.
///
/// # Errors
///
/// Fewer than 4 samples, a sample that is not finite, a rate (Hz) that is not positive, a band that does not lie within
/// 0 to half the rate or holds no line.
pub fn envelope(samples: &[f64], rate_hz: f64, band: Option<[f64; 2]>) -> Result<Vec<f64>, SignalError> {
    check_rate(rate_hz)?;
    check_samples(samples, LEAST_SAMPLES)?;
    let count = samples.len();
    let spacing = rate_hz / count as f64;
    let nyquist_hz = 0.5 * rate_hz;
    let [low_hz, high_hz] = band.unwrap_or([0.0, nyquist_hz]);
    let refused = SignalError::Band { low_hz, high_hz, nyquist_hz };
    if !(low_hz >= 0.0 && high_hz > low_hz && high_hz <= nyquist_hz) {
        return Err(refused);
    }
    let mean = samples.iter().sum::<f64>() / count as f64;
    let mut lines = forward(samples.iter().map(|x| x - mean).collect())?;
    let mut passed = 0;
    for (k, line) in lines.iter_mut().enumerate() {
        let inside = k > 0 && (low_hz..=high_hz).contains(&(k as f64 * spacing));
        passed += usize::from(inside);
        if !inside {
            *line = Complex::ZERO;
        }
    }
    if passed == 0 {
        return Err(refused);
    }
    // The Hilbert transform turns every line by a quarter: sines for cosines.
    let turned = lines.iter().map(|x| Complex::new(x.im, -x.re)).collect();
    let (real, imaginary) = (inverse(lines, count)?, inverse(turned, count)?);
    Ok(real.iter().zip(&imaginary).map(|(x, y)| x.hypot(*y)).collect())
}

/// Spectrum (Hann window) of the [`envelope`] of the samples in a band: lines where the amplitude of that band is
/// modulated.
///
/// # Errors
///
/// Those of [`envelope`].
pub fn envelope_spectrum(samples: &[f64], rate_hz: f64, band: Option<[f64; 2]>) -> Result<Spectrum, SignalError> {
    Spectrum::of(&envelope(samples, rate_hz, band)?, rate_hz, Window::Hann)
}
