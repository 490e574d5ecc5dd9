//! The seven integrals.

use super::curve::LaneCurve;
use super::lanes::{Lanes, fused};
use super::nodes::{Block, Kernel, NODES, ROWS};
use super::{SMALLEST_SQUARE, Scaled};
use crate::SlipField;
use fearless_simd::prelude::*;

/// Sums over the unit disc without the factor p a b λ: share = w κ/s, f = share Δv.
pub(super) struct Values<'a, S: Simd, C> {
    of: &'a Scaled<C>,
    /// Σ f_x, f_y, X f_y, Y f_x, Y² f_x, Y² f_y, share |Δv|², w |Δv|.
    pub(super) sums: [Lanes<S>; 8],
    scratch: Scratch<S>,
}

/// Intermediate values of a block, from stage to stage; kept between blocks so that they are cleared only once.
struct Scratch<S: Simd> {
    u: [Lanes<S>; ROWS],
    v: [[Lanes<S>; NODES]; ROWS],
    squared: [[Lanes<S>; NODES]; ROWS],
    /// |Δv|, then the share.
    share: [[Lanes<S>; NODES]; ROWS],
}

/// u and the part of v that is constant on the row at Y, and Y².
#[inline(always)]
pub(crate) fn row_slip<S: Simd>(slip: &SlipField, y: Lanes<S>) -> [Lanes<S>; 3] {
    let ([gamma, beta, alpha], [delta, _, epsilon]) = (slip.longitudinal, slip.lateral);
    let y2 = y * y;
    [fused(-y, fused(y, alpha, beta), gamma), fused(y2, epsilon, delta), y2]
}

impl<'a, S: Simd, C> Values<'a, S, C> {
    #[inline(always)]
    pub(super) fn new(simd: S, of: &'a Scaled<C>) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let block = [[zero; NODES]; ROWS];
        let scratch = Scratch { u: [zero; ROWS], v: block, squared: block, share: block };
        Self { of, sums: [zero; 8], scratch }
    }
}

impl<S: Simd, C: LaneCurve> Kernel<S> for Values<'_, S, C> {
    #[inline(always)]
    fn block(&mut self, block: &Block<S>) {
        let of = self.of;
        // Bounds that the compiler can see.
        let (rows, nodes) = (block.rows.min(ROWS), block.nodes.min(NODES));
        let zero = Lanes::splat(block.y[0].token(), 0.0);
        let Scratch { u, v, squared, share } = &mut self.scratch;
        for i in 0..rows {
            let [along, offset, _] = row_slip(&of.slip, block.y[i]);
            u[i] = along;
            let along2 = along * along;
            for k in 0..nodes {
                v[i][k] = fused(block.x[i][k], of.slip.lateral[1], offset);
                squared[i][k] = fused(v[i][k], v[i][k], along2).max(SMALLEST_SQUARE);
                share[i][k] = squared[i][k].sqrt();
                self.sums[7] = fused(block.w[i][k], share[i][k], self.sums[7]);
            }
        }
        for (row, w) in share[..rows].iter_mut().zip(&block.w) {
            for (speed, &w) in row[..nodes].iter_mut().zip(w) {
                *speed = w * of.curve.over_slip(*speed);
            }
        }
        for i in 0..rows {
            let mut sums = [zero; 4];
            for k in 0..nodes {
                let share = share[i][k];
                let share_v = share * v[i][k];
                sums[0] += share;
                sums[1] += share_v;
                sums[2] = fused(share_v, block.x[i][k], sums[2]);
                sums[3] = fused(share, squared[i][k], sums[3]);
            }
            // Add Σ share, share v, share v X and share |Δv|² of the row at Y.
            let ([share, fy, x_fy, power], y) = (sums, block.y[i]);
            let (fx, y2) = (share * u[i], y * y);
            for (sum, term) in self.sums.iter_mut().zip([fx, fy, x_fy]) {
                *sum += term;
            }
            for (sum, (y, f)) in self.sums[3..].iter_mut().zip([(y, fx), (y2, fx), (y2, fy)]) {
                *sum = fused(y, f, *sum);
            }
            self.sums[6] += power;
        }
    }
}
