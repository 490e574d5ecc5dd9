//! The orbit from that of balls which more thrust presses on both races, as it is taken off again: balls that skid
//! under the load of the case roll under more, and what they come to is followed from there.

use crate::attempt::{Problem, fitted, found, hurried, resent, rolled, warm};
use crate::homotopy::Regularization;
use crate::search::{SETTLING, holds, soon};
use crate::solved::{OrbitStart, SolvedOrbit};
use crate::start::centrifugal_force;
use tribodyn_bearing::RingFreedom;

/// Thrust at first over the centrifugal forces and the pressing loads of all balls. Under more of it fewer balls skid,
/// under less of it the way is shorter.
const FIRST: [f64; 2] = [2.0, 0.2];
/// Load over the square of a ball's diameter that presses it, Pa: some 0.6 GPa between steel ball and groove.
const PRESSING: f64 = 1e5;
/// Thrust over the first one down to which it falls by equal ratios where the case has less.
const LAST: f64 = 1e-4;
/// Step at first, of the way from more thrust to that of the case.
const STEP: f64 = 0.25;
/// By how much steps grow and shrink.
const GROWS: f64 = 1.5;
const SHRINKS: f64 = 0.3;
/// Shortest step, in the logarithm of the thrust, and the most steps that are tried. Shorter ones, down to 0.02 with
/// swinging balls damped too, led to the end for none of six bearings that skid.
const SHORTEST: f64 = 0.15;
const TRIES: usize = 25;
/// Intervals of the turns of a step that are sent round from near by.
const WORK: usize = 1500;

/// The orbit of a bearing as thrust is taken off it that is more than its own; none where its thrust is not given.
pub(crate) fn relieved(problem: Problem<'_>) -> Option<SolvedOrbit> {
    let RingFreedom::Loaded(thrust) = problem.point.ring[2] else { return None };
    problem.point.watch.stage("more thrust, which is taken off again", None);
    let unit = pressing(problem);
    FIRST.iter().find_map(|first| from_thrust(problem, thrust, first * unit))
}

/// Thrust that presses all balls, N.
fn pressing(Problem { bearing, point, .. }: Problem<'_>) -> f64 {
    let g = &bearing.geometry;
    let speed = 0.5 * (point.inner_speed + point.outer_speed);
    g.ball_count as f64 * (centrifugal_force(bearing, speed) + PRESSING * g.ball_diameter.powi(2))
}

/// The orbit from that under `first` N more thrust than the case's.
fn from_thrust(problem: Problem<'_>, thrust: f64, first: f64) -> Option<SolvedOrbit> {
    let Problem { bearing, point, .. } = problem;
    let least = thrust.abs().max(LAST * first);
    let way = (1.0 + first / least).ln();
    // The whole thrust by equal ratios, and no more than the case's at the end.
    let with_more = |left: f64| {
        let more = least * left.exp_m1();
        let mut point = point.clone();
        point.ring[2] = RingFreedom::Loaded(thrust + if thrust < 0.0 { -more } else { more });
        point
    };
    let heavy = &with_more(way);
    let mut solved = rolled(Problem { point: heavy, ..problem }, bearing, soon).ok()?;
    // Balls made heavier in proportion to that thrust would be too heavy for the case's.
    if solved.start.as_ref()?.regularization != Regularization::NONE {
        return None;
    }
    let (mut left, mut step) = (way, STEP * way);
    for _ in 0..TRIES {
        let next = (left - step).max(0.0);
        let lighter = &with_more(next);
        if let Some(near) = stepped(Problem { point: lighter, ..problem }, solved.start.as_ref()?) {
            (solved, left) = (near, next);
            step *= GROWS;
        } else {
            step = SHRINKS * step.min(left);
        }
        if left == 0.0 {
            return is_kept(problem, solved.start.as_ref()?).then_some(solved);
        }
        if step < SHORTEST || point.watch.stops() {
            break;
        }
    }
    None
}

/// The orbit at a step from the last.
pub(crate) fn stepped(problem: Problem<'_>, near: &OrbitStart) -> Option<SolvedOrbit> {
    let soon = hurried(problem, near, fitted).ok().flatten();
    soon.or_else(|| resent(problem, near)).or_else(|| warm(problem, near, (&SETTLING[..1], WORK)))
}

/// True if a ball that is sent round keeps to the orbit.
pub(crate) fn is_kept(problem: Problem<'_>, solved: &OrbitStart) -> bool {
    let bearing = &solved.regularization.of(problem.bearing);
    found(Problem { bearing, ..problem }, solved).is_ok_and(|mut newton| {
        let residual = newton.residual(&solved.orbit);
        holds(&mut newton, &(solved.orbit.clone(), residual), problem.settings)
    })
}
