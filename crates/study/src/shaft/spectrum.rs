//! Lives of the bearings of a shaft: under one load, or under load cases that alternate.
//!
//! ```text
//! bearing   1/L = Σ q_k/L_k          q_k share of time in load case k (Palmgren, Miner)
//! system    L_s = (Σ L_j^(−e))^(−1/e),   e = 10/9 for ball bearings: the reliability of all is the product of theirs
//! equivalent load   P = (Σ q_k n_k P_k³/Σ q_k n_k)^(1/3)
//! ```

use super::answer::ShaftAnswer;
use super::file::ShaftFile;
use crate::error::StudyError;
use serde::Serialize;
use tribodyn_case::DutySpec;

/// Exponent of Weibull's distribution of ball bearings' lives (ISO 281).
const WEIBULL: f64 = 10.0 / 9.0;

/// One load case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DutyAnswer {
    /// Share of time.
    pub share: f64,
    /// Factor on the loads.
    pub load: f64,
    /// The shaft under it.
    pub shaft: ShaftAnswer,
}

/// Lives over all load cases.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LifeAnswer {
    /// Load cases; one where the file has no spectrum.
    pub duties: Vec<DutyAnswer>,
    /// Mean speed, r/min.
    pub mean_speed_rpm: f64,
    /// Equivalent load of each bearing, N; absent where it is not rated in a load case.
    pub equivalent_load_n: Vec<Option<f64>>,
    /// Rating life of each bearing, h; absent for one that is not rated, does not turn or carries nothing.
    pub life_h: Vec<Option<f64>>,
    /// Life that all bearings reach together with the reliability of each, h; absent where one of them is not rated.
    pub system_life_h: Option<f64>,
}

/// Equilibria and lives over the spectrum of a shaft's file.
///
/// # Errors
/// As [`ShaftAnswer::at`], for any load case.
pub fn shaft_life(file: &ShaftFile) -> Result<LifeAnswer, StudyError> {
    let always = [DutySpec { share: 1.0, load: 1.0, speed: None }];
    let spectrum = if file.system.spectrum.is_empty() { &always[..] } else { &file.system.spectrum };
    let mut duties = Vec::with_capacity(spectrum.len());
    for duty in spectrum {
        let shaft = ShaftAnswer::at(file, duty.speed.unwrap_or(file.system.speed), duty.load)?;
        duties.push(DutyAnswer { share: duty.share, load: duty.load, shaft });
    }
    let mean_speed_rpm: f64 = duties.iter().map(|duty| duty.share * duty.shaft.speed_rpm.abs()).sum();
    let count = file.system.bearings.len();
    let life_h: Vec<_> = (0..count).map(|index| life(&duties, index)).collect();
    let equivalent_load_n = (0..count).map(|index| equivalent(&duties, index, mean_speed_rpm)).collect();
    let rated = duties.iter().all(|duty| duty.shaft.bearings.iter().all(|bearing| bearing.rating.is_some()));
    // A bearing without load lives for ever: it takes nothing from the system.
    let sum: f64 = life_h.iter().flatten().map(|h| h.powf(-WEIBULL)).sum();
    let system_life_h = (rated && sum > 0.0).then(|| sum.powf(-1.0 / WEIBULL));
    Ok(LifeAnswer { duties, mean_speed_rpm, equivalent_load_n, life_h, system_life_h })
}

fn life(duties: &[DutyAnswer], index: usize) -> Option<f64> {
    let mut used = 0.0;
    for duty in duties {
        let rating = duty.shaft.bearings[index].rating.as_ref()?;
        used += rating.rating_life_hours.map_or(0.0, |hours| duty.share / hours);
    }
    (used > 0.0).then(|| 1.0 / used)
}

fn equivalent(duties: &[DutyAnswer], index: usize, mean_speed: f64) -> Option<f64> {
    let mut sum = 0.0;
    for duty in duties {
        let rating = duty.shaft.bearings[index].rating.as_ref()?;
        sum += duty.share * duty.shaft.speed_rpm.abs() * rating.reference_load_n.unwrap_or(0.0).powi(3);
    }
    (mean_speed > 0.0).then(|| (sum / mean_speed).cbrt())
}
