//! Natural modes about the steady orbit.

use super::{Answer, Findings, OrbitAnswer, Question};
use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_orbit::{Bodies, Mode, OrbitModes, orbit_modes};

/// The modes up to a frequency.
#[derive(Debug, Clone, Serialize)]
pub struct ModesAnswer {
    /// Cage speed of the orbit, r/min.
    pub cage_speed_rpm: f64,
    /// Factor on a small disturbance of a ball over a turn of the cage: above 1 it grows.
    pub multiplier: f64,
    /// The same as a rate, 1/s.
    pub growth_rate_per_s: f64,
    /// By frequency.
    pub modes: Vec<Mode>,
}

/// Part of the kinetic energy that rings and cage have at least in a mode of theirs.
const OF_BODIES: f64 = 0.1;

/// The modes of cage and rings up to a frequency in Hz, or of the balls too.
///
/// Those of balls belong to an instant: what becomes of a ball over a turn the multiplier says.
///
/// # Errors
/// A case without masses and supports of a run, a bearing at rest, or an orbit that is not found.
pub fn modes(question: &Question<'_>, up_to_hz: f64, all: bool) -> Result<Answer<ModesAnswer>, AnswerError> {
    if up_to_hz.is_nan() || up_to_hz <= 0.0 {
        return Err(AnswerError::argument("up-to", up_to_hz, "allowed is a frequency above 0 Hz"));
    }
    // Masses and supports are those of a run.
    let inputs = question.run_inputs()?;
    let (problem, answer, start) = OrbitAnswer::with_start(question, None)?;
    let failed = |source| AnswerError::Orbit { file: question.name.to_owned(), source };
    let start = start.ok_or_else(|| AnswerError::AtRest(question.name.to_owned()))?;
    let bodies = Bodies {
        cage: problem.cage,
        contact_damping: inputs.options.contact_damping,
        supports: inputs.supports,
        tilting: inputs.tilting,
    };
    let modes = orbit_modes(&problem.bearing, &problem.point, &bodies, &problem.settings, &start).map_err(failed)?;
    let OrbitModes { modes, multiplier, growth_rate_per_s, warnings } = modes;
    let shown = |mode: &Mode| mode.frequency_hz <= up_to_hz && (all || mode.energy_shares.bodies() >= OF_BODIES);
    let modes = modes.into_iter().filter(shown).collect();
    let answered = ModesAnswer { cage_speed_rpm: answer.orbit.cage_speed_rpm, multiplier, growth_rate_per_s, modes };
    Ok(Answer::new(warnings.into_iter().fold(answer.findings, Findings::with), answered))
}
