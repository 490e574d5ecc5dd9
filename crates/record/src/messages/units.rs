//! From SI to the units of recorded fields.

use std::f64::consts::TAU;

pub(crate) const MICRO_PER_UNIT: f64 = 1e6;
pub(crate) const MILLI_PER_UNIT: f64 = 1e3;
pub(crate) const CUBIC_MICROMETRE: f64 = 1e18;
pub(crate) const BILLION: f64 = 1e9;

/// An angle from 0 to 360 degrees.
pub(crate) fn degrees(angle: f64) -> f64 {
    angle.rem_euclid(TAU).to_degrees()
}
