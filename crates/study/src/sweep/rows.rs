//! From a row of the grid to a row of the table.

use super::columns::{self, Cell, Round, Solved, Unsolved};
use super::grid::Grid;
use super::neighbours::Neighbours;
use rayon::prelude::*;
use std::ops::Range;
use tribodyn::answers::{Findings, OrbitProblem, Question};
use tribodyn::plausibility;
use tribodyn_bearing::{Bearing, OperatingPoint, SearchWatch, Side};
use tribodyn_case::Case;
use tribodyn_orbit::{OrbitStart, SolvedOrbit, SteadyOrbit, steady_orbit};
use tribodyn_quasistatic::{Model, Solution, WarmStart, solve, solve_near};

/// Inner slide-to-roll ratio beyond which a ball may have left the equilibrium that a rolling ball comes to: where the
/// library's coatings have their peak at the latest.
const SKIDDING: f64 = 0.05;

/// Solves the rows of one chunk, one after the other.
pub(crate) struct Chunk<'a> {
    grid: &'a Grid,
    /// True if each row starts from its own initial guess.
    cold: bool,
    equilibria: Neighbours<WarmStart>,
    orbits: Neighbours<OrbitStart>,
    /// True once balls of an orbit in oil have slid in a row.
    slid: bool,
    /// Processor time of a row, s, after which its search is ended.
    limit_s: f64,
}

impl<'a> Chunk<'a> {
    pub fn new(grid: &'a Grid, cold: bool) -> Self {
        let limit_s = grid.time_limit_s;
        Self { grid, cold, equilibria: Neighbours::new(), orbits: Neighbours::new(), slid: false, limit_s }
    }

    /// With less time for a row, s, than the grid gives it.
    pub fn within(self, limit_s: f64) -> Self {
        Self { limit_s: limit_s.min(self.limit_s), ..self }
    }

    /// The lines of some rows, each with its end; none where the sweep was stopped on the way.
    pub fn lines(&mut self, rows: Range<usize>) -> Option<String> {
        Some(self.rows(rows)?.iter().map(|row| columns::encode(row) + "\n").collect())
    }

    /// The fields of some rows; none where the sweep was stopped on the way.
    fn rows(&mut self, rows: Range<usize>) -> Option<Vec<Vec<Cell>>> {
        let grid = self.grid;
        let solved = rows.map(|row| (!grid.is_stopped()).then(|| self.row(row))).collect();
        // The search that a stop ended says nothing of its row.
        if grid.is_stopped() { None } else { solved }
    }

    /// The fields of a row.
    fn row(&mut self, row: usize) -> Vec<Cell> {
        columns::cells(row, self.grid.cells(row), &self.solve(row))
    }

    fn solve(&mut self, row: usize) -> Result<Solved, Unsolved> {
        let text = self.grid.text(row).ok_or_else(|| Unsolved::refused("a path is not in the case of this row"))?;
        let case = self.grid.case(&text).map_err(Unsolved::refused)?;
        case.require(self.grid.model.purpose()).map_err(Unsolved::refused)?;
        let bearing = case.bearing().map_err(Unsolved::refused)?;
        if let Some(why) = plausibility::hopeless(&case, (&text, &bearing)) {
            return Err(Unsolved::refused(why));
        }
        let watch = self.grid.watch(self.limit_s);
        let (solution, round) = match self.grid.model.equilibrium() {
            Some(model) => {
                let point = OperatingPoint { watch, ..case.operating_point() };
                (self.equilibrium(row, (&bearing, &point), model)?, None)
            }
            None => self.orbit(row, &case, watch)?,
        };
        let all_round = round.as_ref().map_or(&solution, |(_, all_round)| all_round);
        let question = Question { name: "", text: &text, case: &case, watch: SearchWatch::default() };
        let found = Findings::of(&question, &bearing, (self.grid.model, all_round)).map_err(Unsolved::refused)?;
        let implausible = Some(found.implausible()).filter(|names| !names.is_empty());
        let warnings = found.warnings().len();
        let round = round.map(|(orbit, all_round)| Round::of(&orbit, all_round.balls));
        Ok(Solved { solution, round, warnings, implausible })
    }

    fn equilibrium(
        &mut self,
        row: usize,
        (bearing, point): (&Bearing, &OperatingPoint),
        model: Model,
    ) -> Result<Solution, Unsolved> {
        let alike = (point.patch, bearing.geometry.ball_count);
        let warm = self.equilibria.starts(self.grid, row, alike).next().and_then(|start| {
            let solved = solve_near(bearing, point, &start).ok();
            solved.filter(|solved| rolls(&solved.solution) && within_target(&solved.solution, point))
        });
        let solved = match warm {
            Some(solved) => solved,
            None => solve(bearing, point, model)?,
        };
        if let Some(start) = solved.warm_start.filter(|_| !self.cold && rolls(&solved.solution)) {
            self.equilibria.add(row, alike, start);
        }
        Ok(solved.solution)
    }

    /// The balls of an orbit where those of an equilibrium stand, and one ball round it.
    fn orbit(&mut self, row: usize, case: &Case, watch: SearchWatch) -> Result<OrbitRow, Unsolved> {
        let problem = OrbitProblem::of(case).map_err(Unsolved::refused)?;
        let problem = OrbitProblem { point: OperatingPoint { watch, ..problem.point }, ..problem };
        let OrbitProblem { bearing, point, cage, settings } = &problem;
        let alike = (point.patch, bearing.geometry.ball_count);
        // Where contacts begin and end otherwise, the neighbour as it is may lead where it does not once it is moved. A
        // cold start can take a hundred times as long as either.
        let beside = |start| orbit_beside(&problem, start, self.slid);
        let solved = match self.orbits.starts(self.grid, row, alike).find_map(beside) {
            Some(solved) => solved,
            None => steady_orbit(bearing, point, cage, settings)?,
        };
        let orbit = solved.solution;
        let all_round = round(&orbit, point);
        let slides = in_films(bearing) && !rolls(&all_round);
        self.slid |= slides;
        let leads = !self.cold && (slides || rolls(&all_round)) && orbit.is_of_the_case();
        if let Some(start) = solved.start.filter(|_| leads) {
            self.orbits.add(row, alike, start);
        }
        let balls = orbit.as_solution(&orbit.balls, [point.inner_speed, point.outer_speed]);
        Ok((balls, Some((orbit, all_round))))
    }
}

/// The balls of an orbit where those of an equilibrium stand, with the orbit and one ball round it.
type OrbitRow = (Solution, Option<(SteadyOrbit, Solution)>);

/// One ball round an orbit.
fn round(orbit: &SteadyOrbit, point: &OperatingPoint) -> Solution {
    orbit.as_solution(&orbit.points, [point.inner_speed, point.outer_speed])
}

/// The orbit from that of a neighbour where it is the one that a cold start comes to.
fn orbit_beside(problem: &OrbitProblem, start: OrbitStart, slid: bool) -> Option<SolvedOrbit> {
    let OrbitProblem { bearing, point, .. } = problem;
    let solved = problem.beside(start)?;
    let all_round = round(&solved.solution, point);
    let alike = rolls(&all_round) || slid && in_films(bearing);
    (alike && within_target(&all_round, point)).then_some(solved)
}

/// True if both races have a film of oil: there, balls that slide come to one motion from neighbours and from cold
/// starts. On coatings, which lose traction beyond their peak, some skid on.
fn in_films(bearing: &Bearing) -> bool {
    Side::BOTH.into_iter().all(|side| bearing.film_law(side).is_some())
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
        chunk.rows(grid.chunk(index)).and_then(&take)
    };
    chunks.into_par_iter().with_max_len(1).map(solve).collect()
}

/// True if all balls are loaded and roll. But for orbits in oil, only then does a neighbour lead to the same solution
/// as a cold start does: a ball that skids may go on to do so where it could roll.
fn rolls(solution: &Solution) -> bool {
    let rolls = |b: &tribodyn_bearing::BallResult| {
        // A model without traction slides nowhere.
        let slide = b.contacts.inner.friction.map_or(0.0, |f| f.slide_to_roll[0]);
        b.is_loaded() && slide.abs() <= SKIDDING
    };
    solution.balls.iter().all(rolls)
}

/// True if the patch rule of a warm start is good enough here.
fn within_target(solution: &Solution, point: &OperatingPoint) -> bool {
    point.patch.is_none_or(|patch| patch.allows(solution.patch_error_estimate))
}

#[cfg(test)]
mod tests {
    use super::super::Setting;
    use super::super::neighbours::Start;
    use super::*;
    use tribodyn::Limits;
    use tribodyn::answers::Equations;

    fn grid(settings: &[&str]) -> Grid {
        grid_of(settings, Equations::Traction)
    }

    fn grid_of(settings: &[&str], equations: Equations) -> Grid {
        let text = include_str!("../../../../fixtures/cases/paper-ag.ron").to_owned();
        let settings: Vec<_> = settings.iter().map(|setting| Setting::parse(setting).unwrap()).collect();
        Grid::new("paper-ag.ron", text, &settings, (equations, &Limits::NORMAL)).unwrap()
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
    fn identity_orbits_from_neighbours_are_those_solved_alone() {
        let settings = ["ring.x.Force=kN(20..20.6 in 3)", "speed.inner.Constant=rpm(13800..14000 in 3)"];
        let grid = grid_of(&settings, Equations::SteadyOrbit);
        let rows = |cold| {
            let mut chunk = Chunk::new(&grid, cold);
            (0..grid.rows).map(|row| chunk.solve(row).ok().unwrap().solution).collect::<Vec<_>>()
        };
        let (near, alone) = (rows(false), rows(true));
        for (row, (a, b)) in near.iter().zip(&alone).enumerate() {
            let of = |s: &Solution| [s.cage_speed_rpm, s.shaft_torque_nm.unwrap()];
            // Each alone has a mesh of its own, and the torque of pockets depends on it.
            let (a, b) = (of(a), of(b));
            assert!((a[0] / b[0] - 1.0).abs() < 2e-6 && (a[1] / b[1] - 1.0).abs() < 5e-4, "{row}: {a:?} {b:?}");
        }
        let jacobians = |all: &[Solution]| all[1..].iter().map(|solution| solution.iterations).sum::<usize>();
        assert!(4 * jacobians(&near) < jacobians(&alone), "{} {}", jacobians(&near), jacobians(&alone));
    }

    /// A patch rule that suits a smaller load errs in the torque, where it is still within the target of the load.
    #[test]
    fn identity_torques_of_orbits_from_neighbours_are_those_solved_alone() {
        let text = include_str!("../../../../fixtures/cases/angular-7210.ron").to_owned();
        let settings = [Setting::parse("ring.z.Force=kN(3..6 in 4)").unwrap()];
        let of = (Equations::SteadyOrbit, &Limits::NORMAL);
        let grid = Grid::new("angular-7210.ron", text, &settings, of).unwrap();
        let torques = |cold| {
            let mut chunk = Chunk::new(&grid, cold);
            (0..grid.rows)
                .map(|row| chunk.solve(row).ok().unwrap().solution.shaft_torque_nm.unwrap())
                .collect::<Vec<_>>()
        };
        for (near, alone) in torques(false).into_iter().zip(torques(true)) {
            assert!((near / alone - 1.0).abs() < 5e-4, "{near} {alone}");
        }
    }

    /// Under radial load the balls beside the load zone slide or lose their load. A row from a neighbour is then that
    /// of a cold start too, by the same patch rule.
    #[test]
    fn identity_orbits_of_balls_that_slide_in_oil_are_those_solved_alone() {
        let text = include_str!("../../../../fixtures/cases/oil-6206.ron").to_owned();
        let settings = [Setting::parse("speed.inner.Constant=rpm(3000..3200 in 5)").unwrap()];
        let of = (Equations::SteadyOrbit, &Limits::NORMAL);
        let grid = Grid::new("oil-6206.ron", text, &settings, of).unwrap();
        let rows = |cold| {
            let mut chunk = Chunk::new(&grid, cold);
            let solved = (0..grid.rows).map(|row| chunk.solve(row).ok().unwrap()).collect::<Vec<_>>();
            (solved, chunk.slid)
        };
        let ((near, slid), (alone, _)) = (rows(false), rows(true));
        assert!(slid);
        for (row, (a, b)) in near.iter().zip(&alone).enumerate() {
            let (a, b) = (&a.solution, &b.solution);
            assert!((a.cage_speed_rpm / b.cage_speed_rpm - 1.0).abs() < 5e-5, "{row}: {}", a.cage_speed_rpm);
            let torques = [a, b].map(|s| s.shaft_torque_nm.unwrap());
            assert!((torques[0] / torques[1] - 1.0).abs() < 5e-4, "{row}: {torques:?}");
            let errors = [a, b].map(|s| s.patch_error_estimate.unwrap());
            assert!((errors[0] / errors[1] - 1.0).abs() < 0.05, "{row}: {errors:?}");
        }
        let jacobians = |all: &[Solved]| all[1..].iter().map(|solved| solved.solution.iterations).sum::<usize>();
        assert!(jacobians(&near) < jacobians(&alone), "{} {}", jacobians(&near), jacobians(&alone));
    }

    /// A row that is nothing but a number.
    #[derive(Clone)]
    struct At(f64);

    impl Start for At {
        fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
            (to.0 > from.0).then_some(Self(self.0 + (to.0 - from.0)))
        }
    }

    #[test]
    fn identity_a_row_begins_with_its_neighbour_moved_and_then_as_it_is() {
        let grid = grid(&["ring.x.Force=kN(5..20 in 4)"]);
        let starts = |solved: &[f64]| {
            let mut rows = Neighbours::new();
            solved.iter().enumerate().for_each(|(row, at)| rows.add(row, (None, 13), At(*at)));
            rows.starts(&grid, solved.len(), (None, 13)).map(|At(at)| at).collect::<Vec<_>>()
        };
        assert_eq!([starts(&[]), starts(&[2.0]), starts(&[2.0, 5.0])], [vec![], vec![2.0], vec![8.0, 5.0]]);
        // What does not go together moves nothing.
        assert_eq!(starts(&[5.0, 2.0]), [2.0]);
    }

    #[test]
    fn identity_ways_lead_from_the_neighbour_to_the_row() {
        let grid = grid(&["ring.x.Force=kN(5..20 in 4)", "speed.inner.Constant=rpm(9000..13000 in 5)"]);
        // Row 7 has the second load and the third speed: after two rows in a line, and beside the first load.
        assert_eq!(grid.ways(6, 7), [vec![[5, 6], [1, 2], [1, 0]], vec![[5, 6]], vec![[1, 2]]]);
        assert_eq!(grid.ways(5, 6), [vec![[0, 1]]]);
        assert_eq!(grid.ways(5, 10), [vec![[0, 5]]]);
        assert_eq!(grid.ways(2, 3), [vec![[1, 2], [1, 2], [1, 0]], vec![[1, 2]]]);
        assert!(grid.ways(0, 5).is_empty() && grid.ways(4, 5).is_empty());
        // What has no third differences is told exactly by three of a way, what has no second ones by a single one.
        let at = |row: usize| (row / 5) as f64 + 3.0 * (row % 5) as f64;
        let bent = |row: usize| at(row) + 0.5 * at(row).powi(2);
        let left = |way: &[[usize; 2]], of: &dyn Fn(usize) -> f64, near: usize, row: usize| {
            of(near) + way.iter().map(|&[from, to]| of(to) - of(from)).sum::<f64>() - of(row)
        };
        for row in 1..20_usize {
            for near in [row - 1, row.saturating_sub(5)] {
                for way in grid.ways(near, row) {
                    assert_eq!(left(&way, &at, near, row), 0.0, "{near} {row} {way:?}");
                    assert_eq!(left(&way, &bent, near, row) == 0.0, way.len() == 3, "{near} {row} {way:?}");
                }
            }
        }
    }
}
