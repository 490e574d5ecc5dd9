//! Signals as Parquet: every column of numbers.

use super::signal_file::{Column, SignalFile, damaged};
use crate::error::StudyError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs::File;
use std::path::Path;

/// Reads the columns whose cells are all numbers.
pub(super) fn read(path: &Path) -> Result<SignalFile, StudyError> {
    let file = File::open(path).map_err(|source| StudyError::Read { path: path.to_owned(), source })?;
    let refused = |error: parquet::errors::ParquetError| damaged(path, error.to_string());
    let reader = SerializedFileReader::new(file).map_err(refused)?;
    let columns = reader.metadata().file_metadata().schema().get_fields();
    if columns.first().is_some_and(|first| first.name() == "member") && columns.iter().any(|column| column.is_group()) {
        let why = "it is the table of a data set, with a signal in a cell: make the set with `dataset --mat` and give \
                   the file of a member, such as mat/000000.mat";
        return Err(damaged(path, why));
    }
    let mut columns: Vec<Option<Column>> = Vec::new();
    for row in reader.get_row_iter(None).map_err(refused)? {
        for (index, (name, field)) in row.map_err(refused)?.into_columns().into_iter().enumerate() {
            if index == columns.len() {
                columns.push(Some(Column { name, values: Vec::new() }));
            }
            match (number(&field), &mut columns[index]) {
                (Some(number), Some(column)) => column.values.push(number),
                (None, column) => *column = None,
                _ => {}
            }
        }
    }
    Ok(SignalFile::of(columns.into_iter().flatten().collect(), None))
}

fn number(field: &Field) -> Option<f64> {
    Some(match field {
        Field::Double(x) => *x,
        Field::Float(x) => f64::from(*x),
        Field::Byte(x) => f64::from(*x),
        Field::Short(x) => f64::from(*x),
        Field::Int(x) => f64::from(*x),
        Field::Long(x) => *x as f64,
        Field::UByte(x) => f64::from(*x),
        Field::UShort(x) => f64::from(*x),
        Field::UInt(x) => f64::from(*x),
        Field::ULong(x) => *x as f64,
        _ => return None,
    })
}
