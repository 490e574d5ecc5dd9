//! Archard wear of races and cage, what it does to coating and groove round a raceway, and the contact angle of a worn
//! ball bearing.
//!
//! # Equations
//! ```text
//! w = K_w Q Δv/H                                           (Archard, volume per time; Eqs. 6–9)
//! race:  w = (K_w/H) ∬ p |Δv| dA,    cage:  w = (K_w/H) F |Δv|
//! cos α_w = [r_i + r_o − (R_o − R_i) − (d_i + d_o)]/(r_i + r_o − D)                     (Eqs. 12, 13)
//! d(φ) = Σ c_k B_k(φ),   c_k += B_k(φ) V/(2a R Δφ)                   (depth of a raceway, a volume V worn off at φ)
//! bare = t²(3 − 2t),     t = 3(d/h − ⅔), 0 to 1                                        (part of the coating gone)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | w | volume worn per time | m³/s |
//! | K_w, H | wear coefficient, hardness of the softer surface | –, Pa |
//! | p, Δv, A | contact pressure, sliding velocity, contact area | Pa, m/s, m² |
//! | Q, F | normal load on a race, in a cage pocket | N |
//! | D, r_i, r_o | ball diameter, groove radii of inner and outer race | m |
//! | R_i, R_o | radii of the groove bottoms about the bearing's axis | m |
//! | d_i, d_o | wear depths of inner and outer race | m |
//! | α_w | free contact angle, worn | rad |
//! | d, c_k, B_k | wear depth at azimuth φ, of bin k, quadratic B-spline | m, m, – |
//! | V, a, R, Δφ | volume, half the width of the track, its radius, width of a bin | m³, m, m, rad |
//! | h | thickness of the new coating | m |
//!
//! Sources: J. F. Archard, J. Appl. Phys. 24 (1953) 981, doi:10.1063/1.1721448; Zhang et al., Lubricants 2025, 13(8),
//! 352, doi:10.3390/lubricants13080352 (equation numbers are theirs; their printed Eqs. 12 and 13 lost signs, and the
//! form above is the one that gives the unworn contact angle at zero depth).
//!
//! Limits: mild wear, linear in load and sliding distance, one coefficient per pair. The worn angle takes wear as radial
//! clearance: depths are the same all round and across the groove, groove radii stay as they are, the ball does not wear.
//!
//! The law of the bare part is an assumption; its reason is at [`Raceway`], with what is not resolved across the groove.
//!
//! The crate does not know how pressure and sliding come about, how a bearing is solved, or how worn coatings slide.

mod archard;
mod defect;
mod geometry;
mod life;
mod raceway;
mod surface;

pub use archard::{Archard, archard_rate, cage_rate};
pub use defect::Defect;
pub use geometry::{GrooveGeometry, WearDepths};
pub use life::{BallWear, CoatingLife, RaceWear, Stride, WearRates};
pub use raceway::{BINS, ProfilePoint, Raceway};
pub use surface::LocalSurface;

/// Why a worn bearing has no contact angle, or what a raceway or its wear cannot be.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WearError {
    /// A ball diameter or groove-bottom radius that is not a length.
    #[error("{name} is {value} m: it must be finite and above 0")]
    Length {
        /// Which length.
        name: &'static str,
        /// The value given, m.
        value: f64,
    },
    /// A groove that does not fit round the ball.
    #[error(
        "groove radius of the {race} race is {value} m: it must be finite and above the ball's radius {ball_radius} m"
    )]
    Groove {
        /// Which race.
        race: &'static str,
        /// The groove radius given, m.
        value: f64,
        /// The ball's radius, m.
        ball_radius: f64,
    },
    /// A wear depth below zero.
    #[error("wear depth of the {race} race is {value} m: it must be finite and at least 0")]
    Depth {
        /// Which race.
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
    /// A part of a whole that is none.
    #[error("{name} is {value}: it must lie between 0 and 1")]
    Fraction {
        /// Which part.
        name: &'static str,
        /// The value given.
        value: f64,
    },
    /// A value that no defect has.
    #[error("{name} of a defect is {value}: allowed is {allowed}")]
    Defect {
        /// Which value.
        name: &'static str,
        /// The value given, m, rad or a fraction.
        value: f64,
        /// What is allowed.
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
