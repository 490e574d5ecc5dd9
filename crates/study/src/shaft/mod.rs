//! A shaft in its bearings: what they carry, how far it bends, how long they live, and how it swings.

mod answer;
mod build;
mod file;
mod fits;
mod loads;
mod outcome;
mod preloads;
mod spectrum;
mod whirl;

pub use answer::{BearingAnswer, CutAnswer, ShaftAnswer, Station};
pub use build::{Running, System};
pub use file::{ShaftFile, listed_case, named_case};
pub use outcome::{ShaftOutcome, shaft_outcome};
pub use spectrum::{DutyAnswer, LifeAnswer, shaft_life};
pub use tribodyn_shaft::{Mode, Whirl};
pub use whirl::{Critical, SpeedAnswer, WhirlAnswer, whirl};

/// Revolutions per minute in one rad/s.
pub(crate) const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;
