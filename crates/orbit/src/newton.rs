//! Newton's method on the collocated orbit. The points within an interval are eliminated first, each interval by
//! itself; what is left is a cyclic chain of the intervals' ends with a border for cage speed and ring, solved by a
//! sparse LU.

use crate::OrbitError;
use crate::collocation::{Orbit, Radau};
use crate::residual::{BORDER, Residual, STACK, Scales, residual, slope};
use crate::system::{BALL, ORBIT, OrbitSystem, RING, rings};
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::prelude::ReborrowMut;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{Argsort, Pair, SparseColMat, SymbolicSparseColMat};
use faer::{Mat, MatMut};
use nalgebra::SVector;
use num_dual::DualSVec64;
use tribodyn_bearing::{LoadedPatch, RingFreedom};

/// Derivatives of a ball: by its own unknowns, the cage speed and the ring.
const DERIVATIVES: usize = BALL + BORDER;

/// Statistics of a solve: a wrong Jacobian converges too, only slower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OrbitStatistics {
    /// Jacobians with their factorisation.
    pub jacobians: usize,
    /// Residuals, each of all points of the mesh.
    pub residuals: usize,
    /// Steps tried again shorter.
    pub rejected: usize,
}

/// An interval with its points eliminated.
pub(crate) struct Interval {
    lu: PartialPivLu<f64>,
    /// Points by the beginning of the interval and by the border.
    back: Mat<f64>,
    /// Border rows by the points.
    rows: Mat<f64>,
}

/// The linearised orbit, factorised.
pub(crate) struct Linear {
    intervals: Vec<Interval>,
    lu: Lu<usize, f64>,
}

/// A change of all unknowns, over their scales.
pub(crate) struct Step {
    values: Vec<[f64; STACK]>,
    pub border: [f64; BORDER],
}

impl Step {
    fn norm(&self) -> f64 {
        let points: f64 = self.values.iter().flatten().map(|v| v * v).sum();
        let points = points / (self.values.len() * STACK) as f64;
        (points + self.border.iter().map(|v| v * v).sum::<f64>()).sqrt()
    }
}

/// The sparse pattern of a number of intervals.
struct Pattern {
    symbolic: SymbolicSparseColMat<usize>,
    order: Argsort<usize>,
    lu: SymbolicLu<usize>,
}

impl Pattern {
    fn new(intervals: usize) -> Result<Self, OrbitError> {
        let size = BALL * intervals + BORDER;
        let pairs: Vec<Pair<usize, usize>> = places(intervals).map(|(row, col)| Pair { row, col }).collect();
        let failed = |_| OrbitError::Singular;
        let (symbolic, order) = SymbolicSparseColMat::try_new_from_indices(size, size, &pairs).map_err(failed)?;
        let lu = SymbolicLu::try_new(symbolic.as_ref()).map_err(|_| OrbitError::Singular)?;
        Ok(Self { symbolic, order, lu })
    }
}

/// Places of the entries in the order of [`entries`]: of each interval the diagonal, the block of the interval before
/// and the border's columns, then the border's rows.
fn places(intervals: usize) -> impl Iterator<Item = (usize, usize)> {
    let edge = BALL * intervals;
    let before = move |j: usize| BALL * if j == 0 { intervals - 1 } else { j - 1 };
    let chain = (0..intervals).flat_map(move |j| {
        (0..BALL).flat_map(move |k| {
            let row = BALL * j + k;
            let own = (0..BALL).map(move |c| (row, BALL * j + c)).filter(|(r, c)| r == c);
            own.chain((0..BALL).map(move |c| (row, before(j) + c))).chain((0..BORDER).map(move |c| (row, edge + c)))
        })
    });
    chain.chain((0..BORDER).flat_map(move |k| (0..edge + BORDER).map(move |c| (edge + k, c))))
}

/// Contraction up to which a Jacobian serves another step.
const CHORD: f64 = 0.2;
/// Shortest share of a step.
const LEAST_SHARE: f64 = 1e-2;
/// Residual below which an iteration that gains no more is left to itself.
const STALLED: f64 = 1e-6;

/// One Newton solver with its workspace.
pub(crate) struct Newton<'a> {
    pub system: OrbitSystem<'a>,
    pub radau: Radau,
    pub scales: Scales,
    pub statistics: OrbitStatistics,
    pattern: Option<(usize, Pattern)>,
}

impl<'a> Newton<'a> {
    pub fn new(system: OrbitSystem<'a>, scales: Scales) -> Self {
        Self { system, radau: Radau::third(), scales, statistics: OrbitStatistics::default(), pattern: None }
    }

    pub fn residual(&mut self, orbit: &Orbit) -> Residual {
        self.statistics.residuals += 1;
        residual(&self.system, &self.radau, orbit, &self.scales)
    }

    /// Iterates from a start to a tolerance: damped Newton steps by the natural monotonicity test (P. Deuflhard, Newton
    /// Methods for Nonlinear Problems, 2011, section 3.3), each Jacobian kept as long as it contracts well.
    pub fn run(&mut self, mut orbit: Orbit, tolerance: f64, limit: usize) -> (Orbit, Residual) {
        let mut residual = self.residual(&orbit);
        let mut best = (f64::INFINITY, 0);
        for iteration in 0..limit {
            if residual.worst.relative <= tolerance {
                break;
            }
            if residual.worst.relative < 0.5 * best.0 {
                best = (residual.worst.relative, iteration);
            } else if best.0 < STALLED && iteration > best.1 + 4 {
                break;
            }
            let Ok(linear) = self.linearise(&orbit) else { break };
            let mut step = self.step(&linear, &residual);
            let mut size = step.norm();
            let mut share = self.longest(&step);
            loop {
                let trial = self.apply(&orbit, &step, share);
                let after = self.residual(&trial);
                let next = self.step(&linear, &after);
                let left = next.norm();
                let good = left <= (1.0 - 0.25 * share) * size;
                if good || after.worst.relative <= tolerance {
                    (orbit, residual) = (trial, after);
                    if share < 1.0 || left > CHORD * size || residual.worst.relative <= tolerance {
                        break;
                    }
                    (step, size) = (next, left);
                    share = self.longest(&step);
                    continue;
                }
                self.statistics.rejected += 1;
                share *= 0.5;
                if share < LEAST_SHARE {
                    // A kink may need a step that the test does not like.
                    (orbit, residual) = (trial, after);
                    break;
                }
            }
        }
        (orbit, residual)
    }

    /// The share of a step that keeps all unknowns within reach of what the slopes say.
    pub fn longest(&self, step: &Step) -> f64 {
        let s = &self.scales;
        let mut share = 1f64;
        let mut limit = |change: f64, largest: f64| share = share.min(largest / change.abs().max(1e-300));
        for change in step.values.iter().flat_map(|v| v.as_chunks::<BALL>().0) {
            (0..BALL).for_each(|k| limit(change[k] * s.ball[k], s.limits[k]));
        }
        limit(step.border[0] * s.border[0], s.limits[ORBIT]);
        (0..3).for_each(|k| limit(step.border[1 + k] * s.border[1 + k], s.limits[0]));
        share
    }

    /// Slopes of rates, cage torque and ring forces at a point, over their scales: by the ball's unknowns alone, or
    /// by cage speed and ring too.
    fn derivatives<const N: usize>(&self, azimuth: f64, y: &[f64; BALL], orbit: &Orbit) -> Point<N> {
        let seed = |value: f64, k: usize, scale: f64| {
            if k >= N {
                return DualSVec64::<N>::from(value);
            }
            let mut direction = SVector::<f64, N>::zeros();
            direction[k] = scale;
            DualSVec64::<N>::new(value, num_dual::Derivative::some(direction))
        };
        let s = &self.scales;
        let unknowns: [DualSVec64<N>; BALL] = std::array::from_fn(|k| seed(y[k], k, s.ball[k]));
        let cage_speed = seed(orbit.cage_speed, BALL, s.border[0]);
        let ring: [DualSVec64<N>; RING] = std::array::from_fn(|k| seed(orbit.ring[k], BALL + 1 + k, s.border[1 + k]));
        let traction =
            |patch: &LoadedPatch<'_, DualSVec64<N>>| self.system.bearing.linear_traction(patch, &self.system.kernel);
        let fixed = rings(ring, self.system.speeds);
        let e = self.system.ball(azimuth.into(), &unknowns, cage_speed, &fixed, traction);
        let slope = |value: &DualSVec64<N>| -> [f64; N] {
            value.eps.unwrap_generic(nalgebra::Const::<N>, nalgebra::Const::<1>).into()
        };
        Point {
            rate: e.rate.map(|r| r.re),
            by: e.rate.each_ref().map(slope),
            cage: slope(&e.cage_torque),
            ring: e.ring.each_ref().map(slope),
        }
    }

    pub fn linearise(&mut self, orbit: &Orbit) -> Result<Linear, OrbitError> {
        self.statistics.jacobians += 1;
        let count = orbit.intervals();
        let balls = self.system.bearing.geometry.ball_count as f64;
        let mut intervals = Vec::with_capacity(count);
        let mut direct = self.border_slopes(orbit);
        let mut values = Vec::with_capacity(count * BALL * (1 + BALL + BORDER) + BORDER * (BALL * count + BORDER));
        for j in 0..count {
            let interval = self.interval(orbit, j, balls, &mut direct);
            let end = self.radau.stack() - BALL;
            for k in 0..BALL {
                values.push(1.0);
                values.extend((0..BALL + BORDER).map(|c| -interval.back[(end + k, c)]));
            }
            intervals.push(interval);
        }
        // Border rows by the ends: an interval's points follow from the end of the one before.
        let coupling: Vec<Mat<f64>> = intervals.iter().map(|i| &i.rows * &i.back).collect();
        for (k, direct) in direct.iter().enumerate() {
            for j in 0..count {
                let next = &coupling[(j + 1) % count];
                values.extend((0..BALL).map(|c| next[(k, c)]));
            }
            values.extend((0..BORDER).map(|c| direct[c] + coupling.iter().map(|m| m[(k, BALL + c)]).sum::<f64>()));
        }
        if self.pattern.as_ref().is_none_or(|(of, _)| *of != count) {
            self.pattern = Some((count, Pattern::new(count)?));
        }
        let Some((_, pattern)) = &self.pattern else { return Err(OrbitError::Singular) };
        let matrix = SparseColMat::new_from_argsort(pattern.symbolic.clone(), &pattern.order, &values)
            .map_err(|_| OrbitError::Singular)?;
        let lu = Lu::try_new_with_symbolic(pattern.lu.clone(), matrix.as_ref()).map_err(|_| OrbitError::Singular)?;
        Ok(Linear { intervals, lu })
    }

    /// Slopes of the border's residuals by the border itself, without the balls.
    fn border_slopes(&self, orbit: &Orbit) -> [[f64; BORDER]; BORDER] {
        let mut slopes = [[0.0; BORDER]; BORDER];
        let speeds = self.system.speeds.map(num_dual::Dual64::from);
        let (_, by_speed): (f64, f64) = num_dual::first_derivative(
            |speed| {
                let [guidance, drag] = self.system.cage.fluid_torques(speed, speeds);
                guidance + drag
            },
            orbit.cage_speed,
        );
        slopes[0][0] = by_speed * self.scales.border[0] / self.scales.border_rows[0];
        for (k, freedom) in self.system.ring.iter().enumerate() {
            if matches!(freedom, RingFreedom::Held(_)) {
                slopes[1 + k][1 + k] = -1.0;
            }
        }
        slopes
    }

    /// Eliminates the points of an interval; adds what cage and ring get directly from their own motion.
    pub fn interval(&self, orbit: &Orbit, j: usize, balls: f64, direct: &mut [[f64; BORDER]; BORDER]) -> Interval {
        let [begin, width] = orbit.interval(j);
        let time = self.system.time(width, orbit.cage_speed);
        let s = &self.scales;
        let stack = self.radau.stack();
        let mut own = Mat::<f64>::zeros(stack, stack);
        let mut right = Mat::<f64>::zeros(stack, BALL + BORDER);
        let mut rows = Mat::<f64>::zeros(BORDER, stack);
        for i in 0..self.radau.stages {
            let azimuth = self.system.azimuth(begin + self.radau.points[i] * width);
            let point = self.derivatives::<DERIVATIVES>(azimuth, &orbit.values[j][i], orbit);
            let at = i * BALL;
            for k in 0..BALL {
                for c in 0..BALL {
                    own[(at + k, at + c)] = -time * point.by[k][c] / s.ball[k];
                }
                for other in 0..self.radau.stages {
                    own[(at + k, other * BALL + k)] += self.radau.slope[i][other];
                }
                right[(at + k, k)] = self.radau.slope[i].iter().sum();
                for c in 0..BORDER {
                    right[(at + k, BALL + c)] = time * point.by[k][BALL + c] / s.ball[k];
                }
                right[(at + k, BALL)] -= time / orbit.cage_speed * s.border[0] * point.rate[k] / s.ball[k];
            }
            let weight = balls * width * self.radau.weights[i];
            let mut add = |row: usize, factor: f64, by: &[f64; DERIVATIVES]| {
                (0..BALL).for_each(|c| rows[(row, at + c)] += factor * by[c]);
                (0..BORDER).for_each(|c| direct[row][c] += factor * by[BALL + c]);
            };
            add(0, weight / s.border_rows[0], &point.cage);
            for (k, freedom) in self.system.ring.iter().enumerate() {
                if matches!(freedom, RingFreedom::Loaded(_)) {
                    add(1 + k, -weight / s.border_rows[1 + k], &point.ring[k]);
                }
            }
        }
        let lu = own.partial_piv_lu();
        lu.solve_in_place(right.rb_mut());
        Interval { lu, back: right, rows }
    }

    /// Change of an interval's points that solves the linearised equations with its beginning, cage speed and ring
    /// held.
    pub fn change_of(&self, orbit: &Orbit, j: usize) -> [f64; STACK] {
        let [begin, width] = orbit.interval(j);
        let time = self.system.time(width, orbit.cage_speed);
        let (s, stack) = (&self.scales, self.radau.stack());
        let mut own = Mat::<f64>::zeros(stack, stack);
        let mut change = [0.0; STACK];
        for i in 0..self.radau.stages {
            let slope = slope(&self.radau, orbit, j, i);
            let azimuth = self.system.azimuth(begin + self.radau.points[i] * width);
            let point = self.derivatives::<BALL>(azimuth, &orbit.values[j][i], orbit);
            let at = i * BALL;
            for k in 0..BALL {
                change[at + k] = (time * point.rate[k] - slope[k]) / s.ball[k];
                (0..BALL).for_each(|c| own[(at + k, at + c)] = -time * point.by[k][c] / s.ball[k]);
                (0..self.radau.stages).for_each(|o| own[(at + k, o * BALL + k)] += self.radau.slope[i][o]);
            }
        }
        own.partial_piv_lu().solve_in_place(MatMut::from_column_major_slice_mut(&mut change[..stack], stack, 1));
        change
    }

    pub fn step(&self, linear: &Linear, residual: &Residual) -> Step {
        let (count, stack) = (linear.intervals.len(), self.radau.stack());
        let mut right = Mat::<f64>::zeros(BALL * count + BORDER, 1);
        let mut free = Vec::with_capacity(count);
        let edge = BALL * count;
        (0..BORDER).for_each(|k| right[(edge + k, 0)] = -residual.border[k]);
        for (j, (interval, r)) in linear.intervals.iter().zip(&residual.intervals).enumerate() {
            let mut own = r.map(|v| -v);
            interval.lu.solve_in_place(MatMut::from_column_major_slice_mut(&mut own[..stack], stack, 1));
            (0..BALL).for_each(|k| right[(BALL * j + k, 0)] = own[stack - BALL + k]);
            for k in 0..BORDER {
                right[(edge + k, 0)] -= (0..stack).map(|c| interval.rows[(k, c)] * own[c]).sum::<f64>();
            }
            free.push(own);
        }
        linear.lu.solve_in_place(right.rb_mut());
        let border = std::array::from_fn(|k| right[(edge + k, 0)]);
        for (j, own) in free.iter_mut().enumerate() {
            let before = BALL * if j == 0 { count - 1 } else { j - 1 };
            let back = &linear.intervals[j].back;
            for (row, value) in own.iter_mut().take(stack).enumerate() {
                *value += (0..BALL).map(|c| back[(row, c)] * right[(before + c, 0)]).sum::<f64>();
                *value += (0..BORDER).map(|c| back[(row, BALL + c)] * border[c]).sum::<f64>();
            }
        }
        Step { values: free, border }
    }

    pub fn apply(&self, orbit: &Orbit, step: &Step, share: f64) -> Orbit {
        let s = &self.scales;
        let mut next = orbit.clone();
        for (values, change) in next.values.iter_mut().zip(&step.values) {
            for (i, value) in values.iter_mut().enumerate() {
                for k in 0..BALL {
                    value[k] += share * s.ball[k] * change[i * BALL + k];
                }
            }
        }
        next.cage_speed += share * s.border[0] * step.border[0];
        (0..RING).for_each(|k| next.ring[k] += share * s.border[1 + k] * step.border[1 + k]);
        next
    }
}

/// A ball at a point: rates, and slopes over the scales of the unknowns.
struct Point<const N: usize> {
    rate: [f64; BALL],
    by: [[f64; N]; BALL],
    cage: [f64; N],
    ring: [[f64; N]; RING],
}
