//! Readings of the paper's equations that no case file can express, as changes of the bearing.

use std::sync::Arc;
use tribodyn_bearing::{Bearing, OperatingPoint, Side};
use tribodyn_identify::Adapt;

/// How many times faster than the shaft the fluid of [`drag_of_the_cage`] turns. The drag on balls then differs by a
/// four-hundredth of what it does in a fluid at rest.
const FAST: f64 = 400.0;

/// The change that a hypothesis of this name asks for.
pub fn named(hypothesis: &str) -> Option<Adapt> {
    if hypothesis.ends_with("Eq. 5 with absolute speeds") {
        return Some(Adapt(Arc::new(absolute_speeds)));
    }
    hypothesis.ends_with("drag at the cage's speed and d_m/2").then(|| Adapt(Arc::new(drag_of_the_cage)))
}

/// Orbital speed of balls that roll at the free contact angle, rad/s.
fn rolling_orbit(bearing: &Bearing, point: &OperatingPoint) -> f64 {
    let g = &bearing.geometry;
    let ratio = g.ball_diameter * g.cos_contact_angle() / g.pitch_diameter;
    0.5 * (point.inner_speed * (1.0 - ratio) + point.outer_speed * (1.0 + ratio))
}

/// Differential slip of Eq. 5 with the speeds of ball and rings in the frame at rest instead of that which moves with
/// the ball: ω_b + ω_i in place of ω_b + ω_i − ω_m, ω_b − ω_o in place of ω_b − (ω_o − ω_m). The slip goes with the
/// curvature of the contact, so that takes the ratio.
fn absolute_speeds(bearing: &mut Bearing, point: &OperatingPoint) {
    let g = &bearing.geometry;
    let orbit = rolling_orbit(bearing, point);
    let ball = (point.inner_speed - orbit) * (g.pitch_diameter / g.ball_diameter - g.cos_contact_angle());
    let inner = (ball + point.inner_speed) / (ball + point.inner_speed - orbit);
    let outer = (ball - point.outer_speed) / (ball - point.outer_speed + orbit);
    bearing.races[Side::Inner].surface_radius /= inner;
    bearing.races[Side::Outer].surface_radius /= outer;
}

/// The same drag on every ball, that of the cage's speed at d_m/2, by a fluid that turns fast against the cage and is
/// thin in proportion. The speed is that of rolling balls.
fn drag_of_the_cage(bearing: &mut Bearing, point: &OperatingPoint) {
    let orbit = rolling_orbit(bearing, point);
    let Some(fluid) = &mut bearing.fluid else { return };
    let at_rest = orbit - fluid.swirl * point.inner_speed;
    fluid.swirl = -FAST;
    fluid.drag.drag_coefficient *= (at_rest / (orbit + FAST * point.inner_speed)).powi(2);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files;
    use crate::transient::AUTHORS;
    use tribodyn_bearing::{AzimuthFrame, BallSize, BallState};
    use tribodyn_case::Case;

    fn authors() -> (Bearing, OperatingPoint) {
        let case = Case::from_ron(&files::read(&files::root().join(AUTHORS.ag)).unwrap()).unwrap();
        (case.bearing().unwrap(), case.operating_point())
    }

    #[test]
    fn limit_the_drag_of_the_cage_is_one_on_all_balls() {
        let (mut bearing, point) = authors();
        let orbit = rolling_orbit(&bearing, &point);
        let radius = 0.5 * bearing.geometry.pitch_diameter;
        let drag = |bearing: &Bearing, speed: f64| {
            let frame = AzimuthFrame::at(0.0);
            let ball = BallState {
                frame,
                position: [0.0; 2],
                velocity: [0.0; 2],
                orbital_speed: speed,
                angular_velocity: [0.0; 3],
                size: BallSize::NOMINAL,
            };
            bearing.fluid.as_ref().unwrap().drag_on(&ball, radius, point.inner_speed)
        };
        let own = drag(&bearing, orbit);
        let faster = drag(&bearing, 1.01 * orbit) / own;
        drag_of_the_cage(&mut bearing, &point);
        assert!((drag(&bearing, orbit) / own - 1.0).abs() < 1e-12);
        assert!(faster > 1.02 && (drag(&bearing, 1.01 * orbit) / own - 1.0).abs() < 3e-5);
    }

    /// With the frame at rest the balls of a bearing whose rings turn against each other, so that none orbits, have the
    /// differential slip that they have.
    #[test]
    fn limit_without_an_orbit_both_frames_are_one() {
        let (mut bearing, point) = authors();
        let g = &bearing.geometry;
        let ratio = g.ball_diameter * g.cos_contact_angle() / g.pitch_diameter;
        let outer_speed = -point.inner_speed * (1.0 - ratio) / (1.0 + ratio);
        let before = bearing.races.clone();
        absolute_speeds(&mut bearing, &OperatingPoint { outer_speed, ..point.clone() });
        for side in Side::BOTH {
            assert!((bearing.races[side].surface_radius / before[side].surface_radius - 1.0).abs() < 1e-12);
        }
        // With one ring at rest the inner contact slips more by it, the outer one less.
        absolute_speeds(&mut bearing, &point);
        assert!(bearing.races[Side::Inner].surface_radius < 0.9 * before[Side::Inner].surface_radius);
        assert!(bearing.races[Side::Outer].surface_radius > 1.1 * before[Side::Outer].surface_radius);
    }
}
