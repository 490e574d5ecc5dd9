//! Tables as Parquet.

use super::columns::{Cell, Column, Kind};
use super::identity::{NOTES, SHARD_NOTE};
use super::merge::{apart, in_order, same_columns};
use super::table::{Count, Marks, Rows};
use crate::error::StudyError;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::record::{Field, Row};
use parquet::schema::types::{Type, TypePtr};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Keys and values beside the rows.
pub(crate) type Notes = Vec<(String, String)>;

/// Rows that are held before they are written: about 10 MB.
const GROUP: usize = 1 << 14;

/// Writes all rows; `notes` become the file's key–value metadata.
pub(crate) fn write(
    writer: impl Write + Send,
    rows: &Rows<'_>,
    notes: Vec<(String, String)>,
) -> Result<Count, StudyError> {
    let failure = |error: ParquetError| rows.failure(std::io::Error::other(error));
    let mut output = Output::begin(writer, rows.columns, notes).map_err(failure)?;
    let count = rows.each(|_, cells| output.add(cells).map_err(failure))?;
    output.end().map_err(failure)?;
    Ok(count)
}

/// How our tables are packed and signed, with notes as key–value metadata.
pub(crate) fn properties(notes: Notes) -> Arc<WriterProperties> {
    let properties = WriterProperties::builder()
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_created_by(concat!("tribodyn version ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(notes.into_iter().map(|(key, value)| KeyValue::new(key, value)).collect()))
        .build();
    Arc::new(properties)
}

/// A table that is being written.
struct Output<'a, W: Write + Send> {
    file: SerializedFileWriter<W>,
    columns: &'a [Column],
    group: Vec<Vec<Cell>>,
}

impl<'a, W: Write + Send> Output<'a, W> {
    fn begin(writer: W, columns: &'a [Column], notes: Vec<(String, String)>) -> Result<Self, ParquetError> {
        let file = SerializedFileWriter::new(writer, schema(columns)?, properties(notes))?;
        Ok(Self { file, columns, group: Vec::new() })
    }

    fn add(&mut self, cells: Vec<Cell>) -> Result<(), ParquetError> {
        self.group.push(cells);
        if self.group.len() == GROUP { self.write() } else { Ok(()) }
    }

    fn write(&mut self) -> Result<(), ParquetError> {
        write_group(&mut self.file, self.columns, &mut self.group)
    }

    fn end(mut self) -> Result<(), ParquetError> {
        if !self.group.is_empty() {
            self.write()?;
        }
        self.file.into_inner()?.flush()?;
        Ok(())
    }
}

/// The rows of some tables of one sweep as one table.
pub(crate) fn merge(
    tables: &[PathBuf],
    first: &Path,
    writer: impl Write + Send,
    path: &Path,
) -> Result<Count, StudyError> {
    let failure = |source| StudyError::Write { path: path.to_owned(), source: std::io::Error::other(source) };
    let mut readers: Vec<Box<dyn Iterator<Item = _>>> = Vec::new();
    let (mut notes, mut columns): (Option<Notes>, Option<Vec<Column>>) = (None, None);
    for table in tables {
        let read = Table::open(table)?;
        let known = notes.get_or_insert_with(|| read.notes.clone());
        if let Some(((key, _), _)) = known.iter().zip(&read.notes).find(|(known, found)| known != found) {
            let what = key.rsplit('.').next().unwrap_or(key);
            return Err(apart(table, format!("it is of another sweep than {}: another {what}", first.display())));
        }
        same_columns(first, table, columns.get_or_insert_with(|| read.columns.clone()), &read.columns)?;
        readers.push(Box::new(read));
    }
    let (mut notes, columns) = (notes.unwrap_or_default(), columns.unwrap_or_default());
    notes.push((SHARD_NOTE.to_owned(), "0/1".to_owned()));
    let marks = Marks::of(|name| columns.iter().position(|column| column.name == name));
    let mut output = Output::begin(writer, &columns, notes).map_err(failure)?;
    let mut count = Count::default();
    count.rows = in_order(tables, readers, |cells: Vec<Cell>| {
        count.add(&marks, |at| cells[at] == Cell::Truth(false), |at| cells[at] != Cell::Null);
        output.add(cells).map_err(failure)
    })?;
    output.end().map_err(failure)?;
    Ok(count)
}

/// A table that is being read.
struct Table {
    path: PathBuf,
    columns: Vec<Column>,
    /// Notes that are the same for all parts of a sweep.
    notes: Notes,
    rows: parquet::record::reader::RowIter<'static>,
}

impl Table {
    fn open(path: &Path) -> Result<Self, StudyError> {
        let failure = |error| StudyError::Read { path: path.to_owned(), source: std::io::Error::other(error) };
        let file = File::open(path).map_err(|source| StudyError::Read { path: path.to_owned(), source })?;
        let reader = SerializedFileReader::new(file).map_err(|error: ParquetError| failure(error))?;
        let metadata = reader.metadata().file_metadata();
        let found = metadata.key_value_metadata().into_iter().flatten();
        let found: Notes = found.filter_map(|note| Some((note.key.clone(), note.value.clone()?))).collect();
        let note = |key: &&str| found.iter().find(|(found, _)| found == key).cloned();
        let notes: Notes = NOTES.iter().filter_map(note).collect();
        let columns: Option<Vec<Column>> = metadata.schema().get_fields().iter().map(|field| column(field)).collect();
        let columns = columns.filter(|columns| columns.first().is_some_and(|first| first.name == "row"));
        let columns = columns.ok_or_else(|| apart(path, "it is not a table of a sweep".to_owned()))?;
        let rows = parquet::record::reader::RowIter::from_file_into(Box::new(reader));
        Ok(Self { path: path.to_owned(), columns, notes, rows })
    }
}

impl Iterator for Table {
    type Item = Result<(usize, Vec<Cell>), StudyError>;

    fn next(&mut self) -> Option<Self::Item> {
        let row = self.rows.next()?;
        let read =
            |error: ParquetError| StudyError::Read { path: self.path.clone(), source: std::io::Error::other(error) };
        Some(row.map_err(read).and_then(|row| {
            let cells = cells(row);
            let number = match cells.as_deref() {
                Some([Cell::Integer(number), ..]) => usize::try_from(*number).ok(),
                _ => None,
            };
            number.zip(cells).ok_or_else(|| apart(&self.path, "one of its rows is not from a sweep".to_owned()))
        }))
    }
}

fn column(field: &Type) -> Option<Column> {
    if !field.is_primitive() {
        return None;
    }
    let kind = match field.get_physical_type() {
        Physical::INT64 => Kind::Integer,
        Physical::DOUBLE => Kind::Number,
        Physical::BOOLEAN => Kind::Truth,
        Physical::BYTE_ARRAY => Kind::Text,
        _ => return None,
    };
    Some(Column::new(field.name(), kind, field.get_basic_info().repetition() == Repetition::OPTIONAL))
}

fn cells(row: Row) -> Option<Vec<Cell>> {
    let cell = |(_, field): (String, Field)| match field {
        Field::Null => Some(Cell::Null),
        Field::Bool(truth) => Some(Cell::Truth(truth)),
        Field::Long(number) => Some(Cell::Integer(number)),
        Field::Double(number) => Some(Cell::Number(number)),
        Field::Str(text) => Some(Cell::Text(text)),
        _ => None,
    };
    row.into_columns().into_iter().map(cell).collect()
}

/// A column as the format has it.
pub(crate) fn field(column: &Column) -> Result<TypePtr, ParquetError> {
    let (physical, logical) = match column.kind {
        Kind::Integer => (Physical::INT64, None),
        Kind::Number => (Physical::DOUBLE, None),
        Kind::Truth => (Physical::BOOLEAN, None),
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let repetition = if column.optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
    let builder = Type::primitive_type_builder(&column.name, physical).with_repetition(repetition);
    builder.with_logical_type(logical).build().map(Arc::new)
}

fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
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

/// Writes the cells of a column.
pub(crate) fn write_column<'c>(
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
