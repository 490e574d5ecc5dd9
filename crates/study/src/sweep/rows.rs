//! From a row of the grid to a line of the table.

use super::columns::{self, Unsolved};
use super::grid::Grid;
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
    indices: Vec<usize>,
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
        let line = |row| columns::line(row, self.grid.cells(row), &self.solve(row)) + "\n";
        rows.map(line).collect()
    }

    fn solve(&mut self, row: usize) -> Result<Solution, Unsolved> {
        let text = self.grid.text(row).ok_or_else(|| Unsolved::refused("a path is not in the case of this row"))?;
        let case = self.grid.case(&text).map_err(Unsolved::refused)?;
        case.require(Purpose::Traction).map_err(Unsolved::refused)?;
        let bearing = case.bearing().map_err(Unsolved::refused)?;
        let point = case.operating_point();
        let indices = self.grid.indices(row);
        let warm = self.nearest(&indices, &bearing, &point).and_then(|near| {
            let solved = solve_from(&bearing, &point, &near.start).ok();
            solved.filter(|solved| rolls(&solved.solution) && within_target(&solved.solution, &point))
        });
        let Solved { solution, warm_start, .. } = match warm {
            Some(solved) => solved,
            None => solve(&bearing, &point, Model::Traction)?,
        };
        if let Some(start) = warm_start.filter(|_| !self.cold && rolls(&solution)) {
            self.solved.push(Neighbour { indices, patch: point.patch, balls: solution.balls.len(), start });
        }
        Ok(solution)
    }

    /// The latest of the rows with the fewest steps in between, among those that are solved by the same rule.
    fn nearest(&self, indices: &[usize], bearing: &Bearing, point: &OperatingPoint) -> Option<&Neighbour> {
        let steps = |near: &&Neighbour| near.indices.iter().zip(indices).map(|(a, b)| a.abs_diff(*b)).sum::<usize>();
        let alike = |near: &&Neighbour| near.patch == point.patch && near.balls == bearing.geometry.ball_count;
        self.solved.iter().rev().filter(alike).min_by_key(steps)
    }
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
