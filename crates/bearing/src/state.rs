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
    /// Small tilt about X and Y, rad; of a ring that is free to tilt the sines of both.
    pub tilt: [D; 2],
    /// Velocity x, y, z, m/s.
    pub velocity: [D; 3],
    /// Rotational speed about Z, of a ring that is free to tilt about its own axis, rad/s.
    pub speed: D,
    /// Angular velocity x, y, z across its axis of a ring that is free to tilt, rad/s; none where tilts are held. The
    /// contacts of a free one are those of a rigid body turned by its tilts, not to first order in them.
    pub turning: Option<[D; 3]>,
}

impl<D: Scalar> RingState<D> {
    /// At rest in the centre, turning at `speed` in rad/s.
    pub fn centred(speed: D) -> Self {
        let z = D::zero();
        Self { displacement: [z; 3], tilt: [z; 2], velocity: [z; 3], speed, turning: None }
    }

    /// The same ring with its tilts held.
    #[inline(always)]
    pub fn held(self) -> Self {
        Self { turning: None, ..self }
    }

    /// Direction x, y, z of its axis: sin θ_y, −sin θ_x and what is left of one.
    #[inline(always)]
    pub fn axis(&self) -> [D; 3] {
        let [x, y] = self.tilt;
        [y, -x, (-(x * x) - y * y + 1.0).sqrt()]
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

/// How large a ball is, against the balls of the drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallSize {
    /// Radius over that of the drawing, m.
    pub excess: f64,
    /// Mass as a multiple of that of the drawing: as the cubes of the diameters.
    pub mass: f64,
    /// Moment of inertia as a multiple: as their fifth powers.
    pub inertia: f64,
}

impl BallSize {
    /// A ball as the drawing has it.
    pub const NOMINAL: Self = Self { excess: 0.0, mass: 1.0, inertia: 1.0 };

    /// A ball of the same density with a diameter that is `excess` over the nominal one, m.
    pub fn new(excess: f64, nominal: f64) -> Self {
        let ratio = 1.0 + excess / nominal;
        Self { excess: 0.5 * excess, mass: ratio.powi(3), inertia: ratio.powi(5) }
    }
}

/// Position and motion of a ball, and its size.
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
    pub angular_velocity: [D; 3],
    /// Its size.
    pub size: BallSize,
}
