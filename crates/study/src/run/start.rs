//! A transient run at its start, by whatever its case asks for.

use crate::error::StudyError;
use tribodyn::CaseFile;
use tribodyn::answers::OrbitProblem;
use tribodyn_bearing::{RunInputs, SearchWatch, Start};
use tribodyn_dynamics::{Run, StartMotion};
use tribodyn_orbit::{OrbitError, SolvedOrbit, steady_orbit};

/// The run of a case at its start, and what it was made from.
///
/// # Errors
/// A case that cannot be run, or a start that is not found.
pub fn start_run(file: &CaseFile) -> Result<(Run, RunInputs), StudyError> {
    let inputs = file.run_inputs()?;
    let cannot_start = |source| StudyError::CannotStart { file: file.name.clone(), source };
    if inputs.options.start != Start::SteadyOrbit {
        let run = Run::new(inputs.clone()).map_err(cannot_start)?;
        return Ok((run, inputs));
    }
    let point = inputs.operating_point_at(0.0);
    let problem = OrbitProblem { point, ..OrbitProblem::new(&file.question(SearchWatch::default()))? };
    let failed = |source| StudyError::NoOrbitToStart { file: file.name.clone(), source };
    let motion = motion(&problem).map_err(failed)?;
    let run = Run::moving(inputs.clone(), motion).map_err(cannot_start)?;
    Ok((run, inputs))
}

/// The motion of an orbit at an instant; of a standstill there is no orbit.
fn motion(problem: &OrbitProblem) -> Result<StartMotion, OrbitError> {
    let OrbitProblem { bearing, point, cage, settings } = problem;
    let SolvedOrbit { solution: orbit, start, .. } = steady_orbit(bearing, point, cage, settings)?;
    let solution = orbit.as_solution(&orbit.balls, [point.inner_speed, point.outer_speed]);
    let start = start.ok_or(OrbitError::AtRest)?;
    Ok(StartMotion { motion: start.motion(orbit.balls.len()), rule: start.rule(), solution })
}
