//! A bearing whose inner ring is held in its place: its balls, and whether they are elastic there.

use crate::error::StudyError;
use tribodyn::AnswerError;
use tribodyn::plausibility::{inelastic, peak_pressure};
use tribodyn_bearing::{Bearing, OperatingPoint, RingFreedom};
use tribodyn_quasistatic::{Model, Solution, solve};
use tribodyn_shaft::{RestingBearing, Vector};

/// The balls of a bearing with its inner ring held, without their pockets, of which nothing is said; none where they
/// have no equilibrium of their own.
pub(crate) fn held_solution(bearing: &Bearing, point: &OperatingPoint, ring: Vector) -> Option<Solution> {
    let point = OperatingPoint { ring: ring.map(RingFreedom::Held), ..point.clone() };
    let mut solution = solve(bearing, &point, Model::JonesHarris).ok()?.solution;
    solution.balls.iter_mut().for_each(|ball| ball.pocket = None);
    Some(solution)
}

/// Highest peak pressure of all contacts, Pa; without a solution that of the bearing at rest on its inner race.
pub(crate) fn held_pressure(bearing: &Bearing, ring: Vector, solution: Option<&Solution>) -> f64 {
    solution.map(peak_pressure).unwrap_or_else(|| {
        let resting = RestingBearing { bearing, first_ball: 0.0 };
        let loads = (0..bearing.geometry.ball_count).map(|ball| resting.ball(resting.azimuth(ball), ring).load);
        bearing.races.inner.frozen::<f64>().ellipse(loads.fold(0.0, f64::max)).peak_pressure
    })
}

/// Refuses a peak pressure, Pa, beyond which no contact is elastic; `place` names the bearing.
pub(crate) fn elastic(place: &str, peak_pressure: f64) -> Result<(), StudyError> {
    match inelastic(peak_pressure) {
        Some(why) => Err(AnswerError::Overload { file: place.to_owned(), why }.into()),
        None => Ok(()),
    }
}
