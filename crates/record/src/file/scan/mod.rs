//! Reading an MCAP file from its start, whatever state it is in: chunk by chunk, damage skipped and counted.
//!
//! A reader that trusts the file's own lengths stops at the first wrong one, or asks for the memory that it names. Here
//! every record at the top of the file must fit its own length: a record that does not is damaged, and the next chunk
//! is looked for by its signature (opcode, plausible length, name of the compression, both sizes consistent). The
//! content of a chunk is believed if its checksum fits. Of a chunk that the end of the file cuts off, and of a damaged
//! one whose fault can be placed, the messages before the fault are taken and counted as unchecked. The checksum over
//! all data, where the file has one, shows what no other check sees.
//!
//! Memory: one chunk, compressed and not, each within [`CHUNK_LIMIT`]; records that are longer count as damage.

mod chunk;
mod record;

pub(crate) use record::{ChannelRecord, Record, SchemaRecord};

use chunk::{ChunkHead, Tail};
use record::{Fields, Judgement, opcode};
use std::io::{self, Read, Seek, SeekFrom};

/// Most bytes of a record and of the content of a chunk: 64 times the size of our chunks.
pub(crate) const CHUNK_LIMIT: u64 = 64 << 20;
/// First and last bytes of every MCAP file.
pub(crate) const MAGIC: [u8; 8] = *b"\x89MCAP0\r\n";
/// Opcode and length of a record.
const HEAD: u64 = 9;
/// Length of the record that ends the data.
const END_LENGTH: u64 = 4;
/// Length of the last record of a closed file.
const FOOTER_LENGTH: u64 = 20;
/// Bytes that are read at once where there is no record to tell how many.
const WINDOW: u64 = 1 << 20;

/// Damage of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Damage {
    /// Chunks whose checksum, lengths or compression are wrong, and chunks with records that cannot be read.
    pub chunks_bad: u64,
    /// Bytes that gave nothing: of damaged chunks and records, what had to be skipped to find the next chunk, and the
    /// decompressed rest after the last whole message of a chunk that was cut off.
    pub bytes_lost: u64,
    /// Messages that stand before the fault of a damaged chunk, or in a chunk that the end of the file cuts off: they
    /// are read, but no checksum vouches for them.
    pub messages_unchecked: u64,
    /// True if the file ends before its end mark.
    pub truncated: bool,
    /// True if the summary at the end cannot be used: it does not fit its checksum, or is not where the file says.
    pub summary_bad: bool,
    /// True if the data do not have the checksum that stands at their end. With no other damage it is metadata or the
    /// head of a chunk that was altered.
    pub checksum_bad: bool,
}

impl Damage {
    /// True for a file that is whole and whose checksums all fit.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }
}

/// A piece of the file: the records of one chunk, or one record outside of chunks.
#[derive(Debug)]
pub(crate) struct Piece {
    bytes: Vec<u8>,
}

impl Piece {
    /// The records that readers of recordings need, in order.
    pub(crate) fn records(&self) -> impl Iterator<Item = Record<'_>> {
        let mut fields = Fields::new(&self.bytes);
        std::iter::from_fn(move || {
            loop {
                let (opcode, body) = fields.record()?;
                if let Some(record) = record::parse(opcode, body) {
                    return Some(record);
                }
            }
        })
    }
}

/// Goes through a file.
#[derive(Debug)]
pub(crate) struct Scanner<R> {
    stream: R,
    length: u64,
    place: u64,
    damage: Damage,
    finished: bool,
}

impl<R: Read + Seek> Scanner<R> {
    /// Starts at the beginning; none if the stream does not begin like an MCAP file.
    pub(crate) fn new(mut stream: R) -> io::Result<Option<Self>> {
        let length = stream.seek(SeekFrom::End(0))?;
        let mut scanner = Self { stream, length, place: 0, damage: Damage::default(), finished: false };
        let magic = scanner.read(0, MAGIC.len() as u64)?;
        scanner.place = MAGIC.len() as u64;
        Ok((magic == MAGIC).then_some(scanner))
    }

    /// Damage found up to now; final once there are no more pieces.
    pub(crate) fn damage(&self) -> Damage {
        self.damage
    }

    /// Schemas and channels of the summary at the end of a closed file, if its checksum fits: with them, messages can
    /// be read even where the chunk that first names them is damaged. What chunks say comes first.
    pub(crate) fn summary(&mut self) -> io::Result<Option<Piece>> {
        // Footer: head, two places and a checksum, then the end mark.
        let footer = HEAD + FOOTER_LENGTH;
        let Some(start) = self.length.checked_sub(footer + MAGIC.len() as u64) else {
            return Ok(None);
        };
        let bytes = self.read(start, footer + MAGIC.len() as u64)?;
        if !bytes.ends_with(&MAGIC) {
            return Ok(None);
        }
        let mut fields = Fields::new(&bytes);
        let head = fields.head();
        let (summary, _offsets, crc) = (fields.u64(), fields.u64(), fields.u32());
        let (Some(summary), Some(crc)) = (summary, crc) else {
            return Ok(None);
        };
        self.damage.summary_bad = true;
        let first = if summary == 0 { start } else { summary };
        if head != Some((opcode::FOOTER, FOOTER_LENGTH)) || first > start || start - first > CHUNK_LIMIT {
            return Ok(None);
        }
        // The checksum covers the footer too, up to the checksum itself.
        let mut covered = self.read(first, start - first + footer - 4)?;
        if crc != 0 && crc != crc32fast::hash(&covered) {
            return Ok(None);
        }
        self.damage.summary_bad = false;
        covered.truncate((start - first) as usize);
        Ok((!covered.is_empty()).then_some(Piece { bytes: covered }))
    }

    /// The next piece that can be believed.
    pub(crate) fn next_piece(&mut self) -> io::Result<Option<Piece>> {
        while !self.finished {
            if self.place >= self.length {
                (self.finished, self.damage.truncated) = (true, true);
                break;
            }
            let head = self.read(self.place, HEAD)?;
            let Some((code, length)) = Fields::new(&head).head() else {
                self.lose_rest();
                break;
            };
            let piece = match code {
                opcode::CHUNK => self.chunk(length)?,
                // Their lengths are fixed. Behind the data is a summary that repeats what has been read.
                opcode::DATA_END if length == END_LENGTH => {
                    let crc = self.read(self.place + HEAD, END_LENGTH)?;
                    let crc = Fields::new(&crc).u32().unwrap_or(0);
                    self.damage.checksum_bad = crc != 0 && crc != self.checksum(self.place)?;
                    self.end()?;
                    None
                }
                opcode::FOOTER if length == FOOTER_LENGTH => {
                    // The record that ends the data is missing.
                    self.damage.bytes_lost += HEAD + END_LENGTH;
                    self.end()?;
                    None
                }
                _ => self.plain(code, length)?,
            };
            if piece.is_some() {
                return Ok(piece);
            }
        }
        Ok(None)
    }

    /// A record outside of chunks.
    fn plain(&mut self, code: u8, length: u64) -> io::Result<Option<Piece>> {
        let end = self.place.checked_add(HEAD).and_then(|start| start.checked_add(length));
        let Some(end) = end.filter(|&end| end <= self.length && length <= CHUNK_LIMIT) else {
            self.resynchronise()?;
            return Ok(None);
        };
        let bytes = self.read(self.place, HEAD + length)?;
        match record::judge(code, &bytes[HEAD as usize..]) {
            Judgement::Damaged => {
                self.resynchronise()?;
                return Ok(None);
            }
            Judgement::Foreign => self.damage.bytes_lost += HEAD + length,
            Judgement::Sound => {}
        }
        self.place = end;
        Ok(Some(Piece { bytes }))
    }

    /// The end of the data: what follows repeats what has been read. The file is whole if it has its end mark.
    fn end(&mut self) -> io::Result<()> {
        self.finished = true;
        let mark = self.length.saturating_sub(MAGIC.len() as u64);
        self.damage.truncated = self.read(mark, MAGIC.len() as u64)? != MAGIC;
        Ok(())
    }

    /// Checksum of the file up to a place.
    fn checksum(&mut self, end: u64) -> io::Result<u32> {
        let mut hasher = crc32fast::Hasher::new();
        let mut place = 0;
        while place < end {
            let bytes = self.read(place, WINDOW.min(end - place))?;
            hasher.update(&bytes);
            place += (bytes.len() as u64).max(1);
        }
        Ok(hasher.finalize())
    }

    /// A chunk, whole or cut off by the end of the file.
    fn chunk(&mut self, length: u64) -> io::Result<Option<Piece>> {
        let head = self.read(self.place, chunk::LONGEST_HEAD)?;
        let Some(head) = ChunkHead::parse(&head) else {
            let found = self.resynchronise()?;
            self.damage.chunks_bad += u64::from(found);
            return Ok(None);
        };
        let data = self.place + head.bytes;
        let end = data.checked_add(head.compressed_size);
        let whole = head.is_consistent(length) && end.is_some_and(|end| end <= self.length);
        if !whole {
            return self.cut_chunk(&head, length, data);
        }
        let compressed = self.read(data, head.compressed_size)?;
        self.place = data + head.compressed_size;
        match head.content(&compressed) {
            Ok(bytes) => {
                let unread = unsound_bytes(&bytes);
                self.damage.chunks_bad += u64::from(unread > 0);
                self.damage.bytes_lost += unread;
                Ok(Some(Piece { bytes }))
            }
            Err(tail) => {
                self.damage.chunks_bad += 1;
                self.damage.bytes_lost += if tail.bytes.is_empty() { head.compressed_size } else { tail.lost };
                Ok(self.unchecked(tail.bytes))
            }
        }
    }

    /// The piece before a fault, its messages counted.
    fn unchecked(&mut self, bytes: Vec<u8>) -> Option<Piece> {
        let piece = Piece { bytes };
        let messages = piece.records().filter(|record| matches!(record, Record::Message { .. })).count();
        self.damage.messages_unchecked += messages as u64;
        (!piece.bytes.is_empty()).then_some(piece)
    }

    /// A chunk that was never closed, or that lies beyond the end of the file: the whole messages at its start. If
    /// there is another chunk behind, it is not the end of the file that is missing but the length that is wrong.
    fn cut_chunk(&mut self, head: &ChunkHead, length: u64, data: u64) -> io::Result<Option<Piece>> {
        if !(head.is_open(length) || head.is_consistent(length)) || self.find(data)?.is_some() {
            self.damage.chunks_bad += 1;
            self.resynchronise()?;
            return Ok(None);
        }
        (self.finished, self.damage.truncated) = (true, true);
        self.place = self.length;
        let compressed = self.read(data, CHUNK_LIMIT)?;
        let Tail { bytes, lost } = head.beginning(&compressed);
        self.damage.bytes_lost += lost;
        Ok(self.unchecked(bytes))
    }

    /// Goes on at the next chunk or at the end of the data; false where there is neither.
    fn resynchronise(&mut self) -> io::Result<bool> {
        let found = self.find(self.place + 1)?;
        if let Some(next) = found {
            self.damage.bytes_lost += next - self.place;
            self.place = next;
        } else {
            self.lose_rest();
        }
        Ok(found.is_some())
    }

    fn lose_rest(&mut self) {
        self.damage.bytes_lost += self.length.saturating_sub(self.place);
        (self.place, self.finished, self.damage.truncated) = (self.length, true, true);
    }

    /// Place of the first chunk at or after a place, or of the end of the data.
    fn find(&mut self, from: u64) -> io::Result<Option<u64>> {
        let end_head: Vec<u8> = [opcode::DATA_END].into_iter().chain(END_LENGTH.to_le_bytes()).collect();
        let mut start = from;
        while start < self.length {
            // Windows overlap by the longest head, so that none is cut in two.
            let bytes = self.read(start, WINDOW + chunk::LONGEST_HEAD)?;
            let rest = self.length - start;
            let is_chunk = |at: usize| {
                let head = ChunkHead::parse(&bytes[at..]);
                head.is_some_and(|head| head.is_plausible(&bytes[at..], rest - at as u64))
            };
            let found = (0..bytes.len().min(WINDOW as usize)).find(|&at| match bytes[at] {
                opcode::CHUNK => is_chunk(at),
                opcode::DATA_END => bytes[at..].starts_with(&end_head),
                _ => false,
            });
            if let Some(at) = found {
                return Ok(Some(start + at as u64));
            }
            start += WINDOW;
        }
        Ok(None)
    }

    /// Up to `count` bytes at a place, fewer at the end of the file.
    fn read(&mut self, place: u64, count: u64) -> io::Result<Vec<u8>> {
        self.stream.seek(SeekFrom::Start(place))?;
        let mut bytes = Vec::new();
        (&mut self.stream).take(count).read_to_end(&mut bytes)?;
        Ok(bytes)
    }
}

/// Bytes of a chunk's content that make no record, or one that cannot be read.
fn unsound_bytes(content: &[u8]) -> u64 {
    let mut fields = Fields::new(content);
    let mut unsound = 0;
    while let Some((code, body)) = fields.record() {
        if !record::is_sound(code, body) {
            unsound += HEAD + body.len() as u64;
        }
    }
    unsound + fields.left() as u64
}
