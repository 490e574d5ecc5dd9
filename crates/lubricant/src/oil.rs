//! An oil: viscosity over temperature and pressure, density, heat.

use crate::{LubricantError, MM2_PER_M2, PressureViscosity, Scalar, Walther, ZERO_CELSIUS, positive};

/// Thermal data of an oil.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thermal {
    /// Thermal conductivity, W/(m K).
    pub conductivity: f64,
    /// Specific heat, J/(kg K).
    pub specific_heat: f64,
}

/// An oil, or the base oil of a grease.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oil {
    /// Kinematic viscosity over temperature.
    pub viscosity: Walther,
    /// Density at 15 °C, kg/m³.
    pub density_15: f64,
    /// Viscosity over pressure.
    pub pressure: PressureViscosity,
    /// Thermal data.
    pub thermal: Thermal,
    /// Limiting shear stress over pressure at 40 °C, Λ.
    pub limiting_shear: f64,
}

/// Thermal expansion of oils, 1/K.
const EXPANSION: f64 = 0.00065;
/// Temperature of the standard density, K.
const STANDARD_TEMPERATURE: f64 = 288.0;
/// Temperatures between which oils are used and the formulas hold, °C.
const TEMPERATURES_C: [f64; 2] = [-60.0, 300.0];
/// Densities that oils have, kg/m³.
const DENSITIES: [f64; 2] = [600.0, 2000.0];
/// Fall of the limiting shear stress with temperature: exp[B (1/T − 1/T_40)] with B in K. Source: L. Houpert,
/// L. Flamand and D. Berthe, ASME J. Lubr. Technol. 103 (1981) 526.
const SHEAR_FALL: f64 = 585.0;

impl Oil {
    /// Checks density, thermal data and limiting shear stress.
    ///
    /// # Errors
    /// [`LubricantError`] for values that no oil has.
    pub fn check(&self) -> Result<(), LubricantError> {
        let within = |quantity, value: f64, unit, [low, high]: [f64; 2]| {
            if (low..=high).contains(&value) {
                Ok(())
            } else {
                Err(LubricantError::Range { quantity, value, unit, low, high })
            }
        };
        within("density at 15 °C", self.density_15, "kg/m³", DENSITIES)?;
        within("thermal conductivity", self.thermal.conductivity, "W/(m K)", [0.05, 0.7])?;
        within("specific heat", self.thermal.specific_heat, "J/(kg K)", [800.0, 5000.0])?;
        within("limiting shear stress over pressure", self.limiting_shear, "", [0.01, 0.2])
    }

    /// Checks that a temperature in K is one at which oils are used.
    ///
    /// # Errors
    /// [`LubricantError::Range`] outside −60 to 300 °C.
    pub fn check_temperature(temperature: f64) -> Result<(), LubricantError> {
        let ([low, high], value) = (TEMPERATURES_C, temperature - ZERO_CELSIUS);
        if (low..=high).contains(&value) {
            return Ok(());
        }
        Err(LubricantError::Range { quantity: "temperature", value, unit: "°C", low, high })
    }

    /// Density at a temperature in K, kg/m³.
    pub fn density<D: Scalar>(&self, temperature: D) -> D {
        ((temperature - STANDARD_TEMPERATURE) * EXPANSION + 1.0).recip() * self.density_15
    }

    /// Dynamic viscosity at ambient pressure and a temperature in K, Pa s.
    pub fn dynamic<D: Scalar>(&self, temperature: D) -> D {
        self.viscosity.kinematic(temperature) * self.density(temperature)
    }

    /// Pressure–viscosity coefficient at a temperature in K, 1/Pa.
    pub fn pressure_coefficient<D: Scalar>(&self, temperature: D) -> D {
        self.pressure.coefficient(self.dynamic(temperature))
    }

    /// Fall of viscosity with temperature β = −d ln η/dT at ambient pressure, 1/K.
    pub fn temperature_coefficient(&self, temperature: f64) -> f64 {
        let dual = self.dynamic(num_dual::Dual64::from(temperature).derivative());
        -dual.eps / dual.re
    }

    /// Limiting shear stress over pressure at a temperature in K.
    pub fn limiting_shear_at<D: Scalar>(&self, temperature: D) -> D {
        ((temperature.recip() - 1.0 / crate::GRADING_TEMPERATURE) * SHEAR_FALL).exp() * self.limiting_shear
    }

    /// Kinematic viscosity at a temperature in K, mm²/s, as the standards have it.
    pub fn kinematic_mm2_s(&self, temperature: f64) -> f64 {
        self.viscosity.kinematic(temperature) * MM2_PER_M2
    }
}

/// Checks a starvation factor.
///
/// # Errors
/// [`LubricantError::Range`] unless it lies above 0 and at most 1.
pub(crate) fn check_starvation(factor: f64) -> Result<f64, LubricantError> {
    positive("starvation factor", factor, "")?;
    if factor <= 1.0 {
        return Ok(factor);
    }
    Err(LubricantError::Range { quantity: "starvation factor", value: factor, unit: "", low: 0.0, high: 1.0 })
}

#[cfg(test)]
mod tests {
    use crate::BaseStock;
    use num_dual::Dual64;

    #[test]
    fn limit_density_and_viscosity_fall_with_temperature() {
        let oil = BaseStock::Mineral.oil(68.0, None).unwrap();
        assert!((oil.density(288.0) - oil.density_15).abs() < 1e-9 && oil.density(363.0) < oil.density_15);
        let [cold, warm] = [313.15, 343.15].map(|t| oil.dynamic(t));
        assert!(cold > 3.0 * warm && oil.limiting_shear_at(343.15) < oil.limiting_shear);
        assert!((oil.limiting_shear_at(313.15) - oil.limiting_shear).abs() < 1e-15);
        let beta = oil.temperature_coefficient(343.15);
        assert!((0.02..0.06).contains(&beta), "{beta} 1/K");
        let slope = oil.dynamic(Dual64::from(343.15).derivative()).eps;
        let difference = (oil.dynamic(343.16) - oil.dynamic(343.14)) / 0.02;
        assert!((slope / difference - 1.0).abs() < 1e-5);
    }

    #[test]
    fn limit_temperatures_of_no_oil_are_refused() {
        assert!(super::Oil::check_temperature(343.15).is_ok());
        // 70 K instead of 70 °C.
        assert!(super::Oil::check_temperature(70.0).unwrap_err().to_string().contains("-60 to 300 °C"));
        assert!(super::check_starvation(0.0).is_err() && super::check_starvation(1.2).is_err());
    }
}
