//! Natural modes about the steady orbit.

use super::OrbitProblem;
use crate::case_file::CaseFile;
use crate::error::StudyError;
use serde::Serialize;
use tribodyn_orbit::{Bodies, Mode, orbit_modes};

/// The modes up to a frequency.
#[derive(Debug, Clone, Serialize)]
pub struct ModesAnswer {
    /// Cage speed of the orbit, r/min.
    pub cage_speed_rpm: f64,
    /// Number of modes that grow.
    pub unstable: usize,
    /// By frequency.
    pub modes: Vec<Mode>,
}

/// The modes of balls, cage and rings up to a frequency in Hz.
///
/// # Errors
/// A case without masses and supports of a run, a bearing at rest, or an orbit that is not found.
pub fn modes(file: &CaseFile, up_to_hz: f64) -> Result<ModesAnswer, StudyError> {
    if up_to_hz.is_nan() || up_to_hz <= 0.0 {
        return Err(StudyError::argument("up-to", up_to_hz, "allowed is a frequency above 0 Hz"));
    }
    // Masses and supports are those of a run.
    let inputs = file.run_inputs()?;
    let problem = OrbitProblem::new(file)?;
    let solved = problem.solve(file)?;
    let failed = |source| StudyError::Orbit { file: file.name.clone(), source };
    let Some(start) = &solved.start else {
        return Err(StudyError::argument("set", "speed", "a bearing at rest has no orbit to swing about"));
    };
    let bodies =
        Bodies { cage: problem.cage, contact_damping: inputs.options.contact_damping, supports: inputs.supports };
    let modes = orbit_modes(&problem.bearing, &problem.point, &bodies, &problem.settings, start).map_err(failed)?;
    let modes: Vec<Mode> = modes.modes.into_iter().filter(|mode| mode.frequency_hz <= up_to_hz).collect();
    let unstable = modes.iter().filter(|mode| mode.growth_rate_per_s > 0.0).count();
    Ok(ModesAnswer { cage_speed_rpm: solved.solution.cage_speed_rpm, unstable, modes })
}
