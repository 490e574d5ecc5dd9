//! A cage that is free to move in all directions: it whirls, tilts and strikes its lands.
//!
//! ```text
//! m x'' = Σ F + m g,   I ω' = Σ M − ω × I ω,   I = I_t 1 + (I_a − I_t) n nᵀ
//! ```
//!
//! x is the centre of mass, M about it, n the cage's axis. Angle and speed about Z are those of a cage that only turns;
//! its orientation is that angle about Z and after it a unit quaternion q, q' = ½ (ω q − q ω_z e_z), which stays near 1
//! while the cage tilts a little and locks nowhere.

mod land;
mod pocket;
mod slope;
#[cfg(test)]
mod tests;

pub use land::{LandFilm, LandLoad};
pub use pocket::{InPocket, PocketShape, PocketWall};
pub use slope::{Gauge, WrenchSlope};

use crate::races::Side;
use crate::vectors::{add, along, cross, dot, rotated, scaled};

/// A cage that is free to move, SI. What it shares with one that only turns (moment of inertia about its axis, gap,
/// stiffness, damping and friction of the pockets, drag) is with that one.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeCage {
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia across the axis about the centre of mass, kg m²; that about the axis is with it.
    pub transverse_inertia: f64,
    /// Distance of the centre of mass from the centre, towards the first pocket, m.
    pub unbalance: f64,
    /// Acceleration by gravity (x, y, z), m/s².
    pub gravity: [f64; 3],
    /// Displacement of the centre (x, y) at the start, m.
    pub displacement: [f64; 2],
    /// Form of the pockets.
    pub pockets: PocketShape,
    /// The lands that guide it; none where the balls alone do.
    pub lands: Vec<CageLand>,
}

/// A land of a ring about the cage, or under it, at a plane of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageLand {
    /// The ring whose land it is: the cage runs on the inner ring's, or in the outer ring's.
    pub side: Side,
    /// Plane of its middle from the plane of the pockets, m.
    pub axial: f64,
    /// Radius of the land, m.
    pub radius: f64,
    /// Width between its edges, m.
    pub width: f64,
    /// Radial gap about the centred cage, m.
    pub gap: f64,
    /// Stiffness of an edge against the cage, N/m.
    pub stiffness: f64,
    /// Damping χ of Hunt and Crossley, s/m.
    pub damping: f64,
    /// Friction coefficient.
    pub friction: f64,
    /// The fluid in the gap; a dry land has none.
    pub film: Option<LandFilm>,
}

/// Unknowns of a free cage beside angle and speed about Z: centre of mass, its velocity, angular velocity about X and
/// Y, quaternion (x, y, z, w).
pub const FREE_CAGE: usize = 12;

/// Where a free cage is and how it moves, in inertial axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CagePose {
    /// Centre of mass, m.
    pub mass_centre: [f64; 3],
    /// Centre of the circle of pockets, m.
    pub centre: [f64; 3],
    /// Velocity of the centre of mass, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity, rad/s.
    pub omega: [f64; 3],
    /// The quaternion after the angle about Z.
    pub quaternion: [f64; 4],
    /// Axes of the cage: towards its first pocket, a quarter turn ahead, along the axis.
    pub axes: [[f64; 3]; 3],
}

/// Rate of the quaternion at an angular velocity, ½ (ω q − q ω_z e_z): of what both have about Z the twofold of the
/// product is left.
pub fn quaternion_rate([w_x, w_y, w_z]: [f64; 3], [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    [
        0.5 * (w * w_x + w_y * z) - w_z * y,
        0.5 * (w * w_y - w_x * z) + w_z * x,
        0.5 * (w_x * y - w_y * x),
        -0.5 * (w_x * x + w_y * y),
    ]
}

/// Friction of a coefficient against a sliding velocity under a normal force, N, and the power that it takes, W; below
/// `creep` (m/s) it falls off in proportion, and so where it were more than `most` (N s/m) times the velocity.
fn friction(coefficient: f64, normal: f64, slip: [f64; 3], [creep, most]: [f64; 2]) -> ([f64; 3], f64) {
    let square = dot(slip, slip);
    let share = (coefficient * normal / (square + creep * creep).sqrt()).min(most);
    (scaled(slip, -share), share * square)
}

/// Force and moment about the centre of mass on a cage.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Wrench {
    /// Force, N.
    pub force: [f64; 3],
    /// Moment, N m.
    pub moment: [f64; 3],
}

impl Wrench {
    /// Adds a force that acts at a distance from the centre of mass, with a moment of its own.
    #[inline(always)]
    pub fn add_at(&mut self, arm: [f64; 3], force: [f64; 3], moment: [f64; 3]) {
        self.force = add(self.force, force);
        self.moment = add(self.moment, add(moment, cross(arm, force)));
    }
}

impl CagePose {
    /// The pose that angle and speed about Z and the other unknowns stand for.
    pub fn new(cage: &FreeCage, [angle, speed]: [f64; 2], unknowns: &[f64; FREE_CAGE]) -> Self {
        let &[x, y, z, v_x, v_y, v_z, w_x, w_y, q @ ..] = unknowns;
        let (sin, cos) = angle.sin_cos();
        let axes = [[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]].map(|axis| rotated(q, axis));
        let mass_centre = [x, y, z];
        Self {
            mass_centre,
            centre: add(mass_centre, scaled(axes[0], -cage.unbalance)),
            velocity: [v_x, v_y, v_z],
            omega: [w_x, w_y, speed],
            quaternion: q,
            axes,
        }
    }

    /// Velocity of a point of the cage, m/s.
    #[inline(always)]
    pub fn velocity_at(&self, point: [f64; 3]) -> [f64; 3] {
        add(self.velocity, cross(self.omega, along(self.mass_centre, point)))
    }

    /// Tilt of the axis about X and Y, rad.
    pub fn tilt(&self) -> [f64; 2] {
        let [x, y, z] = self.axes[2];
        [(-y).atan2(z), x.atan2(z)]
    }
}

impl FreeCage {
    /// The unknowns beside angle and speed, at angle 0 and not tilted, turning at a speed (rad/s) with the pockets in a
    /// plane (m).
    pub fn at_start(&self, speed: f64, plane: f64) -> [f64; FREE_CAGE] {
        let [x, y] = self.displacement;
        [x + self.unbalance, y, plane, 0.0, speed * self.unbalance, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]
    }

    /// Rates of the unknowns under a force and moment, and the acceleration about Z, rad/s². `inertia` is that about
    /// the axis, kg m².
    pub fn rates(&self, pose: &CagePose, wrench: &Wrench, inertia: f64) -> ([f64; FREE_CAGE], f64) {
        let (omega, n) = (pose.omega, pose.axes[2]);
        // I ω' = M − ω × I ω: the part of I that is the same in all directions has no share in the product.
        let gyroscopic = scaled(cross(omega, n), (self.transverse_inertia - inertia) * dot(omega, n));
        let moment = add(wrench.moment, gyroscopic);
        let ([a_x, a_y, a_z], turning) = self.response(pose, &Wrench { moment, ..*wrench }, inertia);
        let ([v_x, v_y, v_z], [g_x, g_y, g_z]) = (pose.velocity, self.gravity);
        let [q_x, q_y, q_z, q_w] = quaternion_rate(omega, pose.quaternion);
        let [w_x, w_y, w_z] = turning;
        ([v_x, v_y, v_z, a_x + g_x, a_y + g_y, a_z + g_z, w_x, w_y, q_x, q_y, q_z, q_w], w_z)
    }

    /// Acceleration (m/s²) and angular acceleration (rad/s²) by a force and moment alone.
    pub fn response(&self, pose: &CagePose, wrench: &Wrench, inertia: f64) -> ([f64; 3], [f64; 3]) {
        let n = pose.axes[2];
        let about_axis = dot(wrench.moment, n);
        let across = add(wrench.moment, scaled(n, -about_axis));
        let turning = add(scaled(across, 1.0 / self.transverse_inertia), scaled(n, about_axis / inertia));
        (wrench.force.map(|force| force / self.mass), turning)
    }

    /// Kinetic energy and that against gravity, J.
    pub fn energy(&self, pose: &CagePose, inertia: f64) -> f64 {
        let (v, omega) = (pose.velocity, pose.omega);
        let spin = dot(omega, pose.axes[2]);
        let turning = self.transverse_inertia * (dot(omega, omega) - spin * spin) + inertia * spin * spin;
        0.5 * (self.mass * dot(v, v) + turning) - self.mass * dot(self.gravity, pose.mass_centre)
    }

    /// Angular momentum about the origin, N m s.
    pub fn angular_momentum(&self, pose: &CagePose, inertia: f64) -> [f64; 3] {
        let n = pose.axes[2];
        let own = scaled(n, (inertia - self.transverse_inertia) * dot(pose.omega, n));
        let turning = add(scaled(pose.omega, self.transverse_inertia), own);
        add(turning, scaled(cross(pose.mass_centre, pose.velocity), self.mass))
    }
}
