//! Units of results and of what is shown of them.

use std::f64::consts::PI;

/// Revolutions per minute in one rad/s.
pub const RPM_PER_RAD_S: f64 = 30.0 / PI;

/// A unit of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// End of a name in this unit, without underscore; empty for a ratio.
    pub suffix: &'static str,
    /// Symbol for people; empty for a ratio.
    pub symbol: &'static str,
    /// The number of these units in one SI unit.
    pub per_si: f64,
}

impl Unit {
    const fn new(suffix: &'static str, symbol: &'static str, per_si: f64) -> Self {
        Self { suffix, symbol, per_si }
    }
}

/// A ratio.
pub const ONE: Unit = Unit::new("", "", 1.0);
/// Percent.
pub const PERCENT: Unit = Unit::new("percent", "%", 100.0);
/// Newton.
pub const NEWTON: Unit = Unit::new("n", "N", 1.0);
/// Newton metre.
pub const NEWTON_METRE: Unit = Unit::new("nm", "N m", 1.0);
/// Newton millimetre.
pub const NEWTON_MILLIMETRE: Unit = Unit::new("nmm", "N mm", 1e3);
/// Pascal.
pub const PASCAL: Unit = Unit::new("pa", "Pa", 1.0);
/// Gigapascal.
pub const GIGAPASCAL: Unit = Unit::new("gpa", "GPa", 1e-9);
/// Metre.
pub const METRE: Unit = Unit::new("m", "m", 1.0);
/// Millimetre.
pub const MILLIMETRE: Unit = Unit::new("mm", "mm", 1e3);
/// Micrometre.
pub const MICROMETRE: Unit = Unit::new("um", "µm", 1e6);
/// Radian.
pub const RADIAN: Unit = Unit::new("rad", "rad", 1.0);
/// Milliradian.
pub const MILLIRADIAN: Unit = Unit::new("mrad", "mrad", 1e3);
/// Degree.
pub const DEGREE: Unit = Unit::new("deg", "°", 180.0 / PI);
/// Radian per second.
pub const RADIAN_PER_SECOND: Unit = Unit::new("rad_s", "rad/s", 1.0);
/// Revolution per minute.
pub const RPM: Unit = Unit::new("rpm", "r/min", RPM_PER_RAD_S);
/// Radian per second squared.
pub const RADIAN_PER_SECOND_SQUARED: Unit = Unit::new("rad_s2", "rad/s²", 1.0);
/// Metre per second.
pub const METRE_PER_SECOND: Unit = Unit::new("m_s", "m/s", 1.0);
/// Millimetre per second.
pub const MILLIMETRE_PER_SECOND: Unit = Unit::new("mm_s", "mm/s", 1e3);
/// Reciprocal metre.
pub const PER_METRE: Unit = Unit::new("per_m", "1/m", 1.0);
/// Kelvin.
pub const KELVIN: Unit = Unit::new("k", "K", 1.0);
/// Watt.
pub const WATT: Unit = Unit::new("w", "W", 1.0);
/// Cubic metre per second.
pub const CUBIC_METRE_PER_SECOND: Unit = Unit::new("m3_s", "m³/s", 1.0);
/// Cubic micrometre per second.
pub const CUBIC_MICROMETRE_PER_SECOND: Unit = Unit::new("um3_s", "µm³/s", 1e18);
