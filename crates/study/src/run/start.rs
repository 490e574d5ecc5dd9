//! A transient run at its start, by whatever its case asks for.

use crate::answers::OrbitProblem;
use crate::case_file::CaseFile;
use crate::error::StudyError;
use tribodyn_bearing::{RunInputs, SearchWatch, Start};
use tribodyn_dynamics::Run;

/// The run of a case at its start, and what it was made from.
///
/// # Errors
/// A case that cannot be run, or a start that is not found.
pub(crate) fn start_run(file: &CaseFile) -> Result<(Run, RunInputs), StudyError> {
    let inputs = file.run_inputs()?;
    let cannot_start = |source| StudyError::CannotStart { file: file.name.clone(), source };
    if inputs.options.start != Start::SteadyOrbit {
        let run = Run::new(inputs.clone()).map_err(cannot_start)?;
        return Ok((run, inputs));
    }
    let point = inputs.operating_point_at(0.0);
    let problem = OrbitProblem { point, ..OrbitProblem::new(&file.question(SearchWatch::default()))? };
    let failed = |source| StudyError::NoOrbitToStart { file: file.name.clone(), source };
    let motion = problem.motion().map_err(failed)?;
    let run = Run::moving(inputs.clone(), motion).map_err(cannot_start)?;
    Ok((run, inputs))
}
