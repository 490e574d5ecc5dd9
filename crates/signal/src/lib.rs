#![doc = include_str!("../README.md")]

mod bearing;
mod decimator;
mod diagnosis;
mod envelope;
mod error;
mod harmonics;
mod key_phase;
mod order;
mod period;
mod quality;
mod settling;
mod spectrogram;
mod spectrum;
mod statistics;
mod transform;
mod velocity;
mod welch;
mod whirl;
mod window;

pub use bearing::BearingFrequencies;
pub use decimator::{Decimator, DecimatorMemory};
pub use diagnosis::{
    Band, CageSpeed, Diagnosis, Evidence, Fault, Harmonic, Kinematics, Search, Shaft, ShaftSpeed, Sideband, Verdict,
    diagnose, kurtogram, whitened, without_trend,
};
pub use envelope::{envelope, envelope_spectrum};
pub use error::SignalError;
pub use harmonics::{HarmonicFamily, HarmonicLine};
pub use key_phase::speed_by_pulses;
pub use order::{AngleSamples, OrderPeak, OrderSpectrum, order_spectrum, resample_by_angle};
pub use period::{Period, period};
pub use quality::{VibrationClass, vibration_class};
pub use settling::{Settling, SettlingRule, settling};
pub use spectrogram::{Spectrogram, spectrogram};
pub use spectrum::{Peak, Spectrum};
pub use statistics::Statistics;
pub use velocity::{BandVelocity, TESTER_BANDS_HZ, band_velocities};
pub use welch::{PowerDensity, Segments, welch};
pub use whirl::{PathKind, Whirl, whirl};
pub use window::Window;
