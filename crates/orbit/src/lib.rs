#![doc = include_str!("../README.md")]

mod collocation;
mod error;
mod mesh;
mod modes;
mod newton;
mod residual;
mod solution;
mod solve;
mod start;
mod statics;
mod stiffness;
mod sweep;
mod system;

pub use error::{OrbitError, OrbitPlace};
pub use modes::{Bodies, EnergyShares, Mode};
pub use newton::OrbitStatistics;
pub use solution::{POINTS, SteadyOrbit};
pub use solve::{
    OrbitSettings, OrbitStart, SolvedOrbit, orbit_modes, orbit_stiffness, steady_orbit, steady_orbit_from,
};
