//! Taking up a run: the old recording is copied into a new one up to the checkpoint, which has the memories of solver
//! and recorder.

use super::checkpoint::{Files, Saved};
use super::tape::{Tape, from_hex};
use crate::error::StudyError;
use std::ops::ControlFlow;
use tribodyn_record::{Sink, read_messages, recover};

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

/// Writes what was recorded up to the checkpoint, message by message: a long recording would fill the memory.
pub(crate) fn copy(files: &Files, saved: &Saved, tape: &mut Tape) -> Result<(), StudyError> {
    let mut copied = 0;
    read_messages(&files.earlier, |topic, log_time, data| {
        if copied == saved.safe_messages {
            return Ok(ControlFlow::Break(()));
        }
        let channel = tape.channel(topic).ok_or_else(|| lost(files, copied, saved))?;
        tape.take_up(channel, log_time, data)?;
        copied += 1;
        Ok::<_, StudyError>(ControlFlow::Continue(()))
    })?;
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
