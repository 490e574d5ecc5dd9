//! An operating point of a bearing: what its ring carries, how fast it turns, and what a solver needs to know besides.
//! It stands below the solvers, so that case files can give one without them.

use crate::bearing::Bearing;
use crate::watch::SearchWatch;
use std::f64::consts::PI;
use tribodyn_fluid::CageChurning;
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

/// Difference of the speeds of two rings, over either, that is rounding: of products of π and a speed in r/min.
const SAME_SPEED: f64 = 1e-12;

impl OperatingPoint {
    /// True where both rings turn, and not against each other: balls and cage turn with them as one body.
    pub fn turns_as_one(&self) -> bool {
        let [inner, outer] = [self.inner_speed, self.outer_speed];
        inner != 0.0 && (inner - outer).abs() <= SAME_SPEED * inner.abs()
    }
}

/// Load on a degree of freedom of the ring, or the position at which it is held.
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
    /// Its form, for the churning of the fluid of the bearing; absent where that has no part.
    pub form: Option<CageForm>,
}

/// Form of a cage that a fluid brakes: a ring with pockets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageForm {
    /// Diameter of its bore, m.
    pub bore: f64,
    /// Outside diameter, m.
    pub outside: f64,
    /// Width along the axis, m.
    pub width: f64,
}

impl Cage {
    /// Braking of the cage by the fluid of a bearing; absent in a dry bearing, or without a form. Pockets are as wide
    /// as ball and gaps.
    pub fn churning(&self, bearing: &Bearing) -> Option<CageChurning> {
        let (form, fluid, g) = (self.form?, bearing.fluid.as_ref()?, &bearing.geometry);
        let pocket = g.ball_diameter + 2.0 * self.pocket_gap;
        Some(CageChurning {
            density: fluid.density,
            viscosity: fluid.viscosity,
            radii: [0.5 * form.bore, 0.5 * form.outside],
            width: form.width,
            pockets: g.ball_count as f64 * 0.25 * PI * pocket * pocket,
        })
    }
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
