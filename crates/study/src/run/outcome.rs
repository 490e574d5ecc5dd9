//! The report of a run: the summary of the recording, and what only the solver knows.

use super::summary::{Summary, carries_accelerations};
use super::tally::Tally;
use super::warnings::{self, Tested};
use crate::case_file::CaseFile;
use crate::error::StudyError;
use crate::plausibility;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_bearing::PatchSurfaces;
use tribodyn_case::Case;
use tribodyn_dynamics::{Run, Statistics, Stiffness};
use tribodyn_quasistatic::Solution;
use tribodyn_record::RecordError;

/// A run that has ended.
pub struct RunOutcome {
    /// Numbers of the run.
    pub report: RunReport,
    /// Where the run was stopped before its end.
    pub stopped: Option<Stopped>,
}

/// A run that can be taken up again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stopped {
    /// Simulated time, s.
    pub simulated_s: f64,
    /// Simulated time at which the run would have ended, s.
    pub duration_s: f64,
}

/// The summary of a recorded run, and what only the solver knows.
#[derive(Debug, Clone, Serialize)]
pub struct RunReport {
    /// Name of the case file.
    pub case: String,
    /// Name of the bearing.
    pub bearing: String,
    /// The recording; empty where there is none.
    pub recording: PathBuf,
    /// Simulated time of the whole run, s.
    pub duration_s: f64,
    /// Wall time of this part of the run, s.
    pub wall_s: f64,
    /// Simulated over wall time of this part of the run.
    pub simulated_per_wall: f64,
    /// Cage speed of the quasi-static solution from which the run starts, r/min.
    pub cage_speed_start_rpm: f64,
    /// Rule by which patches are integrated.
    pub patch_rule: String,
    /// Of the quasi-static solution, over the contact load.
    pub patch_error_estimate: Option<f64>,
    /// Whether that error is small enough for accelerations.
    pub accelerations_supported: bool,
    /// Scheme of integration in time.
    pub scheme: String,
    /// Steps and evaluations of the scheme.
    pub scheme_statistics: Statistics,
    /// Stiffness of the equations of motion.
    pub stiffness: Stiffness,
    /// Numbers of the recording.
    #[serde(flatten)]
    pub summary: Option<Summary>,
    /// Of the quasi-static solution from which the run starts.
    pub warnings_at_start: Vec<String>,
    /// Races whose pressures left the range in which the coating was tested.
    pub untested_pressures: Vec<String>,
}

/// Warnings of the solution that a run starts from, and what is unusual about it and its case.
fn unusual(file: &CaseFile, solution: &Solution) -> Vec<String> {
    let mut all = warnings::at_start(solution.warnings.clone());
    // A case that runs has a bearing.
    if let Ok(bearing) = file.bearing() {
        let found = plausibility::of_solution(&file.case, (&file.text, &bearing), solution);
        all.extend(found.into_iter().flat_map(|found| found.sentences));
    }
    all
}

impl RunReport {
    /// What the solver knows at the end of a run.
    pub(super) fn begin(run: &Run, file: &CaseFile, wall_s: f64) -> Self {
        let solution = run.solution();
        Self {
            case: file.name.clone(),
            bearing: file.case.name.clone(),
            recording: PathBuf::new(),
            duration_s: run.duration(),
            wall_s,
            simulated_per_wall: 0.0,
            cage_speed_start_rpm: solution.cage_speed_rpm,
            // Elastic patches have strips and cells of their own.
            patch_rule: match file.case.modelling.patch {
                Some(PatchSurfaces::Elastic { strips, cells }) => {
                    format!("Elastic {{ strips: {strips}, cells: {cells} }}")
                }
                _ => format!("{:?}", run.patch_rule()),
            },
            patch_error_estimate: solution.patch_error_estimate,
            accelerations_supported: carries_accelerations(solution.patch_error_estimate),
            scheme: file.case.transient.as_ref().map_or_else(String::new, |t| format!("{:?}", t.scheme)),
            scheme_statistics: run.statistics(),
            stiffness: run.stiffness(),
            summary: None,
            warnings_at_start: unusual(file, solution),
            untested_pressures: Vec::new(),
        }
    }

    /// Adds what was gathered while the run was recorded.
    pub(super) fn complete(
        self,
        recording: &Path,
        case: &Case,
        tally: &Tally,
        from_s: f64,
    ) -> Result<Self, StudyError> {
        let nothing = || RecordError::NothingToRecover { path: recording.to_owned() };
        let report = self.summed_up(case, tally, from_s).ok_or_else(nothing)?;
        Ok(Self { recording: recording.to_owned(), ..report })
    }

    /// Adds what was gathered from a run that began at a time, s; none where that is no sample.
    pub(super) fn summed_up(mut self, case: &Case, tally: &Tally, from_s: f64) -> Option<Self> {
        let summary = tally.states.summary(tally.wear.as_ref(), tally.warnings.lines())?.judged(case);
        self.simulated_per_wall = (summary.simulated_s - from_s) / self.wall_s;
        self.summary = Some(summary);
        self.untested_pressures = tally.pressures.iter().filter_map(Tested::warning).collect();
        Some(self)
    }
}
