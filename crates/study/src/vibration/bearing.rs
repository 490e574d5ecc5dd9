//! The bearing that a signal is of.

use crate::error::StudyError;
use std::f64::consts::TAU;
use tribodyn::CaseFile;
use tribodyn_case::Fit;
use tribodyn_signal::Kinematics;

/// The bearing of a case with the speeds of its rings; the shaft's speed, Hz, beside it: that of the inner ring, or of
/// the outer ring where the inner one stands. No speed where the case has none.
///
/// The contact angle is the free one: load moves it by some degrees, which is part of the slip that is searched.
///
/// # Errors
/// A case that makes no bearing.
pub fn bearing_of_case(file: &CaseFile) -> Result<(Kinematics, Option<f64>), StudyError> {
    let bearing = file.bearing()?;
    let point = file.case.operating_point();
    let geometry = &bearing.geometry;
    let shaft = if point.inner_speed == 0.0 { point.outer_speed } else { point.inner_speed };
    // At rest nothing is said: a shaft that turns the inner ring is what measured speeds are of.
    let [inner_turns, outer_turns] =
        if shaft == 0.0 { [1.0, 0.0] } else { [point.inner_speed / shaft, point.outer_speed / shaft] };
    let kinematics = Kinematics {
        ball_count: geometry.ball_count,
        ball_diameter_m: geometry.ball_diameter,
        pitch_diameter_m: geometry.pitch_diameter,
        contact_angle_rad: geometry.contact_angle(),
        inner_turns,
        outer_turns,
    };
    Ok((kinematics, (shaft != 0.0).then_some(shaft.abs() / TAU)))
}

/// Bore of a case's bearing, m, where it is a deep groove one and the case says it.
pub(super) fn deep_groove_bore(file: &CaseFile) -> Option<f64> {
    let is_deep_groove = matches!(file.case.geometry.fit, Fit::RadialClearance(_));
    file.case.rating.filter(|_| is_deep_groove)?.bore
}

/// Numbers between commas.
pub(super) fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split(',').map(|part| part.trim().parse().ok()).collect()
}

/// A bearing from numbers: balls, ball diameter in mm, pitch diameter in mm and, where it is not 0, contact angle in
/// degrees, as in `9,7.94,39.04`. Its inner ring turns with the shaft.
pub fn bearing_of_numbers(text: &str) -> Option<Kinematics> {
    let (count, ball, pitch, angle) = match numbers(text)?[..] {
        [count, ball, pitch] => (count, ball, pitch, 0.0f64),
        [count, ball, pitch, angle] => (count, ball, pitch, angle),
        _ => return None,
    };
    (count >= 1.0 && count.fract() == 0.0 && count < 1e4).then_some(Kinematics {
        ball_count: count as usize,
        ball_diameter_m: 1e-3 * ball,
        pitch_diameter_m: 1e-3 * pitch,
        contact_angle_rad: angle.to_radians(),
        inner_turns: 1.0,
        outer_turns: 0.0,
    })
}
