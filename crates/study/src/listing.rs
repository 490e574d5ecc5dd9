//! The built-in list of bearings, as answers have it.

use crate::error::StudyError;
use serde::Serialize;
use tribodyn::AnswerError;
use tribodyn_catalogue::{KnownBalls, ListedBearing, Origin, search};

/// A bearing of the list.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Listed {
    /// Designation without prefixes and suffixes.
    pub designation: String,
    /// Bore, mm.
    pub bore_mm: f64,
    /// Outside diameter, mm.
    pub outside_diameter_mm: f64,
    /// Width, mm.
    pub width_mm: f64,
    /// Nominal contact angle, degrees.
    pub contact_angle_deg: f64,
    /// C_r by the catalogue, N.
    pub dynamic_rating_n: Option<f64>,
    /// C_0r by the catalogue, N.
    pub static_rating_n: Option<f64>,
    /// Number of balls.
    pub ball_count: usize,
    /// Their diameter, mm.
    pub ball_diameter_mm: f64,
    /// Pitch diameter, mm.
    pub pitch_diameter_mm: f64,
    /// True for balls that are published; the others follow from the ratings.
    pub balls_published: bool,
    /// The larger deviation of the ratings of these balls from the catalogue's.
    pub rating_deviation: Option<f64>,
    /// The same of the set that comes second: where it is near, the balls are not certain.
    pub next_rating_deviation: Option<f64>,
    /// Where the dimensions come from.
    pub source: &'static str,
}

/// The bearings whose designation has a part, or fits a pattern with `*` for any letters; all for an empty text.
///
/// # Errors
/// None of the list.
pub fn listed(pattern: &str) -> Result<Vec<Listed>, StudyError> {
    let found = search(pattern);
    if found.is_empty() {
        let message = "no bearing of the list; `tribodyn catalogue` without a pattern prints all, and what a \
                       designation with prefix and suffixes stands for `tribodyn new` tells";
        return Err(StudyError::argument("catalogue", pattern, message));
    }
    found.into_iter().map(entry).collect()
}

fn entry(bearing: ListedBearing) -> Result<Listed, StudyError> {
    let known = KnownBalls { published: bearing.balls, ..KnownBalls::default() };
    let set = bearing.envelope.ball_set(known, bearing.ratings).map_err(AnswerError::from)?;
    let (deviation, next) = match set.origin {
        Origin::Ratings { dynamic, at_rest, next } => {
            (Some(dynamic.abs().max(at_rest.abs())), next.map(|next| next.deviation))
        }
        _ => (None, None),
    };
    let mm = |metres: f64| (metres * 1e7).round() / 1e4;
    Ok(Listed {
        bore_mm: mm(bearing.envelope.bore),
        outside_diameter_mm: mm(bearing.envelope.outside),
        width_mm: mm(bearing.envelope.width),
        contact_angle_deg: bearing.envelope.contact_angle.to_degrees().round(),
        dynamic_rating_n: bearing.ratings.map(|ratings| ratings.dynamic),
        static_rating_n: bearing.ratings.map(|ratings| ratings.at_rest),
        ball_count: set.ball_count,
        ball_diameter_mm: mm(set.ball_diameter),
        pitch_diameter_mm: mm(set.pitch_diameter),
        balls_published: matches!(set.origin, Origin::Published { .. }),
        rating_deviation: deviation,
        next_rating_deviation: next,
        source: bearing.source,
        designation: bearing.designation,
    })
}
