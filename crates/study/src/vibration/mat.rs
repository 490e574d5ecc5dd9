//! Signals as MATLAB files of level 5 (`save -v6` and `-v7`): numeric arrays, also within structures.
//!
//! Format: The MathWorks, "MAT-File Format", version 5: a header of 128 bytes, then elements of a type, a length and data,
//! whole or in a zlib stream.

use super::signal_file::{Column, SignalFile, damaged};
use crate::error::StudyError;
use std::path::Path;
use tribodyn::Limits;

const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Classes of arrays: structure, numbers from double precision to 64-bit whole numbers.
const STRUCTURE: u8 = 2;
const NUMBERS: std::ops::RangeInclusive<u8> = 6..=15;
const COMPLEX: u8 = 0x08;
/// Structures within structures that are gone into.
const DEEPEST: usize = 8;

pub(super) fn read(path: &Path, bytes: &[u8], limits: &Limits) -> Result<SignalFile, StudyError> {
    let hdf5 =
        bytes.starts_with(b"\x89HDF") || bytes.get(512..516) == Some(b"\x89HDF") || bytes.starts_with(b"MATLAB 7.3");
    if hdf5 {
        return Err(damaged(path, "it is of version 7.3 (HDF5): save it with `save -v7`"));
    }
    let big = match bytes.get(HEADER - 2..HEADER) {
        Some(b"IM") => false,
        Some(b"MI") => true,
        _ => return Err(damaged(path, "it is not a MATLAB file of level 5 (versions 5 to 7)")),
    };
    let most = usize::try_from(limits.recording_bytes).unwrap_or(usize::MAX);
    let reader = Reader { big, most };
    let mut columns = Vec::new();
    reader.elements(&bytes[HEADER..], &mut columns).map_err(|why| damaged(path, why))?;
    // As a data set has it.
    let rate = columns.iter().find(|column| column.name == "rate_hz" && column.values.len() == 1);
    let rate_hz = rate.map(|column| column.values[0]);
    Ok(SignalFile::of(columns, rate_hz))
}

struct Reader {
    /// True if the most significant byte stands first.
    big: bool,
    /// Most bytes of a stream when it is unpacked.
    most: usize,
}

/// A part of an element: its type, its data and what follows.
struct Element<'a> {
    kind: u32,
    data: &'a [u8],
    rest: &'a [u8],
}

impl Reader {
    fn word(&self, bytes: &[u8]) -> Option<u32> {
        let bytes: [u8; 4] = bytes.get(..4)?.try_into().ok()?;
        Some(if self.big { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) })
    }

    fn element<'a>(&self, bytes: &'a [u8]) -> Result<Element<'a>, String> {
        let ended = || "it ends within a variable".to_owned();
        let tag = self.word(bytes).ok_or_else(ended)?;
        // A short element has length and type in one word, and up to four bytes in the next.
        if tag >> 16 != 0 {
            let length = (tag >> 16) as usize;
            let data = bytes.get(4..4 + length).filter(|_| length <= 4).ok_or_else(ended)?;
            return Ok(Element { kind: tag & 0xffff, data, rest: bytes.get(8..).unwrap_or_default() });
        }
        let length = self.word(bytes.get(4..).unwrap_or_default()).ok_or_else(ended)? as usize;
        let data = bytes.get(8..8 + length).ok_or_else(ended)?;
        let padded = if tag == COMPRESSED { length } else { length.next_multiple_of(8) };
        Ok(Element { kind: tag, data, rest: bytes.get(8 + padded..).unwrap_or_default() })
    }

    fn elements(&self, mut bytes: &[u8], columns: &mut Vec<Column>) -> Result<(), String> {
        while bytes.len() >= 8 {
            let element = self.element(bytes)?;
            match element.kind {
                MATRIX => self.matrix(element.data, None, 0, columns)?,
                COMPRESSED => {
                    let unpacked = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(element.data, self.most);
                    let unpacked = unpacked.map_err(|error| format!("a variable cannot be unpacked: {error}"))?;
                    self.elements(&unpacked, columns)?;
                }
                _ => {}
            }
            bytes = element.rest;
        }
        Ok(())
    }

    /// One array; one within a structure has the name of its place.
    fn matrix(&self, bytes: &[u8], place: Option<&str>, depth: usize, columns: &mut Vec<Column>) -> Result<(), String> {
        if bytes.is_empty() || depth > DEEPEST {
            return Ok(());
        }
        let flags = self.element(bytes)?;
        let word = self.word(flags.data).unwrap_or_default();
        let (class, marks) = (word as u8, (word >> 8) as u8);
        let dimensions = self.element(flags.rest)?;
        let name = self.element(dimensions.rest)?;
        let shape: Vec<usize> = self.numbers(&dimensions)?.iter().map(|n| *n as usize).collect();
        let own = String::from_utf8_lossy(name.data).into_owned();
        let name_of = place.map_or(own, str::to_owned);
        if class == STRUCTURE {
            return self.structure(name.rest, &name_of, shape.iter().product(), depth, columns);
        }
        if !NUMBERS.contains(&class) || marks & COMPLEX != 0 || shape.len() != 2 {
            return Ok(());
        }
        let values = self.numbers(&self.element(name.rest)?)?;
        let [rows, across] = [shape[0], shape[1]];
        if rows.checked_mul(across) != Some(values.len()) {
            return Err(format!("variable {name_of} has {} numbers for {rows} times {across}", values.len()));
        }
        // A row is a signal too; a matrix has a signal in each column.
        if rows <= 1 || across == 1 {
            columns.push(Column { name: name_of, values });
        } else {
            let column = |(k, values): (usize, &[f64])| Column {
                name: format!("{name_of}({})", k + 1),
                values: values.to_vec(),
            };
            columns.extend(values.chunks(rows).enumerate().map(column));
        }
        Ok(())
    }

    /// The fields of a structure, or of each of several.
    fn structure(
        &self,
        bytes: &[u8],
        name: &str,
        count: usize,
        depth: usize,
        columns: &mut Vec<Column>,
    ) -> Result<(), String> {
        let length = self.element(bytes)?;
        let names = self.element(length.rest)?;
        let each = self.word(length.data).unwrap_or_default() as usize;
        if each == 0 {
            return Ok(());
        }
        let until_zero =
            |name: &[u8]| String::from_utf8_lossy(name.split(|b| *b == 0).next().unwrap_or(name)).into_owned();
        let fields: Vec<String> = names.data.chunks(each).map(until_zero).collect();
        let mut rest = names.rest;
        for index in 0..count {
            for field in &fields {
                if rest.len() < 8 {
                    return Ok(());
                }
                let element = self.element(rest)?;
                let number = if count > 1 { format!("({})", index + 1) } else { String::new() };
                self.matrix(element.data, Some(&format!("{name}{number}.{field}")), depth + 1, columns)?;
                rest = element.rest;
            }
        }
        Ok(())
    }

    /// Numbers of an element, whatever they are stored as.
    fn numbers(&self, element: &Element) -> Result<Vec<f64>, String> {
        macro_rules! read {
            ($kind:ty) => {{
                let (chunks, _) = element.data.as_chunks::<{ size_of::<$kind>() }>();
                let number = |b: &[u8; size_of::<$kind>()]| {
                    (if self.big { <$kind>::from_be_bytes(*b) } else { <$kind>::from_le_bytes(*b) }) as f64
                };
                chunks.iter().map(number).collect()
            }};
        }
        Ok(match element.kind {
            1 => read!(i8),
            2 => read!(u8),
            3 => read!(i16),
            4 => read!(u16),
            5 => read!(i32),
            6 => read!(u32),
            7 => read!(f32),
            9 => read!(f64),
            12 => read!(i64),
            13 => read!(u64),
            kind => return Err(format!("numbers of type {kind}, which level 5 does not have")),
        })
    }
}
