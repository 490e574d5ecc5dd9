//! The derivative of the seven integrals, from one more pass over the same nodes.

use super::curve::{LaneCurve, Slopes};
use super::lanes::{Lanes, fused, total, totals};
use super::nodes::{Block, Kernel, NODES, ROWS};
use super::values::row_slip;
use super::{SMALLEST_SQUARE, Scaled, assemble as assemble_values, flatness};
use crate::{Patch, PatchTraction, RelativeMotion};
use fearless_simd::prelude::*;
use std::f64::consts::PI;

/// The integrals of one patch and their first derivatives: those of the integral, not of the rule, for strips whose
/// nodes move with the motion are held fast.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatchDerivative {
    /// The integrals.
    pub traction: PatchTraction,
    /// Derivatives of (force_rolling, force_lateral, moment_normal, moment_lateral, moment_rolling), by row, with
    /// respect to (rolling, lateral, spin, about_lateral, about_rolling) of the motion: the outputs that do work on the
    /// inputs. N s/m, N s, N m s. Symmetric, and negative semidefinite where κ rises with slip.
    pub by_motion: [[f64; 5]; 5],
    /// Derivatives with respect to the contact load in N, with semi-axes and peak pressure as its cube root, and the
    /// curve by its slope over pressure.
    pub by_load: PatchTraction,
    /// Derivatives with respect to the rolling speed in m/s, through the unit of slip.
    pub by_rolling_speed: PatchTraction,
}

impl PatchDerivative {
    /// This and another in the shares 1 − `share` and `share`; everything is linear in the curve.
    pub fn mixed_with(&self, other: &Self, share: f64) -> Self {
        let by_motion = std::array::from_fn(|i| {
            std::array::from_fn(|k| self.by_motion[i][k] * (1.0 - share) + other.by_motion[i][k] * share)
        });
        Self {
            traction: self.traction.mixed_with(&other.traction, share),
            by_motion,
            by_load: self.by_load.mixed_with(&other.by_load, share),
            by_rolling_speed: self.by_rolling_speed.mixed_with(&other.by_rolling_speed, share),
        }
    }

    /// No contact.
    pub fn zero() -> Self {
        let zero = PatchTraction::zero();
        Self { traction: zero, by_motion: [[0.0; 5]; 5], by_load: zero, by_rolling_speed: zero }
    }
}

/// Sums of one row, without λ: values, stiffness K = (κ/s) I + s (κ/s)' n nᵀ and change with the load.
pub(super) struct Row<S: Simd> {
    y: Lanes<S>,
    y2: Lanes<S>,
    u: Lanes<S>,
    u2: Lanes<S>,
    offset: Lanes<S>,
    /// Change of u, and of v but for the spin, while y grows in proportion.
    du: Lanes<S>,
    dv: Lanes<S>,
    /// Of share, f_y, w |Δv|, K_11, K_12, K_22, K_22 X, changes of f_x, of f_y and of the power.
    sums: [Lanes<S>; 10],
    /// Of f_y X, the power, K_12 X, K_22 X², change of f_y times X, changes of w |Δv| and with the slip scale.
    products: [Lanes<S>; 7],
    /// Of the share, f_y, f_y X and the power by the entrainment speed.
    entrained: [Lanes<S>; 4],
}

/// The integrals' sums, as [`Row`]'s times powers of Y.
pub(super) struct Sums<'a, S: Simd, C> {
    of: &'a Scaled<C>,
    plain: [Lanes<S>; PLAIN],
    products: [Lanes<S>; SUMS - PLAIN],
    /// Those of the values by the entrainment speed, in their order.
    entrained: [Lanes<S>; 8],
}

/// Sums over all nodes.
pub(super) struct Totals {
    of: [f64; SUMS],
    entrained: Option<[f64; 8]>,
}

/// 8 of the values, 5 + 8 + 6 of the stiffness, 8 of the load, 1 of the slip scale.
const SUMS: usize = 36;
/// Those without a power of Y.
const PLAIN: usize = 17;
/// Where [`assemble`] has the sums that [`Sums::close`] makes, in its order: first those without a power of Y.
#[rustfmt::skip]
const PLACES: [usize; SUMS] = [
    0, 1, 2, 6, 7, 8, 13, 18, 21, 24, 26, 27, 28, 29, 33, 34, 35,
    3, 4, 5, 9, 10, 11, 12, 14, 15, 16, 17, 19, 20, 22, 23, 25, 30, 31, 32,
];

impl<'a, S: Simd, C: LaneCurve> Sums<'a, S, C> {
    #[inline(always)]
    pub(super) fn new(simd: S, of: &'a Scaled<C>) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self { of, plain: [zero; PLAIN], products: [zero; SUMS - PLAIN], entrained: [zero; 8] }
    }

    #[inline(always)]
    pub(super) fn totals(&self) -> Totals {
        let mut of = [0.0; SUMS];
        for (place, &sum) in PLACES.into_iter().zip(self.plain.iter().chain(&self.products)) {
            of[place] = total(sum);
        }
        Totals { of, entrained: if C::ENTRAINED { Some(totals(&self.entrained)) } else { None } }
    }
}

impl<S: Simd, C: LaneCurve> Kernel<S> for Sums<'_, S, C> {
    #[inline(always)]
    fn block(&mut self, block: &Block<S>) {
        for i in 0..block.rows.min(ROWS) {
            let mut row = self.open(block.y[i]);
            for k in 0..block.nodes.min(NODES) {
                self.point(&mut row, block.x[i][k], block.w[i][k]);
            }
            self.close(row);
        }
    }
}

impl<S: Simd, C: LaneCurve> Sums<'_, S, C> {
    #[inline(always)]
    fn open(&self, y: Lanes<S>) -> Row<S> {
        let [u, offset, y2] = row_slip(&self.of.slip, y);
        let ([_, beta, alpha], [_, _, epsilon]) = (self.of.slip.longitudinal, self.of.slip.lateral);
        let (du, dv) = (-y * fused(y, 2.0 * alpha, beta), y2 * (2.0 * epsilon));
        let zero = Lanes::splat(y.token(), 0.0);
        let (sums, products, entrained) = ([zero; 10], [zero; 7], [zero; 4]);
        Row { y, y2, u, u2: u * u, offset, du, dv, sums, products, entrained }
    }

    #[inline(always)]
    fn point(&self, row: &mut Row<S>, x: Lanes<S>, w: Lanes<S>) {
        let (of, u) = (self.of, row.u);
        let v = fused(x, of.slip.lateral[1], row.offset);
        let squared = fused(v, v, row.u2).max(SMALLEST_SQUARE);
        let speed = squared.sqrt();
        let Slopes { over_slip, bend, by_pressure, by_entrainment } = of.curve.slopes(speed);
        let share = w * over_slip;
        // At rest every direction is as good: the bend vanishes there.
        let inverse = Lanes::splat(x.token(), 1.0) / squared;
        let along = w * bend * inverse;
        let (along_u, along_v) = (along * u, along * v);
        let (k11, k12, k22) = (fused(along_u, u, share), along_u * v, fused(along_v, v, share));
        let curve = w * by_pressure;
        let (du, dv) = (row.du, fused(x, of.slip.lateral[1], row.dv));
        let dfx = fused(k11, du, fused(k12, dv, curve * u));
        let dfy = fused(k12, du, fused(k22, dv, curve * v));
        let dot = fused(u, du, v * dv);
        let (fy, wear, k22_x) = (share * v, w * speed, k22 * x);
        let dpower = fused(dfx, u, fused(dfy, v, share * dot));
        let dscale = fused(w, bend, share);
        for (sum, term) in row.sums.iter_mut().zip([share, fy, wear, k11, k12, k22, k22_x, dfx, dfy, dpower]) {
            *sum += term;
        }
        let products =
            [[fy, x], [share, squared], [k12, x], [k22_x, x], [dfy, x], [wear * dot, inverse], [dscale, squared]];
        add_products(&mut row.products, products);
        if let Some(slope) = by_entrainment {
            let share = w * slope;
            let fy = share * v;
            let one = Lanes::splat(x.token(), 1.0);
            add_products(&mut row.entrained, [[share, one], [fy, one], [fy, x], [share, squared]]);
        }
    }

    #[inline(always)]
    fn close(&mut self, row: Row<S>) {
        let (y, y2) = (row.y, row.y2);
        let [share, fy, wear, k11, k12, k22, k22_x, dfx, dfy, dpower] = row.sums;
        let [x_fy, power, k12_x, k22_xx, xdfy, dwear, dscale] = row.products;
        let (fx, y3, y4) = (share * row.u, y * y2, y2 * y2);
        let plain =
            [fx, fy, x_fy, power, wear, k11, k12, k12_x, k22, k22_x, k22_xx, dfx, dfy, xdfy, dpower, dwear, dscale];
        for (sum, term) in self.plain.iter_mut().zip(plain) {
            *sum += term;
        }
        #[rustfmt::skip]
        let products = [
            [fx, y], [fx, y2], [fy, y2], [k11, y], [k11, y2], [k11, y3], [k11, y4],
            [k12, y], [k12, y2], [k12, y3], [k12, y4], [k12_x, y], [k12_x, y2], [k22, y2], [k22, y4], [k22_x, y2],
            [dfx, y], [dfx, y2], [dfy, y2],
        ];
        add_products(&mut self.products, products);
        if !C::ENTRAINED {
            return;
        }
        let [share, fy, x_fy, power] = row.entrained;
        let fx = share * row.u;
        let terms = [fx, fy, x_fy, y * fx, y2 * fx, y2 * fy, power];
        for (sum, term) in self.entrained.iter_mut().zip(terms) {
            *sum += term;
        }
    }
}

/// Adds a product to each sum.
#[inline(always)]
fn add_products<S: Simd, const N: usize>(sums: &mut [Lanes<S>; N], products: [[Lanes<S>; 2]; N]) {
    for (sum, [a, b]) in sums.iter_mut().zip(products) {
        *sum = fused(a, b, *sum);
    }
}

/// Σ w k X^i Y^j of one entry of K, under the names of their powers.
struct Moments<'a> {
    patch: &'a Patch,
    /// y²/(2R_c) over Y², m.
    bow: f64,
}

impl Moments<'_> {
    /// Sum with the height h of the contact, from the sums with 1 and Y².
    fn height(&self, one: f64, y2: f64) -> f64 {
        self.patch.ball_radius * one - self.bow * y2
    }

    /// Sum with its square.
    fn squared(&self, [one, y2, y4]: [f64; 3]) -> f64 {
        self.height(self.height(one, y2), self.height(y2, y4))
    }
}

pub(super) fn assemble(
    (patch, motion): (&Patch, &RelativeMotion),
    scale: f64,
    Totals { of: sums, entrained }: &Totals,
    relative_scale_slope: f64,
) -> PatchDerivative {
    let values: [f64; 8] = std::array::from_fn(|i| sums[i]);
    let traction = assemble_values(patch, scale, values);
    let by_motion = stiffness(patch, scale, sums);
    let by_load = load_slope(patch, scale, &traction, sums);
    let m = [motion.rolling, motion.lateral, motion.spin, motion.about_lateral, motion.about_rolling];
    // The integrals depend on the motion and on λ only as a product.
    let row = |i: usize| relative_scale_slope * by_motion[i].iter().zip(m).map(|(d, m)| d * m).sum::<f64>();
    let load = patch.peak_pressure * patch.semi_lateral * patch.semi_rolling;
    let by_unit = PatchTraction {
        force_rolling: row(0),
        force_lateral: row(1),
        moment_normal: row(2),
        moment_lateral: row(3),
        moment_rolling: row(4),
        power: relative_scale_slope * load * scale * sums[35],
        wear_integral: 0.0,
    };
    let by_rolling_speed = match entrained {
        Some(sums) => by_unit.plus(&assemble_values(patch, scale, *sums)),
        None => by_unit,
    };
    PatchDerivative { traction, by_motion, by_load, by_rolling_speed }
}

/// −p a b λ Σ w Jᵀ K J with (u, v) = J motion: J_u = (1, 0, −y, h, 0), J_v = (0, 1, x, 0, −h).
fn stiffness(patch: &Patch, scale: f64, sums: &[f64; SUMS]) -> [[f64; 5]; 5] {
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let k11: [f64; 5] = std::array::from_fn(|i| sums[8 + i]);
    let [k12_0, k12_1, k12_2, k12_3, k12_4, k12_x, k12_xy, k12_xy2]: [f64; 8] = std::array::from_fn(|i| sums[13 + i]);
    let [k22_0, k22_2, k22_4, k22_x, k22_xy2, k22_xx]: [f64; 6] = std::array::from_fn(|i| sums[21 + i]);
    let m = Moments { patch, bow: flatness(patch) };
    // What spin does to the slip, once and times Y²: sums of K (−y, x)ᵀ.
    let turn_u = [b * k12_x - a * k11[1], b * k12_xy2 - a * k11[3]];
    let turn_v = [b * k22_x - a * k12_1, b * k22_xy2 - a * k12_3];
    let turn = a * a * k11[2] - 2.0 * a * b * k12_xy + b * b * k22_xx;
    let (h11, h12, h22) = (m.height(k11[0], k11[2]), m.height(k12_0, k12_2), m.height(k22_0, k22_2));
    let both12 = m.squared([k12_0, k12_2, k12_4]);
    let rows = [
        [k11[0], k12_0, turn_u[0], h11, -h12],
        [k12_0, k22_0, turn_v[0], h12, -h22],
        [turn_u[0], turn_v[0], turn, m.height(turn_u[0], turn_u[1]), -m.height(turn_v[0], turn_v[1])],
        [h11, h12, m.height(turn_u[0], turn_u[1]), m.squared([k11[0], k11[2], k11[4]]), -both12],
        [-h12, -h22, -m.height(turn_v[0], turn_v[1]), -both12, m.squared([k22_0, k22_2, k22_4])],
    ];
    let factor = -patch.peak_pressure * a * b * scale;
    rows.map(|row| row.map(|entry| factor * entry))
}

/// Q d/dQ is a third of the derivative while x, y and p grow in proportion.
fn load_slope(patch: &Patch, scale: f64, traction: &PatchTraction, sums: &[f64; SUMS]) -> PatchTraction {
    let values: [f64; 8] = std::array::from_fn(|i| sums[i]);
    let inner: [f64; 8] = std::array::from_fn(|i| sums[27 + i]);
    let slopes = assemble_values(patch, scale, inner);
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let volume = patch.peak_pressure * a * b;
    let load = 2.0 / 3.0 * PI * volume;
    let factor = 1.0 / (3.0 * load);
    // The arm falls by twice its bow.
    let sag = 2.0 * flatness(patch) * volume * scale;
    PatchTraction {
        force_rolling: factor * (3.0 * traction.force_rolling + slopes.force_rolling),
        force_lateral: factor * (3.0 * traction.force_lateral + slopes.force_lateral),
        moment_lateral: factor * (3.0 * traction.moment_lateral + slopes.moment_lateral + sag * values[4]),
        moment_normal: factor * (4.0 * traction.moment_normal + slopes.moment_normal),
        moment_rolling: factor * (3.0 * traction.moment_rolling + slopes.moment_rolling - sag * values[5]),
        power: factor * (3.0 * traction.power + slopes.power),
        wear_integral: factor * (3.0 * traction.wear_integral + slopes.wear_integral),
    }
}
