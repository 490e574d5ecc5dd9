//! How the wear of a contact is spread across the groove.

use crate::bearing::Bearing;
use crate::races::Side;
use crate::result::BallResult;
use std::f64::consts::PI;
use tribodyn_traction::{Patch, RelativeMotion, SlipField};
use tribodyn_wear::ContactWear;

/// Strips across a contact; two would do for its volume, these show where the slip vanishes.
const STRIPS: usize = 48;
/// Nodes along a strip, of the Chebyshev rule of the second kind.
const ALONG: usize = 12;

impl Bearing {
    /// Wear of a race under a ball, in strips across the groove: ∫ p |Δv| dx of each, from the motion of the ball
    /// against a race that turns at `ring_speed` (rad/s). Together they make up the ball's wear rate. Where surfaces
    /// give way under shear the proportions are those of rigid ones.
    pub fn contact_wear(&self, side: Side, ball: &BallResult, ring_speed: f64) -> ContactWear {
        let contact = &ball.contacts[side];
        let [semi_lateral, semi_rolling] = contact.semi_axes_m;
        let groove = self.geometry.coefficient(side) * self.geometry.ball_diameter;
        let patch = Patch {
            semi_lateral,
            semi_rolling,
            peak_pressure: contact.peak_pressure_pa,
            ball_radius: self.geometry.ball_radius(),
            surface_radius: self.races[side].surface_radius,
        };
        let across = match contact.load_n > 0.0 {
            true => strips(&SlipField::new(&patch, &self.motion_of(side, ball, ring_speed))),
            false => Vec::new(),
        };
        ContactWear {
            azimuth: ball.azimuth_rad,
            angle: contact.angle_rad,
            half_width: semi_lateral / groove,
            load: contact.load_n,
            volume_rate: if across.is_empty() { 0.0 } else { contact.friction_or_nan().wear_rate_m3_s },
            across,
        }
    }

    /// The motion of a ball against a race, from its result.
    fn motion_of(&self, side: Side, ball: &BallResult, ring_speed: f64) -> RelativeMotion {
        let contact = &ball.contacts[side];
        let radius = self.geometry.ball_radius();
        let (sin, cos) = contact.angle_rad.sin_cos();
        let [n_a, n_r] = if side == Side::Outer { [sin, cos] } else { [-sin, -cos] };
        let [axial, radial, along] = ball.angular_velocity_rad_s;
        let against = axial + ball.orbital_speed_rad_s - ring_speed;
        // The result has the magnitude of the rolling speed; its sign goes with that of the ball's surface.
        let surfaces = (axial * n_r - radial * n_a) * radius
            + (ring_speed - ball.orbital_speed_rad_s) * (ball.orbit_radius_m + n_r * radius);
        let rolling_speed = contact.rolling_speed_m_s.copysign(surfaces);
        let [slip_along, slip_across] = contact.friction_or_nan().slide_to_roll;
        let (about_lateral, about_rolling) = (against * n_r - radial * n_a, along);
        RelativeMotion {
            rolling: slip_along * rolling_speed - about_lateral * radius,
            lateral: slip_across * rolling_speed.abs() + about_rolling * radius,
            spin: contact.spin_ratio_per_m * rolling_speed,
            about_lateral,
            about_rolling,
        }
    }
}

/// ∬ √(1−X²−Y²) |Δv| dX dY over each strip of the unit disc.
fn strips(slip: &SlipField) -> Vec<f64> {
    let width = 2.0 / STRIPS as f64;
    let strip = |k: usize| {
        let y = -1.0 + (k as f64 + 0.5) * width;
        let chord = 1.0 - y * y;
        let along = |j: usize| {
            let angle = PI * (j as f64 + 1.0) / (ALONG as f64 + 1.0);
            let [u, v] = slip.at(chord.sqrt() * angle.cos(), y);
            angle.sin().powi(2) * u.hypot(v)
        };
        width * chord * PI / (ALONG as f64 + 1.0) * (0..ALONG).map(along).sum::<f64>()
    };
    (0..STRIPS).map(strip).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bearing::spec;
    use crate::{AzimuthFrame, BallSize, BallState, Races, RingState};
    use tribodyn_traction::{PatchRule, Quadrature};

    /// Strips rebuilt from the printed result add up to the wear integral of the patch, and the spinning inner contact
    /// wears least where it does not slide.
    #[test]
    fn identity_strips_add_up_to_the_wear_integral() {
        let bearing = Bearing::new(spec()).unwrap();
        let g = &bearing.geometry;
        let offset = g.groove_offset(Side::Outer) + 2e-5;
        let (sin, cos) = (g.sin_contact_angle(), g.cos_contact_angle());
        let quadrature = Quadrature::new(PatchRule::SplitStrip { across: 24, along: 12 }).unwrap();
        for (angular_velocity, orbit) in [([-3300.0, 1000.0, 0.0], 620.0), ([-2000.0, -300.0, 150.0], 300.0)] {
            let ball = BallState {
                frame: AzimuthFrame { sin: 0.6, cos: 0.8 },
                position: [offset * sin, offset * cos],
                velocity: [0.0; 2],
                orbital_speed: orbit,
                angular_velocity,
                size: BallSize::NOMINAL,
            };
            let inner = RingState { displacement: [0.0, 0.0, 5e-5 / sin], ..RingState::centred(1400.0) };
            let outer = RingState::centred(0.0);
            let loads = bearing.ball_loads(&ball, Races { inner: &inner, outer: &outer }, &quadrature);
            let result = bearing.sheet().ball(0.0, &ball, &loads, 1400.0);
            for (side, speed) in [(Side::Inner, 1400.0), (Side::Outer, 0.0)] {
                let wear = bearing.contact_wear(side, &result, speed);
                let e = &loads.contacts[side].ellipse;
                let sum: f64 = wear.across.iter().sum::<f64>() * e.peak_pressure * e.semi_lateral() * e.semi_rolling();
                let expected = loads.contacts[side].traction.wear_integral;
                assert!((sum / expected - 1.0).abs() < 1e-3, "{side:?} {angular_velocity:?}: {sum} {expected}");
                assert_eq!(wear.volume_rate, result.contacts[side].friction.unwrap().wear_rate_m3_s);
            }
        }
    }
}
