//! Curves of two recordings over each other.

use super::{Evaluated, Kind};
use tribodyn_plot::{Axis, Figure, History, LineChart, Panel, PlotError, Samples, Series, time_history};
use tribodyn_record::{BallRow, StateRow};
use tribodyn_study::evaluation::quantities::{friction_torque_nm, ring_displacement_um};

/// Sectors of the azimuth in which samples are averaged, 5° each.
const SECTORS: usize = 72;

/// Legends of the two.
const LABELS: [&str; 2] = ["A", "B"];

/// A curve over the azimuth: heading, quantity, unit, where it is, and the load without which it says nothing.
type Curve = (&'static str, &'static str, &'static str, fn(&BallRow) -> f32, fn(&BallRow) -> f32);

const CURVES: [Curve; 8] = [
    ("Inner race", "Contact angle", "°", |b| b.contact_angle_inner_deg, |b| b.load_inner_n),
    ("Outer race", "Contact angle", "°", |b| b.contact_angle_outer_deg, |b| b.load_outer_n),
    ("Inner race", "Contact load", "N", |b| b.load_inner_n, |_| 1.0),
    ("Outer race", "Contact load", "N", |b| b.load_outer_n, |_| 1.0),
    ("Inner race", "Peak pressure", "GPa", |b| b.peak_pressure_inner_gpa, |b| b.load_inner_n),
    ("Outer race", "Peak pressure", "GPa", |b| b.peak_pressure_outer_gpa, |b| b.load_outer_n),
    ("Inner race", "Slide-to-roll ratio", "%", |b| b.slide_to_roll_inner_percent, |b| b.load_inner_n),
    ("Outer race", "Slide-to-roll ratio", "%", |b| b.slide_to_roll_outer_percent, |b| b.load_outer_n),
];

/// A history: its quantity, unit and where it is in a row.
type Line = (&'static str, &'static str, fn(&StateRow) -> f64);

const LINES: [Line; 6] = [
    ("Cage speed", "r/min", |r| r.cage_speed_rpm),
    ("Friction torque", "N m", friction_torque_nm),
    ("Ring displacement X", "µm", |r| ring_displacement_um(r)[0]),
    ("Ring displacement Z", "µm", |r| ring_displacement_um(r)[2]),
    ("Largest inner load", "N", |r| r.load_inner_max_n),
    ("Largest pocket force", "N", |r| r.pocket_force_max_n),
];

/// Means over the azimuth, and histories where both are runs.
pub fn figures(a: &Evaluated, b: &Evaluated, notes: &mut Vec<String>) -> Result<Vec<Figure>, PlotError> {
    let mut figures = Vec::new();
    let panels: Vec<Panel> = CURVES.iter().filter_map(|curve| panel(curve, [a, b])).collect();
    if panels.is_empty() {
        notes.push("There are no curves over the azimuth: no recording has samples of its balls.".to_owned());
    } else {
        let title = "Contacts over the azimuth, means of all balls";
        figures.push(Figure::in_columns("compare-azimuth", title, 2, &panels)?);
    }
    match (&a.kind, &b.kind) {
        (Kind::Run(_), Kind::Run(_)) => figures.push(histories([a, b])?),
        (Kind::Solution(_), Kind::Solution(_)) => {}
        _ => {
            notes.push("There are no histories: one of the recordings is of a solution, which has no time.".to_owned())
        }
    }
    Ok(figures)
}

impl Evaluated {
    /// From when on samples are compared, s: a solution has no start.
    fn begins_s(&self) -> f64 {
        match &self.kind {
            Kind::Run(answer) => answer.summary.averaged_from_s,
            Kind::Solution(_) => f64::NEG_INFINITY,
        }
    }
}

fn panel((heading, quantity, unit, get, load): &Curve, both: [&Evaluated; 2]) -> Option<Panel> {
    let one = |(evaluated, label): (&Evaluated, &str)| {
        let from = evaluated.begins_s();
        let rows = evaluated.run.balls.iter().filter(|(time, _)| *time >= from).flat_map(|(_, balls)| balls);
        let points = over_azimuth(rows.filter(|b| load(b) > 0.0), *get);
        (!points.is_empty()).then(|| Series::dense(label, points))
    };
    let series: Vec<Series> = both.into_iter().zip(LABELS).filter_map(one).collect();
    (!series.is_empty()).then(|| {
        let azimuth = Axis::new("Azimuth", "°").covering(0.0, 360.0);
        Panel::Cartesian(LineChart::new(*heading, azimuth, Axis::new(*quantity, *unit), series))
    })
}

/// Mean in each sector that has samples, at the middle of the sector.
fn over_azimuth<'a>(rows: impl Iterator<Item = &'a BallRow>, get: fn(&BallRow) -> f32) -> Vec<(f64, f64)> {
    let (mut sums, mut counts) = ([0.0; SECTORS], [0.0; SECTORS]);
    let width = 360.0 / SECTORS as f64;
    for row in rows {
        let sector = (f64::from(row.azimuth_deg).rem_euclid(360.0) / width) as usize % SECTORS;
        sums[sector] += f64::from(get(row));
        counts[sector] += 1.0;
    }
    let middle = |sector: usize| (sector as f64 + 0.5) * width;
    (0..SECTORS).filter(|k| counts[*k] > 0.0).map(|k| (middle(k), sums[k] / counts[k])).collect()
}

/// The steady parts of two runs over each other.
fn histories(both: [&Evaluated; 2]) -> Result<Figure, PlotError> {
    let rows = both.map(|e| {
        let from = e.run.states.partition_point(|row| row.time_s < e.begins_s());
        &e.run.states[from..]
    });
    let times = rows.map(|rows| rows.iter().map(|row| row.time_s).collect::<Vec<f64>>());
    let values: Vec<[Vec<f64>; 2]> =
        LINES.iter().map(|(.., get)| rows.map(|rows| rows.iter().map(get).collect())).collect();
    let panels: Vec<History> = LINES
        .iter()
        .zip(&values)
        .map(|((quantity, unit, _), values)| History {
            title: "",
            quantity: Axis::new(*quantity, *unit),
            samples: (0..2).map(|k| Samples { label: LABELS[k], x: &times[k], y: &values[k] }).collect(),
        })
        .collect();
    time_history("compare-histories", "Both runs, the parts that their means are of", &panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_sectors_without_samples_are_left_out() {
        let row = |azimuth_deg: f32, load: f32| BallRow { azimuth_deg, load_inner_n: load, ..BallRow::default() };
        let rows = [row(1.0, 10.0), row(4.0, 20.0), row(359.9, 7.0), row(360.0, 30.0)];
        assert_eq!(over_azimuth(rows.iter(), |b| b.load_inner_n), [(2.5, 20.0), (357.5, 7.0)]);
    }
}
