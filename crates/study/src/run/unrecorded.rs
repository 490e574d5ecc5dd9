//! A run without a recording, and what it comes to.

use super::outcome::RunReport;
use super::start::start_run;
use super::tally::Tally;
use crate::error::{StudyError, with_causes};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tribodyn::CaseFile;
use tribodyn_dynamics::{BallDetail, DynamicsError, Ending, Event, Observer, RunError, Sample};
use tribodyn_record::{RecordError, RunItem, RunRows};

/// Why a run without a recording has no summary.
#[derive(Debug, thiserror::Error)]
pub(crate) enum NoSummary {
    /// A case that cannot be run.
    #[error(transparent)]
    Input(#[from] StudyError),
    /// The solver, at the start or on the way.
    #[error(transparent)]
    Solver(#[from] DynamicsError),
    /// A sample that no recording would take.
    #[error("{}", with_causes(.0))]
    Sample(#[from] RecordError),
    /// A run without a sample.
    #[error("the run has no sample")]
    NoSample,
}

/// Runs a case to its end; none where `stop` was set before. Its numbers are those of a recorded run, to the last bit.
pub(crate) fn run_unrecorded(file: &CaseFile, stop: &AtomicBool) -> Result<Option<RunReport>, NoSummary> {
    let began = Instant::now();
    let (mut run, _) = start_run(file)?;
    let mut tally = Tally::new(&file.case);
    let mut watch = Watch { rows: RunRows::new(file.case.geometry.ball_count, |item| tally.take(item)), stop };
    match run.advance(f64::INFINITY, &mut watch) {
        // A step beyond its stability is among the warnings of the log.
        Ok(Ending::Complete | Ending::BeyondStability { .. }) => watch.rows.finish(),
        Ok(Ending::Stopped) => return Ok(None),
        Err(RunError::Dynamics(error)) => return Err(error.into()),
        Err(RunError::Observer(error)) => return Err(error.into()),
    }
    RunReport::of_unrecorded(&run, file, &tally, began).map(Some).ok_or(NoSummary::NoSample)
}

/// Hands all on, and looks after each step whether to go on.
struct Watch<'a, T> {
    rows: RunRows<T>,
    stop: &'a AtomicBool,
}

impl<T: FnMut(RunItem)> Observer for Watch<'_, T> {
    type Error = RecordError;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        self.rows.sample(sample, with_balls)
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        self.rows.event(event)
    }

    fn between(&self) -> BallDetail {
        self.rows.between()
    }

    fn stepped(&mut self, _time_s: f64) -> ControlFlow<()> {
        if self.stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
