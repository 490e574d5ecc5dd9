//! Numbers of a report that are not in the summary of a run.

use crate::failure::Failure;
use crate::input::CaseFile;
use crate::run::Summary;
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_bearing::case::{Case, CurveSpec};
use tribodyn_quasistatic::{Model, OperatingPoint, solve};
use tribodyn_record::{BallRow, Run};
use tribodyn_signal::BearingFrequencies;
use tribodyn_traction::Coating;

/// The quasi-static solution of the same case.
#[derive(Debug, Default)]
pub struct Start {
    pub cage_speed_rpm: Option<f64>,
    pub patch_error_estimate: Option<f64>,
    pub warnings: Vec<String>,
}

impl Start {
    pub fn of(file: &CaseFile) -> Self {
        let Ok(bearing) = file.bearing() else { return Self::default() };
        match solve(&bearing, &OperatingPoint::new(&file.case), Model::Traction) {
            Ok(solved) => Self {
                cage_speed_rpm: Some(solved.solution.cage_speed_rpm),
                patch_error_estimate: solved.solution.patch_error_estimate,
                warnings: solved.solution.warnings,
            },
            Err(error) => Self { warnings: vec![format!("no quasi-static solution: {error}")], ..Self::default() },
        }
    }
}

/// How often cage, balls and races met on average in the second half of a run.
pub fn frequencies(run: &Run, summary: &Summary) -> Result<BearingFrequencies, Failure> {
    let half = run.balls.iter().filter(|(time, _)| *time >= summary.averaged_from_s).flat_map(|(_, balls)| balls);
    let (mut sum, mut count) = (0.0, 0.0);
    for ball in half {
        let spin = [ball.spin_axial_rad_s, ball.spin_radial_rad_s, ball.spin_tangential_rad_s].map(f64::from);
        sum += spin.iter().map(|s| s * s).sum::<f64>().sqrt();
        count += 1.0;
    }
    let spin = if count > 0.0 { sum / count } else { 0.0 };
    let states = run.states.iter().filter(|row| row.time_s >= summary.averaged_from_s);
    let (mut inner, mut outer, mut rows) = (0.0, 0.0, 0.0f64);
    for row in states {
        inner += row.inner_speed_rpm;
        outer += row.outer_speed_rpm;
        rows += 1.0;
    }
    let speed = |rpm: f64| rpm * TAU / 60.0;
    let cage = speed(summary.cage_speed_mean_rpm);
    Ok(BearingFrequencies::from_run(
        cage,
        spin,
        speed(inner / rows.max(1.0)),
        speed(outer / rows.max(1.0)),
        balls(run),
    )?)
}

/// Where the peak pressure at a race is in a row, GPa.
type Pressure = fn(&BallRow) -> f32;

/// Pressures outside the tested ones, a sentence for each race: there the traction curve is extrapolated.
pub fn untested(case: &Case, run: &Run) -> Vec<String> {
    // Parameters that do not vary are taken at one pressure, whatever the contacts have.
    if !case.traction.varying {
        return Vec::new();
    }
    let races: [(&str, &CurveSpec, Pressure); 2] = [
        ("inner", &case.coatings.inner.curve, |b| b.pressure_inner_gpa),
        ("outer", &case.coatings.outer.curve, |b| b.pressure_outer_gpa),
    ];
    races.into_iter().filter_map(|(race, curve, get)| untested_at(race, tested_gpa(curve)?, run, get)).collect()
}

/// Lowest and highest tested pressure, GPa.
fn tested_gpa(curve: &CurveSpec) -> Option<[f64; 2]> {
    let pressures: Vec<f64> = match curve {
        CurveSpec::Library(name) => Coating::library(name).ok()?.tested.iter().map(|test| test.pressure).collect(),
        CurveSpec::Tested(points) => points.iter().map(|point| point.pressure).collect(),
    };
    let extreme = |start: f64, pick: fn(f64, f64) -> f64| 1e-9 * pressures.iter().copied().fold(start, pick);
    (!pressures.is_empty()).then(|| [extreme(f64::INFINITY, f64::min), extreme(0.0, f64::max)])
}

fn untested_at(race: &str, [low, high]: [f64; 2], run: &Run, get: Pressure) -> Option<String> {
    let (mut least, mut most, mut all, mut outside) = (f64::INFINITY, 0.0f64, 0.0, 0.0);
    let pressures = run.balls.iter().flat_map(|(_, balls)| balls).map(|ball| f64::from(get(ball)));
    // A contact that is lost has no pressure.
    for pressure in pressures.filter(|pressure| *pressure > 0.0) {
        (least, most) = (least.min(pressure), most.max(pressure));
        all += 1.0;
        outside += f64::from(u8::from(pressure < low || pressure > high));
    }
    (outside > 0.0).then(|| {
        format!(
            "Pressures at the {race} race were {least:.3} to {most:.3} GPa, the coating was tested at {low} to {high} GPa: its traction curve is extrapolated in {:.0} % of the samples.",
            100.0 * outside / all
        )
    })
}

/// Number of balls; 0 where no sample of them was read.
pub fn balls(run: &Run) -> usize {
    run.balls.first().map_or(0, |(_, balls)| balls.len())
}

/// What one ball has worn off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct BallWear {
    pub ball: u32,
    pub inner_um3: f64,
    pub outer_um3: f64,
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
