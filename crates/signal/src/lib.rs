#![doc = include_str!("../README.md")]

mod bearing;
mod decimator;
mod envelope;
mod error;
mod harmonics;
mod order;
mod period;
mod settling;
mod spectrum;
mod statistics;
mod transform;
mod welch;
mod window;

pub use bearing::BearingFrequencies;
pub use decimator::{Decimator, DecimatorMemory};
pub use envelope::{envelope, envelope_spectrum};
pub use error::SignalError;
pub use harmonics::{HarmonicFamily, HarmonicLine};
pub use order::{AngleSamples, OrderPeak, OrderSpectrum, order_spectrum, resample_by_angle};
pub use period::{Period, period};
pub use settling::{Settling, SettlingRule, settling};
pub use spectrum::{Peak, Spectrum};
pub use statistics::Statistics;
pub use welch::{PowerDensity, Segments, welch};
pub use window::Window;
