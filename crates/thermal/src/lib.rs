#![doc = include_str!("../README.md")]

mod network;
mod usual;

pub use network::{Conductances, Heat, Temperatures, ThermalError};
pub use usual::{BearingSize, passing_conductance};
