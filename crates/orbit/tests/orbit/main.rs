//! Tests of the steady orbit.

mod support;

mod checked;
mod damped;
mod forced;
mod kicked;
mod limits;
mod linear;
mod oil;
mod partly_loaded;
mod skidding;
mod watched;
