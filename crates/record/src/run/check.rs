//! Requirements on a sample before it is recorded: finite, of the right bearing, not earlier than the last one.

use super::overview::Overview;
use crate::RecordError;
use crate::wire::Numbers;
use crate::wire::tribodyn::{Ball, TransientState};
use tribodyn_bearing::BallResult;
use tribodyn_bearing::quantities::OfBall;
use tribodyn_dynamics::Sample;

/// Refuses a sample that cannot be recorded; `state` is the message that it has become.
pub(crate) fn check(
    overview: &Overview,
    state: &TransientState,
    balls: usize,
    last_time_s: f64,
) -> Result<(), RecordError> {
    let (sample, speeds) = (&overview.sample, &overview.angular_velocities_rad_s);
    check_count(speeds.len(), balls)?;
    if sample.time_s < last_time_s {
        return Err(RecordError::TimeGoesBack { time_s: sample.time_s, last_s: last_time_s });
    }
    let rest = not_in_state(sample);
    let mut others = rest.iter().map(|(_, value)| value).chain(speeds.as_flattened());
    if state.are_finite() && others.all(|value| value.is_finite()) {
        return Ok(());
    }
    let of_state = TransientState::NAMES.iter().enumerate().map(|(place, name)| (*name, state.number(place)));
    let of_balls = speeds.as_flattened().iter().map(|&value| ("angular_velocity_rad_s of a ball", value));
    match of_state.chain(rest).chain(of_balls).find(|(_, value)| !value.is_finite()) {
        Some((field, value)) => Err(RecordError::NotFinite { field: field.to_owned(), value }),
        None => Ok(()),
    }
}

/// The numbers of a sample that its message does not hold, or not as they are.
fn not_in_state(sample: &Sample) -> [(&'static str, f64); 11] {
    let (p, w) = (&sample.power, &sample.wear);
    [
        ("angle_rad of the inner ring", sample.inner.angle_rad),
        ("angle_rad of the outer ring", sample.outer.angle_rad),
        ("angle_rad of the cage", sample.cage.angle_rad),
        ("speed_filtered_rad_s of the cage", sample.cage.speed_filtered_rad_s),
        ("imbalance_j", p.imbalance_j),
        ("throughput_j", p.throughput_j),
        ("volume_inner_m3", w.volume_inner_m3),
        ("volume_outer_m3", w.volume_outer_m3),
        ("volume_cage_m3", w.volume_cage_m3),
        ("coating_inner_min_m", w.coating_inner_min_m),
        ("coating_outer_min_m", w.coating_outer_min_m),
    ]
}

/// Refuses balls that cannot be recorded; `messages` are those that they have become.
pub(crate) fn check_balls(messages: &[Ball], balls: &[BallResult], count: usize) -> Result<(), RecordError> {
    check_count(balls.len(), count)?;
    if messages.iter().all(Numbers::are_finite) {
        return Ok(());
    }
    let mut values = balls.iter().enumerate().flat_map(|(k, b)| OfBall::all().map(move |q| (k, q, q.get(b))));
    let bad = values.find_map(|(index, q, value)| {
        let value = value.filter(|v| !v.is_finite())?;
        Some(RecordError::NotFinite { field: format!("balls[{index}].{}", q.name_in(q.facts().unit)), value })
    });
    bad.map_or(Ok(()), Err)
}

fn check_count(solution: usize, case: usize) -> Result<(), RecordError> {
    if solution == case { Ok(()) } else { Err(RecordError::BallCount { solution, case }) }
}
