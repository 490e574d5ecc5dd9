//! The 5 × 5 stiffness of the inner ring over its speed.

use super::{Equations, OrbitProblem};
use crate::case_file::CaseFile;
use crate::error::StudyError;
use serde::Serialize;
use tribodyn_case::Purpose;
use tribodyn_orbit::{OrbitStart, orbit_stiffness, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{Model, StiffnessMatrix, compliance, jones_harris_stiffness, solve, traction_stiffness};

const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;

/// Stiffness at one speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StiffnessAnswer {
    /// Speed of the inner ring, r/min.
    pub inner_speed_rpm: f64,
    /// By rows: forces along x, y, z (N) and moments about x, y (N m) against x, y, z (m) and tilts about x, y (rad).
    pub stiffness: StiffnessMatrix,
    /// Its inverse; absent where a displacement meets no resistance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compliance: Option<StiffnessMatrix>,
}

/// Stiffness at each of some speeds of the inner ring, r/min; at that of the case where none is given.
///
/// # Errors
/// A speed that is no number, or an operating point that is not found.
pub fn stiffness(
    file: &CaseFile,
    equations: Equations,
    speeds_rpm: &[f64],
) -> Result<Vec<StiffnessAnswer>, StudyError> {
    if let Some(speed) = speeds_rpm.iter().find(|speed| !speed.is_finite()) {
        return Err(StudyError::argument("speeds", speed, "allowed are finite speeds in r/min"));
    }
    let given = file.case.operating_point().inner_speed;
    let speeds: Vec<f64> =
        if speeds_rpm.is_empty() { vec![given] } else { speeds_rpm.iter().map(|rpm| rpm / RPM_PER_RAD_S).collect() };
    let mut start = None;
    let mut answers = Vec::with_capacity(speeds.len());
    for speed in speeds {
        let stiffness = at_speed(equations, file, speed, &mut start)?;
        let compliance = compliance(&stiffness);
        answers.push(StiffnessAnswer { inner_speed_rpm: speed * RPM_PER_RAD_S, stiffness, compliance });
    }
    Ok(answers)
}

fn at_speed(
    equations: Equations,
    file: &CaseFile,
    speed: f64,
    start: &mut Option<OrbitStart>,
) -> Result<StiffnessMatrix, StudyError> {
    let failed = |source| StudyError::Solver { file: file.name.clone(), source };
    let no_orbit = |source| StudyError::Orbit { file: file.name.clone(), source };
    let mut point = file.case.operating_point();
    point.inner_speed = speed;
    match equations {
        Equations::JonesHarris => {
            let bearing = file.bearing_for(Purpose::JonesHarris)?;
            jones_harris_stiffness(&bearing, &point).map_err(failed)
        }
        Equations::Traction => {
            let bearing = file.bearing_for(Purpose::Traction)?;
            let solved = solve(&bearing, &point, Model::Traction).map_err(failed)?;
            // A traction solution always comes with its unknowns.
            let Some(at) = solved.warm_start else { unreachable!("a traction solution has unknowns") };
            traction_stiffness(&bearing, &point, &at).map_err(failed)
        }
        Equations::SteadyOrbit => {
            let OrbitProblem { bearing, cage, settings, .. } = OrbitProblem::new(file)?;
            let solved = match start.as_ref() {
                Some(near) => steady_orbit_from(&bearing, &point, &cage, &settings, near),
                None => steady_orbit(&bearing, &point, &cage, &settings),
            };
            *start = solved.map_err(no_orbit)?.start;
            match start.as_ref() {
                Some(at) => {
                    let found = orbit_stiffness(&bearing, &point, &cage, &settings, at).map_err(no_orbit)?;
                    Ok(found.stiffness)
                }
                // A bearing at rest: the elastic equilibrium.
                None => jones_harris_stiffness(&file.bearing_for(Purpose::JonesHarris)?, &point).map_err(failed),
            }
        }
    }
}
