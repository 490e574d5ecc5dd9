//! What a solution must be before a byte of it is written.

use crate::RecordError;
use tribodyn_bearing::Geometry;
use tribodyn_quasistatic::Solution;
use tribodyn_quasistatic::ball_numbers as numbers;

/// Refuses what cannot be recorded: numbers that are not finite, another bearing's solution, uneven azimuths.
pub(crate) fn check(solution: &Solution, geometry: &Geometry) -> Result<(), RecordError> {
    if solution.balls.is_empty() || solution.balls.len() != geometry.ball_count {
        return Err(RecordError::BallCount { solution: solution.balls.len(), case: geometry.ball_count });
    }
    let (diameter, pitch) = (geometry.ball_diameter, geometry.pitch_diameter);
    if !(diameter.is_finite() && diameter > 0.0) {
        return Err(RecordError::Geometry { field: "ball_diameter", value: diameter });
    }
    if !(pitch.is_finite() && pitch > diameter) {
        return Err(RecordError::Geometry { field: "pitch_diameter", value: pitch });
    }
    let finite = |field: String, value: f64| {
        if value.is_finite() { Ok(()) } else { Err(RecordError::NotFinite { field, value }) }
    };
    for (field, value) in ring_numbers(solution) {
        finite(field.to_owned(), value)?;
    }
    let spacing = 360.0 / geometry.ball_count as f64;
    for (index, ball) in solution.balls.iter().enumerate() {
        for (field, value) in numbers(ball) {
            finite(format!("balls[{index}].{field}"), value)?;
        }
        let expected = solution.balls[0].azimuth_deg + spacing * index as f64;
        let off = (ball.azimuth_deg - expected + 180.0).rem_euclid(360.0) - 180.0;
        // Azimuths that went through a table of a few digits still pass.
        if off.abs() > 1e-4 {
            return Err(RecordError::UnevenAzimuth {
                ball: index,
                expected_deg: expected,
                found_deg: ball.azimuth_deg,
            });
        }
    }
    Ok(())
}

fn ring_numbers(solution: &Solution) -> Vec<(&'static str, f64)> {
    let mut out = vec![
        ("shaft_torque_nm", solution.shaft_torque_nm),
        ("inner_speed_rad_s", solution.inner_speed_rad_s),
        ("outer_speed_rad_s", solution.outer_speed_rad_s),
    ];
    out.extend(solution.ring_displacement_m.map(|v| ("ring_displacement_m", v)));
    out.extend(solution.ring_tilt_rad.map(|v| ("ring_tilt_rad", v)));
    out.extend(solution.ring_load_n.map(|v| ("ring_load_n", v)));
    out.extend(solution.ring_moment_nm.map(|v| ("ring_moment_nm", v)));
    out
}
