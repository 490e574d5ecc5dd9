//! The equation of a cell in eight strips at a time.

use super::curve::{At, Coefficient, halley};
use super::setup::Law;
use crate::fast::lanes::{Lanes, Mask, fused};
use fearless_simd::prelude::*;

/// Square of a trial slip below which nothing moves, (m/s)²: as in the plain cell.
const AT_REST: f64 = 1e-50;

/// Relative step behind which the root is as good as rounding lets it be: the next step would be about its cube.
pub(super) const SETTLED: f64 = 3e-5;

/// One cell of eight strips.
#[derive(Clone, Copy)]
pub(super) struct Cell<S: Simd> {
    pub(super) trial: [Lanes<S>; 2],
    square: Lanes<S>,
    /// The last cell's weakening.
    pub(super) last: Lanes<S>,
    pub(super) speed: Lanes<S>,
    /// The curve where it was taken last.
    at: At<S>,
    done: Mask<S>,
    pub(super) rest: Mask<S>,
}

/// a = s_t/(σ + C κ), the same over the denominators D, dD/dσ, and Σ a² (dD/dσ)/D.
#[derive(Clone, Copy)]
pub(super) struct Direction<S: Simd> {
    pub(super) a: [Lanes<S>; 2],
    pub(super) inverse: [Lanes<S>; 2],
    pub(super) grow: [Lanes<S>; 2],
    pub(super) rise: Lanes<S>,
}

impl<S: Simd> Cell<S> {
    #[inline(always)]
    pub(super) fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let none = z.simd_lt(z);
        Self { trial: [z; 2], square: z, last: z, speed: z, at: At::nothing(simd), done: none, rest: none }
    }

    /// Sets the trial slip and the last weakening.
    #[inline(always)]
    pub(super) fn open(&mut self, trial: [Lanes<S>; 2], last: Lanes<S>) {
        let one = Lanes::splat(last.token(), 1.0);
        let [u, v] = trial;
        let square = fused(u, u, v * v);
        self.rest = square.simd_lt(AT_REST);
        // Any number but zero, so that the lane runs through without harm.
        self.trial = [self.rest.select(one, u), v];
        (self.square, self.last) = (self.rest.select(one, square), last);
    }

    /// True when every lane has its root.
    #[inline(always)]
    pub(super) fn is_done(&self) -> bool {
        self.done.all_true()
    }

    /// −δσ by Halley's method, and a number below zero where σ is too small.
    #[inline(always)]
    fn step(&mut self, law: &Law, yielding: [f64; 2], keep: f64) -> [Lanes<S>; 2] {
        self.at = At::new(law, self.speed);
        let of = self.at.coefficient(law, self.last, keep);
        let ([u, v], [cx, cy]) = (self.trial, yielding);
        let d = [fused(of.value, cx, self.speed), fused(of.value, cy, self.speed)];
        let grow = [fused(of.slope, cx, 1.0), fused(of.slope, cy, 1.0)];
        halley([u * u, v * v], d, grow, [of.bend * cx, of.bend * cy])
    }

    /// One step from `start`, which nearly always ends at the root.
    #[inline(always)]
    pub(super) fn improve(&mut self, law: &Law, (yielding, keep): ([f64; 2], f64), start: Lanes<S>) {
        self.speed = start;
        let [change, _] = self.step(law, yielding, keep);
        self.speed -= change;
        self.done = change.abs().simd_le(start * SETTLED) | self.rest;
    }

    /// The root of lanes that are not done, within a bracket.
    #[inline(always)]
    pub(super) fn search(&mut self, law: &Law, (yielding, keep): ([f64; 2], f64)) {
        let lanes = |x: f64| Lanes::splat(self.last.token(), x);
        let (mut low, mut high, mut last) = (lanes(0.0), self.square.sqrt(), lanes(f64::INFINITY));
        let fits = self.speed.simd_gt(0.0) & self.speed.simd_lt(high);
        self.speed = (self.done | fits).select(self.speed, high);
        for _ in 0..200 {
            let [change, short] = self.step(law, yielding, keep);
            let below = short.simd_lt(0.0);
            let next = self.speed - change;
            let step = change.abs();
            low = below.select(self.speed, low);
            high = below.select(high, self.speed);
            // Rounding may leave the root at the very end of the bracket.
            let newton = next.simd_ge(low) & next.simd_le(high) & step.simd_lt(last * 0.5);
            let settled = newton & step.simd_le(self.speed * SETTLED);
            let narrow = (high - low).simd_le(high * 4e-16);
            let moved = newton.select(next, narrow.select(self.speed, (low + high) * 0.5));
            self.speed = self.done.select(self.speed, moved);
            last = step;
            self.done |= settled | narrow;
            if self.is_done() {
                break;
            }
        }
    }

    #[inline(always)]
    pub(super) fn direction(&self, of: &Coefficient<Lanes<S>>, [cx, cy]: [f64; 2]) -> Direction<S> {
        let (dx, dy) = (fused(of.value, cx, self.speed), fused(of.value, cy, self.speed));
        let product = Lanes::splat(dx.token(), 1.0) / (dx * dy);
        let inverse = [dy * product, dx * product];
        let a = [self.trial[0] * inverse[0], self.trial[1] * inverse[1]];
        let grow = [fused(of.slope, cx, 1.0), fused(of.slope, cy, 1.0)];
        let rise = fused(a[0] * a[0] * inverse[0], grow[0], a[1] * a[1] * inverse[1] * grow[1]);
        Direction { a, inverse, grow, rise }
    }

    /// The curve and κ at the root.
    #[inline(always)]
    pub(super) fn close(&mut self, law: &Law, keep: f64) -> (At<S>, Coefficient<Lanes<S>>) {
        let at = if self.rest.any_true() {
            self.speed = self.rest.select(Lanes::splat(self.speed.token(), 0.0), self.speed);
            At::new(law, self.speed)
        } else {
            self.at.moved_to(law, self.speed)
        };
        (at, at.coefficient(law, self.last, keep))
    }
}
