//! The offset of a ring against the ball: how it is counted, and the angle that it makes.

use tribodyn_contact::Scalar;

/// How the offset of a ring's axis enters the distance of a ball from its groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingOffset {
    /// Along the radius of the ball alone, as in Jones's equations and the programs built on them: energy and angular
    /// momentum hold, linear momentum to first order in the offset over the radius.
    FirstOrder,
    /// By the distance of the ball from the ring's own axis, and with the climb of a tilted groove along the orbit:
    /// linear momentum holds too, and so does energy where a ring is tilted. Transient runs take it.
    Exact,
}

/// The direction from a ring's axis to a ball against the radius of the ball's orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lean<D = f64> {
    /// Sine of the angle between them, positive where the ring's axis lies ahead of the ball.
    pub sin: D,
    /// Cosine of it.
    pub cos: D,
    /// One over the distance of the ball centre from the ring's axis, 1/m.
    pub curvature: D,
    /// Growth of that distance by the offset along the orbit, m.
    pub farther: D,
    /// Axial climb of the groove of a tilted ring along the orbit, over the way.
    pub climb: D,
}

impl<D: Scalar> Lean<D> {
    /// (radial, tangential) components in the ball's azimuth frame as components along and across the direction from
    /// the ring's axis.
    #[inline(always)]
    pub(crate) fn turn(&self, [r, t]: [D; 2]) -> [D; 2] {
        [r * self.cos - t * self.sin, t * self.cos + r * self.sin]
    }
}
