//! Lubrication of a bearing, in a line.

use super::Equations;
use crate::error::AnswerError;
use tribodyn_case::{Case, CoatingSpec, CurveSpec, FluidSpec, LubricantSpec, Medium, OilSpec};
use tribodyn_catalogue::NewLubricant;
use tribodyn_lubricant::{LubricantError, Oil, Supply, ZERO_CELSIUS};

/// An oil by its name in the library, or by its grade alone as for a new case: `pao-vg32`, `vg68`.
///
/// # Errors
/// [`LubricantError`] for an oil that the library does not have.
pub(super) fn named_oil(word: &str) -> Result<Oil, LubricantError> {
    match NewLubricant::parse(word) {
        Ok(NewLubricant::Oil(name)) => Oil::library(&name),
        _ => Oil::library(word),
    }
}

/// Refuses a word that names no lubricant of a new case, or an oil that the library does not have.
///
/// # Errors
/// As said.
pub fn check_lubricant(word: &str) -> Result<(), AnswerError> {
    match NewLubricant::parse(word) {
        Ok(NewLubricant::Oil(name)) => Ok(Oil::library(&name).map(drop)?),
        Err(error) if word != "usual" => Err(error.into()),
        _ => Ok(()),
    }
}

/// Lubricant, or coatings, and fluid of a case, as the first lines of an answer say them.
pub fn lubrication(case: &Case, equations: Equations) -> String {
    if equations == Equations::JonesHarris {
        return "no part of this model: balls roll without friction".to_owned();
    }
    if let Some(lubricant) = &case.lubricant {
        return oil(lubricant);
    }
    let surfaces = case.coatings.as_ref().map_or_else(
        || "bare races".to_owned(),
        |coatings| match [&coatings.inner, &coatings.outer].map(named) {
            [inner, outer] if inner == outer => format!("{inner} on both races"),
            [inner, outer] => format!("{inner} on the inner race, {outer} on the outer"),
        },
    );
    match &case.fluid {
        Some(fluid) => format!("{surfaces}, {}", medium(fluid)),
        None => format!("{surfaces}, dry"),
    }
}

/// Oil or grease at its temperature.
fn oil(lubricant: &LubricantSpec) -> String {
    let name = match &lubricant.oil {
        OilSpec::Library(name) => name.clone(),
        OilSpec::Grade { stock, vg, .. } => format!("{} VG {vg}", stock.name()),
        OilSpec::Viscosities { stock, .. } => format!("{} by its data sheet", stock.name()),
    };
    let temperature = lubricant.temperature - ZERO_CELSIUS;
    match lubricant.supply {
        Supply::Grease => format!("grease on {name} at {temperature:.0} °C"),
        _ => format!("oil {name} at {temperature:.0} °C"),
    }
}

/// A coating by its curve; its tests were those of a solid film, whatever the bearing has.
fn named(coating: &CoatingSpec) -> String {
    match &coating.curve {
        CurveSpec::Library(name) => format!("solid film `{name}`"),
        CurveSpec::Tested(_) => "solid film with the case's own curve".to_owned(),
    }
}

fn medium(fluid: &FluidSpec) -> String {
    let cryogen = |name: &str, temperature: f64, pressure: f64| {
        format!("balls in {name} at {temperature} K and {} MPa", pressure * 1e-6)
    };
    match fluid.medium {
        Medium::Nitrogen { temperature, pressure } => cryogen("nitrogen", temperature, pressure),
        Medium::Oxygen { temperature, pressure } => cryogen("oxygen", temperature, pressure),
        Medium::Methane { temperature, pressure } => cryogen("methane", temperature, pressure),
        Medium::Custom { density, .. } => format!("balls in a fluid of {density} kg/m³"),
    }
}
