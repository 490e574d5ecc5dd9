//! Kinematic viscosity over temperature.

use crate::{LubricantError, MM2_PER_M2, Scalar, ZERO_CELSIUS, positive};

/// Kinematic viscosity by Walther's equation, log log(ν + 0.7) = A − B log T with ν in mm²/s and T in K.
///
/// Source: C. Walther, Erdöl und Teer 7 (1931) 382; ASTM D341, which has 0.7 for ν above 2 mm²/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walther {
    /// A.
    pub intercept: f64,
    /// B.
    pub slope: f64,
}

/// Constant that Walther adds to the viscosity, mm²/s.
const SHIFT: f64 = 0.7;
/// Viscosities between which two points are taken for those of an oil, mm²/s.
const VISCOSITIES: [f64; 2] = [0.5, 1e5];

impl Walther {
    /// The curve through two points, each (temperature in K, kinematic viscosity in m²/s).
    ///
    /// # Errors
    /// [`LubricantError`] for viscosities that no oil has, and for two points between which viscosity does not fall.
    pub fn through(first: (f64, f64), second: (f64, f64)) -> Result<Self, LubricantError> {
        let (cold, hot) = if first.0 <= second.0 { (first, second) } else { (second, first) };
        for (temperature, viscosity) in [cold, hot] {
            positive("temperature", temperature, "K")?;
            let (value, [low, high]) = (viscosity * MM2_PER_M2, VISCOSITIES);
            if !(low..=high).contains(&value) {
                return Err(LubricantError::Range { quantity: "viscosity", value, unit: "mm²/s", low, high });
            }
        }
        if hot.0 <= cold.0 || hot.1 >= cold.1 {
            return Err(LubricantError::Rising {
                cold: cold.1 * MM2_PER_M2,
                cold_c: cold.0 - ZERO_CELSIUS,
                hot: hot.1 * MM2_PER_M2,
                hot_c: hot.0 - ZERO_CELSIUS,
            });
        }
        let [top, bottom] = [cold, hot].map(|(_, viscosity)| (viscosity * MM2_PER_M2 + SHIFT).log10().log10());
        let slope = (top - bottom) / (hot.0 / cold.0).log10();
        Ok(Self { intercept: top + slope * cold.0.log10(), slope })
    }

    /// Kinematic viscosity at a temperature in K, m²/s.
    pub fn kinematic<D: Scalar>(&self, temperature: D) -> D {
        let exponent = temperature.ln() * (-self.slope) + self.intercept * std::f64::consts::LN_10;
        ((exponent.exp() * std::f64::consts::LN_10).exp() - SHIFT) / MM2_PER_M2
    }

    /// Temperature at which the oil has a kinematic viscosity in m²/s, K.
    pub fn temperature_of(&self, kinematic: f64) -> f64 {
        let double_log = (kinematic * MM2_PER_M2 + SHIFT).log10().log10();
        10f64.powf((self.intercept - double_log) / self.slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn oil(at_40: f64, at_100: f64) -> Walther {
        Walther::through((ZERO_CELSIUS + 40.0, at_40 * 1e-6), (ZERO_CELSIUS + 100.0, at_100 * 1e-6)).unwrap()
    }

    /// Values worked out beside this program from the equation of ASTM D341.
    #[test]
    fn code_walther_of_two_oils() {
        for (at_40, at_100, celsius, expected) in [
            (68.0, 8.8, 60.0, 28.8244),
            (68.0, 8.8, 70.0, 20.2794),
            (68.0, 8.8, 80.0, 14.8604),
            (404.0, 28.0, 60.0, 132.126),
        ] {
            let found = oil(at_40, at_100).kinematic(ZERO_CELSIUS + celsius) * 1e6;
            assert!((found / expected - 1.0).abs() < 4e-6, "{found} {expected}");
        }
    }

    #[test]
    fn identity_temperature_of_a_viscosity() {
        let oil = oil(68.0, 8.8);
        assert!((oil.temperature_of(oil.kinematic(330.0)) - 330.0).abs() < 1e-9);
    }

    #[test]
    fn limit_viscosity_that_rises_and_unit_slips_are_refused() {
        let at = |cold: f64, hot: f64| Walther::through((313.15, cold), (373.15, hot)).unwrap_err().to_string();
        assert!(at(8e-6, 68e-6).contains("falls with temperature"));
        assert!(at(68e-6, 68e-6).contains("68 mm²/s at 40 °C"));
        // 68 mm²/s as if it were m²/s, and the other way round.
        assert!(at(68.0, 8.8).contains("68000000 mm²/s: oils have 0.5 to 100000"));
        assert!(at(68e-12, 8.8e-12).contains("oils have"));
        assert!(Walther::through((f64::NAN, 1e-5), (373.15, 1e-6)).is_err());
    }
}
