//! A member as a MATLAB file of level 5, whole and not packed, as the readers of public data sets expect it: a column
//! of samples for each sensor, and the speed.
//!
//! Format: The MathWorks, "MAT-File Format", version 5.

use super::row::{List, numbers, singles};
use crate::sweep::{Cell, Column};

const MATRIX: u32 = 14;
/// Types of data: unsigned and signed words, text, numbers of double and single precision.
const INT8: u32 = 1;
const INT32: u32 = 5;
const UINT32: u32 = 6;
const SINGLE: u32 = 7;
const DOUBLE: u32 = 9;
/// Classes of arrays.
const CLASS_DOUBLE: u32 = 6;
const CLASS_SINGLE: u32 = 7;

/// The file of a row: its numbers and its lists by the names of their columns.
pub(super) fn file(columns: &[(Column, Option<List>)], row: &[Cell]) -> Vec<u8> {
    let mut bytes = vec![b' '; 124];
    let text = b"MATLAB 5.0 MAT-file, written by tribodyn";
    bytes[..text.len()].copy_from_slice(text);
    bytes.extend([0x00, 0x01, b'I', b'M']);
    for ((column, list), cell) in columns.iter().zip(row) {
        match (list, cell) {
            (Some(List::Singles), _) => {
                let values = singles(cell);
                let data = values.iter().flat_map(|value| value.to_le_bytes()).collect();
                bytes.extend(matrix(&column.name, (CLASS_SINGLE, SINGLE), values.len(), data));
            }
            (Some(_), _) => bytes.extend(doubles(&column.name, &numbers(cell))),
            (None, Cell::Number(number)) => bytes.extend(doubles(&column.name, &[*number])),
            _ => {}
        }
    }
    bytes
}

fn doubles(name: &str, values: &[f64]) -> Vec<u8> {
    let data = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    matrix(name, (CLASS_DOUBLE, DOUBLE), values.len(), data)
}

/// A column of numbers.
fn matrix(name: &str, (class, kind): (u32, u32), rows: usize, data: Vec<u8>) -> Vec<u8> {
    let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let mut inside = element(UINT32, words(&[class, 0]));
    inside.extend(element(INT32, words(&[rows as u32, 1])));
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
