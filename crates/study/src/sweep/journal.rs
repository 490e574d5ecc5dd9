//! Finished rows on disk while a sweep runs, so that one that was stopped can go on.
//!
//! The file `TABLE.rows` begins with a line that says which sweep it belongs to. Then come finished chunks, each as its
//! rows' lines in order, the chunks in the order in which they were finished. What a stop has left half written at the
//! end is cut off.

use super::columns::{Cell, Column, decode};
use super::difference::SweepDifference;
use super::grid::Grid;
use super::shard::Shard;
use crate::error::StudyError;
use crate::files::with_suffix;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Error, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// What makes two sweeps the same.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Identity {
    /// Version of the command; another may give other numbers.
    pub tribodyn: String,
    /// The case's text with the changes of a single value.
    pub case: String,
    /// Name of the model.
    pub model: String,
    /// Swept paths and their values.
    pub swept: Vec<(String, Vec<String>)>,
    pub shard: Shard,
    pub cold: bool,
}

impl Identity {
    pub fn new(grid: &Grid, shard: Shard, cold: bool) -> Self {
        let swept = grid.values().into_iter().map(|(path, values)| (path.to_owned(), values.to_vec())).collect();
        let (tribodyn, model) = (env!("CARGO_PKG_VERSION").to_owned(), grid.model.name().to_owned());
        Self { tribodyn, case: grid.base().to_owned(), model, swept, shard, cold }
    }

    /// What the file of a table says of its sweep.
    pub fn notes(&self) -> Result<Vec<(String, String)>, StudyError> {
        let note = |name: &str, value| (name.to_owned(), value);
        Ok(vec![
            note(NOTES[0], self.tribodyn.clone()),
            note(NOTES[1], self.case.clone()),
            note(NOTES[2], self.model.clone()),
            note(NOTES[3], serde_json::to_string(&self.swept)?),
            note(SHARD_NOTE, self.shard.to_string()),
        ])
    }

    /// How the sweep of a journal differs from this one.
    fn difference(&self, line: &[u8]) -> Option<SweepDifference> {
        let Ok(other) = serde_json::from_slice::<Self>(line) else {
            return Some(SweepDifference::Unknown);
        };
        match &other {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.case != self.case => Some(SweepDifference::Case),
            o if o.model != self.model => Some(SweepDifference::Model { found: o.model.clone() }),
            o if o.swept != self.swept => Some(SweepDifference::Values),
            o if o.shard != self.shard => Some(SweepDifference::Shard { found: o.shard.to_string() }),
            o if o.cold != self.cold => Some(SweepDifference::Cold),
            _ => None,
        }
    }
}

/// Keys in the file of a table that are the same for all parts of a sweep: version, case, model, swept values.
pub const NOTES: [&str; 4] = ["tribodyn.version", "tribodyn.case", "tribodyn.model", "tribodyn.swept"];
/// Key of the part.
pub const SHARD_NOTE: &str = "tribodyn.shard";

/// Finished chunks on disk.
pub struct Journal {
    path: PathBuf,
    file: File,
    end: u64,
    /// Where each finished chunk stands: offset and length.
    chunks: BTreeMap<usize, (u64, usize)>,
}

impl Journal {
    /// Opens the journal of a table, with what is finished if it belongs to the same sweep.
    pub fn open(
        table: &Path,
        identity: &Identity,
        grid: &Grid,
        columns: &[Column],
        restart: bool,
    ) -> Result<Self, StudyError> {
        let path = with_suffix(table, ".rows");
        let write = |source| StudyError::Write { path: path.clone(), source };
        let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).map_err(write)?;
        let mut head = serde_json::to_vec(identity)?;
        head.push(b'\n');
        let mut reader = BufReader::new(&file);
        let mut line = Vec::new();
        reader.read_until(b'\n', &mut line).map_err(write)?;
        // A first line without an end was stopped at birth.
        let fresh = restart || line.last() != Some(&b'\n');
        if !fresh && let Some(difference) = identity.difference(&line) {
            return Err(StudyError::OtherSweep { path, difference });
        }
        let (chunks, end) = if fresh {
            (&file).seek(SeekFrom::Start(0)).and_then(|_| file.set_len(0)).map_err(write)?;
            (&file).write_all(&head).map_err(write)?;
            (BTreeMap::new(), head.len() as u64)
        } else {
            finished(&mut reader, line.len() as u64, grid, identity.shard, columns).map_err(write)?
        };
        drop(reader);
        file.set_len(end).map_err(write)?;
        Ok(Self { path, file, end, chunks })
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether a chunk is finished.
    pub fn has(&self, chunk: usize) -> bool {
        self.chunks.contains_key(&chunk)
    }

    /// Adds a finished chunk; once this returns, the rows outlast the process.
    pub fn append(&mut self, chunk: usize, lines: &str) -> Result<(), StudyError> {
        let written = self.file.seek(SeekFrom::Start(self.end)).and_then(|_| self.file.write_all(lines.as_bytes()));
        written.and_then(|()| self.file.sync_data()).map_err(|source| self.failure(source))?;
        self.chunks.insert(chunk, (self.end, lines.len()));
        self.end += lines.len() as u64;
        Ok(())
    }

    /// The lines of all finished chunks, in the order of the grid, a chunk at a time.
    pub fn read(&self) -> impl Iterator<Item = Result<String, StudyError>> {
        self.chunks.values().map(|&(offset, length)| {
            let mut text = String::new();
            let mut file = &self.file;
            let read =
                file.seek(SeekFrom::Start(offset)).and_then(|_| file.take(length as u64).read_to_string(&mut text));
            match read {
                Ok(found) if found == length => Ok(text),
                Ok(_) => Err(self.failure(Error::from(std::io::ErrorKind::UnexpectedEof))),
                Err(source) => Err(self.failure(source)),
            }
        })
    }

    /// Removes the file: the table has it all.
    pub fn delete(self) -> Result<(), StudyError> {
        std::fs::remove_file(&self.path).map_err(|source| self.failure(source))
    }

    fn failure(&self, source: Error) -> StudyError {
        StudyError::Write { path: self.path.clone(), source }
    }
}

type Finished = (BTreeMap<usize, (u64, usize)>, u64);

/// The whole chunks from `start` on, and where they end.
fn finished(
    reader: &mut impl BufRead,
    start: u64,
    grid: &Grid,
    shard: Shard,
    columns: &[Column],
) -> Result<Finished, Error> {
    let (mut chunks, mut end) = (BTreeMap::new(), start);
    loop {
        let mut length = 0;
        let Some(first) = next_row(reader, columns, &mut length)? else { return Ok((chunks, end)) };
        let chunk = first / grid.chunk_rows();
        let rows = if chunk < grid.chunks() { grid.chunk(chunk) } else { 0..0 };
        if rows.start != first || rows.is_empty() || !shard.has(chunk) || chunks.contains_key(&chunk) {
            return Ok((chunks, end));
        }
        for row in rows.skip(1) {
            if next_row(reader, columns, &mut length)? != Some(row) {
                return Ok((chunks, end));
            }
        }
        chunks.insert(chunk, (end, length));
        end += length as u64;
    }
}

/// The number of the row in the next line, `None` where that is no whole row. Counts the bytes read.
fn next_row(reader: &mut impl BufRead, columns: &[Column], length: &mut usize) -> Result<Option<usize>, Error> {
    let mut line = Vec::new();
    *length += reader.read_until(b'\n', &mut line)?;
    let text = line.strip_suffix(b"\n").and_then(|line| std::str::from_utf8(line).ok());
    let cells = text.and_then(|text| decode(text, columns));
    Ok(cells.and_then(|cells| match cells[0] {
        Cell::Integer(row) => usize::try_from(row).ok(),
        _ => None,
    }))
}
