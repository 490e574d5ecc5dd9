//! From a bearing at an operating point to its steady orbit.

use crate::OrbitError;
use crate::attempt::{Problem, fits, fitted, found, hurried, prepared, resent, rolled, warm, worst};
use crate::damping::{LessDamping, less_damped};
use crate::detours::{damped_more, detour};
use crate::heavier::heavier;
use crate::neighbours::from_neighbours;
use crate::newton::Newton;
use crate::relief::relieved;
use crate::residual::Found;
use crate::search::{OTHER, PATIENCE, SETTLING, WORK, late, soon};
use crate::settings::OrbitSettings;
use crate::solved::{OrbitStart, SolvedOrbit};
use crate::statics::standing;
use crate::stiffness::{DOUBT, OrbitStiffness, slopes, stiffness};
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint};
use tribodyn_quasistatic::{StiffnessMatrix, check_thrust, doubtful_stiffness, rolling_start};
use tribodyn_traction::PatchRule;

/// Refuses what has no orbit to seek.
fn check(bearing: &Bearing, point: &OperatingPoint) -> Result<(), OrbitError> {
    if point.turns_as_one() {
        return Err(OrbitError::TurnsAsOne { speed_rad_s: point.inner_speed });
    }
    Ok(check_thrust(bearing, point)?)
}

/// Solves for the steady orbit from a cold start.
///
/// # Errors
/// [`OrbitError::NotConverged`] with the balance that is furthest from being met.
pub fn steady_orbit(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
) -> Result<SolvedOrbit, OrbitError> {
    check(bearing, point)?;
    let problem = Problem { bearing: &prepared(bearing, settings), point, cage, settings };
    if let Some(standing) = standing(problem.bearing, point, cage) {
        return Ok(standing);
    }
    let found = match rolled(problem, problem.bearing, soon) {
        Err(OrbitError::NotConverged { .. }) if !point.watch.stops() => {
            let found = heavier(problem).or_else(|| from_neighbours(problem)).or_else(|| relieved(problem));
            found.map_or_else(|| patiently(problem), Ok)
        }
        other => other,
    };
    // What an ended search did not reach says nothing of the bearing.
    found.map_err(|error| if point.watch.stops() { OrbitError::Ended } else { error })
}

/// The orbit where balls that roll do not soon lead to it.
fn patiently(problem: Problem<'_>) -> Result<SolvedOrbit, OrbitError> {
    match rolled(problem, problem.bearing, late) {
        Err(error @ OrbitError::NotConverged { .. }) => {
            detour(problem, &error).or_else(|| damped_more(problem)).ok_or(error)
        }
        other => other,
    }
}

/// Solves from the orbit of a neighbouring problem, on its mesh and with its patch rule, the mesh made finer where it
/// errs; from a cold start where that fails.
///
/// # Errors
/// As [`steady_orbit`].
pub fn steady_orbit_from(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    near: &OrbitStart,
) -> Result<SolvedOrbit, OrbitError> {
    check(bearing, point)?;
    let problem = Problem { bearing, point, cage, settings };
    if let Some(solved) = hurried(problem, near, fitted)? {
        return Ok(solved);
    }
    let prepared = &prepared(bearing, settings);
    let warmed = warm(Problem { bearing: prepared, ..problem }, near, (&SETTLING, WORK));
    warmed.map_or_else(|| steady_orbit(bearing, point, cage, settings), Ok)
}

/// The same where the neighbour is so near that a few steps lead to the orbit on its mesh, or a few turns of a ball
/// that starts like its own to one on a mesh of its own contacts; none where a cold start is as cheap.
///
/// # Errors
/// As [`steady_orbit`].
pub fn steady_orbit_near(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    near: &OrbitStart,
) -> Result<Option<SolvedOrbit>, OrbitError> {
    check(bearing, point)?;
    let problem = Problem { bearing, point, cage, settings };
    if let Some(solved) = hurried(problem, near, served)? {
        return Ok(Some(solved));
    }
    Ok(resent(Problem { bearing: &prepared(bearing, settings), ..problem }, near))
}

/// The patch rule that a cold start takes: by the rolling balls, where the point asks for an error instead of a rule.
///
/// # Errors
/// As [`rolling_start`].
pub fn cold_rule(bearing: &Bearing, point: &OperatingPoint, settings: &OrbitSettings) -> Result<PatchRule, OrbitError> {
    Ok(rolling_start(&prepared(bearing, settings), point)?.rule)
}

/// An orbit on a neighbour's mesh, or with some intervals halved where that errs by more than is allowed; none where it
/// errs by so much that the mesh may be made for another orbit.
fn served(newton: &mut Newton<'_>, found: Found, settings: &OrbitSettings) -> Option<Found> {
    if fits(newton, &found.0, settings) {
        return Some(found);
    }
    if worst(newton, &found.0, settings) > OTHER {
        return None;
    }
    let found = newton.halved(found, settings.mesh_error, (settings.tolerance, PATIENCE));
    newton.coarse.is_none().then_some(found)
}

/// Stiffness of the inner ring on its steady orbit, balls and cage condensed, checked on a finer mesh and against
/// orbits under slightly other loads.
///
/// # Errors
/// [`OrbitError::Singular`] where a displacement of the ring meets no resistance, [`OrbitError::Uncertain`] where the
/// checks find an error above 1 %.
pub fn orbit_stiffness(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<OrbitStiffness, OrbitError> {
    let bearing = &solved.regularization.of(&prepared(bearing, settings));
    let problem = Problem { bearing, point, cage, settings };
    let mut newton = found(problem, solved)?;
    let (stiffness, error_estimate) = stiffness(&mut newton, &solved.orbit, settings.tolerance)?;
    let warnings = solved.sentences().into_iter().chain(doubtful_stiffness(error_estimate, DOUBT)).collect();
    Ok(OrbitStiffness { stiffness, error_estimate, warnings })
}

/// The same orbit with the damping that the case gives its pockets, for what the raised damping of the search changes;
/// none where it changes nothing, or no orbit is found with less. It takes some times as long as the orbit itself.
///
/// # Errors
/// [`OrbitError::Traction`].
pub fn less_damped_orbit(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<Option<LessDamping>, OrbitError> {
    let bearing = &solved.regularization.of(&prepared(bearing, settings));
    let problem = Problem { bearing, point, cage, settings };
    let mut newton = found(problem, solved)?;
    let residual = newton.residual(&solved.orbit);
    less_damped(&mut newton, (solved.orbit.clone(), residual), (cage.pocket.damping, settings))
}

/// The same on the mesh of the orbit and unchecked: slopes for Newton's method on a system that the bearing is part of,
/// whose balances tell whether they were right.
///
/// # Errors
/// [`OrbitError::Singular`].
pub fn orbit_slopes(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<StiffnessMatrix, OrbitError> {
    let bearing = &solved.regularization.of(&prepared(bearing, settings));
    slopes(&mut found(Problem { bearing, point, cage, settings }, solved)?, &solved.orbit)
}
