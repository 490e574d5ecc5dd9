//! Tests of the steady orbit.

mod support;

mod limits;
mod linear;
