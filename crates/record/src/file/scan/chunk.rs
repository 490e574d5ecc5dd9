//! Chunks: their head, their content if it can be believed, and the beginning of one that was cut off.

use super::CHUNK_LIMIT;
use super::record::{Fields, is_sound, opcode};
use std::io::Read;

/// Fixed part of a chunk's fields: times, uncompressed size, checksum, length of the name, compressed size.
const FIXED: u64 = 8 + 8 + 8 + 4 + 4 + 8;
/// Longest name of a compression that is believed; those of the specification have three and four letters.
const LONGEST_NAME: u64 = 16;
/// Opcode, length and fields of a chunk with such a name.
pub(crate) const LONGEST_HEAD: u64 = 9 + FIXED + LONGEST_NAME;

/// The head of a chunk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ChunkHead {
    /// Bytes from the opcode to the content.
    pub(crate) bytes: u64,
    compression: String,
    uncompressed_size: u64,
    uncompressed_crc: u32,
    pub(crate) compressed_size: u64,
}

/// The beginning of a chunk that was cut off or is damaged.
pub(crate) struct Tail {
    /// Whole records.
    pub(crate) bytes: Vec<u8>,
    /// Bytes after them that make no whole record.
    pub(crate) lost: u64,
}

impl ChunkHead {
    /// Parses opcode, length and fields.
    pub(crate) fn parse(bytes: &[u8]) -> Option<Self> {
        let mut fields = Fields::new(bytes);
        let (code, _) = fields.head()?;
        let (_start, _end) = (fields.u64()?, fields.u64()?);
        let (uncompressed_size, uncompressed_crc) = (fields.u64()?, fields.u32()?);
        let name = fields.text()?;
        if code != opcode::CHUNK || name.len() as u64 > LONGEST_NAME {
            return None;
        }
        let compressed_size = fields.u64()?;
        Some(Self {
            bytes: 9 + FIXED + name.len() as u64,
            compression: name.to_owned(),
            uncompressed_size,
            uncompressed_crc,
            compressed_size,
        })
    }

    /// True if the length of the record is that of its fields, and both sizes are within bounds.
    pub(crate) fn is_consistent(&self, length: u64) -> bool {
        self.compressed_size <= CHUNK_LIMIT
            && self.uncompressed_size <= CHUNK_LIMIT
            && length == self.bytes - 9 + self.compressed_size
    }

    /// True if the chunk was begun and not closed: its lengths are then all ones.
    pub(crate) fn is_open(&self, length: u64) -> bool {
        length == u64::MAX && self.compressed_size == u64::MAX && self.uncompressed_size == u64::MAX
    }

    /// True if this is a chunk and not bytes that look like one; `rest` bytes are left in the file from its opcode on.
    pub(crate) fn is_plausible(&self, bytes: &[u8], rest: u64) -> bool {
        let length = Fields::new(bytes).head().map_or(0, |(_, length)| length);
        let known = matches!(self.compression.as_str(), "" | "zstd" | "lz4");
        let whole = self.is_consistent(length) && self.bytes + self.compressed_size <= rest;
        // An empty name is little of a signature: the content must fit its size then.
        let named = !self.compression.is_empty() || self.compressed_size == self.uncompressed_size;
        known && named && (whole || self.is_open(length))
    }

    /// The content, if it has the size and the checksum that the head names.
    ///
    /// # Errors
    /// The records before the fault, where the fault can be placed: where zstd stops, or where records of content that
    /// is not compressed no longer fit each other. Wrong content that decompresses may be wrong anywhere, so nothing of
    /// it is taken.
    pub(crate) fn content(&self, compressed: &[u8]) -> Result<Vec<u8>, Tail> {
        let (content, sound) = self.decompress(compressed, self.uncompressed_size);
        let checked = self.uncompressed_crc == 0 || self.uncompressed_crc == crc32fast::hash(&content);
        if sound && content.len() as u64 == self.uncompressed_size && checked {
            return Ok(content);
        }
        let whole = whole_records(&content);
        let placed = if self.compression.is_empty() { whole < content.len() } else { !sound };
        Err(if placed { Tail::new(content) } else { Tail { bytes: Vec::new(), lost: content.len() as u64 } })
    }

    /// The whole records at the start of content that was cut off.
    pub(crate) fn beginning(&self, compressed: &[u8]) -> Tail {
        Tail::new(self.decompress(compressed, CHUNK_LIMIT).0)
    }

    /// Decompresses up to `limit` bytes; false where there are more, or where the data is damaged or ends early.
    fn decompress(&self, compressed: &[u8], limit: u64) -> (Vec<u8>, bool) {
        match self.compression.as_str() {
            "" => (compressed.to_vec(), true),
            "zstd" => {
                let mut content = Vec::new();
                let sound = decompress_zstd(compressed, limit, &mut content).is_ok() && content.len() as u64 <= limit;
                (content, sound)
            }
            // Our recordings have no others.
            _ => (Vec::new(), false),
        }
    }
}

impl Tail {
    fn new(mut bytes: Vec<u8>) -> Self {
        let whole = whole_records(&bytes);
        let lost = (bytes.len() - whole) as u64;
        bytes.truncate(whole);
        Self { bytes, lost }
    }
}

/// Length of the records at the start of a chunk's content that are whole and sound.
fn whole_records(bytes: &[u8]) -> usize {
    let mut fields = Fields::new(bytes);
    let mut whole = 0;
    while let Some((code, body)) = fields.record() {
        if !is_sound(code, body) {
            break;
        }
        whole = bytes.len() - fields.left();
    }
    whole
}

/// Decompresses up to one byte above `limit`; before an error, all but the last few thousand bytes before the fault.
fn decompress_zstd(compressed: &[u8], limit: u64, content: &mut Vec<u8>) -> std::io::Result<()> {
    // What one call has decompressed before it meets a fault is lost with it: small calls lose little.
    let mut part = [0; 4096];
    let mut decoder = zstd::stream::read::Decoder::with_buffer(compressed)?.take(limit + 1);
    loop {
        match decoder.read(&mut part)? {
            0 => return Ok(()),
            count => content.extend_from_slice(&part[..count]),
        }
    }
}
