//! The 5 × 5 stiffness of the inner ring over its speed.

use super::{Answer, Equations, Findings, OrbitProblem, Question};
use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_case::Purpose;
use tribodyn_orbit::{OrbitStart, OrbitStiffness, SolvedOrbit, orbit_stiffness, steady_orbit, steady_orbit_from};
use tribodyn_quasistatic::{
    StiffnessMatrix, checked_traction_stiffness, compliance, doubtful_stiffness, jones_harris_stiffness, solve,
};

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
    /// Largest estimated error of an element over √(K_ii K_jj), of an orbit or of an equilibrium with
    /// traction; absent for Jones–Harris, at rest, and where nothing beside it tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_estimate: Option<f64>,
}

/// Stiffness at each of some speeds of the inner ring, r/min; at that of the case where none is given.
///
/// # Errors
/// A speed that is no number, or an operating point that is not found.
pub fn stiffness(
    question: &Question<'_>,
    equations: Equations,
    speeds_rpm: &[f64],
) -> Result<Vec<Answer<StiffnessAnswer>>, AnswerError> {
    if let Some(speed) = speeds_rpm.iter().find(|speed| !speed.is_finite()) {
        return Err(AnswerError::argument("speeds", speed, "allowed are finite speeds in r/min"));
    }
    let given = question.case.operating_point().inner_speed;
    let speeds: Vec<f64> =
        if speeds_rpm.is_empty() { vec![given] } else { speeds_rpm.iter().map(|rpm| rpm / RPM_PER_RAD_S).collect() };
    let mut start = None;
    let mut answers = Vec::with_capacity(speeds.len());
    for speed in speeds {
        let (findings, stiffness, error_estimate) = at_speed(equations, question, speed, &mut start)?;
        let compliance = compliance(&stiffness);
        let inner_speed_rpm = speed * RPM_PER_RAD_S;
        let answer = StiffnessAnswer { inner_speed_rpm, stiffness, compliance, error_estimate };
        answers.push(Answer::new(findings, answer));
    }
    Ok(answers)
}

/// Reason of an error at an equilibrium.
const DOUBT: &str = "equilibria beside this one give another one, as where a contact just begins";

fn at_speed(
    equations: Equations,
    question: &Question<'_>,
    speed: f64,
    start: &mut Option<OrbitStart>,
) -> Result<(Findings, StiffnessMatrix, Option<f64>), AnswerError> {
    let failed = |source| AnswerError::Solver { file: question.name.to_owned(), source };
    let no_orbit = |source| AnswerError::Orbit { file: question.name.to_owned(), source };
    let mut point = question.point();
    point.inner_speed = speed;
    if let Some(model) = equations.equilibrium() {
        let bearing = question.bearing_for(equations.purpose())?;
        question.bearable(&bearing)?;
        let solved = solve(&bearing, &point, model).map_err(failed)?;
        let findings = Findings::of(question, &bearing, (equations, &solved.solution))?;
        let Some(at) = solved.warm_start else {
            return Ok((findings, jones_harris_stiffness(&bearing, &point).map_err(failed)?, None));
        };
        let checked = checked_traction_stiffness(&bearing, &point, (&solved.solution, &at));
        let (stiffness, error) = checked.map_err(failed)?;
        let doubt = error.and_then(|error| doubtful_stiffness(error, DOUBT));
        return Ok((doubt.into_iter().fold(findings, Findings::with), stiffness, error));
    }
    let OrbitProblem { bearing, cage, settings, .. } = OrbitProblem::new(question)?;
    let solved = match start.as_ref() {
        Some(near) => steady_orbit_from(&bearing, &point, &cage, &settings, near),
        None => steady_orbit(&bearing, &point, &cage, &settings),
    };
    let SolvedOrbit { solution: orbit, start: reached, .. } = solved.map_err(no_orbit)?;
    *start = reached;
    let round = orbit.as_solution(&orbit.points, [point.inner_speed, point.outer_speed]);
    let findings = Findings::of(question, &bearing, (equations, &round))?;
    let Some(at) = start.as_ref() else {
        // A bearing at rest: the elastic equilibrium.
        let bearing = question.bearing_for(Purpose::JonesHarris)?;
        return Ok((findings, jones_harris_stiffness(&bearing, &point).map_err(failed)?, None));
    };
    let found = orbit_stiffness(&bearing, &point, &cage, &settings, at).map_err(no_orbit)?;
    let OrbitStiffness { stiffness, error_estimate, warnings } = found;
    Ok((warnings.into_iter().fold(findings, Findings::with), stiffness, Some(error_estimate)))
}
