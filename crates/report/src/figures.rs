//! The bearing, and histories and balances of a run.

use super::live::{Kind, Live, Plan as LivePlan, View};
use tribodyn_plot::{
    Axis, BearingDrawing, Figure, History, PlotError, Samples, bars, bearing_figure, stacked_bars, time_history,
};
use tribodyn_record::{Run, StateRow};
use tribodyn_study::evaluation::facts::{BallWear, said};
use tribodyn_study::run::Summary;

/// A line of a history: its label and where it is in a row.
type Line = (&'static str, fn(&StateRow) -> f64);

/// A panel: its heading, quantity, unit and lines.
type Plan = (&'static str, &'static str, &'static str, &'static [Line]);

/// Name and title of a figure with its panels.
type Histories = (&'static str, &'static str, &'static [Plan]);

const HISTORIES: [Histories; 6] = [
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
                ("pocket friction", |r| 1e-3 * r.pocket_friction_w),
            ],
        )],
    ),
];

/// Of a cage that is free to move.
const CAGE: Histories = (
    "cage-motion",
    "Centre, tilt and lands of the cage",
    &[
        ("Centre", "Displacement", "µm", &[("X", |r| r.cage_x_um), ("Y", |r| r.cage_y_um), ("Z", |r| r.cage_z_um)]),
        ("Tilt", "Tilt", "mrad", &[("about X", |r| r.cage_tilt_x_mrad), ("about Y", |r| r.cage_tilt_y_mrad)]),
        (
            "Force of the lands",
            "Force",
            "N",
            &[
                ("inner ring", |r| r.land_inner_x_n.hypot(r.land_inner_y_n)),
                ("outer ring", |r| r.land_outer_x_n.hypot(r.land_outer_y_n)),
            ],
        ),
        ("Smallest gap at the lands", "Gap", "µm", &[("gap", |r| r.land_gap_um)]),
    ],
);

/// Of rings that tilt.
const TILT: Histories = (
    "ring-tilt",
    "Tilt of the rings",
    &[
        ("Inner ring", "Tilt", "mrad", &[("about X", |r| r.inner_tilt_x_mrad), ("about Y", |r| r.inner_tilt_y_mrad)]),
        ("Outer ring", "Tilt", "mrad", &[("about X", |r| r.outer_tilt_x_mrad), ("about Y", |r| r.outer_tilt_y_mrad)]),
    ],
);

/// Part of the loads on the ring above which their resultant across the axis has a direction.
const DIRECTED: f64 = 1e-3;

/// The bearing as the file describes it, with the direction of a load (N, across and along the axis); none where the
/// file does not say its geometry.
pub fn bearing(run: &Run, [x, y, z]: [f64; 3]) -> Option<Figure> {
    let number = |key: &str| said(run, key)?.parse::<f64>().ok();
    let radial = x.hypot(y);
    let drawing = BearingDrawing {
        ball_count: number("ball_count")? as usize,
        ball_diameter: 1e-3 * number("ball_diameter_mm")?,
        pitch_diameter: 1e-3 * number("pitch_diameter_mm")?,
        groove_coefficients: [number("inner_groove_coefficient")?, number("outer_groove_coefficient")?],
        contact_angle: number("free_contact_angle_deg")?.to_radians(),
        radial_load: (radial > DIRECTED * radial.hypot(z)).then(|| y.atan2(x)),
    };
    bearing_figure(&drawing).ok()
}

/// The load on the inner ring of a run at its end, N: what the balls hold.
pub fn load(run: &Run) -> [f64; 3] {
    let last = run.states.last();
    last.map_or([0.0; 3], |r| [-r.inner_ball_force_x_n, -r.inner_ball_force_y_n, -r.inner_ball_force_z_n])
}

/// Part of the greatest value of a unit in a figure below which a spread is rounding, of the numbers or of the solver.
const LEAST_SPREAD: f64 = 1e-6;
/// Errors of the acceleration, rms, in the spread of an axis that shows no more than them.
const ERRORS_SHOWN: f64 = 20.0;

/// The least spread that shows in a panel of a figure: the greatest of rounding and of the error of what is drawn.
fn least_spread(unit: &str, figure: &[(&str, f64)], acceleration_error_m_s2: Option<f64>) -> f64 {
    let greatest = figure.iter().filter(|(of, _)| *of == unit).fold(0.0, |most: f64, (_, value)| most.max(*value));
    let of_error = if unit == "m/s²" { ERRORS_SHOWN * acceleration_error_m_s2.unwrap_or(0.0) } else { 0.0 };
    (LEAST_SPREAD * greatest).max(of_error)
}

/// An axis of a quantity that covers a spread about the middle of the values where they have less.
fn resolved(quantity: Axis, values: &[Vec<f64>], spread: f64) -> Axis {
    let all = || values.iter().flatten();
    let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
    if high - low >= spread || !low.is_finite() {
        return quantity;
    }
    let middle = 0.5 * (low + high);
    quantity.covering(middle - 0.5 * spread, middle + 0.5 * spread)
}

/// Quantities over time. The start does not set the scales: what is drawn is the part of the run that the means are of;
/// the interactive figures have the whole run too.
pub fn histories(
    run: &Run,
    summary: &Summary,
    acceleration_error_m_s2: Option<f64>,
    live: &mut Live,
) -> Result<Vec<Figure>, PlotError> {
    let time: Vec<f64> = run.states.iter().map(|row| row.time_s).collect();
    let from = time.partition_point(|t| *t < summary.averaged_from_s);
    let steady = if time.len() - from < FEWEST { 0 } else { from };
    let mut figures = Vec::new();
    let cage = run.states.iter().any(|row| row.cage_free).then_some(&CAGE);
    let tilts =
        |row: &StateRow| [row.inner_tilt_x_mrad, row.inner_tilt_y_mrad, row.outer_tilt_x_mrad, row.outer_tilt_y_mrad];
    let moves = run.states.first().is_some_and(|first| run.states.iter().any(|row| tilts(row) != tilts(first)));
    for (name, title, plans) in HISTORIES.iter().chain(cage).chain(moves.then_some(&TILT)) {
        let values: Values =
            plans.iter().map(|(.., lines)| lines.iter().map(|(_, get)| rows(run, *get)).collect()).collect();
        let greatest: Vec<(&str, f64)> = plans
            .iter()
            .zip(&values)
            .map(|((_, _, unit, _), lines)| (*unit, lines.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()))))
            .collect();
        let spread = |unit: &str| least_spread(unit, &greatest, acceleration_error_m_s2);
        figures.push(time_history(name, title, &panels(plans, &time, &values, (steady, &spread)))?);
        live.add(LivePlan {
            name,
            title,
            kind: Kind::History,
            abscissa: Axis::new("Time", "s"),
            panels: &panels(plans, &time, &values, (0, &spread)),
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
fn panels<'a>(
    plans: &[Plan],
    time: &'a [f64],
    values: &'a Values,
    (from, spread): (usize, &dyn Fn(&str) -> f64),
) -> Vec<History<'a>> {
    let line = |((label, _), y): (&Line, &'a Vec<f64>)| Samples { label, x: &time[from..], y: &y[from..] };
    let panel = |((title, quantity, unit, lines), values): (&Plan, &'a Vec<Vec<f64>>)| History {
        title,
        quantity: resolved(Axis::new(*quantity, *unit), values, spread(unit)),
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A picometre on a displacement of 64 µm along another axis, and 1e-7 m/s² under an error of as much, are flat.
    #[test]
    fn limit_rounding_is_not_drawn_as_vibration() {
        let ripple = |about: f64, height: f64| vec![vec![about - height, about + height]];
        let displacements = [("µm", 64.0), ("µm", 1e-6)];
        let spread = least_spread("µm", &displacements, None);
        let axis = resolved(Axis::new("Displacement", "µm"), &ripple(0.0, 1e-6), spread);
        assert_eq!(axis.at_least, Some((-3.2e-5, 3.2e-5)));
        assert_eq!(resolved(Axis::new("Displacement", "µm"), &ripple(64.0, 0.1), spread).at_least, None);
        let spread = least_spread("m/s²", &[("m/s²", 1e-7)], Some(1e-7));
        let axis = resolved(Axis::new("Acceleration", "m/s²"), &ripple(0.0, 1e-7), spread);
        assert_eq!(axis.at_least, Some((-1e-6, 1e-6)));
        assert_eq!(least_spread("m/s²", &[("m/s²", 3.0)], Some(0.01)), 0.2);
    }
}
