//! A solved orbit, and what is needed to go on from it.

use crate::collocation::{Orbit, Radau};
use crate::newton::{Jacobian, OrbitStatistics};
use crate::residual::Scales;
use crate::solution::SteadyOrbit;
use crate::way::Eased;
use std::f64::consts::TAU;
use tribodyn_bearing::{AzimuthFrame, BallState, Motion, Races};
use tribodyn_traction::PatchRule;

/// An orbit to start a neighbouring problem from.
#[derive(Debug, Clone)]
pub struct OrbitStart {
    pub(crate) orbit: Orbit,
    /// The last Jacobian on the orbit's mesh, where there was one.
    pub(crate) jacobian: Option<Jacobian>,
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

impl OrbitStart {
    /// Balls, cage and ring at the instant when pocket 0 stands at azimuth 0.
    pub fn motion(&self, ball_count: usize) -> Motion {
        let (radau, orbit) = (Radau::new(), &self.orbit);
        let ball = |index: usize| {
            let pocket = TAU * index as f64 / ball_count as f64;
            let turn = orbit.cage_speed.signum() * (pocket - self.origin) / TAU;
            let [x1, x2, lead, v_a, v_r, orbital_speed, spin @ ..] = orbit.at(&radau, turn);
            let azimuth = pocket + lead;
            let frame = AzimuthFrame::at(azimuth);
            (azimuth, BallState { frame, position: [x1, x2], velocity: [v_a, v_r], orbital_speed, spin })
        };
        Motion { balls: (0..ball_count).map(ball).collect(), cage_speed: orbit.cage_speed, ring: orbit.ring }
    }

    /// Patch rule of the orbit.
    pub fn rule(&self) -> PatchRule {
        self.rule
    }
}

/// A steady orbit with what is needed to go on from it.
#[derive(Debug, Clone)]
pub struct SolvedOrbit {
    /// The orbit.
    pub solution: SteadyOrbit,
    /// Statistics of the solver.
    pub statistics: OrbitStatistics,
    /// Start for a neighbouring problem; none for a bearing at rest.
    pub start: Option<OrbitStart>,
}
