//! Figures of a ball over one orbit.

use super::live::{Kind, Live, Plan, View};
use tribodyn_plot::{Axis, Figure, History, PlotError, Samples, orbit_polar};
use tribodyn_record::{BallRow, Run};

/// The ball that is shown.
const BALL: usize = 0;
/// Fewest samples over an orbit that show a curve.
const FEWEST: usize = 24;

/// A line: its label and where it is in a row.
type Line = (&'static str, fn(&BallRow) -> f32);

/// Name, title, quantity and unit of a figure with its lines.
const PLANS: [(&str, &str, &str, &str, [Line; 2]); 6] = [
    (
        "orbit-contact-angle",
        "Contact angle",
        "Contact angle",
        "°",
        [("inner contact", |b| b.contact_angle_inner_deg), ("outer contact", |b| b.contact_angle_outer_deg)],
    ),
    (
        "orbit-load",
        "Contact load",
        "Load",
        "kN",
        [("inner contact", |b| 1e-3 * b.load_inner_n), ("outer contact", |b| 1e-3 * b.load_outer_n)],
    ),
    (
        "orbit-pressure",
        "Peak contact pressure",
        "Pressure",
        "GPa",
        [("inner contact", |b| b.peak_pressure_inner_gpa), ("outer contact", |b| b.peak_pressure_outer_gpa)],
    ),
    (
        "orbit-slide-to-roll",
        "Longitudinal slide-to-roll ratio",
        "Slide-to-roll ratio",
        "%",
        [("inner contact", |b| b.slide_to_roll_inner_percent), ("outer contact", |b| b.slide_to_roll_outer_percent)],
    ),
    (
        "orbit-traction",
        "Longitudinal traction",
        "Force on the ball",
        "N",
        [("inner contact", |b| b.traction_inner_n), ("outer contact", |b| b.traction_outer_n)],
    ),
    (
        "orbit-wear-rate",
        "Wear rate",
        "Wear rate",
        "µm³/s",
        [("inner race", |b| b.wear_rate_inner_um3_s), ("outer race", |b| b.wear_rate_outer_um3_s)],
    ),
];

/// Polar charts over the last orbit of a ball.
pub fn figures(run: &Run, notes: &mut Vec<String>, live: &mut Live) -> Result<Vec<Figure>, PlotError> {
    let Some(rows) = last_orbit(&run.balls) else {
        notes.push(format!(
            "There are no charts over the azimuth: ball {BALL} made no whole orbit with {FEWEST} samples."
        ));
        return Ok(Vec::new());
    };
    let azimuth: Vec<f64> = rows.iter().map(|b| f64::from(b.azimuth_deg).to_radians()).collect();
    let mut figures = Vec::new();
    for (name, title, quantity, unit, lines) in &PLANS {
        let values = lines.map(|(_, get)| rows.iter().map(|b| f64::from(get(b))).collect::<Vec<f64>>());
        let samples = [0, 1].map(|k| Samples { label: lines[k].0, x: &azimuth, y: &values[k] });
        let title = format!("{title} of ball {BALL} over its last orbit");
        let quantity = Axis::new(*quantity, *unit);
        figures.push(orbit_polar(name, &title, quantity.clone(), &samples)?);
        over_azimuth(live, (name, &title), quantity, &samples);
    }
    Ok(figures)
}

/// The same over the azimuth in degrees from 0 to 360, for an interactive figure.
fn over_azimuth(live: &mut Live, (name, title): (&str, &str), quantity: Axis, samples: &[Samples]) {
    let Some(first) = samples.first() else { return };
    let mut order: Vec<usize> = (0..first.x.len()).collect();
    let degrees = |k: usize| first.x[k].to_degrees().rem_euclid(360.0);
    order.sort_by(|a, b| degrees(*a).total_cmp(&degrees(*b)));
    let azimuth: Vec<f64> = order.iter().map(|k| degrees(*k)).collect();
    let sorted = |line: &Samples| order.iter().map(|k| line.y[*k]).collect::<Vec<f64>>();
    let values: Vec<Vec<f64>> = samples.iter().map(sorted).collect();
    let lines = samples.iter().zip(&values).map(|(line, y)| Samples { label: line.label, x: &azimuth, y });
    let panel = History { title: "", quantity, samples: lines.collect() };
    live.add(Plan {
        name,
        title,
        kind: Kind::Orbit,
        abscissa: Axis::new("Azimuth", "°"),
        panels: &[panel],
        views: vec![View { name: "Whole orbit".to_owned(), from: 0.0, to: 360.0 }],
        marks: Vec::new(),
        shaft_hz: None,
    });
}

/// The rows of the ball over its last whole turn.
fn last_orbit(balls: &[(f64, Vec<BallRow>)]) -> Option<Vec<&BallRow>> {
    let mut rows: Vec<&BallRow> = Vec::new();
    let mut turned = 0.0;
    for row in balls.iter().rev().map_while(|(_, balls)| balls.get(BALL)) {
        if let Some(later) = rows.last() {
            // The shorter way round: the samples are much closer than half a turn.
            turned += (later.azimuth_deg - row.azimuth_deg + 180.0).rem_euclid(360.0) - 180.0;
        }
        if turned.abs() >= 360.0 {
            return (rows.len() >= FEWEST).then_some(rows);
        }
        rows.push(row);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_one_orbit_is_one_turn_and_no_less() {
        let rows = |count: i32, step: f32| -> Vec<(f64, Vec<BallRow>)> {
            let row = |k: i32| BallRow { azimuth_deg: (step * k as f32).rem_euclid(360.0), ..BallRow::default() };
            (0..count).map(|k| (f64::from(k), vec![row(k)])).collect()
        };
        assert_eq!(last_orbit(&rows(100, 10.0)).unwrap().len(), 36);
        assert_eq!(last_orbit(&rows(100, -10.0)).unwrap().len(), 36);
        assert!(last_orbit(&rows(36, 10.0)).is_none());
        assert!(last_orbit(&rows(100, 40.0)).is_none(), "too few samples in an orbit");
        assert!(last_orbit(&[]).is_none());
    }
}
