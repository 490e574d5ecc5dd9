//! The linearised orbit: unknowns of a ball at the points of the mesh, with cage speed and ring as those of the whole
//! turn.

use crate::collocation::Orbit;
use crate::residual::{BORDER, STACK};
use crate::system::BALL;
use std::sync::Arc;
use tribodyn_numerics::{Change, Interval, Periodic};

/// Unknowns that an interval's points follow from: its beginning, cage speed and ring.
pub(crate) const FROM: usize = BALL + BORDER;

/// Slopes of an interval's equations, over the scales.
pub(crate) type Slopes = Interval<STACK, BORDER, FROM>;
/// The linearised orbit, factorised.
pub(crate) type Linear = Periodic<BALL, STACK, BORDER, FROM>;
/// A change of all unknowns, over their scales.
pub(crate) type Step = Change<STACK, BORDER>;

/// Largest modulus of a Floquet multiplier of a ball over the turn, cage and ring held: below one, a ball that is moved
/// off its orbit comes back to it.
pub(crate) fn multiplier(linear: &Linear) -> f64 {
    linear.transfer().complex_eigenvalues().iter().map(|v| v.re.hypot(v.im)).fold(0.0, f64::max)
}

/// A factorised Jacobian with the ends of the intervals of its mesh.
#[derive(Debug, Clone)]
pub(crate) struct Jacobian {
    pub ends: Vec<f64>,
    pub linear: Arc<Linear>,
}

impl Jacobian {
    /// True if it serves an orbit: one on its mesh, or on that mesh carried along with contacts.
    pub fn serves(&self, orbit: &Orbit) -> bool {
        self.linear.intervals() == orbit.intervals()
    }

    /// True if it is of the mesh of an orbit.
    pub fn is_of(&self, orbit: &Orbit) -> bool {
        self.ends == orbit.ends
    }
}
