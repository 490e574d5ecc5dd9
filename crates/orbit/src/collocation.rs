//! Collocation at Radau's points: a polynomial on each interval that meets the equations there, stiffly accurate and
//! L-stable (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section IV.5).

use crate::system::BALL;

/// Points of an interval; its degree.
pub(crate) const STAGES: usize = 3;

/// Radau's right points, the derivatives there of the polynomial through them and the beginning, and the weights of
/// their quadrature: three points, or one, which is Euler's implicit method.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Radau {
    pub stages: usize,
    pub points: [f64; STAGES],
    /// `slope[i][k]`: derivative at point i over the value at point k less that at the beginning.
    pub slope: [[f64; STAGES]; STAGES],
    pub weights: [f64; STAGES],
}

impl Radau {
    /// Three points: fifth order at the ends of intervals.
    pub fn third() -> Self {
        let root = 6f64.sqrt();
        let points = [(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0];
        let slope = std::array::from_fn(|i| std::array::from_fn(|k| lagrange_slope(&points, k, points[i])));
        Self { stages: 3, points, slope, weights: [(16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0] }
    }

    /// One point: first order, and what swings dies out.
    pub fn euler() -> Self {
        let mut slope = [[0.0; STAGES]; STAGES];
        slope[0][0] = 1.0;
        Self { stages: 1, points: [1.0, 0.0, 0.0], slope, weights: [1.0, 0.0, 0.0] }
    }

    /// Unknowns of an interval.
    pub fn stack(&self) -> usize {
        self.stages * BALL
    }

    /// Shares of the beginning and of the points in the polynomial's value at `x` of the interval.
    pub fn shares(&self, x: f64) -> [f64; STAGES + 1] {
        let node = |k: usize| if k == 0 { 0.0 } else { self.points[k - 1] };
        std::array::from_fn(|k| {
            let others = (0..=self.stages).filter(|&j| j != k);
            if k > self.stages { 0.0 } else { others.map(|j| (x - node(j)) / (node(k) - node(j))).product() }
        })
    }
}

/// Derivative at `x` of the polynomial that is one at point k and zero at the others and at the beginning.
fn lagrange_slope(points: &[f64; STAGES], k: usize, x: f64) -> f64 {
    let nodes: [f64; STAGES + 1] = std::array::from_fn(|k| if k == 0 { 0.0 } else { points[k - 1] });
    let others = |skip: usize| (0..=STAGES).filter(move |&j| j != k + 1 && j != skip);
    let scale: f64 = others(usize::MAX).map(|j| nodes[k + 1] - nodes[j]).product();
    let sum: f64 = others(usize::MAX).map(|left| others(left).map(|j| x - nodes[j]).product::<f64>()).sum();
    sum / scale
}

/// Values of a ball's unknowns at the points of an interval.
pub(crate) type Values = [[f64; BALL]; STAGES];

/// A mesh round the orbit with the unknowns on it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Orbit {
    /// Ends of the intervals in turns of the cage, from 0 to 1.
    pub ends: Vec<f64>,
    pub values: Vec<Values>,
    /// Points of an interval.
    pub stages: usize,
    /// Cage speed, rad/s.
    pub cage_speed: f64,
    /// Where the inner ring stands.
    pub ring: [f64; crate::system::RING],
}

impl Orbit {
    pub fn intervals(&self) -> usize {
        self.values.len()
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
        &self.values[j][self.stages - 1]
    }

    /// Unknowns when the pocket has gone a share of the turn.
    pub fn at(&self, radau: &Radau, turn: f64) -> [f64; BALL] {
        let turn = turn.rem_euclid(1.0);
        let j = self.ends.partition_point(|&end| end <= turn).clamp(1, self.intervals()) - 1;
        let [begin, width] = self.interval(j);
        let shares = radau.shares((turn - begin) / width);
        let from = self.begin(j);
        std::array::from_fn(|k| {
            shares[0] * from[k] + (0..self.stages).map(|i| shares[i + 1] * self.values[j][i][k]).sum::<f64>()
        })
    }

    /// The same on another mesh with the points of another rule.
    pub fn on(&self, from: &Radau, ends: Vec<f64>, to: &Radau) -> Self {
        let values = ends.windows(2).map(|e| to.points.map(|c| self.at(from, e[0] + c * (e[1] - e[0])))).collect();
        Self { ends, values, stages: to.stages, cage_speed: self.cage_speed, ring: self.ring }
    }
}
