//! Recordings that were cut off or damaged, made whole.

use crate::error::StudyError;
use crate::ours::Ours;
use serde::Serialize;
use std::path::{Path, PathBuf};
use tribodyn_record::Damage;

/// Result of recovering a recording.
#[derive(Debug, Clone, Serialize)]
pub struct Recovered {
    /// The damaged recording.
    pub recording: PathBuf,
    /// The whole one.
    pub output: PathBuf,
    /// Messages saved.
    pub messages: u64,
    /// Messages of unknown topics, which are left out.
    pub messages_lost: u64,
    /// Simulated time of the last message, s.
    pub simulated_s: f64,
    /// Damage that was found.
    #[serde(flatten)]
    pub damage: Damage,
}

/// Makes a whole recording of one that was cut off or damaged; `output` may be the damaged one itself.
///
/// # Errors
/// The file at `output` may not be replaced, there is nothing to recover, or a file cannot be read or written.
pub fn recover(recording: &Path, output: &Path, force: bool) -> Result<Recovered, StudyError> {
    // There is no case here that could be replaced.
    Ours::Recording.may_replace(output, Path::new(""), force)?;
    let done = tribodyn_record::recover(recording, output)?;
    Ok(Recovered {
        recording: recording.to_owned(),
        output: output.to_owned(),
        messages: done.messages,
        messages_lost: done.messages_lost,
        simulated_s: done.last_time_s(),
        damage: done.damage,
    })
}
