//! What a sample must be before it is recorded: finite, of the right bearing, not earlier than the last one.

use super::overview::Overview;
use crate::RecordError;
use crate::wire::Numbers;
use crate::wire::tribodyn::{Ball, TransientState};
use tribodyn_bearing::BallResult;
use tribodyn_bearing::quantities::{OfBall, joined};
use tribodyn_dynamics::{POWER_IN, POWER_LOST, RingSample, Sample};

/// Refuses a sample that cannot be recorded; `state` is the message that it has become.
pub(crate) fn check(
    overview: &Overview,
    state: &TransientState,
    balls: usize,
    last_time_s: f64,
) -> Result<(), RecordError> {
    let (sample, spins) = (&overview.sample, &overview.spins_rad_s);
    check_count(spins.len(), balls)?;
    if sample.time_s < last_time_s {
        return Err(RecordError::TimeGoesBack { time_s: sample.time_s, last_s: last_time_s });
    }
    // What the message does not hold.
    let (p, w) = (&sample.power, &sample.wear);
    let [inner, outer] = [&sample.inner, &sample.outer].map(|ring| ring.angle_rad);
    let volumes = [w.volume_inner_m3, w.volume_outer_m3, w.volume_cage_m3];
    let rest = [p.imbalance_j, p.throughput_j, inner, outer, sample.cage.angle_rad, sample.cage.speed_filtered_rad_s];
    let others = volumes.iter().chain(&rest).chain([&w.coating_inner_min_m, &w.coating_outer_min_m]);
    let are_finite = others.chain(spins.as_flattened()).fold(true, |all, value| all & value.is_finite());
    if are_finite && state.are_finite() {
        return Ok(());
    }
    let mut found = None;
    numbers(sample, &mut |name, values| {
        if let (None, Some(&value)) = (&found, values.iter().find(|v| !v.is_finite())) {
            found = Some(RecordError::NotFinite { field: name.to_owned(), value });
        }
    });
    let mut spinning = spins.iter().enumerate().filter_map(|(index, spin)| {
        let value = *spin.iter().find(|v| !v.is_finite())?;
        Some(RecordError::NotFinite { field: format!("balls[{index}].spin_rad_s"), value })
    });
    let mut over = overview.over_balls().filter(|(.., value)| !value.is_finite());
    let of_all = || over.next().map(|(q, _, value)| RecordError::NotFinite { field: q.name(), value });
    found.or_else(|| spinning.next()).or_else(of_all).map_or(Ok(()), Err)
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

/// Gets a name for some numbers, and the numbers.
type Visit<'a> = dyn FnMut(&str, &[f64]) + 'a;

fn numbers(sample: &Sample, visit: &mut Visit) {
    visit("time_s", &[sample.time_s]);
    ring_numbers(["inner.angle_rad", "inner.motion", "inner.ball_force_n", "inner.torque_nm"], &sample.inner, visit);
    ring_numbers(["outer.angle_rad", "outer.motion", "outer.ball_force_n", "outer.torque_nm"], &sample.outer, visit);
    let (c, p, w) = (&sample.cage, &sample.power, &sample.wear);
    visit("cage.angle_rad", &[c.angle_rad]);
    visit("cage.speed_rad_s", &[c.speed_rad_s, c.speed_filtered_rad_s, c.acceleration_rad_s2]);
    visit("cage torque", &[c.ball_torque_nm, c.fluid_torque_nm]);
    for term in POWER_IN.iter().chain(&POWER_LOST) {
        if let Some(value) = (term.get)(p).filter(|v| !v.is_finite()) {
            visit(&joined(&["power", term.facts.name, term.facts.unit.suffix]), &[value]);
        }
    }
    visit("energy_j", &[p.energy_j, p.imbalance_j, p.throughput_j]);
    visit("worn volume", &[w.volume_inner_m3, w.volume_outer_m3, w.volume_cage_m3]);
    visit("coating left", &[w.coating_inner_min_m, w.coating_outer_min_m]);
}

fn ring_numbers(names: [&'static str; 4], r: &RingSample, visit: &mut Visit) {
    visit(names[0], &[r.angle_rad, r.speed_rad_s]);
    visit(names[1], &r.displacement_m);
    visit(names[1], &r.velocity_m_s);
    visit(names[1], &r.acceleration_m_s2);
    visit(names[2], &r.ball_force_n);
    visit(names[3], &[r.torque_nm]);
}
