//! A whole recording from one that was cut off or damaged.

use crate::output::{SMALL, file_error, mcap_error, open, writer};
use crate::scan::{ChannelRecord, Damage, Piece, Record, Scanner, SchemaRecord};
use crate::{RecordError, TemporaryFile};
use mcap::records::{MessageHeader, Metadata};
use mcap::{Attachment, McapResult, Writer};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufWriter, Read, Seek, Write};
use std::path::{Path, PathBuf};

/// Name of the metadata record that a recovered file has more than the original.
pub const RECOVERY_METADATA: &str = "recovery";

/// Result of a recovery: what was saved and what was lost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recovered {
    /// Messages in the new file.
    pub messages: u64,
    /// Messages that were read but belong to no known channel, or to one that the file describes in two ways.
    pub messages_lost: u64,
    /// Log time of the last message, ns since the Unix epoch.
    pub last_time_ns: u64,
    /// Damage of the original.
    pub damage: Damage,
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

/// Writes a whole MCAP file with all messages of the sound chunks of another one, and with those before the fault of a
/// chunk that is damaged or that the end of the file cuts off; [`Damage`] counts the latter. Memory is bounded whatever
/// lengths the damaged file names. Names of topics and types come from checked chunks before they come from the
/// summary.
///
/// `to` is replaced when the new file is whole, and may be the damaged file itself. The content is taken as it is, from
/// any writer that compresses with zstd or not at all; chunks compressed with lz4 count as bad.
///
/// # Errors
/// [`RecordError::NotMcap`] if `from` does not begin like an MCAP file, [`RecordError::NothingToRecover`] if no message
/// of it is whole, [`RecordError::File`] and [`RecordError::Mcap`] if a file cannot be read or written. Nothing is left
/// behind then.
pub fn recover(from: &Path, to: &Path) -> Result<Recovered, RecordError> {
    let input = open(from)?;
    // `to` may be the very file that is read.
    let mut part = TemporaryFile::beside(to).map_err(|source| file_error("create", to, source))?;
    let (done, mut buffer) = copy(input, BufWriter::new(part.file())).map_err(|failure| named(failure, from, to))?;
    buffer.flush().map_err(|source| file_error("write", to, source))?;
    drop(buffer);
    part.publish(to).map_err(|source| file_error("write", to, source))?;
    Ok(done)
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
        data: Known::default(),
        summary: Known::default(),
        open: BTreeSet::new(),
        done: Recovered { messages: 0, messages_lost: 0, last_time_ns: 0, damage: Damage::default() },
    };
    if let Some(summary) = scanner.summary()? {
        copy.summary.learn(&summary);
    }
    while let Some(piece) = scanner.next_piece()? {
        copy.data.learn(&piece);
        for record in piece.records() {
            copy.record(record)?;
        }
    }
    if copy.done.messages == 0 {
        return Err(Failure::Nothing);
    }
    let done = Recovered { damage: scanner.damage(), ..copy.done };
    copy.writer.write_metadata(&report(&done))?;
    copy.writer.finish()?;
    Ok((done, copy.writer.into_inner()))
}

fn report(done: &Recovered) -> Metadata {
    let damage = &done.damage;
    let entries = [
        ("messages", done.messages.to_string()),
        ("chunks_bad", damage.chunks_bad.to_string()),
        ("bytes_lost", damage.bytes_lost.to_string()),
        ("messages_lost", done.messages_lost.to_string()),
        ("messages_unchecked", damage.messages_unchecked.to_string()),
        ("truncated", damage.truncated.to_string()),
        ("summary_bad", damage.summary_bad.to_string()),
        ("checksum_bad", damage.checksum_bad.to_string()),
    ];
    let metadata = entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
    Metadata { name: RECOVERY_METADATA.to_owned(), metadata }
}

/// A schema: name, encoding, definition.
type Schema = (String, String, Vec<u8>);
/// A channel: schema, topic, encoding, keys and values.
type Channel = (u16, String, String, BTreeMap<String, String>);

/// Schemas and channels seen so far, none where the file describes one number in two ways.
#[derive(Default)]
struct Known {
    schemas: BTreeMap<u16, Option<Schema>>,
    channels: BTreeMap<u16, Option<Channel>>,
}

impl Known {
    fn learn(&mut self, piece: &Piece) {
        for record in piece.records() {
            match record {
                Record::Schema(SchemaRecord { id, name, encoding, data }) => {
                    settle(&mut self.schemas, id, (name.to_owned(), encoding.to_owned(), data.to_owned()));
                }
                Record::Channel(ChannelRecord { id, schema, topic, encoding, entries }) => {
                    settle(&mut self.channels, id, (schema, topic.to_owned(), encoding.to_owned(), entries));
                }
                _ => {}
            }
        }
    }
}

fn settle<T: PartialEq>(known: &mut BTreeMap<u16, Option<T>>, id: u16, found: T) {
    let contradicts = known.get(&id).is_some_and(|before| before.as_ref() != Some(&found));
    known.insert(id, (!contradicts).then_some(found));
}

struct Copy<W: Write + Seek> {
    writer: Writer<W>,
    /// From the data.
    data: Known,
    /// From the summary, for what the data do not say.
    summary: Known,
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

    /// Makes a channel known to the new file; false if the old one does not say, or not clearly, what it is.
    fn open_channel(&mut self, id: u16) -> McapResult<bool> {
        let channel = self.data.channels.get(&id).or_else(|| self.summary.channels.get(&id));
        let Some(Some((schema, topic, encoding, entries))) = channel else {
            return Ok(false);
        };
        if self.open.contains(&id) {
            return Ok(true);
        }
        if *schema != 0 {
            let definition = self.data.schemas.get(schema).or_else(|| self.summary.schemas.get(schema));
            let Some(Some((name, schema_encoding, data))) = definition else {
                return Ok(false);
            };
            self.writer.add_schema_with_id(*schema, name, schema_encoding, data)?;
        }
        self.writer.add_channel_with_id(id, *schema, topic, encoding, entries)?;
        self.open.insert(id);
        Ok(true)
    }
}
