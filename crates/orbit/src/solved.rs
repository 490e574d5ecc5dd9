//! A solved orbit, and what is needed to go on from it.

use crate::collocation::Orbit;
use crate::newton::OrbitStatistics;
use crate::residual::Scales;
use crate::solution::SteadyOrbit;
use crate::way::Eased;
use tribodyn_bearing::Races;
use tribodyn_traction::PatchRule;

/// An orbit to start a neighbouring problem from.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitStart {
    pub(crate) orbit: Orbit,
    pub(crate) rule: PatchRule,
    pub(crate) rule_error: f64,
    /// Azimuth at which the turn begins, rad.
    pub(crate) origin: f64,
    /// Rate at which the swinging of balls dies out besides, 1/s.
    pub(crate) settling: f64,
    pub(crate) eased: Eased,
    pub(crate) scales: Scales,
    pub(crate) speeds: Races<f64>,
}

/// A steady orbit with what is needed to go on from it.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedOrbit {
    /// The orbit.
    pub solution: SteadyOrbit,
    /// Statistics of the solver.
    pub statistics: OrbitStatistics,
    /// Start for a neighbouring problem; none for a bearing at rest.
    pub start: Option<OrbitStart>,
}
