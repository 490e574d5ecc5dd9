//! Impossible spalls of balls.

use super::validate::{Verdict, millimetres, require};
use super::*;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) fn validate(case: &Case) -> Verdict {
    let mut spalls = case.ball_spalls.iter().enumerate();
    spalls.try_for_each(|(i, spec)| spall(&format!("ball_spalls[{i}]"), spec, case))
}

fn spall(path: &str, spec: &BallSpallSpec, case: &Case) -> Verdict {
    let (count, diameter) = (case.geometry.ball_count, case.geometry.ball_diameter);
    let message = format!("must be the number of a ball, 0 to {}", count - 1);
    require(spec.ball < count, &format!("{path}.ball"), message)?;
    let within = |name: &str, value: f64, [least, most]: [f64; 2], limits: String| {
        require((least..=most).contains(&value), &format!("{path}.{name}"), format!("must be {limits}"))
    };
    within("angle", spec.angle, [-2.0 * PI, 2.0 * PI], "between -360° and 360°".to_owned())?;
    within("latitude", spec.latitude, [-FRAC_PI_2, FRAC_PI_2], "between -90° and 90°".to_owned())?;
    let up_to =
        |share: f64, what: &str| format!("at most {what} of the ball diameter, {} mm", millimetres(share * diameter));
    let above = |share: f64, what: &str| format!("above 0 and {}", up_to(share, what));
    let least = f64::MIN_POSITIVE;
    within("length", spec.length, [least, 0.4 * diameter], above(0.4, "four tenths"))?;
    within(
        "width",
        spec.width,
        [least, diameter],
        format!("above 0 and at most the ball diameter, {} mm", millimetres(diameter)),
    )?;
    within("depth", spec.depth, [0.0, 0.1 * diameter], format!("at least 0 and {}", up_to(0.1, "a tenth")))?;
    within(
        "edge_radius",
        spec.edge_radius,
        [0.0, 0.02 * diameter],
        format!("at least 0 and {}", up_to(0.02, "a fiftieth")),
    )
}
