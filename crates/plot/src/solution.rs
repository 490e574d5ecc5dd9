//! The standard figures of quasi-static solutions: one run, or several compared.

use tribodyn_quasistatic::{Model, Solution};

use crate::error::PlotError;
use crate::figure::{Figure, Panel};
use crate::polar::PolarChart;
use crate::quantity::Quantity;
use crate::series::{Axis, Series};

/// Published values of one quantity over the azimuth.
#[derive(Debug, Clone, PartialEq)]
pub struct Published {
    /// What was published.
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

/// One figure of the set.
struct Plan {
    name: &'static str,
    title: &'static str,
    panels: &'static [(&'static str, Quantity)],
    /// Whether all panels have the same radial axis, because their values are to be compared.
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

/// Draws the standard set over the azimuth: contact angles, loads, elastic approaches, peak pressures, longitudinal traction,
/// slide-to-roll ratios, wear rates, orbital speed, pocket force and power losses.
///
/// Each run keeps its colour and dash in all figures. Jones–Harris runs appear only where that model says something: not in
/// traction, slip, wear, pocket force and losses; a figure left without runs is not made. A run that did not converge says so
/// in the legend.
///
/// # Errors
///
/// No runs, a run without balls, equal labels, points for a run that is not given, empty points, numbers that are not finite.
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
    pub panels: Vec<(Quantity, PolarChart)>,
}

impl SolutionCharts {
    /// The figure of them.
    ///
    /// # Errors
    ///
    /// Those of [`Figure::new`].
    pub fn figure(&self) -> Result<Figure, PlotError> {
        let panels: Vec<Panel> = self.panels.iter().map(|(_, chart)| Panel::Polar(chart.clone())).collect();
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
        let mut panels = Vec::with_capacity(plan.panels.len());
        for (heading, quantity) in plan.panels {
            let series = series(runs, published, *quantity);
            if series.iter().any(|s| s.slot.is_some()) {
                let (label, unit, _) = quantity.axis();
                panels.push((*quantity, PolarChart::new(*heading, Axis::new(label, unit), series)));
            }
        }
        if panels.is_empty() {
            continue;
        }
        if plan.shared {
            share_axis(&mut panels);
        }
        figures.push(SolutionCharts { name: plan.name, title: plan.title, panels });
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
        let points = solution.balls.iter().map(|ball| (ball.azimuth_deg, factor * quantity.of(ball))).collect();
        Some(Series { slot: Some(slot), ..Series::marked(legend_label(label, solution), points) })
    });
    let points = published.iter().filter(|p| p.quantity == quantity).map(|p| {
        let of = runs.iter().find(|(label, _)| p.run.as_deref() == Some(*label)).map(|(l, s)| legend_label(l, s));
        let scaled = p.points.iter().map(|(phi, value)| (*phi, factor * value)).collect();
        Series { of, uncertainty: p.uncertainty.map(|u| factor * u), ..Series::points(p.label.clone(), scaled) }
    });
    lines.chain(points).collect()
}

/// Gives all panels the range of all.
fn share_axis(panels: &mut [(Quantity, PolarChart)]) {
    let values = panels.iter().flat_map(|(_, p)| &p.series).flat_map(Series::ordinates);
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low.is_finite() && high.is_finite() {
        for (_, panel) in panels {
            panel.radial.at_least = Some((low, high));
        }
    }
}
