//! Form and size that differ from the drawing: waviness of the races, balls of unequal diameter, and where races and
//! balls stand.

use crate::races::{Races, Side};
use tribodyn_wear::Profile;

/// Deviations of a bearing from its drawing. They enter the elastic approach of each contact by a depth h,
/// δ = δ_rigid − h: that of the race where the ball stands, less half of what the ball is too large. Mass, inertia and
/// rolling radius of a ball are its own (`crate::BallSize`); contact constants and its play in the pocket are those of
/// the drawing.
#[derive(Debug, Clone, Default)]
pub struct Deviations {
    /// Waviness of the races; absent on a round one.
    pub waviness: Races<Option<Profile>>,
    /// Diameter of each ball over the nominal one, m; empty where all balls are equal.
    pub balls: Vec<f64>,
    /// Azimuth of ball 0 at time 0, rad.
    pub first_ball: f64,
    /// How far the rings have turned at time 0, rad.
    pub turned: Races<f64>,
}

impl Deviations {
    /// True if all races are round and all balls equal.
    pub fn are_none(&self) -> bool {
        self.balls.is_empty() && self.waviness.inner.is_none() && self.waviness.outer.is_none()
    }

    /// Depth at the contact of a ball with a race, m, and its derivative by the azimuth, m/rad, at an azimuth in the
    /// ring's own frame.
    #[inline]
    pub fn at(&self, side: Side, ball: usize, azimuth: f64) -> (f64, f64) {
        let (depth, slope) = self.waviness[side].as_ref().map_or((0.0, 0.0), |profile| profile.at(azimuth));
        match self.balls.get(ball) {
            Some(excess) => (depth - 0.5 * excess, slope),
            None => (depth, slope),
        }
    }
}
