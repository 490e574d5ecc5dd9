//! States of rings and balls.
//!
//! Vectors are [a, r, t]: axial, radial, along the orbit. Forces and moments are those on the ball.

use crate::frame::AzimuthFrame;
use tribodyn_contact::Scalar;

/// Position and motion of a ring against the inertial frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingState<D = f64> {
    /// Displacement x, y, z, m.
    pub displacement: [D; 3],
    /// Small tilt about X and Y, rad.
    pub tilt: [D; 2],
    /// Velocity x, y, z, m/s.
    pub velocity: [D; 3],
    /// Rotational speed about Z, rad/s.
    pub speed: D,
}

impl<D: Scalar> RingState<D> {
    /// At rest in the centre, turning at `speed` in rad/s.
    pub fn centred(speed: D) -> Self {
        let z = D::zero();
        Self { displacement: [z; 3], tilt: [z; 2], velocity: [z; 3], speed }
    }
}

/// Balls, cage and inner ring in motion at one instant: the outer ring in the centre, pocket 0 at azimuth 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Azimuth (rad) and motion of each ball, in the order of their pockets.
    pub balls: Vec<(f64, BallState)>,
    /// Cage speed, rad/s.
    pub cage_speed: f64,
    /// Displacement x, y, z (m) and tilts (rad) of the inner ring.
    pub ring: [f64; 5],
}

/// Position and motion of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallState<D = f64> {
    /// Axes at the ball's azimuth φ.
    pub frame: AzimuthFrame<D>,
    /// Ball centre against the outer groove centre: axial X1 and radial X2, m.
    pub position: [D; 2],
    /// Axial and radial velocity of the ball centre, m/s.
    pub velocity: [D; 2],
    /// Orbital speed ω_m, rad/s.
    pub orbital_speed: D,
    /// Absolute angular velocity Ω, rad/s.
    pub spin: [D; 3],
}
