//! The equation of a cell in eight strips at a time.

use super::curve::{At, Coefficient};
use super::setup::Law;
use crate::fast::lanes::{Lanes, Mask, fused};
use fearless_simd::prelude::*;

/// Square of a trial slip below which nothing moves, (m/s)²: as in the plain cell.
const AT_REST: f64 = 1e-50;

/// Relative step behind which the root is good to 1e-12: the next step would be a third of its cube.
pub(super) const SETTLED: f64 = 1e-4;

/// One cell of eight strips.
#[derive(Clone, Copy)]
pub(super) struct Cell<S: Simd> {
    pub(super) trial: [Lanes<S>; 2],
    /// The last cell's weakening.
    pub(super) last: Lanes<S>,
    pub(super) rest: Mask<S>,
}

/// The equation of a cell at a trial speed σ, and the step from there to its root.
#[derive(Clone, Copy)]
pub(super) struct Near<S: Simd> {
    at: At<S>,
    of: Coefficient<Lanes<S>>,
    /// 1/D of the denominators D = σ + C κ, and a = s_t/D.
    inverse: [Lanes<S>; 2],
    direction: [Lanes<S>; 2],
    /// (dD/dσ)/D and half of (d²D/dσ²)/D.
    grow: [Lanes<S>; 2],
    bend: [Lanes<S>; 2],
    /// From σ to the root.
    far: Lanes<S>,
    /// Below zero where σ is too small.
    short: Lanes<S>,
    done: Mask<S>,
}

/// The root of a cell.
#[derive(Clone, Copy)]
pub(super) struct Root<S: Simd> {
    /// σ, m/s.
    pub(super) speed: Lanes<S>,
    pub(super) of: Coefficient<Lanes<S>>,
    pub(super) weakening: Lanes<S>,
    /// a = s_t/(σ + C κ).
    pub(super) direction: [Lanes<S>; 2],
}

/// More of a root, for its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Around<S: Simd> {
    pub(super) at: At<S>,
    /// 1/D, dD/dσ and Σ a² (dD/dσ)/D.
    pub(super) inverse: [Lanes<S>; 2],
    pub(super) grow: [Lanes<S>; 2],
    pub(super) rise: Lanes<S>,
}

impl<S: Simd> Near<S> {
    /// 1/D at the root over that at the trial speed, less one.
    #[inline(always)]
    fn more(&self) -> [Lanes<S>; 2] {
        let ([gx, gy], [bx, by], far) = (self.grow, self.bend, self.far);
        let (x, y) = (fused(bx, far, gx) * far, fused(by, far, gy) * far);
        [fused(x, x, -x), fused(y, y, -y)]
    }
}

impl<S: Simd> Cell<S> {
    #[inline(always)]
    pub(super) fn new(trial: [Lanes<S>; 2], last: Lanes<S>) -> Self {
        let [u, v] = trial;
        let rest = fused(u, u, v * v).simd_lt(AT_REST);
        // Any number but zero, so that the lane runs through without harm.
        let u = rest.select(Lanes::splat(u.token(), 1.0), u);
        Self { trial: [u, v], last, rest }
    }

    /// A step of Halley's method from a speed, which nearly always ends at the root if that comes from
    /// [`super::start`]. For 1/S − 1 with S = Σ a²:
    /// ```text
    /// R = Σ a² D'/D,   T = Σ a² (D''/D − 3 (D'/D)²)/2,   δσ = −(1 − S) R/2/(R² − (1 − S) T/2)
    /// ```
    #[inline(always)]
    pub(super) fn near(&self, law: &Law, ([cx, cy], keep): ([f64; 2], f64), speed: Lanes<S>) -> Near<S> {
        let at = At::new(law, speed);
        let of = at.coefficient(law, self.last, keep);
        let [u, v] = self.trial;
        let (dx, dy) = (fused(of.value, cx, speed), fused(of.value, cy, speed));
        let product = Lanes::splat(speed.token(), 1.0) / (dx * dy);
        let (ix, iy) = (dy * product, dx * product);
        let (ax, ay) = (u * ix, v * iy);
        let (cx, cy, half) = (ix * cx, iy * cy, of.bend * 0.5);
        let (gx, gy) = (fused(of.slope, cx, ix), fused(of.slope, cy, iy));
        let (bx, by) = (half * cx, half * cy);
        let (qx, qy) = (ax * ax, ay * ay);
        let short = -(qx + qy) + 1.0;
        let rise = fused(qx, gx, qy * gy);
        let turn = fused(qx, fused(gx * gx, -1.5, bx), qy * fused(gy * gy, -1.5, by));
        let rise2 = rise * rise;
        let slope = fused(short * turn, -0.5, rise2).max(rise2 * 0.25);
        let far = short * rise * -0.5 / slope;
        let done = far.abs().simd_le(speed * SETTLED) & !self.rest;
        Near { at, of, inverse: [ix, iy], direction: [ax, ay], grow: [gx, gy], bend: [bx, by], far, short, done }
    }

    /// A step that ends at the root in every lane: the one that was made, or where that does not the last of a search.
    #[inline(always)]
    pub(super) fn last_step(&self, law: &Law, given: ([f64; 2], f64), near: Near<S>) -> Near<S> {
        if near.done.all_true() { near } else { self.search(law, given, near) }
    }

    /// The root of lanes that are not done, within a bracket.
    #[inline(always)]
    fn search(&self, law: &Law, given: ([f64; 2], f64), start: Near<S>) -> Near<S> {
        let lanes = |x: f64| Lanes::splat(self.last.token(), x);
        let [u, v] = self.trial;
        let (mut low, mut high, mut last) = (lanes(0.0), fused(u, u, v * v).sqrt(), lanes(f64::INFINITY));
        let (mut done, mut speed) = (start.done | self.rest, start.at.speed + start.far);
        let fits = speed.simd_gt(0.0) & speed.simd_lt(high);
        speed = (done | fits).select(speed, high);
        for _ in 0..200 {
            let near = self.near(law, given, speed);
            let below = near.short.simd_lt(0.0);
            let next = speed + near.far;
            let step = near.far.abs();
            low = below.select(speed, low);
            high = below.select(high, speed);
            // Rounding may leave the root at the very end of the bracket.
            let newton = next.simd_ge(low) & next.simd_le(high) & step.simd_lt(last * 0.5);
            let settled = newton & step.simd_le(speed * SETTLED);
            let narrow = (high - low).simd_le(high * 4e-16);
            let moved = newton.select(next, narrow.select(speed, (low + high) * 0.5));
            let moved = done.select(speed, moved);
            last = step;
            done |= settled | narrow;
            if done.all_true() && !self.rest.any_true() {
                return Near { far: moved - speed, ..near };
            }
            speed = moved;
            if done.all_true() {
                break;
            }
        }
        let mut near = self.near(law, given, self.rest.select(lanes(0.0), speed));
        near.far = lanes(0.0);
        for parts in [&mut near.inverse, &mut near.direction, &mut near.grow, &mut near.bend] {
            for part in parts {
                *part = self.rest.select(lanes(0.0), *part);
            }
        }
        near
    }

    /// The root, near enough that nothing is worked out again.
    #[inline(always)]
    pub(super) fn root(&self, law: &Law, keep: f64, near: &Near<S>) -> Root<S> {
        let Near { at, of, far, direction: [ax, ay], .. } = near;
        let [more_x, more_y] = near.more();
        let direction = [fused(more_x, *ax, *ax), fused(more_y, *ay, *ay)];
        let by = fused(of.bend, *far * 0.5, of.slope);
        let of = Coefficient { value: fused(by, *far, of.value), slope: fused(of.bend, *far, of.slope), bend: of.bend };
        let weakening = at.past.select(fused(of.value, -law.over_peak, 1.0), self.last * keep);
        Root { speed: at.speed + *far, of, weakening, direction }
    }

    #[inline(always)]
    pub(super) fn around(&self, law: &Law, [cx, cy]: [f64; 2], near: &Near<S>, root: &Root<S>) -> Around<S> {
        let ([ix, iy], [more_x, more_y], slope) = (near.inverse, near.more(), root.of.slope);
        let inverse = [fused(more_x, ix, ix), fused(more_y, iy, iy)];
        let grow = [fused(slope, cx, 1.0), fused(slope, cy, 1.0)];
        let a = root.direction;
        let rise = fused(a[0] * a[0] * inverse[0], grow[0], a[1] * a[1] * inverse[1] * grow[1]);
        Around { at: near.at.moved_to(law, root.speed), inverse, grow, rise }
    }
}
