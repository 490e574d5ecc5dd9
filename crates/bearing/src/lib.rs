#![doc = include_str!("../README.md")]

mod across;
mod bearing;
mod cage;
mod contact;
mod cylinder;
mod deviations;
mod elastic;
mod films;
pub mod fits;
mod frame;
mod free_cage;
mod geometry;
mod growth;
mod history;
mod interaction;
mod lean;
mod meridian;
mod modelling;
mod motion;
mod normal;
mod operation;
mod patch_traction;
mod places;
mod pocket;
mod quadrature_error;
pub mod quantities;
mod races;
mod result;
mod run_inputs;
mod side;
mod sliding;
mod state;
#[cfg(test)]
mod test_bearing;
mod tribology;
pub mod vectors;
mod watch;

pub use bearing::{Bearing, BearingSpec, FluidForces, Race};
pub use cage::{CageBody, Guidance};
pub use contact::{BallLoads, BallPose, LoadedPatch, NormalContact, NormalLoads, RaceContact};
pub use cylinder::{Cylinder, Solid};
pub use deviations::Deviations;
pub use elastic::ElasticPatches;
pub use frame::AzimuthFrame;
pub use free_cage::{
    CageLand, CagePose, FREE_CAGE, FreeCage, Gauge, InPocket, LandFilm, LandLoad, PocketShape, PocketWall, Wrench,
    WrenchSlope, quaternion_rate,
};
pub use geometry::{ContactPose, Dimensions, Fit, Geometry, Shoulders};
pub use growth::{GrownBearing, Growth, MountedRing, Seat};
pub use history::{RingLoads, SpeedHistory, Tilt, Translation};
pub use lean::{Lean, RingOffset};
pub use modelling::{
    Equations, GyroscopicFriction, GyroscopicMoment, Modelling, OpenChoice, PatchSurfaces, PocketForce, RaceControl,
    RingCentre, RollingRadius,
};
pub use motion::BallFriction;
pub use normal::ContactSprings;
pub use operation::{Cage, CageForm, OperatingPoint, RingFreedom, SolverSettings};
pub use pocket::{Pocket, PocketLoad, PocketMotion};
pub use races::{Races, Side};
pub use result::{
    BallMotionResult, BallPlace, BallResult, ContactResult, FilmResult, FluidResult, FrictionResult, PocketResult,
    Sheet, TransientContact,
};
pub use run_inputs::{
    BallSpall, CoatingState, GuidingLand, MovingCage, PocketFilm, RunInputs, RunOptions, Scheme, Start, Support,
    Supports, TiltingRing,
};
pub use side::{WrongSide, uncarried_thrust, wrong_sides};
pub use sliding::{ContactForces, Sliding};
pub use state::{BallSize, BallState, Motion, RingState};
pub use tribodyn_contact::{ElasticBody, Ellipse, Scalar};
pub use tribodyn_fluid::FilmExtent;
pub use tribodyn_wear::LocalSurface;
pub use tribology::{TransferredFilm, Tribology};
pub use watch::{SearchObserver, SearchStage, SearchWatch};

/// Why data do not make a bearing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BearingError {
    /// A clearance that no contact angle has.
    #[error(
        "radial clearance {clearance} m is outside {least} to {most} m: at most twice the distance of the groove centres, and no more interference than a tenth of it"
    )]
    Clearance {
        /// Diametral clearance, m.
        clearance: f64,
        /// Largest interference, m, below 0.
        least: f64,
        /// Largest possible clearance, m.
        most: f64,
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
    /// Data of a lubricant.
    #[error(transparent)]
    Lubricant(#[from] tribodyn_lubricant::LubricantError),
    /// Fluid state.
    #[error(transparent)]
    Fluid(#[from] tribodyn_fluid::FluidError),
}
