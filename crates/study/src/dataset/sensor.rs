//! A sensor on the acceleration of the outer ring.

use crate::ensemble::normal_quantile;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use tribodyn_case::{SensorMode, SensorSpec};
use tribodyn_signal::Decimator;
use tribodyn_wear::Random;

/// Samples after the one that a value is of, from which it is made too: values come so many samples late.
pub(super) const AHEAD: usize = 4;
/// Samples before it.
const BEHIND: usize = 6;
const TAPS: usize = AHEAD + 1 + BEHIND;
/// Weights besides that of the sample itself.
const MOVED: usize = TAPS - 1;
/// End of the band, over the rate, in which a mode responds as it should: a little above what a run passes.
const FITTED: f64 = Decimator::PASS_BAND + 0.03;
/// Frequencies in that band.
const LINES: usize = 160;

/// A mode as a digital filter of second order: its poles are those of the mode, exp(pT), and its inputs are weighted so
/// that `gain ω₀²/(ω₀² − ω² + 2iζω₀ω)` holds at rest, and within 1 % up to the end of the pass band of a run for
/// dampings up to 0.1, within 3 % for all.
#[derive(Debug, Clone, PartialEq)]
struct Mode {
    /// Of the inputs from the latest back, gain included.
    weights: [f64; TAPS],
    /// Of the last two outputs.
    a: [f64; 2],
    outputs: [f64; 2],
}

impl Mode {
    fn new(mode: &SensorMode, rate: f64) -> Self {
        let (damping, speed) = (mode.damping, TAU * mode.frequency / rate);
        let decay = (-damping * speed).exp();
        let turn = speed * (1.0 - damping * damping).max(0.0).sqrt();
        let a = [-2.0 * decay * turn.cos(), decay * decay];
        Self { weights: weights(damping, speed, a).map(|weight| mode.gain * weight), a, outputs: [0.0; 2] }
    }

    fn push(&mut self, inputs: &[f64; TAPS]) -> f64 {
        let fed: f64 = self.weights.iter().zip(inputs).map(|(weight, input)| weight * input).sum();
        let output = fed - self.a[0] * self.outputs[0] - self.a[1] * self.outputs[1];
        self.outputs = [output, self.outputs[0]];
        output
    }
}

/// Weights with the least square of the relative error of the response over the fitted band, without error at rest, for
/// a damping, a natural frequency in radians a sample and weights of the outputs.
fn weights(damping: f64, speed: f64, [a1, a2]: [f64; 2]) -> [f64; TAPS] {
    let at_rest = 1.0 + a1 + a2;
    let (mut rows, mut wanted) = (Vec::with_capacity(2 * LINES), Vec::with_capacity(2 * LINES));
    for line in 0..LINES {
        let w = TAU * FITTED * (line as f64 + 0.5) / LINES as f64;
        // One over response and denominator: what a weight of one, that of the sample itself, adds to the response.
        let denominator = [1.0 + a1 * w.cos() + a2 * (2.0 * w).cos(), -a1 * w.sin() - a2 * (2.0 * w).sin()];
        let inverse = [1.0 - (w / speed).powi(2), 2.0 * damping * w / speed];
        let square = denominator[0].powi(2) + denominator[1].powi(2);
        let one = [
            (inverse[0] * denominator[0] + inverse[1] * denominator[1]) / square,
            (inverse[1] * denominator[0] - inverse[0] * denominator[1]) / square,
        ];
        // A weight is taken from the sample itself, so that their sum stays.
        let moved = |k: usize| {
            let place = if k < AHEAD { k } else { k + 1 };
            let (sin, cos) = (w * (AHEAD as f64 - place as f64)).sin_cos();
            let (re, im) = (cos - 1.0, sin);
            [one[0] * re - one[1] * im, one[0] * im + one[1] * re]
        };
        wanted.extend([1.0 - at_rest * one[0], -at_rest * one[1]]);
        let columns: [[f64; 2]; MOVED] = std::array::from_fn(moved);
        rows.extend([0, 1].map(|part| columns.map(|column| column[part])));
    }
    let design = DMatrix::from_row_slice(rows.len(), MOVED, rows.as_flattened());
    let least = design.norm() * f64::EPSILON;
    let Ok(moved) = design.svd(true, true).solve(&DVector::from(wanted), least) else {
        unreachable!("both sides of the decomposition are there")
    };
    let mut weights = [0.0; TAPS];
    weights[AHEAD] = at_rest - moved.sum();
    weights[..AHEAD].copy_from_slice(&moved.as_slice()[..AHEAD]);
    weights[AHEAD + 1..].copy_from_slice(&moved.as_slice()[AHEAD..]);
    weights
}

/// A sensor that is fed with accelerations sample by sample.
#[derive(Debug, Clone)]
pub(super) struct Sensor {
    direction: [f64; 2],
    direct: f64,
    modes: Vec<Mode>,
    /// Accelerations along it from the latest back.
    inputs: [f64; TAPS],
    noise: f64,
    random: Random,
}

impl Sensor {
    /// A sensor at a rate (Hz) with noise from a stream of random numbers.
    pub fn new(spec: &SensorSpec, rate: f64, random: Random) -> Self {
        let (sin, cos) = spec.direction.sin_cos();
        Self {
            direction: [cos, sin],
            direct: spec.direct,
            modes: spec.modes.iter().map(|mode| Mode::new(mode, rate)).collect(),
            inputs: [0.0; TAPS],
            noise: spec.noise,
            random,
        }
    }

    /// Takes an acceleration x, y of the outer ring, m/s²; the value is that of [`AHEAD`] samples before.
    pub fn push(&mut self, [x, y]: [f64; 2]) -> f64 {
        self.inputs.rotate_right(1);
        self.inputs[0] = self.direction[0] * x + self.direction[1] * y;
        let through: f64 = self.modes.iter_mut().map(|mode| mode.push(&self.inputs)).sum();
        // Never 0, where a normal distribution has no quantile.
        let share = self.random.share().max(1e-17);
        self.direct * self.inputs[AHEAD] + through + self.noise * normal_quantile(share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f64 = 25_600.0;

    fn sensor(direct: f64, modes: Vec<SensorMode>, noise: f64) -> Sensor {
        let spec = SensorSpec { name: "x".to_owned(), direction: 0.3, direct, modes, noise };
        Sensor::new(&spec, RATE, Random::new(1, 2))
    }

    /// At rest direct part and gains add up.
    #[test]
    fn limit_a_mode_at_rest() {
        let mode = SensorMode { frequency: 3000.0, damping: 0.02, gain: 2.0 };
        let mut at_rest = sensor(0.5, vec![mode], 0.0);
        let along = 0.3f64.cos() * 3.0 + 0.3f64.sin() * 4.0;
        let last = (0..20_000).map(|_| at_rest.push([3.0, 4.0])).last().unwrap();
        assert!((last - 2.5 * along).abs() < 1e-9, "{last}");
    }

    /// Height and phase from the lowest frequencies to the end of the pass band: gain ω₀²/(ω₀² − ω² + 2iζω₀ω).
    #[test]
    fn limit_a_mode_responds_as_its_equation_says() {
        for (frequency, damping, tolerance) in
            [(2000.0, 0.05, 0.002), (6100.0, 0.02, 0.002), (40.0, 0.02, 0.01), (9000.0, 0.5, 0.03)]
        {
            for tested in [37.0, 1990.0, 5000.0, 8000.0, 9984.0] {
                let mode = SensorMode { frequency, damping, gain: 0.5 };
                let mut sensor = sensor(0.0, vec![mode], 0.0);
                let phase = |k: f64| TAU * tested * k / RATE;
                let ratio = tested / frequency;
                let (re, im) = (1.0 - ratio * ratio, 2.0 * damping * ratio);
                let height = 0.5 / re.hypot(im);
                for k in 0..60_000 {
                    let value = sensor.push([phase(f64::from(k)).cos() / 0.3f64.cos(), 0.0]);
                    let expected = height * (phase(f64::from(k) - AHEAD as f64) - im.atan2(re)).cos();
                    assert!(k < 55_000 || (value - expected).abs() < tolerance * height, "{frequency} {tested}");
                }
            }
        }
    }

    #[test]
    fn limit_noise_has_its_level_and_no_mean() {
        let mut noisy = sensor(0.5, Vec::new(), 0.7);
        let found: Vec<f64> = (0..20_000).map(|_| noisy.push([0.0, 0.0])).collect();
        let mean = found.iter().sum::<f64>() / found.len() as f64;
        let square = found.iter().map(|v| v * v).sum::<f64>() / found.len() as f64;
        assert!(mean.abs() < 0.02 && (square.sqrt() / 0.7 - 1.0).abs() < 0.02, "{mean} {square}");
        assert!(noisy.random.share() != sensor(0.5, Vec::new(), 0.7).random.share());
    }
}
