//! Transient dynamics of a ball bearing.

mod observer;
mod sample;

pub use observer::{Event, EventKind, Observer};
pub use sample::{BallSample, CageSample, ContactSample, PowerSample, RingSample, Sample, WearSample};
