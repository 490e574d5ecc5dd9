//! Friction of balls and rings made linear: what the implicit kick inverts.

use super::LinearTraction;
use crate::machine::Machine;
use nalgebra::{Matrix3, Matrix5, Matrix6, Vector3, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::traction::TractionLaw;
use tribodyn_bearing::{BallLoads, BallState, Side};

/// Friction of one ball linearised: S is the stiffness of a patch, G its motion by the velocities of the ball. Rings move
/// it by their translation (a, r, t) in the ball's azimuth frame as the ball would the other way: R = −G T, with T the first
/// three columns of 1, the third over the radius of the orbit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Friction {
    /// (1 − ½ H A)⁻¹.
    pub(super) inverse: Matrix6<f64>,
    /// Gᵀ S R: force on the ball by ring velocities, those of the inner ring first.
    pub(super) coupling: Matrix6<f64>,
    /// Rᵀ S R of the contacts: force on a ring by its own velocity.
    pub(super) own: [Matrix3<f64>; 2],
    /// Change of the ball's velocities with the rings', (1 − ½ H A)⁻¹ ½ H M⁻¹ Gᵀ S R.
    pub(super) follow: Matrix6<f64>,
}

impl Friction {
    pub(super) const NONE: fn() -> Self = || Self {
        inverse: Matrix6::identity(),
        coupling: Matrix6::zeros(),
        own: [Matrix3::zeros(); 2],
        follow: Matrix6::zeros(),
    };

    /// Force on the rings by their own velocities.
    pub(super) fn on_rings(&self, v: &Vector6<f64>) -> Vector6<f64> {
        let inner = self.own[0] * Vector3::new(v[0], v[1], v[2]);
        let outer = self.own[1] * Vector3::new(v[3], v[4], v[5]);
        Vector6::new(inner[0], inner[1], inner[2], outer[0], outer[1], outer[2])
    }
}

/// The friction of a ball, linearised for a step of `h`.
pub(super) fn friction<L: TractionLaw>(
    machine: &Machine<L>,
    state: &BallState,
    loads: &BallLoads,
    contacts: &[LinearTraction; 2],
    r: f64,
    h: f64,
) -> Friction {
    let mut jacobian = Matrix6::zeros();
    let (mut coupling, mut own) = (Matrix6::zeros(), [Matrix3::zeros(); 2]);
    for (k, (side, contact)) in [(Side::Inner, &loads.inner), (Side::Outer, &loads.outer)].into_iter().enumerate() {
        if contact.load <= 0.0 {
            continue;
        }
        let by_ball = by_velocities(&contacts[k].stiffness(), contact.pose.normal(side), r);
        jacobian += by_ball;
        let over = [1.0, 1.0, 1.0 / r];
        for column in 0..3 {
            for row in 0..6 {
                coupling[(row, 3 * k + column)] = -by_ball[(row, column)] * over[column];
            }
            for row in 0..3 {
                own[k][(row, column)] = by_ball[(row, column)] * over[row] * over[column];
            }
        }
    }
    let (m, j) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
    let mobility = [1.0 / m, 1.0 / m, 1.0 / (m * r * r), 1.0 / j, 1.0 / j, 1.0 / j];
    let mut a = Matrix6::from_fn(|row, column| mobility[row] * jacobian[(row, column)]);
    // The gyroscopic moment, ω_m (Ω_t e_r − Ω_r e_t).
    a[(4, 5)] += state.orbital_speed;
    a[(4, 2)] += state.spin[2];
    a[(5, 4)] -= state.orbital_speed;
    a[(5, 2)] -= state.spin[1];
    let inverse = inverse_of_damped(Matrix6::identity() - a * (0.5 * h));
    let follow = inverse * Matrix6::from_fn(|row, column| 0.5 * h * mobility[row] * coupling[(row, column)]);
    Friction { inverse, coupling, own, follow }
}

/// Gᵀ S G, with G the motion of a patch (rolling, lateral, spin, about lateral, about rolling) by the six velocities of the
/// ball: axial, radial, orbital, and the spin's three.
fn by_velocities(stiffness: &Matrix5<f64>, [n_a, n_r]: [f64; 2], r: f64) -> Matrix6<f64> {
    let of = |f: [f64; 5]| [n_r * f[1], -n_a * f[1], r * f[0], n_a * f[2] + n_r * f[3], n_r * f[2] - n_a * f[3], f[4]];
    let rows: [[f64; 6]; 5] = std::array::from_fn(|row| of(std::array::from_fn(|column| stiffness[(row, column)])));
    let columns: [[f64; 6]; 6] = std::array::from_fn(|column| of(rows.map(|row| row[column])));
    Matrix6::from(columns)
}

/// Inverse by Gauss and Jordan without a search for pivots: 1 − ½ H A is M⁻¹ times a matrix whose symmetric part is
/// positive, since friction only ever damps, and such matrices need none.
fn inverse_of_damped(m: Matrix6<f64>) -> Matrix6<f64> {
    // By columns, which is the order in memory; the inverse of the transpose is the transpose of the inverse.
    let mut m: [[f64; 6]; 6] = m.into();
    for pivot in 0..6 {
        let inverse = 1.0 / m[pivot][pivot];
        m[pivot][pivot] = 1.0;
        m[pivot].iter_mut().for_each(|x| *x *= inverse);
        let row = m[pivot];
        for (_, other) in m.iter_mut().enumerate().filter(|(k, _)| *k != pivot) {
            let factor = std::mem::replace(&mut other[pivot], 0.0);
            other.iter_mut().zip(row).for_each(|(x, r)| *x -= factor * r);
        }
    }
    Matrix6::from(m)
}

/// Inverse of a matrix in which an infinite diagonal element stands for an axis that is held.
pub(super) fn inverse_with_held(mut sum: Matrix5<f64>) -> Matrix5<f64> {
    let held: Vec<usize> = (0..5).filter(|&k| sum[(k, k)].is_infinite()).collect();
    held.iter().for_each(|&k| sum[(k, k)] = 1.0);
    let mut inverse = sum.try_inverse().unwrap_or_else(Matrix5::zeros);
    held.iter().for_each(|&k| inverse[(k, k)] = 0.0);
    inverse
}

/// (a, r, t) of inner and outer ring as (x, y, z) and (x, y).
pub(super) fn in_inertial_axes([sin, cos]: [f64; 2], v: &Vector6<f64>) -> Vector5<f64> {
    Vector5::new(
        v[1] * cos - v[2] * sin,
        v[1] * sin + v[2] * cos,
        v[0],
        v[4] * cos - v[5] * sin,
        v[4] * sin + v[5] * cos,
    )
}

/// The other way round.
pub(super) fn ring_in_ball_axes([sin, cos]: [f64; 2], v: &Vector5<f64>) -> Vector6<f64> {
    Vector6::new(
        v[2],
        v[0] * cos + v[1] * sin,
        v[1] * cos - v[0] * sin,
        0.0,
        v[3] * cos + v[4] * sin,
        v[4] * cos - v[3] * sin,
    )
}
