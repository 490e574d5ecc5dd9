//! Friction of balls and rings made linear: what the implicit kick inverts.

use super::LinearTraction;
use crate::machine::Machine;
use nalgebra::{Matrix5, Matrix6, SMatrix, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::traction::TractionLaw;
use tribodyn_bearing::{BallLoads, BallState, Side};

/// Friction of one ball linearised: S is the stiffness of a patch, G and R its motion by the velocities of ball and ring;
/// ring velocities are (a, r, t) of the inner ring and of the outer, in the ball's azimuth frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Friction {
    /// (1 − ½ H A)⁻¹.
    pub(super) inverse: Matrix6<f64>,
    /// Gᵀ S R: force on the ball by ring velocities.
    pub(super) coupling: Matrix6<f64>,
    /// Rᵀ S R of both contacts: force on a ring by its own velocity.
    pub(super) own: Matrix6<f64>,
    /// Change of the ball's velocities with the rings', (1 − ½ H A)⁻¹ ½ H M⁻¹ Gᵀ S R.
    pub(super) follow: Matrix6<f64>,
}

impl Friction {
    pub(super) const NONE: fn() -> Self = || Self {
        inverse: Matrix6::identity(),
        coupling: Matrix6::zeros(),
        own: Matrix6::zeros(),
        follow: Matrix6::zeros(),
    };
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
    let (mut coupling, mut own) = (Matrix6::zeros(), Matrix6::zeros());
    for (k, (side, contact)) in [(Side::Inner, &loads.inner), (Side::Outer, &loads.outer)].into_iter().enumerate() {
        let stiffness = if contact.load > 0.0 { contacts[k].stiffness() } else { Matrix5::zeros() };
        let (by_ball, by_ring) = patch_motion(contact.pose.normal(side), r);
        let force = stiffness * by_ball;
        jacobian += by_ball.tr_mul(&force);
        coupling.fixed_view_mut::<6, 3>(0, 3 * k).copy_from(&force.tr_mul(&by_ring));
        own.fixed_view_mut::<3, 3>(3 * k, 3 * k).copy_from(&by_ring.tr_mul(&(stiffness * by_ring)));
    }
    let (m, j) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
    let mobility = Vector6::new(1.0 / m, 1.0 / m, 1.0 / (m * r * r), 1.0 / j, 1.0 / j, 1.0 / j);
    let mut a = Matrix6::from_diagonal(&mobility) * jacobian;
    // The gyroscopic moment, ω_m (Ω_t e_r − Ω_r e_t).
    a[(4, 5)] += state.orbital_speed;
    a[(4, 2)] += state.spin[2];
    a[(5, 4)] -= state.orbital_speed;
    a[(5, 2)] -= state.spin[1];
    // Friction only ever damps; a matrix that cannot be inverted is not one of friction.
    let inverse = (Matrix6::identity() - a * (0.5 * h)).try_inverse().unwrap_or_else(Matrix6::identity);
    let follow = inverse * Matrix6::from_diagonal(&mobility) * coupling * (0.5 * h);
    Friction { inverse, coupling, own, follow }
}

/// Motion of a patch (rolling, lateral, spin, about lateral, about rolling) by the six velocities of the ball and by the
/// translation (a, r, t) of the ring.
pub(super) fn patch_motion([n_a, n_r]: [f64; 2], r: f64) -> (SMatrix<f64, 5, 6>, SMatrix<f64, 5, 3>) {
    #[rustfmt::skip]
    let by_ball = SMatrix::<f64, 5, 6>::from_row_slice(&[
        0.0, 0.0, r, 0.0, 0.0, 0.0,
        n_r, -n_a, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, n_a, n_r, 0.0,
        0.0, 0.0, 0.0, n_r, -n_a, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    ]);
    #[rustfmt::skip]
    let by_ring = SMatrix::<f64, 5, 3>::from_row_slice(&[
        0.0, 0.0, -1.0,
        -n_r, n_a, 0.0,
        0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    ]);
    (by_ball, by_ring)
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
