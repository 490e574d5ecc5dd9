//! Requirements on a solution before a byte of it is written.

use crate::RecordError;
use tribodyn_bearing::Geometry;
use tribodyn_bearing::quantities::{OfBall, joined};
use tribodyn_quasistatic::{SOLUTION, Solution};

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
    for quantity in &SOLUTION {
        if let Some(value) = (quantity.get)(solution) {
            finite(joined(&[quantity.facts.name, quantity.facts.unit.suffix]), value)?;
        }
    }
    let spacing = 360.0 / geometry.ball_count as f64;
    for (index, ball) in solution.balls.iter().enumerate() {
        for quantity in OfBall::all() {
            if let Some(value) = quantity.get(ball) {
                finite(format!("balls[{index}].{}", quantity.name_in(quantity.facts().unit)), value)?;
            }
        }
        let found_deg = ball.azimuth_rad.to_degrees();
        let expected = solution.balls[0].azimuth_rad.to_degrees() + spacing * index as f64;
        let off = (found_deg - expected + 180.0).rem_euclid(360.0) - 180.0;
        // Azimuths that went through a table of a few digits still pass.
        if off.abs() > 1e-4 {
            return Err(RecordError::UnevenAzimuth { ball: index, expected_deg: expected, found_deg });
        }
    }
    Ok(())
}
