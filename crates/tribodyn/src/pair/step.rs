//! The step of Newton's method for the shaft.

use super::{Evaluated, FREEDOMS, Matrix, Pair, Vector, times};
use tribodyn_bearing::RingFreedom;
use tribodyn_quasistatic::compliance;

/// Stiffness over the largest that is given to displacements without resistance.
const NUDGE: f64 = 1e-9;

impl Pair<'_> {
    /// The step of Newton's method; where some displacement meets no resistance, with a little of it.
    pub(super) fn step(&self, now: &Evaluated) -> Option<Vector> {
        let steadied = || {
            let mut matrix = self.constrained(now);
            let stiffest = (0..3).fold(0.0, |most: f64, k| most.max(now.stiffness[k][k]));
            let lever = 0.5 * (self.distance + self.bearing.geometry.pitch_diameter);
            for (k, freedom) in self.point.ring.iter().enumerate() {
                let arm = if k < 3 { 1.0 } else { lever };
                let added = if matches!(freedom, RingFreedom::Loaded(_)) { NUDGE * stiffest * arm * arm } else { 0.0 };
                matrix[k][k] += added;
            }
            compliance(&matrix)
        };
        let inverse = self.inverse(now).or_else(steadied)?;
        Some(times(&inverse, &now.lacking))
    }

    pub(super) fn inverse(&self, now: &Evaluated) -> Option<Matrix> {
        compliance(&self.constrained(now))
    }

    /// The stiffness with the freedoms that are held.
    fn constrained(&self, now: &Evaluated) -> Matrix {
        let mut matrix = now.stiffness;
        for (k, freedom) in self.point.ring.iter().enumerate() {
            if matches!(freedom, RingFreedom::Held(_)) {
                matrix[k] = [0.0; FREEDOMS];
                matrix[k][k] = 1.0;
            }
        }
        matrix
    }
}
