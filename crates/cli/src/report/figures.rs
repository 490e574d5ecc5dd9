//! Histories and balances of a run.

use super::live::{Kind, Live, Plan as LivePlan, View};
use tribodyn_plot::{Axis, Figure, History, PlotError, Samples, bars, stacked_bars, time_history};
use tribodyn_record::{Run, StateRow};
use tribodyn_study::evaluation::facts::BallWear;
use tribodyn_study::run::Summary;

/// A line of a history: its label and where it is in a row.
type Line = (&'static str, fn(&StateRow) -> f64);

/// A panel: its heading, quantity, unit and lines.
type Plan = (&'static str, &'static str, &'static str, &'static [Line]);

/// Name and title of a figure with its panels.
const HISTORIES: [(&str, &str, &[Plan]); 6] = [
    (
        "cage-speed",
        "Cage speed and orbital speeds of the balls",
        &[(
            "",
            "Speed",
            "r/min",
            &[
                ("fastest ball", |r| r.orbital_speed_max_rpm),
                ("slowest ball", |r| r.orbital_speed_min_rpm),
                ("mean of the balls", |r| r.orbital_speed_mean_rpm),
                ("cage", |r| r.cage_speed_rpm),
            ],
        )],
    ),
    (
        "ring-acceleration",
        "Acceleration of the outer ring",
        &[
            ("Along X, the radial load", "Acceleration", "m/s²", &[("X", |r| r.outer_acceleration_x_m_s2)]),
            ("Along Y", "Acceleration", "m/s²", &[("Y", |r| r.outer_acceleration_y_m_s2)]),
        ],
    ),
    (
        "displacements",
        "Displacements of the rings",
        &[
            ("Inner ring, X", "Displacement", "µm", &[("X", |r| r.inner_displacement_x_um)]),
            ("Inner ring, Y", "Displacement", "µm", &[("Y", |r| r.inner_displacement_y_um)]),
            ("Inner ring, Z", "Displacement", "µm", &[("Z", |r| r.inner_displacement_z_um)]),
            (
                "Outer ring, X and Y",
                "Displacement",
                "µm",
                &[("X", |r| r.outer_displacement_x_um), ("Y", |r| r.outer_displacement_y_um)],
            ),
        ],
    ),
    (
        "pocket-force",
        "Cage pockets",
        &[
            ("Largest force of any pocket", "Force", "N", &[("largest of all pockets", |r| r.pocket_force_max_n)]),
            ("Impacts since the start", "Impacts", "", &[("all pockets", |r| f64::from(r.impacts))]),
        ],
    ),
    (
        "contacts",
        "Most loaded contacts",
        &[
            (
                "Load",
                "Load",
                "kN",
                &[("inner", |r| 1e-3 * r.load_inner_max_n), ("outer", |r| 1e-3 * r.load_outer_max_n)],
            ),
            (
                "Peak pressure",
                "Pressure",
                "GPa",
                &[("inner", |r| r.peak_pressure_inner_max_gpa), ("outer", |r| r.peak_pressure_outer_max_gpa)],
            ),
        ],
    ),
    (
        "powers",
        "Powers",
        &[(
            "",
            "Power",
            "kW",
            &[
                ("shaft", |r| 1e-3 * r.shaft_w),
                ("friction, inner race", |r| 1e-3 * r.friction_inner_w),
                ("friction, outer race", |r| 1e-3 * r.friction_outer_w),
                ("drag on the balls", |r| 1e-3 * r.drag_w),
                ("churning of the balls", |r| 1e-3 * r.churning_w),
            ],
        )],
    ),
];

/// Quantities over time. The start does not set the scales: what is drawn is the part of the run that the means are of;
/// the interactive figures have the whole run too.
pub fn histories(run: &Run, summary: &Summary, live: &mut Live) -> Result<Vec<Figure>, PlotError> {
    let time: Vec<f64> = run.states.iter().map(|row| row.time_s).collect();
    let from = time.partition_point(|t| *t < summary.averaged_from_s);
    let steady = if time.len() - from < FEWEST { 0 } else { from };
    let mut figures = Vec::new();
    for (name, title, plans) in &HISTORIES {
        let values: Values =
            plans.iter().map(|(.., lines)| lines.iter().map(|(_, get)| rows(run, *get)).collect()).collect();
        figures.push(time_history(name, title, &panels(plans, &time, &values, steady))?);
        live.add(LivePlan {
            name,
            title,
            kind: Kind::History,
            abscissa: Axis::new("Time", "s"),
            panels: &panels(plans, &time, &values, 0),
            views: views(&time, steady),
            marks: Vec::new(),
            shaft_hz: None,
        });
    }
    Ok(figures)
}

/// Fewest samples of a part of a run that is drawn alone.
const FEWEST: usize = 16;

/// Of each panel, of each line the values.
type Values = Vec<Vec<Vec<f64>>>;

fn rows(run: &Run, get: fn(&StateRow) -> f64) -> Vec<f64> {
    run.states.iter().map(get).collect()
}

/// The panels of a figure from a sample on.
fn panels<'a>(plans: &[Plan], time: &'a [f64], values: &'a Values, from: usize) -> Vec<History<'a>> {
    let line = |((label, _), y): (&Line, &'a Vec<f64>)| Samples { label, x: &time[from..], y: &y[from..] };
    let panel = |((title, quantity, unit, lines), values): (&Plan, &'a Vec<Vec<f64>>)| History {
        title,
        quantity: Axis::new(*quantity, *unit),
        samples: lines.iter().zip(values).map(line).collect(),
    };
    plans.iter().zip(values).map(panel).collect()
}

fn views(time: &[f64], steady: usize) -> Vec<View> {
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else { return Vec::new() };
    let whole = View { name: "Whole run".to_owned(), from: first, to: last };
    let part = View { name: "Steady part".to_owned(), from: time[steady], to: last };
    if steady > 0 { vec![part, whole] } else { vec![whole] }
}

/// Part of the power put in below which a loss has no bar, for it would not be seen.
const SEEN: f64 = 1e-3;

/// Wear of each ball and the balance of powers.
pub fn balances(summary: &Summary, worn: &[BallWear]) -> Result<Vec<Figure>, PlotError> {
    let mut figures = Vec::new();
    if worn.iter().any(|w| w.inner_um3 + w.outer_um3 + w.cage_um3 > 0.0) {
        let names: Vec<String> = worn.iter().map(|w| w.ball.to_string()).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let volume = |get: fn(&BallWear) -> f64| worn.iter().map(get).collect::<Vec<f64>>();
        let series = [
            ("inner race", volume(|w| w.inner_um3)),
            ("outer race", volume(|w| w.outer_um3)),
            ("cage pocket", volume(|w| w.cage_um3)),
        ];
        let quantity = Axis::new("Worn volume", "µm³");
        figures.push(bars("wear", "Wear caused by each ball, by its number", quantity, &names, &series)?);
    }
    let p = &summary.power;
    let all = p.mean.shaft_w.abs() + p.mean.load_w.abs();
    let sources =
        [("shaft", p.mean.shaft_w), ("loads on the rings", p.mean.load_w)].map(|(name, w)| (name, vec![1e-3 * w, 0.0]));
    let losses = p.out().into_iter().map(|(name, w)| (name, vec![0.0, 1e-3 * w]));
    let seen = |(_, values): &(&str, Vec<f64>)| values.iter().any(|kw| 1e3 * kw.abs() > SEEN * all);
    let series: Vec<(&str, Vec<f64>)> = sources.into_iter().chain(losses).filter(seen).collect();
    if !series.is_empty() {
        let quantity = Axis::new("Mean power", "kW");
        figures.push(stacked_bars(
            "power-balance",
            "Power balance of the second half",
            quantity,
            &["in", "out"],
            &series,
        )?);
    }
    Ok(figures)
}
