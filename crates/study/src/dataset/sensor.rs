//! A sensor on the acceleration of the outer ring.

use crate::ensemble::normal_quantile;
use std::f64::consts::PI;
use tribodyn_case::{SensorMode, SensorSpec};
use tribodyn_wear::Random;

/// A mode as a digital filter of second order, by the bilinear transform with its natural frequency kept.
#[derive(Debug, Clone, PartialEq)]
struct Mode {
    /// Of the last three inputs, gain included.
    b: [f64; 3],
    /// Of the last two outputs.
    a: [f64; 2],
    inputs: [f64; 2],
    outputs: [f64; 2],
}

impl Mode {
    fn new(mode: &SensorMode, rate: f64) -> Self {
        let w = (PI * mode.frequency / rate).tan();
        let scale = 1.0 / (1.0 + 2.0 * mode.damping * w + w * w);
        let gain = mode.gain * w * w * scale;
        Self {
            b: [gain, 2.0 * gain, gain],
            a: [2.0 * (w * w - 1.0) * scale, (1.0 - 2.0 * mode.damping * w + w * w) * scale],
            inputs: [0.0; 2],
            outputs: [0.0; 2],
        }
    }

    fn push(&mut self, input: f64) -> f64 {
        let output = self.b[0] * input + self.b[1] * self.inputs[0] + self.b[2] * self.inputs[1]
            - self.a[0] * self.outputs[0]
            - self.a[1] * self.outputs[1];
        self.inputs = [input, self.inputs[0]];
        self.outputs = [output, self.outputs[0]];
        output
    }
}

/// A sensor that is fed with accelerations sample by sample.
#[derive(Debug, Clone)]
pub(super) struct Sensor {
    direction: [f64; 2],
    direct: f64,
    modes: Vec<Mode>,
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
            noise: spec.noise,
            random,
        }
    }

    /// Its value for an acceleration x, y of the outer ring, m/s².
    pub fn push(&mut self, [x, y]: [f64; 2]) -> f64 {
        let along = self.direction[0] * x + self.direction[1] * y;
        let through: f64 = self.modes.iter_mut().map(|mode| mode.push(along)).sum();
        // Never 0, where a normal distribution has no quantile.
        let share = self.random.share().max(1e-17);
        self.direct * along + through + self.noise * normal_quantile(share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE: f64 = 25_600.0;

    fn sensor(modes: Vec<SensorMode>, noise: f64) -> Sensor {
        let spec = SensorSpec { name: "x".to_owned(), direction: 0.3, direct: 0.5, modes, noise };
        Sensor::new(&spec, RATE, Random::new(1, 2))
    }

    /// At rest direct part and gains add up; at its natural frequency a mode has gain/2ζ, a quarter of a period late.
    #[test]
    fn limit_a_mode_at_rest_and_at_its_frequency() {
        let mode = SensorMode { frequency: 3000.0, damping: 0.02, gain: 2.0 };
        let mut at_rest = sensor(vec![mode], 0.0);
        let along = 0.3f64.cos() * 3.0 + 0.3f64.sin() * 4.0;
        let last = (0..20_000).map(|_| at_rest.push([3.0, 4.0])).last().unwrap();
        assert!((last - 2.5 * along).abs() < 1e-9, "{last}");
        let mut swinging = Mode::new(&mode, RATE);
        let phase = |k: u32| 2.0 * PI * 3000.0 * f64::from(k) / RATE;
        let found: Vec<f64> = (0..20_000).map(|k| swinging.push(phase(k).cos())).collect();
        for k in 19_000..20_000 {
            assert!((found[k as usize] - 50.0 * phase(k).sin()).abs() < 1e-6, "{k}");
        }
    }

    #[test]
    fn limit_noise_has_its_level_and_no_mean() {
        let mut noisy = sensor(Vec::new(), 0.7);
        let found: Vec<f64> = (0..20_000).map(|_| noisy.push([0.0, 0.0])).collect();
        let mean = found.iter().sum::<f64>() / found.len() as f64;
        let square = found.iter().map(|v| v * v).sum::<f64>() / found.len() as f64;
        assert!(mean.abs() < 0.02 && (square.sqrt() / 0.7 - 1.0).abs() < 0.02, "{mean} {square}");
        assert!(noisy.random.share() != sensor(Vec::new(), 0.7).random.share());
    }
}
