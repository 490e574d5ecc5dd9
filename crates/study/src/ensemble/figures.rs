//! The numbers that a member comes to: those of the run's summary, by its names and in its units.

use super::numbers::numbers_of;
use crate::error::StudyError;
use crate::run::{RunReport, Summary};
use crate::sweep::{Cell, Column, Kind};
use serde::Serialize;
use tribodyn_dynamics::Statistics;
use tribodyn_record::StateRow;

/// Name of the number of warnings of a run.
const WARNINGS: &str = "warnings";

/// The part of a run's report that depends on its case alone, not on the machine.
#[derive(Serialize)]
struct Figures<'a> {
    patch_error_estimate: Option<f64>,
    acceleration_error_m_s2: Option<f64>,
    #[serde(flatten)]
    summary: &'a Summary,
    scheme_statistics: Statistics,
}

/// Columns of the figures, the same for every case.
pub(super) fn columns() -> Result<Vec<Column>, StudyError> {
    // Names and kinds are those of any summary.
    let Some(summary) = Summary::of(&[StateRow::default()], None, &[]) else { return Ok(Vec::new()) };
    let figures = Figures {
        patch_error_estimate: None,
        acceleration_error_m_s2: None,
        summary: &summary,
        scheme_statistics: Statistics::default(),
    };
    let column = |(name, cell): (String, Cell)| {
        let kind = if matches!(cell, Cell::Integer(_)) { Kind::Integer } else { Kind::Number };
        Column::new(&name, kind, true)
    };
    let warnings = Column::new(WARNINGS, Kind::Integer, true);
    Ok(numbers_of(&figures)?.into_iter().map(column).chain([warnings]).collect())
}

/// The figures of a run, in the order of the columns.
pub(super) fn figures(report: &RunReport) -> Result<Vec<Cell>, StudyError> {
    let Some(summary) = &report.summary else { return Ok(Vec::new()) };
    let figures = Figures {
        patch_error_estimate: report.known.patch_error_estimate,
        acceleration_error_m_s2: report.outcome.acceleration_error_m_s2,
        summary,
        scheme_statistics: report.outcome.scheme_statistics,
    };
    let warnings = report.warnings().count();
    let numbers = numbers_of(&figures)?.into_iter().map(|(_, cell)| cell);
    Ok(numbers.chain([Cell::Integer(warnings as i64)]).collect())
}
