//! What a run leaves beside its recording so that it can be taken up again.

use super::tape::{Loose, SharedTape};
use crate::error::StudyError;
use crate::files::with_suffix;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::{Path, PathBuf};
use tribodyn_dynamics::{Checkpoint, Run};
use tribodyn_record::RecorderMemory;

/// Changes with the meaning of the fields.
const FORMAT: u32 = 3;
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// A run at a time.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Saved {
    format: u32,
    version: String,
    pub simulated_s: f64,
    /// The case that was run, changes made: another one cannot go on from here.
    case_text: String,
    pub run: Checkpoint,
    pub recorder: RecorderMemory,
    /// Messages of the recording that are safe in the file, in the order of the file.
    pub safe_messages: u64,
    /// Those after them.
    pub loose_messages: Vec<Loose>,
}

impl Saved {
    pub fn new(case_text: &str, run: &Run, recorder: &RecorderMemory, tape: &SharedTape) -> Self {
        let (safe_messages, loose_messages) = tape.state();
        Self {
            format: FORMAT,
            version: VERSION.to_owned(),
            simulated_s: run.time(),
            case_text: case_text.to_owned(),
            run: run.checkpoint(),
            recorder: recorder.clone(),
            safe_messages,
            loose_messages,
        }
    }

    /// Replaces the checkpoint; whenever the program ends, the old or the new one stands there.
    pub fn write(&self, path: &Path) -> std::io::Result<()> {
        let part = with_suffix(path, ".part");
        let written = fs::write(&part, serde_json::to_vec(self)?).and_then(|()| fs::rename(&part, path));
        if written.is_err() {
            // It may not exist; the error that counts is the first.
            let _ = fs::remove_file(&part);
        }
        written
    }

    /// The checkpoint of a run of this very case by this very version.
    pub fn read(path: &Path, case_text: &str) -> Result<Self, StudyError> {
        /// What is read first: a checkpoint of another version may have any other fields.
        #[derive(Deserialize)]
        struct Head {
            format: u32,
            version: String,
        }
        let bytes = fs::read(path).map_err(|source| StudyError::Read { path: path.to_owned(), source })?;
        let damaged = |source| StudyError::Damaged { path: path.to_owned(), source };
        let head: Head = serde_json::from_slice(&bytes).map_err(damaged)?;
        if head.format != FORMAT || head.version != VERSION {
            return Err(StudyError::OtherVersion { path: path.to_owned(), found: head.version });
        }
        let saved: Self = serde_json::from_slice(&bytes).map_err(damaged)?;
        if saved.case_text != case_text {
            let line = first_difference(&saved.case_text, case_text);
            return Err(StudyError::OtherCase { path: path.to_owned(), line });
        }
        Ok(saved)
    }
}

/// Line of the second text, from 1, at which two texts part.
fn first_difference(a: &str, b: &str) -> usize {
    1 + a.lines().zip(b.lines()).take_while(|(a, b)| a == b).count()
}

/// The files of a run.
#[derive(Debug, Clone)]
pub(crate) struct Files {
    /// The whole recording.
    pub recording: PathBuf,
    /// The recording while it grows.
    pub active: PathBuf,
    pub checkpoint: PathBuf,
    /// What a resumed run copies from, until all of it is in the new file.
    pub earlier: PathBuf,
}

impl Files {
    pub fn new(recording: &Path) -> Self {
        Self {
            recording: recording.to_owned(),
            active: with_suffix(recording, ".active"),
            checkpoint: with_suffix(recording, ".checkpoint"),
            earlier: with_suffix(recording, ".earlier"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::first_difference;

    #[test]
    fn limit_the_first_different_line_is_named() {
        assert_eq!((first_difference("a\nb\n", "a\nc\n"), first_difference("a\n", "a\nb\n")), (2, 2));
    }
}
