//! Stiffness of the inner ring at an equilibrium: how the balls' forces on it grow with its displacement while they
//! stay in balance. It is the Schur complement of Newton's Jacobian, so that it is exact.

use crate::at_rest::{AtRest, Moments, is_at_rest};
use crate::block::RING;
use crate::condensed::{StiffnessMatrix, condensed};
use crate::jones_harris::Typical;
use crate::problem::QuasiStaticError;
use crate::rolling::{rolling_system, traction_of};
use crate::start::WarmStart;
use tribodyn_bearing::{Bearing, OperatingPoint, Races};

/// Stiffness at an equilibrium with traction. It is symmetric only without friction.
///
/// # Errors
/// [`QuasiStaticError::Singular`] names a ball that has no unique answer to a displacement.
pub fn traction_stiffness(
    bearing: &Bearing,
    point: &OperatingPoint,
    at: &WarmStart,
) -> Result<StiffnessMatrix, QuasiStaticError> {
    if is_at_rest(point) {
        return stiffness_at_rest(bearing, point, (at.state.ring, Moments::AboutRing));
    }
    condensed(&traction_of(bearing, point, at)?, &at.state)
}

/// Stiffness at the Jones–Harris equilibrium of an operating point.
///
/// # Errors
/// As [`crate::solve()`], and [`QuasiStaticError::Singular`].
pub fn jones_harris_stiffness(bearing: &Bearing, point: &OperatingPoint) -> Result<StiffnessMatrix, QuasiStaticError> {
    let (system, state) = rolling_system(bearing, point)?;
    if is_at_rest(point) {
        return stiffness_at_rest(bearing, point, (state.ring, Moments::OfPotential));
    }
    condensed(&system, &state)
}

/// At rest the balls follow from the ring: those that carry nothing have no part in it.
fn stiffness_at_rest(
    bearing: &Bearing,
    point: &OperatingPoint,
    (ring, moments): ([f64; RING], Moments),
) -> Result<StiffnessMatrix, QuasiStaticError> {
    let typical = Typical::new(bearing, &point.ring, Races { inner: 0.0, outer: 0.0 });
    condensed(&AtRest::of(bearing, point, (typical, moments)).with_actual_constants(), &AtRest::state(ring))
}
