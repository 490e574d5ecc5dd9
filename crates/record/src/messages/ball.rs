//! A ball as it is recorded: its message is filled from the table of quantities, and read back by it.

use crate::units::degrees;
use crate::wire::Numbers;
use crate::wire::tribodyn::ball::{Motion, Pocket};
use crate::wire::tribodyn::{AroundBearing, Ball};
use prost_types::Timestamp;
use std::sync::LazyLock;
use tribodyn_bearing::quantities::{GIGAPASCAL, OfBall, PERCENT, RPM_PER_RAD_S, Scope};
use tribodyn_bearing::{BallResult, ContactResult, Side};

/// The quantity of a ball that belongs into each number of a message, in the order of their places.
static FIELDS: LazyLock<Vec<Option<OfBall>>> = LazyLock::new(|| {
    let called = |name: &str| OfBall::all().find(|q| q.name_in(q.facts().shown) == *name);
    Ball::NAMES.iter().map(|name| called(name)).collect()
});

/// One ball; f32 halves the file and keeps seven digits.
pub(crate) fn message(index: usize, ball: &BallResult) -> Ball {
    let mut message = Ball {
        index: index as u32,
        contact_inner: ball.contacts.inner.load_n > 0.0,
        contact_outer: ball.contacts.outer.load_n > 0.0,
        motion: motion(ball).into(),
        pocket: pocket(ball).into(),
        ..Ball::default()
    };
    let fields = &FIELDS[..];
    message.set_numbers(|place| {
        let quantity = fields.get(place)?.as_ref()?;
        Some(quantity.get(ball)? * quantity.facts().shown.per_si)
    });
    message.azimuth_deg = degrees(ball.azimuth_rad) as f32;
    message
}

/// A ball read back, with the quantities of a model of this scope.
pub fn read_ball(row: &Ball, scope: Scope) -> BallResult {
    let held = |of: Scope| match scope {
        Scope::All => of == Scope::All,
        Scope::Traction | Scope::Lubricated => of != Scope::Run,
        Scope::Run => true,
    };
    let mut ball = BallResult::default();
    for (place, quantity) in FIELDS.iter().enumerate() {
        if let Some((quantity, facts)) = quantity.map(|q| (q, q.facts()))
            && held(facts.scope)
            && !facts.is_absence(row.number(place))
        {
            quantity.set(&mut ball, row.number(place) / facts.shown.per_si);
        }
    }
    ball
}

/// Slide-to-roll ratio above which a loaded ball skids: micro-slip of a rolling ball stays well below.
const SKIDDING: f64 = 0.05;

fn motion(b: &BallResult) -> Motion {
    // A model without traction slides nowhere.
    let slide = |c: &ContactResult| c.friction.map_or(0.0, |f| f.slide_to_roll[0].abs());
    let (i, o) = (&b.contacts.inner, &b.contacts.outer);
    let slide = slide(i).max(slide(o));
    match (i.load_n > 0.0, o.load_n > 0.0) {
        (true, true) if slide > SKIDDING => Motion::Skidding,
        (true, true) => Motion::Rolling,
        (false, true) => Motion::InnerLost,
        (true, false) => Motion::OuterLost,
        (false, false) => Motion::Free,
    }
}

/// The force of the pocket on the ball drives the ball where it points along the orbit.
fn pocket(b: &BallResult) -> Pocket {
    let along = b.pocket.unwrap_or_default().force_n * b.orbital_speed_rad_s;
    match along {
        _ if along > 0.0 => Pocket::CagePushes,
        _ if along < 0.0 => Pocket::BallPushes,
        _ => Pocket::Clear,
    }
}

/// Balls sorted by azimuth; slide-to-roll ratios are left out where the model has none.
pub(crate) fn around(stamp: Timestamp, time_s: f64, balls: &[BallResult]) -> AroundBearing {
    let mut order: Vec<(f64, usize)> = balls.iter().enumerate().map(|(i, b)| (degrees(b.azimuth_rad), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    let of = |get: fn(&BallResult) -> f64| order.iter().map(|&(_, ball)| get(&balls[ball]) as f32).collect();
    let slide = |side: Side| -> Vec<f32> {
        let percent = |ball: usize| Some(balls[ball].contacts[side].friction?.slide_to_roll[0] * PERCENT.per_si);
        order.iter().map_while(|&(_, ball)| percent(ball).map(|value| value as f32)).collect()
    };
    AroundBearing {
        timestamp: Some(stamp),
        time_s,
        azimuth_deg: order.iter().map(|&(azimuth, _)| azimuth as f32).collect(),
        ball: order.iter().map(|&(_, ball)| ball as u32).collect(),
        load_inner_n: of(|b| b.contacts.inner.load_n),
        load_outer_n: of(|b| b.contacts.outer.load_n),
        peak_pressure_inner_gpa: of(|b| b.contacts.inner.peak_pressure_pa * GIGAPASCAL.per_si),
        peak_pressure_outer_gpa: of(|b| b.contacts.outer.peak_pressure_pa * GIGAPASCAL.per_si),
        contact_angle_inner_deg: of(|b| b.contacts.inner.angle_rad.to_degrees()),
        contact_angle_outer_deg: of(|b| b.contacts.outer.angle_rad.to_degrees()),
        slide_to_roll_inner_percent: slide(Side::Inner),
        slide_to_roll_outer_percent: slide(Side::Outer),
        orbital_speed_rpm: of(|b| b.orbital_speed_rad_s * RPM_PER_RAD_S),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quantity without a field would be lost without a word, a field without a quantity always 0.
    #[test]
    fn identity_every_quantity_of_a_ball_has_a_field_and_every_number_a_quantity() {
        let names: Vec<String> = OfBall::all().map(|q| q.name_in(q.facts().shown)).collect();
        for name in &names {
            assert!(Ball::place(name).is_some(), "the message has no field {name}");
        }
        for field in Ball::NAMES {
            assert!(names.iter().any(|name| name == field), "no quantity is called {field}");
        }
    }

    #[test]
    fn identity_a_ball_comes_back_in_single_precision() {
        let mut ball = BallResult::default();
        for (k, q) in OfBall::all().enumerate() {
            q.set(&mut ball, (0.1 + k as f64) / q.facts().shown.per_si);
        }
        let back = read_ball(&message(3, &ball), Scope::Run);
        for q in OfBall::all().filter(|q| q.facts().name != "azimuth") {
            let (exact, found) = (q.get(&ball).unwrap(), q.get(&back).unwrap());
            assert!((found - exact).abs() <= 1e-7 * exact.abs(), "{}: {found} instead of {exact}", q.name());
        }
        assert_eq!(read_ball(&message(3, &ball), Scope::All).contacts.inner.friction, None);
    }
}
