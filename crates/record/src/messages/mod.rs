//! The messages of a recording, and how a ball becomes one.

pub(crate) mod ball;
pub(crate) mod units;
pub mod wire;

pub(crate) use crate::solution::messages::{fields, fill, in_contact, over_fields};
