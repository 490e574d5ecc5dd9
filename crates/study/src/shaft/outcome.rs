//! All that is asked of a shaft's file at once.

use super::{LifeAnswer, ShaftFile, WhirlAnswer, shaft_life, whirl};
use crate::error::StudyError;
use serde::Serialize;

/// A shaft under its loads, with its modes where they were asked for.
#[derive(Debug, Serialize)]
pub struct ShaftOutcome {
    /// Name of the shaft.
    pub name: String,
    /// Reactions, deflections, stresses, lives.
    #[serde(flatten)]
    pub life: LifeAnswer,
    /// Modes, critical speeds, unbalance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub whirl: Option<WhirlAnswer>,
}

/// A shaft under its loads; with speeds in r/min also its modes there, up to a frequency in Hz.
///
/// # Errors
/// As [`shaft_life`] and [`whirl`].
pub fn shaft_outcome(file: &ShaftFile, modes_rpm: &[f64], up_to_hz: f64) -> Result<ShaftOutcome, StudyError> {
    let life = shaft_life(file)?;
    let whirl = if modes_rpm.is_empty() { None } else { Some(whirl(file, modes_rpm, up_to_hz)?) };
    Ok(ShaftOutcome { name: file.system.name.clone(), life, whirl })
}
