//! Finished strides of a life on disk, beside the table that they will make: each by its number with all that the next
//! one goes on from, as JSON.

use crate::error::StudyError;
use crate::journal::{Identity, Journal};
use crate::lock::OutputLock;
use crate::sweep::{Cell, Column, Format, Kind, decode, encode};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

pub(super) struct Strides<K> {
    path: PathBuf,
    format: Format,
    journal: Journal,
    kept: Vec<K>,
    /// Let go of after everything else.
    _lock: OutputLock,
}

impl<K: Serialize + DeserializeOwned> Strides<K> {
    /// Opens the finished strides of a table, `.parquet` or `.csv` by its name, or begins with none; `restart` forgets
    /// those of a life that was stopped.
    ///
    /// # Errors
    /// A name with another ending, a table that another process writes, or finished strides of another life.
    pub fn open(path: &Path, identity: &impl Identity, restart: bool) -> Result<Self, StudyError> {
        let format = Format::of(path)?;
        let lock = OutputLock::take(path)?;
        let one = |stride: usize| Some((stride, stride..stride + 1));
        let journal = Journal::open(path, identity, &one, &columns(), restart)?;
        let kept = journal.read().map(|line| read(&line?, &journal)).collect::<Result<_, _>>()?;
        Ok(Self { path: path.to_owned(), format, journal, kept, _lock: lock })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    pub fn format(&self) -> Format {
        self.format
    }

    /// Number of strides that an earlier run had finished.
    pub fn finished(&self) -> usize {
        self.kept.len()
    }

    /// Those strides, and the way of further ones to the disk, on which each is safe as soon as it is there.
    pub fn go_on(&mut self) -> (Vec<K>, impl FnMut(usize, &K) -> Result<(), StudyError>) {
        let journal = &mut self.journal;
        let keep = move |stride: usize, kept: &K| {
            let cells = [Cell::Integer(stride as i64), Cell::Text(serde_json::to_string(kept)?)];
            journal.append(stride, &(encode(&cells) + "\n"))
        };
        (std::mem::take(&mut self.kept), keep)
    }

    /// Removes the finished strides: the table is whole.
    ///
    /// # Errors
    /// They cannot be removed.
    pub fn delete(self) -> Result<(), StudyError> {
        self.journal.delete()
    }
}

fn columns() -> [Column; 2] {
    [Column::new("stride", Kind::Integer, false), Column::new("state", Kind::Text, false)]
}

/// A finished stride from its line on disk.
fn read<K: DeserializeOwned>(line: &str, journal: &Journal) -> Result<K, StudyError> {
    let cells = decode(line.trim_end_matches('\n'), &columns());
    match cells.as_deref() {
        Some([_, Cell::Text(text)]) => Ok(serde_json::from_str(text)?),
        _ => Err(StudyError::Write {
            path: journal.path().to_owned(),
            source: Error::new(ErrorKind::InvalidData, "a finished stride cannot be read"),
        }),
    }
}
