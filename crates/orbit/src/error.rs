//! The errors of a steady orbit.

use crate::collocation::Orbit;
use crate::residual::Worst;
use crate::system::{BALL, OrbitSystem};
use std::f64::consts::TAU;
use tribodyn_quasistatic::QuasiStaticError;
use tribodyn_traction::TractionError;

/// Why there is no steady orbit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OrbitError {
    /// No attempt met all balances.
    #[error(
        "{reason}; the nearest state has the cage at {cage_speed_rpm:.1} r/min, {}",
        if residual <= tolerance {
            "and all balances are met, but no ball that is sent round keeps to it".to_owned()
        } else {
            format!("{equation} {place} off by {residual:.1e} of its terms (tolerance {tolerance:.1e})")
        }
    )]
    NotConverged {
        /// Why, as far as that is known.
        reason: OrbitReason,
        /// The worst balance.
        equation: &'static str,
        /// Where it is.
        place: OrbitPlace,
        /// Its relative residual.
        residual: f64,
        /// The tolerance asked for.
        tolerance: f64,
        /// The cage speed that was reached, r/min.
        cage_speed_rpm: f64,
    },
    /// The caller ended the search.
    #[error("the search for the steady orbit was stopped before it found one")]
    Ended,
    /// Rings that turn against each other as fast as leaves balls and cage in place: a turn has no end.
    #[error(
        "the rings turn against each other and the cage stands still, so that it has no orbit; \
         change one speed a little"
    )]
    CageStands,
    /// Rings that turn, and not against each other.
    #[error(
        "both rings turn at {} r/min and not against each other, so that balls and cage turn with them as one body \
         and nothing rolls",
        (speed_rad_s * 60e3 / TAU).round() / 1e3
    )]
    TurnsAsOne {
        /// Speed of both, rad/s.
        speed_rad_s: f64,
    },
    /// Balls at rest, where an orbit is asked for.
    #[error("balls and cage stand still; `transient.start` can be Rest")]
    AtRest,
    /// The linearised equations have no solution.
    #[error("the linearised equations of the orbit are singular")]
    Singular,
    /// A stiffness that does not pass its checks.
    #[error(
        "the stiffness of this orbit is uncertain ({}) and not given: balls touch pockets or lose contact too often \
         for one slope; try a slightly different load or speed, or differences of `solve` over larger steps",
        match error_estimate {
            Some(error) => format!("finer meshes and slightly other loads differ by {:.1} %", 100.0 * error),
            None => "its orbit is not found on a finer mesh or under slightly other loads".to_owned(),
        }
    )]
    Uncertain {
        /// Estimated error over √(K_ii K_jj); none where a check had no outcome.
        error_estimate: Option<f64>,
    },
    /// The eigenvalues of the linearised motion were not found.
    #[error("the eigenvalues of the linearised motion did not converge")]
    Eigenvalues,
    /// The start.
    #[error(transparent)]
    Start(#[from] QuasiStaticError),
    /// Patch quadrature.
    #[error(transparent)]
    Traction(#[from] TractionError),
}

/// Centrifugal force over the load of a ball beyond which nothing presses it on the inner race.
const NOTHING: f64 = 1e6;

/// Why a bearing has no steady orbit, or none that was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OrbitReason {
    /// Centrifugal force takes the balls off the inner race, which then does not drive them.
    GrossSkidding {
        /// Centrifugal force of a ball over the mean load of a ball on the inner race.
        centrifugal_share: f64,
    },
    /// Balls that the inner race does not touch over part of the turn, and that little else holds.
    IdleBalls {
        /// Centrifugal force of a ball over the mean load of a ball on the inner race.
        centrifugal_share: f64,
    },
    /// Neither.
    Unknown,
}

impl std::fmt::Display for OrbitReason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::GrossSkidding { centrifugal_share } if *centrifugal_share > NOTHING => f.write_str(
                "gross skidding: nothing presses the balls on the inner race, and no steady orbit was found; raise the load \
                 or reduce the clearance",
            ),
            Self::GrossSkidding { centrifugal_share } => write!(
                f,
                "gross skidding: centrifugal force is {centrifugal_share:.1} times the load that presses a ball on the inner \
                 race, and no steady orbit was found; raise the load, reduce the speed or take lighter balls"
            ),
            Self::IdleBalls { centrifugal_share } => write!(
                f,
                "balls without inner contact keep swinging in their grooves (centrifugal force is \
                 {centrifugal_share:.1e} of the mean load of a ball), and no steady orbit was found; raise the axial \
                 load, reduce the clearance, or simulate a run in time"
            ),
            Self::Unknown => f.write_str(
                "no steady orbit was found; try a slightly different load or speed, or simulate a run in time",
            ),
        }
    }
}

/// Where a residual is left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OrbitPlace {
    /// A ball at an azimuth, degrees.
    Ball {
        /// The azimuth.
        azimuth_deg: f64,
    },
    /// Cage or ring.
    Body,
}

impl std::fmt::Display for OrbitPlace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Ball { azimuth_deg } => write!(f, "of a ball at {azimuth_deg:.1}°"),
            Self::Body => f.write_str("over the turn"),
        }
    }
}

const OF_BALL: [&str; BALL] = [
    "axial velocity",
    "radial velocity",
    "lead over the pocket",
    "axial force",
    "radial force",
    "force along the orbit",
    "axial moment",
    "radial moment",
    "tangential moment",
];
const OF_BODIES: [&str; 6] = [
    "torque on the cage",
    "force along x on the ring",
    "force along y on the ring",
    "axial force on the ring",
    "moment about x on the ring",
    "moment about y on the ring",
];

impl OrbitError {
    /// The same with its reason.
    pub(crate) fn because(mut self, why: OrbitReason) -> Self {
        if let Self::NotConverged { reason, .. } = &mut self {
            *reason = why;
        }
        self
    }

    /// The one of the state that came nearer.
    pub(crate) fn nearer(self, other: Self) -> Self {
        match (&self, &other) {
            (Self::NotConverged { residual, .. }, Self::NotConverged { residual: left, .. }) if left < residual => {
                other
            }
            _ => self,
        }
    }

    pub(crate) fn not_converged(system: &OrbitSystem<'_>, orbit: &Orbit, worst: &Worst, tolerance: f64) -> Self {
        let (place, equation) = match worst.interval {
            Some(j) => {
                let azimuth_deg = system.azimuth(orbit.interval(j)[0]).to_degrees().rem_euclid(360.0);
                (OrbitPlace::Ball { azimuth_deg }, OF_BALL[worst.equation])
            }
            None => (OrbitPlace::Body, OF_BODIES[worst.equation]),
        };
        let cage_speed_rpm = orbit.cage_speed * 60.0 / TAU;
        let reason = OrbitReason::Unknown;
        Self::NotConverged { reason, equation, place, residual: worst.relative, tolerance, cage_speed_rpm }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_an_orbit_that_no_ball_keeps_to_is_not_said_to_miss_a_balance() {
        let said = |residual| {
            let (reason, place) = (OrbitReason::Unknown, OrbitPlace::Body);
            let equation = "torque on the cage";
            OrbitError::NotConverged { reason, equation, place, residual, tolerance: 1e-10, cage_speed_rpm: 100.0 }
                .to_string()
        };
        assert!(said(4e-13).ends_with("but no ball that is sent round keeps to it"), "{}", said(4e-13));
        assert!(
            said(1e-3).ends_with("torque on the cage over the turn off by 1.0e-3 of its terms (tolerance 1.0e-10)")
        );
    }

    #[test]
    fn limit_a_bearing_that_skids_as_a_whole_says_so_with_advice() {
        let said = |centrifugal_share| OrbitReason::GrossSkidding { centrifugal_share }.to_string();
        for nothing in [f64::INFINITY, 1.6e13] {
            assert!(said(nothing).starts_with("gross skidding: nothing presses the balls"), "{}", said(nothing));
            assert!(said(nothing).ends_with("reduce the clearance"), "{}", said(nothing));
        }
        assert!(said(4.3).contains("centrifugal force is 4.3 times the load"), "{}", said(4.3));
    }
}
