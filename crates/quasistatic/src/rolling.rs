//! States from which others go on: the rolling start of the steady orbit, and the equations at a solution.

use crate::Model;
use crate::at_rest::is_at_rest;
use crate::block::{BlockState, RING};
use crate::jones_harris::{JonesHarris, Typical};
use crate::needs;
use crate::problem::QuasiStaticError;
use crate::solve::{Rolling, SCOUT, choose_quadrature, patch_error, rolling_state, traction_system};
use crate::start::{BallMotion, WarmStart};
use crate::with_traction::WithTraction;
use tribodyn_bearing::{Bearing, OperatingPoint, Races};
use tribodyn_traction::PatchRule;

/// A rolling state of balls and ring, for solvers that go on with equations of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct RollingStart {
    /// Position and motion of each ball.
    pub balls: Vec<BallMotion>,
    /// Load of each ball on the inner race, N.
    pub inner_loads: Vec<f64>,
    /// Displacement x, y, z (m) and tilt about X and Y (rad) of the inner ring.
    pub ring: [f64; RING],
    /// The patch rule of the operating point, by its target error at this state where it is not named.
    pub rule: PatchRule,
    /// Estimated error of the rule's traction over the load, against a finer rule.
    pub rule_error: f64,
    /// Largest relative residual of the state's balances.
    pub residual: f64,
}

/// The state of Jones–Harris, or the elastic one where raceway control has no solution. It always exists and needs no
/// traction.
///
/// # Errors
/// [`QuasiStaticError::Missing`] names what the traction model needs and is not there, [`QuasiStaticError::Traction`]
/// a patch rule that cannot be laid out.
pub fn rolling_start(bearing: &Bearing, point: &OperatingPoint) -> Result<RollingStart, QuasiStaticError> {
    needs::check(bearing, point, Model::Traction)?;
    let Rolling { system, elastic, solved } = rolling_state(bearing, point, false);
    let mut traction = traction_system(bearing, point, system.typical, SCOUT)?;
    // At rest there is no other guess.
    let rolling = if is_at_rest(point) { solved? } else { solved.unwrap_or(elastic) };
    let (residual, state) = (rolling.worst().residual, rolling.state);
    let chosen = choose_quadrature(&mut traction, &state, point)?;
    let rule = traction.kernel.quadrature().rule();
    let rule_error = match chosen {
        Some(error) => error,
        None => patch_error(&traction, &state)?,
    };
    let load = |(index, &ball)| traction.evaluate(index, ball, state.ring).1.contacts.inner.normal.load;
    let inner_loads = state.balls.iter().enumerate().map(load).collect();
    let warm = WarmStart { state, rule, speeds: system.speeds };
    Ok(RollingStart { balls: warm.balls().collect(), inner_loads, ring: warm.ring(), rule, rule_error, residual })
}

/// The Jones–Harris equations with their solution.
pub(crate) fn rolling_system<'a>(
    bearing: &'a Bearing,
    point: &OperatingPoint,
) -> Result<(JonesHarris<'a>, BlockState), QuasiStaticError> {
    needs::check(bearing, point, Model::JonesHarris)?;
    let Rolling { system, solved, .. } = rolling_state(bearing, point, true);
    Ok((system, solved?.state))
}

/// The equations with traction of a solution.
pub(crate) fn traction_of<'a>(
    bearing: &'a Bearing,
    point: &OperatingPoint,
    at: &WarmStart,
) -> Result<WithTraction<'a>, QuasiStaticError> {
    needs::check(bearing, point, Model::Traction)?;
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    traction_system(bearing, point, Typical::new(bearing, &point.ring, speeds), at.rule)
}
