//! Lines of a spectrum over their floor, and how surely a family of harmonics stands above it.

use crate::error::SignalError;
use crate::spectrum::amplitudes;
use crate::window::Window;

/// Powers of the lines of a signal, averaged over segments, with their floor.
pub(crate) struct FlooredLines {
    /// Distance between lines, Hz.
    pub spacing_hz: f64,
    /// Root mean square of the amplitude of each line, in the unit of the samples.
    pub amplitude: Vec<f64>,
    /// Power of each line over that of the noise around it: mean 1 where there is nothing but noise.
    pub over_floor: Vec<f64>,
    /// Independent segments that were averaged.
    pub averages: f64,
    /// Lines that are left out of families, as they belong to the shaft.
    pub masked: Vec<bool>,
}

/// A family of harmonics where it stands highest above the floor.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Found {
    /// Fundamental, Hz.
    pub frequency_hz: f64,
    /// One standard deviation of it, Hz.
    pub deviation_hz: f64,
    /// Decadic logarithm of the probability that noise stands as high anywhere in the range.
    pub log_chance: f64,
    /// Orders, frequencies and heights of the harmonics.
    pub lines: Vec<FoundLine>,
}

/// A line of a family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FoundLine {
    pub order: usize,
    pub frequency_hz: f64,
    /// Amplitude with the floor taken off, in the unit of the samples.
    pub amplitude: f64,
    pub over_floor: f64,
}

/// Half the width of the running median that gives the floor, lines.
const FLOOR_LINES: usize = 30;
/// The power of one line over the floor counts up to this: one line alone makes no family.
const MOST: f64 = 15.0;
/// Numbers of harmonics that are tried for a family.
const ORDERS: [usize; 4] = [1, 2, 3, 5];
/// Height over the floor from which a line is used to find a frequency: noise reaches it once in 1600 lines.
const USED: f64 = 7.4;

impl FlooredLines {
    /// The lines up to a frequency, from segments of about `segment_s` that overlap by half.
    pub fn of(
        samples: &[f64],
        rate_hz: f64,
        segment_s: f64,
        up_to_hz: f64,
        floor_hz: f64,
    ) -> Result<Self, SignalError> {
        let whole = samples.len();
        let length = ((segment_s * rate_hz) as usize).clamp(whole.min(16), whole);
        let mut power: Vec<f64> = Vec::new();
        let mut count = 0.0;
        for start in (0..=whole - length).step_by((length / 2).max(1)) {
            let (lines, _) = amplitudes(&samples[start..start + length], Window::Hann)?;
            power.resize(lines.len(), 0.0);
            power.iter_mut().zip(&lines).for_each(|(sum, line)| *sum += line * line);
            count += 1.0;
        }
        let spacing_hz = rate_hz / length as f64;
        power.truncate((up_to_hz / spacing_hz) as usize + 2 * FLOOR_LINES);
        power.iter_mut().for_each(|p| *p /= count);
        let averages = if count > 1.0 { (0.75 * count).max(1.0) } else { 1.0 };
        let floor = floors(&power, FLOOR_LINES.max((floor_hz / spacing_hz) as usize), averages);
        let over = |(p, floor): (&f64, &f64)| if *floor > 0.0 { p / floor } else { 1.0 };
        Ok(Self {
            spacing_hz,
            over_floor: power.iter().zip(&floor).map(over).collect(),
            masked: vec![false; power.len()],
            amplitude: power.into_iter().map(f64::sqrt).collect(),
            averages,
        })
    }

    /// Leaves out what lies on multiples of a frequency, each with the skirts of its line.
    pub fn mask(&mut self, frequency_hz: f64, deviation_hz: f64) {
        if frequency_hz < 8.0 * self.spacing_hz {
            return;
        }
        for order in 1.. {
            let place = order as f64 * frequency_hz / self.spacing_hz;
            let reach = 1.5 + (order as f64 * deviation_hz / self.spacing_hz).min(3.0);
            if place + reach + 1.0 > self.masked.len() as f64 {
                return;
            }
            let (mut low, mut high) = ((place - reach).ceil().max(1.0) as usize, (place + reach) as usize);
            let falls = |from: usize, to: usize| self.amplitude[to] < self.amplitude[from] && self.over_floor[to] > 2.0;
            while low > 1 && falls(low, low - 1) {
                low -= 1;
            }
            while high + 1 < self.masked.len() && falls(high, high + 1) {
                high += 1;
            }
            self.masked[low..=high].fill(true);
        }
    }

    /// Height over the floor at a place in lines; that of noise where the line is left out.
    fn height(&self, place: f64) -> f64 {
        let line = place.round() as usize;
        match (self.over_floor.get(line), self.masked.get(line)) {
            (Some(height), Some(false)) => *height,
            _ => 1.0,
        }
    }

    /// The family whose fundamental lies in a range and that stands highest above the floor; `trials` are other places
    /// at which it was looked for too.
    pub fn family(&self, [low_hz, high_hz]: [f64; 2], trials: f64) -> Option<Found> {
        let mut best: Option<(f64, f64, usize)> = None;
        for orders in ORDERS {
            if (orders as f64 * high_hz) / self.spacing_hz + 2.0 > self.over_floor.len() as f64 {
                break;
            }
            let step = 0.5 * self.spacing_hz / orders as f64;
            let steps = ((high_hz - low_hz) / step).ceil().max(1.0);
            let places = (0..=steps as usize).map(|k| (low_hz + step * k as f64) / self.spacing_hz);
            let sum = |place: f64| (1..=orders).map(|h| self.height(h as f64 * place).min(MOST)).sum::<f64>();
            let highest = places.map(|place| (sum(place), place)).max_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((sum, place)) = highest {
                let tried = (0.5 * steps).max(1.0) * trials * ORDERS.len() as f64;
                let chance = log_chance(self.averages * orders as f64, self.averages * sum) + tried.log10();
                if best.is_none_or(|(least, ..)| chance < least) {
                    best = Some((chance, place, orders));
                }
            }
        }
        let (log_chance, place, orders) = best?;
        Some(self.refined(log_chance.min(0.0), place, orders))
    }

    /// Frequencies of the lines between lines, and the fundamental that fits them best.
    fn refined(&self, log_chance: f64, place: f64, orders: usize) -> Found {
        let mut fundamental = place;
        let mut lines = Vec::new();
        let mut deviation = 0.5;
        // From the lowest harmonic up: each is looked for where those below it say.
        for order in 1..=ORDERS[ORDERS.len() - 1] {
            let Some((at, height)) = self.peak_near(order as f64 * fundamental) else { continue };
            lines.push((order, at, height));
            // What lies beyond the family may be another's: it is shown, but says nothing of the frequency.
            let used = || lines.iter().filter(|(order, _, height)| *height > USED && *order <= orders.max(3));
            let weight = |(order, _, height): &(usize, f64, f64)| (*order as f64).powi(2) * height.min(1e4);
            let total: f64 = used().map(weight).sum();
            if total > 0.0 {
                fundamental = used().map(|l| weight(l) * l.1 / l.0 as f64).sum::<f64>() / total;
                let scatter = used().map(|l| weight(l) * (l.1 / l.0 as f64 - fundamental).powi(2)).sum::<f64>() / total;
                // A line in noise is known to about 0.55/√(power over floor) of the distance between lines.
                let known = 0.55 / (total * self.averages).sqrt();
                deviation = (scatter / (used().count() as f64)).sqrt().max(known);
            }
        }
        let spacing = self.spacing_hz;
        let line = |(order, at, height): (usize, f64, f64)| FoundLine {
            order,
            frequency_hz: at * spacing,
            amplitude: self.amplitude_at(at) * (1.0 - 1.0 / height.max(1.0)).sqrt(),
            over_floor: height,
        };
        let lines = lines.into_iter().map(line).collect();
        Found { frequency_hz: fundamental * spacing, deviation_hz: deviation * spacing, log_chance, lines }
    }

    /// Place and height of the highest line within one line of a place, the place interpolated.
    pub fn peak_near(&self, place: f64) -> Option<(f64, f64)> {
        let middle = place.round() as usize;
        let line = (middle.max(2) - 1..=middle + 1)
            .max_by(|a, b| self.height(*a as f64).total_cmp(&self.height(*b as f64)))?;
        let height = *self.over_floor.get(line)?;
        let near = [line.checked_sub(1)?, line, line + 1].map(|k| self.amplitude.get(k).copied());
        let [Some(left), Some(top), Some(right)] = near else { return None };
        if self.masked[line] {
            return None;
        }
        let top_of_all = top >= left && top >= right && top > 0.0;
        Some((line as f64 + if top_of_all { Window::Hann.offset([left, top, right]) } else { 0.0 }, height))
    }

    fn amplitude_at(&self, place: f64) -> f64 {
        self.amplitude.get(place.round() as usize).copied().unwrap_or(0.0)
    }

    /// The chance that noise stands as high as the lines at some frequencies, as its decadic logarithm, and the lines.
    pub fn at(&self, frequencies_hz: &[f64]) -> (f64, Vec<(f64, f64)>) {
        let found: Vec<(f64, f64)> = frequencies_hz
            .iter()
            .filter(|hz| **hz > 2.0 * self.spacing_hz)
            .filter_map(|hz| self.peak_near(hz / self.spacing_hz))
            .map(|(place, height)| (place * self.spacing_hz, height))
            .collect();
        let sum: f64 = found.iter().map(|(_, height)| height.min(MOST)).sum();
        // The highest of three lines each, two of them independent under a Hann window.
        let tried = 2f64.powi(found.len() as i32);
        ((log_chance(self.averages * found.len() as f64, self.averages * sum) + tried.log10()).min(0.0), found)
    }
}

/// Running median of the powers over the lines around, as the mean of the noise: the median of averages of exponential
/// variables is `m (1 − 1/(9m))³`/m of their mean for m averages (Wilson, Hilferty).
fn floors(power: &[f64], half: usize, averages: f64) -> Vec<f64> {
    let to_mean = if averages > 1.5 { (1.0 - 1.0 / (9.0 * averages)).powi(3) } else { std::f64::consts::LN_2 };
    let median = |k: usize| {
        let mut around = power[k.saturating_sub(half).max(1.min(k))..(k + half + 1).min(power.len())].to_vec();
        let middle = around.len() / 2;
        *around.select_nth_unstable_by(middle, f64::total_cmp).1 / to_mean
    };
    // The median moves slowly: every few lines are enough.
    let stride = (half / 8).max(1);
    (0..power.len()).step_by(stride).flat_map(|k| std::iter::repeat_n(median(k), stride)).take(power.len()).collect()
}

/// Decadic logarithm of the chance that a sum of `count` exponential variables of mean 1 exceeds `sum`.
fn log_chance(count: f64, sum: f64) -> f64 {
    let (mut term, mut total) = (1.0, 1.0);
    for k in 1..(count.round() as usize).max(1) {
        term *= sum / k as f64;
        total += term;
    }
    -sum / std::f64::consts::LN_10 + f64::log10(total)
}
