//! The seven integrals.

use super::elementary::exp_m1;
use super::nodes::Kernel;
use super::{SMALLEST_ARGUMENT, Scaled};
use fearless_simd::{f64x4, prelude::*};

/// Sums over the unit disc without the factor p a b λ: share = w κ/s, f = share Δv.
pub(super) struct Values<'a, S: Simd> {
    pub(super) of: &'a Scaled,
    /// Σ f_x, f_y, X f_y, Y f_x, Y² f_x, Y² f_y, share |Δv|², w |Δv|.
    pub(super) sums: [f64x4<S>; 8],
}

pub(super) struct Row<S: Simd> {
    y: f64x4<S>,
    y2: f64x4<S>,
    u: f64x4<S>,
    u2: f64x4<S>,
    offset: f64x4<S>,
    /// Σ share, share v, share v X, share |Δv|², w |Δv|.
    sums: [f64x4<S>; 5],
}

/// u and the part of v that is constant on the row at Y, and Y².
#[inline(always)]
pub(super) fn row_slip<S: Simd>(of: &Scaled, y: f64x4<S>) -> [f64x4<S>; 3] {
    let ([gamma, beta, alpha], [delta, _, epsilon]) = (of.slip.longitudinal, of.slip.lateral);
    let y2 = y * y;
    [-(y * beta + y2 * alpha) + gamma, y2 * epsilon + delta, y2]
}

impl<'a, S: Simd> Values<'a, S> {
    #[inline(always)]
    pub(super) fn new(simd: S, of: &'a Scaled) -> Self {
        Self { of, sums: [f64x4::splat(simd, 0.0); 8] }
    }
}

impl<S: Simd> Kernel<S> for Values<'_, S> {
    type Row = Row<S>;

    #[inline(always)]
    fn open(&self, y: f64x4<S>) -> Row<S> {
        let [u, offset, y2] = row_slip(self.of, y);
        Row { y, y2, u, u2: u * u, offset, sums: [f64x4::splat(y.token(), 0.0); 5] }
    }

    #[inline(always)]
    fn point(&self, row: &mut Row<S>, x: f64x4<S>, w: f64x4<S>) {
        let of = self.of;
        let v = row.offset + x * of.slip.lateral[1];
        let squared = row.u2 + v * v;
        let speed = squared.sqrt();
        // C s; at rest a number so small that (exp(−x) − 1)/x is −1.
        let argument = (speed * of.rate).max(SMALLEST_ARGUMENT);
        let e = exp_m1((-argument).max(-700.0));
        let over_slip = (e + 1.0) * of.b + e / argument * of.a_c;
        let share = w * over_slip;
        let share_v = share * v;
        let terms = [share, share_v, share_v * x, share * squared, w * speed];
        for (sum, term) in row.sums.iter_mut().zip(terms) {
            *sum += term;
        }
    }

    #[inline(always)]
    fn close(&mut self, row: Row<S>) {
        let [share, fy, x_fy, power, wear] = row.sums;
        let fx = share * row.u;
        let terms = [fx, fy, x_fy, row.y * fx, row.y2 * fx, row.y2 * fy, power, wear];
        for (sum, term) in self.sums.iter_mut().zip(terms) {
            *sum += term;
        }
    }
}
