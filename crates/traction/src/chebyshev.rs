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
