//! The table of a life: a row for each stride, with the strides that are finished beside it until it is whole.

use super::{Kept, Life, LifeOptions, LifeStride, worn_life};
use crate::difference::SweepDifference;
use crate::ensemble::numbers_of;
use crate::error::StudyError;
use crate::journal::{self, Journal};
use crate::lock::OutputLock;
use crate::sweep::{Cell, Column, Format, Kind, Rows, decode, encode, write_rows};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::io::{Error, ErrorKind};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use tribodyn::CaseFile;

/// What makes two lives the same.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    tribodyn: String,
    case: String,
    model: String,
    strides: u32,
    until_s: Option<f64>,
    clearance_limit_m: Option<f64>,
}

impl journal::Identity for Identity {
    fn difference(&self, found: &Self) -> Option<SweepDifference> {
        let ends = |i: &Self| (i.strides, i.until_s, i.clearance_limit_m);
        match found {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.case != self.case => Some(SweepDifference::Case),
            o if o.model != self.model => Some(SweepDifference::Model { found: o.model.clone() }),
            o if ends(o) != ends(self) => Some(SweepDifference::Strides),
            _ => None,
        }
    }
}

/// A life with its finished strides on disk, beside the table that they will make.
pub struct LifeTable<'a> {
    file: &'a CaseFile,
    options: LifeOptions,
    path: PathBuf,
    format: Format,
    identity: Identity,
    journal: Journal,
    kept: Vec<Kept>,
    /// Let go of after everything else.
    _lock: OutputLock,
}

impl<'a> LifeTable<'a> {
    /// Opens the finished strides of a table, `.parquet` or `.csv` by its name, or begins with none; `restart` forgets
    /// those of a life that was stopped.
    ///
    /// # Errors
    /// A name with another ending, a table that another process writes, or finished strides of another life.
    pub fn open(file: &'a CaseFile, options: LifeOptions, path: &Path, restart: bool) -> Result<Self, StudyError> {
        let format = Format::of(path)?;
        let lock = OutputLock::take(path)?;
        let identity = Identity {
            tribodyn: env!("CARGO_PKG_VERSION").to_owned(),
            case: file.text.clone(),
            model: options.equations.name().to_owned(),
            strides: options.strides,
            until_s: options.until_s,
            clearance_limit_m: options.clearance_limit_m,
        };
        let one = |stride: usize| Some((stride, stride..stride + 1));
        let journal = Journal::open(path, &identity, &one, &kept_columns(), restart)?;
        let kept = journal.read().map(|line| read(&line?, &journal)).collect::<Result<_, _>>()?;
        Ok(Self { file, options, path: path.to_owned(), format, identity, journal, kept, _lock: lock })
    }

    /// Number of strides that an earlier run had finished.
    pub fn finished_strides(&self) -> usize {
        self.kept.len()
    }

    /// [`wear_life`](super::wear_life) from the last finished stride on; each is safe on disk as soon as it is.
    ///
    /// # Errors
    /// Those of a life, and a stride that cannot be written.
    pub fn wear(&mut self, progress: impl FnMut(&LifeStride) -> ControlFlow<()>) -> Result<Life, StudyError> {
        let journal = &mut self.journal;
        let mut keep = |stride: usize, kept: &Kept| {
            let cells = [Cell::Integer(stride as i64), Cell::Text(serde_json::to_string(kept)?)];
            journal.append(stride, &(encode(&cells) + "\n"))
        };
        worn_life(self.file, self.options.clone(), (std::mem::take(&mut self.kept), &mut keep), progress)
    }

    /// Writes the table, under its name only when it is whole; the finished strides beside it are removed.
    ///
    /// # Errors
    /// The table cannot be written.
    pub fn write(self, life: &Life) -> Result<(), StudyError> {
        let columns = numbers_of(&LifeStride::default())?;
        let columns: Vec<Column> = [Column::new("stride", Kind::Integer, false)]
            .into_iter()
            .chain(columns.into_iter().map(|(name, _)| Column::new(&name, Kind::Number, true)))
            .collect();
        let row = |(stride, row): (usize, &LifeStride)| {
            let numbers = numbers_of(row)?.into_iter().map(|(_, cell)| cell);
            Ok([Cell::Integer(stride as i64)].into_iter().chain(numbers).collect())
        };
        let rows: Vec<Vec<Cell>> = life.strides.iter().enumerate().map(row).collect::<Result<_, StudyError>>()?;
        let Identity { tribodyn, case, model, .. } = &self.identity;
        let notes = [("version", tribodyn), ("case", case), ("model", model)];
        let notes = notes.map(|(name, value)| (format!("tribodyn.{name}"), value.clone())).into();
        write_rows(&Rows::in_memory(&self.path, &columns, &rows), self.format, notes)?;
        self.journal.delete()
    }
}

/// Columns of a finished stride on disk: its number, and the rest as JSON.
pub(super) fn kept_columns() -> [Column; 2] {
    [Column::new("stride", Kind::Integer, false), Column::new("state", Kind::Text, false)]
}

/// A finished stride from its line on disk.
pub(super) fn read<T: DeserializeOwned>(line: &str, journal: &Journal) -> Result<T, StudyError> {
    let cells = decode(line.trim_end_matches('\n'), &kept_columns());
    match cells.as_deref() {
        Some([_, Cell::Text(text)]) => Ok(serde_json::from_str(text)?),
        _ => Err(StudyError::Write {
            path: journal.path().to_owned(),
            source: Error::new(ErrorKind::InvalidData, "a finished stride cannot be read"),
        }),
    }
}
