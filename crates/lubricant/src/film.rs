//! Thickness of the film between two elastic bodies that roll, and the resistance of its inlet.

use crate::oil::check_starvation;
use crate::{LubricantError, Oil, Scalar, positive};

/// A contact as the film formulas see it, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingContact<D = f64> {
    /// Normal load Q, N.
    pub load: D,
    /// Entrainment speed u, the mean of both surface speeds against the contact, m/s.
    pub entrainment: D,
    /// Slide-to-roll ratio, sliding over entrainment speed.
    pub slide_to_roll: D,
    /// Radius of relative curvature along rolling R_x, m.
    pub rolling_radius: D,
    /// Radius of relative curvature across rolling R_y, m.
    pub lateral_radius: f64,
    /// Ellipticity k = a/b: across rolling over along it.
    pub ellipticity: D,
    /// Highest pressure, Pa.
    pub peak_pressure: D,
    /// Effective modulus E' = 2/Σ(1 − ν²)/E, Pa.
    pub effective_modulus: f64,
}

/// A film, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmThickness<D = f64> {
    /// Central thickness h_c.
    pub central: D,
    /// Least thickness h_min, in the constriction at the sides.
    pub minimum: D,
}

/// The oil before the contacts of a bearing, and what they make of it, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InletFilm {
    /// Dynamic viscosity at ambient pressure, Pa s.
    pub viscosity: f64,
    /// Pressure–viscosity coefficient α, 1/Pa.
    pub pressure_coefficient: f64,
    /// Fall of viscosity with temperature β = −d ln η/dT, 1/K.
    pub temperature_coefficient: f64,
    /// Thermal conductivity, W/(m K).
    pub conductivity: f64,
    /// Film thickness over that of a fully flooded contact.
    pub starvation: f64,
    /// Roughness of both surfaces together, sqrt(R_q1² + R_q2²), m.
    pub roughness: f64,
}

/// Entrainment speed below which the formulas are taken at this one, m/s: a film at rest must have finite slopes.
const LEAST_ENTRAINMENT: f64 = 1e-6;
/// Slide-to-roll ratio below which its power 0.83 is rounded off: its slope at 0 would be infinite.
const LEAST_SLIDING: f64 = 1e-3;
/// Load group W below which the rolling resistance goes to 0 in proportion to more than the load: the formulas were
/// fitted from about there on, and their power 0.47 would have an infinite slope without load.
const LEAST_LOAD: f64 = 1e-7;
/// Least thermal reduction: the formula was fitted down to some 0.2.
const LEAST_REDUCTION: f64 = 0.1;

impl InletFilm {
    /// An oil at the temperature of the inlet in K, a starvation factor and a roughness in m.
    ///
    /// # Errors
    /// [`LubricantError`] for a temperature at which no oil is used, a factor outside 0 to 1, a roughness not above 0.
    pub fn new(oil: &Oil, temperature: f64, starvation: f64, roughness: f64) -> Result<Self, LubricantError> {
        Oil::check_temperature(temperature)?;
        Ok(Self {
            viscosity: oil.dynamic(temperature),
            pressure_coefficient: oil.pressure_coefficient(temperature),
            temperature_coefficient: oil.temperature_coefficient(temperature),
            conductivity: oil.thermal.conductivity,
            starvation: check_starvation(starvation)?,
            roughness: positive("roughness", roughness, "m")?,
        })
    }

    /// The film of a contact, with inlet heating and starvation.
    pub fn thickness<D: Scalar>(&self, contact: &RollingContact<D>) -> FilmThickness<D> {
        let FilmThickness { central, minimum } = contact.flooded_isothermal(self.viscosity, self.pressure_coefficient);
        let reduction = self.thermal_reduction(contact) * self.starvation;
        FilmThickness { central: central * reduction, minimum: minimum * reduction }
    }

    /// Reduction of the film by shear heating in the inlet, φ_T.
    ///
    /// Source: P. K. Gupta, H. S. Cheng, D. Zhu, N. H. Forster and J. B. Schrand, Tribol. Trans. 35 (1992) 269: up to
    /// L = 25, S = 2 and p/E' = 0.01.
    pub fn thermal_reduction<D: Scalar>(&self, contact: &RollingContact<D>) -> D {
        let speed = contact.speed();
        let heating = speed * speed * (self.viscosity * self.temperature_coefficient / self.conductivity);
        let sliding = contact.slide_to_roll;
        let sliding = ((sliding * sliding + LEAST_SLIDING * LEAST_SLIDING).ln() * 0.415).exp();
        let pressure = contact.peak_pressure * (13.2 / contact.effective_modulus);
        let top = -pressure * heating.powf(0.42) + 1.0;
        let reduction = top / ((sliding * 2.23 + 1.0) * heating.powf(0.64) * 0.213 + 1.0);
        if reduction.re() > LEAST_REDUCTION { reduction } else { D::from(LEAST_REDUCTION) }
    }

    /// Film parameter λ = h_min/roughness.
    pub fn lambda_ratio<D: Scalar>(&self, film: &FilmThickness<D>) -> D {
        film.minimum / self.roughness
    }

    /// Resistance of the inlet to rolling, N, on each of both surfaces against its motion.
    ///
    /// Source: L. Houpert, ASME J. Tribol. 109 (1987) 363: 2.86 E' R_x² (R_y/R_x)^0.348 G^0.022 U^0.66 W^0.47. Heating
    /// and starvation take as much of it as of the film: both come from the viscosity and the oil in the inlet, of
    /// which the film has the power 0.67.
    pub fn rolling_resistance<D: Scalar>(&self, contact: &RollingContact<D>) -> D {
        let [speed, material, load] = contact.groups(self.viscosity, self.pressure_coefficient);
        let radius = contact.rolling_radius;
        let ratio = radius.recip() * contact.lateral_radius;
        let logs = ratio.ln() * 0.348 + material.ln() * 0.022 + speed.ln() * 0.66 + load.ln() * 0.47;
        let flooded = radius * radius * logs.exp() * (2.86 * contact.effective_modulus);
        // A contact that is about to part has no inlet: the slope over the load stays finite.
        let pressed = load / (load + LEAST_LOAD);
        flooded * pressed * self.thermal_reduction(contact) * self.starvation
    }
}

impl<D: Scalar> RollingContact<D> {
    /// Magnitude of the entrainment speed, m/s.
    fn speed(&self) -> D {
        let speed = self.entrainment.abs();
        if speed.re() > LEAST_ENTRAINMENT { speed } else { D::from(LEAST_ENTRAINMENT) }
    }

    /// U = η0 u/(E' R_x), G = α E', W = Q/(E' R_x²).
    fn groups(&self, viscosity: f64, pressure_coefficient: f64) -> [D; 3] {
        let (modulus, radius) = (self.effective_modulus, self.rolling_radius);
        [
            self.speed() * (viscosity / modulus) / radius,
            D::from(pressure_coefficient * modulus),
            self.load / (radius * radius * modulus),
        ]
    }

    /// The film of a smooth, fully flooded contact without heating, from the viscosity at the inlet (Pa s) and α
    /// (1/Pa).
    ///
    /// Source: B. J. Hamrock and D. Dowson, ASME J. Lubr. Technol. 99 (1977) 264, doi:10.1115/1.3453074. Full solutions
    /// differ by 10 to 20 % in h_c and more in h_min (J.-D. Wheeler, P. Vergne, N. Fillot and D. Philippon, Friction 4
    /// (2016) 369).
    pub fn flooded_isothermal(&self, viscosity: f64, pressure_coefficient: f64) -> FilmThickness<D> {
        let [speed, material, load] = self.groups(viscosity, pressure_coefficient).map(|group| group.ln());
        let k = self.ellipticity;
        let formula = |factor: f64, [u, g, w]: [f64; 3], sides: D| {
            self.rolling_radius * (speed * u + material * g + load * w).exp() * sides * factor
        };
        FilmThickness {
            central: formula(2.69, [0.67, 0.53, -0.067], -(k * -0.73).exp() * 0.61 + 1.0),
            minimum: formula(3.63, [0.68, 0.49, -0.073], -(k * -0.68).exp() + 1.0),
        }
    }
}

impl RollingContact {
    /// Checks that the formulas hold: lengths, speeds and loads above 0, and a contact that is not longer along rolling
    /// than across it.
    ///
    /// # Errors
    /// [`LubricantError`] else.
    pub fn check(&self) -> Result<(), LubricantError> {
        positive("load", self.load, "N")?;
        positive("entrainment speed", self.entrainment, "m/s")?;
        positive("radius along rolling", self.rolling_radius, "m")?;
        positive("radius across rolling", self.lateral_radius, "m")?;
        positive("effective modulus", self.effective_modulus, "Pa")?;
        positive("ellipticity", self.ellipticity, "")?;
        // A contact of circles may miss 1 by rounding.
        if self.ellipticity < 1.0 - 1e-9 {
            return Err(LubricantError::Ellipticity { ellipticity: self.ellipticity });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BaseStock;
    use num_dual::Dual64;
    use std::f64::consts::PI;

    /// Both contacts of a 6206 at 3000 r/min under 1500 N a ball: D 9.525 mm, d_m 46 mm, f 0.52, 208 GPa, 0.3.
    fn deep_groove(side: f64, ellipticity: f64) -> RollingContact {
        let (diameter, pitch) = (9.525e-3, 46e-3);
        let gamma: f64 = diameter / pitch;
        RollingContact {
            load: 1500.0,
            entrainment: 0.25 * pitch * (1.0 - gamma * gamma) * 3000.0 * PI / 30.0,
            slide_to_roll: 0.0,
            rolling_radius: 0.5 * diameter * (1.0 + side * gamma),
            lateral_radius: 0.52 * diameter / 0.04,
            ellipticity,
            peak_pressure: 2e9,
            effective_modulus: 208e9 / (1.0 - 0.09),
        }
    }

    /// Values worked out beside this program.
    #[test]
    fn code_hamrock_dowson_of_a_6206() {
        for (side, k, central, minimum) in [(-1.0, 9.36747, 0.25437, 0.20315), (1.0, 7.25172, 0.30839, 0.24573)] {
            let contact = deep_groove(side, k);
            contact.check().unwrap();
            assert!((contact.entrainment - 3.45793).abs() < 5e-6, "{}", contact.entrainment);
            let film = contact.flooded_isothermal(0.02, 20e-9);
            assert!((film.central * 1e6 - central).abs() < 6e-6, "{} µm", film.central * 1e6);
            assert!((film.minimum * 1e6 - minimum).abs() < 6e-6, "{} µm", film.minimum * 1e6);
        }
    }

    #[test]
    fn limit_slow_contacts_are_not_heated_and_starvation_is_a_factor() {
        let oil = BaseStock::Mineral.oil(68.0, None).unwrap();
        let flooded = InletFilm::new(&oil, 343.15, 1.0, 0.1e-6).unwrap();
        let contact = deep_groove(-1.0, 9.36747);
        let slow = RollingContact { entrainment: 1e-4, ..contact };
        assert!((flooded.thermal_reduction(&slow) - 1.0).abs() < 1e-3);
        let reduction = flooded.thermal_reduction(&contact);
        assert!((0.75..0.99).contains(&reduction), "{reduction}");
        let sliding = RollingContact { slide_to_roll: 1.0, ..contact };
        assert!(flooded.thermal_reduction(&sliding) < reduction);
        let grease = InletFilm::new(&oil, 343.15, 0.7, 0.1e-6).unwrap();
        let ratio = grease.thickness(&contact).minimum / flooded.thickness(&contact).minimum;
        assert!((ratio - 0.7).abs() < 1e-12);
        let film = flooded.thickness(&contact);
        assert!((flooded.lambda_ratio(&film) - film.minimum / 0.1e-6).abs() < 1e-12);
    }

    /// Film and resistance rise with the powers of the speed that the formulas have.
    #[test]
    fn identity_powers_of_the_speed() {
        let contact = deep_groove(-1.0, 9.36747);
        let dual = RollingContact {
            load: Dual64::from(contact.load),
            entrainment: Dual64::from(contact.entrainment).derivative(),
            slide_to_roll: Dual64::from(0.0),
            rolling_radius: Dual64::from(contact.rolling_radius),
            lateral_radius: contact.lateral_radius,
            ellipticity: Dual64::from(contact.ellipticity),
            peak_pressure: Dual64::from(contact.peak_pressure),
            effective_modulus: contact.effective_modulus,
        };
        let film = dual.flooded_isothermal(0.02, 20e-9);
        let power = |value: Dual64| value.eps * contact.entrainment / value.re;
        assert!((power(film.central) - 0.67).abs() < 1e-12 && (power(film.minimum) - 0.68).abs() < 1e-12);
        let cold = InletFilm {
            viscosity: 0.02,
            pressure_coefficient: 20e-9,
            temperature_coefficient: 1e-9,
            conductivity: 0.14,
            starvation: 1.0,
            roughness: 1e-7,
        };
        let resistance = cold.rolling_resistance(&dual);
        assert!((power(resistance) - 0.66).abs() < 1e-4, "{}", power(resistance));
        assert!((0.05..0.5).contains(&resistance.re), "{} N", resistance.re);
    }

    #[test]
    fn limit_contacts_along_rolling_are_refused() {
        let contact = deep_groove(-1.0, 0.5);
        assert!(contact.check().unwrap_err().to_string().contains("1 or more"));
        assert!(RollingContact { load: -1.0, ..deep_groove(-1.0, 2.0) }.check().is_err());
    }
}
