//! Viscosity over pressure.

use crate::{LubricantError, Scalar, Walther, positive};

/// Dynamic viscosity over pressure, from that at ambient pressure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PressureViscosity {
    /// Barus: η = η0 exp(α p). Far too stiff above some 0.3 GPa: for comparison, not for traction.
    Barus {
        /// α, 1/Pa.
        coefficient: f64,
    },
    /// Roelands: η = η0 exp{(ln η0 + 9.67) [(1 + 5.1e-9 p)^Z − 1]}, η0 in Pa s and p in Pa.
    ///
    /// Source: C. J. A. Roelands, Correlational aspects of the viscosity–temperature–pressure relationship of
    /// lubricating oils, Delft 1966.
    Roelands {
        /// Z.
        index: f64,
    },
}

/// ln(η0/η∞) = ln η0 + 9.67 of Roelands, η∞ = 6.31e-5 Pa s.
const ROELANDS_SHIFT: f64 = 9.67;
/// Reciprocal of his 196.2 MPa, 1/Pa.
pub const ROELANDS_PRESSURE: f64 = 5.1e-9;
/// Pressure–viscosity coefficients that oils have, 1/GPa.
const COEFFICIENTS: [f64; 2] = [3.0, 60.0];

impl PressureViscosity {
    /// ln(η/η0) at a pressure in Pa over ln η0 + 9.67 for Roelands, over 1 for Barus: the part that does not depend on
    /// temperature.
    pub fn relative_log<D: Scalar>(&self, pressure: D) -> D {
        match *self {
            Self::Barus { coefficient } => pressure * coefficient,
            Self::Roelands { index } => ((pressure * ROELANDS_PRESSURE + 1.0).ln() * index).exp() - 1.0,
        }
    }

    /// Derivative of [`Self::relative_log`] by the pressure, 1/Pa.
    pub fn relative_log_slope(&self, pressure: f64) -> f64 {
        match *self {
            Self::Barus { coefficient } => coefficient,
            Self::Roelands { index } => {
                index * ROELANDS_PRESSURE * ((pressure * ROELANDS_PRESSURE + 1.0).ln() * (index - 1.0)).exp()
            }
        }
    }

    /// Factor of [`Self::relative_log`] at a viscosity at ambient pressure in Pa s.
    pub fn stiffness<D: Scalar>(&self, ambient: D) -> D {
        match self {
            Self::Barus { .. } => D::one(),
            Self::Roelands { .. } => ambient.ln() + ROELANDS_SHIFT,
        }
    }

    /// Dynamic viscosity at a pressure in Pa from that at ambient pressure, both Pa s.
    pub fn viscosity<D: Scalar>(&self, ambient: D, pressure: D) -> D {
        ambient * (self.relative_log(pressure) * self.stiffness(ambient)).exp()
    }

    /// Pressure–viscosity coefficient α = d ln η/dp at ambient pressure, 1/Pa.
    pub fn coefficient<D: Scalar>(&self, ambient: D) -> D {
        match *self {
            Self::Barus { coefficient } => D::from(coefficient),
            Self::Roelands { index } => (ambient.ln() + ROELANDS_SHIFT) * (index * ROELANDS_PRESSURE),
        }
    }
}

/// Roelands' Z from a pressure–viscosity coefficient in 1/Pa at a viscosity in Pa s.
///
/// # Errors
/// [`LubricantError::Range`] for a coefficient that no oil has, such as one in 1/GPa.
pub fn roelands_index(coefficient: f64, viscosity: f64) -> Result<f64, LubricantError> {
    let ([low, high], value) = (COEFFICIENTS, coefficient * 1e9);
    if !(low..=high).contains(&value) {
        let (quantity, unit) = ("pressure–viscosity coefficient", "1/GPa");
        return Err(LubricantError::Range { quantity, value, unit, low, high });
    }
    Ok(coefficient / (ROELANDS_PRESSURE * (positive("viscosity", viscosity, "Pa s")?.ln() + ROELANDS_SHIFT)))
}

/// Roelands' Z from a mean coefficient ln[η(p)/η0]/p in 1/Pa up to a pressure p in Pa, at a viscosity in Pa s.
///
/// # Errors
/// As [`roelands_index`].
pub fn roelands_index_of_mean(mean: f64, pressure: f64, viscosity: f64) -> Result<f64, LubricantError> {
    // Checks the coefficient and the viscosity.
    roelands_index(mean, viscosity)?;
    let rise = mean * pressure / (viscosity.ln() + ROELANDS_SHIFT);
    Ok((1.0 + rise).ln() / (1.0 + ROELANDS_PRESSURE * pressure).ln())
}

/// Pressure–viscosity coefficient by the correlation of So and Klaus, 1/Pa, from kinematic viscosity (m²/s), density
/// (kg/m³) at that temperature and the slope of Walther's equation. Its own error is about 15 % (B. Y. C. So and
/// E. E. Klaus, ASLE Trans. 23 (1980) 409).
pub fn so_klaus(kinematic: f64, density: f64, curve: &Walther) -> f64 {
    let log = (kinematic * crate::MM2_PER_M2).log10();
    let grams = density * 1e-3;
    let value = 1.216 + 4.143 * log.powf(3.0627) + 2.848e-4 * curve.slope.powf(5.1903) * log.powf(1.5976)
        - 3.999 * log.powf(3.0975) * grams.powf(0.1162);
    // The correlation has 1e-5 1/kPa.
    value * 1e-8
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    #[test]
    fn limit_at_ambient_pressure_roelands_is_barus() {
        let roelands = PressureViscosity::Roelands { index: roelands_index(20e-9, 0.02).unwrap() };
        assert!(f64::abs(roelands.coefficient(0.02) - 20e-9) < 1e-20);
        let slope = roelands.viscosity(Dual64::from(0.02), Dual64::from(0.0).derivative());
        assert!((slope.re - 0.02).abs() < 1e-16 && (slope.eps / 0.02 / 20e-9 - 1.0).abs() < 1e-12);
        let barus = PressureViscosity::Barus { coefficient: 20e-9 };
        assert!(roelands.viscosity(0.02, 1e9) < 0.01 * barus.viscosity(0.02, 1e9));
        for law in [roelands, barus] {
            let dual = law.relative_log(Dual64::from(0.7e9).derivative()).eps;
            assert!((law.relative_log_slope(0.7e9) / dual - 1.0).abs() < 1e-12);
        }
    }

    /// 68 mm²/s, 8.8 mm²/s at 100 °C and 870 kg/m³: near the 20 to 26 1/GPa of mineral oils.
    #[test]
    fn limit_so_klaus_of_a_mineral_oil() {
        let oil = Walther::through((313.15, 68e-6), (373.15, 8.8e-6)).unwrap();
        let at_40 = so_klaus(68e-6, 870.0, &oil) * 1e9;
        assert!((20.0..28.0).contains(&at_40), "{at_40}");
        assert!(so_klaus(oil.kinematic(373.15), 830.0, &oil) * 1e9 < at_40);
    }

    #[test]
    fn limit_a_coefficient_in_another_unit_is_refused() {
        assert!(roelands_index(20.0, 0.02).unwrap_err().to_string().contains("oils have 3 to 60 1/GPa"));
        assert!(roelands_index(f64::NAN, 0.02).is_err());
    }
}
