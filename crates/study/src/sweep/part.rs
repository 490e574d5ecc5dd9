//! A part of a sweep that is solved in memory and written at once: the unit of work of a cluster.

use super::columns::{self, CONVERGED, Cell};
use super::grid::Grid;
use super::identity::Identity;
use super::rows::solve_chunks;
use super::shard::Shard;
use super::table::{self, Count, Format, Rows};
use crate::error::StudyError;
use std::ops::Range;
use std::path::Path;

/// Choices of a part.
#[derive(Debug, Clone)]
pub struct Part {
    /// Chunks to solve.
    pub chunks: Range<usize>,
    /// Solve every row from its own initial guess instead of a neighbour's solution.
    pub cold: bool,
}

/// Solves a part and writes its table, which has its name only when it is whole. `progress` gets the number of rows of
/// each chunk; where it says false the part ends and nothing is written.
///
/// # Errors
/// The name of the table has no known ending, or it cannot be written.
pub fn write_part(
    grid: &Grid,
    part: &Part,
    path: &Path,
    progress: impl Fn(usize) -> bool + Sync,
) -> Result<Option<Count>, StudyError> {
    let format = Format::of(path)?;
    let take = |rows: Vec<Vec<Cell>>| progress(rows.len()).then_some(rows);
    let Some(chunks) = solve_chunks(grid, part.chunks.clone(), part.cold, take) else { return Ok(None) };
    let rows: Vec<Vec<Cell>> = chunks.into_iter().flatten().collect();
    let columns = columns::columns(grid.columns());
    // Samples of a part are no more than its own: the swept values are left to the study's own description.
    let notes = Identity::new(grid, Shard::ALL, part.cold).notes()?;
    let notes = notes.into_iter().take(3).collect();
    table::write(&Rows::in_memory(path, &columns, &rows), format, notes).map(Some)
}

/// Columns of a grid's tables.
impl Grid {
    /// Name, kind and nulls of every column of a table of this grid.
    pub fn table_columns(&self) -> Vec<columns::Column> {
        columns::columns(self.columns())
    }

    /// Place of the column that says whether a row is a solution.
    pub fn converged_column(&self) -> Option<usize> {
        self.table_columns().iter().position(|column| column.name == CONVERGED)
    }
}
