#![doc = include_str!("../README.md")]

mod archard;
mod ball_size;
mod ball_spall;
mod ball_waves;
mod defect;
mod geometry;
mod groove;
mod life;
mod profile;
mod raceway;
mod random;
mod spall;
mod surface;
mod transfer;
mod waviness;

pub use archard::{Archard, archard_rate, cage_rate};
pub use ball_size::{ball_deviations, ball_grades, lot_variation};
pub use ball_spall::{BallSpallDepth, BallSpallPath};
pub use ball_waves::{BallForm, BallWave, BallWaves, HIGHEST_OF_BALL};
pub use defect::Defect;
pub use geometry::{GrooveGeometry, WearDepths};
pub use groove::{ContactWear, GrooveField, GroovePlace, GrooveSpot, GrooveWear, UnderContact};
pub use life::{BallWear, CoatingLife, RaceWear, Stride, WearRates};
pub use profile::Profile;
pub use raceway::{BINS, ProfilePoint, Raceway};
pub use random::Random;
pub use spall::{Spall, SpallPath, Track};
pub use surface::LocalSurface;
pub use transfer::{TransferFilm, TransferLaw, TransferRates};
pub use waviness::{HIGHEST_ORDER, Wave, WaveSpectrum, waviness};

/// Errors of worn geometry, raceways and wear data.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WearError {
    /// A ball diameter or groove-bottom radius that is not a length.
    #[error("{name} is {value} m: it must be finite and above 0")]
    Length {
        /// Name of the length.
        name: &'static str,
        /// The value given, m.
        value: f64,
    },
    /// A groove that does not fit round the ball.
    #[error(
        "groove radius of the {race} race is {value} m: it must be finite and above the ball's radius {ball_radius} m"
    )]
    Groove {
        /// The race.
        race: &'static str,
        /// The groove radius given, m.
        value: f64,
        /// The ball's radius, m.
        ball_radius: f64,
    },
    /// A wear depth below zero.
    #[error("wear depth of the {race} race is {value} m: it must be finite and at least 0")]
    Depth {
        /// The race.
        race: &'static str,
        /// The depth given, m.
        value: f64,
    },
    /// Groove bottoms and wear that leave no contact angle.
    #[error(
        "the groove bottoms leave the ball a radial clearance of {clearance} m: a contact angle between 0 and 90 degrees needs 0 to {limit} m, the distance of the groove centres"
    )]
    Clearance {
        /// Clearance on the radius, R_o − R_i − D with wear, m.
        clearance: f64,
        /// Largest with a contact angle, r_i + r_o − D, m.
        limit: f64,
    },
    /// A coating thickness below zero.
    #[error("thickness of the coating is {value} m: it must be finite and at least 0")]
    Thickness {
        /// The thickness given, m.
        value: f64,
    },
    /// A share outside 0 to 1.
    #[error("{name} is {value}: it must lie between 0 and 1")]
    Fraction {
        /// Name of the part.
        name: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value that no defect has.
    #[error("{name} of a defect is {value}: allowed is {allowed}")]
    Defect {
        /// Name of the value.
        name: &'static str,
        /// The value given, m, rad or a fraction.
        value: f64,
        /// Allowed values.
        allowed: &'static str,
    },
    /// A value that no spall has.
    #[error("{name} of a spall is {value}: allowed is {allowed}")]
    Spall {
        /// Name of the value.
        name: &'static str,
        /// The value given, SI.
        value: f64,
        /// Allowed values.
        allowed: &'static str,
    },
    /// A value that no wave has.
    #[error("{name} of a wave is {value}: allowed is {allowed}")]
    Wave {
        /// Name of the value.
        name: &'static str,
        /// The value given, SI.
        value: f64,
        /// Allowed values.
        allowed: &'static str,
    },
    /// A stored raceway with another number of bins.
    #[error("a stored raceway has {count} azimuth bins, this version has {BINS}")]
    Bins {
        /// Bins stored.
        count: usize,
    },
    /// A rate of wear that is negative or no number.
    #[error("a ball wears off {value} m³/s: the rate must be finite and at least 0")]
    Rate {
        /// The rate given, m³/s.
        value: f64,
    },
    /// A longest stride that is no time.
    #[error("the longest stride is {value} s: it must be finite and above 0")]
    Time {
        /// The time given, s.
        value: f64,
    },
    /// Azimuths of a ball that are not those of one turn.
    #[error("azimuths of a ball from {azimuth} rad on must rise over one turn and be finite")]
    Orbit {
        /// The first azimuth, rad, or the one that is not finite.
        azimuth: f64,
    },
}
