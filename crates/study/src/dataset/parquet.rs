//! A data set as Parquet: a row a member, signals as lists of single precision.

use super::row::{List, numbers, singles};
use crate::sweep::{Cell, Column, Notes, field, properties, write_column};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::errors::ParquetError;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use std::io::Write;
use std::sync::Arc;

/// Rows that are held before they are written.
const GROUP: usize = 256;

/// Writes rows with the columns; `notes` become the file's key–value metadata.
pub(super) fn write<E: From<ParquetError>>(
    writer: impl Write + Send,
    columns: &[(Column, Option<List>)],
    notes: Notes,
    rows: impl Iterator<Item = Result<Vec<Cell>, E>>,
) -> Result<(), E> {
    let mut file = SerializedFileWriter::new(writer, schema(columns)?, properties(notes))?;
    let mut group = Vec::with_capacity(GROUP);
    for row in rows {
        group.push(row?);
        if group.len() == GROUP {
            write_group(&mut file, columns, &group)?;
            group.clear();
        }
    }
    if !group.is_empty() {
        write_group(&mut file, columns, &group)?;
    }
    file.into_inner()?.flush().map_err(ParquetError::from)?;
    Ok(())
}

fn schema(columns: &[(Column, Option<List>)]) -> Result<TypePtr, ParquetError> {
    let of = |(column, list): &(Column, Option<List>)| match list {
        None => field(column),
        Some(list) => list_of(&column.name, *list),
    };
    let fields = columns.iter().map(of).collect::<Result<_, _>>()?;
    Type::group_type_builder("dataset").with_fields(fields).build().map(Arc::new)
}

/// A list as the format has it: three levels.
fn list_of(name: &str, list: List) -> Result<TypePtr, ParquetError> {
    let physical = match list {
        List::Integers => Physical::INT64,
        List::Numbers => Physical::DOUBLE,
        List::Singles => Physical::FLOAT,
    };
    let element = Type::primitive_type_builder("element", physical).with_repetition(Repetition::REQUIRED).build()?;
    let repeated = Type::group_type_builder("list")
        .with_repetition(Repetition::REPEATED)
        .with_fields(vec![Arc::new(element)])
        .build()?;
    Type::group_type_builder(name)
        .with_repetition(Repetition::REQUIRED)
        .with_logical_type(Some(LogicalType::List))
        .with_fields(vec![Arc::new(repeated)])
        .build()
        .map(Arc::new)
}

fn write_group(
    file: &mut SerializedFileWriter<impl Write + Send>,
    columns: &[(Column, Option<List>)],
    rows: &[Vec<Cell>],
) -> Result<(), ParquetError> {
    let mut group = file.next_row_group()?;
    for (index, (column, list)) in columns.iter().enumerate() {
        let Some(writer) = group.next_column()? else { continue };
        let cells = rows.iter().map(|row| &row[index]);
        match list {
            None => write_column(writer, column, cells)?,
            Some(_) => write_lists(writer, cells)?,
        }
    }
    group.close()?;
    Ok(())
}

/// Levels of lists of these lengths: of definition, 0 for an empty list, and of repetition, 0 where a list begins.
fn levels(lengths: impl Iterator<Item = usize>) -> [Vec<i16>; 2] {
    let [mut definition, mut repetition] = [Vec::new(), Vec::new()];
    for length in lengths {
        definition.extend((0..length.max(1)).map(|_| i16::from(length > 0)));
        repetition.extend((0..length.max(1)).map(|k| i16::from(k > 0)));
    }
    [definition, repetition]
}

fn write_lists<'c>(
    mut writer: SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = &'c Cell>,
) -> Result<(), ParquetError> {
    match writer.untyped() {
        ColumnWriter::FloatColumnWriter(w) => {
            let lists: Vec<Vec<f32>> = cells.map(singles).collect();
            let [definition, repetition] = levels(lists.iter().map(Vec::len));
            w.write_batch(&lists.concat(), Some(&definition), Some(&repetition))?;
        }
        ColumnWriter::DoubleColumnWriter(w) => {
            let lists: Vec<Vec<f64>> = cells.map(numbers).collect();
            let [definition, repetition] = levels(lists.iter().map(Vec::len));
            w.write_batch(&lists.concat(), Some(&definition), Some(&repetition))?;
        }
        ColumnWriter::Int64ColumnWriter(w) => {
            let whole = |cell: &Cell| numbers(cell).into_iter().map(|number| number as i64).collect();
            let lists: Vec<Vec<i64>> = cells.map(whole).collect();
            let [definition, repetition] = levels(lists.iter().map(Vec::len));
            w.write_batch(&lists.concat(), Some(&definition), Some(&repetition))?;
        }
        _ => return Err(ParquetError::General("a list has no kind that is written here".to_owned())),
    }
    writer.close()
}
