//! What a ball bearing is: its geometry and the one ball–race interaction that the quasi-static and the transient solver
//! share.
//!
//! # Equations
//! ```text
//! A = (f_i + f_o − 1) D,   A1 = A sin α0 + z_i + (θ_x sin φ − θ_y cos φ) R_i,   A2 = A cos α0 + (x_i − x_o)·e_r
//! l_o = |(X1, X2)|,  l_i = |(A1 − X1, A2 − X2)|,   δ = l − (f − ½) D,   Q = K_n δ^1.5
//! r_c = d_m/2 − (f_o − ½) D cos α0 + X2 + x_o·e_r
//! Δv = v_ball + Ω × P − v_race − ω_race e_a × (r_c e_r + P − x_race)
//! force on the ball = −Q n + T at each race, drag −F_d e_t, (1/r_c)(−Q_i cos α_i x_i·e_t + Q_o cos α_o x_o·e_t) e_t
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | D, d_m, f | ball diameter, pitch diameter, groove radius over D | m, m, – |
//! | α0, α | free and actual contact angle | rad |
//! | x, y, z, θ | ring displacement (radial, radial, axial), tilt about X and Y | m, rad |
//! | X1, X2 | ball centre from the outer groove centre, axial and radial | m |
//! | δ, Q | elastic approach, load of a contact | m, N |
//! | ω_m, Ω | orbital speed, absolute angular velocity of a ball | rad/s |
//! | n, e_y, e_t | outward contact normal, across the groove, along the orbit | – |
//!
//! Sources: Jones 1959, doi:10.1115/1.4008346 (groove-centre geometry); Zhang et al., Lubricants 2025, 13(8), 352,
//! doi:10.3390/lubricants13080352 (slip and traction).
//!
//! Limits: rigid rings and races, small ring tilts (they move the groove centres, not the direction of rotation),
//! Hertzian contacts, balls of one size. The crate solves nothing: it says what forces a given state has. It reads no files.

mod bearing;
mod frame;
mod geometry;
mod interaction;
mod normal;
mod operation;
mod races;
mod state;
#[cfg(test)]
mod test_bearing;

pub use bearing::{Bearing, BearingSpec, FluidForces, Race};
pub use frame::AzimuthFrame;
pub use geometry::{ContactPose, Dimensions, Fit, Geometry};
pub use interaction::{ContactForces, Sliding};
pub use normal::{Lean, NormalContact, NormalLoads, RingOffset};
pub use operation::{Cage, OperatingPoint, RaceControl, RingFreedom, SolverSettings};
pub use races::{Races, Side};
pub use state::{BallLoads, BallPose, BallState, LoadedPatch, RaceContact, RingState};
pub use tribodyn_contact::{Ellipse, Scalar};
pub use tribodyn_wear::LocalSurface;

/// Why data do not make a bearing.
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
