//! Records of an MCAP file, parsed without trust: every length is held against the bytes that are there.

use std::collections::BTreeMap;

/// Opcodes (MCAP specification 0).
pub(crate) mod opcode {
    pub(crate) const HEADER: u8 = 0x01;
    pub(crate) const FOOTER: u8 = 0x02;
    pub(crate) const SCHEMA: u8 = 0x03;
    pub(crate) const CHANNEL: u8 = 0x04;
    pub(crate) const MESSAGE: u8 = 0x05;
    pub(crate) const CHUNK: u8 = 0x06;
    pub(crate) const MESSAGE_INDEX: u8 = 0x07;
    pub(crate) const ATTACHMENT: u8 = 0x09;
    pub(crate) const METADATA: u8 = 0x0c;
    pub(crate) const DATA_END: u8 = 0x0f;
}

/// A record that carries something of a recording.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Record<'a> {
    Schema(SchemaRecord<'a>),
    Channel(ChannelRecord<'a>),
    Message { channel: u16, sequence: u32, log_time: u64, publish_time: u64, data: &'a [u8] },
    Attachment { log_time: u64, create_time: u64, name: &'a str, media_type: &'a str, data: &'a [u8] },
    Metadata { name: &'a str, entries: BTreeMap<String, String> },
}

/// How messages are encoded.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SchemaRecord<'a> {
    pub(crate) id: u16,
    pub(crate) name: &'a str,
    pub(crate) encoding: &'a str,
    pub(crate) data: &'a [u8],
}

/// A channel: the topic, schema and encoding of its messages.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ChannelRecord<'a> {
    pub(crate) id: u16,
    pub(crate) schema: u16,
    pub(crate) topic: &'a str,
    pub(crate) encoding: &'a str,
    pub(crate) entries: BTreeMap<String, String>,
}

/// Reads little-endian fields off a slice; none where it is too short.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fields<'a> {
    rest: &'a [u8],
}

impl<'a> Fields<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    pub(crate) fn left(&self) -> usize {
        self.rest.len()
    }

    pub(crate) fn bytes(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.rest.split_at_checked(count)?;
        self.rest = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.bytes(N)?.try_into().ok()
    }

    pub(crate) fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    pub(crate) fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    pub(crate) fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    pub(crate) fn text(&mut self) -> Option<&'a str> {
        let length = self.u32()? as usize;
        std::str::from_utf8(self.bytes(length)?).ok()
    }

    fn map(&mut self) -> Option<BTreeMap<String, String>> {
        let length = self.u32()? as usize;
        let mut entries = Self::new(self.bytes(length)?);
        let mut map = BTreeMap::new();
        while entries.left() > 0 {
            map.insert(entries.text()?.to_owned(), entries.text()?.to_owned());
        }
        Some(map)
    }

    /// Opcode and length of a record.
    pub(crate) fn head(&mut self) -> Option<(u8, u64)> {
        let [code] = self.array()?;
        Some((code, self.u64()?))
    }

    /// A whole record: opcode and body; where there is none, nothing is taken.
    pub(crate) fn record(&mut self) -> Option<(u8, &'a [u8])> {
        let mut ahead = *self;
        let (code, length) = ahead.head()?;
        let body = ahead.bytes(usize::try_from(length).ok()?)?;
        *self = ahead;
        Some((code, body))
    }
}

/// The record, if it is one of those above and sound.
pub(crate) fn parse(code: u8, body: &[u8]) -> Option<Record<'_>> {
    let mut fields = Fields::new(body);
    let record = match code {
        opcode::SCHEMA => {
            let (id, name, encoding) = (fields.u16()?, fields.text()?, fields.text()?);
            let length = fields.u32()? as usize;
            Record::Schema(SchemaRecord { id, name, encoding, data: fields.bytes(length)? })
        }
        opcode::CHANNEL => Record::Channel(ChannelRecord {
            id: fields.u16()?,
            schema: fields.u16()?,
            topic: fields.text()?,
            encoding: fields.text()?,
            entries: fields.map()?,
        }),
        opcode::MESSAGE => Record::Message {
            channel: fields.u16()?,
            sequence: fields.u32()?,
            log_time: fields.u64()?,
            publish_time: fields.u64()?,
            data: fields.bytes(fields.left())?,
        },
        opcode::ATTACHMENT => {
            let (log_time, create_time) = (fields.u64()?, fields.u64()?);
            let (name, media_type) = (fields.text()?, fields.text()?);
            let length = usize::try_from(fields.u64()?).ok()?;
            let data = fields.bytes(length)?;
            let covered = body.len() - fields.left();
            let crc = fields.u32()?;
            if crc != 0 && crc != crc32fast::hash(&body[..covered]) {
                return None;
            }
            Record::Attachment { log_time, create_time, name, media_type, data }
        }
        opcode::METADATA => Record::Metadata { name: fields.text()?, entries: fields.map()? },
        _ => return None,
    };
    (fields.left() == 0).then_some(record)
}

/// True for a record among the data that is of a kind that nobody here reads, or one of those above and sound.
pub(crate) fn is_sound(code: u8, body: &[u8]) -> bool {
    match code {
        opcode::SCHEMA | opcode::CHANNEL | opcode::MESSAGE | opcode::ATTACHMENT | opcode::METADATA => {
            parse(code, body).is_some()
        }
        0 => false,
        _ => true,
    }
}

/// Verdict on a record outside of chunks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Judgement {
    /// It fits its own length.
    Sound,
    /// It does not, and what seems to lie behind it cannot be believed.
    Damaged,
    /// It is of a kind that has no place among the data.
    Foreign,
}

/// Judges a record outside of chunks.
pub(crate) fn judge(code: u8, body: &[u8]) -> Judgement {
    let mut fields = Fields::new(body);
    let sound = match code {
        opcode::HEADER => fields.text().and_then(|_| fields.text()).is_some() && fields.left() == 0,
        opcode::MESSAGE_INDEX => {
            fields.u16().and_then(|_| fields.u32()).is_some_and(|length| length as usize == fields.left())
        }
        opcode::SCHEMA | opcode::CHANNEL | opcode::MESSAGE | opcode::ATTACHMENT | opcode::METADATA => {
            parse(code, body).is_some()
        }
        // Records of the summary, and private ones.
        0x02..=0x0f | 0x80..=0xff => return Judgement::Foreign,
        _ => false,
    };
    if sound { Judgement::Sound } else { Judgement::Damaged }
}
