//! From the deviations of a case to those of its bearing, and their limits.

use crate::validate::{Verdict, require};
use crate::{
    BallSizeSpec, BallWaveSpec, BallWavesSpec, Case, DeviationsSpec, PositionSpec, SpectrumSpec, WavinessSpec,
};
use tribodyn_bearing::{Deviations, Races, Start};
use tribodyn_wear::{BallWave, BallWaves, HIGHEST_OF_BALL, HIGHEST_ORDER, Profile, Wave, WaveSpectrum, WearError};
use tribodyn_wear::{ball_deviations, ball_grades, lot_variation, waviness};

/// Largest amplitude or excess over the ball diameter: beyond it nobody would call the part a bearing.
const MOST: f64 = 0.01;
/// Largest exponent of a spectrum.
const EXPONENT_MAX: f64 = 10.0;

impl DeviationsSpec {
    /// The deviations of a bearing with so many balls.
    ///
    /// # Errors
    /// [`WearError::Wave`] for waves that are none.
    pub(crate) fn of(&self, balls: usize) -> Result<Deviations, WearError> {
        let PositionSpec { ball, inner, outer } = self.position;
        let sizes = match &self.balls {
            None => Vec::new(),
            Some(BallSizeSpec::Excess(excess)) => excess.iter().map(|length| length.0).collect(),
            Some(BallSizeSpec::Grade { grade, seed }) => {
                lot_variation(*grade).map_or(Vec::new(), |variation| ball_deviations(variation, balls, *seed))
            }
        };
        let equal = sizes.iter().all(|excess| *excess == 0.0);
        Ok(Deviations {
            waviness: Races { inner: self.inner.profile()?, outer: self.outer.profile()? },
            // Equal balls are those of a bearing without deviations, to the last bit.
            balls: if equal { Vec::new() } else { sizes },
            first_ball: ball,
            turned: Races { inner, outer },
        })
    }
}

impl WavinessSpec {
    fn profile(&self) -> Result<Option<Profile>, WearError> {
        let listed = self.waves.iter();
        let mut waves: Vec<Wave> =
            listed.map(|w| Wave { order: w.order, amplitude: w.amplitude, phase: w.phase }).collect();
        if let Some(spectrum) = self.spectrum {
            waves.extend(spectrum.law().waves());
        }
        waviness(&waves)
    }
}

impl SpectrumSpec {
    fn law(self) -> WaveSpectrum {
        let Self { first, last, amplitude, exponent, seed } = self;
        WaveSpectrum { first, last, amplitude, exponent, seed }
    }
}

impl BallWavesSpec {
    /// The waves of the balls in a run.
    pub(crate) fn waves(&self) -> BallWaves {
        let wave = |spec: &BallWaveSpec| {
            let BallWaveSpec { ball, order, amplitude, phase } = *spec;
            BallWave { ball, wave: Wave { order, amplitude, phase } }
        };
        BallWaves { waves: self.waves.iter().map(wave).collect(), spectrum: self.spectrum.map(SpectrumSpec::law) }
    }
}

pub(super) fn validate(case: &Case) -> Verdict {
    let Some(spec) = &case.deviations else { return Ok(()) };
    let most = MOST * case.geometry.ball_diameter;
    for (name, race) in [("inner", &spec.inner), ("outer", &spec.outer)] {
        self::race(&format!("deviations.{name}"), race, most)?;
    }
    match &spec.balls {
        Some(BallSizeSpec::Excess(excess)) => {
            let (path, count) = ("deviations.balls.Excess", case.geometry.ball_count);
            let message = format!("must have an entry for each of the {count} balls; it has {}", excess.len());
            require(excess.len() == count, path, message)?;
            for (i, length) in excess.iter().enumerate() {
                let within = (-most..=most).contains(&length.0);
                let message = format!("must lie within a hundredth of the ball diameter, ±{} um", most * 1e6);
                require(within, &format!("{path}[{i}]"), message)?;
            }
        }
        Some(BallSizeSpec::Grade { grade, .. }) => {
            let known: Vec<String> = ball_grades().map(|grade| grade.to_string()).collect();
            let message = format!("must be a grade of ISO 3290-1: {}", known.join(", "));
            require(lot_variation(*grade).is_some(), "deviations.balls.Grade.grade", message)?;
        }
        None => {}
    }
    ball_waves(&spec.ball_waves, case.geometry.ball_count, most)?;
    let on_orbit = case.transient.as_ref().is_some_and(|transient| transient.start == Start::SteadyOrbit);
    require(
        spec.position.ball == 0.0 || !on_orbit,
        "deviations.position.ball",
        "a run from the steady orbit has ball 0 at 0°: leave it out, or take transient.start: QuasiStatic",
    )
}

fn race(path: &str, spec: &WavinessSpec, most: f64) -> Verdict {
    let orders = [1, HIGHEST_ORDER];
    for (i, wave) in spec.waves.iter().enumerate() {
        let path = format!("{path}.waves[{i}]");
        order(&format!("{path}.order"), wave.order, orders)?;
        amplitude(&format!("{path}.amplitude"), wave.amplitude, most)?;
    }
    spec.spectrum.iter().try_for_each(|s| spectrum(&format!("{path}.spectrum"), s, (orders, most)))
}

fn ball_waves(spec: &BallWavesSpec, balls: usize, most: f64) -> Verdict {
    let (path, orders) = ("deviations.ball_waves", [2, HIGHEST_OF_BALL]);
    for (i, wave) in spec.waves.iter().enumerate() {
        let path = format!("{path}.waves[{i}]");
        let message = format!("must be the number of a ball, 0 to {}", balls - 1);
        require(wave.ball < balls, &format!("{path}.ball"), message)?;
        order(&format!("{path}.order"), wave.order, orders)?;
        amplitude(&format!("{path}.amplitude"), wave.amplitude, most)?;
    }
    spec.spectrum.iter().try_for_each(|s| spectrum(&format!("{path}.spectrum"), s, (orders, most)))
}

fn spectrum(path: &str, spec: &SpectrumSpec, (orders, most): ([u32; 2], f64)) -> Verdict {
    order(&format!("{path}.first"), spec.first, orders)?;
    order(&format!("{path}.last"), spec.last, [spec.first, orders[1]])?;
    amplitude(&format!("{path}.amplitude"), spec.amplitude, most)?;
    let within = (0.0..=EXPONENT_MAX).contains(&spec.exponent);
    require(within, &format!("{path}.exponent"), format!("must lie between 0 and {EXPONENT_MAX}"))
}

fn amplitude(path: &str, value: f64, most: f64) -> Verdict {
    let message = format!("must lie between 0 and a hundredth of the ball diameter, {} um", most * 1e6);
    require((0.0..=most).contains(&value), path, message)
}

fn order(path: &str, value: u32, [least, highest]: [u32; 2]) -> Verdict {
    require((least..=highest).contains(&value), path, format!("must lie between {least} and {highest}"))
}
