//! Where each unknown stands in the vector that the schemes integrate.

use tribodyn_bearing::{FREE_CAGE, Races, Side};

/// Unknowns of a ball.
pub(crate) const BALL: usize = 9;
/// Axial position X1 of the ball centre against the outer groove centres, m.
pub(crate) const AXIAL: usize = 0;
/// Radius of the orbit about the inertial axis, m.
pub(crate) const RADIUS: usize = 1;
/// Azimuth, rad.
pub(crate) const AZIMUTH: usize = 2;
/// Axial velocity, m/s; the radial velocity, the orbital speed (rad/s) and the absolute angular velocity (rad/s)
/// follow.
pub(crate) const VELOCITY: usize = 3;
/// Orbital speed, rad/s.
pub(crate) const ORBIT: usize = 5;
/// Absolute angular velocity Ω (axial, radial, tangential), rad/s.
pub(crate) const OMEGA: usize = 6;
/// Velocities of a ball, with its angular velocity.
pub(crate) const VELOCITIES: usize = BALL - VELOCITY;

/// Offsets of what comes after the balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Number of balls.
    pub balls: usize,
    /// True if the cage is free to move in all directions.
    pub free_cage: bool,
    /// True for a ring that is free to tilt.
    pub tilting: Races<bool>,
    /// Number of balls that are not round: with spalls or waves.
    pub marked: usize,
}

impl Layout {
    /// Start of a ball's unknowns.
    pub fn ball(self, index: usize) -> usize {
        BALL * index
    }

    /// Cage: angle, speed.
    pub fn cage(self) -> usize {
        BALL * self.balls
    }

    /// Inner ring: x, y, z and their velocities.
    pub fn inner(self) -> usize {
        self.cage() + 2
    }

    /// Outer ring: x, y and their velocities.
    pub fn outer(self) -> usize {
        self.inner() + 6
    }

    /// Places of the rings' translations and of their velocities: x, y, z of the inner, x, y of the outer one.
    pub fn translations(self) -> [[usize; 2]; 5] {
        let (i, o) = (self.inner(), self.outer());
        [[i, i + 3], [i + 1, i + 4], [i + 2, i + 5], [o, o + 2], [o + 1, o + 3]]
    }

    /// Velocities of inner (three) and outer ring (two).
    pub fn velocities_of_rings(self) -> [usize; 5] {
        self.translations().map(|[_, velocity]| velocity)
    }

    /// Velocities of the cage: its speed, of a free one also three of its centre of mass and two across its axis.
    pub fn velocities_of_cage(self) -> impl Iterator<Item = usize> {
        let free = self.free();
        let velocities = if free.is_empty() { free } else { free.start + 3..free.start + 8 };
        std::iter::once(self.cage() + 1).chain(velocities)
    }

    /// Velocities of cage and rings, tilting ones included.
    pub fn velocities_of_bodies(self) -> impl Iterator<Item = usize> {
        self.velocities_of_cage().chain(self.velocities_of_rings()).chain(self.velocities_of_tilts())
    }

    /// Angles turned by inner and outer ring.
    pub fn angles(self) -> usize {
        self.outer() + 4
    }

    /// Work done by drives and loads, work lost, and the sum of the magnitudes of what is put in.
    pub fn work(self) -> usize {
        self.angles() + 2
    }

    /// The unknowns of a free cage beside angle and speed.
    pub fn free(self) -> std::ops::Range<usize> {
        let start = self.work() + 3;
        start..start + if self.free_cage { FREE_CAGE } else { 0 }
    }

    /// True if a ring is free to tilt.
    pub fn any_tilts(self) -> bool {
        self.tilting.inner || self.tilting.outer
    }

    /// Tilts of a ring that is free to tilt about x and y, and its angular velocity about them.
    pub fn tilt(self, side: Side) -> std::ops::Range<usize> {
        let size = |tilting: bool| if tilting { 4 } else { 0 };
        let start = self.free().end + if side == Side::Outer { size(self.tilting.inner) } else { 0 };
        start..start + size(self.tilting[side])
    }

    /// Orientations of the balls that are not round in their azimuth frames, as quaternions.
    pub fn orientations(self) -> std::ops::Range<usize> {
        let start = self.tilt(Side::Outer).end;
        start..start + 4 * self.marked
    }

    /// True if the fast scheme presses the balls one by one: rings tilt, or balls are not round.
    pub fn one_by_one(self) -> bool {
        self.any_tilts() || self.marked > 0
    }

    /// Angular velocity of a tilting ring.
    pub fn velocities_of_tilt(self, side: Side) -> std::ops::Range<usize> {
        let tilt = self.tilt(side);
        tilt.start + tilt.len() / 2..tilt.end
    }

    /// Angular velocities of all tilting rings.
    pub fn velocities_of_tilts(self) -> impl Iterator<Item = usize> {
        Side::BOTH.into_iter().flat_map(move |side| self.velocities_of_tilt(side))
    }

    /// Number of unknowns.
    pub fn len(self) -> usize {
        self.orientations().end
    }
}
