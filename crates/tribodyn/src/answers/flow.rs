//! The cryogen of a case: its phase, whether its mixture can exist, and what heat makes of a flow of it.

use super::Question;
use crate::error::AnswerError;
use serde::Serialize;
use tribodyn_case::{Case, Medium};
use tribodyn_fluid::{Fluid, Phase};

/// A flow through the bearing that has taken up heat.
#[derive(Debug, Clone, Serialize)]
pub struct HeatedFlowAnswer {
    /// Flow, kg/s.
    pub flow_kg_s: f64,
    /// Heat taken up, W.
    pub power_w: f64,
    /// Temperature at the inlet, K.
    pub inlet_temperature_k: f64,
    /// Density at the inlet, kg/m³.
    pub inlet_density_kg_m3: f64,
    /// Temperature at the outlet, K.
    pub outlet_temperature_k: f64,
    /// Density at the outlet, kg/m³, of the mixture where it boils.
    pub outlet_density_kg_m3: f64,
    /// Phase at the outlet; `boiling` where it is liquid and vapour.
    pub outlet_phase: String,
    /// Part of its mass that is vapour; absent where there is one phase.
    pub outlet_quality: Option<f64>,
}

/// The cryogen of a case with its temperature, K, and pressure, Pa.
fn cryogen(case: &Case) -> Option<(Fluid, f64, f64)> {
    match case.fluid.as_ref()?.medium {
        Medium::Nitrogen { temperature, pressure } => Some((Fluid::Nitrogen, temperature, pressure)),
        Medium::Oxygen { temperature, pressure } => Some((Fluid::Oxygen, temperature, pressure)),
        Medium::Methane { temperature, pressure } => Some((Fluid::Methane, temperature, pressure)),
        Medium::Custom { .. } => None,
    }
}

/// The phase of the case's cryogen.
pub(super) fn phase(case: &Case) -> Option<Phase> {
    let (fluid, temperature, pressure) = cryogen(case)?;
    fluid.phase(temperature, pressure).ok()
}

/// Sentences where a mixture of liquid and gas cannot be at the temperature and pressure of the case.
pub(super) fn fluid_warnings(case: &Case) -> Vec<String> {
    let (Some(spec), Some((fluid, temperature, pressure))) = (&case.fluid, cryogen(case)) else { return Vec::new() };
    if spec.liquid_fraction >= 1.0 {
        return Vec::new();
    }
    let share = format!("`fluid.liquid_fraction` {} with gas of {} kg/m³", spec.liquid_fraction, spec.gas_density);
    let state = format!("{fluid} at {temperature} K and {} MPa", pressure * 1e-6);
    let sentence = match fluid.phase(temperature, pressure) {
        Ok(Phase::DenseLiquid | Phase::Supercritical) => format!(
            "{state} is above the critical pressure of {:.3} MPa, where there are no bubbles: {share} is no state of it, but a choice of density",
            fluid.critical_pressure() * 1e-6
        ),
        Ok(Phase::Liquid) => match fluid.boiling(pressure) {
            Some(boiling) if boiling.temperature - temperature > BOILING_WITHIN => format!(
                "{state} is liquid, {:.1} K below boiling: {share} is no equilibrium of it; bubbles are left where it is heated or cavitates only",
                boiling.temperature - temperature
            ),
            _ => return Vec::new(),
        },
        _ => return Vec::new(),
    };
    vec![sentence]
}

/// Distance from boiling within which a mixture is taken as one in equilibrium, K.
const BOILING_WITHIN: f64 = 0.5;

/// State of a flow (kg/s) of the case's cryogen after it has taken up a power (W) at the case's pressure.
///
/// # Errors
/// A case without a cryogen, and more heat than the equations of state go.
pub fn heated_flow(question: &Question<'_>, flow: f64, power: f64) -> Result<HeatedFlowAnswer, AnswerError> {
    let Some((fluid, temperature, pressure)) = cryogen(question.case) else {
        return Err(AnswerError::argument("flow", flow, "the case has no cryogen whose enthalpy is known"));
    };
    let failed = |error: tribodyn_fluid::FluidError| AnswerError::argument("flow", flow, error.to_string());
    let out = fluid.heated((temperature, pressure), power, flow).map_err(failed)?;
    Ok(HeatedFlowAnswer {
        flow_kg_s: flow,
        power_w: power,
        inlet_temperature_k: temperature,
        inlet_density_kg_m3: fluid.density_at(temperature, pressure).map_err(failed)?,
        outlet_temperature_k: out.temperature,
        outlet_density_kg_m3: out.density,
        outlet_phase: out.phase.map_or("boiling".to_owned(), |phase| phase.to_string()),
        outlet_quality: out.quality,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn case(changes: &[(&str, &str)]) -> Case {
        let text = include_str!("../../../../fixtures/cases/paper-ag.ron").to_owned();
        let set = |text: String, (path, value): &(&str, &str)| tribodyn_case::set_value(&text, path, value).unwrap();
        Case::from_ron(&changes.iter().fold(text, set)).unwrap()
    }

    #[test]
    fn limit_a_mixture_that_cannot_exist_is_marked() {
        let paper = fluid_warnings(&case(&[]));
        assert!(paper.len() == 1 && paper[0].contains("critical pressure of 3.396 MPa"), "{paper:?}");
        assert!(fluid_warnings(&case(&[("fluid.liquid_fraction", "1")])).is_empty());
        let cold = fluid_warnings(&case(&[("fluid.medium", "Nitrogen(temperature: K(87.5), pressure: MPa(1))")]));
        assert!(cold.len() == 1 && cold[0].contains("16.2 K below boiling"), "{cold:?}");
        let boiling = case(&[("fluid.medium", "Nitrogen(temperature: K(87.5), pressure: MPa(0.29))")]);
        assert!(fluid_warnings(&boiling).is_empty());
        assert_eq!(phase(&case(&[])), Some(Phase::DenseLiquid));
    }
}
