//! Faults of a rolling bearing in a vibration signal: the band in which impacts ring, the spectrum of its envelope, the
//! characteristic lines in it and what they say.
//!
//! The order of the steps is that of R. B. Randall, J. Antoni, Mech. Syst. Signal Process. 25 (2011) 485,
//! doi:10.1016/j.ymssp.2010.07.017: trend off, tones and resonances whitened, band by spectral kurtosis, spectrum of
//! the squared envelope, over shaft angle where the speed is known at each sample. Speeds are known to some per cent
//! and balls slip, so that each line is looked for in a range and the chance that noise stands as high anywhere in that
//! range is what counts.

mod bands;
mod evidence;
mod lines;
mod shaft;
mod verdict;

pub(crate) use bands::faded;
pub use bands::{Band, kurtogram, whitened, without_trend};
pub use evidence::{Evidence, Fault, Harmonic, Sideband};
pub use shaft::ShaftSpeed;
pub use verdict::{CageSpeed, Verdict};

use bands::Lines;
use serde::Serialize;

use crate::bearing::BearingFrequencies;
use crate::error::{SignalError, check_rate, check_samples, check_setting};
use crate::spectrum::Spectrum;
use crate::window::Window;

/// The bearing that a signal is of, and how its rings turn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Kinematics {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter, m.
    pub ball_diameter_m: f64,
    /// Pitch diameter, m.
    pub pitch_diameter_m: f64,
    /// Contact angle, rad.
    pub contact_angle_rad: f64,
    /// Turns of the inner ring in one turn of the shaft: 1, and 0 where the outer ring turns with the shaft.
    pub inner_turns: f64,
    /// Turns of the outer ring in one turn of the shaft.
    pub outer_turns: f64,
}

impl Kinematics {
    /// Frequencies of pure rolling in one turn of the shaft each second: events per turn.
    ///
    /// # Errors
    ///
    /// A geometry that no bearing has, rings that turn alike.
    pub fn per_turn(&self) -> Result<BearingFrequencies, SignalError> {
        let turns = |share: f64| share * std::f64::consts::TAU;
        let frequencies = BearingFrequencies::from_geometry(
            self.ball_count,
            self.ball_diameter_m,
            self.pitch_diameter_m,
            self.contact_angle_rad,
            turns(self.inner_turns),
            turns(self.outer_turns),
        )?;
        check_setting("turns of the inner ring against the outer ring", frequencies.shaft_hz, false)?;
        Ok(frequencies)
    }

    /// Turns of the cage in one turn of the shaft, with their sign.
    pub(crate) fn cage_turns(&self) -> f64 {
        let gamma = self.ball_diameter_m * self.contact_angle_rad.cos() / self.pitch_diameter_m;
        0.5 * (self.inner_turns * (1.0 - gamma) + self.outer_turns * (1.0 + gamma))
    }
}

/// Speed of the shaft as it is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shaft<'a> {
    /// A speed about which the true one lies, Hz.
    Near(f64),
    /// The speed at each sample, rad/s: lines are then those over shaft angle.
    At(&'a [f64]),
}

/// How far lines may lie from where pure rolling at the given speed has them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Search {
    /// Uncertainty of the given shaft speed, relative.
    pub speed: f64,
    /// Slip of the balls and uncertainty of contact angle and pitch diameter, relative to the speed of the cage.
    pub slip: f64,
    /// Height of blows over the speed of the shaft, in the unit of the samples over Hz, up to which sound bearings have
    /// them too; 0 where the unit is not known.
    pub quiet: f64,
}

impl Default for Search {
    /// Induction motors slip by up to some per cent and their nominal speed is given; a few degrees of contact angle
    /// and slip move the cage by up to 2 %. Wider ranges let lines of the shaft and of other faults in.
    fn default() -> Self {
        Self { speed: 0.015, slip: 0.02, quiet: 0.0 }
    }
}

/// Diagnosis of a bearing from a vibration signal.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Diagnosis {
    /// Speed of the shaft.
    pub shaft: ShaftSpeed,
    /// True if the lines are those over shaft angle, frequencies then those at the mean speed.
    pub order_tracked: bool,
    /// Bands of the kurtogram, from wide to narrow.
    pub kurtogram: Vec<Band>,
    /// The band of the envelope spectrum below.
    pub band: Band,
    /// True if that band was cut from the whitened signal.
    pub whitened: bool,
    /// Evidence for each fault, in its best band.
    pub evidence: Vec<Evidence>,
    /// Speed of the cage by the lines that were found.
    pub cage: Option<CageSpeed>,
    /// The verdict with its reasons.
    pub verdict: Verdict,
    /// Spectrum of the squared envelope of the band, over the mean of the squared envelope.
    #[serde(skip)]
    pub envelope: Spectrum,
    /// Limitations of the answer.
    pub warnings: Vec<String>,
}

/// Evaluates a vibration signal.
///
/// # Errors
///
/// A signal of fewer than 64 samples or 8 turns of the shaft, that is constant or has a sample that is not finite; a
/// rate below what the lines of the bearing need; a speed that is not positive; those of [`Kinematics::per_turn`] and,
/// with the speed at each sample, of [`crate::resample_by_angle`].
pub fn diagnose(
    samples: &[f64],
    rate_hz: f64,
    shaft: Shaft,
    bearing: &Kinematics,
    search: Search,
) -> Result<Diagnosis, SignalError> {
    check_rate(rate_hz)?;
    check_samples(samples, 64)?;
    check_setting("uncertainty of the speed", search.speed, true)?;
    check_setting("slip", search.slip, true)?;
    check_setting("height of quiet blows", search.quiet, true)?;
    let per_turn = bearing.per_turn()?;
    let given_hz = shaft::given_hz(shaft, samples.len())?;
    let turns = given_hz * samples.len() as f64 / rate_hz;
    if turns < LEAST_TURNS {
        return Err(SignalError::FewTurns { turns, needed: LEAST_TURNS });
    }
    let highest_hz = given_hz * per_turn.ball_pass_inner_hz.max(per_turn.ball_defect_hz);
    if 4.0 * highest_hz > 0.5 * rate_hz {
        return Err(SignalError::SlowRate { rate_hz, needed_hz: 8.0 * highest_hz });
    }
    let mut warnings = clipped(samples).into_iter().collect::<Vec<_>>();
    let plain = without_trend(samples);
    let peak = plain.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let scale = samples.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if peak <= 1e-12 * scale {
        return Err(SignalError::Still);
    }
    let raw = Lines::of(&plain, rate_hz)?;
    let white = raw.whitened();
    let least_width = 3.0 * highest_hz;
    let kurtogram = bands::of_lines(&raw, least_width);
    let candidates = evidence::candidates(&kurtogram, &bands::of_lines(&white, least_width));
    let speed = shaft::found(&plain, rate_hz, shaft, search)?;
    let envelopes = evidence::Envelopes::new(&raw, &white, candidates, shaft, &speed, highest_hz)?;
    let evidence = envelopes.evidence(bearing, &per_turn, &speed, search);
    let is_short = turns < evidence::SEGMENT_TURNS;
    let of = |e: &Evidence| hidden(e, (speed.frequency_hz, is_short), envelopes.spacing_hz(e.candidate));
    warnings.extend(evidence.iter().filter_map(of));
    warnings.extend((!speed.measured).then(|| shaft::NOT_FOUND.to_owned()));
    let verdict = verdict::of(&evidence, search.quiet * speed.frequency_hz);
    let cage = verdict::cage(&evidence, &verdict, bearing, &speed);
    let shown =
        evidence.iter().find(|e| Some(e.fault) == verdict.fault).map_or(envelopes.widest_kurtosis(), |e| e.candidate);
    let (candidate, envelope) = envelopes.envelope(shown)?;
    Ok(Diagnosis {
        shaft: speed,
        order_tracked: matches!(shaft, Shaft::At(_)),
        kurtogram,
        band: candidate.band,
        whitened: candidate.whitened,
        evidence,
        cage,
        verdict,
        envelope: Spectrum::of(&envelope.values, envelope.rate_hz, Window::Hann)?,
        warnings,
    })
}

/// Fewest turns of the shaft that an envelope spectrum needs to tell lines apart.
const LEAST_TURNS: f64 = 8.0;

/// A warning where a line lies so near a multiple of the shaft that they are not told apart.
fn hidden(e: &Evidence, (shaft_hz, is_short): (f64, bool), spacing_hz: f64) -> Option<String> {
    let multiple = (e.expected_hz / shaft_hz).round();
    let distance = (e.expected_hz - multiple * shaft_hz).abs();
    (multiple >= 1.0 && distance < 2.0 * spacing_hz).then(|| {
        format!(
            "{} is {distance:.2} Hz from {multiple} turns of the shaft, lines are {spacing_hz:.2} Hz apart: {}",
            e.fault.line(),
            if is_short { "a longer record may tell them apart" } else { "they are not told apart" }
        )
    })
}

/// A warning where samples lie at the end of the sensor's range.
fn clipped(samples: &[f64]) -> Option<String> {
    let (least, most) = samples.iter().fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(*x), b.max(*x)));
    // Two neighbours at one extreme: a signal that is not cut off, and not coarse, has that by chance only.
    let flat = samples.windows(2).filter(|pair| pair[0] == pair[1] && (pair[0] == least || pair[0] == most)).count();
    let share = flat as f64 / samples.len() as f64;
    (flat >= 5 && share > 1e-4).then(|| {
        format!(
            "{:.2} % of the samples lie at the end of the range: the signal is clipped, which makes lines of its own",
            100.0 * share
        )
    })
}
