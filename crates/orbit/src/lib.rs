#![doc = include_str!("../README.md")]

mod collocation;
mod error;
mod mesh;
mod newton;
mod residual;
mod solution;
mod solve;
mod start;
mod statics;
mod sweep;
mod system;

pub use error::{OrbitError, OrbitPlace};
pub use newton::OrbitStatistics;
pub use solution::{OrbitPoint, POINTS, SteadyOrbit};
pub use solve::{OrbitSettings, OrbitStart, SolvedOrbit, steady_orbit, steady_orbit_from};
