#![doc = include_str!("../README.md")]

mod attempt;
mod balance;
mod chain;
mod coarse;
mod collocation;
mod damping;
mod detours;
mod direct;
mod error;
mod events;
mod heavier;
mod homotopy;
mod linearised;
mod march;
mod means;
#[cfg(feature = "modes")]
mod modes;
#[cfg(feature = "modes")]
mod modes_matrix;
mod neighbours;
mod newton;
mod relief;
mod residual;
mod search;
mod settings;
mod shooting;
mod solution;
mod solve;
mod solved;
mod start;
mod statics;
mod stiffness;
mod system;

pub use damping::LessDamping;
pub use error::{OrbitError, OrbitPlace, OrbitReason};
#[cfg(feature = "modes")]
pub use modes::{EnergyShares, Mode, OrbitModes, orbit_modes};
#[cfg(feature = "modes")]
pub use modes_matrix::Bodies;
pub use newton::OrbitStatistics;
pub use settings::OrbitSettings;
pub use solution::{POINTS, SteadyOrbit};
pub use solve::{
    cold_rule, less_damped_orbit, orbit_slopes, orbit_stiffness, steady_orbit, steady_orbit_from, steady_orbit_near,
};
pub use solved::{OrbitStart, SolvedOrbit};
pub use stiffness::OrbitStiffness;
