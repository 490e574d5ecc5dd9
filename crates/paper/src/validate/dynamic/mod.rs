//! Rows of the transient model. All come from one set of runs with one set of parameters; what a word of the paper
//! means in numbers is said here once and holds for every row.

mod against_itself;
mod coating;
mod defect;
mod preload;
mod settled;

pub use preload::first_impacts_of;

use super::row::{Claim, Evidence, Row, Stated, Verdict};
use crate::error::PaperError;
use crate::transient::{Set, Transient};

/// "Mostly": more than half.
const MOSTLY: f64 = 0.5;
/// "Clearly", "well above": by half at least.
const CLEARLY: f64 = 1.5;
/// "Identical": 1 % of the largest value, a line's width in a plot.
const IDENTICAL: f64 = 0.01;
/// "About" with an acceleration: impacts on pocket walls are a threshold, and peaks scatter by about this part between
/// schemes, steps and lengths of a run.
const ACCELERATION: f64 = 0.25;
/// "About" with an azimuth in steps of 20° to 30°: half a step, degrees.
const AZIMUTH: f64 = 10.0;
/// The tolerance of speeds (DESIGN.md), also for frequencies of the orbit.
const SPEED: f64 = 1e-3;

/// All rows of the dynamic model.
pub fn rows(set: &Set) -> Result<Vec<Row>, PaperError> {
    let mut rows = settled::rows(set)?;
    rows.extend(coating::rows(set));
    rows.extend(preload::rows(set));
    rows.extend(against_itself::rows(set)?);
    if let Some(defect) = &set.defect {
        rows.extend(defect::rows(defect, &set.ag)?);
    }
    Ok(rows)
}

/// The rows of a run with a defect beside one without.
pub fn defect_rows(with: &Transient, without: &Transient) -> Result<Vec<Row>, PaperError> {
    defect::rows(with, without)
}

/// Reason without transient runs: another case than those of the readings.
pub fn not_yet() -> Vec<Row> {
    let text = "claims of sections 4.3 and 5.2, decided for the cases of the readings only";
    vec![Row {
        verdict: Verdict::NotYet,
        computed: None,
        ..claim("dynamic", text, "dynamic model").row(0.0, false, "")
    }]
}

fn claim(id: &'static str, text: &'static str, measured: &'static str) -> Claim {
    Claim { id, evidence: Evidence::Validation, text, measured, unit: "" }
}

impl Claim {
    fn in_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    fn row(self, computed: f64, met: bool, note: impl Into<String>) -> Row {
        Row::claim(&self, computed, met, note.into())
    }
}

/// A published number; calibration where the pocket's parameters were chosen with it in view.
fn number(
    id: &str,
    quantity: &str,
    unit: &'static str,
    values: [f64; 3],
    decimals: usize,
    evidence: Evidence,
    note: impl Into<String>,
) -> Row {
    let row = Row::number(id.to_owned(), quantity.to_owned(), values);
    Row { unit, decimals, evidence, note: note.into(), ..row }
}

/// Paper against itself: no result of ours can decide it.
fn contradiction(
    id: &'static str,
    text: &'static str,
    measured: &'static str,
    unit: &'static str,
    computed: f64,
    note: String,
) -> Row {
    Row {
        verdict: Verdict::Contradictory,
        published: Stated::Text(text),
        ..claim(id, text, measured).in_unit(unit).row(computed, false, note)
    }
}

/// `25 % 1.23, 50 % …`, for the notes.
fn by_load(set: &Set, value: impl Fn(&Transient) -> f64, decimals: usize) -> String {
    let one = |(percent, run): (u32, &Transient)| format!("{percent} % {:.decimals$}", value(run));
    set.by_load().map(one).join(", ")
}
