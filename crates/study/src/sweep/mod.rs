//! Equilibria, or steady orbits, over a grid of case values.
//!
//! Rows are solved in chunks of neighbours, each chunk for itself, by the threads of the current rayon pool; finished
//! chunks go to a journal beside the table, and the table is written from the journal. So a row's numbers depend on the
//! grid alone, not on threads, shards or stops on the way.

mod axis;
pub(crate) mod columns;
mod grid;
mod identity;
mod merge;
mod neighbours;
#[cfg(feature = "parquet")]
mod parquet;
mod part;
mod plan;
mod rows;
mod setting;
mod shard;
mod table;
mod values;

pub(crate) use axis::Axis;
pub use axis::AxisSummary;
pub use columns::{CONVERGED, Cell, Column, IMPLAUSIBLE, Kind};
pub(crate) use columns::{decode, encode};
pub use grid::{Grid, SampleRows};
pub use merge::{Merged, merge};
#[cfg(feature = "parquet")]
pub(crate) use parquet::{Notes, field, properties, write_column};
pub use part::{Part, write_part};
pub use plan::Plan;
pub use rows::solve_chunks;
pub use setting::Setting;
pub use shard::Shard;
pub(crate) use table::write as write_rows;
pub use table::{Count, Format, Rows};
pub(crate) use values::short;

use crate::error::StudyError;
use crate::journal::Journal;
use crate::lock::OutputLock;
use identity::Identity;
use rayon::prelude::*;
use rows::Chunk;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Choices of a sweep besides its grid.
#[derive(Debug, Clone)]
pub struct Options {
    /// Table to write, `.parquet` or `.csv` by its name; finished rows are in `<table>.rows` until then.
    pub table: PathBuf,
    /// Part of the grid to solve.
    pub shard: Shard,
    /// Solve every row from its own initial guess instead of a neighbour's solution.
    pub cold: bool,
    /// Forget the finished rows of a sweep that was stopped.
    pub restart: bool,
}

/// A sweep with its finished rows on disk.
///
/// ```no_run
/// use std::ops::ControlFlow;
/// use tribodyn::Limits;
/// use tribodyn::answers::Equations;
/// use tribodyn_study::sweep::{Grid, Options, Setting, Shard, Sweep};
///
/// let path = std::path::Path::new("case.ron");
/// let forces = Setting::parse("ring.z.Force=kN(10..60 by 5)")?;
/// let text = tribodyn_study::read_text(path, &Limits::NORMAL)?;
/// let grid = Grid::new("case.ron", text, &[forces], (Equations::Traction, &Limits::NORMAL))?;
/// let options = Options { table: "table.csv".into(), shard: Shard::ALL, cold: false, restart: false };
/// let mut sweep = Sweep::open(&grid, &options)?;
/// sweep.solve(|_| ControlFlow::Continue(()))?;
/// let count = sweep.write_table()?;
/// sweep.forget_rows()?;
/// assert_eq!(count.rows, 11);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Sweep<'a> {
    grid: &'a Grid,
    shard: Shard,
    cold: bool,
    table: PathBuf,
    format: Format,
    columns: Vec<Column>,
    identity: Identity,
    journal: Journal,
    /// Let go of after everything else.
    _lock: OutputLock,
}

impl<'a> Sweep<'a> {
    /// Opens the finished rows of the table, or begins with none.
    ///
    /// # Errors
    /// The name of the table has no known ending, another process writes it, or its finished rows are of another sweep
    /// or cannot be read.
    pub fn open(grid: &'a Grid, options: &Options) -> Result<Self, StudyError> {
        let format = Format::of(&options.table)?;
        let lock = OutputLock::take(&options.table)?;
        let columns = columns::columns(grid.columns());
        let identity = Identity::new(grid, options.shard, options.cold);
        let chunk_at = |first: usize| {
            let chunk = first / grid.chunk_rows();
            let rows = if chunk < grid.chunks() { grid.chunk(chunk) } else { 0..0 };
            (rows.start == first && !rows.is_empty() && options.shard.has(chunk)).then_some((chunk, rows))
        };
        let journal = Journal::open(&options.table, &identity, &chunk_at, &columns, options.restart)?;
        let Options { shard, cold, .. } = *options;
        Ok(Self { grid, shard, cold, table: options.table.clone(), format, columns, identity, journal, _lock: lock })
    }

    /// Rows of the shard.
    pub fn row_count(&self) -> usize {
        self.of_shard().map(|chunk| self.grid.chunk(chunk).len()).sum()
    }

    /// Rows of the shard that are finished.
    pub fn finished_rows(&self) -> usize {
        self.of_shard().filter(|chunk| self.journal.has(*chunk)).map(|chunk| self.grid.chunk(chunk).len()).sum()
    }

    fn of_shard(&self) -> impl Iterator<Item = usize> {
        (0..self.grid.chunks()).filter(|chunk| self.shard.has(*chunk))
    }

    /// Solves the rows that are not finished, in parallel. `progress` gets the number of rows each time that some are
    /// finished; a break ends the sweep, which can be opened again.
    ///
    /// # Errors
    /// Finished rows cannot be written, or `progress` has ended the sweep.
    pub fn solve(&mut self, progress: impl Fn(usize) -> ControlFlow<()> + Sync) -> Result<(), StudyError> {
        let open: Vec<usize> = self.of_shard().filter(|chunk| !self.journal.has(*chunk)).collect();
        let (grid, cold) = (self.grid, self.cold);
        let path = self.journal.path().to_owned();
        let journal = Mutex::new(&mut self.journal);
        // One chunk at a time for each thread: the next free thread takes the next one.
        open.par_iter().with_max_len(1).try_for_each(|&chunk| {
            let rows = grid.chunk(chunk);
            let stopped = || StudyError::SweepStopped { path: path.clone() };
            let lines = Chunk::new(grid, cold).lines(rows.clone()).ok_or_else(stopped)?;
            journal.lock().unwrap_or_else(PoisonError::into_inner).append(chunk, &lines)?;
            match progress(rows.len()) {
                ControlFlow::Continue(()) => Ok(()),
                ControlFlow::Break(()) => Err(stopped()),
            }
        })
    }

    /// The finished rows.
    pub fn rows(&self) -> Rows<'_> {
        Rows::new(&self.table, &self.columns, &self.journal)
    }

    /// Writes the table from the finished rows, under its name only when it is whole.
    ///
    /// # Errors
    /// The table cannot be written, or a finished row cannot be read.
    pub fn write_table(&self) -> Result<Count, StudyError> {
        let notes = self.identity.notes()?;
        table::write(&self.rows(), self.format, notes)
    }

    /// Removes the finished rows: the table has them all.
    ///
    /// # Errors
    /// The file cannot be removed.
    pub fn forget_rows(self) -> Result<(), StudyError> {
        self.journal.delete()
    }

    /// The table.
    pub fn table(&self) -> &Path {
        &self.table
    }
}
