//! The finished table: CSV or Parquet, rows in the order of the grid.

use super::columns::{CONVERGED, Cell, Column, IMPLAUSIBLE, decode, encode, header};
use crate::error::StudyError;
use crate::files::StagedFiles;
use crate::journal::Journal;
use std::io::{BufWriter, Error, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tribodyn::answers::Equations;
use tribodyn::plausibility::advice;

/// File format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text, one row a line.
    Csv,
    /// Columns with types, compressed.
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Format {
    /// By the end of the name.
    ///
    /// # Errors
    /// A name that ends in neither.
    pub fn of(path: &Path) -> Result<Self, StudyError> {
        match path.extension().and_then(|e| e.to_str()) {
            Some("csv") => Ok(Self::Csv),
            #[cfg(feature = "parquet")]
            Some("parquet") => Ok(Self::Parquet),
            _ => {
                let allowed =
                    if cfg!(feature = "parquet") { ".parquet or .csv" } else { ".csv (this build has no Parquet)" };
                Err(StudyError::TableFormat { path: path.to_owned(), allowed })
            }
        }
    }
}

/// Rows of a table, how many of them are no solutions, and how many name what no bearing does.
#[derive(Debug, Clone, Copy, Default)]
pub struct Count {
    /// All rows.
    pub rows: usize,
    /// Those that are no solutions.
    pub failed: usize,
    /// Solutions that are implausible.
    pub implausible: usize,
}

/// Places of the columns by which rows are counted.
pub(crate) struct Marks {
    converged: Option<usize>,
    implausible: Option<usize>,
}

impl Marks {
    /// By the places of columns of a name.
    pub fn of(place: impl Fn(&str) -> Option<usize>) -> Self {
        Self { converged: place(CONVERGED), implausible: place(IMPLAUSIBLE) }
    }
}

impl Count {
    /// Counts what the fields of a row say at these places.
    pub(crate) fn add(&mut self, marks: &Marks, fails: impl Fn(usize) -> bool, names: impl Fn(usize) -> bool) {
        self.failed += usize::from(marks.converged.is_some_and(fails));
        self.implausible += usize::from(marks.implausible.is_some_and(names));
    }

    /// A warning where solutions are implausible, with what to do about it.
    pub fn warning(&self, model: Equations) -> Option<String> {
        let Self { rows, implausible, .. } = *self;
        (implausible > 0).then(|| {
            let column = IMPLAUSIBLE;
            format!("{implausible} of {rows} rows are implausible, the column `{column}` says what: {}", advice(model))
        })
    }
}

/// Writes the table from the finished rows, under its name only when it is whole. `notes` go into formats that have a
/// place for them.
pub(crate) fn write(rows: &Rows<'_>, format: Format, notes: Vec<(String, String)>) -> Result<Count, StudyError> {
    let path = rows.path;
    let failure = |source| StudyError::Write { path: path.to_owned(), source };
    let name = path.file_name().and_then(|name| name.to_str());
    let name = name.ok_or_else(|| failure(Error::new(ErrorKind::InvalidInput, "the name is not UTF-8 text")))?;
    let mut staged = StagedFiles::new(path.parent().unwrap_or(Path::new("")), true)?;
    let file = staged.create(name.to_owned())?;
    let kept = file.try_clone().map_err(failure)?;
    let writer = BufWriter::new(file);
    let count = match format {
        Format::Csv => rows.csv(writer)?,
        #[cfg(feature = "parquet")]
        Format::Parquet => super::parquet::write(writer, rows, notes)?,
    };
    #[cfg(not(feature = "parquet"))]
    drop(notes);
    // The finished rows are deleted after this: the table must be on the disk.
    kept.sync_all().map_err(failure)?;
    staged.publish()?;
    Ok(count)
}

/// Finished rows of a table.
pub struct Rows<'a> {
    path: &'a Path,
    /// Columns in order.
    pub columns: &'a [Column],
    source: Source<'a>,
}

/// Where finished rows are.
enum Source<'a> {
    Journal(&'a Journal),
    Memory(&'a [Vec<Cell>]),
}

impl<'a> Rows<'a> {
    /// The finished rows of a table that will stand at `path`.
    pub(crate) fn new(path: &'a Path, columns: &'a [Column], journal: &'a Journal) -> Self {
        Self { path, columns, source: Source::Journal(journal) }
    }

    /// Rows in memory, for a table that will stand at `path`.
    pub(crate) fn in_memory(path: &'a Path, columns: &'a [Column], rows: &'a [Vec<Cell>]) -> Self {
        Self { path, columns, source: Source::Memory(rows) }
    }

    /// Hands out each row as its line and its fields.
    ///
    /// # Errors
    /// A finished row cannot be read, or the failure of `take`.
    pub fn each<E: From<StudyError>>(
        &self,
        mut take: impl FnMut(&str, Vec<Cell>) -> Result<(), E>,
    ) -> Result<Count, E> {
        let marks = Marks::of(|name| self.columns.iter().position(|column| column.name == name));
        let mut count = Count::default();
        let mut one = |line: &str, cells: Vec<Cell>| {
            count.rows += 1;
            count.add(&marks, |at| cells[at] == Cell::Truth(false), |at| cells[at] != Cell::Null);
            take(line, cells)
        };
        match self.source {
            Source::Journal(journal) => {
                let unread = || self.failure(Error::new(ErrorKind::InvalidData, "a finished row cannot be read"));
                for lines in journal.read() {
                    for line in lines?.lines() {
                        one(line, decode(line, self.columns).ok_or_else(unread)?)?;
                    }
                }
            }
            Source::Memory(rows) => rows.iter().try_for_each(|cells| one(&encode(cells), cells.clone()))?,
        }
        Ok(count)
    }

    pub(crate) fn failure(&self, source: Error) -> StudyError {
        StudyError::Write { path: PathBuf::from(self.path), source }
    }

    fn csv(&self, mut writer: impl Write) -> Result<Count, StudyError> {
        let failure = |source| self.failure(source);
        writeln!(writer, "{}", header(self.columns)).map_err(failure)?;
        let count = self.each(|line, _| writeln!(writer, "{line}").map_err(failure))?;
        writer.flush().map_err(failure)?;
        Ok(count)
    }
}
