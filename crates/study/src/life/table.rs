//! The table of a life: a row for each stride, with the strides that are finished beside it until it is whole.

use super::strides::Strides;
use super::{Kept, Life, LifeOptions, LifeStride, worn_life};
use crate::difference::SweepDifference;
use crate::ensemble::numbers_of;
use crate::error::StudyError;
use crate::journal;
use crate::sweep::{Cell, Column, Kind, Rows, write_rows};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::path::Path;
use tribodyn::CaseFile;

/// Identity of a life: two with the same one are the same.
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
    identity: Identity,
    strides: Strides<Kept>,
}

impl<'a> LifeTable<'a> {
    /// Opens the finished strides of a table, `.parquet` or `.csv` by its name, or begins with none; `restart` forgets
    /// those of a life that was stopped.
    ///
    /// # Errors
    /// A name with another ending, a table that another process writes, or finished strides of another life.
    pub fn open(file: &'a CaseFile, options: LifeOptions, path: &Path, restart: bool) -> Result<Self, StudyError> {
        let identity = Identity {
            tribodyn: env!("CARGO_PKG_VERSION").to_owned(),
            case: file.text.clone(),
            model: options.equations.name().to_owned(),
            strides: options.strides,
            until_s: options.until_s,
            clearance_limit_m: options.clearance_limit_m,
        };
        let strides = Strides::open(path, &identity, restart)?;
        Ok(Self { file, options, identity, strides })
    }

    /// Number of strides that an earlier run had finished.
    pub fn finished_strides(&self) -> usize {
        self.strides.finished()
    }

    /// [`wear_life`](super::wear_life) from the last finished stride on; each is safe on disk as soon as it is.
    ///
    /// # Errors
    /// Those of a life, and a stride that cannot be written.
    pub fn wear(&mut self, progress: impl FnMut(&LifeStride) -> ControlFlow<()>) -> Result<Life, StudyError> {
        let (finished, mut keep) = self.strides.go_on();
        worn_life(self.file, self.options.clone(), (finished, &mut keep), progress)
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
        write_rows(&Rows::in_memory(self.strides.path(), &columns, &rows), self.strides.format(), notes)?;
        self.strides.delete()
    }
}
