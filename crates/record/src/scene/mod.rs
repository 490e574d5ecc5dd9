//! The picture of a bearing in Foxglove: bodies, what lies on them, arrows, and the frames that move it all.

pub(crate) mod colour;
pub(crate) mod contacts;
pub(crate) mod frames;
pub(crate) mod geometry;
pub(crate) mod guide;
pub(crate) mod mesh;
pub(crate) mod quaternion;
pub(crate) mod raceway;
pub(crate) mod trail;

pub(crate) use geometry::{Bodies, entity, geometry};
