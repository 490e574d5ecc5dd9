//! Friction of balls and rings made linear: what the implicit kick inverts.
//!
//! A step H of v' = f + A (v − v₀) + B u(t), with the rings' velocities u changing evenly by Δu, is taken as v − v₀ = H
//! R f + R₂ H B Δu with rational functions of X = H A that have one pole, W = (1 − γ X)⁻¹:
//!
//! R = γ W + (1 − γ) W²,  R₂ = (R − 1)/X = R − ½ W²,  R₃ = (R₂ − ½)/X = ½ R − γ W².
//!
//! The mean change of the velocities over the step is then H R₂ f + R₃ H B Δu, for which v − v₀ is just what the mean
//! force gives. With γ = 1 − 1/√2 these hold, R agrees with the exact (e^X − 1)/X in two terms, and 1 + X R tends to
//! zero where friction is stiff: what settles within a step has settled at its end, instead of swinging over to the
//! other side.

use crate::linear::LinearTraction;
use crate::machine::Machine;
use nalgebra::{Matrix3, Matrix5, Matrix6, SMatrix, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{AzimuthFrame, BallState, NormalLoads, Side};

/// Friction of one ball linearised: S is the stiffness of a patch, G its motion by the velocities of the ball. Rings
/// move it by their translation (a, r, t) in the ball's azimuth frame as the ball would the other way: R = −G T, with T
/// the first three columns of 1, the third over the radius of the orbit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct LinearFriction {
    /// R and R₂: change of the velocities and its mean over the step, both over H f.
    pub(super) response: [Matrix6<f64>; 2],
    /// Gᵀ S R: force on the ball by ring velocities, those of the inner ring first.
    pub(super) coupling: Matrix6<f64>,
    /// Rᵀ S R of the contacts: force on a ring by its own velocity.
    pub(super) own: [Matrix3<f64>; 2],
    /// R₂ H B and R₃ H B, B = M⁻¹ Gᵀ S R: change of the ball's velocities with the rings', and its mean.
    pub(super) follow: [Matrix6<f64>; 2],
    /// Slopes that it was made with: see [`slopes`].
    slopes: [[f64; 2]; 2],
    /// True for the inner, and the outer, contact if there was load then.
    loaded: [bool; 2],
}

/// 1 − 1/√2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

impl LinearFriction {
    pub(super) const NONE: fn() -> Self = || Self {
        response: [Matrix6::identity(); 2],
        coupling: Matrix6::zeros(),
        own: [Matrix3::zeros(); 2],
        follow: [Matrix6::zeros(); 2],
        slopes: [[0.0; 2]; 2],
        loaded: [false; 2],
    };

    /// All numbers.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let own = self.own.iter().flat_map(|m| m.iter());
        let six = self.response.iter().chain([&self.coupling]).chain(&self.follow).flat_map(|m| m.iter());
        six.chain(own).chain(self.slopes.iter().flatten()).copied()
    }

    /// True for the inner, and the outer, contact if it had load when this was made.
    pub(super) fn loaded(&self) -> [bool; 2] {
        self.loaded
    }

    /// True while the slopes of traction are still near enough to those that it was made with, for steps of `h`.
    pub(super) fn serves(&self, stiffness: &[Matrix5<f64>; 2], h: f64) -> bool {
        let now = slopes(stiffness);
        let mut pairs = now.iter().flatten().zip(self.slopes.iter().flatten());
        pairs.all(|(now, made)| (now - made).abs() <= STALE * h * made.abs())
    }

    /// Mean force of a ball on the rings over a step in which their velocities change, by that change: the ball
    /// follows.
    pub(super) fn force_on_rings(&self) -> Matrix6<f64> {
        self.coupling.tr_mul(&self.follow[1]) + self.on_rings() * 0.5
    }

    /// Force on the rings by their own velocities.
    fn on_rings(&self) -> Matrix6<f64> {
        let mut all = Matrix6::zeros();
        all.fixed_view_mut::<3, 3>(0, 0).copy_from(&self.own[0]);
        all.fixed_view_mut::<3, 3>(3, 3).copy_from(&self.own[1]);
        all
    }
}

/// Relative change of a slope beyond which the friction of a ball is linearised anew, over the step, 1/s: a fifth at
/// 20 µs. With a matrix that is off in proportion to the step the method keeps its second order.
const STALE: f64 = 1e4;

/// Slopes of traction by slip of the inner and the outer contact, along and across.
fn slopes(stiffness: &[Matrix5<f64>; 2]) -> [[f64; 2]; 2] {
    stiffness.each_ref().map(|s| [s[(0, 0)], s[(1, 1)]])
}

/// Stiffnesses of the inner and the outer contact of a ball in a step of `h`; none without load.
pub(super) fn stiffnesses(
    machine: &Machine,
    state: &BallState,
    normal: &NormalLoads,
    (contacts, h): (&[LinearTraction; 2], f64),
) -> [Matrix5<f64>; 2] {
    let (m, j) = (machine.bearing.mass_of(&state.size), machine.bearing.inertia_of(&state.size));
    let r = machine.bearing.geometry.ball_radius();
    let give = h * (1.0 / m + r * r / j);
    Side::BOTH.map(|side| {
        let loaded = normal.contacts[side].load > 0.0;
        if loaded { contacts[side as usize].stiffness(give, r, machine.is_damaged()) } else { Matrix5::zeros() }
    })
}

/// Least pivot of 1 − γ H A that the step takes as it comes. Friction that damps leaves none below one; where it falls
/// with growing slip, past its peak, slip grows, and at zero the method breaks down.
const LEAST_PIVOT: f64 = 0.7;

/// The friction of a ball, linearised for a step of `h`.
pub(super) fn linear_friction(
    machine: &Machine,
    state: &BallState,
    normal: &NormalLoads,
    (contacts, stiffness): (&[LinearTraction; 2], [Matrix5<f64>; 2]),
    h: f64,
) -> LinearFriction {
    let r = normal.orbit_radius;
    let normals = Side::BOTH.map(|side| normal.contacts[side].pose.normal(side));
    let with = |stiffness: [Matrix5<f64>; 2]| {
        let slopes: [Matrix6<f64>; 2] = std::array::from_fn(|k| by_velocities(&stiffness[k], normals[k], r));
        LinearFriction::new(machine, state, slopes, r, h)
    };
    let (mut friction, pivot) = with(stiffness);
    if pivot < LEAST_PIVOT {
        let ball = machine.bearing.geometry.ball_radius();
        let scales = |k: usize| [1.0, 1.0, contacts[k].semi_lateral(), ball, ball];
        friction = with(std::array::from_fn(|k| damping_part(&stiffness[k], scales(k)))).0;
    }
    friction.slopes = slopes(&stiffness);
    friction.loaded = Side::BOTH.map(|side| normal.contacts[side].load > 0.0);
    friction
}

impl LinearFriction {
    /// From the derivatives Gᵀ S G of the forces of both contacts by the velocities of the ball. Also returns the least
    /// pivot of 1 − γ H A.
    fn new(machine: &Machine, state: &BallState, slopes: [Matrix6<f64>; 2], r: f64, h: f64) -> (Self, f64) {
        let (mut coupling, mut own) = (Matrix6::zeros(), [Matrix3::zeros(); 2]);
        let over = [1.0, 1.0, 1.0 / r];
        for (k, by_ball) in slopes.iter().enumerate() {
            for column in 0..3 {
                for row in 0..6 {
                    coupling[(row, 3 * k + column)] = -by_ball[(row, column)] * over[column];
                }
                for row in 0..3 {
                    own[k][(row, column)] = by_ball[(row, column)] * over[row] * over[column];
                }
            }
        }
        let (m, j) = (machine.bearing.mass_of(&state.size), machine.bearing.inertia_of(&state.size));
        let mobility = [1.0 / m, 1.0 / m, 1.0 / (m * r * r), 1.0 / j, 1.0 / j, 1.0 / j];
        let mut a =
            Matrix6::from_fn(|row, column| mobility[row] * (slopes[0][(row, column)] + slopes[1][(row, column)]));
        // The gyroscopic moment, ω_m (Ω_t e_r − Ω_r e_t).
        a[(4, 5)] += state.orbital_speed;
        a[(4, 2)] += state.angular_velocity[2];
        a[(5, 4)] -= state.orbital_speed;
        a[(5, 2)] -= state.angular_velocity[1];
        let (once, pivot) = inverse_of_damped(Matrix6::identity() - a * (GAMMA * h));
        let twice = once * once;
        let change = once * GAMMA + twice * (1.0 - GAMMA);
        let mean = change - twice * 0.5;
        let by_rings = Matrix6::from_fn(|row, column| h * mobility[row] * coupling[(row, column)]);
        let follow = [mean * by_rings, (change * 0.5 - twice * GAMMA) * by_rings];
        (Self { response: [change, mean], coupling, own, follow, ..Self::NONE() }, pivot)
    }
}

/// S without what lets slip grow: the positive eigenvalues of its symmetric part, with the motion in units of slip,
/// `scale`. Any approximate A leaves the kick consistent; what is taken out here acts explicitly.
fn damping_part(stiffness: &Matrix5<f64>, scale: [f64; 5]) -> Matrix5<f64> {
    let symmetric = |i: usize, k: usize| 0.5 * (stiffness[(i, k)] + stiffness[(k, i)]) / (scale[i] * scale[k]);
    let eigen = Matrix5::from_fn(symmetric).symmetric_eigen();
    let growing = eigen.eigenvalues.map(|value| value.max(0.0));
    let growth = eigen.eigenvectors * Matrix5::from_diagonal(&growing) * eigen.eigenvectors.transpose();
    Matrix5::from_fn(|i, k| stiffness[(i, k)] - scale[i] * scale[k] * growth[(i, k)])
}

/// Gᵀ S G, with G the motion of a patch (rolling, lateral, spin, about lateral, about rolling) by the six velocities of
/// the ball: axial, radial, orbital, and the three of its angular velocity.
fn by_velocities(stiffness: &Matrix5<f64>, [n_a, n_r]: [f64; 2], r: f64) -> Matrix6<f64> {
    let of = |f: [f64; 5]| [n_r * f[1], -n_a * f[1], r * f[0], n_a * f[2] + n_r * f[3], n_r * f[2] - n_a * f[3], f[4]];
    let rows: [[f64; 6]; 5] = std::array::from_fn(|row| of(std::array::from_fn(|column| stiffness[(row, column)])));
    let columns: [[f64; 6]; 6] = std::array::from_fn(|column| of(rows.map(|row| row[column])));
    Matrix6::from(columns)
}

/// Inverse by Gauss and Jordan without a search for pivots, and the least pivot: where friction damps, 1 − γ H A is M⁻¹
/// times a matrix whose symmetric part is at least M, and its pivots are at least one.
fn inverse_of_damped(m: Matrix6<f64>) -> (Matrix6<f64>, f64) {
    // By columns, which is the order in memory; the inverse of the transpose is the transpose of the inverse.
    let mut m: [[f64; 6]; 6] = m.into();
    let mut least = f64::INFINITY;
    for pivot in 0..6 {
        least = least.min(m[pivot][pivot]);
        let inverse = 1.0 / m[pivot][pivot];
        m[pivot][pivot] = 1.0;
        m[pivot].iter_mut().for_each(|x| *x *= inverse);
        let row = m[pivot];
        for (_, other) in m.iter_mut().enumerate().filter(|(k, _)| *k != pivot) {
            let factor = std::mem::replace(&mut other[pivot], 0.0);
            other.iter_mut().zip(row).for_each(|(x, r)| *x -= factor * r);
        }
    }
    (Matrix6::from(m), least)
}

/// Inverse of a matrix in which an infinite diagonal element stands for an axis that is held.
pub(super) fn inverse_with_held<const N: usize>(mut sum: SMatrix<f64, N, N>) -> SMatrix<f64, N, N> {
    let held: Vec<usize> = (0..N).filter(|&k| sum[(k, k)].is_infinite()).collect();
    for &k in &held {
        sum.row_mut(k).fill(0.0);
        sum.column_mut(k).fill(0.0);
        sum[(k, k)] = 1.0;
    }
    let mut inverse = sum.try_inverse().unwrap_or_else(SMatrix::zeros);
    held.iter().for_each(|&k| inverse[(k, k)] = 0.0);
    inverse
}

/// (a, r, t) of inner and outer ring as (x, y, z) and (x, y).
pub(super) fn in_inertial_axes(axes: AzimuthFrame, v: &Vector6<f64>) -> Vector5<f64> {
    let inner = axes.to_inertial([v[0], v[1], v[2]]);
    let outer = axes.to_inertial([v[3], v[4], v[5]]);
    Vector5::new(inner[0], inner[1], inner[2], outer[0], outer[1])
}
