#![doc = include_str!("../README.md")]

mod ball_set;
mod clearance;
mod designation;
mod list;
mod new_case;
mod suffixes;

pub use ball_set::{BallSet, KnownBalls, Origin, Ratings, RunnerUp, USUAL_GROOVES};
pub use clearance::ClearanceGroup;
pub use list::{ListedBearing, PublishedBalls, SOURCE, find, listed, search};
pub use new_case::{Fits, Given, NewCase, NewLubricant};
pub use suffixes::Part;

/// Boundary dimensions of a bearing and its nominal contact angle, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Envelope {
    /// Bore d, m.
    pub bore: f64,
    /// Outside diameter D, m.
    pub outside: f64,
    /// Width B, m.
    pub width: f64,
    /// Nominal contact angle, rad: 0 for a deep-groove bearing.
    pub contact_angle: f64,
}

/// Why there is no bearing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CatalogueError {
    /// A lubricant that a new case cannot have.
    #[error("lubricant \"{word}\": allowed are ag, ptfe, grease, vg68 and the other grades, and oils such as pao-vg32")]
    Lubricant {
        /// The word.
        word: String,
    },
    /// A word that is no tolerance class.
    #[error("fit \"{word}\": allowed is a tolerance class of ISO 286, such as k5 for the shaft and H7 for the housing")]
    Fit {
        /// The word.
        word: String,
    },
    /// A designation that the list does not have.
    #[error("no bearing `{designation}` in the list; allowed: {allowed}; any other by --bore, --outside and --width")]
    Unknown {
        /// The designation asked for.
        designation: String,
        /// The sizes or series in the list.
        allowed: String,
    },
    /// Bearings that the models do not hold for.
    #[error("`{designation}` {why}")]
    Type {
        /// The designation asked for.
        designation: String,
        /// Why the models do not hold.
        why: String,
    },
    /// A part of a designation that is not understood.
    #[error(
        "`{part}` {place} the basic number of `{designation}` is not understood; allowed are {allowed}. Leave it out if it does not matter"
    )]
    Part {
        /// The designation asked for.
        designation: String,
        /// The part that is not understood.
        part: String,
        /// `before` or `after`.
        place: &'static str,
        /// Prefixes or suffixes that are understood there.
        allowed: String,
    },
    /// A contact angle that does not fit the designation.
    #[error("`{designation}` {why}")]
    Angle {
        /// The bearing.
        designation: String,
        /// The reason, with what is allowed.
        why: String,
    },
    /// A dimension that no bearing has.
    #[error("{quantity} is {value_mm} mm: it must be {allowed}")]
    Dimension {
        /// Which dimension.
        quantity: &'static str,
        /// Its value, mm.
        value_mm: f64,
        /// The allowed values.
        allowed: String,
    },
    /// A nominal contact angle beyond those of radial bearings.
    #[error("contact angle {angle_deg}°: allowed is 0° to 45°")]
    ContactAngle {
        /// The angle, degrees.
        angle_deg: f64,
    },
    /// Balls that do not stand side by side on the pitch circle.
    #[error("{count} balls of {diameter_mm} mm: at least 3, and as many as fit on the pitch circle side by side")]
    Count {
        /// Number of balls.
        count: usize,
        /// Ball diameter, mm.
        diameter_mm: f64,
    },
    /// A bearing that the standards do not rate.
    #[error(transparent)]
    Rating(tribodyn_rating::RatingError),
    /// No balls between the rings.
    #[error("no standard balls fit into the {space_mm} mm between bore and outside radius: give number and diameter")]
    NoBalls {
        /// Space between the radii, mm.
        space_mm: f64,
    },
}
