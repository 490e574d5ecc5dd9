//! The basic reference rating life L_10r of ISO/TS 16281: from the load of every ball.

use crate::dynamic_rating::race_ratio;
use crate::{RatedBearing, RatingError, load, positive};

/// Which ring turns against the direction of the load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turning {
    /// The inner ring; also for a bearing at rest, as a bearing is usually rated.
    Inner,
    /// The outer ring.
    Outer,
    /// Both.
    Both,
}

impl Turning {
    /// From the speeds of the rings in the frame in which the load stands still, in any unit.
    pub fn of_speeds(inner: f64, outer: f64) -> Self {
        match (inner != 0.0, outer != 0.0) {
            (true, true) => Self::Both,
            (false, true) => Self::Outer,
            _ => Self::Inner,
        }
    }
}

/// Loads of all balls on both races, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallLoads<'a> {
    /// On the inner race.
    pub inner: &'a [f64],
    /// On the outer race; at speed the centrifugal forces are in it.
    pub outer: &'a [f64],
    /// Which ring turns against the load.
    pub turning: Turning,
}

/// A life from a distribution of load, and what it rests on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceLife {
    /// Life that 90 % of such bearings reach, 10⁶ revolutions; absent where no ball carries load.
    pub life_mrev: Option<f64>,
    /// Reference equivalent load P_ref = C_r/L_10r^(1/3), N: the radial load of a catalogue with this life.
    pub equivalent_load: f64,
    /// Rolling element load Q_c of the inner and the outer race, N, that it bears for 10⁶ revolutions.
    pub capacities: [f64; 2],
    /// Equivalent ball load Q_e of the inner and the outer race, N.
    pub ball_loads: [f64; 2],
}

/// Hours that a life of 10⁶ revolutions takes at a speed of the rings against each other, rad/s; absent at rest.
pub fn hours(life_mrev: f64, relative_speed: f64) -> Option<f64> {
    let turns_per_hour = relative_speed.abs() * 3600.0 / (2.0 * std::f64::consts::PI);
    let hours = life_mrev * 1e6 / turns_per_hour;
    (turns_per_hour > 0.0 && hours.is_finite()).then_some(hours)
}

/// Exponents of the mean of the ball loads on a ring that turns against the load and on one that stands under it.
const TURNING: f64 = 3.0;
const STANDING: f64 = 10.0 / 3.0;

impl RatedBearing {
    /// L_10r of a distribution of ball loads, with C_r in N from the catalogue or from [`Self::dynamic_rating`].
    ///
    /// # Errors
    /// [`RatingError`] for loads below 0 or of another number of balls, for a rating that is not above 0, and for
    /// dimensions that are not those of a radial ball bearing.
    pub fn reference_life(&self, dynamic_rating: f64, loads: &BallLoads<'_>) -> Result<ReferenceLife, RatingError> {
        self.check()?;
        positive("dynamic load rating", dynamic_rating, "N")?;
        for (race, found) in [("inner", loads.inner.len()), ("outer", loads.outer.len())] {
            if found != self.ball_count {
                return Err(RatingError::Count { race, found, expected: self.ball_count });
            }
        }
        let exponents = match loads.turning {
            Turning::Inner => [TURNING, STANDING],
            Turning::Outer => [STANDING, TURNING],
            Turning::Both => [TURNING, TURNING],
        };
        let capacities = self.capacities(dynamic_rating);
        let ball_loads = [mean(loads.inner, exponents[0])?, mean(loads.outer, exponents[1])?];
        let term = |k: usize| (ball_loads[k] / capacities[k]).powf(10.0 / 3.0);
        let damage = term(0) + term(1);
        let life = damage.powf(-0.9);
        Ok(ReferenceLife {
            life_mrev: (damage > 0.0 && life.is_finite()).then_some(life),
            equivalent_load: dynamic_rating * damage.powf(0.3),
            capacities,
            ball_loads,
        })
    }

    /// Q_ci and Q_ce, N.
    fn capacities(&self, dynamic_rating: f64) -> [f64; 2] {
        let ratio = race_ratio(1.044, self.gamma(), self.inner_coefficient, self.outer_coefficient);
        let each = dynamic_rating / (self.ball_count as f64 * self.contact_angle.cos());
        let part = |constant: f64, power: f64| each / constant * (1.0 + ratio.powf(power)).powf(0.3);
        [part(0.407, 10.0 / 3.0), part(0.389, -10.0 / 3.0)]
    }
}

/// (mean Q^p)^(1/p), N.
fn mean(loads: &[f64], exponent: f64) -> Result<f64, RatingError> {
    let mut sum = 0.0;
    for value in loads {
        sum += load("load of a ball", *value)?.powf(exponent);
    }
    Ok((sum / loads.len() as f64).powf(1.0 / exponent))
}
