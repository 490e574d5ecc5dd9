//! Tables of shards, or of parts, as the one table of the whole sweep.
//!
//! Rows go through memory one at a time: tables may be larger than it. Each table has its rows in order, so that the
//! next row is the first unread one of some table.

#[cfg(feature = "parquet")]
use super::columns::Column;
use super::table::{Count, Format, Marks};
use crate::error::StudyError;
use crate::files::StagedFiles;
use std::fs::File;
use std::io::{BufRead, BufReader, BufWriter, Error, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A table that was put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Merged {
    /// Tables that it was made of.
    pub tables: usize,
    /// Rows of the whole.
    pub rows: usize,
    /// Rows that are no solutions.
    pub failed: usize,
    /// Solutions that are implausible.
    pub implausible: usize,
}

/// Writes the rows of some tables of one sweep into one, in the order of the sweep: every row exactly once.
///
/// # Errors
/// Tables of different kinds, columns or sweeps, a row that is there twice or not at all, and a table that cannot be
/// read or written.
pub fn merge(tables: &[PathBuf], output: &Path, force: bool) -> Result<Merged, StudyError> {
    let format = Format::of(output)?;
    let Some(first) = tables.first() else {
        return Err(StudyError::argument("merge", "nothing", "allowed are two tables or more"));
    };
    for table in tables {
        if Format::of(table)? != format {
            return Err(apart(table, format!("it is not of the kind of {}", output.display())));
        }
        if table.canonicalize().ok().is_some_and(|table| output.canonicalize().is_ok_and(|output| output == table)) {
            return Err(apart(table, "it would be replaced by the whole".to_owned()));
        }
    }
    let failure = |source| StudyError::Write { path: output.to_owned(), source };
    let name = output.file_name().and_then(|name| name.to_str());
    let name = name.ok_or_else(|| failure(Error::new(ErrorKind::InvalidInput, "the name is not UTF-8 text")))?;
    let mut staged = StagedFiles::new(output.parent().unwrap_or(Path::new("")), force)?;
    let file = staged.create(name.to_owned())?;
    let kept = file.try_clone().map_err(failure)?;
    let writer = BufWriter::new(file);
    let count = match format {
        Format::Csv => lines(tables, first, writer, failure)?,
        #[cfg(feature = "parquet")]
        Format::Parquet => super::parquet::merge(tables, first, writer, output)?,
    };
    kept.sync_all().map_err(failure)?;
    staged.publish()?;
    let Count { rows, failed, implausible } = count;
    Ok(Merged { tables: tables.len(), rows, failed, implausible })
}

/// A table that does not go with the others.
pub(crate) fn apart(path: &Path, why: String) -> StudyError {
    StudyError::Merge { path: path.to_owned(), why }
}

/// A reader of rows with their numbers.
type Numbered<T> = Box<dyn Iterator<Item = Result<(usize, T), StudyError>>>;

/// Takes rows from tables in the order of their numbers.
pub(crate) fn in_order<T>(
    tables: &[PathBuf],
    mut readers: Vec<Numbered<T>>,
    mut take: impl FnMut(T) -> Result<(), StudyError>,
) -> Result<usize, StudyError> {
    let mut heads: Vec<Option<(usize, T)>> =
        readers.iter_mut().map(|reader| reader.next().transpose()).collect::<Result<_, _>>()?;
    let mut expected = 0;
    loop {
        let least = |(i, head): (usize, &Option<(usize, T)>)| head.as_ref().map(|(row, _)| (*row, i));
        let Some((row, place)) = heads.iter().enumerate().filter_map(least).min() else { return Ok(expected) };
        if row < expected {
            return Err(apart(&tables[place], format!("row {row} is there twice, or out of order")));
        }
        if row > expected {
            let missing =
                if row == expected + 1 { format!("row {expected}") } else { format!("rows {expected} to {}", row - 1) };
            return Err(apart(
                &tables[place],
                format!("{missing} are in none of the tables; this one goes on with {row}"),
            ));
        }
        let next = readers[place].next().transpose()?;
        if let Some((_, fields)) = std::mem::replace(&mut heads[place], next) {
            take(fields)?;
        }
        expected += 1;
    }
}

/// CSV: lines as they are.
fn lines(
    tables: &[PathBuf],
    first: &Path,
    mut writer: impl Write,
    failure: impl Fn(Error) -> StudyError,
) -> Result<Count, StudyError> {
    let mut header = None;
    let mut readers: Vec<Numbered<String>> = Vec::new();
    for table in tables {
        let read = |source| StudyError::Read { path: table.clone(), source };
        let mut reader = BufReader::new(File::open(table).map_err(read)?);
        let mut line = String::new();
        reader.read_line(&mut line).map_err(read)?;
        if header.get_or_insert_with(|| line.clone()) != &line {
            return Err(apart(table, format!("its columns are not those of {}", first.display())));
        }
        readers.push(Box::new(numbered(table.clone(), reader)));
    }
    let header = header.unwrap_or_default();
    let marks = Marks::of(|name| header.trim_end().split(',').position(|known| known == name));
    if !header.starts_with("row,") {
        return Err(apart(first, "it is not a table of a sweep: its first column is not `row`".to_owned()));
    }
    writer.write_all(header.as_bytes()).map_err(&failure)?;
    let mut count = Count::default();
    count.rows = in_order(tables, readers, |line| {
        let named = |at| field(&line, at).is_some_and(|names| !names.is_empty());
        count.add(&marks, |at| field(&line, at) == Some("false"), named);
        writeln!(writer, "{line}").map_err(&failure)
    })?;
    writer.flush().map_err(&failure)?;
    Ok(count)
}

fn numbered(table: PathBuf, reader: impl BufRead) -> impl Iterator<Item = Result<(usize, String), StudyError>> {
    reader.lines().map(move |line| {
        let line = line.map_err(|source| StudyError::Read { path: table.clone(), source })?;
        let row = line.split(',').next().and_then(|row| row.parse().ok());
        row.map(|row| (row, line)).ok_or_else(|| apart(&table, "a line of it has no number of a row".to_owned()))
    })
}

/// A field of a line of CSV; commas in quotes are no ends of fields.
fn field(line: &str, at: usize) -> Option<&str> {
    let mut quoted = false;
    let separator = |c: char| {
        quoted ^= c == '"';
        c == ',' && !quoted
    };
    line.split(separator).nth(at)
}

/// Refuses columns that are not those of the first table.
#[cfg(feature = "parquet")]
pub(crate) fn same_columns(first: &Path, table: &Path, known: &[Column], found: &[Column]) -> Result<(), StudyError> {
    if known == found {
        return Ok(());
    }
    let differs = known.iter().zip(found).find(|(known, found)| known != found);
    let column = differs.map_or_else(|| "their number".to_owned(), |(_, found)| format!("`{}`", found.name));
    Err(apart(table, format!("its columns are not those of {}: {column}", first.display())))
}
