//! The table of an ensemble: a row a member.

use super::Ensemble;
use super::member::Member;
use crate::error::StudyError;
use crate::lock::OutputLock;
use crate::sweep::{Cell, Column, Format, Kind, Rows, write_rows};
use std::path::{Path, PathBuf};

/// The column that says whether a member came to its end.
pub const COMPLETE: &str = "complete";

/// A table that is not written yet.
pub struct EnsembleTable<'a> {
    ensemble: &'a Ensemble,
    path: PathBuf,
    format: Format,
    _lock: OutputLock,
}

impl EnsembleTable<'_> {
    /// Writes a row for each of the members. The table gets its name when it is whole.
    ///
    /// # Errors
    /// The table cannot be written.
    pub fn write(self, members: &[Member]) -> Result<(), StudyError> {
        let columns = self.ensemble.columns();
        let rows: Vec<Vec<Cell>> = members.iter().map(|member| self.ensemble.row(member)).collect();
        write_rows(&Rows::in_memory(&self.path, &columns, &rows), self.format, self.ensemble.notes()).map(drop)
    }
}

impl Ensemble {
    /// Columns of the table: the member's number, the varied values, whether it is complete, its figures, why not.
    pub fn columns(&self) -> Vec<Column> {
        let varied = self.axes.iter().map(|axis| axis.column.clone());
        let before = [Column::new("member", Kind::Integer, false)].into_iter().chain(varied);
        let figures = self.figures.iter().cloned();
        let error = [Column::new("error", Kind::Text, true)];
        before.chain([Column::new(COMPLETE, Kind::Truth, false)]).chain(figures).chain(error).collect()
    }

    /// The fields of a member's row.
    fn row(&self, member: &Member) -> Vec<Cell> {
        let varied = self.axes.iter().map(|axis| axis.cells[member.number].clone());
        let mut cells: Vec<Cell> = [Cell::Integer(member.number as i64)].into_iter().chain(varied).collect();
        match &member.figures {
            Ok(figures) => {
                cells.push(Cell::Truth(true));
                cells.extend(figures.iter().cloned());
                cells.push(Cell::Null);
            }
            Err(why) => {
                cells.push(Cell::Truth(false));
                cells.extend(self.figures.iter().map(|_| Cell::Null));
                cells.push(Cell::Text(why.clone()));
            }
        }
        cells
    }

    /// The table to write, `.parquet` or `.csv` by its name; nobody else writes it meanwhile.
    ///
    /// # Errors
    /// A name with another ending, or a table that another process writes.
    pub fn table(&self, path: &Path) -> Result<EnsembleTable<'_>, StudyError> {
        let format = Format::of(path)?;
        Ok(EnsembleTable { ensemble: self, path: path.to_owned(), format, _lock: OutputLock::take(path)? })
    }

    /// The notes on its ensemble in the file of a table, where that has a place for them.
    fn notes(&self) -> Vec<(String, String)> {
        let spreads = self.spreads.iter().map(|spread| format!("{}={}", spread.path, spread.text));
        [
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("case", self.base.text.clone()),
            ("vary", spreads.collect::<Vec<_>>().join("\n")),
            ("members", self.options.members.to_string()),
            ("seed", self.options.seed.to_string()),
        ]
        .map(|(name, value)| (format!("tribodyn.{name}"), value))
        .into()
    }
}
