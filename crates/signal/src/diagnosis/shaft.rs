//! The speed of the shaft: as it is given, or more exactly by its lines in the signal.

use super::lines::{FlooredLines, Found};
use super::{Search, Shaft};
use crate::error::{SignalError, check_samples, check_setting};
use serde::Serialize;
use std::f64::consts::TAU;

/// Speed of the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShaftSpeed {
    /// Turns per second, Hz; the mean where the speed is given at each sample.
    pub frequency_hz: f64,
    /// One standard deviation of it, Hz; that of the given speed where the signal does not show it.
    pub deviation_hz: f64,
    /// True if it was found in the signal; otherwise it is the given one.
    pub measured: bool,
}

/// A warning where the signal does not show the speed.
pub(super) const NOT_FOUND: &str =
    "no line of the shaft stands out near the speed given: the sampling rate or the speed may be wrong";

/// The given speed, Hz.
pub(super) fn given_hz(shaft: Shaft, samples: usize) -> Result<f64, SignalError> {
    let hz = match shaft {
        Shaft::Near(hz) => hz,
        Shaft::At(speeds) if speeds.len() != samples => {
            return Err(SignalError::SpeedCount { speeds: speeds.len(), count: samples });
        }
        Shaft::At(speeds) => {
            check_samples(speeds, 1)?;
            speeds.iter().sum::<f64>().abs() / speeds.len() as f64 / TAU
        }
    };
    check_setting("shaft speed in Hz", hz, false)?;
    Ok(hz)
}

/// Lines of the shaft that are looked at, in its turns.
const ORDERS: f64 = 8.0;
/// Decadic logarithm of the chance from which lines count as those of the shaft.
const SURE: f64 = -6.0;

/// The speed by the lines of the shaft in the signal, or the given one.
pub(super) fn found(samples: &[f64], rate_hz: f64, shaft: Shaft, search: Search) -> Result<ShaftSpeed, SignalError> {
    let given = given_hz(shaft, samples.len())?;
    let near = match shaft {
        Shaft::At(_) => return Ok(ShaftSpeed { frequency_hz: given, deviation_hz: 0.0, measured: true }),
        Shaft::Near(hz) => hz,
    };
    let lines = FlooredLines::of(samples, rate_hz, super::evidence::segment_s(near), ORDERS * near, 0.4 * near)?;
    let range = [near * (1.0 - search.speed), near * (1.0 + search.speed)];
    let certain = |found: &Found| found.log_chance < SURE && (range[0]..=range[1]).contains(&found.frequency_hz);
    Ok(match lines.family(range, 1.0).filter(certain) {
        Some(found) => {
            ShaftSpeed { frequency_hz: found.frequency_hz, deviation_hz: found.deviation_hz, measured: true }
        }
        // Even within the range: its standard deviation is 1/√3 of half the width.
        None => ShaftSpeed { frequency_hz: near, deviation_hz: near * search.speed / 3f64.sqrt(), measured: false },
    })
}
