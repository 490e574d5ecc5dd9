//! Where the messages of a run go: the file, and a memory of those that a kill could still take from it.

use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;
use tribodyn_record::{FileSink, Preamble, RecordError, RecordingSummary, Sink};

/// A message that may not have reached the file yet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct Loose {
    /// Place of the topic among the topics of a run.
    pub channel: usize,
    pub log_time_ns: u64,
    /// The encoded message as hexadecimal digits, which JSON can hold.
    pub hex: String,
}

/// Who watches a run as it goes, besides the file.
pub trait Viewers {
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

struct Tape {
    /// None once finished.
    file: Option<FileSink>,
    viewers: Option<Box<dyn Viewers>>,
    topics: Vec<&'static str>,
    /// Messages that the last flush made safe.
    safe: u64,
    /// Those after it: channel, log time, and where their bytes end.
    loose: Vec<(usize, u64, usize)>,
    loose_bytes: Vec<u8>,
}

/// The sink of a run's recorder, shared with the driver of the run, who asks it what is safe.
#[derive(Clone)]
pub(crate) struct SharedTape(Rc<RefCell<Tape>>);

impl SharedTape {
    /// Creates `<path>.active`.
    pub fn create(path: &Path, viewers: Option<Box<dyn Viewers>>) -> Result<Self, RecordError> {
        let file = Some(FileSink::create(path)?);
        let tape = Tape { file, viewers, topics: Vec::new(), safe: 0, loose: Vec::new(), loose_bytes: Vec::new() };
        Ok(Self(Rc::new(RefCell::new(tape))))
    }

    /// Place of a topic among those of a run.
    pub fn channel(&self, topic: &str) -> Option<usize> {
        self.0.borrow().topics.iter().position(|t| *t == topic)
    }

    /// Writes a message that was recorded before.
    pub fn put(&self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.0.borrow_mut().write(channel, log_time, data)
    }

    /// Closes the chunk and counts all messages as safe.
    pub fn flush(&self) -> Result<(), RecordError> {
        self.0.borrow_mut().flush()
    }

    /// Messages in the file that no kill can take, and those after them.
    pub fn state(&self) -> (u64, Vec<Loose>) {
        let tape = self.0.borrow();
        let mut start = 0;
        let loose = tape.loose.iter().map(|&(channel, log_time_ns, end)| {
            let data = &tape.loose_bytes[std::mem::replace(&mut start, end)..end];
            Loose { channel, log_time_ns, hex: to_hex(data) }
        });
        (tape.safe, loose.collect())
    }
}

impl Tape {
    fn write(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.file.as_mut().ok_or(RecordError::NotBegun)?.message(channel, log_time, data)?;
        if let Some(viewers) = &mut self.viewers {
            viewers.message(channel, log_time, data)?;
        }
        self.loose_bytes.extend_from_slice(data);
        self.loose.push((channel, log_time, self.loose_bytes.len()));
        if self.loose_bytes.len() >= LOOSE_BYTES { self.flush() } else { Ok(()) }
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.file.as_mut().ok_or(RecordError::NotBegun)?.flush()?;
        self.safe += self.loose.len() as u64;
        self.loose.clear();
        self.loose_bytes.clear();
        Ok(())
    }
}

impl Sink for SharedTape {
    type Output = RecordingSummary;

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        let mut tape = self.0.borrow_mut();
        tape.topics = preamble.channels.iter().map(|channel| channel.topic).collect();
        if let Some(viewers) = &mut tape.viewers {
            viewers.begin(preamble)?;
        }
        tape.file.as_mut().ok_or(RecordError::NotBegun)?.begin(preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.put(channel, log_time, data)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.0.borrow_mut().flush()
    }

    fn finish(self) -> Result<RecordingSummary, RecordError> {
        let (file, viewers) = {
            let mut tape = self.0.borrow_mut();
            (tape.file.take(), tape.viewers.take())
        };
        let summary = file.ok_or(RecordError::NotBegun)?.finish()?;
        viewers.map_or(Ok(()), Viewers::finish)?;
        Ok(summary)
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
