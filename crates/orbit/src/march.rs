//! One ball sent round from a start, cage speed and ring held: Radau's method of fifth order with steps by its error,
//! so that the mesh is fine where a ball meets its pocket or loses a contact (E. Hairer, G. Wanner, Solving Ordinary
//! Differential Equations II, 1996, section IV.8).

use crate::collocation::{Orbit, STAGES, Values};
use crate::newton::Newton;
use crate::residual::STACK;
use crate::system::{BALL, RING};
use nalgebra::{SMatrix, SVector};

/// Longest, first and shortest step, turns. The last is taken whatever its error: there the ball stands at a kink.
const LONGEST: f64 = 0.08;
const FIRST: f64 = 0.01;
const SHORTEST: f64 = 1e-6;
/// Widths that there are within a factor of two.
const RUNGS: f64 = 6.0;
/// Intervals of a turn after which errors may be larger.
const MANY: usize = 1000;
/// Intervals after which a ball is thrown about too much to be followed.
const MOST: usize = 1500;
/// Newton steps of an interval.
const ITERATIONS: usize = 9;
/// Error of an interval where a turn is traced on a given mesh.
const CLOSELY: f64 = 1e-8;
/// Error of an interval's equations over that of its step.
const SOLVED: f64 = 0.03;
/// Real eigenvalue of the inverse of Radau's matrix, (6 + 81^(1/3) − 9^(1/3))/30 to the power of −1.
const REAL: f64 = 3.637_834_252_744_496;

type Block = SMatrix<f64, BALL, BALL>;
type Ball = SVector<f64, BALL>;
type Stack = SMatrix<f64, STACK, STACK>;
type Points = SVector<f64, STACK>;

/// The nearest of a ladder of widths. Where contacts begin and end, the error of a step depends steeply on where it
/// lies, and so does the next width: from step to step a last digit would grow until another mesh comes out. Widths
/// that are just those of the ladder forget it.
fn rung(width: f64) -> f64 {
    ((width.log2() * RUNGS).round() / RUNGS).exp2()
}

/// An interval that was tried.
struct Tried {
    values: Values,
    /// Error over what is allowed.
    error: f64,
    iterations: usize,
}

/// A place on the way with the slopes there, over the scales.
pub(crate) struct Place {
    turn: f64,
    y: [f64; BALL],
    /// Change per turn, and its slopes by the unknowns.
    rate: Ball,
    by: Block,
}

impl Newton<'_> {
    /// The turn from a start, with errors allowed in an interval over the scales.
    pub fn march(&mut self, from: &[f64; BALL], border: (f64, [f64; RING]), allowed: f64) -> Orbit {
        self.statistics.turns += 1;
        let mut orbit = Orbit { ends: vec![0.0], values: Vec::new(), cage_speed: border.0, ring: border.1 };
        let mut place = self.place(0.0, from, border);
        let mut width = FIRST;
        let mut rejected = false;
        while place.turn < 1.0 && (orbit.values.is_empty() || orbit.values.len() < MOST && !self.is_spent()) {
            self.tried += 1;
            let left = 1.0 - place.turn;
            let step = if width > 0.99 * left { left } else { width.min(0.5 * left) };
            // A ball that is thrown about has no turn worth following closely.
            let allowed = allowed * (1 + orbit.values.len() / MANY) as f64;
            let tried = self.interval(&place, step, (&orbit, allowed));
            let Some(tried) = tried.filter(|t| t.error < 1.0 || step <= SHORTEST) else {
                width = (0.3 * step).max(SHORTEST);
                rejected = true;
                if step > SHORTEST {
                    continue;
                }
                // Nothing solves the equations here: the ball goes on as it is.
                orbit.ends.push(place.turn + step);
                orbit.values.push([place.y; STAGES]);
                place = self.place(place.turn + step, &place.y.clone(), border);
                width = 10.0 * step;
                continue;
            };
            let end = if step == left { 1.0 } else { place.turn + step };
            orbit.ends.push(end);
            orbit.values.push(tried.values);
            self.statistics.intervals += 1;
            place = self.place(end, &tried.values[STAGES - 1], border);
            let safety = 0.9 * (2 * ITERATIONS + 1) as f64 / (2 * ITERATIONS + tried.iterations) as f64;
            let growth = (safety * tried.error.max(1e-8).powf(-0.25)).clamp(0.2, if rejected { 1.0 } else { 5.0 });
            width = rung(step * growth).clamp(SHORTEST, LONGEST);
            rejected = false;
        }
        orbit
    }

    /// The turn from a start over the intervals of an orbit near by, each met closely; none where one is not.
    pub fn traced(&mut self, from: &[f64; BALL], near: &Orbit) -> Option<Orbit> {
        self.statistics.turns += 1;
        let border = (near.cage_speed, near.ring);
        let s = &self.scales.ball;
        let mut orbit = Orbit { values: Vec::with_capacity(near.intervals()), ..near.clone() };
        let mut y = *from;
        for j in 0..near.intervals() {
            if self.watch.stops() {
                return None;
            }
            let [begin, width] = near.interval(j);
            let place = self.place(begin, &y, border);
            let guess =
                Points::from_fn(|n, _| (near.values[j][n / BALL][n % BALL] - near.begin(j)[n % BALL]) / s[n % BALL]);
            let (changes, _) = self.iterate_points(&place, width, (near, guess, CLOSELY), true)?;
            let values: Values = std::array::from_fn(|i| std::array::from_fn(|k| y[k] + s[k] * changes[BALL * i + k]));
            self.statistics.intervals += 1;
            self.tried += 1;
            y = values[STAGES - 1];
            orbit.values.push(values);
        }
        Some(orbit)
    }

    pub fn place(&self, turn: f64, y: &[f64; BALL], border: (f64, [f64; RING])) -> Place {
        let point = self.derivatives::<BALL>(self.system.azimuth(turn), y, border, &self.system.kernel);
        let time = self.system.time(1.0, border.0);
        let s = &self.scales.ball;
        Place {
            turn,
            y: *y,
            rate: Ball::from_fn(|k, _| time * point.rate[k] / s[k]),
            by: Block::from_fn(|k, c| time * point.by[k][c] / s[k]),
        }
    }

    /// Norm over what counts as an error.
    fn size(&self, change: impl Iterator<Item = f64>, count: usize) -> f64 {
        let errors = &self.scales.errors;
        (change.enumerate().map(|(n, c)| (c / errors[n % BALL]).powi(2)).sum::<f64>() / count as f64).sqrt()
    }

    /// Newton's method with the slopes of the beginning, or else with those of each point at each step, which take a
    /// ball over the kinks of its forces; none where neither converges.
    fn interval(&self, place: &Place, step: f64, (orbit, allowed): (&Orbit, f64)) -> Option<Tried> {
        let guess = self.guess(place, step, orbit);
        let simplified = self.iterate_points(place, step, (orbit, guess, allowed), false);
        let all = || self.iterate_points(place, step, (orbit, guess, allowed), true);
        let (changes, iterations) = simplified.or_else(all)?;
        let s = &self.scales.ball;
        let values = std::array::from_fn(|i| std::array::from_fn(|k| place.y[k] + s[k] * changes[BALL * i + k]));
        let error = self.error(place, step, &changes)? / allowed;
        Some(Tried { values, error, iterations })
    }

    fn iterate_points(
        &self,
        place: &Place,
        step: f64,
        (orbit, mut changes, allowed): (&Orbit, Points, f64),
        full: bool,
    ) -> Option<(Points, usize)> {
        let mut lu = self.matrix(&[place.by; STAGES], step).lu();
        let mut last = f64::INFINITY;
        for iterations in 1..=ITERATIONS {
            let (mut residual, slopes) = self.points(place, step, (orbit, &changes), full);
            if let Some(slopes) = slopes {
                lu = self.matrix(&slopes, step).lu();
            }
            if !lu.solve_mut(&mut residual) {
                return None;
            }
            changes += residual;
            let size = self.size(residual.iter().copied(), STACK) / allowed;
            let contraction = size / last;
            let left = if contraction < 1.0 { size * contraction / (1.0 - contraction) } else { size };
            if size == 0.0 || left.min(size) < SOLVED && iterations > 1 || size < 0.1 * SOLVED {
                return Some((changes, iterations));
            }
            let remaining = (ITERATIONS - iterations) as i32;
            let hopeless = iterations > 2 && left * contraction.powi(remaining) > SOLVED;
            let apart = iterations > 1 && contraction > 2.0 || hopeless;
            if !size.is_finite() || !full && apart {
                return None;
            }
            last = size;
        }
        None
    }

    /// Equations of the points by the points.
    fn matrix(&self, by: &[Block; STAGES], step: f64) -> Stack {
        let mut own = Stack::zeros();
        for (i, by) in by.iter().enumerate() {
            own.fixed_view_mut::<BALL, BALL>(BALL * i, BALL * i).copy_from(&(by * -step));
            for k in 0..BALL {
                (0..STAGES).for_each(|o| own[(BALL * i + k, BALL * o + k)] += self.radau.slope[i][o]);
            }
        }
        own
    }

    /// Residual of the equations of the points, with their slopes where wanted.
    fn points(
        &self,
        place: &Place,
        step: f64,
        (orbit, changes): (&Orbit, &Points),
        with_slopes: bool,
    ) -> (Points, Option<[Block; STAGES]>) {
        let (radau, s, border) = (&self.radau, &self.scales.ball, (orbit.cage_speed, orbit.ring));
        let time = self.system.time(step, orbit.cage_speed);
        let mut residual = Points::zeros();
        let mut slopes = with_slopes.then(|| [Block::zeros(); STAGES]);
        for i in 0..STAGES {
            let y: [f64; BALL] = std::array::from_fn(|k| place.y[k] + s[k] * changes[BALL * i + k]);
            let turn = place.turn + radau.points[i] * step;
            let rate = match &mut slopes {
                Some(slopes) => {
                    let at = self.place(turn, &y, border);
                    slopes[i] = at.by;
                    at.rate * step
                }
                None => {
                    let e = self.system.value(self.system.azimuth(turn), &y, border.0, border.1);
                    Ball::from_fn(|k, _| time * e.rate[k] / s[k])
                }
            };
            for k in 0..BALL {
                let slope: f64 = (0..STAGES).map(|o| radau.slope[i][o] * changes[BALL * o + k]).sum();
                residual[BALL * i + k] = rate[k] - slope;
            }
        }
        (residual, slopes)
    }

    /// Changes at the points of an interval as the interval before goes on; none at first.
    fn guess(&self, place: &Place, step: f64, orbit: &Orbit) -> Points {
        let count = orbit.values.len();
        let Some(values) = orbit.values.last().filter(|_| count > 1) else { return Points::zeros() };
        let [_, width] = orbit.interval(count - 1);
        if step > 3.0 * width {
            return Points::zeros();
        }
        let (from, s) = (orbit.end(count - 2), &self.scales.ball);
        let shares: [[f64; STAGES + 1]; STAGES] =
            std::array::from_fn(|i| self.radau.shares(1.0 + self.radau.points[i] * step / width));
        Points::from_fn(|n, _| {
            let (share, k) = (&shares[n / BALL], n % BALL);
            let on = share[0] * from[k] + (0..STAGES).map(|i| share[i + 1] * values[i][k]).sum::<f64>();
            (on - place.y[k]) / s[k]
        })
    }

    /// Estimated error of an interval's end with values at its points.
    pub fn error_of(&self, place: &Place, step: f64, values: &Values) -> Option<f64> {
        let s = &self.scales.ball;
        let change = |n: usize| (values[n / BALL][n % BALL] - place.y[n % BALL]) / s[n % BALL];
        self.error(place, step, &Points::from_fn(|n, _| change(n)))
    }

    /// Estimated error of the end against a formula of third order, damped where the equations are stiff.
    fn error(&self, place: &Place, step: f64, changes: &Points) -> Option<f64> {
        let root = 6f64.sqrt();
        let shares = [-(13.0 + 7.0 * root) / 3.0, (-13.0 + 7.0 * root) / 3.0, -1.0 / 3.0];
        let weighted = |k: usize| (0..STAGES).map(|i| shares[i] * changes[BALL * i + k]).sum::<f64>();
        let right = Ball::from_fn(|k, _| step * place.rate[k] + weighted(k));
        let error = (Block::identity() * REAL - place.by * step).lu().solve(&right)?;
        Some(self.size(error.iter().copied(), BALL))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_numerics::Radau;

    #[test]
    fn identity_the_real_eigenvalue_is_that_of_the_matrix() {
        let slope = Radau::new().slope;
        let m = SMatrix::<f64, STAGES, STAGES>::from_fn(|i, k| slope[i][k]);
        let singular = m - SMatrix::<f64, STAGES, STAGES>::identity() * REAL;
        assert!(singular.determinant().abs() < 1e-12 * m.determinant());
    }
}
