//! `tribodyn traction`: one traction curve.

use crate::failure::Failure;
use crate::table;
use serde::Serialize;
use std::io::Write;
use tribodyn_traction::{Coating, CoatingLaw, SlipCurve, TractionLaw};

/// Traction coefficient of a coating at a contact pressure, over slip in the unit of the coating's own data.
#[derive(clap::Args)]
pub struct Arguments {
    /// Coating of the library: ag or ptfe
    #[arg(long)]
    coating: String,
    /// Contact pressure, GPa
    #[arg(long, allow_hyphen_values = true)]
    pressure: f64,
    /// Slips, separated by commas
    #[arg(long, value_delimiter = ',', required = true, allow_hyphen_values = true)]
    slip: Vec<f64>,
    /// Order of the polynomials in pressure (2: through the three tested pressures)
    #[arg(long, default_value_t = 2)]
    order: usize,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    coefficient: Vec<f64>,
    slip: Vec<f64>,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    peak_slip: f64,
    peak_coefficient: f64,
    residual_coefficient: f64,
    pressure_gpa: f64,
    /// Outside the tested pressures, where the polynomials extrapolate.
    extrapolated: bool,
    /// Outside the pressures for which the fit may be used, whose nearest end is taken instead.
    clamped: bool,
    source: String,
}

fn refuse(option: &'static str, value: f64, message: &str) -> Result<(), Failure> {
    Err(Failure::Option { option, value: value.to_string(), message: message.into() })
}

/// Lowest and highest tested pressure, Pa.
fn tested_range(coating: &Coating) -> [f64; 2] {
    let pressures = || coating.tested.iter().map(|test| test.pressure);
    [pressures().fold(f64::INFINITY, f64::min), pressures().fold(f64::NEG_INFINITY, f64::max)]
}

/// What the reader must know about the pressure.
fn note(answer: &Answer, coating: &Coating) -> Option<String> {
    let range = |[low, high]: [f64; 2]| format!("{} to {} GPa", low * 1e-9, high * 1e-9);
    let (pressure, tested) = (answer.pressure_gpa, range(tested_range(coating)));
    if answer.clamped {
        let valid = range(coating.valid_pressure);
        Some(format!("{pressure} GPa is outside {valid}, where the fit may be used: the nearest of the two is taken"))
    } else if answer.extrapolated {
        Some(format!("{pressure} GPa is outside the tested {tested}: the curve is extrapolated"))
    } else {
        None
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let a = arguments;
    if !(a.pressure.is_finite() && a.pressure > 0.0) {
        refuse("pressure", a.pressure, "allowed is a pressure in GPa above 0")?;
    }
    if let Some(&slip) = a.slip.iter().find(|s| !(s.is_finite() && **s >= 0.0)) {
        refuse("slip", slip, "allowed are slips of 0 or more")?;
    }
    let coating = Coating::library(&a.coating)?;
    let law = CoatingLaw::varying(&coating, a.order)?;
    let pressure = a.pressure * 1e9;
    let curve = law.at(pressure);
    let peak = curve.peak();
    let [low, high] = tested_range(&coating);
    let answer = Answer {
        coefficient: a.slip.iter().map(|&s| curve.coefficient(s)).collect(),
        slip: a.slip.clone(),
        a: curve.a,
        b: curve.b,
        c: curve.c,
        d: curve.d(),
        peak_slip: peak.slip,
        peak_coefficient: peak.coefficient,
        residual_coefficient: peak.residual,
        pressure_gpa: a.pressure,
        extrapolated: !(low..=high).contains(&pressure),
        clamped: law.clamps(pressure),
        source: coating.source.clone(),
    };
    if a.json {
        return table::print_json(&answer);
    }
    if let Some(note) = note(&answer, &coating) {
        // If nobody listens, nothing can be done.
        let _ = writeln!(std::io::stderr(), "note: {note}");
    }
    let digits = |v: f64| format!("{v:.6}");
    table::print_pairs(&[
        ("A", digits(answer.a), ""),
        ("B", digits(answer.b), "per slip"),
        ("C", digits(answer.c), "per slip"),
        ("D", digits(answer.d), ""),
        ("peak slip", digits(answer.peak_slip), "slip"),
        ("peak coefficient", digits(answer.peak_coefficient), ""),
    ])?;
    let rows = answer.slip.iter().zip(&answer.coefficient).map(|(s, k)| vec![s.to_string(), digits(*k)]);
    table::print_rows(&["slip", "coefficient"], rows)
}
