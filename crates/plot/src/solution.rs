//! The standard figures of quasi-static solutions: one run, or several compared.

use tribodyn_bearing::BallResult;
use tribodyn_quasistatic::{Model, Solution};

use crate::cartesian::LineChart;
use crate::error::PlotError;
use crate::figure::{Figure, Panel};
use crate::polar::PolarChart;
use crate::quantity::Quantity;
use crate::series::{Axis, Series};

/// Published values of one quantity over the azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct Published {
    /// The published values.
    pub quantity: Quantity,
    /// Name in the legend, such as `Published (Table 5)`.
    pub label: String,
    /// Label of the run whose colour the points take; black without it.
    pub run: Option<String>,
    /// Azimuth in degrees against value in the unit of [`Quantity::of`]: SI, angles in degrees.
    pub points: Vec<(f64, f64)>,
    /// Half-width of the error bars in the same unit.
    pub uncertainty: Option<f64>,
}

/// Name in the legend of balls that have no value.
const NO_CONTACT: &str = "ball without contact";

/// One figure of the set.
struct Plan {
    name: &'static str,
    title: &'static str,
    panels: &'static [(&'static str, Quantity)],
    /// True if all panels have the same axis, because their values are to be compared.
    shared: bool,
}

const PLANS: [Plan; 10] = [
    Plan {
        name: "contact-angles",
        title: "Contact angles",
        panels: &[("Inner contact", Quantity::ContactAngleInner), ("Outer contact", Quantity::ContactAngleOuter)],
        shared: false,
    },
    Plan {
        name: "contact-loads",
        title: "Contact loads",
        panels: &[("Inner contact", Quantity::LoadInner), ("Outer contact", Quantity::LoadOuter)],
        shared: true,
    },
    Plan {
        name: "elastic-approaches",
        title: "Elastic approaches",
        panels: &[("Inner contact", Quantity::ApproachInner), ("Outer contact", Quantity::ApproachOuter)],
        shared: true,
    },
    Plan {
        name: "peak-pressures",
        title: "Peak contact pressures",
        panels: &[("Inner contact", Quantity::PeakPressureInner), ("Outer contact", Quantity::PeakPressureOuter)],
        shared: true,
    },
    Plan {
        name: "longitudinal-traction",
        title: "Longitudinal traction forces",
        panels: &[("Inner contact", Quantity::TractionInner), ("Outer contact", Quantity::TractionOuter)],
        shared: false,
    },
    Plan {
        name: "slide-to-roll",
        title: "Longitudinal slide-to-roll ratios",
        panels: &[("Inner contact", Quantity::SlideToRollInner), ("Outer contact", Quantity::SlideToRollOuter)],
        shared: false,
    },
    Plan {
        name: "wear-rates",
        title: "Wear rates",
        panels: &[
            ("Inner race", Quantity::WearRateInner),
            ("Outer race", Quantity::WearRateOuter),
            ("Cage pocket", Quantity::WearRateCage),
        ],
        shared: false,
    },
    Plan {
        name: "orbital-speed",
        title: "Orbital speed of the balls",
        panels: &[("", Quantity::OrbitalSpeed)],
        shared: false,
    },
    Plan { name: "cage-force", title: "Ball–cage pocket force", panels: &[("", Quantity::CageForce)], shared: false },
    Plan {
        name: "power-losses",
        title: "Power losses of each ball",
        panels: &[
            ("Inner contact", Quantity::PowerLossInner),
            ("Outer contact", Quantity::PowerLossOuter),
            ("Drag and churning", Quantity::PowerLossFluid),
        ],
        shared: false,
    },
];

/// All quantities of the set.
#[cfg(test)]
pub(crate) fn drawn() -> impl Iterator<Item = Quantity> {
    PLANS.iter().flat_map(|plan| plan.panels.iter().map(|(_, quantity)| *quantity))
}

/// Draws the standard set over the azimuth: contact angles, loads, elastic approaches, peak pressures, longitudinal
/// traction, slide-to-roll ratios, wear rates, orbital speed, pocket force and power losses.
///
/// Every ball is marked, those without contact by a cross, which no line goes over. Figures are polar where no value is
/// negative by kind or by number and not all are zero; otherwise all their panels are over degrees.
///
/// Each run keeps its colour and dash in all figures. Jones–Harris runs appear only where that model says something:
/// not in traction, slip, wear, pocket force and losses; a figure left without runs is not made. A run that did not
/// converge says so in the legend.
///
/// # Errors
///
/// No runs, a run without balls, equal labels, points for a run that is not given, empty points, numbers that are not
/// finite.
pub fn solution_figures(runs: &[(&str, &Solution)], published: &[Published]) -> Result<Vec<Figure>, PlotError> {
    solution_charts(runs, published)?.iter().map(SolutionCharts::figure).collect()
}

/// The charts of one figure of the standard set.
#[derive(Debug, Clone, PartialEq)]
pub struct SolutionCharts {
    /// Short name in lower case and hyphens, fit for a file name.
    pub name: &'static str,
    /// Title above the panels.
    pub title: &'static str,
    /// The charts with what they show.
    pub panels: Vec<(Quantity, Panel)>,
}

impl SolutionCharts {
    /// The figure of them.
    ///
    /// # Errors
    ///
    /// Those of [`Figure::new`].
    pub fn figure(&self) -> Result<Figure, PlotError> {
        let panels: Vec<Panel> = self.panels.iter().map(|(_, panel)| panel.clone()).collect();
        Figure::new(self.name, self.title, &panels)
    }
}

/// The charts of [`solution_figures`], for what else belongs on them.
///
/// # Errors
///
/// No runs, a run without balls, equal labels, points for a run that is not given.
pub fn solution_charts(runs: &[(&str, &Solution)], published: &[Published]) -> Result<Vec<SolutionCharts>, PlotError> {
    check(runs, published)?;
    let mut figures = Vec::with_capacity(PLANS.len());
    for plan in &PLANS {
        let drawn =
            plan.panels.iter().map(|(heading, quantity)| (*heading, *quantity, series(runs, published, *quantity)));
        let drawn: Vec<(&str, Quantity, Vec<Series>)> =
            drawn.filter(|(_, _, series)| series.iter().any(|s| s.slot.is_some())).collect();
        if drawn.is_empty() {
            continue;
        }
        let polar = drawn.iter().all(|(_, quantity, series)| !quantity.signed() && fits_circle(series));
        let covered = plan.shared.then(|| range(drawn.iter().flat_map(|(_, _, series)| series))).flatten();
        let panels = drawn.into_iter().map(|(heading, quantity, series)| {
            let (label, unit, _) = quantity.axis();
            let axis = Axis { at_least: covered, ..Axis::new(label, unit) };
            (quantity, over_azimuth(heading, axis, series, polar))
        });
        figures.push(SolutionCharts { name: plan.name, title: plan.title, panels: panels.collect() });
    }
    Ok(figures)
}

fn check(runs: &[(&str, &Solution)], published: &[Published]) -> Result<(), PlotError> {
    if runs.is_empty() {
        return Err(PlotError::NoRun);
    }
    for (i, (label, solution)) in runs.iter().enumerate() {
        if solution.balls.is_empty() {
            return Err(PlotError::NoBalls { run: (*label).to_owned() });
        }
        if runs[..i].iter().any(|(other, _)| other == label) {
            return Err(PlotError::DuplicateLabel { label: (*label).to_owned() });
        }
    }
    for points in published {
        if let Some(run) = points.run.as_ref().filter(|run| runs.iter().all(|(label, _)| label != run)) {
            return Err(PlotError::UnknownRun { series: points.label.clone(), run: run.clone() });
        }
    }
    Ok(())
}

fn legend_label(label: &str, solution: &Solution) -> String {
    if solution.converged { label.to_owned() } else { format!("{label} (not converged)") }
}

/// All runs that have the quantity, and its published points, in the unit of the axis.
fn series(runs: &[(&str, &Solution)], published: &[Published], quantity: Quantity) -> Vec<Series> {
    let (_, _, factor) = quantity.axis();
    let lines = runs.iter().enumerate().filter_map(|(slot, (label, solution))| {
        if solution.model == Model::JonesHarris && quantity.needs_traction() {
            return None;
        }
        let found =
            |ball: &BallResult| quantity.found(ball).map(|value| (ball.azimuth_rad.to_degrees(), factor * value));
        let points = solution.balls.iter().filter_map(found).collect();
        let unloaded = solution.balls.iter().filter(|ball| quantity.found(ball).is_none());
        let line = Series::marked(legend_label(label, solution), points);
        let line = line.without(NO_CONTACT, unloaded.map(|ball| ball.azimuth_rad.to_degrees()).collect());
        Some(Series { slot: Some(slot), ..line })
    });
    let points = published.iter().filter(|p| p.quantity == quantity).map(|p| {
        let of = runs.iter().find(|(label, _)| p.run.as_deref() == Some(*label)).map(|(l, s)| legend_label(l, s));
        let scaled = p.points.iter().map(|(phi, value)| (*phi, factor * value)).collect();
        Series { of, uncertainty: p.uncertainty.map(|u| factor * u), ..Series::points(p.label.clone(), scaled) }
    });
    lines.chain(points).collect()
}

/// The range of all numbers; `None` where there are none.
fn range<'a>(series: impl Iterator<Item = &'a Series>) -> Option<(f64, f64)> {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = series.flat_map(Series::ordinates).fold(start, |(low, high), v| (low.min(v), high.max(v)));
    (low.is_finite() && high.is_finite()).then_some((low, high))
}

/// True if values can be told on a circle: none is negative, and not all are zero, which would be a dot.
pub(crate) fn fits_circle(series: &[Series]) -> bool {
    range(series.iter()).is_some_and(|(low, high)| low >= 0.0 && high > 0.0)
}

/// Values over the azimuth, polar or over degrees.
pub(crate) fn over_azimuth(title: &str, quantity: Axis, series: Vec<Series>, polar: bool) -> Panel {
    if polar {
        Panel::Polar(PolarChart::new(title, quantity, series))
    } else {
        Panel::Cartesian(LineChart::over_azimuth(title, quantity, series))
    }
}
