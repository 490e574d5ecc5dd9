//! MCAP files: writing, reading, and what can be saved of a damaged one.

pub(crate) mod held;
pub(crate) mod messages;
mod numbers;
pub(crate) mod output;
pub(crate) mod read;
pub(crate) mod recover;
pub(crate) mod replay;
pub(crate) mod scan;
pub(crate) mod temporary;
