//! A whole recording from one that was cut off or damaged.

use crate::RecordError;
use crate::output::{SMALL, file_error, mcap_error, with_suffix, writer};
use crate::scan::{ChannelRecord, Piece, Record, Scanner};
use mcap::records::{MessageHeader, Metadata};
use mcap::{Attachment, McapResult, Writer};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Name of the metadata record that a recovered file has more than the original.
pub const RECOVERY_METADATA: &str = "recovery";

/// What was saved and what was not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recovered {
    /// Messages in the new file.
    pub messages: u64,
    /// Chunks left out: their checksum, their lengths or their compression is wrong.
    pub chunks_bad: u64,
    /// Bytes that gave nothing: damaged chunks and records, what had to be skipped to find the next chunk, and the
    /// decompressed rest after the last whole message of a chunk that the end of the file cuts off.
    pub bytes_lost: u64,
    /// Messages that were read but belong to no known channel.
    pub messages_lost: u64,
    /// Log time of the last message, ns since the Unix epoch.
    pub last_time_ns: u64,
    /// Whether the original ended before its end mark.
    pub truncated: bool,
}

impl Recovered {
    /// Simulated time of the last message, s.
    pub fn last_time_s(&self) -> f64 {
        self.last_time_ns.saturating_sub(crate::timeline::EPOCH_NS) as f64 * 1e-9
    }
}

/// Why a stream was not recovered.
enum Failure {
    Read(std::io::Error),
    Write(mcap::McapError),
    NotMcap,
    Nothing,
}

impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        Self::Read(error)
    }
}

impl From<mcap::McapError> for Failure {
    fn from(error: mcap::McapError) -> Self {
        Self::Write(error)
    }
}

/// Writes a whole MCAP file with all messages of the sound chunks of another one, and with what can be decompressed of
/// a chunk that the end of the file cuts off. Damaged chunks are skipped; memory is bounded whatever lengths the
/// damaged file names.
///
/// `to` is replaced when the new file is whole, and may be the damaged file itself. The content is taken as it is, from
/// any writer that compresses with zstd or not at all; chunks compressed with lz4 count as bad.
///
/// # Errors
/// [`RecordError::NotMcap`] if `from` does not begin like an MCAP file, [`RecordError::NothingToRecover`] if no message
/// of it is whole, [`RecordError::File`] and [`RecordError::Mcap`] if a file cannot be read or written. Nothing is left
/// behind then.
pub fn recover(from: &Path, to: &Path) -> Result<Recovered, RecordError> {
    // `.active` may be the very file that is read.
    let part = with_suffix(to, ".recovering");
    let result = recover_file(from, &part)
        .and_then(|done| fs::rename(&part, to).map(|()| done).map_err(|e| file_error("move into place", &part, e)));
    if result.is_err() {
        // It may not exist; the error that counts is the first.
        let _ = fs::remove_file(&part);
    }
    result
}

fn recover_file(from: &Path, part: &Path) -> Result<Recovered, RecordError> {
    let input = File::open(from).map_err(|source| file_error("open", from, source))?;
    let output = File::create(part).map_err(|source| file_error("create", part, source))?;
    let (recovered, buffer) = copy(input, BufWriter::new(output)).map_err(|failure| named(failure, from, part))?;
    let file = buffer.into_inner().map_err(|error| file_error("flush", part, error.into_error()))?;
    file.sync_all().map_err(|source| file_error("close", part, source))?;
    Ok(recovered)
}

/// [`recover`] from any stream to any stream, which is handed back.
///
/// # Errors
/// As [`recover`]; the errors call the streams `input` and `output`.
pub fn recover_stream<R: Read + Seek, W: Write + Seek>(input: R, output: W) -> Result<(Recovered, W), RecordError> {
    copy(input, output).map_err(|failure| named(failure, Path::new("input"), Path::new("output")))
}

fn named(failure: Failure, from: &Path, to: &Path) -> RecordError {
    let path = PathBuf::from(from);
    match failure {
        Failure::Read(source) => file_error("read", from, source),
        Failure::Write(source) => mcap_error("write", to, source),
        Failure::NotMcap => RecordError::NotMcap { path },
        Failure::Nothing => RecordError::NothingToRecover { path },
    }
}

fn copy<R: Read + Seek, W: Write + Seek>(input: R, output: W) -> Result<(Recovered, W), Failure> {
    let mut scanner = Scanner::new(input)?.ok_or(Failure::NotMcap)?;
    let generator = concat!("tribodyn-record ", env!("CARGO_PKG_VERSION"), " recover");
    let mut copy = Copy {
        writer: writer(output, generator, SMALL)?,
        known: Known::default(),
        open: BTreeSet::new(),
        done: nothing(),
    };
    if let Some(summary) = scanner.summary()? {
        copy.known.learn(&summary);
    }
    while let Some(piece) = scanner.next_piece()? {
        copy.known.learn(&piece);
        for record in piece.records() {
            copy.record(record)?;
        }
    }
    if copy.done.messages == 0 {
        return Err(Failure::Nothing);
    }
    let damage = scanner.damage();
    let done = Recovered {
        chunks_bad: damage.chunks_bad,
        bytes_lost: damage.bytes_lost,
        truncated: damage.truncated,
        ..copy.done
    };
    copy.writer.write_metadata(&report(&done))?;
    copy.writer.finish()?;
    Ok((done, copy.writer.into_inner()))
}

fn nothing() -> Recovered {
    Recovered { messages: 0, chunks_bad: 0, bytes_lost: 0, messages_lost: 0, last_time_ns: 0, truncated: false }
}

fn report(done: &Recovered) -> Metadata {
    let entries = [
        ("messages", done.messages.to_string()),
        ("chunks_bad", done.chunks_bad.to_string()),
        ("bytes_lost", done.bytes_lost.to_string()),
        ("messages_lost", done.messages_lost.to_string()),
        ("truncated", done.truncated.to_string()),
    ];
    let metadata = entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
    Metadata { name: RECOVERY_METADATA.to_owned(), metadata }
}

/// Schemas and channels seen so far, from the data and from the summary.
#[derive(Default)]
struct Known {
    schemas: BTreeMap<u16, (String, String, Vec<u8>)>,
    channels: BTreeMap<u16, (u16, String, String, BTreeMap<String, String>)>,
}

impl Known {
    fn learn(&mut self, piece: &Piece) {
        for record in piece.records() {
            match record {
                Record::Schema(s) => {
                    let content = || (s.name.to_owned(), s.encoding.to_owned(), s.data.to_owned());
                    self.schemas.entry(s.id).or_insert_with(content);
                }
                Record::Channel(ChannelRecord { id, schema, topic, encoding, entries }) => {
                    let content = || (schema, topic.to_owned(), encoding.to_owned(), entries);
                    self.channels.entry(id).or_insert_with(content);
                }
                _ => {}
            }
        }
    }
}

struct Copy<W: Write + Seek> {
    writer: Writer<W>,
    known: Known,
    /// Channels that the new file knows.
    open: BTreeSet<u16>,
    done: Recovered,
}

impl<W: Write + Seek> Copy<W> {
    fn record(&mut self, record: Record) -> McapResult<()> {
        match record {
            // They go into the new file with the first message that needs them.
            Record::Schema(_) | Record::Channel(_) => Ok(()),
            Record::Metadata { name, entries } => {
                self.writer.write_metadata(&Metadata { name: name.to_owned(), metadata: entries })
            }
            Record::Attachment { log_time, create_time, name, media_type, data } => self.writer.attach(&Attachment {
                log_time,
                create_time,
                name: name.to_owned(),
                media_type: media_type.to_owned(),
                data: Cow::Borrowed(data),
            }),
            Record::Message { channel, sequence, log_time, publish_time, data } => {
                if !self.open_channel(channel)? {
                    self.done.messages_lost += 1;
                    return Ok(());
                }
                let header = MessageHeader { channel_id: channel, sequence, log_time, publish_time };
                self.writer.write_to_known_channel(&header, data)?;
                self.done.messages += 1;
                self.done.last_time_ns = self.done.last_time_ns.max(log_time);
                Ok(())
            }
        }
    }

    /// Makes a channel known to the new file; false if the old one does not say what it is.
    fn open_channel(&mut self, id: u16) -> McapResult<bool> {
        if self.open.contains(&id) {
            return Ok(true);
        }
        let Some((schema, topic, encoding, entries)) = self.known.channels.get(&id) else {
            return Ok(false);
        };
        if *schema != 0 {
            let Some((name, schema_encoding, data)) = self.known.schemas.get(schema) else {
                return Ok(false);
            };
            self.writer.add_schema_with_id(*schema, name, schema_encoding, data)?;
        }
        self.writer.add_channel_with_id(id, *schema, topic, encoding, entries)?;
        self.open.insert(id);
        Ok(true)
    }
}
