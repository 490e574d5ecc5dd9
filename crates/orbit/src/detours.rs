//! Detours to an orbit that is not found at once: over slower rings, over pockets that hardly hold a ball, and by
//! contacts that are damped more.

use crate::attempt::{Problem, begun, rolled};
use crate::homotopy::Regularization;
use crate::search::{find, sliding};
use crate::solved::SolvedOrbit;
use crate::{OrbitError, OrbitReason};
use tribodyn_bearing::{Bearing, OperatingPoint, RaceControl};

/// Shares of the inner ring's speed at which balls that slide on it might roll.
const SLIDING: [f64; 7] = [0.7, 0.5, 0.35, 0.25, 0.15, 0.08, 0.03];

/// Places at which balls are sent round where all else fails.
const SOFTEST: [f64; 2] = [0.25, 0.0];

/// Damping ratio of contacts on which balls without load do not bounce. What it adds to the loads of balls that follow
/// their orbit is twice that times the speed of the cage over the frequency of a contact.
const DAMPED: f64 = 1.0;

/// An orbit where a search from the balls that would roll ended with an error.
pub(crate) fn detour(problem: Problem<'_>, error: &OrbitError) -> Option<SolvedOrbit> {
    let watch = &problem.point.watch;
    let guessed = outer_controlled(problem.bearing);
    // What is guessed where a case states no control is that of the outer race: tried before. By the inner one balls
    // may roll as none would, against both rings, or have no load that outer control leaves them.
    let tried = matches!(problem.bearing.modelling.race_control, None | Some(RaceControl::Outer));
    let again = (!tried).then(|| {
        watch.stage("control by the outer race", None);
        rolled(problem, &guessed, find)
    });
    let skids = match again {
        Some(Ok(solved)) => return Some(solved),
        Some(Err(again)) => skids(error) || skids(&again),
        None => skids(error),
    };
    if skids {
        watch.stage("an inner ring that turns more slowly", None);
        if let Some(found) = from_slower(problem, &guessed) {
            return Some(found);
        }
    }
    watch.stage("pockets that hardly hold a ball", None);
    softest(problem)
}

/// The orbit with contacts on which balls do not bounce, searched for as that of the bearing itself.
pub(crate) fn damped_more(problem: Problem<'_>) -> Option<SolvedOrbit> {
    problem.point.watch.stage("contacts that are damped more", None);
    let bearing = &Regularization { contact_damping: DAMPED, ..Regularization::NONE }.of(problem.bearing);
    let problem = Problem { bearing, ..problem };
    let mut solved = match rolled(problem, bearing, find) {
        Err(error @ OrbitError::NotConverged { .. }) => detour(problem, &error)?,
        other => other.ok()?,
    };
    solved.solution.raised_contact_damping = Some(DAMPED);
    solved.start.iter_mut().for_each(|start| start.regularize(|by| by.contact_damping = DAMPED));
    Some(solved)
}

/// The orbit in pockets so soft that they hardly do more than take idle balls along, where there is none in stiffer
/// ones.
fn softest(problem: Problem<'_>) -> Option<SolvedOrbit> {
    let Problem { bearing, point, settings, .. } = problem;
    let at = |share: &f64| {
        begun(problem, (bearing, point), |newton, rolling, homotopy| {
            sliding(newton, rolling, (homotopy, *share), settings)
        })
        .ok()
    };
    SOFTEST.iter().find_map(at)
}

/// The bearing with balls that roll on their outer race.
fn outer_controlled(bearing: &Bearing) -> Bearing {
    let mut guessed = bearing.clone();
    guessed.modelling.race_control = Some(RaceControl::Outer);
    guessed
}

fn skids(error: &OrbitError) -> bool {
    matches!(error, OrbitError::NotConverged { reason: OrbitReason::GrossSkidding { .. }, .. })
}

/// The orbit of balls that slide on the inner race, from those that would roll if it turned more slowly: the slower,
/// the less centrifugal force takes them off it.
fn from_slower(problem: Problem<'_>, guessed: &Bearing) -> Option<SolvedOrbit> {
    let Problem { point, settings, .. } = problem;
    let slower = |share: &f64| {
        let slower = slower(point, *share);
        begun(problem, (guessed, &slower), |newton, rolling, homotopy| {
            sliding(newton, rolling, (homotopy, 1.0), settings)
        })
        .ok()
    };
    SLIDING.iter().find_map(slower)
}

/// Rings of which the inner one turns at a share of its speed, seen from the outer one.
fn slower(point: &OperatingPoint, share: f64) -> OperatingPoint {
    OperatingPoint { inner_speed: point.outer_speed + share * (point.inner_speed - point.outer_speed), ..point.clone() }
}
