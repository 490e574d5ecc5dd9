//! Effects of lubricant, dirt and reliability on a rating life: a_ISO, a_1 and the reference viscosity of ISO 281.

use crate::dynamic_rating::MM_PER_M;
use crate::{RatingError, load, positive};

/// The state of the lubricant film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lubrication {
    /// Viscosity ratio κ = ν/ν_1 at operating temperature; above 4 it counts as 4.
    pub viscosity_ratio: f64,
    /// Contamination factor e_C: 1 for extreme cleanliness, 0.8 to 0.6 for high, 0.6 to 0.5 for normal, 0 for very
    /// severe contamination.
    pub contamination: f64,
}

/// How clean the lubricant of a bearing is, by the classes of ISO 281:2007, table 13.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cleanliness {
    /// Particles of the size of the film: laboratories.
    Extreme,
    /// Oil through an extremely fine filter; sealed bearings greased for life.
    High,
    /// Oil through a fine filter; shielded bearings greased for life.
    Normal,
    /// Slightly dirty lubricant.
    Slight,
    /// Bearings without seals, coarse filters, wear and dirt from around.
    Typical,
    /// Very dirty surroundings and insufficient seals.
    Severe,
    /// Beyond all that.
    VerySevere,
}

impl Cleanliness {
    /// Contamination factor e_C on a pitch diameter in m: the middle of its range in the table.
    pub fn contamination(self, pitch_diameter: f64) -> f64 {
        // Below 100 mm, and from there on.
        let [small, large] = match self {
            Self::Extreme => [1.0, 1.0],
            Self::High => [0.7, 0.85],
            Self::Normal => [0.55, 0.7],
            Self::Slight => [0.4, 0.5],
            Self::Typical => [0.2, 0.3],
            Self::Severe => [0.05, 0.05],
            Self::VerySevere => [0.0, 0.0],
        };
        if pitch_diameter < 0.1 { small } else { large }
    }
}

/// Largest a_ISO.
const FACTOR_MAX: f64 = 50.0;
/// Smallest viscosity ratio with a formula.
const KAPPA_MIN: f64 = 0.1;

/// Life modification factor a_ISO of radial ball bearings from the film, the fatigue load limit C_u and the load P, N.
///
/// # Errors
/// [`RatingError`] for a viscosity ratio below 0.1, a contamination factor outside 0 to 1, and a load not above 0.
pub fn life_modification_factor(film: Lubrication, fatigue_limit: f64, equivalent: f64) -> Result<f64, RatingError> {
    let Lubrication { viscosity_ratio: kappa, contamination } = film;
    if !(kappa.is_finite() && kappa >= KAPPA_MIN) {
        return Err(RatingError::ViscosityRatio { kappa });
    }
    if !(0.0..=1.0).contains(&contamination) {
        return Err(RatingError::Contamination { contamination });
    }
    load("fatigue load limit", fatigue_limit)?;
    positive("equivalent load", equivalent, "N")?;
    let film = if kappa < 0.4 {
        2.2649 / kappa.powf(0.054381)
    } else if kappa < 1.0 {
        1.9987 / kappa.powf(0.19087)
    } else {
        1.9987 / kappa.min(4.0).powf(0.071739)
    };
    let stress = (contamination * fatigue_limit / equivalent).cbrt();
    let left = 1.0 - (2.5671 - film).powf(0.83) * stress;
    if left <= 0.0 {
        return Ok(FACTOR_MAX);
    }
    Ok((0.1 * left.powf(-9.3)).min(FACTOR_MAX))
}

/// Life factor a_1 for a reliability in percent, 1 at 90 %: the Weibull distribution of ISO/TR 1281-2 with its least
/// life.
///
/// # Errors
/// [`RatingError::Reliability`] outside 90 % to 99.95 %.
pub fn reliability_factor(percent: f64) -> Result<f64, RatingError> {
    if !(90.0..=99.95).contains(&percent) {
        return Err(RatingError::Reliability { percent });
    }
    let least = 0.05;
    let share = (100.0 / percent).ln() / (100.0f64 / 90.0).ln();
    Ok(least + (1.0 - least) * share.powf(2.0 / 3.0))
}

/// Reference kinematic viscosity ν_1, m²/s, that a film needs at a speed (rad/s) on a pitch diameter (m).
///
/// # Errors
/// [`RatingError::Dimension`] unless both are above 0.
pub fn reference_viscosity(speed: f64, pitch_diameter: f64) -> Result<f64, RatingError> {
    let rpm = positive("speed", speed.abs(), "rad/s")? * 30.0 / std::f64::consts::PI;
    let pitch = positive("pitch diameter", pitch_diameter, "m")? * MM_PER_M;
    let at_unit_pitch = if rpm < 1000.0 { 45_000.0 * rpm.powf(-0.83) } else { 4500.0 * rpm.powf(-0.5) };
    Ok(at_unit_pitch / pitch.sqrt() * 1e-6)
}
