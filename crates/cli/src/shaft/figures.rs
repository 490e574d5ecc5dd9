//! Figures of a shaft: its line, its moments, Campbell's diagram.

use tribodyn_plot::{Axis, Figure, LineChart, Panel, PlotError, Series};
use tribodyn_study::shaft::{CutAnswer, LifeAnswer, ShaftFile, Station, Whirl, WhirlAnswer};

/// Figures of the first load case, and of modes where there are some.
pub fn figures(file: &ShaftFile, life: &LifeAnswer, whirl: Option<&WhirlAnswer>) -> Vec<Result<Figure, PlotError>> {
    let stations = &life.duties[0].shaft.stations;
    let place = |station: &Station| station.position_m;
    let title = |what: &str| format!("{what}: {}", file.system.name);
    let mut all = vec![
        figure(
            "shaft-deflection",
            chart(
                &title("Deflection"),
                ("Deflection", "µm"),
                (stations, place),
                &[("x", &|s| 1e6 * s.displacement_m[0]), ("y", &|s| 1e6 * s.displacement_m[1])],
            ),
        ),
        figure(
            "shaft-moment",
            chart(
                &title("Bending moment"),
                ("Moment", "N m"),
                (&life.duties[0].shaft.cuts, |cut: &CutAnswer| cut.position_m),
                &[
                    ("about x", &|s| s.bending_moment_nm[0]),
                    ("about y", &|s| s.bending_moment_nm[1]),
                    ("torque", &|s| s.torque_nm),
                ],
            ),
        ),
        figure(
            "shaft-stress",
            chart(
                &title("Nominal stress"),
                ("Stress", "MPa"),
                (stations, place),
                &[("bending", &|s| 1e-6 * s.bending_stress_pa), ("von Mises", &|s| 1e-6 * s.equivalent_stress_pa)],
            ),
        ),
    ];
    if let Some(whirl) = whirl.filter(|whirl| whirl.speeds.len() > 1) {
        all.push(figure("campbell", campbell(&title("Campbell diagram"), whirl)));
        if whirl.speeds.iter().all(|speed| speed.amplitude_max_m.is_some()) {
            all.push(figure("unbalance", unbalance(&title("Unbalance"), file, whirl)));
        }
    }
    all
}

fn figure(name: &str, chart: LineChart) -> Result<Figure, PlotError> {
    let title = chart.title.clone();
    Figure::new(name, title, &[Panel::Cartesian(LineChart { title: String::new(), ..chart })])
}

type Line<'a, T> = (&'a str, &'a dyn Fn(&T) -> f64);

fn chart<T>(
    title: &str,
    (label, unit): (&str, &str),
    (points, place): (&[T], impl Fn(&T) -> f64),
    lines: &[Line<'_, T>],
) -> LineChart {
    let line = |value: &dyn Fn(&T) -> f64| points.iter().map(|point| (1e3 * place(point), value(point))).collect();
    let series = lines.iter().map(|(name, value)| Series::line(*name, line(value)));
    LineChart::new(title, Axis::new("Along the shaft", "mm"), Axis::new(label, unit), series.collect())
}

fn campbell(title: &str, whirl: &WhirlAnswer) -> LineChart {
    let kinds = [
        (Whirl::Forward, "forward"),
        (Whirl::Backward, "backward"),
        (Whirl::Mixed, "in a plane"),
        (Whirl::Axial, "axial"),
    ];
    let mut series = Vec::new();
    for (kind, name) in kinds {
        let points = whirl.speeds.iter().flat_map(|speed| {
            let of = speed.modes.iter().filter(|mode| mode.whirl == kind);
            of.map(|mode| (speed.speed_rpm, mode.frequency_hz)).collect::<Vec<_>>()
        });
        let points: Vec<(f64, f64)> = points.collect();
        if !points.is_empty() {
            series.push(Series::points(name, points));
        }
    }
    let ends = [whirl.speeds.first(), whirl.speeds.last()].into_iter().flatten();
    series.push(Series::line("rotation", ends.map(|speed| (speed.speed_rpm, speed.speed_rpm / 60.0)).collect()));
    LineChart::new(title, Axis::new("Speed", "r/min"), Axis::new("Frequency", "Hz"), series)
}

fn unbalance(title: &str, file: &ShaftFile, whirl: &WhirlAnswer) -> LineChart {
    let bearings = file.system.bearings.iter().enumerate().map(|(index, spec)| {
        let points = whirl.speeds.iter().map(|speed| (speed.speed_rpm, 1e6 * speed.amplitude_m[index]));
        Series::line(spec.name.clone(), points.collect())
    });
    let most = whirl.speeds.iter().filter_map(|s| s.amplitude_max_m.map(|a| (s.speed_rpm, 1e6 * a)));
    let series = bearings.chain([Series::line("largest", most.collect())]).collect();
    LineChart::new(title, Axis::new("Speed", "r/min"), Axis::new("Amplitude", "µm"), series)
}
