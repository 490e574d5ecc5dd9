//! One ball after another interval: the equations of each interval solved with the end of the one before as its
//! beginning. As motion with friction forgets, a turn or two of it give the orbit for a held cage speed and ring,
//! contacts lost or not.

use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::STACK;
use crate::start::implicit_step;
use crate::system::BALL;

/// Newton steps of an interval.
const ITERATIONS: usize = 14;
/// Newton steps after which they are shortened, for balances that swing to and fro.
const STEADY: usize = 5;

impl Newton<'_> {
    /// Goes round once, each interval solved to a change over the scales. Gives the largest change of an interval's
    /// end over the scales.
    pub fn sweep(&mut self, orbit: &mut Orbit, solved: f64) -> f64 {
        let mut largest = 0f64;
        for j in 0..orbit.intervals() {
            let old = *orbit.end(j);
            if !self.solve_interval(orbit, j, solved) {
                self.go_on(orbit, j);
            }
            let new = orbit.end(j);
            for k in 0..BALL {
                largest = largest.max(((new[k] - old[k]) / self.scales.ball[k]).abs());
            }
        }
        largest
    }

    fn solve_interval(&mut self, orbit: &mut Orbit, j: usize, solved: f64) -> bool {
        let mut last = f64::INFINITY;
        for iteration in 0..ITERATIONS {
            let change = self.change_of(orbit, j);
            let s = &self.scales;
            let mut share = if iteration < STEADY { 1f64 } else { 0.5 };
            for (n, c) in change.iter().enumerate().take(self.radau.stack()) {
                share = share.min(s.limits[n % BALL] / (c * s.ball[n % BALL]).abs().max(1e-300));
            }
            for (n, c) in change.iter().enumerate().take(self.radau.stack()) {
                orbit.values[j][n / BALL][n % BALL] += share * s.ball[n % BALL] * c;
            }
            let size = change.iter().map(|c| c * c).sum::<f64>().sqrt() / STACK as f64;
            if size < solved {
                return true;
            }
            if !size.is_finite() || size > 1e3 * last {
                return false;
            }
            last = size;
        }
        false
    }

    /// By implicit Euler steps from point to point.
    fn go_on(&self, orbit: &mut Orbit, j: usize) {
        let [begin, width] = orbit.interval(j);
        let (mut y, mut done) = (*orbit.begin(j), 0.0);
        for (i, point) in self.radau.points.into_iter().enumerate().take(self.radau.stages) {
            let azimuth = self.system.azimuth(begin + point * width);
            let time = self.system.time(width * (point - done), orbit.cage_speed);
            y = implicit_step(&self.system, &self.scales, (azimuth, time), &y, (orbit.cage_speed, orbit.ring));
            orbit.values[j][i] = y;
            done = point;
        }
    }
}
