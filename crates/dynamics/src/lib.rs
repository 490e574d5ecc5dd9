//! Transient dynamics of a ball bearing.

mod detail;
mod dp54;
mod error;
mod fast;
mod forces;
mod layout;
mod linear;
mod machine;
mod observer;
mod pocket;
mod rk4;
mod run;
mod sample;
mod start;
mod stiffness;

pub use error::DynamicsError;
pub use observer::{Event, EventKind, Observer};
pub use run::{Checkpoint, Ending, Run, RunError, Statistics};
pub use sample::{BallSample, CageSample, ContactSample, PowerSample, RingSample, Sample, WearSample};
pub use stiffness::Stiffness;
