//! Stiffness of the inner ring on its steady orbit: how the mean forces of the balls on it grow with its displacement
//! while balls and cage keep to their equations. Newton's Jacobian with all else eliminated, so that it is exact.

use crate::OrbitError;
use crate::collocation::Orbit;
use crate::means::Means;
use crate::newton::Newton;
use crate::residual::{BORDER, Residual, STACK, Worst};
use crate::system::RING;
use nalgebra::SMatrix;
use tribodyn_bearing::RingFreedom;
use tribodyn_quasistatic::StiffnessMatrix;

/// Stiffness at a converged orbit. The ring is given unit loads, one after the other, however it is held.
///
/// # Errors
/// [`OrbitError::Singular`] where a displacement of the ring meets no resistance.
pub(crate) fn stiffness(newton: &mut Newton<'_>, orbit: &Orbit) -> Result<StiffnessMatrix, OrbitError> {
    let held = std::mem::replace(&mut newton.system.ring, [RingFreedom::Loaded(0.0); RING]);
    let linear = newton.linearise(orbit);
    newton.system.ring = held;
    let linear = linear?;
    let scales = newton.scales;
    let mut compliance = SMatrix::<f64, RING, RING>::zeros();
    for load in 0..RING {
        let mut border = [0.0; BORDER];
        border[1 + load] = 1.0 / scales.border_rows[1 + load];
        let unit = Residual {
            intervals: vec![[0.0; STACK]; orbit.intervals()],
            border,
            worst: Worst::NONE,
            means: Means::default(),
        };
        let step = linear.step(&unit);
        (0..RING).for_each(|k| compliance[(k, load)] = step.border[1 + k] * scales.border[1 + k]);
    }
    let stiffness = compliance.try_inverse().ok_or(OrbitError::Singular)?;
    if stiffness.iter().all(|k| k.is_finite()) { Ok(stiffness.transpose().into()) } else { Err(OrbitError::Singular) }
}
