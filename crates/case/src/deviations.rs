//! From the deviations of a case to those of its bearing, and their limits.

use crate::validate::{Verdict, require};
use crate::{BallSizeSpec, Case, DeviationsSpec, PositionSpec, WavinessSpec};
use tribodyn_bearing::{Deviations, Races, Start};
use tribodyn_wear::{HIGHEST_ORDER, Profile, Wave, WaveSpectrum, WearError};
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
        if let Some(s) = self.spectrum {
            let spectrum = WaveSpectrum {
                first: s.first,
                last: s.last,
                amplitude: s.amplitude,
                exponent: s.exponent,
                seed: s.seed,
            };
            waves.extend(spectrum.waves());
        }
        waviness(&waves)
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
    let on_orbit = case.transient.as_ref().is_some_and(|transient| transient.start == Start::SteadyOrbit);
    require(
        spec.position.ball == 0.0 || !on_orbit,
        "deviations.position.ball",
        "a run from the steady orbit has ball 0 at 0°: leave it out, or take transient.start: QuasiStatic",
    )
}

fn race(path: &str, spec: &WavinessSpec, most: f64) -> Verdict {
    let amplitude = |path: String, value: f64| {
        let message = format!("must lie between 0 and a hundredth of the ball diameter, {} um", most * 1e6);
        require((0.0..=most).contains(&value), &path, message)
    };
    for (i, wave) in spec.waves.iter().enumerate() {
        let path = format!("{path}.waves[{i}]");
        order(&format!("{path}.order"), wave.order, 1)?;
        amplitude(format!("{path}.amplitude"), wave.amplitude)?;
    }
    let Some(spectrum) = &spec.spectrum else { return Ok(()) };
    let path = format!("{path}.spectrum");
    order(&format!("{path}.first"), spectrum.first, 1)?;
    order(&format!("{path}.last"), spectrum.last, spectrum.first)?;
    amplitude(format!("{path}.amplitude"), spectrum.amplitude)?;
    let within = (0.0..=EXPONENT_MAX).contains(&spectrum.exponent);
    require(within, &format!("{path}.exponent"), format!("must lie between 0 and {EXPONENT_MAX}"))
}

fn order(path: &str, value: u32, least: u32) -> Verdict {
    let message = format!("must lie between {least} and {HIGHEST_ORDER}");
    require((least..=HIGHEST_ORDER).contains(&value), path, message)
}
