//! The orbit of balls that are heavier than the case's. In a slow bearing idle balls weigh next to nothing, and whether
//! one that is sent round closes its turns hangs on how it bounces between its races. With more weight, and still a
//! thousandth of the load, it rolls on the outer one.
//!
//! Six bearings from 608 to 6303 in oil, as `new` writes them but at 300 to 1000 r/min, had an orbit after 40 to 59 s,
//! three of them with damped swinging; all have one so in 1 to 11 s. Where both are found the cage speed is up to
//! 1.1e-3 lower and the torque up to 5e-3 higher. It is therefore for bearings whose balls are taken heavier than the
//! case's in any search: others may still have an orbit of their own. To go on from here to lighter balls, from the
//! start of a turn, gave none of six.

use crate::attempt::{Problem, rolled};
use crate::homotopy::{LIGHTEST, Regularization, mass_factor};
use crate::search::soon;
use crate::solved::SolvedOrbit;
use crate::start;
use tribodyn_quasistatic::rolling_start;

/// Centrifugal force of a ball over the mean load of a ball.
const SHARE: f64 = 1e-3;

/// The orbit of balls that are heavier than in other searches; none where those have the case's.
pub(crate) fn heavier(problem: Problem<'_>) -> Option<SolvedOrbit> {
    let Problem { bearing, point, .. } = problem;
    let rolling = rolling_start(bearing, point).ok()?;
    let speed = start::cage_speed(&rolling);
    let [least, ball_mass] = [LIGHTEST, SHARE].map(|share| mass_factor(share, bearing, (&rolling, speed)));
    if least == 1.0 || !ball_mass.is_finite() {
        return None;
    }
    point.watch.stage("heavier balls", Some(speed));
    let bearing = &Regularization { ball_mass, ..Regularization::NONE }.of(bearing);
    let mut solved = rolled(Problem { bearing, ..problem }, bearing, soon).ok()?;
    solved.start = solved.start.filter(|start| start.regularization == Regularization::NONE);
    solved.start.as_mut()?.regularize(|by| by.ball_mass = ball_mass);
    solved.solution.ball_mass_factor = Some(ball_mass);
    Some(solved)
}
