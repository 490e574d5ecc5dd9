//! A member as a MATLAB file of level 5, whole and not packed, as the readers of public data sets expect it: a column
//! of samples for each sensor, and its labels.
//!
//! Format: The MathWorks, "MAT-File Format", version 5.

use super::row::{List, numbers, singles};
use crate::error::StudyError;
use crate::sweep::{Cell, Column};
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

const MATRIX: u32 = 14;
/// Types of data: unsigned and signed words, text, numbers of double and single precision.
const INT8: u32 = 1;
const INT32: u32 = 5;
const UINT16: u32 = 4;
const UINT32: u32 = 6;
const SINGLE: u32 = 7;
const DOUBLE: u32 = 9;
/// Classes of arrays.
const CLASS_TEXT: u32 = 4;
const CLASS_DOUBLE: u32 = 6;
const CLASS_SINGLE: u32 = 7;

/// Beginning of each file.
const TITLE: &[u8] = b"MATLAB 5.0 MAT-file, written by tribodyn";
/// A column whose name is a word of the language.
const RESERVED: &str = "case";

/// Name of the file of a member.
pub(super) fn name(member: usize) -> String {
    format!("{member:06}.mat")
}

/// Removes the files of members from a number on that an earlier set has left in a folder.
pub(super) fn remove_from(folder: &Path, members: usize) -> Result<(), StudyError> {
    let Ok(entries) = fs::read_dir(folder) else { return Ok(()) };
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        let stem = path.file_stem().and_then(|stem| stem.to_str()).and_then(|stem| stem.parse().ok());
        let stale = stem.is_some_and(|number| number >= members && path.ends_with(name(number)));
        let mut title = vec![0; TITLE.len()];
        if stale && File::open(&path).is_ok_and(|mut file| file.read_exact(&mut title).is_ok()) && title == TITLE {
            fs::remove_file(&path).map_err(|source| StudyError::Write { path: path.clone(), source })?;
        }
    }
    // Only an empty folder goes.
    let _ = fs::remove_dir(folder);
    Ok(())
}

/// The file of a row: its fields by the names of their columns; one that is empty is not there, and of the columns not
/// `case`, which is a word of the language.
pub(super) fn file(columns: &[(Column, Option<List>)], row: &[Cell]) -> Vec<u8> {
    let mut bytes = vec![b' '; 124];
    bytes[..TITLE.len()].copy_from_slice(TITLE);
    bytes.extend([0x00, 0x01, b'I', b'M']);
    for ((column, list), cell) in columns.iter().zip(row) {
        match (list, cell) {
            (Some(List::Singles), _) => {
                let values = singles(cell);
                let data = values.iter().flat_map(|value| value.to_le_bytes()).collect();
                bytes.extend(matrix(&column.name, (CLASS_SINGLE, SINGLE), [values.len(), 1], data));
            }
            (Some(_), _) => bytes.extend(doubles(&column.name, &numbers(cell))),
            (None, Cell::Number(number)) => bytes.extend(doubles(&column.name, &[*number])),
            (None, Cell::Integer(number)) => bytes.extend(doubles(&column.name, &[*number as f64])),
            (None, Cell::Text(text)) if column.name != RESERVED => {
                let letters: Vec<u16> = text.encode_utf16().collect();
                let data = letters.iter().flat_map(|letter| letter.to_le_bytes()).collect();
                bytes.extend(matrix(&column.name, (CLASS_TEXT, UINT16), [1, letters.len()], data));
            }
            _ => {}
        }
    }
    bytes
}

fn doubles(name: &str, values: &[f64]) -> Vec<u8> {
    let data = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    matrix(name, (CLASS_DOUBLE, DOUBLE), [values.len(), 1], data)
}

/// An array of a shape.
fn matrix(name: &str, (class, kind): (u32, u32), shape: [usize; 2], data: Vec<u8>) -> Vec<u8> {
    let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let mut inside = element(UINT32, words(&[class, 0]));
    inside.extend(element(INT32, words(&shape.map(|length| length as u32))));
    inside.extend(element(INT8, name.as_bytes().to_vec()));
    inside.extend(element(kind, data));
    element(MATRIX, inside)
}

fn element(kind: u32, data: Vec<u8>) -> Vec<u8> {
    let mut bytes = kind.to_le_bytes().to_vec();
    bytes.extend((data.len() as u32).to_le_bytes());
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}
