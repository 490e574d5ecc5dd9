//! The plan of a sweep, and about how long it would take.

use super::axis::AxisSummary;
use super::grid::Grid;
use super::rows::Chunk;
use super::shard::Shard;
use serde::Serialize;
use std::time::Instant;

/// Rows that are solved to see how long one takes.
const TRIED: usize = 8;
/// Time after which no other is tried, and processor time after which the search of one is ended, s: some rows of a
/// grid may be by far the slowest.
const TRIAL_S: f64 = 2.0;

/// A sweep that is not begun.
#[derive(Debug, Clone, Serialize)]
pub struct Plan {
    /// Rows of the whole grid.
    pub grid_rows: usize,
    /// Rows of the shard.
    pub rows: usize,
    /// Part of the grid, `I/N`.
    pub shard: String,
    /// Rows that are solved one after the other.
    pub chunk_rows: usize,
    /// Threads that share the chunks.
    pub threads: usize,
    /// Swept values.
    pub axes: Vec<AxisSummary>,
    /// Time of one row that starts cold, from one try of two seconds at most.
    pub cold_row_s: f64,
    /// Mean time of the rows after it, each up to two seconds.
    pub next_row_s: f64,
    /// Time of the shard, if all rows are like the first few and every thread has a core of its own.
    pub estimated_time_s: f64,
}

impl Plan {
    /// Of a sweep by so many threads; some rows are solved for the estimate, and nothing is written.
    pub fn new(grid: &Grid, shard: Shard, cold: bool, threads: usize) -> Self {
        let chunks: Vec<usize> = (0..grid.chunks()).filter(|chunk| shard.has(*chunk)).collect();
        let rows = chunks.iter().map(|chunk| grid.chunk(*chunk).len()).sum();
        let [cold_row_s, next_row_s] = time_rows(grid, cold);
        // A thread's share in whole chunks.
        let rounds = chunks.len().div_ceil(threads);
        let chunk_time = cold_row_s + next_row_s * (grid.chunk(0).len() - 1) as f64;
        Self {
            grid_rows: grid.rows,
            rows,
            shard: shard.to_string(),
            chunk_rows: grid.chunk_rows(),
            threads,
            axes: grid.summary(),
            cold_row_s,
            next_row_s,
            estimated_time_s: rounds as f64 * chunk_time,
        }
    }
}

/// Seconds of the first row, and mean of the few after it.
fn time_rows(grid: &Grid, cold: bool) -> [f64; 2] {
    let mut chunk = Chunk::new(grid, cold).within(TRIAL_S);
    let began = Instant::now();
    chunk.lines(0..1);
    let first = began.elapsed().as_secs_f64();
    let (mut row, began) = (1, Instant::now());
    while row < grid.chunk(0).len().min(TRIED) && (row == 1 || began.elapsed().as_secs_f64() < TRIAL_S) {
        chunk.lines(row..row + 1);
        row += 1;
    }
    let next = if row > 1 { began.elapsed().as_secs_f64() / (row - 1) as f64 } else { first };
    [first, next]
}
