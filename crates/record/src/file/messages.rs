//! All messages of a recording as they stand in it, one after the other.

use crate::RecordError;
use crate::output::{file_error, open};
use crate::scan::{Record, Scanner};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;

/// Hands out the messages of a recording in the order of the file, each with topic, log time (ns since the Unix epoch)
/// and bytes, until `take` breaks or the file ends, or at the first damage: what is handed out has no gap. It takes the
/// memory of one chunk (about 1 MiB), however long the recording is.
///
/// # Errors
/// [`RecordError::File`] if the file cannot be read, [`RecordError::NotMcap`] if it is no MCAP file, and what `take`
/// gives.
pub fn read_messages<E: From<RecordError>>(
    path: &Path,
    mut take: impl FnMut(&str, u64, &[u8]) -> Result<ControlFlow<()>, E>,
) -> Result<(), E> {
    let error = |source| file_error("read", path, source);
    let scanner = Scanner::new(open(path)?).map_err(error)?;
    let mut scanner = scanner.ok_or_else(|| RecordError::NotMcap { path: path.to_owned() })?;
    let mut topics = BTreeMap::new();
    while let Some(piece) = scanner.next_piece().map_err(error)? {
        if !scanner.damage().is_none() {
            break;
        }
        for record in piece.records() {
            match record {
                Record::Channel(channel) => {
                    topics.insert(channel.id, channel.topic.to_owned());
                }
                Record::Message { channel, log_time, data, .. } => {
                    let topic = topics.get(&channel).map_or("", String::as_str);
                    if take(topic, log_time, data)?.is_break() {
                        return Ok(());
                    }
                }
                _ => {}
            }
        }
    }
    Ok(())
}
