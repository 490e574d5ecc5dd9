//! Numbers of a recording that has been read back.

pub mod facts;
pub mod published;
pub mod quantities;
