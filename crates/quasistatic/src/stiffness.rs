//! Stiffness of the inner ring at an equilibrium: how the balls' forces on it grow with its displacement while they
//! stay in balance. It is the Schur complement of Newton's Jacobian, so that it is exact.

use crate::at_rest::{AtRest, Moments, is_at_rest};
use crate::block::RING;
use crate::condensed::{StiffnessMatrix, condensed};
use crate::jones_harris::Typical;
use crate::problem::QuasiStaticError;
use crate::rolling::{rolling_system, traction_of};
use crate::solution::Solution;
use crate::start::WarmStart;
use crate::warm::solve_from;
use tribodyn_bearing::{Bearing, OperatingPoint, Races, RingFreedom};

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

/// Error over √(K_ii K_jj) above which a matrix comes with a warning, and above which there is none.
const DOUBTFUL: f64 = 1e-3;
const WRONG: f64 = 1e-2;

/// True if an error over √(K_ii K_jj) is such that there is no answer.
pub fn is_wrong_stiffness(error: f64) -> bool {
    error > WRONG || error.is_nan()
}

/// Sentence on a matrix that its checks leave in doubt, with the reason.
pub fn doubtful_stiffness(error: f64, why: &str) -> Option<String> {
    (error > DOUBTFUL).then(|| format!("the stiffness is uncertain by about {:.1} %: {why}", 100.0 * error))
}

/// Steps of the differences over the largest approach of a ball and a race; the first that agrees is enough.
const STEPS: [f64; 3] = [3e-4, 3e-3, 3e-5];
/// Deviation that is taken for that of the differences.
const AGREES: f64 = 3e-4;
/// Part of the largest approach by which the ring may seem to be moved between an equilibrium and the same one held.
const SAME: f64 = 1e-5;

/// The same with an estimate of its error over √(K_ii K_jj), against differences of equilibria beside it: where a
/// contact begins or ends, or the slip turns, slopes on either side differ. No estimate at rest, and where the balls
/// come to another equilibrium with the ring held.
///
/// # Errors
/// As [`traction_stiffness`], and [`QuasiStaticError::Uncertain`].
pub fn checked_traction_stiffness(
    bearing: &Bearing,
    point: &OperatingPoint,
    (solution, at): (&Solution, &WarmStart),
) -> Result<(StiffnessMatrix, Option<f64>), QuasiStaticError> {
    let stiffness = traction_stiffness(bearing, point, at)?;
    let error = error_along(bearing, point, (solution, at), &stiffness);
    match error.filter(|error| is_wrong_stiffness(*error)) {
        Some(error) => Err(QuasiStaticError::Uncertain { error }),
        None => Ok((stiffness, error)),
    }
}

/// Deviation from differences along one direction of all freedoms.
fn error_along(
    bearing: &Bearing,
    point: &OperatingPoint,
    (solution, at): (&Solution, &WarmStart),
    stiffness: &StiffnessMatrix,
) -> Option<f64> {
    if is_at_rest(point) {
        return None;
    }
    let radius = 0.5 * bearing.geometry.pitch_diameter;
    let direction = [1.0, 0.7, -0.5, 0.6 / radius, -0.8 / radius];
    let contacts = solution.balls.iter().flat_map(|ball| [&ball.contacts.inner, &ball.contacts.outer]);
    let approach = contacts.map(|contact| contact.approach_m).fold(0.0, f64::max);
    let ([x, y, z], [tilt_x, tilt_y]) = (solution.ring_displacement_m, solution.ring_tilt_rad);
    let loads = |moved: f64| {
        let ring = [x, y, z, tilt_x, tilt_y];
        let ring = std::array::from_fn(|k| RingFreedom::Held(ring[k] + moved * direction[k]));
        let held = OperatingPoint { ring, ..point.clone() };
        solve_from(bearing, &held, at).ok().map(|solved| carried(&solved.solution))
    };
    let scale: f64 = (0..RING).map(|k| stiffness[k][k].abs().sqrt() * direction[k].abs()).sum();
    let off = |a: &[f64; RING], b: &[f64; RING]| {
        let parts = (0..RING).map(|k| (a[k] - b[k]).abs() / (stiffness[k][k].abs().sqrt() * scale));
        parts.fold(0.0, f64::max)
    };
    if off(&loads(0.0)?, &carried(solution)) > SAME * approach {
        return None;
    }
    let slope: [f64; RING] = std::array::from_fn(|i| (0..RING).map(|j| stiffness[i][j] * direction[j]).sum());
    let mut least = f64::INFINITY;
    for step in STEPS.map(|step| step * approach) {
        let Some((up, down)) = loads(step).zip(loads(-step)) else { continue };
        let difference = std::array::from_fn(|k| (up[k] - down[k]) / (2.0 * step));
        least = least.min(off(&slope, &difference));
        if least < AGREES {
            break;
        }
    }
    least.is_finite().then_some(least)
}

/// Forces, N, and moments, N m, of the inner ring.
fn carried(solution: &Solution) -> [f64; RING] {
    let ([x, y, z], [mx, my]) = (solution.ring_load_n, solution.ring_moment_nm);
    [x, y, z, mx, my]
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
