//! Where balls stand at time 0, what lies under them there, and the circles on which they touch the races.

use crate::bearing::Bearing;
use crate::races::{Races, Side};
use crate::state::BallSize;
use std::f64::consts::TAU;
use tribodyn_wear::{LocalSurface, Track};

impl Bearing {
    /// Azimuth of ball `index` at time 0, rad: ball 0 is at 0 unless the bearing has another place for it.
    pub fn azimuth(&self, index: usize) -> f64 {
        TAU * index as f64 / self.geometry.ball_count as f64 + self.deviations.first_ball
    }

    /// Size of ball `index`.
    pub fn ball_size(&self, index: usize) -> BallSize {
        let excess = self.deviations.balls.get(index);
        excess.map_or(BallSize::NOMINAL, |excess| BallSize::new(*excess, self.geometry.ball_diameter))
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
