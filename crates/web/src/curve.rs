//! Numbers over a load or over speed, by raceway control.

use crate::question::{Over, Range, operation};
use serde::Serialize;
use std::f64::consts::PI;
use tribodyn::sheet::{SheetQuestion, sheet};
use tribodyn::{AnswerError, CaseFile};

/// One value, and the bearing there.
#[derive(Serialize, Default)]
pub(crate) struct CurvePoint {
    /// N or r/min.
    at: f64,
    peak_pressure_pa: Option<f64>,
    ball_load_max_n: Option<f64>,
    stiffness_radial_n_per_m: Option<f64>,
    stiffness_axial_n_per_m: Option<f64>,
    contact_angle_max_rad: Option<f64>,
    rating_life_l10r_mrev: Option<f64>,
    rating_life_hours: Option<f64>,
    /// Why there are no numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

/// Most values of a curve.
const MOST: usize = 200;

/// The values at equal distances.
pub(crate) fn curve(file: &CaseFile, range: &Range) -> Result<Vec<CurvePoint>, AnswerError> {
    let Range { over, from, to, count } = *range;
    if !(2..=MOST).contains(&count) {
        return Err(AnswerError::argument("count", count, format!("allowed are 2 to {MOST} values")));
    }
    if let Some(value) = [from, to].into_iter().find(|value| !value.is_finite()) {
        return Err(AnswerError::argument("range", value, "allowed are finite numbers"));
    }
    let given = operation(file);
    let values = (0..count).map(|k| from + (to - from) * k as f64 / (count - 1) as f64);
    Ok(values.map(|at| point(file, at, changed(given, over, at))).collect())
}

fn changed(given: SheetQuestion, over: Over, at: f64) -> SheetQuestion {
    match over {
        Over::Radial => SheetQuestion { radial: at, ..given },
        Over::Axial => SheetQuestion { axial: at, ..given },
        Over::Speed => SheetQuestion { speed: at * PI / 30.0, ..given },
    }
}

fn point(file: &CaseFile, at: f64, question: SheetQuestion) -> CurvePoint {
    match sheet(&file.name, &file.case, &question) {
        Ok(found) => CurvePoint {
            at,
            peak_pressure_pa: found.rating.peak_pressure_max_pa,
            ball_load_max_n: Some(found.ball_load_max_n),
            stiffness_radial_n_per_m: Some(found.stiffness[0][0]),
            stiffness_axial_n_per_m: Some(found.stiffness[2][2]),
            contact_angle_max_rad: found.contact_angle_rad.map(|[_, most]| most),
            rating_life_l10r_mrev: found.rating.rating_life_l10r_mrev,
            rating_life_hours: found.rating.rating_life_hours,
            error: None,
        },
        Err(error) => CurvePoint { at, error: Some(error.to_string()), ..CurvePoint::default() },
    }
}
