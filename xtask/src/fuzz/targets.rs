//! Readers of files and messages from elsewhere, each as a function of bytes that must neither panic nor take long.

use super::mutate::Form;
use super::seeds;
use crate::error::Failure;
use std::io::Cursor;
use std::path::Path;
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Checkpoint, Run};
use tribodyn_identify::Problem;
use tribodyn_record::{RunReader, RunRecorder, RunRecording, StreamSink, recover_stream};
use tribodyn_study::evaluation::published::is_figures;
use tribodyn_study::sweep::{Grid, Setting};
use tribodyn_study::{CaseFile, Limits};

/// A reader of input from elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Target {
    /// The text of a case file, within the limits
    Case,
    /// A change of `--set`, PATH=VALUE
    Set,
    /// An identification problem
    Problem,
    /// A table of published figures
    Figures,
    /// The values of a sweep, and the grid that they make
    Grid,
    /// A recording, read by `report`
    Reader,
    /// A recording, recovered
    Recovery,
    /// A checkpoint, and a run that goes on from it
    Checkpoint,
    /// A message of a live viewer
    Live,
}

impl Target {
    pub const ALL: [Self; 9] = [
        Self::Case,
        Self::Set,
        Self::Problem,
        Self::Figures,
        Self::Grid,
        Self::Reader,
        Self::Recovery,
        Self::Checkpoint,
        Self::Live,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Case => "case",
            Self::Set => "set",
            Self::Problem => "problem",
            Self::Figures => "figures",
            Self::Grid => "grid",
            Self::Reader => "reader",
            Self::Recovery => "recovery",
            Self::Checkpoint => "checkpoint",
            Self::Live => "live",
        }
    }

    pub fn form(self) -> Form {
        if matches!(self, Self::Reader | Self::Recovery) { Form::Binary } else { Form::Text }
    }
}

/// A target with what it needs besides its input.
pub struct Subject {
    target: Target,
    case: Case,
    run: Option<Run>,
}

impl Subject {
    pub fn new(target: Target) -> Result<Self, Failure> {
        let case = Case::from_ron(seeds::RUN_CASE).map_err(seeds::refused)?;
        let run = match target {
            Target::Checkpoint => Some(Run::new(case.run_inputs().map_err(seeds::failed)?).map_err(seeds::failed)?),
            _ => None,
        };
        Ok(Self { target, run, case })
    }

    /// Reads an input. The number tells kinds of answers apart: an input with a new one is worth further changes.
    pub fn read(&mut self, input: &[u8]) -> u64 {
        let text = || String::from_utf8_lossy(input);
        match self.target {
            Target::Case => match CaseFile::from_text("case", text().into_owned(), &[], &Limits::NORMAL) {
                Ok(file) => kind(&file.bearing().map(|_| ()).map_err(|error| error.to_string())),
                Err(error) => kind(&error.to_string()),
            },
            Target::Set => {
                let text = text();
                let (path, value) = text.split_once('=').unwrap_or((&text, ""));
                match set_value(seeds::RUN_CASE, path, value) {
                    Ok(changed) => kind(&Case::from_ron(&changed).map(|_| ()).map_err(|error| error.to_string())),
                    Err(error) => kind(&error.to_string()),
                }
            }
            Target::Problem => kind(&Problem::from_ron(&text()).map(|_| ()).map_err(|error| error.to_string())),
            Target::Figures => kind(&is_figures(&text())),
            Target::Grid => grid(&text()),
            Target::Reader => reader(input),
            Target::Recovery => recovery(input),
            Target::Checkpoint => self.checkpoint(input),
            Target::Live => kind(&tribodyn_record::is_live_request(&text())),
        }
    }

    /// As the file of a checkpoint, and as the run and the recorder in it, which go on where they are accepted.
    fn checkpoint(&mut self, input: &[u8]) -> u64 {
        let whole = tribodyn_study::run::is_checkpoint(input);
        let body = input.split(|byte| *byte == b'\n').nth(1).unwrap_or(input);
        let Ok(mut value) = serde_json::from_slice::<serde_json::Value>(body) else { return u64::from(whole) };
        let mut answer = 2;
        if let (Some(run), Ok(checkpoint)) = (&mut self.run, serde_json::from_value::<Checkpoint>(value["run"].take()))
        {
            answer = match run.resume(checkpoint) {
                Ok(()) => {
                    let until = run.time() + 1e-5;
                    // What the solver says of a strange state is its answer; it must only come.
                    kind(&run.advance(until, &mut Nobody).is_ok())
                }
                Err(error) => kind(&error.to_string()),
            };
        }
        let input = RunRecording { case_text: seeds::RUN_CASE, case: &self.case, generator: "tribodyn fuzz" };
        let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
        if let (Ok(mut recorder), Ok(memory)) =
            (RunRecorder::new(sink, &input), serde_json::from_value(value["recorder"].take()))
        {
            answer ^= kind(&recorder.remember(memory).map_err(|error| error.to_string()));
            return answer ^ kind(&recorder.finish().is_ok());
        }
        answer
    }
}

/// Takes the samples of a run and keeps none.
struct Nobody;

impl tribodyn_dynamics::Observer for Nobody {
    type Error = std::convert::Infallible;

    fn sample(
        &mut self,
        _: &tribodyn_dynamics::Sample,
        _: bool,
    ) -> Result<std::ops::ControlFlow<()>, std::convert::Infallible> {
        Ok(std::ops::ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &tribodyn_dynamics::Event) -> Result<(), std::convert::Infallible> {
        Ok(())
    }
}

/// Grids of few values only are checked value by value, which takes as long as so many cases.
fn grid(text: &str) -> u64 {
    match Setting::parse(text) {
        Ok(setting) if setting.count() <= 8 => {
            let grid = Grid::new("case", seeds::RUN_CASE.to_owned(), &[setting], &Limits::NORMAL);
            kind(&grid.map(|grid| grid.rows).map_err(|error| error.to_string()))
        }
        Ok(_) => 1,
        Err(error) => kind(&error),
    }
}

fn reader(input: &[u8]) -> u64 {
    let mut reader = match RunReader::new(Cursor::new(input), Path::new("recording")) {
        Ok(reader) => reader,
        Err(error) => return kind(&error.to_string()),
    };
    let mut items = 0_u64;
    let mut answer = 0;
    for item in &mut reader {
        items += 1;
        if let Err(error) = item {
            answer ^= kind(&error.to_string());
        }
    }
    let damage = reader.damage();
    answer
        ^ kind(&(items.min(8), damage.chunks_bad.min(3), damage.bytes_lost > 0, damage.truncated, damage.summary_bad))
}

/// A recovered recording is whole: it is recovered again, without damage and with as many messages.
fn recovery(input: &[u8]) -> u64 {
    match recover_stream(Cursor::new(input), Cursor::new(Vec::new())) {
        Ok((done, whole)) => {
            let again = recover_stream(whole, Cursor::new(Vec::new())).map(|(again, _)| again);
            let same = again.as_ref().is_ok_and(|again| again.messages == done.messages && again.damage.is_none());
            assert!(same, "recovered {done:?}, and then {:?}", again.map_err(|error| error.to_string()));
            let d = done.damage;
            kind(&(
                done.messages.min(8),
                done.messages_lost.min(2),
                d.chunks_bad.min(3),
                d.messages_unchecked.min(2),
                d.truncated,
                d.summary_bad,
            ))
        }
        Err(error) => kind(&error.to_string()),
    }
}

/// A number for an answer, figures left out: FNV-1a, 64 bits.
fn kind(answer: &impl std::fmt::Debug) -> u64 {
    let text = format!("{answer:?}");
    let words = text.bytes().filter(|byte| !byte.is_ascii_digit()).take(120);
    words.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
