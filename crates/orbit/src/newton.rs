//! Newton's method on the collocated orbit.

use crate::OrbitError;
use crate::chain::{FROM, Jacobian, Slopes, Step, multiplier};
use crate::coarse::Coarse;
use crate::collocation::{Orbit, STAGES};
use crate::residual::{BORDER, Residual, STACK, Scales, residual};
use crate::system::{BALL, LEAD, ORBIT, OrbitSystem, RING, rings};
use nalgebra::{Const, SMatrix, SVector};
use num_dual::DualSVec64;
use std::sync::Arc;
use tribodyn_bearing::{LoadedPatch, RingFreedom, SearchWatch};
use tribodyn_numerics::Radau;
use tribodyn_traction::FastPatch;

/// Statistics of a solve: a wrong Jacobian converges too, only slower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OrbitStatistics {
    /// Jacobians of the whole orbit with their factorisation.
    pub jacobians: usize,
    /// Residuals, each of all points of the mesh.
    pub residuals: usize,
    /// Steps of the whole orbit tried again shorter.
    pub rejected: usize,
    /// Turns for which a ball was sent round.
    pub turns: usize,
    /// Intervals of those turns.
    pub intervals: usize,
}

/// Contraction up to which a Jacobian serves another step.
const CHORD: f64 = 0.2;
/// By how much a step may be longer than the one before, of full and of damped steps.
const FULL: f64 = 100.0;
const DAMPED: f64 = 1.0;
/// Shortest share of a step.
const LEAST_SHARE: f64 = 1e-2;
/// By how much the worst residual may rise in full steps: from farther off they do not come back. Damped ones do.
const STRAYED: f64 = 10.0;
/// Residual from which on an orbit is met by a few more Jacobians, and how many.
const CLOSE: f64 = 1e-2;
const LAST: usize = 3;
/// Residual below which an iteration that gains no more is left to itself.
const STALLED: f64 = 1e-6;

/// One Newton solver.
pub(crate) struct Newton<'a> {
    pub system: OrbitSystem<'a>,
    /// Patches by which Newton's method on all unknowns takes its slopes; none for those of the system.
    pub slopes_by: Option<FastPatch>,
    pub radau: Radau,
    pub scales: Scales,
    /// The last Jacobian with its mesh.
    pub last: Option<Jacobian>,
    pub statistics: OrbitStatistics,
    /// Errors of the last mesh, where it could not be made as fine as is asked for.
    pub coarse: Option<Coarse>,
    /// Intervals that were tried in all turns, and the number after which a turn is not gone on with.
    pub tried: usize,
    work: usize,
    /// By which the search is followed and ended.
    pub watch: SearchWatch,
}

impl<'a> Newton<'a> {
    pub fn new(system: OrbitSystem<'a>, scales: Scales, watch: SearchWatch) -> Self {
        let statistics = OrbitStatistics::default();
        Self {
            system,
            slopes_by: None,
            radau: Radau::new(),
            scales,
            last: None,
            statistics,
            coarse: None,
            tried: 0,
            work: usize::MAX,
            watch,
        }
    }

    /// Attempts something in which no turn is gone on with after so many intervals from now.
    pub fn within<T>(&mut self, work: usize, attempt: impl FnOnce(&mut Self) -> T) -> T {
        let outer = std::mem::replace(&mut self.work, self.tried + work);
        let result = attempt(self);
        self.work = outer;
        result
    }

    /// True once all intervals of an attempt are tried, or the caller ends the search.
    pub fn is_spent(&self) -> bool {
        self.tried >= self.work || self.watch.stops()
    }

    /// The same with other patches.
    pub fn with_patches<T>(&mut self, kernel: FastPatch, attempt: impl FnOnce(&mut Self) -> T) -> T {
        let own = std::mem::replace(&mut self.system.kernel, kernel);
        let result = attempt(self);
        self.system.kernel = own;
        result
    }

    pub fn residual(&mut self, orbit: &Orbit) -> Residual {
        self.statistics.residuals += 1;
        residual(&self.system, &self.radau, orbit, &self.scales)
    }

    /// Iterates from a start to a tolerance: full steps first, as contacts that open and close settle soonest by them,
    /// then damped ones.
    pub fn run(&mut self, orbit: Orbit, tolerance: f64, limit: usize) -> (Orbit, Residual) {
        let residual = self.residual(&orbit);
        if residual.worst.relative <= tolerance {
            return (orbit, residual);
        }
        // Both begin with it where the full steps lead away.
        let known = self.jacobian(&orbit).ok();
        let full = (limit / 2, FULL);
        let (there, left) = self.iterate((orbit.clone(), residual.clone()), tolerance, full, known.clone());
        if left.worst.relative <= tolerance {
            return (there, left);
        }
        let nearer = left.worst.relative < residual.worst.relative;
        let (from, known) = if nearer { ((there, left), None) } else { ((orbit, residual), known) };
        self.iterate(from, tolerance, (limit, DAMPED), known)
    }

    /// The same by so many Jacobians and full steps alone, the first of them known, and by a few more where these lead
    /// near; none where they do not meet the tolerance.
    pub fn by_full_steps(
        &mut self,
        orbit: Orbit,
        tolerance: f64,
        (jacobians, known): (usize, Option<Jacobian>),
    ) -> Option<(Orbit, Residual)> {
        let residual = self.residual(&orbit);
        let mut found = (orbit, residual);
        let known = known.filter(|known| known.serves(&found.0));
        let others = jacobians - usize::from(known.is_some());
        for (limit, known) in [(usize::from(known.is_some()), known), (others, None)] {
            found = self.iterate(found, tolerance, (limit, FULL), known);
        }
        if found.1.worst.relative < CLOSE {
            found = self.iterate(found, tolerance, (LAST, FULL), None);
        }
        (found.1.worst.relative <= tolerance).then_some(found)
    }

    /// Newton steps by the natural monotonicity test (P. Deuflhard, Newton Methods for Nonlinear Problems, 2011,
    /// section 3.3), each Jacobian kept as long as it contracts well, what it errs by learnt from the steps taken with
    /// it (Broyden's update in the same book's form, section 2.1.4). `growth` is by how much a step may be longer than
    /// the one before.
    fn iterate(
        &mut self,
        (mut orbit, mut residual): (Orbit, Residual),
        tolerance: f64,
        (limit, growth): (usize, f64),
        mut known: Option<Jacobian>,
    ) -> (Orbit, Residual) {
        let mut best = (f64::INFINITY, 0);
        let strayed = if growth == FULL { STRAYED * residual.worst.relative } else { f64::INFINITY };
        for iteration in 0..limit {
            if residual.worst.relative <= tolerance || residual.worst.relative > strayed || self.watch.stops() {
                break;
            }
            if residual.worst.relative < 0.5 * best.0 {
                best = (residual.worst.relative, iteration);
            } else if best.0 < STALLED && iteration > best.1 + 4 {
                break;
            }
            let fresh = known.is_none();
            let jacobian = known.take().map_or_else(|| self.jacobian(&orbit), Ok);
            let Ok(Jacobian { linear, .. }) = jacobian.inspect(|found| self.last = Some(found.clone())) else { break };
            let mut taken = vec![linear.step(&residual.intervals, &residual.border)];
            let mut share = self.longest(&taken[0]);
            while let Some(step) = taken.last() {
                let trial = self.apply(&orbit, step, share);
                let after = self.residual(&trial);
                if after.worst.relative <= tolerance {
                    (orbit, residual) = (trial, after);
                    break;
                }
                let next = linear.step(&after.intervals, &after.border).corrected(&taken);
                let (left, size) = (next.norm(), step.norm());
                // A fresh one that contracts no better: the next by the same cheap slopes would not either.
                if fresh && taken.len() == 1 && share == 1.0 && left > CHORD * size && left < size {
                    self.slopes_by = None;
                }
                if left <= growth * (1.0 - 0.25 * share) * size {
                    (orbit, residual) = (trial, after);
                    if share < 1.0 || left > CHORD * size {
                        break;
                    }
                    let next = next.lengthened(step);
                    share = self.longest(&next);
                    taken.push(next);
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
        let mut share = self.longest_of_border(&step.border);
        for change in step.values.iter().flat_map(|v| v.as_chunks::<BALL>().0) {
            (0..BALL).for_each(|k| share = share.min(s.limits[k] / (change[k] * s.ball[k]).abs().max(1e-300)));
        }
        share
    }

    /// The same by the end of the turn alone, the lead left out.
    pub fn longest_of_start(&self, step: &Step) -> f64 {
        let s = &self.scales;
        let Some(last) = step.values.last() else { return 1.0 };
        let of = |k: usize| s.limits[k] / (last[STACK - BALL + k] * s.ball[k]).abs().max(1e-300);
        (0..BALL).filter(|k| *k != LEAD).map(of).fold(1.0, f64::min)
    }

    /// The same by cage speed and ring alone.
    pub fn longest_of_border(&self, step: &[f64; BORDER]) -> f64 {
        let s = &self.scales;
        let of = |k: usize, largest: f64| largest / (step[k] * s.border[k]).abs().max(1e-300);
        (1..=3).map(|k| of(k, s.limits[0])).fold(of(0, s.limits[ORBIT]), f64::min).min(1.0)
    }

    /// Slopes of rates, cage torque and ring forces at a point, over the scales of the unknowns: by the ball's alone,
    /// or by cage speed and ring too.
    pub fn derivatives<const N: usize>(
        &self,
        azimuth: f64,
        y: &[f64; BALL],
        (cage_speed, ring): (f64, [f64; RING]),
        kernel: &FastPatch,
    ) -> Point<N> {
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
        let cage_speed = seed(cage_speed, BALL, s.border[0]);
        let ring: [DualSVec64<N>; RING] = std::array::from_fn(|k| seed(ring[k], BALL + 1 + k, s.border[1 + k]));
        let traction = |patch: &LoadedPatch<'_, DualSVec64<N>>| self.system.bearing.linear_traction(patch, kernel);
        let fixed = rings(ring, self.system.speeds);
        let e = self.system.ball(azimuth.into(), &unknowns, cage_speed, &fixed, traction);
        let slope = |value: &DualSVec64<N>| -> [f64; N] { value.eps.unwrap_generic(Const::<N>, Const::<1>).into() };
        Point {
            rate: e.rate.map(|r| r.re),
            by: e.rate.each_ref().map(slope),
            cage: slope(&e.cage_torque),
            ring: e.ring.each_ref().map(slope),
        }
    }

    fn jacobian(&mut self, orbit: &Orbit) -> Result<Jacobian, OrbitError> {
        Ok(Jacobian { ends: orbit.ends.clone(), linear: Arc::new(self.linearise(orbit)?) })
    }

    /// Largest modulus of a Floquet multiplier of a ball on an orbit, cage and ring held: below one, a ball that is
    /// moved off it comes back.
    pub fn multiplier(&mut self, orbit: &Orbit) -> Result<f64, OrbitError> {
        let held = orbit.ring.map(RingFreedom::Held);
        let ring = std::mem::replace(&mut self.system.ring, held);
        let cage = self.system.held.replace(orbit.cage_speed);
        let linear = self.linearise(orbit);
        (self.system.ring, self.system.held) = (ring, cage);
        Ok(multiplier(&linear?))
    }

    /// Slopes of the border's residuals by the border itself, without the balls.
    pub fn border_slopes(&self, orbit: &Orbit) -> [[f64; BORDER]; BORDER] {
        let mut slopes = [[0.0; BORDER]; BORDER];
        let speeds = self.system.speeds.map(num_dual::Dual64::from);
        let (_, by_speed): (f64, f64) = num_dual::first_derivative(
            |speed| {
                let [guidance, drag] = self.system.cage.fluid_torques(speed, speeds);
                guidance + drag
            },
            orbit.cage_speed,
        );
        slopes[0][0] = match self.system.held {
            Some(_) => -1.0,
            None => by_speed * self.scales.border[0] / self.scales.border_rows[0],
        };
        for (k, freedom) in self.system.ring.iter().enumerate() {
            if matches!(freedom, RingFreedom::Held(_)) {
                slopes[1 + k][1 + k] = -1.0;
            }
        }
        slopes
    }

    /// Slopes of an interval; adds what cage and ring get directly from their own motion.
    pub fn slopes(&self, orbit: &Orbit, j: usize, direct: &mut [[f64; BORDER]; BORDER]) -> Slopes {
        let [begin, width] = orbit.interval(j);
        let time = self.system.time(width, orbit.cage_speed);
        let balls = self.system.bearing.geometry.ball_count as f64;
        let s = &self.scales;
        let mut own = Box::new(SMatrix::<f64, STACK, STACK>::zeros());
        let mut right = Box::new(SMatrix::<f64, STACK, FROM>::zeros());
        let mut rows = Box::new(SMatrix::<f64, BORDER, STACK>::zeros());
        for i in 0..STAGES {
            let azimuth = self.system.azimuth(begin + self.radau.points[i] * width);
            let kernel = self.slopes_by.as_ref().unwrap_or(&self.system.kernel);
            let border = (orbit.cage_speed, orbit.ring);
            let point = self.derivatives::<FROM>(azimuth, &orbit.values[j][i], border, kernel);
            let at = i * BALL;
            for k in 0..BALL {
                let share = time / s.ball[k];
                (0..BALL).for_each(|c| own[(at + k, at + c)] = -share * point.by[k][c]);
                (0..STAGES).for_each(|other| own[(at + k, other * BALL + k)] += self.radau.slope[i][other]);
                right[(at + k, k)] = self.radau.slope[i].iter().sum();
                (0..BORDER).for_each(|c| right[(at + k, BALL + c)] = share * point.by[k][BALL + c]);
                right[(at + k, BALL)] -= share / orbit.cage_speed * s.border[0] * point.rate[k];
            }
            let weight = balls * width * self.radau.weights[i];
            let mut add = |row: usize, factor: f64, by: &[f64; FROM]| {
                (0..BALL).for_each(|c| rows[(row, at + c)] += factor * by[c]);
                (0..BORDER).for_each(|c| direct[row][c] += factor * by[BALL + c]);
            };
            if self.system.held.is_none() {
                add(0, weight / s.border_rows[0], &point.cage);
            }
            for (k, freedom) in self.system.ring.iter().enumerate() {
                if matches!(freedom, RingFreedom::Loaded(_)) {
                    add(1 + k, -weight / s.border_rows[1 + k], &point.ring[k]);
                }
            }
        }
        Slopes { own, right, rows }
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

    /// The start of the turn that a share of a step leads to from the end of the last. The lead goes no farther than
    /// its limit: where no ball meets its pocket hardly anything holds it. A step beyond what slopes can say is not
    /// taken, as balls settle by themselves.
    pub fn moved_start(&self, from: &[f64; BALL], step: &Step, share: f64) -> [f64; BALL] {
        let s = &self.scales;
        let Some(last) = step.values.last() else { return *from };
        let mut change: [f64; BALL] = std::array::from_fn(|k| share * s.ball[k] * last[STACK - BALL + k]);
        change[LEAD] = change[LEAD].clamp(-s.limits[LEAD], s.limits[LEAD]);
        if (0..BALL).all(|k| change[k].abs() <= s.limits[k]) {
            std::array::from_fn(|k| from[k] + change[k])
        } else {
            *from
        }
    }
}

/// A ball at a point: rates, and slopes over the scales of the unknowns.
pub(crate) struct Point<const N: usize> {
    pub rate: [f64; BALL],
    pub by: [[f64; N]; BALL],
    pub cage: [f64; N],
    pub ring: [[f64; N]; RING],
}
