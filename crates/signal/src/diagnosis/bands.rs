//! Bands of a signal as complex envelopes, their kurtosis over a tree of bands, and whitening.

use realfft::num_complex::Complex;
use serde::Serialize;

use crate::error::{SignalError, check_rate, check_samples};
use crate::transform::{forward, inverse, inverse_complex};

/// A band of the kurtogram.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Band {
    /// Lower edge, Hz.
    pub low_hz: f64,
    /// Upper edge, Hz.
    pub high_hz: f64,
    /// Spectral kurtosis `⟨|c|⁴⟩/⟨|c|²⟩² − 2` of the complex envelope c of the band: 0 for Gaussian noise, −1 for a
    /// sine, large for a train of impacts.
    pub kurtosis: f64,
}

/// The transform of a signal, from which bands are cut.
pub(crate) struct Lines {
    lines: Vec<Complex<f64>>,
    count: usize,
    rate_hz: f64,
    /// Samples at either end that are left out of all envelopes.
    faded: usize,
}

/// Share of a record at either end that is in no envelope, over half of which it fades: the transform takes the record
/// for periodic, and the step from its end to its beginning would be a blow in every band.
const FADED: f64 = 1.0 / 32.0;

/// The samples with both ends faded over a number of them, without a jump in the second derivative.
pub(crate) fn faded(samples: &[f64], count: usize) -> Vec<f64> {
    let last = samples.len() - 1;
    let weight = |n: usize| {
        let from_end = n.min(last - n) as f64 + 0.5;
        let x = (from_end / count as f64).min(1.0);
        x * x * x * (10.0 + x * (6.0 * x - 15.0))
    };
    samples.iter().enumerate().map(|(n, x)| x * weight(n)).collect()
}

/// Squared envelope of a band.
pub(crate) struct SquaredEnvelope {
    /// Samples, in the squared unit of the signal.
    pub values: Vec<f64>,
    /// Time of the first one, in samples of the signal.
    pub first: usize,
    /// Their rate, Hz: twice the width of the band.
    pub rate_hz: f64,
}

impl Lines {
    pub fn of(samples: &[f64], rate_hz: f64) -> Result<Self, SignalError> {
        check_rate(rate_hz)?;
        check_samples(samples, LEAST)?;
        let ends = ((FADED * samples.len() as f64) as usize).max(1);
        Ok(Self { lines: forward(faded(samples, ends.div_ceil(2)))?, count: samples.len(), rate_hz, faded: ends })
    }

    pub fn duration_s(&self) -> f64 {
        (self.count - 2 * self.faded) as f64 / self.rate_hz
    }

    pub fn nyquist_hz(&self) -> f64 {
        0.5 * self.rate_hz
    }

    /// All lines with one magnitude and their phases as they are (cepstrum pre-whitening, P. Borghesani et al., Mech.
    /// Syst. Signal Process. 36 (2013) 370, doi:10.1016/j.ymssp.2012.11.001): tones and resonances no longer outweigh
    /// the rest.
    pub fn whitened(&self) -> Self {
        let unit = |line: &Complex<f64>| if line.norm() > 0.0 { line / line.norm() } else { Complex::ZERO };
        Self { lines: self.lines.iter().map(unit).collect(), ..*self }
    }

    /// The lines of a band; line 0 is never among them.
    fn within(&self, [low_hz, high_hz]: [f64; 2]) -> &[Complex<f64>] {
        let place = |hz: f64| (hz * self.count as f64 / self.rate_hz).round() as usize;
        let end = place(high_hz).min(self.lines.len());
        &self.lines[place(low_hz).clamp(1, end.max(1))..end.max(1)]
    }

    /// Height of blows in a band, in the unit of the samples: what its envelope exceeds for a hundredth of the time.
    pub fn height(&self, edges: [f64; 2]) -> f64 {
        let mut squares = self.squared_envelope(edges).values;
        let place = (0.99 * squares.len() as f64) as usize;
        squares.select_nth_unstable_by(place, f64::total_cmp).1.sqrt()
    }

    fn kurtosis(&self, edges: [f64; 2]) -> f64 {
        let envelope = inverse_complex(self.within(edges).to_vec());
        let envelope = self.whole(&envelope);
        let mean = |power: i32| envelope.iter().map(|c| c.norm_sqr().powi(power)).sum::<f64>() / envelope.len() as f64;
        let square = mean(1).powi(2);
        if square > 0.0 { mean(2) / square - 2.0 } else { 0.0 }
    }

    /// An envelope without its faded ends.
    fn whole<'a, T>(&self, envelope: &'a [T]) -> &'a [T] {
        let ends = (self.faded * envelope.len()).div_ceil(self.count);
        &envelope[ends..envelope.len() - ends]
    }

    /// Squared envelope of a band, at twice the width of the band, so that its own spectrum does not fold.
    pub fn squared_envelope(&self, edges: [f64; 2]) -> SquaredEnvelope {
        let mut lines = self.within(edges).to_vec();
        let count = 2 * lines.len();
        lines.resize(count, Complex::ZERO);
        let envelope = inverse_complex(lines);
        let square = |c: &Complex<f64>| 4.0 * c.norm_sqr() / (self.count as f64).powi(2);
        let values = self.whole(&envelope).iter().map(square).collect();
        SquaredEnvelope { values, first: self.faded, rate_hz: count as f64 * self.rate_hz / self.count as f64 }
    }
}

/// Fewest samples that bands are cut from.
const LEAST: usize = 64;

/// Spectral kurtosis over a tree of bands that halves and thirds the frequencies from 0 to half the rate: 1, 2, 3, 4,
/// 6, 8, 12 … bands of one width, none narrower than `least_width_hz`. Ordered from wide to narrow, then from low to
/// high.
///
/// After J. Antoni, Mech. Syst. Signal Process. 21 (2007) 108, doi:10.1016/j.ymssp.2005.12.002, with bands cut from the
/// transform of the whole record in place of his filter bank.
///
/// # Errors
///
/// Fewer than 64 samples, a sample that is not finite, a rate (Hz) or width that is not positive.
pub fn kurtogram(samples: &[f64], rate_hz: f64, least_width_hz: f64) -> Result<Vec<Band>, SignalError> {
    crate::error::check_setting("least width of a band in Hz", least_width_hz, false)?;
    Ok(of_lines(&Lines::of(samples, rate_hz)?, least_width_hz))
}

pub(crate) fn of_lines(lines: &Lines, least_width_hz: f64) -> Vec<Band> {
    let nyquist_hz = lines.nyquist_hz();
    let mut bands = Vec::new();
    for parts in (0..).flat_map(|level| if level == 0 { vec![1] } else { vec![1 << level, 3 << (level - 1)] }) {
        let width = nyquist_hz / f64::from(parts);
        if parts > 1 && (width < least_width_hz || parts > MOST_PARTS) {
            break;
        }
        for part in 0..parts {
            let [low_hz, high_hz] = [part, part + 1].map(|edge| width * f64::from(edge));
            if lines.within([low_hz, high_hz]).len() >= LEAST / 4 {
                bands.push(Band { low_hz, high_hz, kurtosis: lines.kurtosis([low_hz, high_hz]) });
            }
        }
    }
    bands
}

/// Narrower bands would hold no train of impacts at any usual rate.
const MOST_PARTS: i32 = 96;

/// The samples less the straight line that fits them best: an offset and a drift of the sensor say nothing.
pub fn without_trend(samples: &[f64]) -> Vec<f64> {
    let count = samples.len() as f64;
    let middle = 0.5 * (count - 1.0);
    let mean = samples.iter().sum::<f64>() / count;
    let place = |n: usize| n as f64 - middle;
    let spread: f64 = (0..samples.len()).map(|n| place(n).powi(2)).sum();
    let product: f64 = samples.iter().enumerate().map(|(n, x)| place(n) * (x - mean)).sum();
    let slope = if spread > 0.0 { product / spread } else { 0.0 };
    samples.iter().enumerate().map(|(n, x)| x - mean - slope * place(n)).collect()
}

/// The samples with all lines of their spectrum at one magnitude, mean square 1 (see `Lines::whitened`).
///
/// # Errors
///
/// Fewer than 64 samples, a sample that is not finite.
pub fn whitened(samples: &[f64]) -> Result<Vec<f64>, SignalError> {
    check_samples(samples, LEAST)?;
    let lines =
        Lines { lines: forward(samples.to_vec())?, count: samples.len(), rate_hz: 1.0, faded: 0 }.whitened().lines;
    let values = inverse(lines, samples.len())?;
    let scale = (values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64).sqrt();
    Ok(values.iter().map(|x| if scale > 0.0 { x / scale } else { 0.0 }).collect())
}
