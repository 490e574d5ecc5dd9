//! Archard wear of races and cage, and the contact angle of a worn ball bearing.
//!
//! # Equations
//! ```text
//! w = K_w Q Δv/H                                           (Archard, volume per time; Eqs. 6–9)
//! race:  w = (K_w/H) ∬ p |Δv| dA,    cage:  w = (K_w/H) F |Δv|
//! cos α_w = [r_i + r_o − (R_o − R_i) − (d_i + d_o)]/(r_i + r_o − D)                     (Eqs. 12, 13)
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
//!
//! Sources: J. F. Archard, J. Appl. Phys. 24 (1953) 981, doi:10.1063/1.1721448; Zhang et al., Lubricants 2025, 13(8),
//! 352, doi:10.3390/lubricants13080352 (equation numbers are theirs; their printed Eqs. 12 and 13 lost signs, and the
//! form above is the one that gives the unworn contact angle at zero depth).
//!
//! Limits: mild wear, linear in load and sliding distance, one coefficient per pair. The worn angle takes wear as radial
//! clearance: depths are the same all round and across the groove, groove radii stay as they are, the ball does not wear.
//!
//! The crate does not know how pressure and sliding come about, what the volume does to a coating, or how time passes.

mod archard;
mod geometry;
mod surface;

pub use archard::{Archard, archard_rate, cage_rate};
pub use geometry::{GrooveGeometry, WearDepths};
pub use surface::LocalSurface;

/// Why a worn bearing has no contact angle.
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
}
