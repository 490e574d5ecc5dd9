//! The errors of a solution.

use crate::Model;
use tribodyn_traction::TractionError;

/// Where a residual is left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A ball.
    Ball {
        /// Its index.
        index: usize,
        /// Its azimuth, degrees.
        azimuth_deg: f64,
    },
    /// The inner ring.
    Ring,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Ball { index, azimuth_deg } => write!(f, "ball {index} at {azimuth_deg:.1}°"),
            Self::Ring => f.write_str("the inner ring"),
        }
    }
}

/// Reason why a bearing has no equilibrium, by the state that came nearest to one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reason {
    /// All balances are met as far as rounding lets them.
    Rounding {
        /// A tolerance that can be met.
        attainable: f64,
    },
    /// Drag is stronger than the friction of the inner race, or nearly: no steady rolling.
    Skidding {
        /// Balls that skid, and balls that the inner race does not press on.
        skidding: usize,
        /// Balls without inner contact.
        idle: usize,
        /// All balls.
        balls: usize,
        /// Mean orbital speed at the nearest state, r/min.
        cage_speed_rpm: f64,
        /// The same if all balls rolled, r/min.
        rolling_rpm: f64,
    },
    /// The race that controls would have to hold the gyroscopic moment by more friction than there is.
    RacewayControl {
        /// Friction over load that the controlling race would need, the largest of all balls.
        friction: f64,
        /// Speed of the rings up to which there is an equilibrium, over the speed asked for.
        speed_share: f64,
    },
    /// None of these.
    Unknown,
}

impl std::fmt::Display for Reason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Rounding { attainable } => write!(
                f,
                "rounding limits the balances at this slip scale; set numerics.tolerance to {attainable:.0e} or more"
            ),
            Self::Skidding { skidding, idle, balls, cage_speed_rpm, rolling_rpm } => write!(
                f,
                "no steady state was found; at the nearest {skidding} of {balls} balls skid, {idle} are off the inner race, and the cage turns at {cage_speed_rpm:.0} r/min instead of {rolling_rpm:.0} r/min rolling: raise the axial load or reduce the drag, or simulate a run in time"
            ),
            Self::RacewayControl { friction, speed_share } => {
                let share = 100.0 * speed_share;
                write!(f, "raceway control has an equilibrium only up to {share:.0} % of this speed; ")?;
                if friction.is_finite() {
                    write!(f, "the controlling race holds the gyroscopic moment with a friction of {friction:.2} of its load")?;
                } else {
                    f.write_str("the controlling race cannot hold a ball without load")?;
                }
                f.write_str(": take another race_control, more load, or the model with traction")
            }
            Self::Unknown => f.write_str(
                "neither Newton's method nor pseudo-time stepping converged: raise max_iterations, change load or speed a little, or simulate a run in time"
            ),
        }
    }
}

/// Why there is no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuasiStaticError {
    /// The iteration stopped above the tolerance.
    #[error(
        "{model} model did not converge: {equation} of {place} has a relative residual of {residual:.3e} after \
         {iterations} steps (tolerance {tolerance:.1e}): {reason}"
    )]
    NotConverged {
        /// Which equations.
        model: Model,
        /// The worst balance.
        equation: &'static str,
        /// Where it is.
        place: Place,
        /// Its relative residual.
        residual: f64,
        /// Newton steps taken.
        iterations: usize,
        /// The tolerance asked for.
        tolerance: f64,
        /// The reason, with a remedy.
        reason: Box<Reason>,
    },
    /// The caller ended the search.
    #[error("the search for the equilibrium was stopped before it found one")]
    Ended,
    /// A ball whose balances have no unique solution.
    #[error("ball {ball} has no unique answer to a displacement of the ring")]
    Singular {
        /// Its index.
        ball: usize,
    },
    /// A stiffness matrix that equilibria beside it do not confirm.
    #[error(
        "the stiffness at this equilibrium is uncertain: equilibria beside it differ from it by {:.1} %, as where a \
         contact begins or ends; the steady orbit has a mean",
        100.0 * error
    )]
    Uncertain {
        /// Estimated error over √(K_ii K_jj).
        error: f64,
    },
    /// The bearing or the operating point lacks what the model uses.
    #[error("{model} model needs what is not given: {}", missing.join(", "))]
    Missing {
        /// Which equations.
        model: Model,
        /// All that is missing.
        missing: Vec<&'static str>,
    },
    /// A load that presses the balls on a side of their grooves that has no shoulder, or on none.
    #[error(
        "the grooves have a shoulder on one side only (`geometry.shoulders`), on which a positive axial load presses the balls, and the axial load `ring.z` is {axial_n} N{}",
        wrong_way(*axial_n)
    )]
    NoShoulder {
        /// Axial load, N.
        axial_n: f64,
    },
    /// Balls that the inner race presses nowhere, while the ring is loaded.
    #[error(
        "{model} model: no equilibrium was found in which a ball is loaded; what is left carries the ring by friction \
         without load: take another race_control, more load, or the model with traction"
    )]
    NoLoadedBall {
        /// Which equations.
        model: Model,
    },
    /// Patch quadrature.
    #[error(transparent)]
    Traction(#[from] TractionError),
}

/// Remedy for an axial load that no shoulder carries.
fn wrong_way(axial_n: f64) -> &'static str {
    if axial_n < 0.0 {
        ": turn its sign, or give the grooves both shoulders where they have them"
    } else {
        ": a radial load alone pushes such a bearing apart; give it an axial load or a preload above 0, or hold `ring.z`"
    }
}
