//! A recording of a quasi-static solution: one orbit of the cage.

mod check;
pub(crate) mod messages;
pub(crate) mod timeline;
pub(crate) mod write;
