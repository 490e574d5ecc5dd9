//! Readers of files and messages from elsewhere, each as a function of bytes that must neither panic nor take long.

use super::seeds;
use super::target::Target;
use crate::error::Failure;
use serde_json::Value;
use std::fmt::Write;
use std::io::Cursor;
use std::path::Path;
use tribodyn::answers::Equations;
use tribodyn::{CaseFile, Limits};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Checkpoint, Run};
use tribodyn_identify::Problem;
use tribodyn_record::{RunReader, RunRecorder, RunRecording, StreamSink, recover_stream};
use tribodyn_study::evaluation::published::is_figures;
use tribodyn_study::sweep::{Grid, Setting};

/// A target with what it needs besides its input.
pub struct Subject {
    target: Target,
    case: Case,
    run: Option<Run>,
    /// Run and recorder of the checkpoint that all others are made of, with what was answered: most changes leave one
    /// of the two alone.
    known: [Option<(Value, u64)>; 2],
}

impl Subject {
    pub fn new(target: Target) -> Result<Self, Failure> {
        let case = Case::from_ron(&seeds::RUN_CASE).map_err(seeds::refused)?;
        let run = match target {
            Target::Checkpoint => Some(Run::new(case.run_inputs().map_err(seeds::failed)?).map_err(seeds::failed)?),
            _ => None,
        };
        Ok(Self { target, run, case, known: [None, None] })
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
                match set_value(&seeds::RUN_CASE, path, value) {
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
        let Ok(mut value) = serde_json::from_slice::<Value>(body) else { return u64::from(whole) };
        let mut part = |name: &str| value.get_mut(name).map(Value::take).unwrap_or_default();
        let parts = [part("run"), part("recorder")];
        let mut answer = 2;
        for (k, part) in parts.into_iter().enumerate() {
            if let Some((_, known)) = self.known[k].as_ref().filter(|(known, _)| *known == part) {
                answer ^= known;
                continue;
            }
            let first = self.known[k].is_none().then(|| part.clone());
            let told = if k == 0 { self.resumed(part) } else { self.remembered(part) };
            answer ^= told;
            self.known[k] = first.map(|part| (part, told)).or(self.known[k].take());
        }
        answer
    }

    /// A run that goes on from a checkpoint, where that is accepted.
    fn resumed(&mut self, part: Value) -> u64 {
        let (Some(run), Ok(checkpoint)) = (&mut self.run, serde_json::from_value::<Checkpoint>(part)) else { return 0 };
        match run.resume(checkpoint) {
            Ok(()) => {
                let until = run.time() + 1e-5;
                // What the solver says of a strange state is its answer; it must only come.
                kind(&run.advance(until, &mut Nobody).is_ok())
            }
            Err(error) => kind(&error.to_string()),
        }
    }

    /// A recorder that goes on with a memory, where that is accepted.
    fn remembered(&self, part: Value) -> u64 {
        let Ok(memory) = serde_json::from_value(part) else { return 0 };
        let Ok(inputs) = &self.case.run_inputs() else { return 0 };
        let input = RunRecording::new(&seeds::RUN_CASE, &self.case.name, inputs, "tribodyn fuzz");
        let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
        let Ok(mut recorder) = RunRecorder::new(sink, &input) else { return 0 };
        let told = kind(&recorder.remember(memory).map_err(|error| error.to_string()));
        told ^ kind(&recorder.finish().is_ok())
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
            let grid = Grid::new("case", seeds::RUN_CASE.clone(), &[setting], (Equations::Traction, &Limits::NORMAL));
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

/// Characters of an answer that tell its kind.
const TOLD: usize = 120;

/// A number for an answer, figures left out: FNV-1a, 64 bits. The rest of a long answer is not even written.
fn kind(answer: &impl std::fmt::Debug) -> u64 {
    let mut hash = Hash { value: 0xcbf2_9ce4_8422_2325, left: TOLD };
    // An error is the end of what is looked at.
    let _ = write!(hash, "{answer:?}");
    hash.value
}

struct Hash {
    value: u64,
    left: usize,
}

impl Write for Hash {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        for byte in text.bytes().filter(|byte| !byte.is_ascii_digit()) {
            self.left = self.left.checked_sub(1).ok_or(std::fmt::Error)?;
            self.value = (self.value ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_kinds_are_told_by_words_and_not_by_figures_or_ends() {
        assert_eq!(kind(&"line 12 of 5"), kind(&"line 7 of 112"));
        assert_ne!(kind(&"line 12"), kind(&"lane 12"));
        let long = |end: &str| "a".repeat(TOLD) + end;
        assert_eq!(kind(&long("b")), kind(&long("c")));
    }
}
