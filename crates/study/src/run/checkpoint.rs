//! The checkpoint of a run: a file beside its recording, from which it can be taken up again.
//!
//! The file is two lines of JSON: a head with format, version, length and checksum of the second line, and the run.

use super::tape::{Loose, Tape};
use crate::error::StudyError;
use crate::files::{read_at_most, with_suffix};
use serde::{Deserialize, Serialize};
use std::io::Write;
use std::path::{Path, PathBuf};
use tribodyn_dynamics::Checkpoint;
use tribodyn_record::{RecorderMemory, RunRecorder, TemporaryFile};

/// Changes with the meaning of the fields.
pub(crate) const FORMAT: u32 = 17;
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Longest file that is read, bytes: that of a run with a thousand balls has 20 MB.
const LONGEST: u64 = 256 << 20;

/// The first line of the file. Of older formats, which were one line, it is read alone: they may have any other fields.
#[derive(Debug, Serialize, Deserialize)]
struct Head {
    format: u32,
    version: String,
    /// Of the second line.
    #[serde(default)]
    bytes: u64,
    #[serde(default)]
    crc32: u32,
}

/// A run at a time.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Saved {
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
    /// Of a run at a time (s) whose recorder has everything up to there.
    pub fn new(case_text: &str, (simulated_s, run): (f64, Checkpoint), recorder: &RunRecorder<Tape>) -> Self {
        let (safe_messages, loose_messages) = recorder.sink().state();
        Self {
            simulated_s,
            case_text: case_text.to_owned(),
            run,
            recorder: recorder.memory().clone(),
            safe_messages,
            loose_messages,
        }
    }

    /// Replaces the checkpoint; whenever the program or the machine stops, the old or the new one stands there, whole.
    pub fn write(&self, path: &Path) -> std::io::Result<()> {
        let body = serde_json::to_vec(self)?;
        let (bytes, crc32) = (body.len() as u64, crc32fast::hash(&body));
        let head = serde_json::to_vec(&Head { format: FORMAT, version: VERSION.to_owned(), bytes, crc32 })?;
        let mut part = TemporaryFile::beside(path)?;
        part.file().write_all(&[head.as_slice(), b"\n", &body].concat())?;
        part.publish(path)
    }

    /// The checkpoint of a run of this very case by this very version.
    pub fn read(path: &Path, case_text: &str) -> Result<Self, StudyError> {
        let read = |source| StudyError::Read { path: path.to_owned(), source };
        let saved = Self::from_bytes(&read_at_most(path, LONGEST).map_err(read)?, path)?;
        if saved.case_text != case_text {
            let line = first_difference(&saved.case_text, case_text);
            return Err(StudyError::OtherCase { path: path.to_owned(), line });
        }
        Ok(saved)
    }

    /// The checkpoint in a file's bytes; `path` is for messages.
    fn from_bytes(bytes: &[u8], path: &Path) -> Result<Self, StudyError> {
        let damaged = |source| StudyError::Damaged { path: path.to_owned(), source };
        let line = bytes.iter().position(|byte| *byte == b'\n').unwrap_or(bytes.len());
        let (head, body) = (&bytes[..line], bytes.get(line + 1..).unwrap_or_default());
        let head: Head = serde_json::from_slice(head).map_err(damaged)?;
        if head.format != FORMAT || head.version != VERSION {
            return Err(StudyError::OtherVersion { path: path.to_owned(), found: head.version, format: head.format });
        }
        if head.bytes != body.len() as u64 || head.crc32 != crc32fast::hash(body) {
            let (found, expected) = (body.len() as u64, head.bytes);
            return Err(StudyError::Altered { path: path.to_owned(), found, expected });
        }
        serde_json::from_slice(body).map_err(damaged)
    }
}

/// True for bytes that are read as a checkpoint, for trials with damaged ones: none of them may do worse than be
/// refused.
#[doc(hidden)]
pub fn is_checkpoint(bytes: &[u8]) -> bool {
    Saved::from_bytes(bytes, Path::new("checkpoint")).is_ok()
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
    /// The recording that a resumed run copies from, until all of it is in the new file.
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
    use super::{FORMAT, Head, Saved, VERSION, first_difference};
    use crate::error::StudyError;
    use std::path::Path;

    fn refused(bytes: &[u8]) -> String {
        Saved::from_bytes(bytes, Path::new("run.mcap.checkpoint")).unwrap_err().to_string()
    }

    #[test]
    fn limit_an_altered_checkpoint_is_refused_by_its_checksum() {
        let body = br#"{"simulated_s":0.25}"#;
        let (bytes, crc32) = (body.len() as u64, crc32fast::hash(body));
        let head = Head { format: FORMAT, version: VERSION.to_owned(), bytes, crc32 };
        let mut file = [serde_json::to_vec(&head).unwrap().as_slice(), b"\n", body].concat();
        // The checksum fits, so it is the fields that are missing.
        assert!(matches!(Saved::from_bytes(&file, Path::new("c")), Err(StudyError::Damaged { .. })));
        let last = file.len() - 2;
        file[last] = b'6';
        assert_eq!(refused(&file), "run.mcap.checkpoint is damaged: its checksum does not match (20 of 20 bytes)");
        file.truncate(last);
        assert_eq!(refused(&file), "run.mcap.checkpoint is damaged: its checksum does not match (18 of 20 bytes)");
    }

    #[test]
    fn limit_a_checkpoint_of_another_format_is_named() {
        let old = format!(r#"{{"format":3,"version":"{VERSION}","simulated_s":0.1,"case_text":""}}"#);
        let expected = format!(
            "run.mcap.checkpoint is of version {VERSION}, format 3; this is version {VERSION}, format {FORMAT}"
        );
        assert_eq!(refused(old.as_bytes()), expected);
    }

    #[test]
    fn limit_the_first_different_line_is_named() {
        assert_eq!((first_difference("a\nb\n", "a\nc\n"), first_difference("a\n", "a\nb\n")), (2, 2));
    }
}
