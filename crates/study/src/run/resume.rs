//! Taking up a run: the old recording is copied into a new one up to the checkpoint, which has the memories of solver
//! and recorder.

use super::checkpoint::{Files, Saved};
use super::tape::{Tape, from_hex};
use crate::error::StudyError;
use std::fs;
use tribodyn_record::{RecordError, Sink, recover};

/// Makes `files.earlier` the recording that the checkpoint belongs to, whole; `.active` is free afterwards.
pub(crate) fn set_aside(files: &Files) -> Result<(), StudyError> {
    // One that stands there already is of a resumption that was stopped before its first checkpoint.
    if files.earlier.exists() {
        return Ok(());
    }
    let source = if files.active.exists() { &files.active } else { &files.recording };
    recover(source, &files.earlier)?;
    Ok(())
}

/// Writes what was recorded up to the checkpoint.
pub(crate) fn copy(files: &Files, saved: &Saved, tape: &mut Tape) -> Result<(), StudyError> {
    let read = |source| StudyError::Read { path: files.earlier.clone(), source };
    let bytes = fs::read(&files.earlier).map_err(read)?;
    let damaged = |source| RecordError::Mcap { action: "read", path: files.earlier.clone(), source };
    let mut copied = 0;
    for message in mcap::MessageStream::new(&bytes).map_err(damaged)?.take(saved.safe_messages as usize) {
        let message = message.map_err(damaged)?;
        let channel = tape.channel(&message.channel.topic).ok_or_else(|| lost(files, copied, saved))?;
        tape.take_up(channel, message.log_time, &message.data)?;
        copied += 1;
    }
    if copied < saved.safe_messages {
        return Err(lost(files, copied, saved));
    }
    for loose in &saved.loose_messages {
        let data = from_hex(&loose.hex).ok_or_else(|| lost(files, copied, saved))?;
        tape.take_up(loose.channel, loose.log_time_ns, &data)?;
    }
    // From now on a reader of the new file sees all of it.
    tape.flush()?;
    Ok(())
}

fn lost(files: &Files, found: u64, saved: &Saved) -> StudyError {
    StudyError::Incomplete { path: files.earlier.clone(), found, expected: saved.safe_messages }
}
