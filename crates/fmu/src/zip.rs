//! Archives of stored files: PKWARE's APPNOTE 6.3.10, sections 4.3.7, 4.3.12 and 4.3.16.
//!
//! Sizes stand before the bytes, as readers of streams want them for stored files, and times are left at the first day
//! of the format, so that the same files make the same archive.

/// Bytes that begin a local header, an entry of the directory, and its end.
const LOCAL: [u8; 4] = *b"PK\x03\x04";
const ENTRY: [u8; 4] = *b"PK\x01\x02";
const END: [u8; 4] = *b"PK\x05\x06";
/// Version 2.0 of the format; as the maker, on Unix.
const VERSION: u16 = 20;
const MADE_ON_UNIX: u16 = (3 << 8) | VERSION;
/// The first of January 1980.
const FIRST_DAY: u16 = (1 << 5) | 1;
/// A plain file that all may read.
const MODE: u32 = 0o100_644 << 16;

/// An archive that grows file by file.
#[derive(Debug, Default)]
pub struct Zip {
    bytes: Vec<u8>,
    directory: Vec<u8>,
    files: u16,
}

impl Zip {
    /// Adds a file; its name is ASCII with slashes. Archives of this form hold less than 4 GiB and 65535 files.
    pub fn put(&mut self, name: &str, content: &[u8]) {
        let offset = self.bytes.len() as u32;
        let common = common(name, content);
        self.bytes.extend(LOCAL);
        self.bytes.extend(&common);
        self.bytes.extend(name.as_bytes());
        self.bytes.extend(content);
        self.directory.extend(ENTRY);
        self.directory.extend(MADE_ON_UNIX.to_le_bytes());
        self.directory.extend(&common);
        // No comment, first disk, no attributes of the content.
        self.directory.extend([0; 6]);
        self.directory.extend(MODE.to_le_bytes());
        self.directory.extend(offset.to_le_bytes());
        self.directory.extend(name.as_bytes());
        self.files += 1;
    }

    /// The bytes of the archive.
    pub fn finish(mut self) -> Vec<u8> {
        let start = self.bytes.len() as u32;
        let length = self.directory.len() as u32;
        self.bytes.append(&mut self.directory);
        self.bytes.extend(END);
        self.bytes.extend([0; 4]);
        self.bytes.extend(self.files.to_le_bytes());
        self.bytes.extend(self.files.to_le_bytes());
        self.bytes.extend(length.to_le_bytes());
        self.bytes.extend(start.to_le_bytes());
        self.bytes.extend([0; 2]);
        self.bytes
    }
}

/// The part that a local header and an entry of the directory share, from the version needed to the length of the
/// extra field.
fn common(name: &str, content: &[u8]) -> Vec<u8> {
    let size = (content.len() as u32).to_le_bytes();
    let mut out = Vec::with_capacity(26);
    out.extend(VERSION.to_le_bytes());
    // No flags; stored.
    out.extend([0; 4]);
    out.extend([0; 2]);
    out.extend(FIRST_DAY.to_le_bytes());
    out.extend(crc32fast::hash(content).to_le_bytes());
    out.extend(size);
    out.extend(size);
    out.extend((name.len() as u16).to_le_bytes());
    out.extend([0; 2]);
    out
}
