#![doc = include_str!("../README.md")]

mod bearing;
pub mod case;
mod frame;
mod geometry;
mod interaction;
mod normal;
mod races;
mod state;

pub use bearing::{Bearing, FluidForces, Race};
pub use frame::AzimuthFrame;
pub use geometry::{ContactPose, Geometry};
pub use interaction::{ContactForces, Sliding};
pub use normal::{Lean, NormalContact, NormalLoads, RingOffset};
pub use races::{Races, Side};
pub use state::{BallLoads, BallPose, BallState, LoadedPatch, RaceContact, RingState};
pub use tribodyn_contact::{Ellipse, Scalar};
pub use tribodyn_fluid as fluid;
pub use tribodyn_traction as traction;
pub use tribodyn_wear as wear;
pub use tribodyn_wear::LocalSurface;

/// Why a case does not make a bearing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BearingError {
    /// A clearance that no contact angle has.
    #[error("radial clearance {clearance} m is outside 0 to {limit} m, twice the distance of the groove centres")]
    Clearance {
        /// Diametral clearance, m.
        clearance: f64,
        /// Largest possible, m.
        limit: f64,
    },
    /// Contact constants.
    #[error(transparent)]
    Contact(#[from] tribodyn_contact::ContactError),
    /// Traction data.
    #[error(transparent)]
    Traction(#[from] tribodyn_traction::TractionError),
    /// Wear of the raceways.
    #[error(transparent)]
    Wear(#[from] tribodyn_wear::WearError),
    /// Fluid state.
    #[error(transparent)]
    Fluid(#[from] tribodyn_fluid::FluidError),
}
