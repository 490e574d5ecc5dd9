//! Palmgren's friction torque: a part of the lubricant and one of the load.
//!
//! Source: A. Palmgren, Grundlagen der Wälzlagertechnik, Stuttgart 1964; constants as in T. A. Harris, Rolling Bearing
//! Analysis, 4th ed. 2001, ch. 14.

use super::Supply;
use crate::{LubricantError, positive};

/// A bearing as Palmgren's formula sees it, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PalmgrenBearing {
    /// Pitch diameter, m.
    pub pitch_diameter: f64,
    /// True for an angular contact bearing.
    pub angular_contact: bool,
    /// Static load rating C_0, N.
    pub static_rating: f64,
}

/// Palmgren's torque by cause, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PalmgrenTorque {
    /// Of the lubricant, M0.
    pub viscous: f64,
    /// Of the load, M1.
    pub load: f64,
}

impl PalmgrenTorque {
    /// The sum, N m.
    pub fn total(&self) -> f64 {
        self.viscous + self.load
    }
}

const MM: f64 = 1e3;
/// ν n in mm²/s and r/min below which M0 no longer falls.
const SLOW: f64 = 2000.0;

impl PalmgrenBearing {
    /// f0: grease and oil mist, bath, jet.
    fn viscous_factor(&self, supply: Supply) -> f64 {
        match (self.angular_contact, supply) {
            (false, Supply::OilAir) => 1.0,
            (false, Supply::Grease) => 1.5,
            (false, Supply::Bath) => 2.0,
            (false, Supply::Jet) => 4.0,
            (true, Supply::OilAir) => 1.7,
            (true, Supply::Grease) => 2.0,
            (true, Supply::Bath) => 3.3,
            (true, Supply::Jet) => 6.6,
        }
    }

    /// Torque at loads in N, a speed in rad/s and a kinematic viscosity in m²/s.
    ///
    /// # Errors
    /// [`LubricantError::NotPositive`] for a pitch diameter, rating, speed or viscosity that is not above 0.
    pub fn torque(
        &self,
        [radial, axial]: [f64; 2],
        speed: f64,
        viscosity: f64,
        supply: Supply,
    ) -> Result<PalmgrenTorque, LubricantError> {
        let pitch = positive("pitch diameter", self.pitch_diameter, "m")? * MM;
        let rating = positive("static load rating", self.static_rating, "N")?;
        let rpm = positive("speed", speed.abs(), "rad/s")? * 30.0 / std::f64::consts::PI;
        let product = positive("viscosity", viscosity, "m²/s")? * crate::MM2_PER_M2 * rpm;
        let (radial, axial) = (radial.abs(), axial.abs());
        let viscous = self.viscous_factor(supply) * pitch.powi(3) * 1e-7;
        let viscous = viscous * if product < SLOW { 160.0 } else { product.powf(2.0 / 3.0) };
        let (directed, at_rest, factor, power) = if self.angular_contact {
            // X_0 and Y_0 of 40°.
            (axial - 0.1 * radial, (0.5 * radial + 0.26 * axial).max(radial), 1e-3, 0.33)
        } else {
            (3.0 * axial - 0.1 * radial, (0.6 * radial + 0.5 * axial).max(radial), 7e-4, 0.55)
        };
        let load = factor * (at_rest / rating).powf(power) * directed.max(radial) * pitch;
        Ok(PalmgrenTorque { viscous: viscous / MM, load: load / MM })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// 1e-7 · 2 · 46³ · (20.279 · 3000)^(2/3) = 30.1 N mm, and 7e-4 (1000/11 200)^0.55 · 1000 · 46 = 8.54 N mm.
    #[test]
    fn limit_palmgren_of_a_6206_by_hand() {
        let bearing = PalmgrenBearing { pitch_diameter: 46e-3, angular_contact: false, static_rating: 11_200.0 };
        let at = |rpm: f64| bearing.torque([1000.0, 0.0], rpm * PI / 30.0, 20.279e-6, Supply::Bath).unwrap();
        let torque = at(3000.0);
        assert!((torque.viscous * 1e3 - 30.10).abs() < 0.05, "{} N mm", torque.viscous * 1e3);
        assert!((torque.load * 1e3 - 8.54).abs() < 0.02, "{} N mm", torque.load * 1e3);
        assert!((torque.total() - torque.viscous - torque.load).abs() < 1e-15);
        // Below ν n = 2000 the speed has no part in it; at the limit both formulas give 160 to a percent.
        assert_eq!(at(20.0).viscous, at(80.0).viscous);
        assert!((at(98.0).viscous / at(99.0).viscous - 1.0).abs() < 0.02);
    }

    #[test]
    fn limit_a_pure_axial_load_counts_threefold_in_a_deep_groove() {
        let bearing = PalmgrenBearing { pitch_diameter: 46e-3, angular_contact: false, static_rating: 11_200.0 };
        let axial = bearing.torque([0.0, 1000.0], 300.0, 20e-6, Supply::Grease).unwrap();
        let expected = 7e-4 * (500.0f64 / 11_200.0).powf(0.55) * 3000.0 * 46.0 * 1e-3;
        assert!((axial.load / expected - 1.0).abs() < 1e-12);
        assert!(bearing.torque([0.0, 0.0], 0.0, 20e-6, Supply::Grease).is_err());
    }
}
