//! Recent past of a run: the last turn of the shaft and the samples behind the spectra.

use super::overview::Overview;
use crate::RecordError;
use crate::timeline::timestamp;
use crate::wire::tribodyn::{Orbit, Spectrum};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::f64::consts::TAU;
use tribodyn_dynamics::Sample;
use tribodyn_signal::{BearingFrequencies, Decimator, Window};

/// Most points of an orbit: a shaft that hardly turns would else fill the memory.
pub(super) const ORBIT_POINTS: usize = 4096;
/// Most samples behind a spectrum: 6 Hz between lines at 25.6 kHz.
pub(super) const SPECTRUM_SAMPLES: usize = 4096;
/// Fewest samples behind a spectrum.
const LEAST_SPECTRUM_SAMPLES: usize = 256;

/// The path of the inner ring over the last turn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct LastTurn {
    /// Angle turned (rad), x and y (µm).
    points: VecDeque<[f64; 3]>,
}

impl LastTurn {
    /// Number of points.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// All numbers.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.points.iter().flatten().copied()
    }

    pub(crate) fn push(&mut self, sample: &Sample) {
        // Where only the outer ring turns, its turns count.
        let angle = sample.inner.angle_rad.abs().max(sample.outer.angle_rad.abs());
        let [x, y, _] = sample.inner.displacement_m;
        self.points.push_back([angle, x * 1e6, y * 1e6]);
        while self.points.len() > ORBIT_POINTS || self.points.get(1).is_some_and(|second| angle - second[0] >= TAU) {
            self.points.pop_front();
        }
    }

    /// The path up to now.
    pub(crate) fn message(&self, time_s: f64, log_time: u64) -> Orbit {
        Orbit {
            timestamp: Some(timestamp(log_time)),
            time_s,
            x_um: self.points.iter().map(|p| p[1] as f32).collect(),
            y_um: self.points.iter().map(|p| p[2] as f32).collect(),
        }
    }
}

/// A quantity with a spectrum: its name, its unit, and where it is in a sample.
pub(crate) type Quantity = (&'static str, &'static str, fn(&Sample) -> f64);

/// The quantities with spectra, in the order of their topics.
pub(crate) const QUANTITIES: [Quantity; 3] = [
    ("acceleration of the outer ring along X", "m/s²", |s| s.outer.acceleration_m_s2[0]),
    ("acceleration of the inner ring along X", "m/s²", |s| s.inner.acceleration_m_s2[0]),
    ("speed of the cage", "r/min", |s| s.cage.speed_filtered_rad_s * 60.0 / TAU),
];

/// The speeds by which characteristic frequencies are found: mean orbital speed and mean angular velocity of the balls,
/// speeds of the rings, rad/s.
const SPEEDS: [fn(&Overview) -> f64; 4] = [
    |o| o.orbital_speed_rad_s,
    |o| {
        let speed = |omega: &[f64; 3]| omega.iter().map(|w| w * w).sum::<f64>().sqrt();
        o.angular_velocities_rad_s.iter().map(speed).sum::<f64>() / o.angular_velocities_rad_s.len() as f64
    },
    |o| o.sample.inner.speed_rad_s,
    |o| o.sample.outer.speed_rad_s,
];

/// Multiples of a characteristic frequency that are marked.
const MARKED: usize = 3;

/// The recent samples of the quantities with spectra.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Recent {
    times: VecDeque<f64>,
    values: [VecDeque<f64>; QUANTITIES.len()],
    speeds: [VecDeque<f64>; SPEEDS.len()],
}

impl Recent {
    /// Number of times.
    pub(super) fn times(&self) -> usize {
        self.times.len()
    }

    /// Lengths of all series.
    pub(super) fn sizes(&self) -> [usize; 1 + QUANTITIES.len() + SPEEDS.len()] {
        let mut series = [&self.times].into_iter().chain(&self.values).chain(&self.speeds);
        std::array::from_fn(|_| series.next().map_or(0, VecDeque::len))
    }

    /// All numbers.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        [&self.times].into_iter().chain(&self.values).chain(&self.speeds).flatten().copied()
    }

    /// Samples behind a spectrum: the largest power of two that there is; 0 where they are too few.
    pub(super) fn spectrum_samples(&self) -> usize {
        let count = if self.times.is_empty() { 0 } else { 1 << self.times.len().ilog2() };
        if count < LEAST_SPECTRUM_SAMPLES { 0 } else { count }
    }

    pub(crate) fn push(&mut self, overview: &Overview) {
        let sample = &overview.sample;
        // Two samples of one time, at an event for instance, are one of an even series.
        if self.times.back().is_some_and(|&last| sample.time_s <= last) {
            return;
        }
        self.times.push_back(sample.time_s);
        for (values, (_, _, get)) in self.values.iter_mut().zip(QUANTITIES) {
            values.push_back(get(sample));
        }
        for (values, get) in self.speeds.iter_mut().zip(SPEEDS) {
            values.push_back(get(overview));
        }
        if self.times.len() > SPECTRUM_SAMPLES {
            self.times.pop_front();
            self.values.iter_mut().chain(&mut self.speeds).for_each(|values| {
                values.pop_front();
            });
        }
    }

    /// Spectrum of one of [`QUANTITIES`] over the largest power of two of samples, up to the end of the filter's pass
    /// band; none where there are too few samples or their times are not even.
    pub(crate) fn spectrum(
        &self,
        quantity: usize,
        balls: usize,
        log_time: u64,
    ) -> Result<Option<Spectrum>, RecordError> {
        let count = self.spectrum_samples();
        let first = self.times.len() - count;
        let (Some(&start), Some(&end)) = (self.times.get(first), self.times.back()) else { return Ok(None) };
        let step = (end - start) / (count - 1) as f64;
        let even = |(i, &t): (usize, &f64)| (t - start - step * i as f64).abs() < 0.01 * step;
        if !self.times.range(first..).enumerate().all(even) {
            return Ok(None);
        }
        let samples: Vec<f64> = self.values[quantity].range(first..).copied().collect();
        let spectrum = tribodyn_signal::Spectrum::of(&samples, 1.0 / step, Window::Hann)?;
        let passed = spectrum.frequency_hz.partition_point(|hz| *hz <= Decimator::PASS_BAND / step);
        let narrow = |values: &[f64]| values[..passed].iter().map(|&v| v as f32).collect();
        let (name, unit, _) = QUANTITIES[quantity];
        let mean = |i: usize| self.speeds[i].range(first..).sum::<f64>() / count as f64;
        let f = BearingFrequencies::from_run(mean(0), mean(1), mean(2), mean(3), balls)?;
        let highest = spectrum.amplitude[..passed].iter().copied().fold(0.0, f64::max);
        let marks = |frequency: f64| marks(passed, frequency / spectrum.line_spacing_hz(), highest);
        Ok(Some(Spectrum {
            ftf_hz: f.cage_hz,
            bsf_hz: f.ball_spin_hz,
            bpfo_hz: f.ball_pass_outer_hz,
            bpfi_hz: f.ball_pass_inner_hz,
            mark_ftf: marks(f.cage_hz),
            mark_bsf: marks(f.ball_spin_hz),
            mark_bpfo: marks(f.ball_pass_outer_hz),
            mark_bpfi: marks(f.ball_pass_inner_hz),
            timestamp: Some(timestamp(log_time)),
            time_s: end,
            quantity: name.into(),
            unit: unit.into(),
            frequency_hz: narrow(&spectrum.frequency_hz),
            amplitude: narrow(&spectrum.amplitude),
        }))
    }
}

/// Depth of a mark under the axis over the highest amplitude. It hangs below, so that nobody takes it for an amplitude.
const MARK: f64 = 0.12;

/// Marks at a frequency, in lines, and its multiples: below the axis, a half and a third as deep at the multiples.
fn marks(lines: usize, frequency: f64, highest: f64) -> Vec<f32> {
    let mut values = vec![0.0; lines];
    for multiple in 1..=MARKED {
        let line = (multiple as f64 * frequency).round() as usize;
        // A cage at a standstill has no frequency to mark.
        if line > 0 && line < lines {
            values[line] = (-MARK * highest / multiple as f64) as f32;
        }
    }
    values
}
