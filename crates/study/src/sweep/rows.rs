//! From a row of the grid to a row of the table.

use super::columns::{self, Cell, Unsolved};
use super::grid::Grid;
use rayon::prelude::*;
use std::ops::Range;
use tribodyn_bearing::Bearing;
use tribodyn_case::Purpose;
use tribodyn_quasistatic::{Model, OperatingPoint, Solution, Solved, WarmStart, solve, solve_from};
use tribodyn_traction::PatchChoice;

/// Inner slide-to-roll ratio beyond which a ball may have left the equilibrium that a rolling ball comes to: where the
/// library's coatings have their peak at the latest.
const SKIDDING: f64 = 0.05;

/// A solved row that others can start from.
struct Neighbour {
    row: usize,
    patch: Option<PatchChoice>,
    balls: usize,
    start: WarmStart,
}

/// Solves the rows of one chunk, one after the other.
pub(crate) struct Chunk<'a> {
    grid: &'a Grid,
    /// Whether each row starts from its own initial guess.
    cold: bool,
    solved: Vec<Neighbour>,
}

impl<'a> Chunk<'a> {
    pub fn new(grid: &'a Grid, cold: bool) -> Self {
        Self { grid, cold, solved: Vec::new() }
    }

    /// The lines of some rows, each with its end.
    pub fn lines(&mut self, rows: Range<usize>) -> String {
        rows.map(|row| columns::encode(&self.row(row)) + "\n").collect()
    }

    /// The fields of a row.
    fn row(&mut self, row: usize) -> Vec<Cell> {
        columns::cells(row, self.grid.cells(row), &self.solve(row))
    }

    fn solve(&mut self, row: usize) -> Result<Solution, Unsolved> {
        let text = self.grid.text(row).ok_or_else(|| Unsolved::refused("a path is not in the case of this row"))?;
        let case = self.grid.case(&text).map_err(Unsolved::refused)?;
        case.require(Purpose::Traction).map_err(Unsolved::refused)?;
        let bearing = case.bearing().map_err(Unsolved::refused)?;
        let point = case.operating_point();
        let warm = self.nearest(row, &bearing, &point).and_then(|near| {
            let solved = solve_from(&bearing, &point, &near.start).ok();
            solved.filter(|solved| rolls(&solved.solution) && within_target(&solved.solution, &point))
        });
        let Solved { solution, warm_start, .. } = match warm {
            Some(solved) => solved,
            None => solve(&bearing, &point, Model::Traction)?,
        };
        if let Some(start) = warm_start.filter(|_| !self.cold && rolls(&solution)) {
            self.solved.push(Neighbour { row, patch: point.patch, balls: solution.balls.len(), start });
        }
        Ok(solution)
    }

    /// The latest of the nearest rows, among those that are solved by the same rule.
    fn nearest(&self, row: usize, bearing: &Bearing, point: &OperatingPoint) -> Option<&Neighbour> {
        let alike = |near: &&Neighbour| near.patch == point.patch && near.balls == bearing.geometry.ball_count;
        let apart = |near: &Neighbour| self.grid.distance(near.row, row);
        self.solved.iter().rev().filter(alike).min_by(|a, b| apart(a).total_cmp(&apart(b)))
    }
}

/// Solves some chunks of a grid in memory, on the threads of the current rayon pool. `take` turns the rows of a chunk
/// into what is kept of them; where it gives nothing the sweep ends, and so does this with nothing.
///
/// Rows are those of [`Sweep`](super::Sweep), bit for bit: a chunk depends on its rows alone.
pub fn solve_chunks<T: Send>(
    grid: &Grid,
    chunks: Range<usize>,
    cold: bool,
    take: impl Fn(Vec<Vec<Cell>>) -> Option<T> + Sync,
) -> Option<Vec<T>> {
    let solve = |index| {
        let mut chunk = Chunk::new(grid, cold);
        take(grid.chunk(index).map(|row| chunk.row(row)).collect())
    };
    chunks.into_par_iter().with_max_len(1).map(solve).collect()
}

/// Whether all balls are loaded and roll. Only then does a neighbour lead to the same equilibrium as a cold start does:
/// a ball that skids may go on to do so where it could roll.
fn rolls(solution: &Solution) -> bool {
    let rolls = |b: &tribodyn_bearing::BallResult| {
        let (i, o) = (&b.contacts.inner, &b.contacts.outer);
        // A model without traction slides nowhere.
        let slide = i.friction.map_or(0.0, |f| f.slide_to_roll[0]);
        i.load_n > 0.0 && o.load_n > 0.0 && slide.abs() <= SKIDDING
    };
    solution.balls.iter().all(rolls)
}

/// Whether the neighbour's patch rule, which a warm start takes over, is good enough here.
fn within_target(solution: &Solution, point: &OperatingPoint) -> bool {
    point.patch.is_none_or(|patch| patch.allows(solution.patch_error_estimate))
}
