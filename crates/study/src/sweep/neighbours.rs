//! Solved rows that others start from.

use super::grid::Grid;
use tribodyn_orbit::OrbitStart;
use tribodyn_quasistatic::WarmStart;
use tribodyn_traction::PatchChoice;

/// A start that a solution leaves for others.
pub trait Start: Clone {
    /// The fourth corner of a parallelogram of problems, of which this start, `from` and `to` are three; none where
    /// they do not go together.
    fn moved(&self, from: &Self, to: &Self) -> Option<Self>;
}

impl Start for WarmStart {
    fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
        self.moved(from, to)
    }
}

impl Start for OrbitStart {
    fn moved(&self, from: &Self, to: &Self) -> Option<Self> {
        self.moved(from, to)
    }
}

/// Patches and number of balls, the same where one row may start from the other.
pub type Alike = (Option<PatchChoice>, usize);

/// A solved row.
struct Neighbour<S> {
    row: usize,
    alike: Alike,
    start: S,
}

/// The solved rows of a chunk.
pub struct Neighbours<S> {
    solved: Vec<Neighbour<S>>,
}

impl<S: Start> Neighbours<S> {
    pub fn new() -> Self {
        Self { solved: Vec::new() }
    }

    pub fn add(&mut self, row: usize, alike: Alike, start: S) {
        self.solved.push(Neighbour { row, alike, start });
    }

    /// Where to start a row from, one after the other: the nearest solved row, moved by as much as the solutions of
    /// others differ that are as far apart, where there are such; and as it is.
    pub fn starts(&self, grid: &Grid, row: usize, alike: Alike) -> impl Iterator<Item = S> + use<'_, S> {
        let near = self.nearest(grid, row, alike);
        let start = |row: usize| self.solved.iter().find(|other| other.row == row).map(|other| &other.start);
        let moved = near.and_then(|near| {
            let moved = |way: Vec<[usize; 2]>| {
                let pairs: Option<Vec<_>> = way.iter().map(|&[from, to]| start(from).zip(start(to))).collect();
                pairs?.into_iter().try_fold(near.start.clone(), |at, (from, to)| at.moved(from, to))
            };
            grid.ways(near.row, row).into_iter().find_map(moved)
        });
        moved.into_iter().chain(near.into_iter().map(|near| near.start.clone()))
    }

    /// The latest of the nearest rows, among those that are solved by the same rule.
    fn nearest(&self, grid: &Grid, row: usize, alike: Alike) -> Option<&Neighbour<S>> {
        let apart = |near: &Neighbour<S>| grid.distance(near.row, row);
        let like = |near: &&Neighbour<S>| near.alike == alike;
        self.solved.iter().rev().filter(like).min_by(|a, b| apart(a).total_cmp(&apart(b)))
    }
}
