//! An orbit by collocation at Radau's points.

use crate::system::{BALL, RING};
use tribodyn_numerics::Radau;

/// Points of an interval.
pub(crate) const STAGES: usize = Radau::STAGES;

/// Values of a ball's unknowns at the points of an interval.
pub(crate) type Values = [[f64; BALL]; STAGES];

/// A mesh round the orbit with the unknowns on it.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct Orbit {
    /// Ends of the intervals in turns of the cage, from 0 to 1.
    pub ends: Vec<f64>,
    pub values: Vec<Values>,
    /// Cage speed, rad/s.
    pub cage_speed: f64,
    /// Where the inner ring stands.
    pub ring: [f64; RING],
}

impl Orbit {
    pub fn intervals(&self) -> usize {
        self.values.len()
    }

    /// On a mesh with its ends, by the ball at each place of the turn.
    pub fn of(
        radau: &Radau,
        ends: Vec<f64>,
        (cage_speed, ring): (f64, [f64; RING]),
        ball: impl Fn(f64) -> [f64; BALL],
    ) -> Self {
        let at = |pair: &[f64], i: usize| ball(pair[0] + radau.points[i] * (pair[1] - pair[0]));
        let values = ends.windows(2).map(|pair| std::array::from_fn(|i| at(pair, i))).collect();
        Self { ends, values, cage_speed, ring }
    }

    /// Moves all unknowns by as much as those of two others differ, each on a mesh of as many intervals.
    pub fn shift(&mut self, radau: &Radau, from: (&Self, &[f64]), to: (&Self, &[f64])) {
        let [from_here, to_here] = [from, to].map(|(other, ends)| other.on(radau, ends));
        let ((from, _), (to, _)) = (from, to);
        let all = |values: &[Values]| -> Vec<f64> { values.iter().flatten().flatten().copied().collect() };
        let pairs = all(&from_here).into_iter().zip(all(&to_here));
        self.values.iter_mut().flatten().flatten().zip(pairs).for_each(|(v, (from, to))| *v += to - from);
        self.cage_speed += to.cage_speed - from.cage_speed;
        (0..RING).for_each(|k| self.ring[k] += to.ring[k] - from.ring[k]);
    }

    /// Values at the points of a mesh with these ends.
    fn on(&self, radau: &Radau, ends: &[f64]) -> Vec<Values> {
        if self.ends == ends {
            return self.values.clone();
        }
        let border = (self.cage_speed, self.ring);
        Self::of(radau, ends.to_vec(), border, |turn| self.at(radau, turn)).values
    }

    /// Share of the turn that it has.
    pub fn last_end(&self) -> f64 {
        self.ends.last().copied().unwrap_or(0.0)
    }

    /// Beginning and width of an interval, turns.
    pub fn interval(&self, j: usize) -> [f64; 2] {
        [self.ends[j], self.ends[j + 1] - self.ends[j]]
    }

    /// Unknowns at the beginning of an interval: those at the end of the one before.
    pub fn begin(&self, j: usize) -> &[f64; BALL] {
        self.end(if j == 0 { self.intervals() - 1 } else { j - 1 })
    }

    /// Unknowns at the end of an interval.
    pub fn end(&self, j: usize) -> &[f64; BALL] {
        &self.values[j][STAGES - 1]
    }

    /// Unknowns at the end of the turn, with which the next begins.
    pub fn last(&self) -> &[f64; BALL] {
        self.end(self.intervals() - 1)
    }

    /// Unknowns when the pocket has gone a share of the turn.
    pub fn at(&self, radau: &Radau, turn: f64) -> [f64; BALL] {
        let turn = turn.rem_euclid(1.0);
        let j = self.ends.partition_point(|&end| end <= turn).clamp(1, self.intervals()) - 1;
        let [begin, width] = self.interval(j);
        let shares = radau.shares((turn - begin) / width);
        let from = self.begin(j);
        std::array::from_fn(|k| {
            shares[0] * from[k] + (0..STAGES).map(|i| shares[i + 1] * self.values[j][i][k]).sum::<f64>()
        })
    }
}
