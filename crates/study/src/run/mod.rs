//! Transient runs, recorded, and what a recorded run comes to.

mod checkpoint;
mod outcome;
mod resume;
mod session;
mod settled;
mod summary;
mod tape;
pub mod warnings;

pub use outcome::{RunOutcome, RunReport, Stopped};
pub use session::{Beginning, PreparedRun, RunSession};
pub use settled::Settled;
pub use summary::{Powers, Summary, Worn, carries_accelerations, imbalance};
pub use tape::Viewers;
