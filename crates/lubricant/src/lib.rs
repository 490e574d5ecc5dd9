#![doc = include_str!("../README.md")]

mod error;
mod film;
mod grease;
mod library;
mod oil;
mod pressure;
mod torque;
mod viscosity_index;
mod walther;

pub use error::LubricantError;
pub use film::{FilmThickness, InletFilm, RollingContact};
pub use grease::{GreaseLife, GreasedBearing};
pub use library::{BaseStock, GRADES, GREASE_STARVATION, oil_names, stock_names};
pub use oil::{Oil, Thermal};
pub use pressure::{PressureViscosity, ROELANDS_PRESSURE, roelands_index, roelands_index_of_mean, so_klaus};
pub use torque::{PalmgrenBearing, PalmgrenTorque, SkfBearing, SkfLoads, SkfSeries, SkfTorque, Supply};
pub use viscosity_index::{viscosity_at_100, viscosity_index};
pub use walther::Walther;

use num_dual::DualNum;

/// The scalar of the formulas: `f64` or a dual number over it.
pub trait Scalar: DualNum<Primitive = f64> + Copy {}
impl<T: DualNum<Primitive = f64> + Copy> Scalar for T {}

/// mm²/s in a m²/s: ν of oil standards.
pub const MM2_PER_M2: f64 = 1e6;
/// Absolute temperature of 0 °C, K.
pub const ZERO_CELSIUS: f64 = 273.15;
/// Absolute temperature of 40 °C, K, at which oils are graded.
pub const GRADING_TEMPERATURE: f64 = ZERO_CELSIUS + 40.0;

pub(crate) fn positive(quantity: &'static str, value: f64, unit: &'static str) -> Result<f64, LubricantError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(LubricantError::NotPositive { quantity, value, unit })
    }
}
