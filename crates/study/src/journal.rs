//! Finished rows on disk while a sweep, an ensemble or a life goes on, so that one that was stopped can be taken up
//! again.
//!
//! The file `TABLE.rows` begins with a line that says which study it belongs to. Then come finished chunks, each as its
//! rows' lines in order, the chunks in the order in which they were finished. What a stop has left half written at the
//! end is cut off.

use crate::difference::SweepDifference;
use crate::error::StudyError;
use crate::files::with_suffix;
use crate::sweep::columns::{Cell, Column, decode};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Error, Read, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Identity of a study, the first line of its file: two of a kind with the same one are the same.
pub(crate) trait Identity: Serialize + DeserializeOwned {
    /// How the study of a file differs from this one.
    fn difference(&self, found: &Self) -> Option<SweepDifference>;
}

/// The chunk that begins with a row, by its number and its rows; none where no chunk of the study does.
pub(crate) type Chunks<'a> = &'a dyn Fn(usize) -> Option<(usize, Range<usize>)>;

/// Finished chunks on disk.
pub(crate) struct Journal {
    path: PathBuf,
    file: File,
    end: u64,
    /// Where each finished chunk stands: offset and length.
    chunks: BTreeMap<usize, (u64, usize)>,
}

impl Journal {
    /// Opens the journal of a table, with what is finished if it belongs to the same study.
    pub fn open(
        table: &Path,
        identity: &impl Identity,
        chunks: Chunks<'_>,
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
        if !fresh && let Some(difference) = difference(identity, &line) {
            return Err(StudyError::OtherSweep { path, difference });
        }
        let (chunks, end) = if fresh {
            (&file).seek(SeekFrom::Start(0)).and_then(|_| file.set_len(0)).map_err(write)?;
            (&file).write_all(&head).map_err(write)?;
            (BTreeMap::new(), head.len() as u64)
        } else {
            finished(&mut reader, line.len() as u64, chunks, columns).map_err(write)?
        };
        drop(reader);
        file.set_len(end).map_err(write)?;
        Ok(Self { path, file, end, chunks })
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// True if a chunk is finished.
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

/// How the study of a file's first line differs from another.
fn difference<I: Identity>(identity: &I, line: &[u8]) -> Option<SweepDifference> {
    match serde_json::from_slice::<I>(line) {
        Ok(found) => identity.difference(&found),
        Err(_) => Some(SweepDifference::Unknown),
    }
}

type Finished = (BTreeMap<usize, (u64, usize)>, u64);

/// The whole chunks from `start` on, and where they end.
fn finished(reader: &mut impl BufRead, start: u64, chunks: Chunks<'_>, columns: &[Column]) -> Result<Finished, Error> {
    let (mut found, mut end) = (BTreeMap::new(), start);
    loop {
        let mut length = 0;
        let Some(first) = next_row(reader, columns, &mut length)? else { return Ok((found, end)) };
        let Some((chunk, rows)) = chunks(first).filter(|(chunk, _)| !found.contains_key(chunk)) else {
            return Ok((found, end));
        };
        for row in rows.skip(1) {
            if next_row(reader, columns, &mut length)? != Some(row) {
                return Ok((found, end));
            }
        }
        found.insert(chunk, (end, length));
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
