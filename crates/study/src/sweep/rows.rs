//! From a row of the grid to a row of the table.

use super::columns::{self, Cell, Solved, Unsolved};
use super::grid::Grid;
use crate::answers::OrbitProblem;
use crate::plausibility;
use rayon::prelude::*;
use std::ops::Range;
use tribodyn_bearing::{Bearing, OperatingPoint};
use tribodyn_case::Case;
use tribodyn_orbit::steady_orbit;
use tribodyn_quasistatic::{Model, Solution, WarmStart, solve, solve_near};
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

    fn solve(&mut self, row: usize) -> Result<Solved, Unsolved> {
        let text = self.grid.text(row).ok_or_else(|| Unsolved::refused("a path is not in the case of this row"))?;
        let case = self.grid.case(&text).map_err(Unsolved::refused)?;
        case.require(self.grid.model.purpose()).map_err(Unsolved::refused)?;
        let (bearing, (mut solution, round)) = match self.grid.model.equilibrium() {
            Some(model) => {
                let bearing = case.bearing().map_err(Unsolved::refused)?;
                let solution = self.equilibrium(row, (&bearing, &case.operating_point()), model)?;
                (bearing, (solution, None))
            }
            None => orbit(&case)?,
        };
        let all_round = round.as_ref().unwrap_or(&solution);
        let found = plausibility::of_solution(&case, (&text, &bearing), all_round).map_err(Unsolved::refused)?;
        solution.warnings.extend(found.sentences);
        // `solve` has a sentence on what is implausible.
        let implausible = plausibility::names(&found.implausible);
        let warnings = solution.warnings.len() + usize::from(implausible.is_some());
        Ok(Solved { solution, round: round.map(|round| round.balls), warnings, implausible })
    }

    fn equilibrium(
        &mut self,
        row: usize,
        (bearing, point): (&Bearing, &OperatingPoint),
        model: Model,
    ) -> Result<Solution, Unsolved> {
        let warm = self.start(row, bearing, point).and_then(|start| {
            let solved = solve_near(bearing, point, &start).ok();
            solved.filter(|solved| rolls(&solved.solution) && within_target(&solved.solution, point))
        });
        let solved = match warm {
            Some(solved) => solved,
            None => solve(bearing, point, model)?,
        };
        if let Some(start) = solved.warm_start.filter(|_| !self.cold && rolls(&solved.solution)) {
            self.solved.push(Neighbour { row, patch: point.patch, balls: solved.solution.balls.len(), start });
        }
        Ok(solved.solution)
    }

    /// Where to start a row from: the nearest solved row, moved by as much as the solutions of two others differ that
    /// are as far apart, where there are such.
    fn start(&self, row: usize, bearing: &Bearing, point: &OperatingPoint) -> Option<WarmStart> {
        let near = self.nearest(row, bearing, point)?;
        let start = |row: usize| self.solved.iter().find(|other| other.row == row).map(|other| &other.start);
        let moved = self
            .grid
            .parallelograms(near.row, row)
            .into_iter()
            .find_map(|[from, to]| near.start.moved(start(from)?, start(to)?));
        Some(moved.unwrap_or_else(|| near.start.clone()))
    }

    /// The latest of the nearest rows, among those that are solved by the same rule.
    fn nearest(&self, row: usize, bearing: &Bearing, point: &OperatingPoint) -> Option<&Neighbour> {
        let alike = |near: &&Neighbour| near.patch == point.patch && near.balls == bearing.geometry.ball_count;
        let apart = |near: &Neighbour| self.grid.distance(near.row, row);
        self.solved.iter().rev().filter(alike).min_by(|a, b| apart(a).total_cmp(&apart(b)))
    }
}

/// The balls of an orbit where those of an equilibrium stand, and one ball round it. Each row starts cold: on the mesh
/// of a neighbour's orbit the numbers would be others, within the error of a mesh.
fn orbit(case: &Case) -> Result<(Bearing, (Solution, Option<Solution>)), Unsolved> {
    let OrbitProblem { bearing, point, cage, settings } = OrbitProblem::of(case).map_err(Unsolved::refused)?;
    let orbit = steady_orbit(&bearing, &point, &cage, &settings)?.solution;
    let of = |balls| orbit.as_solution(balls, [point.inner_speed, point.outer_speed]);
    Ok((bearing, (of(&orbit.balls), Some(of(&orbit.points)))))
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

/// Whether the patch rule of a warm start is good enough here.
fn within_target(solution: &Solution, point: &OperatingPoint) -> bool {
    point.patch.is_none_or(|patch| patch.allows(solution.patch_error_estimate))
}

#[cfg(test)]
mod tests {
    use super::super::Setting;
    use super::*;
    use crate::answers::Equations;
    use crate::limits::Limits;

    fn grid(settings: &[&str]) -> Grid {
        let text = include_str!("../../../../fixtures/cases/paper-ag.ron").to_owned();
        let settings: Vec<_> = settings.iter().map(|setting| Setting::parse(setting).unwrap()).collect();
        Grid::new("paper-ag.ron", text, &settings, (Equations::Traction, &Limits::NORMAL)).unwrap()
    }

    #[test]
    fn identity_rows_from_neighbours_are_those_solved_alone() {
        let rule = "traction.patch=SplitStrip(across: 8, along: 4)";
        let grid = grid(&[rule, "ring.x.Force=kN(5..20 in 4)", "speed.inner.Constant=rpm(9000..13000 in 4)"]);
        let rows = |cold| {
            let mut chunk = Chunk::new(&grid, cold);
            (0..grid.rows).map(|row| chunk.solve(row).ok().unwrap().solution).collect::<Vec<_>>()
        };
        let (near, alone) = (rows(false), rows(true));
        assert_eq!((near.len(), near[0].iterations), (16, alone[0].iterations));
        for (row, (a, b)) in near.iter().zip(&alone).enumerate() {
            let of = |s: &Solution| [s.cage_speed_rpm, s.shaft_torque_nm.unwrap()];
            assert!(of(a).iter().zip(of(b)).all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{row}: {:?} {:?}", of(a), of(b));
        }
        // A start of second order needs fewer steps than the first guess.
        let steps = |all: &[Solution]| all[5..].iter().map(|solution| solution.iterations).sum::<usize>();
        assert!(2 * steps(&near) < steps(&alone), "{} {}", steps(&near), steps(&alone));
    }

    #[test]
    fn identity_pairs_of_rows_differ_as_the_neighbour_and_the_row_do() {
        let grid = grid(&["ring.x.Force=kN(5..20 in 4)", "speed.inner.Constant=rpm(9000..13000 in 5)"]);
        // Row 7 has the second load and the third speed: after two rows in a line, and beside the first load.
        assert_eq!(grid.parallelograms(6, 7), [[5, 6], [1, 2]]);
        assert_eq!(grid.parallelograms(5, 6), [[0, 1]]);
        assert_eq!(grid.parallelograms(5, 10), [[0, 5]]);
        assert!(grid.parallelograms(0, 5).is_empty() && grid.parallelograms(4, 5).is_empty());
    }
}
