//! SKF's model of the friction torque.
//!
//! Source: SKF, Rolling bearings, PUB BU/P1 17000/1 EN, 2018, chapter friction, tables 1 and 2.

use super::Supply;
use crate::{LubricantError, positive};

/// Geometry constants of a series and the dimensions of a bearing, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfBearing {
    /// Bore d, m.
    pub bore: f64,
    /// Outside diameter, m.
    pub outside: f64,
    /// Constants of the series.
    pub series: SkfSeries,
    /// Static load rating C_0, N, for deep-groove bearings with axial load.
    pub static_rating: f64,
}

/// Constants R and S of SKF's rolling and sliding terms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SkfSeries {
    /// R1, R2, S1, S2 of a series of deep-groove bearings.
    DeepGroove([f64; 4]),
    /// R1, R2, R3, S1, S2, S3 of angular contact bearings.
    AngularContact([f64; 6]),
}

/// Constants of deep-groove bearings by the first digits of their designation: R1, R2, S1, S2.
const DEEP_GROOVE: [(&str, [f64; 4]); 10] = [
    ("60", [4.1e-7, 1.7, 3.73e-3, 14.6]),
    ("630", [4.1e-7, 1.7, 3.73e-3, 14.6]),
    ("62", [3.9e-7, 1.7, 3.23e-3, 36.5]),
    ("622", [3.9e-7, 1.7, 3.23e-3, 36.5]),
    ("63", [3.7e-7, 1.7, 2.84e-3, 92.8]),
    ("623", [3.7e-7, 1.7, 2.84e-3, 92.8]),
    ("64", [3.6e-7, 1.7, 2.43e-3, 198.0]),
    ("160", [4.3e-7, 1.7, 4.63e-3, 4.25]),
    ("618", [4.7e-7, 1.7, 6.5e-3, 0.78]),
    ("619", [4.3e-7, 1.7, 4.75e-3, 3.6]),
];
/// Constants of single-row angular contact bearings.
const ANGULAR_CONTACT: [f64; 6] = [5.03e-7, 1.97, 1.9e-12, 1.3e-2, 0.68, 1.91e-12];
/// Sliding friction without a film.
const DRY_SLIDING: f64 = 0.15;
/// Sliding friction in a film of mineral oil.
const MINERAL_SLIDING: f64 = 0.05;
/// Sliding friction in a film of synthetic oil.
const SYNTHETIC_SLIDING: f64 = 0.04;
/// Axial load over radial load below which there is none: SKF's formulas for deep grooves jump there.
const NO_AXIAL: f64 = 1e-6;
const MM: f64 = 1e3;

/// Load, speed and oil of a bearing, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfLoads {
    /// Radial load F_r, N.
    pub radial: f64,
    /// Axial load F_a, N.
    pub axial: f64,
    /// Speed, rad/s.
    pub speed: f64,
    /// Kinematic viscosity at operating temperature, m²/s.
    pub viscosity: f64,
    /// How the oil gets to the bearing.
    pub supply: Supply,
    /// True for synthetic oils.
    pub synthetic: bool,
}

/// SKF's torque by cause, N m: without seals and without the drag of an oil bath.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkfTorque {
    /// Rolling, with inlet heating and replenishment.
    pub rolling: f64,
    /// Sliding.
    pub sliding: f64,
}

impl SkfTorque {
    /// The sum, N m.
    pub fn total(&self) -> f64 {
        self.rolling + self.sliding
    }
}

impl SkfSeries {
    /// The series of a deep-groove or angular contact bearing by its designation; absent for one that is not in the
    /// tables.
    pub fn of_designation(designation: &str) -> Option<Self> {
        let digits: String = designation.chars().take_while(char::is_ascii_digit).collect();
        if digits.len() == 4 && digits.starts_with('7') {
            return Some(Self::angular_contact());
        }
        // The last two digits tell the bore; 608 and its like have one.
        let of_bore = if digits.len() == 3 { 1 } else { 2 };
        Self::deep_groove(digits.get(..digits.len().checked_sub(of_bore)?)?.parse().ok()?)
    }

    /// A series of deep-groove bearings by its number, such as 62; absent for one that is not in the table.
    pub fn deep_groove(series: u16) -> Option<Self> {
        let name = series.to_string();
        DEEP_GROOVE.iter().find(|(known, _)| *known == name).map(|(_, constants)| Self::DeepGroove(*constants))
    }

    /// Single-row angular contact bearings, which have one set of constants.
    pub fn angular_contact() -> Self {
        Self::AngularContact(ANGULAR_CONTACT)
    }

    /// K_Z of the replenishment factor.
    fn replenishment(&self) -> f64 {
        match self {
            Self::DeepGroove(_) => 3.1,
            Self::AngularContact(_) => 4.4,
        }
    }
}

impl SkfBearing {
    /// Torque under a load.
    ///
    /// # Errors
    /// [`LubricantError::NotPositive`] for dimensions, speed or viscosity that are not above 0.
    pub fn torque(&self, at: &SkfLoads) -> Result<SkfTorque, LubricantError> {
        let bore = positive("bore", self.bore, "m")? * MM;
        let outside = positive("outside diameter less bore", self.outside - self.bore, "m")? * MM + bore;
        let rpm = positive("speed", at.speed.abs(), "rad/s")? * 30.0 / std::f64::consts::PI;
        let viscosity = positive("viscosity", at.viscosity, "m²/s")? * crate::MM2_PER_M2;
        let pitch = 0.5 * (bore + outside);
        let [rolling, sliding] = self.variables(at, pitch, rpm)?;
        let heating = 1.0 / (1.0 + 1.84e-9 * (rpm * pitch).powf(1.28) * viscosity.powf(0.64));
        let supply = match at.supply {
            Supply::Bath | Supply::Jet => 3e-8,
            Supply::OilAir | Supply::Grease => 6e-8,
        };
        let section = (self.series.replenishment() / (2.0 * (outside - bore))).sqrt();
        let replenishment = (-supply * viscosity * rpm * (bore + outside) * section).exp();
        let film = if at.synthetic { SYNTHETIC_SLIDING } else { MINERAL_SLIDING };
        let boundary = (-2.6e-8 * (rpm * viscosity).powf(1.4) * pitch).exp();
        let friction = boundary * DRY_SLIDING + (1.0 - boundary) * film;
        Ok(SkfTorque {
            rolling: heating * replenishment * rolling * (viscosity * rpm).powf(0.6) / MM,
            sliding: sliding * friction / MM,
        })
    }

    /// G_rr and G_sl, in N and mm.
    fn variables(&self, at: &SkfLoads, pitch: f64, rpm: f64) -> Result<[f64; 2], LubricantError> {
        let (radial, axial) = (at.radial.abs(), at.axial.abs());
        Ok(match self.series {
            SkfSeries::DeepGroove([r1, _, s1, _]) if axial <= NO_AXIAL * radial => {
                [r1 * pitch.powf(1.96) * radial.powf(0.54), s1 * pitch.powf(-0.26) * radial.powf(5.0 / 3.0)]
            }
            SkfSeries::DeepGroove([r1, r2, s1, s2]) => {
                let rating = positive("static load rating", self.static_rating, "N")?;
                let sin = (24.6 * (axial / rating).powf(0.24)).to_radians().sin();
                let rolling = r1 * pitch.powf(1.96) * (radial + r2 / sin * axial).powf(0.54);
                let slid = radial.powi(5) + s2 * pitch.powf(1.5) / sin * axial.powi(4);
                [rolling, s1 * pitch.powf(-0.145) * slid.cbrt()]
            }
            SkfSeries::AngularContact([r1, r2, r3, s1, s2, s3]) => {
                let [rolled, slid] = [r3, s3].map(|factor| factor * pitch.powi(4) * rpm * rpm);
                let rolling = r1 * pitch.powf(1.97) * (radial + rolled + r2 * axial).powf(0.54);
                let sliding = (radial + slid).powf(4.0 / 3.0) + s2 * axial.powf(4.0 / 3.0);
                [rolling, s1 * pitch.powf(0.26) * sliding]
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn deep_groove() -> SkfBearing {
        let series = SkfSeries::of_designation("6206").unwrap();
        SkfBearing { bore: 30e-3, outside: 62e-3, series, static_rating: 11_200.0 }
    }

    fn at(rpm: f64) -> SkfLoads {
        SkfLoads {
            radial: 1000.0,
            axial: 0.0,
            speed: rpm * PI / 30.0,
            viscosity: 20.279e-6,
            supply: Supply::Bath,
            synthetic: false,
        }
    }

    /// Values worked out beside this program: VG 68 at 70 °C, 1000 N radial.
    #[test]
    fn code_skf_of_a_6206() {
        for (rpm, expected) in [(500.0, 20.709), (3000.0, 26.146), (10_000.0, 38.562)] {
            let found = deep_groove().torque(&at(rpm)).unwrap().total() * 1e3;
            assert!((found - expected).abs() < 2e-3, "{rpm} r/min: {found} N mm");
        }
    }

    #[test]
    fn limit_a_small_axial_load_adds_little_and_grease_starves() {
        let bath = at(3000.0);
        let plain = deep_groove().torque(&bath).unwrap();
        let loaded = deep_groove().torque(&SkfLoads { axial: 2e-3, ..bath }).unwrap();
        assert!((loaded.rolling / plain.rolling - 1.0).abs() < 1e-3 && loaded.sliding > plain.sliding);
        assert_eq!(deep_groove().torque(&SkfLoads { axial: 1e-12, ..bath }).unwrap(), plain);
        let grease = deep_groove().torque(&SkfLoads { supply: Supply::Grease, ..bath }).unwrap();
        assert!(grease.rolling < plain.rolling && grease.sliding == plain.sliding);
        let synthetic = deep_groove().torque(&SkfLoads { synthetic: true, ..bath }).unwrap();
        assert!(synthetic.sliding < plain.sliding);
    }

    #[test]
    fn limit_series_and_bad_input() {
        let known = |name| SkfSeries::of_designation(name).is_some();
        assert!(known("608") && known("6308-2RS") && known("7210BE") && known("16005") && known("61807"));
        assert!(!known("22210") && !known("abc") && !known("6"));
        assert_eq!(SkfSeries::deep_groove(62), SkfSeries::of_designation("6206"));
        assert!(deep_groove().torque(&SkfLoads { viscosity: 0.0, ..at(3000.0) }).is_err());
        assert!(deep_groove().torque(&at(0.0)).is_err());
    }
}
