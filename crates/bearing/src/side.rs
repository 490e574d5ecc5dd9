//! Balls on the side of their groove on which they do not bear under a positive axial load.

use crate::geometry::{Geometry, Shoulders};
use crate::operation::{OperatingPoint, RingFreedom};
use crate::races::Side;
use crate::result::BallResult;

/// Contact angle beyond which a ball is past the bottom of its groove, rad: half a degree, some hundredths of a contact
/// ellipse.
const BEYOND: f64 = 0.5 / 180.0 * std::f64::consts::PI;
/// Share of the largest contact load below which a contact counts as none.
const SOME_LOAD: f64 = 1e-6;

/// A loaded contact on the side of negative contact angles, where its groove has no shoulder or may have none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrongSide {
    /// The ball.
    pub ball: usize,
    /// The race.
    pub side: Side,
    /// Contact angle, rad.
    pub angle_rad: f64,
    /// Load, N.
    pub load_n: f64,
    /// True if the groove is known to have no shoulder there.
    pub known: bool,
}

/// The contacts of balls on a side of their groove that has no shoulder, or of which that is not known.
pub fn wrong_sides(geometry: &Geometry, balls: &[BallResult]) -> Vec<WrongSide> {
    let loads = balls.iter().flat_map(|ball| Side::BOTH.map(|side| ball.contacts[side].load_n));
    let least = SOME_LOAD * loads.fold(0.0, f64::max);
    let of = |side: Side, (ball, result): (usize, &BallResult)| {
        let contact = &result.contacts[side];
        let shoulders = geometry.shoulders.map(|shoulders| shoulders[side]);
        let wrong = shoulders != Some(Shoulders::Both) && contact.load_n > least && contact.angle_rad < -BEYOND;
        let known = shoulders.is_some();
        wrong.then_some(WrongSide { ball, side, angle_rad: contact.angle_rad, load_n: contact.load_n, known })
    };
    let on = |side| balls.iter().enumerate().filter_map(move |ball| of(side, ball));
    Side::BOTH.into_iter().flat_map(on).collect()
}

/// The axial load (N) of a loaded ring that a bearing with shoulders on one side does not carry: none or a negative
/// one. Absent where the bearing carries it, where the ring is held along Z and where there is no load at all.
pub fn uncarried_thrust(geometry: &Geometry, point: &OperatingPoint) -> Option<f64> {
    let loaded = |freedom: &RingFreedom| matches!(freedom, RingFreedom::Loaded(load) if *load != 0.0);
    match point.ring[2] {
        RingFreedom::Loaded(axial) if axial <= 0.0 && geometry.is_one_sided() && point.ring.iter().any(loaded) => {
            Some(axial)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Dimensions, Fit};
    use crate::operation::SolverSettings;
    use crate::races::Races;

    fn geometry(shoulders: Option<Races<Shoulders>>) -> Geometry {
        let fit = Fit::ContactAngle(0.7);
        let (ball_count, ball_diameter, pitch_diameter) = (2, 0.01, 0.05);
        let drawn = Geometry::new(Dimensions {
            ball_count,
            ball_diameter,
            pitch_diameter,
            inner_coefficient: 0.52,
            outer_coefficient: 0.53,
            fit,
        });
        drawn.unwrap().with_shoulders(shoulders)
    }

    fn ball(angle_rad: f64, load_n: f64) -> BallResult {
        let mut ball = BallResult::default();
        for side in Side::BOTH {
            (ball.contacts[side].angle_rad, ball.contacts[side].load_n) = (angle_rad, load_n);
        }
        ball
    }

    #[test]
    fn limit_a_ball_is_on_the_wrong_side_where_no_shoulder_is() {
        let one = Some(Races { inner: Shoulders::Both, outer: Shoulders::One });
        let both = Some(Races { inner: Shoulders::Both, outer: Shoulders::Both });
        // A ball that rests at the bottom of its groove or carries nothing is on neither side.
        let balls = [ball(-0.6, 100.0), ball(0.6, 90.0), ball(-0.004, 90.0), ball(-0.6, 1e-9)];
        let found = wrong_sides(&geometry(one), &balls);
        assert_eq!(found, [WrongSide { ball: 0, side: Side::Outer, angle_rad: -0.6, load_n: 100.0, known: true }]);
        assert_eq!(wrong_sides(&geometry(both), &balls), []);
        let open = wrong_sides(&geometry(None), &balls);
        assert_eq!(
            open.iter().map(|w| (w.ball, w.side, w.known)).collect::<Vec<_>>(),
            [(0, Side::Inner, false), (0, Side::Outer, false)]
        );
    }

    #[test]
    fn limit_thrust_is_carried_on_the_side_of_the_shoulders() {
        use RingFreedom::{Held, Loaded};
        let one = geometry(Some(Races { inner: Shoulders::Both, outer: Shoulders::One }));
        let both = geometry(Some(Races { inner: Shoulders::Both, outer: Shoulders::Both }));
        let uncarried = |geometry: &Geometry, radial: f64, axial: RingFreedom| {
            let ring = [Loaded(radial), Loaded(0.0), axial, Held(0.0), Held(0.0)];
            let numerics = SolverSettings::default();
            let watch = crate::SearchWatch::default();
            let [inner_speed, outer_speed] = [0.0; 2];
            let point = OperatingPoint { ring, inner_speed, outer_speed, patch: None, cage: None, numerics, watch };
            uncarried_thrust(geometry, &point)
        };
        assert_eq!(uncarried(&one, 100.0, Loaded(-50.0)), Some(-50.0));
        assert_eq!(uncarried(&one, 100.0, Loaded(0.0)), Some(0.0));
        for carried in [
            uncarried(&one, 100.0, Loaded(50.0)),
            uncarried(&one, 100.0, Held(-1e-5)),
            uncarried(&one, 0.0, Loaded(0.0)),
            uncarried(&both, 100.0, Loaded(-50.0)),
            uncarried(&geometry(None), 100.0, Loaded(-50.0)),
        ] {
            assert_eq!(carried, None);
        }
    }
}
