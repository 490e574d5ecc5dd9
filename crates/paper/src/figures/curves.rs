//! Figures 9 and 15: the traction curves at the tested pressures and what of them varies with pressure.

use super::runs::Made;
use super::spec::Spec;
use crate::error::PaperError;
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Place, Reference, Series};
use tribodyn_traction::{Coating, CoatingLaw, Peak, SlipCurve, TractionLaw};

/// Coatings of Table 2.
const COATINGS: [(&str, &str); 2] = [("ag", "Ag coating"), ("ptfe", "PTFE film")];
/// Slip up to which curves are drawn, in the unit of the tests.
const SLIP_MAX: f64 = 15.0;
/// Points of a curve.
const POINTS: u32 = 200;
/// Order of the paper's fits.
const PARABOLA: usize = 2;
/// Pressures of the bearing's contacts in section 5.1.1, and the limits that it sets to the fits, GPa.
const OF_THE_BEARING: Place = Place::Between(1.79, 2.46);
const LIMITS: [f64; 2] = [1.5, 4.0];

/// A parameter that varies with pressure: title, axis and value.
type Parameter = (&'static str, &'static str, &'static str, fn(Peak) -> f64);

const PARAMETERS: [Parameter; 3] = [
    ("Slip at the peak", "Slip", "unit of the tests", |p| p.slip),
    ("Peak coefficient", "Coefficient", "–", |p| p.coefficient),
    ("Residual coefficient", "Coefficient", "–", |p| p.residual),
];

pub fn curves(spec: &Spec, _: &Made) -> Result<Figure, PaperError> {
    let mut panels = Vec::new();
    for (name, label) in COATINGS {
        let coating = Coating::library(name)?;
        let law = CoatingLaw::varying(&coating, PARABOLA)?;
        let mut series: Vec<Series> = coating.tested.iter().map(|test| curve(&law, test.pressure)).collect();
        let peaks = coating.tested.iter().map(|test| (test.peak.slip, test.peak.coefficient)).collect();
        series.push(Series::points("published (Table 2): peaks", peaks));
        let kappa = Axis::new("Traction coefficient", "–").covering(0.0, 0.15);
        panels.push(Panel::Cartesian(LineChart::new(label, Axis::new("Slip", "unit of the tests"), kappa, series)));
    }
    Ok(Figure::new(spec.name, spec.title, &panels)?)
}

fn curve(law: &CoatingLaw, pressure: f64) -> Series {
    let kappa = law.at(pressure);
    let points = (0..=POINTS).map(|i| f64::from(i) * SLIP_MAX / f64::from(POINTS));
    Series::line(format!("{:.1} GPa", pressure * 1e-9), points.map(|s| (s, kappa.coefficient(s))).collect())
}

pub fn parameters(spec: &Spec, _: &Made) -> Result<Figure, PaperError> {
    let panels = PARAMETERS.iter().map(|parameter| parameter_chart(parameter).map(Panel::Cartesian));
    Ok(Figure::new(spec.name, spec.title, &panels.collect::<Result<Vec<_>, _>>()?)?)
}

fn parameter_chart((title, quantity, unit, get): &Parameter) -> Result<LineChart, PaperError> {
    let mut series = Vec::new();
    for (name, label) in COATINGS {
        let coating = Coating::library(name)?;
        let law = CoatingLaw::varying(&coating, PARABOLA)?;
        let [low, high] = law.fit().valid_pressure;
        let pressures = (0..=POINTS).map(|i| low + (high - low) * f64::from(i) / f64::from(POINTS));
        series.push(Series::line(label, pressures.map(|p| (p * 1e-9, get(law.fit().peak(p)))).collect()));
        let tested = coating.tested.iter().map(|t| (t.pressure * 1e-9, get(t.peak))).collect();
        series.push(Series {
            of: Some(label.to_owned()),
            ..Series::points(format!("published (Table 2), {label}"), tested)
        });
    }
    let axis = Axis::new("Peak pressure", "GPa").covering(1.25, 4.25);
    let mut chart = LineChart::new(*title, axis, Axis::new(*quantity, *unit), series);
    let limit = |p| Reference::new("published limits of use: 1.5 and 4 GPa", Place::At(p));
    chart.references.extend(LIMITS.map(limit));
    chart.references.push(Reference::new("published pressures of the bearing: 1.79–2.46 GPa", OF_THE_BEARING));
    chart.area_px = [300.0, 250.0];
    Ok(chart)
}
