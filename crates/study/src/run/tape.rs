//! Where the messages of a run go: the file, and a memory of those that a kill could still take from it.

use super::tally::Tally;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tribodyn_case::Case;
use tribodyn_record::{BallRow, Channel, FileSink, Preamble, RecordError, RunItem, Sink, StateRow};

/// A message that may not have reached the file yet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Loose {
    /// Place of the topic among the topics of a run.
    pub channel: usize,
    pub log_time_ns: u64,
    /// The encoded message as hexadecimal digits, which JSON can hold.
    pub hex: String,
}

/// Who watches a run as it goes, besides the file; called from the thread that records.
pub trait Viewers: Send {
    /// Takes what stands before all messages.
    ///
    /// # Errors
    /// The run ends.
    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError>;
    /// Takes a message of a topic, by its place in the preamble, at a time in ns.
    ///
    /// # Errors
    /// The run ends.
    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError>;
    /// Takes the end of the run.
    ///
    /// # Errors
    /// The run ends without its report.
    fn finish(self: Box<Self>) -> Result<(), RecordError>;
}

/// Bytes of messages after which a chunk is closed, at the latest: they bound the size of a checkpoint. About what the
/// writer puts into a chunk; the bytes of a file must depend on what is written, not on when.
const LOOSE_BYTES: usize = 1 << 20;

/// The sink of a run's recorder.
pub(crate) struct Tape {
    /// None once finished.
    file: Option<FileSink>,
    viewers: Option<Box<dyn Viewers>>,
    channels: &'static [Channel],
    tally: Tally,
    /// Messages that the last flush made safe.
    safe: u64,
    /// Those after it: channel, log time, and where their bytes end.
    loose: Vec<(usize, u64, usize)>,
    loose_bytes: Vec<u8>,
}

impl Tape {
    /// Creates `<path>.active` for a run of a case.
    pub fn create(path: &Path, case: &Case, viewers: Option<Box<dyn Viewers>>) -> Result<Self, RecordError> {
        Ok(Self {
            file: Some(FileSink::create(path)?),
            viewers,
            channels: &[],
            tally: Tally::new(case),
            safe: 0,
            loose: Vec::new(),
            loose_bytes: Vec::new(),
        })
    }

    /// Place of a topic among those of a run.
    pub fn channel(&self, topic: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.topic == topic)
    }

    /// Messages in the file that no kill can take, and those after them.
    pub fn state(&self) -> (u64, Vec<Loose>) {
        let mut start = 0;
        let loose = self.loose.iter().map(|&(channel, log_time_ns, end)| {
            let data = &self.loose_bytes[std::mem::replace(&mut start, end)..end];
            Loose { channel, log_time_ns, hex: to_hex(data) }
        });
        (self.safe, loose.collect())
    }

    /// Takes a message of an earlier recording of the run.
    pub fn take_up(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.tally.add(&self.channels[channel], data)?;
        self.write(channel, log_time, data)
    }

    fn write(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.file()?.message(channel, log_time, data)?;
        if let Some(viewers) = &mut self.viewers {
            viewers.message(channel, log_time, data)?;
        }
        self.loose_bytes.extend_from_slice(data);
        self.loose.push((channel, log_time, self.loose_bytes.len()));
        if self.loose_bytes.len() >= LOOSE_BYTES { self.flush() } else { Ok(()) }
    }

    fn file(&mut self) -> Result<&mut FileSink, RecordError> {
        self.file.as_mut().ok_or(RecordError::NotBegun)
    }
}

impl Sink for Tape {
    type Output = Tally;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.channels = preamble.channels;
        if let Some(viewers) = &mut self.viewers {
            viewers.begin(preamble)?;
        }
        self.file()?.begin(preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        let kind = &self.channels[channel];
        if !RunItem::is_of_samples(kind.schema) {
            self.tally.add(kind, data)?;
        }
        self.write(channel, log_time, data)
    }

    fn state(&mut self, row: &StateRow) {
        self.tally.add_state(row);
    }

    fn balls(&mut self, rows: &[BallRow]) {
        self.tally.add_balls(rows);
    }

    fn outcome(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        self.file()?.outcome(entries)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file()?.flush()?;
        self.safe += self.loose.len() as u64;
        self.loose.clear();
        self.loose_bytes.clear();
        Ok(())
    }

    fn finish(self) -> Result<Tally, RecordError> {
        self.file.ok_or(RecordError::NotBegun)?.finish()?;
        self.viewers.map_or(Ok(()), Viewers::finish)?;
        Ok(self.tally)
    }
}

fn to_hex(data: &[u8]) -> String {
    const DIGITS: &[u8; 16] = b"0123456789abcdef";
    let digits = data.iter().flat_map(|byte| [byte >> 4, byte & 15]);
    digits.map(|digit| char::from(DIGITS[usize::from(digit)])).collect()
}

/// The bytes behind an even number of hexadecimal digits.
pub(crate) fn from_hex(text: &str) -> Option<Vec<u8>> {
    let digit = |c: &u8| char::from(*c).to_digit(16).map(|d| d as u8);
    let pair = |pair: &[u8]| Some(digit(pair.first()?)? << 4 | digit(pair.get(1)?)?);
    text.as_bytes().chunks(2).map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::{from_hex, to_hex};

    #[test]
    fn identity_hexadecimal_digits_give_the_bytes_back() {
        let bytes: Vec<u8> = (0..=255).collect();
        assert_eq!(from_hex(&to_hex(&bytes)), Some(bytes));
        assert_eq!((from_hex("0"), from_hex("0g"), from_hex("")), (None, None, Some(Vec::new())));
    }
}
