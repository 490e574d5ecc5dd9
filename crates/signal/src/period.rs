//! The period of a signal by its autocorrelation.

use serde::{Deserialize, Serialize};

use crate::error::{SignalError, check_rate, check_samples};
use crate::transform::{forward, inverse};

/// A period and how well the signal repeats after it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Period {
    /// Period, s, interpolated between samples.
    pub period_s: f64,
    /// Correlation of the signal with itself one period later: 1 for exact repetition.
    pub correlation: f64,
}

/// A maximum this near to the greatest one is as good: the shortest of such is the period, the others its multiples.
const AS_GOOD: f64 = 0.95;

/// `r(τ) = Σ x_n x_{n+τ}/√(Σ x_n² Σ x_{n+τ}²)` over the overlapping parts of the samples less their mean, for lags 0 to
/// `most`.
///
/// With both energies taken over the overlap only, r is 1 at the period of a periodic signal whatever its length.
fn autocorrelation(samples: &[f64], most: usize) -> Result<Vec<f64>, SignalError> {
    let count = samples.len();
    let mean = samples.iter().sum::<f64>() / count as f64;
    let mut padded: Vec<f64> = samples.iter().map(|x| x - mean).collect();
    let mut energy = vec![0.0];
    let mut sum = 0.0;
    energy.extend(padded.iter().map(|x| {
        sum += x * x;
        sum
    }));
    // Zeros at the end keep the ends of the signal from meeting.
    padded.resize(count + most + 1, 0.0);
    let length = padded.len();
    let lines = forward(padded)?.iter().map(|x| realfft::num_complex::Complex::new(x.norm_sqr(), 0.0)).collect();
    let products = inverse(lines, length)?;
    let normalised = |lag: usize| {
        let energies = energy[count - lag] * (energy[count] - energy[lag]);
        if energies > 0.0 { products[lag] / energies.sqrt() } else { 0.0 }
    };
    Ok((0..=most).map(normalised).collect())
}

/// The shortest period between two bounds, s, after which the signal repeats as well as after any other.
///
/// The samples must span twice the upper bound.
///
/// # Errors
///
/// Bounds that are not positive and rising or of which the lower is below two samples, too few samples for the upper
/// one, a sample that is not finite, a rate (Hz) that is not positive, no positive maximum of the correlation between
/// the bounds.
pub fn period(samples: &[f64], rate_hz: f64, [shortest_s, longest_s]: [f64; 2]) -> Result<Period, SignalError> {
    check_rate(rate_hz)?;
    for (name, value) in [("shortest period in s", shortest_s), ("longest period in s", longest_s)] {
        if !(value.is_finite() && value * rate_hz >= 2.0) || longest_s <= shortest_s {
            return Err(SignalError::Setting { name, value });
        }
    }
    let most = (longest_s * rate_hz).floor() as usize;
    check_samples(samples, (2 * most).max(8))?;
    let r = autocorrelation(samples, most + 1)?;
    let least = (shortest_s * rate_hz).ceil() as usize;
    let maxima = (least..=most).filter(|k| r[*k] > 0.0 && r[*k] > r[k - 1] && r[*k] >= r[k + 1]);
    let maxima: Vec<(f64, f64)> = maxima.map(|k| vertex(k, [r[k - 1], r[k], r[k + 1]])).collect();
    let best = maxima.iter().fold(0.0, |most: f64, (_, height)| most.max(*height));
    match maxima.iter().find(|(_, height)| *height >= AS_GOOD * best) {
        Some((lag, correlation)) => Ok(Period { period_s: lag / rate_hz, correlation: correlation.min(1.0) }),
        None => Err(SignalError::NoPeriod { shortest_s, longest_s }),
    }
}

/// Vertex of the parabola through three neighbouring values: place and height.
fn vertex(middle: usize, [left, top, right]: [f64; 3]) -> (f64, f64) {
    let bend = left - 2.0 * top + right;
    let offset = if bend < 0.0 { 0.5 * (left - right) / bend } else { 0.0 };
    (middle as f64 + offset, top - 0.25 * (left - right) * offset)
}
