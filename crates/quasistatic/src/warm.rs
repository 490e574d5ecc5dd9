//! From the solution of a neighbouring problem to the equilibrium.

use crate::at_rest::is_at_rest;
use crate::block::SolverStatistics;
use crate::jones_harris::Typical;
use crate::problem::QuasiStaticError;
use crate::solve::{Solved, choose_quadrature, finish, solve, traction_system};
use crate::start::WarmStart;
use crate::with_traction::WithTraction;
use crate::{Model, needs};
use tribodyn_bearing::{Bearing, OperatingPoint, Races};
use tribodyn_traction::PatchChoice;

/// Solves the traction model from the solution of a neighbouring problem, with its patch rule.
///
/// # Errors
/// As [`solve`](crate::solve()).
pub fn solve_from(bearing: &Bearing, point: &OperatingPoint, start: &WarmStart) -> Result<Solved, QuasiStaticError> {
    if is_at_rest(point) {
        let rule = Some(PatchChoice::Named(start.rule));
        return solve(bearing, &OperatingPoint { patch: rule, ..point.clone() }, Model::Traction);
    }
    near(bearing, point, start).map(|(_, solved)| solved)
}

/// Solves the traction model from the solution of a neighbouring problem; where its patch rule errs by more than the
/// problem allows, with a rule chosen at what it leads to.
///
/// # Errors
/// As [`solve`](crate::solve()).
pub fn solve_near(bearing: &Bearing, point: &OperatingPoint, start: &WarmStart) -> Result<Solved, QuasiStaticError> {
    if is_at_rest(point) {
        return solve(bearing, point, Model::Traction);
    }
    let (mut traction, solved) = near(bearing, point, start)?;
    let allowed = point.patch.is_none_or(|patch| patch.allows(solved.solution.patch_error_estimate));
    let Some(WarmStart { state, .. }) = solved.warm_start.as_ref().filter(|_| !allowed && bearing.elastic.is_none())
    else {
        return Ok(solved);
    };
    let estimate = choose_quadrature(&mut traction, state, point)?;
    finish(&traction, [state.clone(), state.clone()], point, solved.statistics, estimate)
}

fn near<'a>(
    bearing: &'a Bearing,
    point: &OperatingPoint,
    start: &WarmStart,
) -> Result<(WithTraction<'a>, Solved), QuasiStaticError> {
    needs::check(bearing, point, Model::Traction)?;
    let typical = Typical::new(bearing, &point.ring, Races { inner: point.inner_speed, outer: point.outer_speed });
    let traction = traction_system(bearing, point, typical, start.rule)?;
    let start = start.at_speeds(traction.speeds);
    let solved = finish(&traction, [start.clone(), start], point, SolverStatistics::default(), None)?;
    Ok((traction, solved))
}
