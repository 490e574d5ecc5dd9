#![doc = include_str!("../README.md")]

mod dynamic_rating;
mod equivalent;
mod modified;
mod reference;
mod static_rating;

pub use dynamic_rating::RatedBearing;
pub use equivalent::{LoadFactors, basic_life_mrev};
pub use modified::{Cleanliness, Lubrication, life_modification_factor, reference_viscosity, reliability_factor};
pub use reference::{BallLoads, ReferenceLife, Turning, hours};
pub use static_rating::PERMISSIBLE_PRESSURE;

/// Largest nominal contact angle of a radial bearing, degrees: ISO 281 takes thrust bearings beyond it.
pub const CONTACT_ANGLE_MAX_DEG: f64 = 45.0;

/// Why there is no rating.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RatingError {
    /// A dimension that no bearing has.
    #[error("{quantity} is {value} {unit}: it must be finite and above 0")]
    Dimension {
        /// Name of the dimension.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// A nominal contact angle beyond those of radial bearings.
    #[error(
        "nominal contact angle {angle_deg}°: ISO 281 rates radial ball bearings from 0° to {CONTACT_ANGLE_MAX_DEG}°"
    )]
    ContactAngle {
        /// The angle, degrees.
        angle_deg: f64,
    },
    /// Balls as large as the pitch circle.
    #[error("D cos α/d_m is {gamma}: it must be below 1")]
    Ratio {
        /// γ = D cos α/d_m.
        gamma: f64,
    },
    /// Grooves that no ball rolls in.
    #[error("groove radius over ball diameter is {coefficient} on the {race} race: it must be above 0.5")]
    Groove {
        /// Which race.
        race: &'static str,
        /// The coefficient.
        coefficient: f64,
    },
    /// A load that is negative or not a number.
    #[error("{quantity} is {value} N: it must be at least 0 and finite")]
    Load {
        /// Which load.
        quantity: &'static str,
        /// Its value, N.
        value: f64,
    },
    /// Ball loads of another number of balls.
    #[error("{found} loads on the {race} race for {expected} balls")]
    Count {
        /// Which race.
        race: &'static str,
        /// Loads given.
        found: usize,
        /// Balls of the bearing.
        expected: usize,
    },
    /// A viscosity ratio for which ISO 281 has no formula.
    #[error("viscosity ratio {kappa}: ISO 281 has a_ISO from 0.1 on")]
    ViscosityRatio {
        /// κ.
        kappa: f64,
    },
    /// A contamination factor beyond its range.
    #[error("contamination factor {contamination}: it lies from 0 to 1")]
    Contamination {
        /// e_C.
        contamination: f64,
    },
    /// A reliability beyond the range of ISO 281.
    #[error("reliability {percent} %: ISO 281 has a_1 from 90 % to 99.95 %")]
    Reliability {
        /// Percent of bearings that reach the life.
        percent: f64,
    },
    /// Curvatures that make no point contact.
    #[error(transparent)]
    Contact(#[from] tribodyn_contact::ContactError),
}

fn positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, RatingError> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(RatingError::Dimension { quantity, value, unit }) }
}

fn load(quantity: &'static str, value: f64) -> Result<f64, RatingError> {
    if value.is_finite() && value >= 0.0 { Ok(value) } else { Err(RatingError::Load { quantity, value }) }
}
