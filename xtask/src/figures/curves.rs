//! Figures 9 and 15: the traction curves at the tested pressures and what of them varies with pressure.

use super::Entry;
use crate::error::Failure;
use tribodyn_bearing::traction::{Coating, CoatingLaw, SlipCurve, TractionLaw};
use tribodyn_plot::{Axis, Figure, LineChart, Panel, Series};

/// Coatings of Table 2.
const COATINGS: [(&str, &str); 2] = [("ag", "Ag"), ("ptfe", "PTFE")];
/// Slip up to which curves are drawn, in the unit of the tests.
const SLIP_MAX: f64 = 15.0;
/// Points of a curve.
const POINTS: u32 = 200;

pub fn all() -> Result<Vec<Entry>, Failure> {
    let slip = Axis::new("Slip", "unit of the tests");
    let (mut curves, mut parameters) = (Vec::new(), Vec::new());
    for (name, label) in COATINGS {
        let coating = Coating::library(name)?;
        let law = CoatingLaw::varying(&coating, 2)?;
        let series = coating.tested.iter().map(|test| curve(&law, test.pressure)).collect();
        let kappa = Axis::new("Traction coefficient", "–").covering(0.0, 0.15);
        curves.push(Panel::Cartesian(LineChart::new(label, slip.clone(), kappa, series)));
        parameters.push(Panel::Cartesian(peaks(label, &coating, &law)));
    }
    let curves = Figure::new("fig09-curves", "Traction curves at the tested pressures", &curves)?;
    let parameters = Figure::new("fig15-parameters", "Peak and residual coefficient over pressure", &parameters)?;
    Ok(vec![
        Entry {
            of: "9",
            caption: "The curves of Table 2, as `tribodyn traction --coating ag --pressure 2.5` has them.",
            figure: curves,
        },
        Entry {
            of: "15",
            caption: "Parabolas through the tests of Table 2 (marked), drawn over the range in which they are used.",
            figure: parameters,
        },
    ])
}

fn curve(law: &CoatingLaw, pressure: f64) -> Series {
    let kappa = law.at(pressure);
    let points = (0..=POINTS).map(|i| f64::from(i) * SLIP_MAX / f64::from(POINTS));
    Series::line(format!("{} GPa", pressure * 1e-9), points.map(|s| (s, kappa.coefficient(s))).collect())
}

fn peaks(title: &str, coating: &Coating, law: &CoatingLaw) -> LineChart {
    let [low, high] = law.fit().valid_pressure;
    let pressures = (0..=POINTS).map(|i| low + (high - low) * f64::from(i) / f64::from(POINTS));
    let over = |label: &str, get: fn(tribodyn_bearing::traction::Peak) -> f64| {
        Series::line(label, pressures.clone().map(|p| (p * 1e-9, get(law.fit().peak(p)))).collect())
    };
    let tested = |label: &str, get: fn(tribodyn_bearing::traction::Peak) -> f64| {
        Series::points(label, coating.tested.iter().map(|t| (t.pressure * 1e-9, get(t.peak))).collect())
    };
    let series = vec![
        over("peak coefficient", |p| p.coefficient),
        over("residual coefficient", |p| p.residual),
        tested("tested, peak", |p| p.coefficient),
        tested("tested, residual", |p| p.residual),
    ];
    LineChart::new(title, Axis::new("Peak pressure", "GPa"), Axis::new("Coefficient", "–"), series)
}
