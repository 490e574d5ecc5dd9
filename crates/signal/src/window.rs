//! Windows: sums of cosines, their gains, and the lobe that a sine makes in the spectrum.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

/// The window by which samples are weighted before the transform.
///
/// The default is [`Window::Hann`]: its leakage falls fast and its lobe, ±2 lines, is narrow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Window {
    /// `½ − ½ cos(2πn/N)`: between lines a sine shows up to 15 % low.
    #[default]
    Hann,
    /// No weighting: exact for whole periods only; between lines up to 36 % low, with much leakage.
    Rectangular,
    /// Five cosine terms: amplitudes right to 0.1 % between lines, lobe of ±5 lines.
    FlatTop,
}

/// Coefficients of the flat-top window: G. D'Antona, A. Ferrero, "Digital Signal Processing for Measurement Systems",
/// Springer 2006, p. 72.
const FLAT_TOP: [f64; 5] = [0.215_578_95, 0.416_631_58, 0.277_263_158, 0.083_578_947, 0.006_947_368];

impl Window {
    /// a_j of `w(n) = Σ (−1)^j a_j cos(2πjn/N)`.
    fn coefficients(self) -> &'static [f64] {
        match self {
            Self::Hann => &[0.5, 0.5],
            Self::Rectangular => &[1.0],
            Self::FlatTop => &FLAT_TOP,
        }
    }

    /// The weights of `count` samples, periodic in `count`.
    pub fn weights(self, count: usize) -> Vec<f64> {
        let weight = |n: usize| {
            let turn = 2.0 * PI * n as f64 / count as f64;
            let term = |(j, a): (usize, &f64)| sign(j) * a * (j as f64 * turn).cos();
            self.coefficients().iter().enumerate().map(term).sum()
        };
        (0..count).map(weight).collect()
    }

    /// Coherent gain: the mean of the weights, by which the line of a sine is lowered.
    pub fn coherent_gain(self) -> f64 {
        self.coefficients()[0]
    }

    /// Equivalent noise bandwidth in lines: `N Σw²/(Σw)²`.
    pub fn noise_bandwidth_lines(self) -> f64 {
        let a = self.coefficients();
        1.0 + 0.5 * a[1..].iter().map(|a| (a / self.coherent_gain()).powi(2)).sum::<f64>()
    }

    /// Half the width of the lobe of a sine, from the peak to the first zero, in lines.
    pub fn lobe_lines(self) -> usize {
        self.coefficients().len()
    }

    /// Height of the lobe at a distance from its middle in lines; 1 in the middle. In the limit of many samples
    /// `sinc δ + Σ_j a_j/(2a_0) [sinc(δ − j) + sinc(δ + j)]` with `sinc x = sin(πx)/(πx)`.
    pub fn lobe(self, distance_lines: f64) -> f64 {
        let a = self.coefficients();
        let shifted = |shift: f64| sinc(distance_lines - shift);
        let pair = |j: usize| 0.5 * a[j] * (shifted(j as f64) + shifted(-(j as f64)));
        (a[0] * shifted(0.0) + (1..a.len()).map(pair).sum::<f64>()) / a[0]
    }

    /// Place of a sine beside the highest line, in lines from −½ to ½, from that line and its neighbours.
    ///
    /// For Hann and no window in closed form from the highest line and its higher neighbour, after T. Grandke, IEEE
    /// Trans. Instrum. Meas. 32 (1983) 350, doi:10.1109/TIM.1983.4314077; for the flat top, whose top says little, from
    /// the ratio of the two neighbours.
    pub(crate) fn offset(self, [left, top, right]: [f64; 3]) -> f64 {
        let side = if right >= left { 1.0 } else { -1.0 };
        let ratio = left.max(right) / top;
        match self {
            Self::Hann => side * ((2.0 * ratio - 1.0) / (1.0 + ratio)).clamp(0.0, 0.5),
            Self::Rectangular => side * (ratio / (1.0 + ratio)).clamp(0.0, 0.5),
            Self::FlatTop => side * self.offset_by_neighbours(left.min(right) / left.max(right)),
        }
    }

    /// The offset at which the lower neighbour is `ratio` of the higher one; by bisection, the ratio falls with the
    /// offset.
    fn offset_by_neighbours(self, ratio: f64) -> f64 {
        let (mut low, mut high) = (0.0, 0.5);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if self.lobe(1.0 + middle) / self.lobe(1.0 - middle) > ratio { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

fn sign(j: usize) -> f64 {
    if j.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// `sin(πx)/(πx)`.
pub(crate) fn sinc(x: f64) -> f64 {
    let angle = PI * x;
    // Below this the next term of the series is under the rounding.
    if angle.abs() < 1e-8 { 1.0 } else { angle.sin() / angle }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Window; 3] = [Window::Hann, Window::Rectangular, Window::FlatTop];

    #[test]
    fn identity_gains_are_those_of_the_weights() {
        for window in ALL {
            let weights = window.weights(64);
            let sum: f64 = weights.iter().sum();
            let squares: f64 = weights.iter().map(|w| w * w).sum();
            assert!((sum / 64.0 - window.coherent_gain()).abs() < 1e-12);
            assert!((64.0 * squares / (sum * sum) - window.noise_bandwidth_lines()).abs() < 1e-12);
        }
    }

    /// Harris 1978, doi:10.1109/PROC.1978.10837, Table 1: bandwidth 1.50, scalloping loss 1.42 dB; rectangular 1.00 and
    /// 3.92 dB.
    #[test]
    fn paper_bandwidth_and_scalloping_loss() {
        assert_eq!(Window::Hann.noise_bandwidth_lines(), 1.5);
        assert_eq!(Window::Rectangular.noise_bandwidth_lines(), 1.0);
        let loss = |w: Window| -20.0 * w.lobe(0.5).log10();
        assert!((loss(Window::Hann) - 1.42).abs() < 5e-3);
        assert!((loss(Window::Rectangular) - 3.92).abs() < 5e-3);
        assert!((Window::FlatTop.lobe(0.5) - 1.0).abs() < 1.2e-3, "{}", Window::FlatTop.lobe(0.5));
    }

    #[test]
    fn identity_offset_inverts_the_lobe() {
        for window in ALL {
            for step in -10..=10i32 {
                let offset = 0.05 * f64::from(step);
                let heights = [-1.0, 0.0, 1.0].map(|line| window.lobe(line - offset).abs());
                let found = window.offset(heights);
                // At ±½ both sides are right.
                let error = if step.abs() == 10 { (found.abs() - 0.5).abs() } else { (found - offset).abs() };
                assert!(error < 1e-9, "{window:?} {offset} {found}");
            }
        }
    }

    #[test]
    fn limit_lobe_ends_at_its_first_zero() {
        for window in ALL {
            let zero = window.lobe_lines() as f64;
            assert!(window.lobe(zero).abs() < 1e-12 && window.lobe(zero - 0.5).abs() > 1e-4, "{window:?}");
        }
    }
}
