//! Runs of catalogue bearings as `tribodyn new` writes them.

use super::row::{Limit, Row};
use super::speed::Prepared;
use crate::error::Failure;
use tribodyn_catalogue::{Given, NewCase, find};

const GROUP: &str = "catalogue";
/// Its usual lubricant.
pub const USUAL: &str = "usual";
const BEARINGS: [&str; 6] = ["7210B", "6206", "6308", "608", "71908C", "6024"];
/// Simulated, s.
const DURATION: f64 = 0.1;
/// Promise: simulated over processor time.
const REAL_TIME: f64 = 4.0;

/// The case that `tribodyn new` writes of a bearing, with its contact angle in degrees where it is not in the name.
pub fn written((bearing, angle): (&str, Option<f64>), lubricant: &str) -> Result<String, Failure> {
    let refused = |error: &dyn std::fmt::Display| Failure::Seed(format!("{bearing}: {error}"));
    let listed = find(bearing, angle).map_err(|error| refused(&error))?;
    let given = Given { lubricant: Some(lubricant.to_owned()), ..Given::default() };
    let case = NewCase::of_listed(listed, bearing).given(given).map_err(|error| refused(&error))?;
    case.text().map_err(|error| refused(&error))
}

pub fn rows(quick: bool) -> Result<Vec<Row>, Failure> {
    let (duration, repetitions) = if quick { (0.5 * DURATION, 2) } else { (DURATION, 5) };
    let mut rows = Vec::new();
    for bearing in BEARINGS {
        let changes = [("transient.duration", "s(1)")];
        let mut prepared = Prepared::new(&written((bearing, None), USUAL)?, &changes, false)?;
        for _ in 0..repetitions {
            prepared.repeat(duration)?;
        }
        let name = format!("{bearing} in its usual lubricant, simulated over processor time");
        let note = prepared.step_us().map_or_else(String::new, |step| format!("steps of {step:.2} µs"));
        rows.push(Row::new(GROUP, name, duration / prepared.least(), "").must_be(Limit::AtLeast(REAL_TIME)).note(note));
    }
    Ok(rows)
}
