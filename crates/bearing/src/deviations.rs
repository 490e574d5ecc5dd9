//! Form and size that differ from the drawing: waviness of the races, balls of unequal diameter, and where races and
//! balls stand.

use crate::bearing::Bearing;
use crate::races::{Races, Side};
use std::f64::consts::TAU;
use tribodyn_wear::{LocalSurface, Profile, Track};

/// Deviations of a bearing from its drawing. They enter the elastic approach of each contact by a depth h,
/// δ = δ_rigid − h: that of the race where the ball stands, less half of what the ball is too large. Mass and rolling
/// radius of a ball stay those of the drawing: they differ by some 1e-4.
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

impl Bearing {
    /// Azimuth of ball `index` at time 0, rad: ball 0 is at 0 unless the bearing has another place for it.
    pub fn azimuth(&self, index: usize) -> f64 {
        TAU * index as f64 / self.geometry.ball_count as f64 + self.deviations.first_ball
    }

    /// Radius of the circle on which the balls touch a race at the free contact angle, m.
    pub fn track_radius(&self, side: Side) -> f64 {
        let g = &self.geometry;
        let outwards = g.ball_radius() * g.cos_contact_angle();
        0.5 * g.pitch_diameter + if side == Side::Inner { -outwards } else { outwards }
    }

    /// A raceway as a ball on it sees a spall, with the contact ellipse of a load (N).
    pub fn track(&self, side: Side, load: f64) -> Track {
        let g = &self.geometry;
        let ellipse = self.races[side].frozen::<f64>().ellipse(load);
        Track {
            ball_radius: g.ball_radius(),
            radius: self.track_radius(side),
            outer: side == Side::Outer,
            cosine: g.cos_contact_angle(),
            semi_rolling: ellipse.semi_rolling(),
            semi_lateral: ellipse.semi_lateral(),
        }
    }

    /// Depth by deviations of form and size under a ball in its place of time 0, m.
    pub fn depth_under(&self, index: usize, side: Side) -> f64 {
        if self.deviations.are_none() {
            return 0.0;
        }
        self.deviations.at(side, index, self.azimuth(index) - self.deviations.turned[side]).0
    }

    /// The surfaces under a ball in its place of time 0. They have no slope: in the mean over a wave it moves no ball,
    /// and what it does to one on its way is for a run to tell.
    pub fn surfaces_under(&self, index: usize) -> Races<LocalSurface> {
        Races::from_fn(|side| LocalSurface { depth: self.depth_under(index, side), ..self.worn[side] })
    }
}
