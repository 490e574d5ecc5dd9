//! Transient runs, recorded, and what a recorded run comes to.

pub mod balance;
mod cage;
mod checkpoint;
mod gathered;
mod known;
mod outcome;
mod recording;
mod resume;
mod session;
mod settled;
mod start;
mod summary;
mod tally;
mod tape;
mod unrecorded;
pub mod warnings;

pub use balance::imbalance;
pub use cage::CageMotion;
pub(crate) use checkpoint::FORMAT as CHECKPOINT_FORMAT;
#[doc(hidden)]
pub use checkpoint::is_checkpoint;
pub use known::{KnownAtEnd, KnownAtStart};
pub use outcome::{RunOutcome, RunReport, Stopped};
pub use session::{Beginning, PreparedRun, RunSession};
pub use settled::Settled;
pub use start::start_run;
pub(crate) use summary::unresolved;
pub use summary::{
    Powers, Summary, Worn, carries_accelerations, carries_accelerations_of_patch, carries_accelerations_of_scheme,
};
#[cfg(feature = "parquet")]
pub(crate) use tally::Tally;
pub use tape::Viewers;
pub(crate) use unrecorded::run_unrecorded;
