//! A transient run, recorded.
//!
//! The run goes in slices of about a millisecond of simulated time whose ends depend on the case alone: between them the
//! session reports its progress, can be stopped and, about once a second of wall time, writes a checkpoint. Neither changes a step, so
//! that a resumed run makes the samples of one that was never stopped.

use super::checkpoint::{Files, Saved};
use super::outcome::{RunOutcome, RunReport, Stopped};
use super::resume;
use super::tape::{SharedTape, Viewers};
use crate::case_file::CaseFile;
use crate::error::StudyError;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};
use tribodyn_bearing::Scheme;
use tribodyn_case::Case;
use tribodyn_dynamics::{DynamicsError, Event, EventKind, Observer, Run, RunError as Advance};
use tribodyn_record::{RecordError, RunRecorder, RunRecording};

/// Simulated time between looks at the clock and at the caller, s.
const SLICE_S: f64 = 1e-3;
/// Wall time between checkpoints.
const CHECKPOINT_EVERY: Duration = Duration::from_secs(1);
const GENERATOR: &str = concat!("tribodyn ", env!("CARGO_PKG_VERSION"));

/// How a run begins where an earlier one of the same recording was stopped or killed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beginning {
    /// At time zero; refuses to lose an earlier run.
    New,
    /// Where the earlier run was stopped.
    Resume,
    /// At time zero; forgets the earlier run.
    Restart,
}

/// A run that can begin: its case and the files of an earlier run are accepted, nothing is written yet.
///
/// ```no_run
/// use std::ops::ControlFlow;
/// use tribodyn_study::CaseFile;
/// use tribodyn_study::run::{Beginning, PreparedRun};
///
/// let file = CaseFile::read("case.ron".as_ref(), &[])?;
/// let prepared = PreparedRun::new(&file, "run.mcap".as_ref(), Beginning::New)?;
/// let outcome = prepared.begin(None)?.complete(|_time_s| ControlFlow::Continue(()))?;
/// assert!(outcome.stopped.is_none() && outcome.report.summary.is_some());
/// # Ok::<(), tribodyn_study::StudyError>(())
/// ```
pub struct PreparedRun<'a> {
    file: &'a CaseFile,
    run: Run,
    files: Files,
    saved: Option<Saved>,
}

impl<'a> PreparedRun<'a> {
    /// For a recording at a path; it is `<recording>.active` until it is whole, with a checkpoint beside it.
    ///
    /// # Errors
    /// The case cannot be run, or the files of an earlier run forbid this beginning.
    pub fn new(file: &'a CaseFile, recording: &Path, beginning: Beginning) -> Result<Self, StudyError> {
        let files = Files::new(recording);
        let saved = earlier(beginning, &files, &file.text)?;
        let cannot_start = |source| StudyError::CannotStart { file: file.name.clone(), source };
        let run = Run::new(file.run_inputs()?).map_err(cannot_start)?;
        Ok(Self { file, run, files, saved })
    }

    /// Opens the recording; `viewers` get all of it as it is written.
    ///
    /// # Errors
    /// The recording cannot be written, or the earlier one cannot be read.
    pub fn begin(self, viewers: Option<Box<dyn Viewers>>) -> Result<RunSession<'a>, StudyError> {
        let Self { file, run, files, saved } = self;
        match saved {
            None => RunSession::start(file, run, files, viewers),
            Some(saved) => RunSession::resume(file, run, files, saved, viewers),
        }
    }
}

/// The checkpoint to go on from; refuses to lose a run that nobody asked to forget.
fn earlier(beginning: Beginning, files: &Files, case_text: &str) -> Result<Option<Saved>, StudyError> {
    if beginning == Beginning::Resume {
        if !files.checkpoint.exists() {
            return Err(StudyError::NothingToResume { path: files.checkpoint.clone() });
        }
        return Saved::read(&files.checkpoint, case_text).map(Some);
    }
    if beginning == Beginning::New
        && let Some(path) = [&files.checkpoint, &files.active, &files.earlier].into_iter().find(|path| path.exists())
    {
        return Err(StudyError::Unfinished { path: path.clone() });
    }
    Ok(None)
}

/// How the stepping ended.
enum Ending {
    Complete,
    Stopped,
    BrokenOff(DynamicsError),
}

/// A run with its recording.
pub struct RunSession<'a> {
    file: &'a CaseFile,
    /// Simulated time at which this part of the run begins, s.
    from_s: f64,
    run: Run,
    files: Files,
    tape: SharedTape,
    recorder: RunRecorder<SharedTape>,
    slices: Slices,
}

impl<'a> RunSession<'a> {
    fn start(
        file: &'a CaseFile,
        run: Run,
        files: Files,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<Self, StudyError> {
        for old in [&files.checkpoint, &files.active, &files.earlier] {
            remove(old)?;
        }
        let (tape, recorder) = Self::record(file, &files, viewers)?;
        Ok(Self { file, from_s: run.time(), slices: Slices::new(&file.case), run, files, tape, recorder })
    }

    fn resume(
        file: &'a CaseFile,
        mut run: Run,
        files: Files,
        saved: Saved,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<Self, StudyError> {
        resume::set_aside(&files)?;
        let (tape, mut recorder) = Self::record(file, &files, viewers)?;
        resume::copy(&files, &saved, &tape)?;
        recorder.remember(saved.recorder)?;
        let resumed = run.resume(saved.run);
        resumed.map_err(|source| StudyError::CannotStart { file: file.name.clone(), source })?;
        let from_s = run.time();
        let session = Self { file, from_s, slices: Slices::new(&file.case), run, files, tape, recorder };
        // The new file holds everything from here on.
        session.save()?;
        remove(&session.files.earlier)?;
        Ok(session)
    }

    fn record(
        file: &CaseFile,
        files: &Files,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<(SharedTape, RunRecorder<SharedTape>), StudyError> {
        let tape = SharedTape::create(&files.recording, viewers)?;
        let recording = RunRecording { case_text: &file.text, case: &file.case, generator: GENERATOR };
        Ok((tape.clone(), RunRecorder::new(tape, &recording)?))
    }

    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.run.time()
    }

    /// Simulated time at the end, s.
    pub fn duration_s(&self) -> f64 {
        self.run.duration()
    }

    /// Runs to the end of the duration and closes the recording. `progress` gets the simulated time, s, about every
    /// millisecond of it; a break stops the run there, with a checkpoint from which it can be taken up again.
    ///
    /// # Errors
    /// The solver or the disk fails; what was recorded before is kept.
    pub fn complete(mut self, progress: impl FnMut(f64) -> ControlFlow<()>) -> Result<RunOutcome, StudyError> {
        let began = Instant::now();
        let ending = self.go(progress)?;
        self.finish(ending, began.elapsed().as_secs_f64())
    }

    /// Steps to the end of the duration, or to a stop.
    fn go(&mut self, mut progress: impl FnMut(f64) -> ControlFlow<()>) -> Result<Ending, StudyError> {
        let mut saved = Instant::now();
        loop {
            let until = self.slices.after(self.run.time());
            let stopped = match self.run.advance(until, &mut self.recorder) {
                Ok(_) => progress(self.run.time()).is_break(),
                Err(Advance::Dynamics(error)) => return Ok(Ending::BrokenOff(error)),
                Err(Advance::Observer(error)) => return Err(self.not_recorded(error)),
            };
            if until >= self.run.duration() {
                return Ok(Ending::Complete);
            }
            if stopped || saved.elapsed() >= CHECKPOINT_EVERY {
                self.save()?;
                saved = Instant::now();
            }
            if stopped {
                return Ok(Ending::Stopped);
            }
        }
    }

    fn not_recorded(&self, source: RecordError) -> StudyError {
        let active = self.files.active.clone();
        StudyError::NotRecorded { simulated_s: self.run.time(), source: Box::new(source), active }
    }

    fn save(&self) -> Result<(), StudyError> {
        let saved = Saved::new(&self.file.text, &self.run, self.recorder.memory(), &self.tape);
        let written = saved.write(&self.files.checkpoint);
        written.map_err(|source| {
            let Files { checkpoint, active, .. } = self.files.clone();
            StudyError::NoCheckpoint { simulated_s: self.run.time(), checkpoint, source, active }
        })
    }

    /// Closes the recording, whatever the ending.
    fn finish(mut self, ending: Ending, wall_s: f64) -> Result<RunOutcome, StudyError> {
        let file = self.file;
        let time_s = self.run.time();
        if let Ending::BrokenOff(error) = &ending {
            let kind = EventKind::Warning { message: format!("the run was broken off: {error}") };
            self.recorder.event(&Event { time_s, kind }).map_err(|error| self.not_recorded(error))?;
        }
        let report = RunReport::begin(&self.run, file, wall_s);
        let (files, duration_s) = (self.files.clone(), self.run.duration());
        let not_recorded = |source| StudyError::NotRecorded {
            simulated_s: time_s,
            source: Box::new(source),
            active: files.active.clone(),
        };
        self.recorder.finish().map_err(not_recorded)?;
        if !matches!(ending, Ending::Stopped) {
            remove(&files.checkpoint)?;
        }
        if let Ending::BrokenOff(source) = ending {
            let recording = files.recording.clone();
            return Err(StudyError::BrokenOff { file: file.name.clone(), source, recording });
        }
        let stopped = matches!(ending, Ending::Stopped).then_some(Stopped { simulated_s: time_s, duration_s });
        Ok(RunOutcome { report: report.complete(&files.recording, &file.case, self.from_s)?, stopped })
    }
}

fn remove(path: &Path) -> Result<(), StudyError> {
    match fs::remove_file(path) {
        Err(source) if source.kind() != std::io::ErrorKind::NotFound => {
            Err(StudyError::Write { path: path.to_owned(), source })
        }
        _ => Ok(()),
    }
}

/// The ends of the slices: multiples of a time that fits the scheme, so that no step is cut that would not be cut anyway.
#[derive(Debug, Clone, Copy)]
struct Slices {
    /// Step of the scheme or distance of samples, s.
    unit: f64,
    /// Units in a slice.
    count: f64,
}

impl Slices {
    fn new(case: &Case) -> Self {
        let rate = case.rates().state_rate;
        let unit = match case.transient.as_ref().map(|transient| transient.scheme) {
            Some(Scheme::RungeKutta4 { step }) => step,
            // The steps of the fast scheme end at samples, those of the adaptive one anywhere.
            _ => 1.0 / rate,
        };
        Self { unit, count: (SLICE_S / unit).round().max(1.0) }
    }

    /// The end after a time, s.
    fn after(self, time_s: f64) -> f64 {
        let slices = (time_s / (self.unit * self.count) + 1e-6).floor() + 1.0;
        self.unit * (self.count * slices)
    }
}

#[cfg(test)]
mod tests {
    use super::Slices;

    #[test]
    fn identity_slices_end_at_steps_and_go_on() {
        let slices = Slices { unit: 1e-5, count: 100.0 };
        let mut time = 0.0;
        for slice in 1..=500 {
            time = slices.after(time);
            // The very expression of a fixed step, so that the last digit agrees.
            assert_eq!(time, 1e-5 * f64::from(100 * slice));
        }
    }
}
