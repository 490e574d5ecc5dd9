//! The orbit linearised for Newton's method, and for its stiffness.

use crate::OrbitError;
use crate::chain::{Linear, Slopes};
use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::BORDER;
use tribodyn_bearing::RingFreedom;

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
