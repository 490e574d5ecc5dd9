//! The measuring chain of a run: accelerations of the rings and the speed of the cage without what lies beyond the
//! reach of the samples. Contacts vibrate at 10 kHz and more, and sampled as they are they would fold into the
//! spectrum.
//!
//! Velocities at an internal rate cost no forces, and their differences are exact means of the accelerations between.

use crate::layout::Layout;
use fearless_simd::{Level, dispatch};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::Scheme;
use tribodyn_numerics::hermite;
use tribodyn_signal::{Decimator, DecimatorMemory};

/// Least internal rate of the Runge–Kutta methods, Hz: ten times and more above contact modes and their harmonics.
const INTERNAL_RATE: f64 = 409_600.0;
/// Most internal intervals of a sample: from there on means fold less than the filter leaves, whatever the spectrum.
const MOST: f64 = 4096.0;
/// Accelerations of inner (x, y, z) and outer ring (x, y), and the speed of the cage.
const CHANNELS: usize = 6;
/// Unknowns whose rates are filtered.
type Values = [f64; CHANNELS];

/// The filter of a run's accelerations of rings (`acceleration_m_s2`) and cage speed (`speed_filtered_rad_s`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilterBands {
    /// Samples, Hz.
    state_rate: f64,
    /// Internal intervals of a sample.
    factor: usize,
}

impl FilterBands {
    /// The filter of a run by a scheme, with samples at a rate in Hz.
    pub fn new(scheme: Scheme, state_rate: f64) -> Self {
        let intervals = match scheme {
            // Its velocities are known at the ends of the steps, which divide the interval of samples.
            Scheme::Fast { step } => steps_of_sample(step, state_rate),
            // Before its step is chosen: a run knows it, [`crate::Run::scheme`].
            Scheme::FastTo { .. } => 1.0,
            Scheme::RungeKutta4 { step: longest } | Scheme::DormandPrince { longest, .. } => {
                ((1.0 / longest).max(INTERNAL_RATE) / state_rate - 1e-9).ceil().max(2.0)
            }
        };
        Self { state_rate, factor: intervals.min(MOST) as usize }
    }

    /// Rate at which velocities are taken, Hz.
    pub fn internal_rate_hz(&self) -> f64 {
        self.state_rate * self.factor as f64
    }

    /// End of the pass band, Hz.
    pub fn pass_band_hz(&self) -> f64 {
        Decimator::PASS_BAND * self.state_rate
    }

    /// Begin of the stop band, Hz.
    pub fn stop_band_hz(&self) -> f64 {
        Decimator::STOP_BAND * self.state_rate
    }

    /// How long before the time of its sample a filtered value occurred, s: a whole number of samples.
    pub fn delay_s(&self) -> f64 {
        Decimator::DELAY as f64 / self.state_rate
    }
}

/// Steps of the fast scheme, at most `step` long, between two samples.
pub(super) fn steps_of_sample(step: f64, rate: f64) -> f64 {
    (1.0 / (rate * step) - 1e-9).ceil().max(1.0)
}

/// The filter with its internal clock.
#[derive(Debug, Clone)]
pub(super) struct Filter {
    /// The vector instructions of this processor.
    level: Level,
    decimator: Decimator,
    bands: FilterBands,
}

/// Memory of the filter between steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct FilterMemory {
    /// Internal times that have passed, time 0 included.
    passed: u64,
    /// Velocities and the angle of the cage at the last one.
    last: Values,
    sums: DecimatorMemory,
    /// The last output: accelerations (m/s²) and the speed of the cage (rad/s).
    output: Values,
}

impl Filter {
    pub fn new(bands: FilterBands) -> Result<Self, tribodyn_signal::SignalError> {
        Ok(Self { level: Level::new(), decimator: Decimator::new(bands.factor)?, bands })
    }

    /// The vector instructions of this processor.
    pub fn level(&self) -> Level {
        self.level
    }

    /// Rate at which velocities are taken, Hz.
    pub fn internal_rate_hz(&self) -> f64 {
        self.bands.internal_rate_hz()
    }

    /// Before the run nothing accelerated, and the cage turned as it does at the start.
    pub fn at_start(&self, l: Layout, state: &[f64]) -> FilterMemory {
        let output = [0.0, 0.0, 0.0, 0.0, 0.0, state[l.cage() + 1]];
        FilterMemory { passed: 1, last: values(l, |i| state[i]), sums: self.decimator.settled(output), output }
    }

    /// True if a memory is one of this filter.
    pub fn remembers(&self, memory: &FilterMemory) -> bool {
        self.decimator.remembers(&memory.sums, CHANNELS)
    }

    /// The next internal time, s, and whether a sample falls on it.
    pub fn next(&self, memory: &FilterMemory) -> (f64, bool) {
        let factor = self.bands.factor as u64;
        if memory.passed.is_multiple_of(factor) {
            return ((memory.passed / factor) as f64 / self.bands.state_rate, true);
        }
        (memory.passed as f64 / self.bands.internal_rate_hz(), false)
    }

    /// Takes the velocities and the angle of the cage at the next internal time.
    pub fn take(&self, memory: &mut FilterMemory, now: Values) {
        let rate = self.bands.internal_rate_hz();
        let means = std::array::from_fn(|k| rate * (now[k] - memory.last[k]));
        (memory.last, memory.passed) = (now, memory.passed + 1);
        let (decimator, sums) = (&self.decimator, &mut memory.sums);
        let output = dispatch!(self.level, _simd => decimator.push(sums, means));
        memory.output = output.unwrap_or(memory.output);
    }
}

impl FilterMemory {
    /// Internal times that have passed.
    pub fn passed(&self) -> u64 {
        self.passed
    }

    /// All numbers that are remembered.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.last.into_iter().chain(self.output).chain(self.sums.values())
    }

    /// Filtered accelerations of inner and outer ring, m/s².
    pub fn accelerations(&self) -> [[f64; 3]; 2] {
        let [ix, iy, iz, ox, oy, _] = self.output;
        [[ix, iy, iz], [ox, oy, 0.0]]
    }

    /// Filtered speed of the cage, rad/s.
    pub fn cage_speed(&self) -> f64 {
        self.output[5]
    }
}

/// A step from which values between its ends are taken.
pub(super) struct Between<'a> {
    /// State at both ends.
    pub state: [&'a [f64]; 2],
    /// Its derivatives over the step there; none of the fast scheme, whose mean accelerations hold over the step.
    pub slopes: Option<[&'a [f64]; 2]>,
    /// Length of the step, s.
    pub length: f64,
}

impl Between<'_> {
    /// An unknown at a part of the step.
    pub fn at(&self, s: f64, i: usize) -> f64 {
        let [a, b] = self.state.map(|y| y[i]);
        if is_end(s) {
            return b;
        }
        match self.slopes {
            Some(slopes) => hermite(s, [a, b], slopes.map(|dy| dy[i] * self.length)),
            None => a + s * (b - a),
        }
    }

    /// The values to be filtered, at a part of the step.
    pub fn values(&self, l: Layout, s: f64) -> Values {
        if is_end(s) { values(l, |i| self.state[1][i]) } else { values(l, |i| self.at(s, i)) }
    }
}

/// True for the end of a step itself, which is met to the last digit.
fn is_end(s: f64) -> bool {
    (s - 1.0).abs() < 1e-9
}

fn values(l: Layout, get: impl Fn(usize) -> f64) -> Values {
    let (i, o) = (l.inner() + 3, l.outer() + 2);
    [i, i + 1, i + 2, o, o + 1, l.cage()].map(get)
}
