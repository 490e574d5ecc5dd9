//! `tribodyn run`: a transient run, recorded.
//!
//! The run goes in slices of about a millisecond of simulated time whose ends depend on the case alone: between them the
//! program looks for an interrupt and, about once a second of wall time, writes a checkpoint. Neither changes a step, so
//! that a resumed run makes the samples of one that was never stopped.

mod checkpoint;
mod error;
#[cfg(feature = "live")]
mod live;
mod outcome;
mod progress;
mod resume;
mod settled;
mod summary;
mod tape;
pub mod warnings;

pub use error::RunError;
pub use summary::{Summary, acceleration, carries_accelerations, imbalance};

use crate::failure::Failure;
use crate::input::CaseArguments;
use crate::solve::check_output;
use crate::table;
use checkpoint::{Files, Saved};
use progress::Progress;
use signal_hook::consts::{SIGINT, SIGTERM};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tape::{SharedTape, Viewers};
use tribodyn_bearing::case::{Case, SchemeSpec};
use tribodyn_dynamics::{DynamicsError, Event, EventKind, Observer, Run, RunError as Advance};
use tribodyn_record::{RecordError, RunRecorder, RunRecording};
use tribodyn_study::{CaseFile, Change, StudyError};

/// Run a bearing in time and record it.
#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Recording to write (MCAP, opens in Foxglove); RUN.mcap.active until it is whole
    #[arg(short, long, value_name = "RUN.mcap")]
    output: PathBuf,
    /// Simulated time in s; short for --set transient.duration=s(…)
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    duration: Option<f64>,
    /// Go on with a run of the same case that was stopped or killed
    #[arg(long, conflicts_with = "restart")]
    resume: bool,
    /// Forget a run of before that was stopped or killed
    #[arg(long)]
    restart: bool,
    /// Let viewers such as Foxglove watch over a WebSocket, on this machine only unless an address says otherwise
    #[cfg(feature = "live")]
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, require_equals = true, default_missing_value = live::ADDRESS)]
    live: Option<String>,
    /// Show no progress
    #[arg(short, long)]
    quiet: bool,
    /// Print the summary as JSON, and nothing else, to standard output
    #[arg(long)]
    json: bool,
}

/// Simulated time between looks at the clock and at signals, s.
const SLICE_S: f64 = 1e-3;
/// Wall time between checkpoints.
const CHECKPOINT_EVERY: Duration = Duration::from_secs(1);
const GENERATOR: &str = concat!("tribodyn ", env!("CARGO_PKG_VERSION"));

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let duration = arguments
        .duration
        .map(|seconds| Change::new(format!("--duration {seconds}"), "transient.duration", &format!("s({seconds})")));
    let changes: Vec<Change> = arguments.case.changes.iter().cloned().chain(duration).collect();
    let file = CaseFile::read(&arguments.case.path, &changes).map_err(|error| match error {
        // Only a section can be missing on the way to a duration: the news is that, and not the path.
        StudyError::Change { ref option, .. } if option.starts_with("--duration") => RunError::CannotStart {
            file: arguments.case.path.display().to_string(),
            source: DynamicsError::Missing { path: "transient" },
        }
        .into(),
        other => Failure::from(other),
    })?;
    check_output(&arguments.output, &arguments.case.path, "recording")?;
    let files = Files::new(&arguments.output);
    let saved = earlier(arguments, &files, &file.text)?;
    let cannot_start = |source| RunError::CannotStart { file: file.name.clone(), source };
    let run = Run::new(&file.case).map_err(cannot_start)?;
    let stop = stop_flag()?;
    #[cfg(feature = "live")]
    let viewers = arguments.live.as_deref().map(live::start).transpose()?;
    #[cfg(not(feature = "live"))]
    let viewers = None;
    let mut session = match saved {
        None => Session::start(&file, run, files, viewers)?,
        Some(saved) => Session::resume(&file, run, files, saved, viewers)?,
    };
    let progress = Progress::new(arguments.quiet, session.run.duration(), session.run.time());
    let ending = session.go(&file, &stop, &progress)?;
    let took = (progress.from_s, progress.wall_s());
    drop(progress);
    let outcome = session.finish(&file, ending, took)?;
    if arguments.json {
        table::print_json(&outcome.report)?;
    } else {
        outcome.print()?;
    }
    outcome.stopped.map_or(Ok(()), |stopped| Err(stopped.into()))
}

/// The checkpoint to go on from; refuses to lose a run that nobody asked to forget.
fn earlier(arguments: &Arguments, files: &Files, case_text: &str) -> Result<Option<Saved>, Failure> {
    if arguments.resume {
        if !files.checkpoint.exists() {
            return Err(RunError::NothingToResume { path: files.checkpoint.clone() }.into());
        }
        return Saved::read(&files.checkpoint, case_text).map(Some);
    }
    if !arguments.restart
        && let Some(path) = [&files.checkpoint, &files.active, &files.earlier].into_iter().find(|path| path.exists())
    {
        return Err(RunError::Unfinished { path: path.clone() }.into());
    }
    Ok(None)
}

/// Set by the first interrupt or request to terminate; the second one ends the program at once.
fn stop_flag() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        signal_hook::flag::register_conditional_shutdown(signal, 1, Arc::clone(&flag)).map_err(Failure::Output)?;
        signal_hook::flag::register(signal, Arc::clone(&flag)).map_err(Failure::Output)?;
    }
    Ok(flag)
}

/// How the stepping ended.
enum Ending {
    Complete,
    Stopped,
    BrokenOff(DynamicsError),
}

/// A run with its recording.
struct Session {
    run: Run,
    files: Files,
    tape: SharedTape,
    recorder: RunRecorder<SharedTape>,
    slices: Slices,
}

impl Session {
    fn start(file: &CaseFile, run: Run, files: Files, viewers: Option<Box<dyn Viewers>>) -> Result<Self, Failure> {
        for old in [&files.checkpoint, &files.active, &files.earlier] {
            remove(old)?;
        }
        let (tape, recorder) = Self::record(file, &files, viewers)?;
        Ok(Self { slices: Slices::new(&file.case), run, files, tape, recorder })
    }

    fn resume(
        file: &CaseFile,
        mut run: Run,
        files: Files,
        saved: Saved,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<Self, Failure> {
        resume::set_aside(&files)?;
        let (tape, mut recorder) = Self::record(file, &files, viewers)?;
        resume::copy(&files, &saved, &tape)?;
        recorder.remember(saved.recorder)?;
        let resumed = run.resume(saved.run);
        resumed.map_err(|source| RunError::CannotStart { file: file.name.clone(), source })?;
        let session = Self { slices: Slices::new(&file.case), run, files, tape, recorder };
        // The new file holds everything from here on.
        session.save(&file.text)?;
        remove(&session.files.earlier)?;
        Ok(session)
    }

    fn record(
        file: &CaseFile,
        files: &Files,
        viewers: Option<Box<dyn Viewers>>,
    ) -> Result<(SharedTape, RunRecorder<SharedTape>), Failure> {
        let tape = SharedTape::create(&files.recording, viewers)?;
        let recording = RunRecording { case_text: &file.text, case: &file.case, generator: GENERATOR };
        Ok((tape.clone(), RunRecorder::new(tape, &recording)?))
    }

    /// Steps to the end of the duration, or to an interrupt.
    fn go(&mut self, file: &CaseFile, stop: &AtomicBool, progress: &Progress) -> Result<Ending, Failure> {
        let mut saved = Instant::now();
        loop {
            let until = self.slices.after(self.run.time());
            match self.run.advance(until, &mut self.recorder) {
                Ok(_) => progress.show(self.run.time()),
                Err(Advance::Dynamics(error)) => return Ok(Ending::BrokenOff(error)),
                Err(Advance::Observer(error)) => return Err(self.not_recorded(error).into()),
            }
            if until >= self.run.duration() {
                return Ok(Ending::Complete);
            }
            let stopped = stop.load(Ordering::Relaxed);
            if stopped || saved.elapsed() >= CHECKPOINT_EVERY {
                self.save(&file.text)?;
                saved = Instant::now();
            }
            if stopped {
                return Ok(Ending::Stopped);
            }
        }
    }

    fn not_recorded(&self, source: RecordError) -> RunError {
        let active = self.files.active.clone();
        RunError::NotRecorded { simulated_s: self.run.time(), source: Box::new(source), active }
    }

    fn save(&self, case_text: &str) -> Result<(), RunError> {
        let saved = Saved::new(case_text, &self.run, self.recorder.memory(), &self.tape);
        let written = saved.write(&self.files.checkpoint);
        written.map_err(|source| {
            let Files { checkpoint, active, .. } = self.files.clone();
            RunError::NoCheckpoint { simulated_s: self.run.time(), checkpoint, source, active }
        })
    }

    /// Closes the recording, whatever the ending.
    fn finish(
        mut self,
        file: &CaseFile,
        ending: Ending,
        (from_s, wall_s): (f64, f64),
    ) -> Result<outcome::Outcome, Failure> {
        let time_s = self.run.time();
        if let Ending::BrokenOff(error) = &ending {
            let kind = EventKind::Warning { message: format!("the run was broken off: {error}") };
            self.recorder.event(&Event { time_s, kind }).map_err(|error| self.not_recorded(error))?;
        }
        let report = outcome::Report::begin(&self.run, file, wall_s);
        let (files, duration_s) = (self.files.clone(), self.run.duration());
        let not_recorded = |source| RunError::NotRecorded {
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
            return Err(RunError::BrokenOff { file: file.name.clone(), source, recording }.into());
        }
        let stopped =
            matches!(ending, Ending::Stopped).then_some(RunError::Stopped { simulated_s: time_s, duration_s });
        Ok(outcome::Outcome { report: report.complete(&files.recording, &file.case, from_s)?, stopped })
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

/// Samples where the case does not say how many, Hz.
const STATE_RATE: f64 = 25_600.0;

impl Slices {
    fn new(case: &Case) -> Self {
        let rate = case.recording.map_or(STATE_RATE, |recording| recording.state_rate);
        let unit = match case.transient.as_ref().map(|transient| transient.scheme) {
            Some(SchemeSpec::RungeKutta4 { step }) => step,
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
