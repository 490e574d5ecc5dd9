//! Quantities of a ball at any azimuth, from the solved ones at N equispaced azimuths.
//!
//! Smooth periodic data f_j at φ_j = φ_0 + 2πj/N have one trigonometric interpolant of least degree,
//! f(φ) = Σ_j D(φ − φ_j) f_j, with the cardinal function D(x) = sin(Nx/2)/(N sin(x/2)) for odd N and
//! D(x) = sin(Nx/2) cos(x/2)/(N sin(x/2)) for even N (Trefethen, Spectral Methods in MATLAB, 2000,
//! doi:10.1137/1.9780898719598, chapter 3). It converges exponentially where the solution is analytic in φ.
//! A ball that loses contact makes the data kink, and the interpolant would ring through zero load: then every
//! quantity is interpolated linearly. Pocket force and pocket wear have a dead band and are always linear.

use crate::{BallResult, Solution};
use std::f64::consts::TAU;
use tribodyn_bearing::quantities::{Course, OfBall};

/// How quantities are interpolated over azimuth.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AzimuthRule {
    /// Trigonometric: all balls carry load at both races.
    Trigonometric,
    /// Piecewise linear: some ball has lost contact.
    Linear,
}

impl AzimuthRule {
    /// The rule that suits a solution.
    pub fn of(solution: &Solution) -> Self {
        if solution.balls.iter().all(BallResult::is_loaded) { AzimuthRule::Trigonometric } else { AzimuthRule::Linear }
    }

    /// Name for the metadata of the recording.
    pub fn name(self) -> &'static str {
        match self {
            AzimuthRule::Trigonometric => "trigonometric",
            AzimuthRule::Linear => "linear",
        }
    }
}

/// Weights of N equispaced values, the first at `first`, for the value at `azimuth` (both rad); they sum to 1.
fn weights(rule: AzimuthRule, count: usize, first: f64, azimuth: f64) -> Vec<f64> {
    let spacing = TAU / count as f64;
    match rule {
        AzimuthRule::Trigonometric => {
            (0..count).map(|j| cardinal(count, azimuth - first - spacing * j as f64)).collect()
        }
        AzimuthRule::Linear => {
            let place = (azimuth - first).rem_euclid(TAU) / spacing;
            let left = place.floor();
            let mut out = vec![0.0; count];
            // rem_euclid may round up to the full circle: wrap the index.
            out[left as usize % count] += 1.0 - (place - left);
            out[(left as usize + 1) % count] += place - left;
            out
        }
    }
}

fn cardinal(count: usize, x: f64) -> f64 {
    let n = count as f64;
    // Near a full turn the two sines would vanish with different rounding errors: reduce to a half turn first.
    let x = x - TAU * (x / TAU).round();
    let half = (0.5 * x).sin();
    // At a node the quotient is 0/0, its limit 1.
    if half == 0.0 {
        return 1.0;
    }
    let even = if count.is_multiple_of(2) { (0.5 * x).cos() } else { 1.0 };
    (0.5 * n * x).sin() * even / (n * half)
}

/// A ball at an azimuth (rad), from the weights of the solution's rule and the linear ones.
fn blend(balls: &[BallResult], rule: &[f64], linear: &[f64], azimuth: f64) -> BallResult {
    let mut out = BallResult::default();
    for quantity in OfBall::all() {
        let course = quantity.facts().course;
        let weights = if course == Course::Threshold { linear } else { rule };
        let sum = weights.iter().zip(balls).map(|(w, ball)| Some(w * quantity.get(ball)?)).sum::<Option<f64>>();
        // The interpolant of a positive quantity may undershoot.
        let value = if course == Course::Positive { sum.map(|v| v.max(0.0)) } else { sum };
        if let Some(value) = value {
            quantity.set(&mut out, value);
        }
    }
    BallResult { azimuth_rad: azimuth, ..out }
}

/// The solution as a function of azimuth.
#[derive(Debug, Clone)]
pub struct OverAzimuth<'a> {
    balls: &'a [BallResult],
    rule: AzimuthRule,
    first: f64,
}

impl<'a> OverAzimuth<'a> {
    /// Takes the balls of a solution: at least one, equispaced, as the solver gives them.
    pub fn new(solution: &'a Solution) -> Self {
        Self { balls: &solution.balls, rule: AzimuthRule::of(solution), first: solution.balls[0].azimuth_rad }
    }

    /// Azimuth of a ball at the start, rad.
    pub fn start(&self, ball: usize) -> f64 {
        self.first + TAU * ball as f64 / self.balls.len() as f64
    }

    /// The state of a ball at this azimuth, rad, between those of the solution.
    pub fn at(&self, azimuth: f64) -> BallResult {
        let count = self.balls.len();
        let rule = weights(self.rule, count, self.first, azimuth);
        let linear = weights(AzimuthRule::Linear, count, self.first, azimuth);
        blend(self.balls, &rule, &linear, azimuth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_trigonometric_weights_reproduce_harmonics_below_the_nyquist_one() {
        for count in [1_usize, 2, 5, 8, 13, 16] {
            for step in 0..50 {
                let azimuth = 0.37 + 0.21 * f64::from(step);
                let w = weights(AzimuthRule::Trigonometric, count, 0.3, azimuth);
                for order in 0..count.div_ceil(2) {
                    let k = order as f64;
                    let f = |phi: f64| (k * phi + 0.4).cos();
                    let node = |j: usize| 0.3 + TAU * j as f64 / count as f64;
                    let value: f64 = w.iter().enumerate().map(|(j, w)| w * f(node(j))).sum();
                    assert!((value - f(azimuth)).abs() < 1e-12, "N {count}, order {order}");
                }
            }
        }
    }

    #[test]
    fn identity_both_rules_return_the_nodes_and_sum_to_one() {
        for rule in [AzimuthRule::Trigonometric, AzimuthRule::Linear] {
            for count in [1_usize, 2, 13] {
                for node in 0..3 * count {
                    let azimuth = 0.3 + TAU * node as f64 / count as f64;
                    let w = weights(rule, count, 0.3, azimuth);
                    assert!((w[node % count] - 1.0).abs() < 1e-12, "{rule:?} {count} {node}");
                    let between: f64 = weights(rule, count, 0.3, azimuth + 0.1).iter().sum();
                    assert!((between - 1.0).abs() < 1e-12);
                }
            }
        }
    }
}
