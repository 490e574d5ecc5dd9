//! Tables as Parquet.

use super::columns::{Cell, Column, Kind};
use super::table::{Count, Rows};
use crate::error::StudyError;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use std::io::Write;
use std::sync::Arc;

/// Rows that are held before they are written: about 10 MB.
const GROUP: usize = 1 << 14;

/// Writes all rows; `notes` become the file's key–value metadata.
pub(crate) fn write(
    writer: impl Write + Send,
    rows: &Rows<'_>,
    notes: Vec<(String, String)>,
) -> Result<Count, StudyError> {
    let failure = |error: ParquetError| rows.failure(std::io::Error::other(error));
    let properties = WriterProperties::builder()
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_created_by(concat!("tribodyn version ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(notes.into_iter().map(|(key, value)| KeyValue::new(key, value)).collect()))
        .build();
    let schema = schema(rows.columns).map_err(failure)?;
    let mut file = SerializedFileWriter::new(writer, schema, Arc::new(properties)).map_err(failure)?;
    let mut group: Vec<Vec<Cell>> = Vec::new();
    let count = rows.each(|_, cells| {
        group.push(cells);
        if group.len() == GROUP {
            write_group(&mut file, rows.columns, &mut group).map_err(failure)?;
        }
        Ok::<_, StudyError>(())
    })?;
    if !group.is_empty() {
        write_group(&mut file, rows.columns, &mut group).map_err(failure)?;
    }
    let mut writer = file.into_inner().map_err(failure)?;
    writer.flush().map_err(|source| rows.failure(source))?;
    Ok(count)
}

fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let field = |column: &Column| {
        let (physical, logical) = match column.kind {
            Kind::Integer => (Physical::INT64, None),
            Kind::Number => (Physical::DOUBLE, None),
            Kind::Truth => (Physical::BOOLEAN, None),
            Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let repetition = if column.optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let builder = Type::primitive_type_builder(&column.name, physical).with_repetition(repetition);
        builder.with_logical_type(logical).build().map(Arc::new)
    };
    let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
    Type::group_type_builder("sweep").with_fields(fields).build().map(Arc::new)
}

/// Writes the rows, and forgets them.
fn write_group(
    file: &mut SerializedFileWriter<impl Write + Send>,
    columns: &[Column],
    rows: &mut Vec<Vec<Cell>>,
) -> Result<(), ParquetError> {
    let mut group = file.next_row_group()?;
    for (index, column) in columns.iter().enumerate() {
        if let Some(writer) = group.next_column()? {
            write_column(writer, column, rows.iter().map(|row| &row[index]))?;
        }
    }
    group.close()?;
    rows.clear();
    Ok(())
}

fn write_column<'c>(
    mut writer: SerializedColumnWriter<'_>,
    column: &Column,
    cells: impl Iterator<Item = &'c Cell> + Clone,
) -> Result<(), ParquetError> {
    // Where a column may have nulls, level 1 marks a value and 0 a null.
    let levels: Option<Vec<i16>> =
        column.optional.then(|| cells.clone().map(|c| i16::from(*c != Cell::Null)).collect());
    let levels = levels.as_deref();
    match writer.untyped() {
        ColumnWriter::Int64ColumnWriter(w) => {
            let values: Vec<i64> =
                cells.filter_map(|c| if let Cell::Integer(n) = c { Some(*n) } else { None }).collect();
            w.write_batch(&values, levels, None)?;
        }
        ColumnWriter::DoubleColumnWriter(w) => {
            let values: Vec<f64> =
                cells.filter_map(|c| if let Cell::Number(v) = c { Some(*v) } else { None }).collect();
            w.write_batch(&values, levels, None)?;
        }
        ColumnWriter::BoolColumnWriter(w) => {
            let values: Vec<bool> =
                cells.filter_map(|c| if let Cell::Truth(t) = c { Some(*t) } else { None }).collect();
            w.write_batch(&values, levels, None)?;
        }
        ColumnWriter::ByteArrayColumnWriter(w) => {
            let text = |c: &Cell| if let Cell::Text(t) = c { Some(ByteArray::from(t.as_str())) } else { None };
            let values: Vec<ByteArray> = cells.filter_map(text).collect();
            w.write_batch(&values, levels, None)?;
        }
        _ => return Err(ParquetError::General(format!("column {} has no kind that is written here", column.name))),
    }
    writer.close()
}
