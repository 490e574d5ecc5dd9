//! The report of a run: the summary of the recording, and what only the solver knows.

use super::known::{KnownAtEnd, KnownAtStart};
use super::summary::{Summary, carries_accelerations};
use super::tally::Tally;
use super::warnings::Tested;
use crate::error::StudyError;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tribodyn::CaseFile;
use tribodyn_case::Case;
use tribodyn_dynamics::Run;
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
    /// Facts that are known before the first step.
    #[serde(flatten)]
    pub known: KnownAtStart,
    /// Facts that are known at the end.
    #[serde(flatten)]
    pub outcome: KnownAtEnd,
    /// True if the errors of patch and scheme are small enough for accelerations.
    pub accelerations_supported: bool,
    /// Numbers of the recording.
    #[serde(flatten)]
    pub summary: Option<Summary>,
    /// Of the solution from which the run starts.
    pub warnings_at_start: Vec<String>,
    /// Races whose pressures left the range in which the coating was tested.
    pub untested_pressures: Vec<String>,
}

impl RunReport {
    /// The solver's part of the report, at the end of a run.
    pub(super) fn begin(run: &Run, file: &CaseFile, (known, outcome): (KnownAtStart, KnownAtEnd), wall_s: f64) -> Self {
        Self {
            case: file.name.clone(),
            bearing: file.case.name.clone(),
            recording: PathBuf::new(),
            duration_s: run.duration(),
            wall_s,
            simulated_per_wall: 0.0,
            accelerations_supported: false,
            summary: None,
            warnings_at_start: known.warnings_at_start.clone(),
            untested_pressures: Vec::new(),
            known,
            outcome,
        }
    }

    /// Of a run that began at an instant and was not recorded; none where it has no sample.
    pub(crate) fn of_unrecorded(run: &Run, file: &CaseFile, tally: &Tally, began: Instant) -> Option<Self> {
        let known = (KnownAtStart::of(run, file), KnownAtEnd::of(run));
        Self::begin(run, file, known, began.elapsed().as_secs_f64()).summed_up(&file.case, tally, 0.0)
    }

    /// All warnings: of the start, of pressures, of the run.
    pub fn warnings(&self) -> impl Iterator<Item = &String> {
        let of_run = self.summary.iter().flat_map(|summary| &summary.warnings);
        self.warnings_at_start.iter().chain(&self.untested_pressures).chain(of_run)
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
        self.accelerations_supported = carries_accelerations(&summary, &self.known, Some(&self.outcome));
        self.simulated_per_wall = (summary.simulated_s - from_s) / self.wall_s;
        self.summary = Some(summary);
        self.untested_pressures = tally.pressures.iter().filter_map(Tested::warning).collect();
        Some(self)
    }
}
