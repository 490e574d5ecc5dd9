//! A transient run, recorded.
//!
//! After each step the session looks at the clock: some times a second it reports its progress and can be stopped, and
//! twice a second it has a checkpoint written. Neither changes a step, so that a resumed run makes the samples of one
//! that was never stopped. What is recorded is encoded and compressed on a second thread.

use super::checkpoint::{Files, Saved};
use super::known::{KnownAtEnd, KnownAtStart};
use super::outcome::{RunOutcome, RunReport, Stopped};
use super::recording::{Failed, Keeper, Reason, Recorder, Recording};
use super::resume;
use super::start::start_run;
use super::tape::{Tape, Viewers};
use crate::error::StudyError;
use crate::lock::OutputLock;
use std::convert::Infallible;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};
use tribodyn::CaseFile;
use tribodyn_bearing::{RunInputs, Scheme};
use tribodyn_dynamics::{
    BallDetail, DynamicsError, Ending as Advanced, Event, EventKind, Observer, Run, RunError as Advance, Sample,
};
use tribodyn_record::{RunRecorder, RunRecording};

/// Wall time between looks at the caller.
const LOOK_EVERY: Duration = Duration::from_millis(50);
/// Wall time between checkpoints: half of the second that a kill may cost, the other half is for a slow disk.
const CHECKPOINT_EVERY: Duration = Duration::from_millis(500);
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

/// A run that can begin: its case and the files of an earlier run are accepted, nothing but a lock is written yet. No
/// other process can write the same recording until this or its session is dropped.
///
/// ```no_run
/// use std::ops::ControlFlow;
/// use tribodyn::Limits;
/// use tribodyn_study::read_case;
/// use tribodyn_study::run::{Beginning, PreparedRun};
///
/// let file = read_case("case.ron".as_ref(), &[], &Limits::NORMAL)?;
/// let prepared = PreparedRun::new(&file, "run.mcap".as_ref(), Beginning::New)?;
/// let outcome = prepared.begin(None)?.complete(|_time_s| ControlFlow::Continue(()))?;
/// assert!(outcome.stopped.is_none() && outcome.report.summary.is_some());
/// # Ok::<(), tribodyn_study::StudyError>(())
/// ```
pub struct PreparedRun<'a> {
    file: &'a CaseFile,
    run: Run,
    inputs: RunInputs,
    files: Files,
    saved: Option<Saved>,
    lock: OutputLock,
}

impl<'a> PreparedRun<'a> {
    /// For a recording at a path; it is `<recording>.active` until it is whole, with a checkpoint beside it.
    ///
    /// # Errors
    /// Another process writes the recording, the case cannot be run, or the files of an earlier run forbid this
    /// beginning.
    pub fn new(file: &'a CaseFile, recording: &Path, beginning: Beginning) -> Result<Self, StudyError> {
        let lock = OutputLock::take(recording)?;
        let files = Files::new(recording);
        let saved = earlier(beginning, &files, &file.text)?;
        let (run, inputs) = start_run(file)?;
        Ok(Self { file, run, inputs, files, saved, lock })
    }

    /// Opens the recording; `viewers` get all of it as it is written.
    ///
    /// # Errors
    /// The recording cannot be written, or the earlier one cannot be read.
    pub fn begin(self, viewers: Option<Box<dyn Viewers>>) -> Result<RunSession<'a>, StudyError> {
        let Self { file, mut run, inputs, files, saved, lock } = self;
        let known = KnownAtStart::of(&run, file);
        let begun = Begun { file, inputs: &inputs, scheme: run.scheme(), known: &known };
        let recorder = match saved {
            None => begun.start(&files, viewers),
            Some(saved) => begun.resume(&mut run, &files, saved, viewers),
        }?;
        let from_s = run.time();
        let keeper = Keeper { checkpoint: files.checkpoint.clone(), case_text: file.text.clone() };
        if from_s > 0.0 {
            // The new recording holds everything up to here; from now on a kill may take what comes after it.
            keeper.save(&recorder, run.checkpoint(), from_s).map_err(|failed| failed.into_error(&files))?;
        }
        let recording = Recording::start(recorder, keeper).map_err(|source| StudyError::NoThread { source })?;
        Ok(RunSession { file, known, from_s, run, files, recording, _lock: lock })
    }
}

impl Failed {
    fn into_error(self, files: &Files) -> StudyError {
        let (simulated_s, Files { checkpoint, active, .. }) = (self.simulated_s, files.clone());
        match self.reason {
            Reason::Recording(source) => StudyError::NotRecorded { simulated_s, source: Box::new(source), active },
            Reason::Checkpoint(source) => StudyError::NoCheckpoint { simulated_s, checkpoint, source, active },
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
    known: KnownAtStart,
    /// Simulated time at which this part of the run begins, s.
    from_s: f64,
    run: Run,
    files: Files,
    recording: Recording,
    /// Let go of after everything else.
    _lock: OutputLock,
}

/// Data that a recording begins with.
struct Begun<'a> {
    file: &'a CaseFile,
    inputs: &'a RunInputs,
    scheme: Scheme,
    known: &'a KnownAtStart,
}

impl Begun<'_> {
    fn start(&self, files: &Files, viewers: Option<Box<dyn Viewers>>) -> Result<Recorder, StudyError> {
        for old in [&files.checkpoint, &files.active, &files.earlier] {
            remove(old)?;
        }
        self.record(files, viewers)
    }

    fn resume(
        &self,
        run: &mut Run,
        files: &Files,
        saved: Saved,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<Recorder, StudyError> {
        resume::set_aside(files)?;
        let mut recorder = self.record(files, viewers)?;
        resume::copy(files, &saved, recorder.sink_mut())?;
        recorder.remember(saved.recorder)?;
        let resumed = run.resume(saved.run);
        resumed.map_err(|source| StudyError::CannotStart { file: self.file.name.clone(), source })?;
        // The new file holds what the checkpoint counts and more. A newer checkpoint would count on messages that only
        // the new one has, and with the old file still there a resumption would look for them in that.
        remove(&files.earlier)?;
        Ok(recorder)
    }

    fn record(&self, files: &Files, viewers: Option<Box<dyn Viewers>>) -> Result<Recorder, StudyError> {
        let tape = Tape::create(&files.recording, &self.file.case, viewers)?;
        let recording = RunRecording {
            case_text: &self.file.text,
            name: &self.file.case.name,
            inputs: self.inputs,
            scheme: self.scheme,
            facts: &self.known.entries(),
            warnings: &self.known.warnings_at_start,
            generator: GENERATOR,
        };
        Ok(RunRecorder::new(tape, &recording)?)
    }
}

impl RunSession<'_> {
    /// Simulated time, s.
    pub fn time_s(&self) -> f64 {
        self.run.time()
    }

    /// Simulated time at the end, s.
    pub fn duration_s(&self) -> f64 {
        self.run.duration()
    }

    /// Runs to the end of the duration and closes the recording. `progress` gets the simulated time, s, about twenty
    /// times a second of wall time; a break stops the run there, with a checkpoint from which it can be taken up again.
    ///
    /// # Errors
    /// The solver or the disk fails; what was recorded before is kept.
    pub fn complete(mut self, progress: impl FnMut(f64) -> ControlFlow<()>) -> Result<RunOutcome, StudyError> {
        let began = Instant::now();
        let ending = self.go(progress);
        self.finish(ending, began)
    }

    /// Steps to the end of the duration, or to a stop. What cannot be recorded is a stop too; the recorder tells it.
    fn go(&mut self, mut progress: impl FnMut(f64) -> ControlFlow<()>) -> Ending {
        let mut clock = Clock { looked: Instant::now(), saved: Instant::now(), stopped: false };
        loop {
            let mut watch = Watch { recording: &mut self.recording, progress: &mut progress, clock: &mut clock };
            match self.run.advance(f64::INFINITY, &mut watch) {
                // A step beyond its stability is among the warnings of the log.
                Ok(Advanced::Complete | Advanced::BeyondStability { .. }) => return Ending::Complete,
                Ok(Advanced::Stopped) => self.recording.save(self.run.checkpoint(), self.run.time()),
                Err(Advance::Dynamics(error)) => return Ending::BrokenOff(error),
            }
            if clock.stopped || self.recording.has_failed() {
                return Ending::Stopped;
            }
            clock.saved = Instant::now();
        }
    }

    /// Closes the recording, whatever the ending. The wall time of the run is that until all is recorded.
    fn finish(self, ending: Ending, began: Instant) -> Result<RunOutcome, StudyError> {
        let Self { file, known, from_s, run, files, recording, _lock } = self;
        let time_s = run.time();
        let mut recorder = recording.end().map_err(|failed| failed.into_error(&files))?;
        let wall_s = began.elapsed().as_secs_f64();
        let not_recorded =
            |source| Failed { simulated_s: time_s, reason: Reason::Recording(source) }.into_error(&files);
        if let Ending::BrokenOff(error) = &ending {
            let kind = EventKind::Warning { message: format!("the run was broken off: {error}") };
            recorder.event(&Event { time_s, kind }).map_err(not_recorded)?;
        }
        let outcome = KnownAtEnd::of(&run);
        recorder.conclude(&outcome.entries()).map_err(not_recorded)?;
        let report = RunReport::begin(&run, file, (known, outcome), wall_s);
        let tally = recorder.finish().map_err(not_recorded)?;
        if !matches!(ending, Ending::Stopped) {
            remove(&files.checkpoint)?;
        }
        if let Ending::BrokenOff(source) = ending {
            let recording = files.recording.clone();
            return Err(StudyError::BrokenOff { file: file.name.clone(), source: Box::new(source), recording });
        }
        let duration_s = run.duration();
        let stopped = matches!(ending, Ending::Stopped).then_some(Stopped { simulated_s: time_s, duration_s });
        Ok(RunOutcome { report: report.complete(&files.recording, &file.case, &tally, from_s)?, stopped })
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

/// Hands all to the recorder, and looks at the clock after each step.
struct Watch<'a, P> {
    recording: &'a mut Recording,
    progress: &'a mut P,
    clock: &'a mut Clock,
}

/// When the caller and the disk had their turn, and whether the caller has stopped the run.
struct Clock {
    looked: Instant,
    saved: Instant,
    stopped: bool,
}

impl<P: FnMut(f64) -> ControlFlow<()>> Observer for Watch<'_, P> {
    type Error = Infallible;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Infallible> {
        self.recording.sample(sample, with_balls)
    }

    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        self.recording.event(event)
    }

    fn between(&self) -> BallDetail {
        self.recording.between()
    }

    fn stepped(&mut self, time_s: f64) -> ControlFlow<()> {
        let now = Instant::now();
        if now.duration_since(self.clock.looked) >= LOOK_EVERY {
            self.clock.looked = now;
            self.clock.stopped = (self.progress)(time_s).is_break();
            // Viewers see what there is, however slowly the samples come.
            self.recording.hand_over();
        }
        let due = now.duration_since(self.clock.saved) >= CHECKPOINT_EVERY;
        let ends = due || self.clock.stopped || self.recording.has_failed();
        if ends { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
