//! The traction curve of a coating at one pressure.

use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_traction::{Coating, CoatingLaw, SlipCurve, TractionLaw};

/// A curve, over slip in the unit of the coating's own data.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveAnswer {
    /// Traction coefficient at each slip.
    pub coefficient: Vec<f64>,
    /// Slips that were asked for.
    pub slip: Vec<f64>,
    /// Parameter A of the curve.
    pub a: f64,
    /// Parameter B, per slip.
    pub b: f64,
    /// Parameter C, per slip.
    pub c: f64,
    /// Parameter D.
    pub d: f64,
    /// Slip of the largest coefficient.
    pub peak_slip: f64,
    /// Largest coefficient.
    pub peak_coefficient: f64,
    /// Coefficient at large slip.
    pub residual_coefficient: f64,
    /// Contact pressure, GPa.
    pub pressure_gpa: f64,
    /// Outside the tested pressures, where the polynomials extrapolate.
    pub extrapolated: bool,
    /// Outside the pressures for which the fit may be used, whose nearest end is taken instead.
    pub clamped: bool,
    /// Where the data of the coating come from.
    pub source: String,
    /// Note on a pressure outside the tested or the valid range.
    #[serde(skip)]
    pub note: Option<String>,
}

/// The curve of a coating of the library at a pressure, by polynomials of this order in pressure.
///
/// # Errors
/// A coating that the library does not have, or a value that is refused.
pub fn traction_curve(
    coating: &str,
    pressure_gpa: f64,
    slip: &[f64],
    order: usize,
) -> Result<CurveAnswer, AnswerError> {
    if !(pressure_gpa.is_finite() && pressure_gpa > 0.0) {
        return Err(AnswerError::argument("pressure", pressure_gpa, "allowed is a pressure in GPa above 0"));
    }
    if let Some(slip) = slip.iter().find(|s| !(s.is_finite() && **s >= 0.0)) {
        return Err(AnswerError::argument("slip", slip, "allowed are slips of 0 or more"));
    }
    let coating = Coating::library(coating)?;
    let law = CoatingLaw::varying(&coating, order)?;
    let pressure = pressure_gpa * 1e9;
    let curve = law.at(pressure);
    let peak = curve.peak();
    let [low, high] = tested_range(&coating);
    let (extrapolated, clamped) = (!(low..=high).contains(&pressure), law.clamps(pressure));
    Ok(CurveAnswer {
        coefficient: slip.iter().map(|&s| curve.coefficient(s)).collect(),
        slip: slip.to_vec(),
        a: curve.a,
        b: curve.b,
        c: curve.c,
        d: curve.d(),
        peak_slip: peak.slip,
        peak_coefficient: peak.coefficient,
        residual_coefficient: peak.residual,
        pressure_gpa,
        extrapolated,
        clamped,
        source: coating.source.clone(),
        note: note(pressure_gpa, [extrapolated, clamped], &coating),
    })
}

/// Lowest and highest tested pressure, Pa.
fn tested_range(coating: &Coating) -> [f64; 2] {
    let pressures = || coating.tested.iter().map(|test| test.pressure);
    [pressures().fold(f64::INFINITY, f64::min), pressures().fold(f64::NEG_INFINITY, f64::max)]
}

fn note(pressure: f64, [extrapolated, clamped]: [bool; 2], coating: &Coating) -> Option<String> {
    let range = |[low, high]: [f64; 2]| format!("{} to {} GPa", low * 1e-9, high * 1e-9);
    let tested = range(tested_range(coating));
    if clamped {
        let valid = range(coating.valid_pressure);
        Some(format!("{pressure} GPa is outside {valid}, where the fit may be used: the nearest of the two is taken"))
    } else if extrapolated {
        Some(format!("{pressure} GPa is outside the tested {tested}: the curve is extrapolated"))
    } else {
        None
    }
}
