//! An operating point of a bearing: what its ring carries, how fast it turns, and what a solver needs to know besides.
//! It stands below the solvers, so that case files can give one without them.

use crate::watch::SearchWatch;
use tribodyn_traction::PatchChoice;

/// A bearing at an operating point, with the solver's settings.
#[derive(Debug, Clone, PartialEq)]
pub struct OperatingPoint {
    /// Load or held position of x, y, z, tilt about X, tilt about Y of the inner ring.
    pub ring: [RingFreedom; 5],
    /// Speed of the inner ring, rad/s.
    pub inner_speed: f64,
    /// Speed of the outer ring, rad/s.
    pub outer_speed: f64,
    /// Quadrature over the contact patches; models with traction need it.
    pub patch: Option<PatchChoice>,
    /// The cage, for the pocket forces; models with traction need it.
    pub cage: Option<Cage>,
    /// Solver settings.
    pub numerics: SolverSettings,
    /// By which a search is followed and ended.
    pub watch: SearchWatch,
}

/// What each ring freedom carries or where it is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RingFreedom {
    /// External force (N) or moment (N m) on the inner ring.
    Loaded(f64),
    /// Held displacement (m) or tilt (rad).
    Held(f64),
}

/// Pockets of a cage and the drag on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cage {
    /// Circumferential gap between ball and pocket wall on either side when centred, m.
    pub pocket_gap: f64,
    /// Pocket contact stiffness, N/m.
    pub pocket_stiffness: f64,
    /// Drag torque on the cage (positive retards it), N m.
    pub drag_torque: f64,
}

/// Settings of a quasi-static solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolverSettings {
    /// Largest relative residual of any balance at which the solver stops.
    pub tolerance: f64,
    /// Newton steps before the solver gives up; a cold start takes 10 to 40.
    pub max_iterations: usize,
}

impl Default for SolverSettings {
    fn default() -> Self {
        Self {
            // Each balance to ten digits: five more than any published figure has, five above rounding.
            tolerance: 1e-10,
            // A cold start takes 10 to 40 steps; more means that it will not converge.
            max_iterations: 200,
        }
    }
}
