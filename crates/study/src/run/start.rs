//! A transient run at its start, by whatever its case asks for.

use crate::answers::OrbitProblem;
use crate::case_file::CaseFile;
use crate::error::StudyError;
use tribodyn_bearing::{SearchWatch, Start};
use tribodyn_dynamics::Run;

/// The run of a case at its start.
///
/// # Errors
/// A case that cannot be run, or a start that is not found.
pub(crate) fn start_run(file: &CaseFile) -> Result<Run, StudyError> {
    let inputs = file.run_inputs()?;
    let cannot_start = |source| StudyError::CannotStart { file: file.name.clone(), source };
    if inputs.options.start != Start::SteadyOrbit {
        return Run::new(inputs).map_err(cannot_start);
    }
    let point = inputs.operating_point_at(0.0);
    let problem = OrbitProblem { point, ..OrbitProblem::new(&file.question(SearchWatch::default()))? };
    let failed = |source| StudyError::NoOrbitToStart { file: file.name.clone(), source };
    let motion = problem.motion().map_err(failed)?;
    Run::moving(inputs, motion).map_err(cannot_start)
}
