//! `/bearing/state` and `/bearing/balls` of a solution, filled from the tables of quantities.

use crate::ball;
use crate::timeline::{Timeline, timestamp};
use crate::units::degrees;
use crate::wire::Numbers;
use crate::wire::tribodyn::{Balls, BearingState};
use std::sync::LazyLock;
use tribodyn_bearing::BallResult;
use tribodyn_bearing::quantities::{OfBall, Over, Quantity, Scope, joined};
use tribodyn_quasistatic::{Model, SOLUTION, Solution};

/// Each number for all balls that a message `M` holds, with the place of its field.
pub(crate) fn over_fields<M: Numbers>() -> Vec<(OfBall, Over, usize)> {
    let place = |q: &OfBall, over| M::place(&q.over_name(over, q.facts().shown));
    OfBall::over_balls().filter_map(|(q, over)| Some((q, over, place(&q, over)?))).collect()
}

/// Each quantity of a table that a message `M` holds, with the place of its field.
pub(crate) fn fields<M: Numbers, T>(table: &'static [Quantity<T>]) -> Vec<(&'static Quantity<T>, usize)> {
    let place = |q: &Quantity<T>| M::place(&joined(&[q.facts.name, q.facts.shown.suffix]));
    table.iter().filter_map(|q| Some((q, place(q)?))).collect()
}

/// Writes the numbers for all balls that a message holds.
fn fill_over<M: Numbers>(message: &mut M, fields: &[(OfBall, Over, usize)], balls: &[BallResult]) {
    for (quantity, over, place) in fields {
        if let Some(value) = quantity.over(*over, balls) {
            message.set_number(*place, value * quantity.facts().shown.per_si);
        }
    }
}

/// Writes the quantities of `of` that a message holds.
pub(crate) fn fill<M: Numbers, T>(message: &mut M, fields: &[(&Quantity<T>, usize)], of: &T) {
    for (quantity, place) in fields {
        if let Some(value) = (quantity.get)(of) {
            message.set_number(*place, value * quantity.facts.shown.per_si);
        }
    }
}

static OF_SOLUTION: LazyLock<Vec<(&Quantity<Solution>, usize)>> =
    LazyLock::new(|| fields::<BearingState, _>(&SOLUTION));
static OVER_BALLS: LazyLock<Vec<(OfBall, Over, usize)>> = LazyLock::new(over_fields::<BearingState>);

/// Writes to a solution what a state of its recording holds, and its model has.
pub fn read_state(solution: &mut Solution, state: &BearingState) {
    let held = |scope: Scope| scope == Scope::All || solution.model == Model::Traction;
    let of_model: Vec<_> = OF_SOLUTION.iter().filter(|(quantity, _)| held(quantity.facts.scope)).collect();
    for (quantity, place) in of_model {
        (quantity.set)(solution, state.number(*place) / quantity.facts.shown.per_si);
    }
}

/// Balls that carry load at both races.
pub(crate) fn in_contact(balls: &[BallResult]) -> u32 {
    balls.iter().filter(|ball| ball.is_loaded()).count() as u32
}

/// Ring, cage and sums over the balls at one sample.
pub(crate) fn state(solution: &Solution, timeline: &Timeline, sample: usize, balls: &[BallResult]) -> BearingState {
    let time_s = timeline.seconds(sample);
    let mut message = BearingState {
        timestamp: Some(timestamp(timeline.log_time(sample))),
        time_s,
        cage_angle_deg: degrees(timeline.cage_angle(sample)),
        shaft_angle_deg: degrees(solution.inner_speed_rad_s * time_s),
        balls_in_contact: in_contact(balls),
        ..BearingState::default()
    };
    fill(&mut message, &OF_SOLUTION, solution);
    fill_over(&mut message, &OVER_BALLS, balls);
    message
}

/// All balls at one sample.
pub(crate) fn balls(timeline: &Timeline, sample: usize, balls: &[BallResult]) -> Balls {
    Balls {
        timestamp: Some(timestamp(timeline.log_time(sample))),
        time_s: timeline.seconds(sample),
        balls: balls.iter().enumerate().map(|(i, ball)| ball::message(i, ball)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A number that is renamed in a table alone would be 0 in all recordings.
    #[test]
    fn identity_every_number_of_a_state_is_filled() {
        let filled: Vec<usize> = OF_SOLUTION.iter().map(|f| f.1).chain(OVER_BALLS.iter().map(|f| f.2)).collect();
        for (place, name) in BearingState::NAMES.iter().enumerate() {
            let own = ["time_s", "cage_angle_deg", "shaft_angle_deg"].contains(name);
            assert_eq!(filled.iter().filter(|p| **p == place).count(), usize::from(!own), "{name}");
        }
    }
}
