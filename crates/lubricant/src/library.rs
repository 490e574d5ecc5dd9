//! Base oils by stock and grade.

use crate::{
    GRADING_TEMPERATURE, LubricantError, MM2_PER_M2, Oil, PressureViscosity, Thermal, Walther, ZERO_CELSIUS,
    roelands_index_of_mean, viscosity_at_100,
};

/// Viscosity grades of ISO 3448, mm²/s at 40 °C: each stands for its value and 10 % to either side.
pub const GRADES: [f64; 20] = [
    2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0, 680.0, 1000.0, 1500.0,
    2200.0, 3200.0,
];

/// Film thickness of grease over that of its base oil once the bearing has run in and the contacts are starved.
///
/// A rule of thumb: measured ones lie between about 0.4 and 1.1 (P. M. Lugt, Grease Lubrication in Rolling Bearings,
/// Wiley 2013, ch. 9).
pub const GREASE_STARVATION: f64 = 0.7;

/// Pressure up to which the mean coefficients of the base stocks are, Pa.
const MEAN_PRESSURE: f64 = 0.2e9;

/// Base stock of an oil: it decides about pressure, heat and limiting shear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BaseStock {
    /// Paraffinic mineral oil.
    Mineral,
    /// Poly-α-olefin.
    Pao,
    /// Diester and polyol ester.
    Ester,
    /// Polyalkylene glycol.
    Polyglycol,
}

/// Typical numbers of a base stock.
struct Typical {
    name: &'static str,
    /// Viscosity index.
    index: f64,
    /// Density at 15 °C, kg/m³.
    density_15: f64,
    /// s (1/GPa) and t of ln[η(0.2 GPa)/η0]/0.2 GPa = s ν^t, ν in mm²/s.
    pressure: [f64; 2],
    thermal: Thermal,
    limiting_shear: f64,
}

impl BaseStock {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Mineral, Self::Pao, Self::Ester, Self::Polyglycol];

    /// Viscosity under pressure by P. W. Gold, A. Schmidt, H. Dicke, J. Loos and C. Assmann, J. Synth. Lubr. 18 (2001)
    /// 51; spread about 15 %. Densities, viscosity indices and thermal data: usual values of data sheets, spread 5, 10
    /// and 10 %. Limiting shear: disc machine traction of each stock at 1 GPa and 40 °C, spread 25 %.
    fn typical(self) -> Typical {
        let heat = |conductivity, specific_heat| Thermal { conductivity, specific_heat };
        match self {
            Self::Mineral => Typical {
                name: "mineral",
                index: 95.0,
                density_15: 880.0,
                pressure: [9.904, 0.1390],
                thermal: heat(0.135, 1950.0),
                limiting_shear: 0.07,
            },
            Self::Pao => Typical {
                name: "pao",
                index: 138.0,
                density_15: 835.0,
                pressure: [7.382, 0.1335],
                thermal: heat(0.15, 2150.0),
                limiting_shear: 0.045,
            },
            Self::Ester => Typical {
                name: "ester",
                index: 140.0,
                density_15: 940.0,
                pressure: [6.605, 0.1360],
                thermal: heat(0.15, 1950.0),
                limiting_shear: 0.045,
            },
            Self::Polyglycol => Typical {
                name: "polyglycol",
                index: 200.0,
                density_15: 1040.0,
                pressure: [5.489, 0.1485],
                thermal: heat(0.16, 1950.0),
                limiting_shear: 0.035,
            },
        }
    }

    /// Its name in the library.
    pub fn name(self) -> &'static str {
        self.typical().name
    }

    /// Mean pressure–viscosity coefficient up to 0.2 GPa at a kinematic viscosity in m²/s, 1/Pa. That at ambient
    /// pressure, [`Oil::pressure_coefficient`], is larger: viscosity rises the less the higher the pressure.
    pub fn mean_pressure_coefficient(self, kinematic: f64) -> f64 {
        let [s, t] = self.typical().pressure;
        s * 1e-9 * (kinematic * MM2_PER_M2).powf(t)
    }

    /// The oil of a grade of ISO 3448, with a viscosity index or the stock's usual one.
    ///
    /// # Errors
    /// [`LubricantError::Grade`] for a grade that the standard does not have, else as [`Self::with_viscosity`].
    pub fn oil(self, grade: f64, index: Option<f64>) -> Result<Oil, LubricantError> {
        if !GRADES.contains(&grade) {
            let known = GRADES.map(|grade| grade.to_string()).join(", ");
            return Err(LubricantError::Grade { grade, known });
        }
        let at_40 = grade / MM2_PER_M2;
        let at_100 = viscosity_at_100(at_40, index.unwrap_or(self.typical().index))?;
        self.with_viscosity(Walther::through((GRADING_TEMPERATURE, at_40), (ZERO_CELSIUS + 100.0, at_100))?)
    }

    /// The oil of a viscosity curve, all else as usual for the stock.
    ///
    /// # Errors
    /// [`LubricantError`] where the curve is none of an oil.
    pub fn with_viscosity(self, viscosity: Walther) -> Result<Oil, LubricantError> {
        let Typical { density_15, thermal, limiting_shear, .. } = self.typical();
        let unpressed = PressureViscosity::Roelands { index: 0.0 };
        let oil = Oil { viscosity, density_15, pressure: unpressed, thermal, limiting_shear };
        let at_40 = viscosity.kinematic(GRADING_TEMPERATURE);
        let mean = self.mean_pressure_coefficient(at_40);
        let index = roelands_index_of_mean(mean, MEAN_PRESSURE, oil.dynamic(GRADING_TEMPERATURE))?;
        Ok(Oil { pressure: PressureViscosity::Roelands { index }, ..oil })
    }
}

impl Oil {
    /// An oil of the library by its name: stock and grade, such as `mineral-vg68`.
    ///
    /// # Errors
    /// [`LubricantError::Unknown`] for another name, [`LubricantError::Grade`] for a grade that ISO 3448 does not have.
    pub fn library(name: &str) -> Result<Self, LubricantError> {
        let unknown = || LubricantError::Unknown { name: name.to_owned(), known: oil_names() };
        let (stock, grade) = name.split_once("-vg").ok_or_else(unknown)?;
        let stock = BaseStock::ALL.into_iter().find(|known| known.name() == stock).ok_or_else(unknown)?;
        stock.oil(grade.parse().map_err(|_| unknown())?, None)
    }
}

/// Names of the base stocks.
pub fn stock_names() -> Vec<&'static str> {
    BaseStock::ALL.map(BaseStock::name).to_vec()
}

/// How names of oils are made, for messages.
pub fn oil_names() -> String {
    format!("{} with a grade of ISO 3448 behind, as in mineral-vg68", stock_names().join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_every_stock_makes_oils_of_bearing_grades() {
        for stock in BaseStock::ALL {
            for grade in [10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0] {
                let oil = stock.oil(grade, None).unwrap();
                oil.check().unwrap();
                assert!((oil.kinematic_mm2_s(GRADING_TEMPERATURE) - grade).abs() < 1e-9 * grade);
                let ambient = oil.dynamic(GRADING_TEMPERATURE);
                let mean = (oil.pressure.viscosity(ambient, 0.2e9) / ambient).ln() / 0.2e9;
                let expected = stock.mean_pressure_coefficient(grade * 1e-6);
                let alpha = oil.pressure_coefficient(GRADING_TEMPERATURE);
                assert!((mean / expected - 1.0).abs() < 1e-12 && alpha > mean && alpha < 30e-9, "{mean:e} {alpha:e}");
                let PressureViscosity::Roelands { index } = oil.pressure else { panic!() };
                assert!((0.2..0.9).contains(&index), "{grade} {index}");
            }
        }
    }

    #[test]
    fn limit_names_and_grades_outside_the_library_are_refused() {
        assert_eq!(Oil::library("mineral-vg68").unwrap(), BaseStock::Mineral.oil(68.0, None).unwrap());
        assert!(Oil::library("mineral-vg70").unwrap_err().to_string().contains("46, 68, 100"));
        for name in ["mineral", "whale-vg68", "mineral-vgx", ""] {
            assert!(Oil::library(name).unwrap_err().to_string().contains("as in mineral-vg68"), "{name}");
        }
    }
}
