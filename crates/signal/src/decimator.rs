//! A streaming low-pass filter that keeps every n-th sample: what a measuring chain does before it digitises.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use crate::error::SignalError;
use crate::window::sinc;

/// Low-pass filter of linear phase with decimation, for quantities known by their means over short intervals.
///
/// ```text
/// y_m = Σ_j g((j − ½)/n − m + D) x_j,   x_j = n f_s ∫ x dt over internal interval j,   |u| < D
/// g(u) = w(u/D) (2/n) ∫ cos(2πfu)/sinc(f/n) df from 0 to f_c,   w(v) = I_0(β √(1 − v²))/I_0(β)
/// ```
///
/// Frequencies f are over the output rate f_s, n is the factor, f_c the middle of the transition. Means over intervals
/// of an acceleration are differences of the velocity, so that a solver has them without an evaluation of forces. They
/// are lower than the values by sinc(f/n), which the filter gives back, and what folds at the internal rate is lowered
/// by that: into the pass band at most by f/n, −80 dB from n = 4096 on whatever the spectrum.
///
/// Window: J. F. Kaiser, "Nonrecursive digital filter design using the I0-sinh window function", Proc. IEEE ISCAS 1974,
/// 20.
#[derive(Debug, Clone, PartialEq)]
pub struct Decimator {
    factor: usize,
    /// Weights by the place of an input in its output interval, then by the outputs that it goes into, twice: from any
    /// place on there are those of all outputs.
    taps: Vec<[f64; 2 * SPAN]>,
}

/// The outputs that are not complete yet: all that a filter remembers.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DecimatorMemory {
    /// Inputs since the last output.
    phase: usize,
    /// Place of the next output among the sums.
    head: usize,
    /// Sums of one channel after the other, each of all outputs in reach.
    sums: Vec<f64>,
}

impl DecimatorMemory {
    /// The sums.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        self.sums.iter().copied()
    }
}

/// Output intervals over which the filter reaches.
const SPAN: usize = 2 * Decimator::DELAY;
/// Attenuation that the window is made for, dB: ten more than what is promised.
const ATTENUATION_DB: f64 = 90.0;
/// Five-point Gauss–Legendre rule from −1 to 1: places and weights.
const GAUSS: [(f64, f64); 5] = [
    (0.0, 128.0 / 225.0),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];
/// Panels of that rule: less than a turn of the cosine in each, so that it errs by some 1e-6.
const PANELS: usize = 16;

impl Decimator {
    /// End of the pass band over the output rate: that of measuring chains, 1/2.56.
    pub const PASS_BAND: f64 = 0.39;
    /// Begin of the stop band over the output rate: nothing is left there that could fold.
    pub const STOP_BAND: f64 = 0.5;
    /// Group delay in output intervals: half of the length that Kaiser's rule asks for.
    pub const DELAY: usize = 26;
    /// Least attenuation in the stop band, dB.
    pub const STOP_ATTENUATION_DB: f64 = 80.0;

    /// The filter for so many inputs to an output.
    ///
    /// # Errors
    ///
    /// A factor of 0.
    pub fn new(factor: usize) -> Result<Self, SignalError> {
        if factor == 0 {
            return Err(SignalError::Setting { name: "decimation factor", value: 0.0 });
        }
        let nodes = nodes(factor);
        let of = |phase: usize| std::array::from_fn(|output| kernel(&nodes, place(factor, phase, output)));
        // The second half mirrors the first.
        let mut taps: Vec<[f64; SPAN]> = (0..factor.div_ceil(2)).map(of).collect();
        for phase in (0..factor / 2).rev() {
            let mut mirrored = taps[phase];
            mirrored.reverse();
            taps.push(mirrored);
        }
        let sum: f64 = taps.iter().flatten().sum();
        taps.iter_mut().flatten().for_each(|tap| *tap /= sum);
        let twice = |taps: [f64; SPAN]| std::array::from_fn(|output| taps[output % SPAN]);
        Ok(Self { factor, taps: taps.into_iter().map(twice).collect() })
    }

    /// Inputs to an output.
    pub fn factor(&self) -> usize {
        self.factor
    }

    /// The memory of a filter that has had these values, one for each channel, for ever.
    pub fn settled<const C: usize>(&self, values: [f64; C]) -> DecimatorMemory {
        let mut sums = vec![0.0; SPAN * C];
        let mut share = 0.0;
        for output in (0..SPAN).rev() {
            values.iter().enumerate().for_each(|(channel, value)| sums[channel * SPAN + output] = share * value);
            share += self.taps.iter().map(|taps| taps[output]).sum::<f64>();
        }
        DecimatorMemory { phase: 0, head: 0, sums }
    }

    /// True if a memory is one of this filter with `channels` channels.
    pub fn remembers(&self, memory: &DecimatorMemory, channels: usize) -> bool {
        memory.phase < self.factor && memory.head < SPAN && memory.sums.len() == SPAN * channels
    }

    /// Takes the means of one internal interval; returns an output with the last one of each output interval.
    ///
    /// The memory must be one of this filter ([`Self::remembers`]) with `C` channels.
    #[inline(always)] // with the vector instructions of the caller
    pub fn push<const C: usize>(&self, memory: &mut DecimatorMemory, values: [f64; C]) -> Option<[f64; C]> {
        let (head, sums) = (memory.head, memory.sums.as_chunks_mut::<SPAN>().0);
        let taps = &self.taps[memory.phase][SPAN - head..][..SPAN];
        for (sums, value) in sums.iter_mut().zip(values) {
            sums.iter_mut().zip(taps).for_each(|(sum, tap)| *sum += tap * value);
        }
        memory.phase += 1;
        if memory.phase < self.factor {
            return None;
        }
        memory.phase = 0;
        memory.head = (head + 1) % SPAN;
        let mut output = [0.0; C];
        output.iter_mut().zip(sums).for_each(|(output, sums)| *output = std::mem::take(&mut sums[head]));
        Some(output)
    }

    /// Gain at a frequency over the output rate, the mean over the internal intervals included; the phase is that of
    /// the delay.
    pub fn gain(&self, frequency: f64) -> f64 {
        let of = |(phase, taps): (usize, &[f64; 2 * SPAN])| {
            let term = |(output, tap): (usize, &f64)| tap * (TAU * frequency * place(self.factor, phase, output)).cos();
            taps[..SPAN].iter().enumerate().map(term).sum::<f64>()
        };
        sinc(frequency / self.factor as f64) * self.taps.iter().enumerate().map(of).sum::<f64>()
    }
}

/// Distance of an input from the middle of the reach of an output, in output intervals.
fn place(factor: usize, phase: usize, output: usize) -> f64 {
    (Decimator::DELAY as f64 - 1.0 - output as f64) + (phase as f64 + 0.5) / factor as f64
}

/// Angular frequencies and weights of the integral over the band that the ideal filter passes.
fn nodes(factor: usize) -> Vec<(f64, f64)> {
    let end = 0.5 * (Decimator::PASS_BAND + Decimator::STOP_BAND);
    let half = 0.5 * end / PANELS as f64;
    let node = |panel: usize, (x, weight): (f64, f64)| {
        let f = half * (2.0 * panel as f64 + 1.0 + x);
        (TAU * f, half * weight / sinc(f / factor as f64))
    };
    (0..PANELS).flat_map(|panel| GAUSS.map(|point| node(panel, point))).collect()
}

/// Weight at a distance from the middle, up to a factor.
fn kernel(nodes: &[(f64, f64)], distance: f64) -> f64 {
    let ideal: f64 = nodes.iter().map(|(omega, weight)| weight * (omega * distance).cos()).sum();
    let v = distance / Decimator::DELAY as f64;
    let beta = 0.1102 * (ATTENUATION_DB - 8.7);
    ideal * bessel_i0(beta * (1.0 - v * v).max(0.0).sqrt())
}

/// Modified Bessel function of order 0, by its power series.
fn bessel_i0(x: f64) -> f64 {
    let (mut term, mut sum, mut k) = (1.0, 1.0, 1.0);
    while term > 1e-17 * sum {
        term *= (0.5 * x / k) * (0.5 * x / k);
        sum += term;
        k += 1.0;
    }
    sum
}
