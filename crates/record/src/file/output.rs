//! The MCAP file below a recording: channels, messages, attachments, and the name a file has until it is whole.

use crate::RecordError;
use crate::timeline::EPOCH_NS;
use crate::wire::{FOXGLOVE_DESCRIPTORS, TRIBODYN_DESCRIPTORS};
use crate::write::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT};
use mcap::records::{MessageHeader, Metadata};
use mcap::{Attachment, McapResult, WriteOptions, Writer};
use prost::Message;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

/// A topic and what its messages are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Channel {
    /// Name of the topic, such as `/bearing/state`.
    pub topic: &'static str,
    /// Full name of the message type.
    pub schema: &'static str,
    /// The descriptor set that has the type and its imports, as a schema record holds it.
    pub descriptors: &'static [u8],
}

impl Channel {
    /// A topic with one of Foxglove's public messages.
    pub(crate) const fn foxglove(topic: &'static str, schema: &'static str) -> Self {
        Self { topic, schema, descriptors: FOXGLOVE_DESCRIPTORS }
    }

    /// A topic with one of our own messages.
    pub(crate) const fn own(topic: &'static str, schema: &'static str) -> Self {
        Self { topic, schema, descriptors: TRIBODYN_DESCRIPTORS }
    }
}

/// `<path>.active`: viewers know that such a file is not whole.
pub(crate) fn active_path(path: &Path) -> PathBuf {
    with_suffix(path, ".active")
}

pub(crate) fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

/// Opens a recording.
pub(crate) fn open(path: &Path) -> Result<File, RecordError> {
    let active = active_path(path);
    File::open(path).map_err(|source| match source.kind() {
        ErrorKind::NotFound if active.exists() => RecordError::OnlyBegun { path: path.to_owned(), active },
        _ => file_error("open", path, source),
    })
}

pub(crate) fn file_error(action: &'static str, path: &Path, source: std::io::Error) -> RecordError {
    RecordError::File { action, path: path.to_owned(), source }
}

pub(crate) fn mcap_error(action: &'static str, path: &Path, source: mcap::McapError) -> RecordError {
    RecordError::Mcap { action, path: path.to_owned(), source }
}

/// FNV-1a, 64 bits (RFC 9923): tells one case from another, no protection against forgery.
pub(crate) fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The compression of a file that is written in one go: the default level of zstd.
pub(crate) const SMALL: u32 = 0;
/// The compression of a run, one of zstd's fast levels, −3: the writer hands the number on as a signed one. With 13
/// balls, states at 25.6 kHz and balls at 5 kHz, recording takes 0.43 s of processor time per simulated second and
/// makes 40 MB; level 1 takes 0.63 s and makes 36 MB, level −1 0.51 s and 38 MB. Level 3, the default, takes 0.3 s more
/// than level 1 for 8 % fewer bytes.
pub(crate) const QUICK: u32 = (-3_i32) as u32;

/// A writer whose bytes depend on nothing but what is written.
pub(crate) fn writer<W: Write + Seek>(stream: W, generator: &str, level: u32) -> McapResult<Writer<W>> {
    WriteOptions::new()
        .library(generator)
        // Threads would change the bytes.
        .compression_threads(0)
        .compression_level(level)
        .create(stream)
}

/// An open MCAP file with its channels.
///
/// Channels are declared with the first message. A schema or channel opens a chunk, a metadata record or an attachment
/// closes it: declared before those, they would leave a chunk without messages, whose index says start time 0. Viewers
/// take the span of a recording from these indexes and would open it in 1970.
pub(crate) struct Output<W: Write + Seek> {
    pub(crate) writer: Writer<W>,
    topics: Vec<Channel>,
    /// Number and next sequence of each channel; empty until there is a message.
    channels: Vec<(u16, u32)>,
}

impl<W: Write + Seek> Output<W> {
    /// Opens the file; messages name their channel by its place in `channels`.
    pub(crate) fn new(stream: W, generator: &str, level: u32, channels: &[Channel]) -> McapResult<Self> {
        Ok(Self { writer: writer(stream, generator, level)?, topics: channels.to_vec(), channels: Vec::new() })
    }

    /// Number of topics.
    pub(crate) fn topics(&self) -> usize {
        self.topics.len()
    }

    fn declare(&mut self) -> McapResult<()> {
        for channel in &self.topics {
            let schema = self.writer.add_schema(channel.schema, "protobuf", channel.descriptors)?;
            self.channels.push((self.writer.add_channel(schema, channel.topic, "protobuf", &BTreeMap::new())?, 0));
        }
        Ok(())
    }

    /// The metadata record `simulation` and the attachments, before all messages.
    pub(crate) fn describe(
        &mut self,
        entries: &[(&'static str, String)],
        case_text: &str,
        layout: &str,
    ) -> McapResult<()> {
        self.metadata("simulation", entries)?;
        for (name, media_type, text) in
            [(CASE_ATTACHMENT, "text/plain", case_text), (LAYOUT_ATTACHMENT, "application/json", layout)]
        {
            self.writer.attach(&Attachment {
                log_time: EPOCH_NS,
                create_time: EPOCH_NS,
                name: name.into(),
                media_type: media_type.into(),
                data: Cow::Borrowed(text.as_bytes()),
            })?;
        }
        Ok(())
    }

    /// A metadata record.
    pub(crate) fn metadata(&mut self, name: &str, entries: &[(&'static str, String)]) -> McapResult<()> {
        let metadata = entries.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect();
        self.writer.write_metadata(&Metadata { name: name.into(), metadata })
    }

    pub(crate) fn log(&mut self, channel: usize, time: u64, message: &impl Message) -> McapResult<()> {
        self.write(channel, time, &message.encode_to_vec())
    }

    /// Writes an encoded message.
    pub(crate) fn write(&mut self, channel: usize, time: u64, data: &[u8]) -> McapResult<()> {
        if self.channels.is_empty() {
            self.declare()?;
        }
        let (channel_id, sequence) = &mut self.channels[channel];
        let header = MessageHeader { channel_id: *channel_id, sequence: *sequence, log_time: time, publish_time: time };
        *sequence = sequence.wrapping_add(1);
        self.writer.write_to_known_channel(&header, data)
    }
}

/// Keys and values of the metadata record `simulation`.
pub(crate) type Entries = Vec<(&'static str, String)>;
