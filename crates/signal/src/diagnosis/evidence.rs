//! Evidence for each fault: its harmonics and their sidebands in the envelope spectra of several bands.

use super::bands::{Band, Lines, SquaredEnvelope};
use super::lines::{FlooredLines, Found};
use super::shaft::ShaftSpeed;
use super::{Kinematics, Search, Shaft};
use crate::bearing::BearingFrequencies;
use crate::error::SignalError;
use crate::order::resample_by_angle;
use serde::Serialize;

/// A part of the bearing that may be damaged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// Outer race: BPFO.
    Outer,
    /// Inner race: BPFI, with sidebands at the speed of the shaft where the load is radial.
    Inner,
    /// A ball: twice BSF, with sidebands at the speed of the cage.
    Ball,
    /// The cage, or one ball unlike the others: FTF alone.
    Cage,
}

impl Fault {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Outer, Self::Inner, Self::Ball, Self::Cage];

    /// Name of the line by which it shows.
    pub fn line(self) -> &'static str {
        match self {
            Self::Outer => "BPFO",
            Self::Inner => "BPFI",
            Self::Ball => "2 BSF",
            Self::Cage => "FTF",
        }
    }
}

/// Decadic logarithm of the chance below which a family is taken for real.
pub(super) const SURE: f64 = -8.0;

/// Spectral kurtosis from which a band is impulsive.
const IMPULSIVE: f64 = 1.0;

/// A harmonic of a characteristic frequency in the envelope spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Harmonic {
    /// Multiple of the fundamental.
    pub order: usize,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Height over the noise floor, dB.
    pub over_floor_db: f64,
    /// Amplitude over the mean of the squared envelope, the floor taken off: 2 for a train of short impacts alone.
    pub modulation: f64,
}

/// A line beside a harmonic.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Sideband {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Height over the noise floor, dB.
    pub over_floor_db: f64,
}

/// Evidence for one fault.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Evidence {
    /// The fault.
    pub fault: Fault,
    /// Frequency of pure rolling at the speed of the shaft, Hz.
    pub expected_hz: f64,
    /// Frequency of the family that stands highest near it, Hz.
    pub frequency_hz: f64,
    /// One standard deviation of it, Hz.
    pub deviation_hz: f64,
    /// Decadic logarithm of the chance that noise stands as high in any of the bands.
    pub log_chance: f64,
    /// Root of the sum of the squares of the modulations of the harmonics.
    pub modulation: f64,
    /// Harmonics of the family, from 1.
    pub harmonics: Vec<Harmonic>,
    /// Lines at the distance of the modulating speed beside the first two harmonics: that of the shaft for the inner
    /// race, that of the cage for a ball; none for the others.
    pub sidebands: Vec<Sideband>,
    /// That speed, Hz.
    pub modulating_hz: Option<f64>,
    /// Decadic logarithm of the chance of these in noise; absent without sidebands.
    pub sidebands_log_chance: Option<f64>,
    /// Lower and upper edge of the band, Hz.
    pub band_hz: [f64; 2],
    /// True if the band was cut from the whitened signal.
    pub whitened: bool,
    /// Spectral kurtosis of the band.
    pub kurtosis: f64,
    /// Height of the blows in the highest band that shows them, in the unit of the samples: what its envelope exceeds
    /// for a hundredth of the time.
    pub height: f64,
    /// Least spectral kurtosis of a band whose envelope varies that much because something strikes.
    pub kurtosis_of_blows: f64,
    /// Mean height of the lines one turn of the cage below and above the fundamental, dB.
    #[serde(skip)]
    pub(super) beside_db: f64,
    /// The candidate among those seen.
    #[serde(skip)]
    pub(super) candidate: usize,
}

/// Root of the sum of the squares of the modulations of a family.
fn modulation(found: &Found) -> f64 {
    found.lines.iter().map(|l| l.amplitude.powi(2)).sum::<f64>().sqrt()
}

/// A band that is demodulated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Candidate {
    pub band: Band,
    pub whitened: bool,
}

/// Bands of highest kurtosis that are looked at in the plain signal and in the whitened one; besides, all of each.
const HIGHEST: [usize; 2] = [3, 2];

/// The bands that are demodulated: the highest of both kurtograms that do not repeat each other, and all of the signal.
pub(super) fn candidates(raw: &[Band], white: &[Band]) -> Vec<Candidate> {
    let mut all = Vec::new();
    for (bands, whitened, count) in [(raw, false, HIGHEST[0]), (white, true, HIGHEST[1])] {
        let mut by_height: Vec<&Band> = bands.iter().collect();
        by_height.sort_by(|a, b| b.kurtosis.total_cmp(&a.kurtosis));
        let mut chosen: Vec<Band> = Vec::new();
        for band in by_height {
            if chosen.len() == count {
                break;
            }
            if chosen.iter().all(|other| overlap(band, other) < 0.5) {
                chosen.push(*band);
            }
        }
        chosen.extend(bands.first().filter(|whole| !chosen.contains(whole)));
        all.extend(chosen.into_iter().map(|band| Candidate { band, whitened }));
    }
    all
}

/// Common width over that of both bands together.
fn overlap(a: &Band, b: &Band) -> f64 {
    let common = a.high_hz.min(b.high_hz) - a.low_hz.max(b.low_hz);
    common.max(0.0) / (a.high_hz.max(b.high_hz) - a.low_hz.min(b.low_hz))
}

/// Standard deviation of a line of impacts that slip by a per cent each, in distances of lines: between the mean rate
/// of a record of some hundred impacts and the peak of its spectrum. Slips add up, and move all harmonics alike.
const OF_SLIP: f64 = 0.15;
/// Turns of the shaft in a segment: enough to tell 0.02 orders apart, few enough for a speed that drifts by some per
/// mille.
pub(super) const SEGMENT_TURNS: f64 = 120.0;

/// Length of a segment, s.
pub(super) fn segment_s(shaft_hz: f64) -> f64 {
    SEGMENT_TURNS / shaft_hz
}

/// Envelopes of the candidates and their lines.
pub(super) struct Envelopes<'a> {
    raw: &'a Lines,
    white: &'a Lines,
    shaft: Shaft<'a>,
    mean_hz: f64,
    duration_s: f64,
    candidates: Vec<Candidate>,
    lines: Vec<FlooredLines>,
}

impl<'a> Envelopes<'a> {
    pub fn new(
        raw: &'a Lines,
        white: &'a Lines,
        candidates: Vec<Candidate>,
        shaft: Shaft<'a>,
        speed: &ShaftSpeed,
        highest_hz: f64,
    ) -> Result<Self, SignalError> {
        let (mean_hz, duration_s) = (speed.frequency_hz, raw.duration_s());
        let mut envelopes = Self { raw, white, shaft, mean_hz, duration_s, candidates, lines: Vec::new() };
        for index in 0..envelopes.candidates.len() {
            let (_, envelope) = envelopes.envelope(index)?;
            let up_to = 5.5 * highest_hz;
            let floor_hz = 0.4 * speed.frequency_hz;
            let segment = segment_s(speed.frequency_hz);
            let mut lines = FlooredLines::of(&envelope.values, envelope.rate_hz, segment, up_to, floor_hz)?;
            lines.mask(speed.frequency_hz, speed.deviation_hz);
            envelopes.lines.push(lines);
        }
        Ok(envelopes)
    }

    /// The band of highest kurtosis.
    pub fn widest_kurtosis(&self) -> usize {
        0
    }

    /// Squared envelope of a candidate, over shaft angle where that is known.
    pub fn envelope(&self, index: usize) -> Result<(Candidate, SquaredEnvelope), SignalError> {
        let candidate = self.candidates[index];
        let lines = if candidate.whitened { self.white } else { self.raw };
        let mut envelope = lines.squared_envelope([candidate.band.low_hz, candidate.band.high_hz]);
        if let Shaft::At(speeds) = self.shaft {
            let step = 2.0 * self.raw.nyquist_hz() / envelope.rate_hz;
            let speed = |k: usize| {
                let place = (envelope.first as f64 + k as f64 * step).min((speeds.len() - 1) as f64);
                let (low, part) = (place as usize, place.fract());
                speeds[low] + part * (speeds[(low + 1).min(speeds.len() - 1)] - speeds[low])
            };
            let along: Vec<f64> = (0..envelope.values.len()).map(speed).collect();
            let turned = resample_by_angle(&envelope.values, envelope.rate_hz, &along, None)?;
            envelope = SquaredEnvelope {
                values: turned.values,
                rate_hz: turned.samples_per_turn as f64 * self.mean_hz,
                ..envelope
            };
        }
        let mean = envelope.values.iter().sum::<f64>() / envelope.values.len() as f64;
        if mean > 0.0 {
            envelope.values.iter_mut().for_each(|x| *x /= mean);
        }
        Ok((candidate, envelope))
    }

    /// Distance between the lines of a band, Hz.
    pub fn spacing_hz(&self, index: usize) -> f64 {
        self.lines[index].spacing_hz
    }

    /// Evidence for each fault in the band where it is strongest.
    pub fn evidence(
        &self,
        bearing: &Kinematics,
        per_turn: &BearingFrequencies,
        speed: &ShaftSpeed,
        search: Search,
    ) -> Vec<Evidence> {
        let expected = |fault: Fault| match fault {
            Fault::Outer => per_turn.ball_pass_outer_hz,
            Fault::Inner => per_turn.ball_pass_inner_hz,
            Fault::Ball => per_turn.ball_defect_hz,
            Fault::Cage => per_turn.cage_hz,
        };
        // Where the speed was not found its whole range is searched.
        let of_speed = if speed.measured { 3.0 * speed.deviation_hz / speed.frequency_hz } else { search.speed };
        let cage = (bearing.cage_turns() - bearing.outer_turns).abs();
        let of_slip = |fault: Fault| match fault {
            Fault::Outer | Fault::Cage => search.slip,
            Fault::Inner => search.slip * cage * bearing.ball_count as f64 / per_turn.ball_pass_inner_hz,
            // 1 − γ² with γ = 1 − 2 f_c/f_s for an outer ring at rest.
            Fault::Ball => search.slip * 4.0 * cage * (1.0 - 2.0 * cage).abs() / (4.0 * cage * (1.0 - cage)) + 0.003,
        };
        Fault::ALL
            .into_iter()
            .filter_map(|fault| {
                let expected_hz = expected(fault) * speed.frequency_hz;
                let reach = of_slip(fault) + of_speed;
                let range = [expected_hz * (1.0 - reach), expected_hz * (1.0 + reach)];
                let trials = self.lines.len() as f64;
                let found = self.lines.iter().map(|lines| lines.family(range, trials)).enumerate();
                let best: Vec<(usize, Found)> = found.filter_map(|(k, found)| Some((k, found?))).collect();
                let least = |of: &dyn Fn(usize, &Found) -> bool| {
                    let fits = best.iter().filter(|(k, found)| of(*k, found));
                    fits.min_by(|a, b| a.1.log_chance.total_cmp(&b.1.log_chance))
                };
                // A band that tones fill says less than one in which something strikes.
                let strikes = |k: usize, found: &Found| {
                    found.log_chance < SURE
                        && self.candidates[k].band.kurtosis >= self.kurtosis_of_blows(fault, k, found)
                };
                let tall = best.iter().filter(|(k, found)| strikes(*k, found)).map(|(k, _)| self.height(*k));
                let tall = tall.fold(0.0, f64::max);
                let (candidate, found) = least(&strikes).or_else(|| least(&|_, _| true))?;
                let candidate = *candidate;
                let modulating = match fault {
                    Fault::Inner => Some(speed.frequency_hz),
                    Fault::Ball => Some(per_turn.cage_hz * speed.frequency_hz),
                    _ => None,
                };
                let cage_hz = per_turn.cage_hz * speed.frequency_hz;
                let mut one = self.one(fault, expected_hz, candidate, found, modulating);
                let (_, near) = self.lines[candidate].at(&[one.frequency_hz - cage_hz, one.frequency_hz + cage_hz]);
                let heights = near.iter().map(|(_, over)| 10.0 * over.max(1e-12).log10()).sum::<f64>();
                one.beside_db = heights / near.len().max(1) as f64;
                one.height = one.height.max(tall);
                Some(one)
            })
            .collect()
    }

    /// Height of the blows in the band of a candidate, in the unit of the samples.
    fn height(&self, candidate: usize) -> f64 {
        let band = self.candidates[candidate].band;
        self.raw.height([band.low_hz, band.high_hz])
    }

    /// Least spectral kurtosis of a band whose squared envelope has these lines because something strikes or noise
    /// swells: at half the kurtosis Σ m² of noise that swells as slowly, less two standard deviations of noise. Tones
    /// that beat, as those of waves of the races do, give the same lines with ½ Σ m² − 1 and more tones at most 0.
    /// Balls pass the waves of a race at the rate at which they pass its damage, so that there the band has to be
    /// impulsive besides.
    fn kurtosis_of_blows(&self, fault: Fault, candidate: usize, found: &Found) -> f64 {
        let band = self.candidates[candidate].band;
        let samples = (band.high_hz - band.low_hz) * self.duration_s;
        let least = 0.5 * modulation(found).powi(2) - 2.0 * 2.0 / samples.sqrt();
        if matches!(fault, Fault::Outer | Fault::Inner) { least.max(IMPULSIVE) } else { least }
    }

    fn one(&self, fault: Fault, expected_hz: f64, candidate: usize, found: &Found, beside: Option<f64>) -> Evidence {
        let lines = &self.lines[candidate];
        let db = |over: f64| 10.0 * over.max(1e-12).log10();
        let harmonic = |l: &super::lines::FoundLine| Harmonic {
            order: l.order,
            frequency_hz: l.frequency_hz,
            over_floor_db: db(l.over_floor),
            modulation: l.amplitude,
        };
        let harmonics: Vec<Harmonic> = found.lines.iter().map(harmonic).collect();
        let sides = beside.map(|by| {
            let f = found.frequency_hz;
            lines.at(&[f - by, f + by, 2.0 * f - by, 2.0 * f + by])
        });
        let (sidebands_log_chance, sidebands) = sides.map_or((None, Vec::new()), |(chance, sides)| {
            let side = |(hz, over): (f64, f64)| Sideband { frequency_hz: hz, over_floor_db: db(over) };
            (Some(chance), sides.into_iter().map(side).collect())
        });
        let Candidate { band, whitened } = self.candidates[candidate];
        Evidence {
            fault,
            expected_hz,
            frequency_hz: found.frequency_hz,
            deviation_hz: found.deviation_hz + OF_SLIP * lines.spacing_hz / lines.averages.sqrt(),
            log_chance: found.log_chance,
            modulation: modulation(found),
            harmonics,
            sidebands,
            modulating_hz: beside,
            sidebands_log_chance,
            band_hz: [band.low_hz, band.high_hz],
            whitened,
            kurtosis: band.kurtosis,
            height: self.height(candidate),
            kurtosis_of_blows: self.kurtosis_of_blows(fault, candidate, found),
            beside_db: 0.0,
            candidate,
        }
    }
}
