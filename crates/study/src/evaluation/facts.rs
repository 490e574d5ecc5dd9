//! Numbers of a report that are not in the summary of a run.

use super::quantities::Quantities;
use crate::error::StudyError;
use crate::run::warnings::Tested;
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_case::Case;
use tribodyn_record::{BallRow, Run};
use tribodyn_signal::BearingFrequencies;

/// Mean speeds of the rings over a part of a run, rad/s.
pub fn ring_speeds(run: &Run, from_s: f64) -> [f64; 2] {
    let (mut inner, mut outer, mut rows) = (0.0, 0.0, 0.0f64);
    for row in run.states.iter().filter(|row| row.time_s >= from_s) {
        inner += row.inner_speed_rpm;
        outer += row.outer_speed_rpm;
        rows += 1.0;
    }
    [inner, outer].map(|sum| sum / rows.max(1.0) * TAU / 60.0)
}

/// How often cage, balls and races met on average from a time on; speeds of cage and rings in rad/s.
///
/// # Errors
/// The speeds are not those of a bearing with balls.
pub fn frequencies(
    run: &Run,
    from_s: f64,
    cage: f64,
    [inner, outer]: [f64; 2],
) -> Result<BearingFrequencies, StudyError> {
    let (mut sum, mut count) = (0.0, 0.0);
    for ball in run.balls.iter().filter(|(time, _)| *time >= from_s).flat_map(|(_, balls)| balls) {
        let omega = [
            ball.angular_velocity_axial_rad_s,
            ball.angular_velocity_radial_rad_s,
            ball.angular_velocity_tangential_rad_s,
        ]
        .map(f64::from);
        sum += omega.iter().map(|s| s * s).sum::<f64>().sqrt();
        count += 1.0;
    }
    let turning = if count > 0.0 { sum / count } else { 0.0 };
    Ok(BearingFrequencies::from_run(cage, turning, inner, outer, balls(run))?)
}

/// Frequencies of pure rolling.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Rolling {
    /// Number of balls.
    pub ball_count: usize,
    /// Mean operating contact angle of both races.
    pub contact_angle_deg: f64,
    /// D cos α/d_m.
    #[serde(skip)]
    pub gamma: f64,
    /// Of cage, balls and races.
    #[serde(flatten)]
    pub frequencies: BearingFrequencies,
}

/// Frequencies of pure rolling at the mean operating contact angle; none where the file does not say the geometry.
pub fn rolling(run: &Run, operation: &Quantities, [inner, outer]: [f64; 2]) -> Option<Rolling> {
    let length = |key: &str| Some(1e-3 * said(run, key)?.parse::<f64>().ok()?);
    let (ball, pitch) = (length("ball_diameter_mm")?, length("pitch_diameter_mm")?);
    let angle = |key: &str| operation.mean(key);
    let contact_angle_deg = 0.5 * (angle("contact_angle_inner")? + angle("contact_angle_outer")?);
    let (ball_count, radians) = (balls(run), contact_angle_deg.to_radians());
    let frequencies = BearingFrequencies::from_geometry(ball_count, ball, pitch, radians, inner, outer).ok()?;
    Some(Rolling { ball_count, contact_angle_deg, gamma: ball * radians.cos() / pitch, frequencies })
}

/// An entry of the metadata of a recording.
pub fn said<'a>(run: &'a Run, key: &str) -> Option<&'a str> {
    run.metadata.get("simulation")?.get(key).map(String::as_str)
}

/// Radius of a ball, m; none where the file does not say it.
pub fn ball_radius_m(run: &Run) -> Option<f64> {
    Some(0.5e-3 * said(run, "ball_diameter_mm")?.parse::<f64>().ok()?)
}

/// Sentences on races whose pressures were outside the tested ones.
pub fn untested(case: &Case, run: &Run) -> Vec<String> {
    let mut races = Tested::of(case);
    for (_, balls) in &run.balls {
        races.iter_mut().for_each(|race| race.add(balls));
    }
    races.iter().filter_map(Tested::warning).collect()
}

/// Number of balls; 0 where no sample of them was read.
pub fn balls(run: &Run) -> usize {
    run.balls.first().map_or(0, |(_, balls)| balls.len())
}

/// Volumes that one ball has worn off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BallWear {
    /// Number of the ball.
    pub ball: u32,
    /// Volume off the inner race, µm³.
    pub inner_um3: f64,
    /// Volume off the outer race, µm³.
    pub outer_um3: f64,
    /// Volume off its pocket, µm³.
    pub cage_um3: f64,
}

/// Wear rates integrated by trapezia over the samples of the balls.
pub fn ball_wear(rows: &[(f64, Vec<BallRow>)]) -> Vec<BallWear> {
    let Some((_, first)) = rows.first() else { return Vec::new() };
    let over = |ball: usize, get: fn(&BallRow) -> f32| {
        let rate = |balls: &[BallRow]| balls.get(ball).map_or(0.0, |b| f64::from(get(b)));
        rows.windows(2).map(|w| 0.5 * (w[1].0 - w[0].0) * (rate(&w[0].1) + rate(&w[1].1))).sum::<f64>()
    };
    let one = |(k, ball): (usize, &BallRow)| BallWear {
        ball: ball.index,
        inner_um3: over(k, |b| b.wear_rate_inner_um3_s),
        outer_um3: over(k, |b| b.wear_rate_outer_um3_s),
        cage_um3: over(k, |b| b.wear_rate_cage_um3_s),
    };
    first.iter().enumerate().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_constant_rate_wears_rate_times_time() {
        let balls = |rate: f32| vec![BallRow { index: 4, wear_rate_inner_um3_s: rate, ..BallRow::default() }];
        let rows = [(0.0, balls(10.0)), (0.5, balls(10.0)), (2.0, balls(10.0))];
        let worn = ball_wear(&rows);
        assert_eq!(worn, [BallWear { ball: 4, inner_um3: 20.0, outer_um3: 0.0, cage_um3: 0.0 }]);
        assert!(ball_wear(&[]).is_empty());
    }
}
