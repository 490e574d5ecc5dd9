//! The linearised orbit: unknowns of a ball at the points of the mesh, with cage speed and ring as those of the whole
//! turn.

use crate::OrbitError;
use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::{BORDER, STACK};
use crate::system::BALL;
use tribodyn_bearing::RingFreedom;
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

/// Slopes of all intervals, and of the residuals of cage and ring by their own motion.
type OfOrbit = (Vec<Slopes>, [[f64; BORDER]; BORDER]);

impl Newton<'_> {
    /// The linearised orbit by which a search goes on. A ring that no ball resists stays as it is, or goes towards its
    /// load: one that floats between balls without touching any has no place of its own, and balls that a fluid or the
    /// cage drives have an orbit all the same.
    pub fn linearise(&mut self, orbit: &Orbit) -> Result<Linear, OrbitError> {
        let (slopes, mut direct) = self.of_orbit(orbit);
        for (k, freedom) in self.system.ring.iter().enumerate() {
            let row = 1 + k;
            let resisted = || slopes.iter().any(|slopes| slopes.rows.row(row).iter().any(|slope| *slope != 0.0));
            if matches!(freedom, RingFreedom::Loaded(_)) && !resisted() {
                direct[row][row] = -1.0;
            }
        }
        Linear::new(slopes, &direct).map_err(|_| OrbitError::Singular)
    }

    /// The same as it is.
    ///
    /// # Errors
    /// [`OrbitError::Singular`], also where the ring floats.
    pub fn linearise_exactly(&mut self, orbit: &Orbit) -> Result<Linear, OrbitError> {
        let (slopes, direct) = self.of_orbit(orbit);
        Linear::new(slopes, &direct).map_err(|_| OrbitError::Singular)
    }

    fn of_orbit(&mut self, orbit: &Orbit) -> OfOrbit {
        self.statistics.jacobians += 1;
        let mut direct = self.border_slopes(orbit);
        let slopes = (0..orbit.intervals()).map(|j| self.slopes(orbit, j, &mut direct)).collect();
        (slopes, direct)
    }
}
