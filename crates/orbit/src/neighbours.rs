//! The orbit from that of the same bearing at a slightly other speed. Where balls just reach their pockets, whether one
//! that is sent round closes its turns hangs on details of its contacts with them, and half of the neighbours of a
//! bearing without an orbit have theirs; from there a step or two lead to its own.

use crate::attempt::{Problem, rolled};
use crate::homotopy::Regularization;
use crate::relief::{is_kept, stepped};
use crate::search::alone;
use crate::solved::SolvedOrbit;
use tribodyn_bearing::OperatingPoint;

/// Speeds over those of the case.
const SHARES: [f64; 2] = [1.07, 0.93];

/// The orbit from that of a neighbour; none where no neighbour soon has one that leads to it.
pub(crate) fn from_neighbours(problem: Problem<'_>) -> Option<SolvedOrbit> {
    problem.point.watch.stage("the bearing at a slightly other speed", None);
    SHARES.iter().find_map(|share| from_speed(problem, *share))
}

fn from_speed(problem: Problem<'_>, share: f64) -> Option<SolvedOrbit> {
    let Problem { bearing, point, .. } = problem;
    let [inner_speed, outer_speed] = [point.inner_speed, point.outer_speed].map(|speed| share * speed);
    let other = &OperatingPoint { inner_speed, outer_speed, ..point.clone() };
    let near = rolled(Problem { point: other, ..problem }, bearing, alone).ok()?.start?;
    if near.regularization != Regularization::NONE {
        return None;
    }
    let solved = stepped(problem, &near)?;
    is_kept(problem, solved.start.as_ref()?).then_some(solved)
}
