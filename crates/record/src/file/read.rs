//! Contents of a closed recording, from its summary section alone: fast for files of any size.

use crate::RecordError;
use mcap::records::{MetadataIndex, Record};
use mcap::sans_io::summary_reader::{SummaryReadEvent, SummaryReader, SummaryReaderOptions};
use mcap::{McapError, McapResult, Summary};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

/// Contents of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordingSummary {
    /// Size of the file, bytes.
    pub file_bytes: u64,
    /// Time of the first message, ns since the Unix epoch.
    pub start_ns: u64,
    /// Time of the last message, ns since the Unix epoch.
    pub end_ns: u64,
    /// Messages on all topics.
    pub messages: u64,
    /// Compressed chunks.
    pub chunks: u32,
    /// Topics by name.
    pub topics: Vec<TopicSummary>,
    /// Attachments in the order of the file.
    pub attachments: Vec<AttachmentSummary>,
    /// Metadata records: name, then keys and values.
    pub metadata: BTreeMap<String, BTreeMap<String, String>>,
}

impl RecordingSummary {
    /// Time from the first message to the last, s.
    pub fn duration_s(&self) -> f64 {
        self.end_ns.saturating_sub(self.start_ns) as f64 * 1e-9
    }
}

/// One topic of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TopicSummary {
    /// Name, such as `/bearing/state`.
    pub topic: String,
    /// Name of the message type; empty for a topic without schema.
    pub schema: String,
    /// Number of messages.
    pub messages: u64,
}

/// One attachment of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AttachmentSummary {
    /// File name.
    pub name: String,
    /// Media type.
    pub media_type: String,
    /// Size, bytes.
    pub bytes: u64,
}

/// Reads topics, counts, times, attachments and metadata of a closed recording.
///
/// # Errors
/// [`RecordError::File`] if the file cannot be read, [`RecordError::Mcap`] if it is damaged or no MCAP file,
/// [`RecordError::Unfinished`] if it has no summary with statistics.
pub fn read_summary(path: &Path) -> Result<RecordingSummary, RecordError> {
    let io = |source| RecordError::File { action: "open", path: path.to_owned(), source };
    let damaged = |source| RecordError::Mcap { action: "read", path: path.to_owned(), source };
    let mut file = File::open(path).map_err(io)?;
    let file_bytes = file.metadata().map_err(io)?.len();
    let unfinished = || RecordError::Unfinished { path: path.to_owned() };
    let summary = summary(&mut file, file_bytes).map_err(damaged)?.ok_or_else(unfinished)?;
    let statistics = summary.stats.as_ref().ok_or_else(unfinished)?;
    let mut metadata = BTreeMap::new();
    for index in &summary.metadata_indexes {
        let (name, entries) = metadata_at(&mut file, file_bytes, index).map_err(damaged)?;
        metadata.insert(name, entries);
    }
    let mut topics: Vec<TopicSummary> = summary
        .channels
        .values()
        .map(|channel| TopicSummary {
            topic: channel.topic.clone(),
            schema: channel.schema.as_ref().map_or_else(String::new, |schema| schema.name.clone()),
            messages: statistics.channel_message_counts.get(&channel.id).copied().unwrap_or(0),
        })
        .collect();
    topics.sort_by(|a, b| a.topic.cmp(&b.topic));
    let attachment = |index: &mcap::records::AttachmentIndex| AttachmentSummary {
        name: index.name.clone(),
        media_type: index.media_type.clone(),
        bytes: index.data_size,
    };
    Ok(RecordingSummary {
        file_bytes,
        start_ns: statistics.message_start_time,
        end_ns: statistics.message_end_time,
        messages: statistics.message_count,
        chunks: statistics.chunk_count,
        topics,
        attachments: summary.attachment_indexes.iter().map(attachment).collect(),
        metadata,
    })
}

fn summary(file: &mut File, file_bytes: u64) -> McapResult<Option<Summary>> {
    // No record is longer than the file: a corrupt length must not ask for memory.
    let limit = usize::try_from(file_bytes).unwrap_or(usize::MAX);
    let options = SummaryReaderOptions::default().with_file_size(file_bytes).with_record_length_limit(limit);
    let mut reader = SummaryReader::new_with_options(options);
    while let Some(event) = reader.next_event() {
        match event? {
            SummaryReadEvent::ReadRequest(wanted) => {
                let read = file.read(reader.insert(wanted))?;
                reader.notify_read(read);
            }
            SummaryReadEvent::SeekRequest(place) => reader.notify_seeked(file.seek(place)?),
        }
    }
    Ok(reader.finish())
}

fn metadata_at(
    file: &mut File,
    file_bytes: u64,
    index: &MetadataIndex,
) -> McapResult<(String, BTreeMap<String, String>)> {
    if index.offset.checked_add(index.length).is_none_or(|end| end > file_bytes) {
        return Err(McapError::BadIndex);
    }
    file.seek(SeekFrom::Start(index.offset))?;
    let mut bytes = Vec::new();
    file.take(index.length).read_to_end(&mut bytes)?;
    match mcap::read::LinearReader::sans_magic(&bytes).next() {
        Some(Ok(Record::Metadata(record))) => Ok((record.name, record.metadata)),
        Some(Err(error)) => Err(error),
        _ => Err(McapError::BadIndex),
    }
}
