//! Chebyshev series of a smooth function on an interval.

use crate::Scalar;
use std::f64::consts::PI;

/// Σ c_k T_k on [low, high].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chebyshev {
    middle: f64,
    half: f64,
    coefficients: Vec<f64>,
}

impl Chebyshev {
    /// Interpolates `f` at `count` Chebyshev nodes.
    pub(crate) fn interpolate(low: f64, high: f64, count: usize, f: impl Fn(f64) -> f64) -> Self {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        // cos(k (2i + 1) π/(2 count)) from one table over a full turn.
        let cosines: Vec<f64> = (0..4 * count).map(|j| (PI * j as f64 / (2 * count) as f64).cos()).collect();
        let cosine = |k: usize, i: usize| cosines[k * (2 * i + 1) % (4 * count)];
        let values: Vec<f64> = (0..count).map(|i| f(middle + half * cosine(1, i))).collect();
        let coefficients = (0..count)
            .map(|k| {
                let sum: f64 = values.iter().enumerate().map(|(i, v)| v * cosine(k, i)).sum();
                sum * if k == 0 { 1.0 } else { 2.0 } / count as f64
            })
            .collect();
        Self { middle, half, coefficients }
    }

    /// Drops the trailing coefficients that are rounding noise, which would only spoil derivatives.
    pub(crate) fn trimmed(mut self) -> Self {
        let noise = 4e-16 * self.coefficients.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let keep = self.coefficients.iter().rposition(|c| c.abs() > noise).map_or(1, |last| last + 1);
        self.coefficients.truncate(keep);
        self
    }

    /// Size of the last two coefficients against the largest: an estimate of the relative error.
    pub(crate) fn tail(&self) -> f64 {
        let size = |c: &[f64]| c.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let count = self.coefficients.len();
        size(&self.coefficients[count.saturating_sub(2)..]) / size(&self.coefficients).max(f64::MIN_POSITIVE)
    }

    /// The series at `x`, by Clenshaw's recurrence.
    pub(crate) fn value<D: Scalar>(&self, x: D) -> D {
        let t = if self.half > 0.0 { (x - self.middle) / self.half } else { D::zero() };
        let (mut b1, mut b2) = (D::zero(), D::zero());
        for &c in self.coefficients.iter().skip(1).rev() {
            (b1, b2) = (t * b1 * 2.0 - b2 + c, b1);
        }
        t * b1 - b2 + self.coefficients[0]
    }
}

/// Three functions as powers on equal pieces of one interval, for speed in double precision: four interleaved Horner
/// schemes in t⁴ on each piece.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Powers {
    low: f64,
    /// Pieces per unit of x.
    density: f64,
    /// Coefficients of t^(4 i + j), t from −1 to 1 on a piece, by i, j and function; the fourth function is padding.
    pieces: Vec<[[[f64; 4]; 4]; 4]>,
}

/// Terms of a piece.
const TERMS: usize = 16;
/// Most pieces; silver's parabolas take 16.
const MOST_PIECES: usize = 64;

impl Powers {
    /// The series and their derivatives over x. None where so many pieces do not bring the terms down to rounding.
    pub(crate) fn new(series: &[Chebyshev; 3]) -> Option<[Self; 2]> {
        let [first, ..] = series;
        if first.half <= 0.0 {
            return None;
        }
        let counts = std::iter::successors(Some(1), |n| Some(2 * n)).take_while(|&n| n <= MOST_PIECES);
        counts.filter_map(|count| Self::with_pieces(series, count)).next()
    }

    fn with_pieces(series: &[Chebyshev; 3], count: usize) -> Option<[Self; 2]> {
        let low = series[0].middle - series[0].half;
        let width = 2.0 * series[0].half / count as f64;
        let mut pieces = [Vec::with_capacity(count), Vec::with_capacity(count)];
        for piece in 0..count {
            let start = low + width * piece as f64;
            let mut tables = [[[[0.0; 4]; 4]; 4]; 2];
            for (s, whole) in series.iter().enumerate() {
                let local = Chebyshev::interpolate(start, start + width, TERMS, |x| whole.value(x));
                if local.tail() > 1e-15 {
                    return None;
                }
                let powers = local.trimmed().powers();
                for (k, &c) in powers.iter().enumerate() {
                    tables[0][k / 4][k % 4][s] = c;
                    if k > 0 {
                        tables[1][(k - 1) / 4][(k - 1) % 4][s] = k as f64 * c * (2.0 / width);
                    }
                }
            }
            pieces.iter_mut().zip(tables).for_each(|(pieces, table)| pieces.push(table));
        }
        let density = width.recip();
        Some(pieces.map(|pieces| Self { low, density, pieces }))
    }

    /// The three values at `x` of the interval.
    pub(crate) fn values(&self, x: f64) -> [f64; 3] {
        let place = (x - self.low) * self.density;
        // Casts saturate: numbers outside the interval and NaN find a piece too.
        let piece = (place as usize).min(self.pieces.len() - 1);
        let t = 2.0 * (place - piece as f64) - 1.0;
        let t2 = t * t;
        let t4 = t2 * t2;
        let mut sums = [[0.0; 4]; 4];
        for row in self.pieces[piece].iter().rev() {
            for (sums, row) in sums.iter_mut().zip(row) {
                for (sum, c) in sums.iter_mut().zip(row) {
                    *sum = *sum * t4 + c;
                }
            }
        }
        [0, 1, 2].map(|s| (sums[0][s] + sums[1][s] * t) + (sums[2][s] + sums[3][s] * t) * t2)
    }
}

impl Chebyshev {
    /// Coefficients by rising powers of t, from T_(k+1) = 2 t T_k − T_(k−1).
    fn powers(&self) -> Vec<f64> {
        let count = self.coefficients.len();
        let mut powers = vec![0.0; count];
        let (mut below, mut current) = (vec![0.0; count], vec![0.0; count]);
        current[0] = 1.0;
        for (k, c) in self.coefficients.iter().enumerate() {
            powers.iter_mut().zip(&current).for_each(|(p, t)| *p += c * t);
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let next: Vec<f64> =
                (0..count).map(|i| factor * if i > 0 { current[i - 1] } else { 0.0 } - below[i]).collect();
            below = std::mem::replace(&mut current, next);
        }
        powers
    }
}
