//! The plan of a sweep, and about how long it would take.

use super::axis::AxisSummary;
use super::grid::Grid;
use super::rows::Chunk;
use super::shard::Shard;
use serde::Serialize;
use std::time::Instant;

/// Rows of a chunk that are solved to see how long one takes.
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
    /// Time of one row that starts cold, s: mean of three in different places, each up to two seconds.
    pub cold_row_s: f64,
    /// The same of the rows after them.
    pub next_row_s: f64,
    /// Time of the shard, if all rows are like those few and every thread has a core of its own.
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

/// Seconds of a row that starts cold, and of one after it: means over three places of the grid, of which the easiest
/// loads and speeds may be a hundred times faster than the hardest.
fn time_rows(grid: &Grid, cold: bool) -> [f64; 2] {
    let mut places = [1, 3, 5].map(|k| k * grid.chunks() / 6).to_vec();
    places.dedup();
    let times: Vec<[f64; 2]> = places.iter().map(|place| time_chunk(grid, *place, cold)).collect();
    [0, 1].map(|k| times.iter().map(|time| time[k]).sum::<f64>() / times.len() as f64)
}

/// Seconds of the first row of a chunk, and mean of the few after it.
fn time_chunk(grid: &Grid, place: usize, cold: bool) -> [f64; 2] {
    let rows = grid.chunk(place);
    let mut chunk = Chunk::new(grid, cold).within(TRIAL_S);
    let began = Instant::now();
    chunk.lines(rows.start..rows.start + 1);
    let first = began.elapsed().as_secs_f64();
    let (mut tried, began) = (1, Instant::now());
    while tried < rows.len().min(TRIED) && (tried == 1 || began.elapsed().as_secs_f64() < TRIAL_S) {
        chunk.lines(rows.start + tried..rows.start + tried + 1);
        tried += 1;
    }
    let next = if tried > 1 { began.elapsed().as_secs_f64() / (tried - 1) as f64 } else { first };
    [first, next]
}
