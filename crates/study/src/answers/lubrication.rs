//! What a bearing runs with, in a line.

use super::Equations;
use tribodyn_case::{Case, CoatingSpec, CurveSpec, FluidSpec, Medium};

/// Coatings and fluid of a case, as the first lines of an answer say them.
pub fn lubrication(case: &Case, equations: Equations) -> String {
    if equations == Equations::JonesHarris {
        return "no part of this model: balls roll without friction".to_owned();
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
