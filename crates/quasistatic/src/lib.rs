#![doc = include_str!("../README.md")]

mod at_rest;
mod azimuth;
mod block;
mod cage;
mod condensed;
mod driver;
mod jones_harris;
mod methods;
mod needs;
mod problem;
mod relax;
mod report;
mod rescue;
mod rolling;
mod roots;
mod secant;
mod settle;
mod solution;
mod solve;
mod stability;
mod start;
mod stiffness;
mod warm;
mod with_traction;

#[cfg(test)]
mod branch_test;
#[cfg(test)]
mod jacobian_test;

pub use at_rest::{Seated, shaft_at_rest};
pub use azimuth::{AzimuthRule, OverAzimuth};
pub use block::SolverStatistics;
pub use condensed::{StiffnessMatrix, compliance};
pub use needs::check_thrust;
pub use problem::{Place, QuasiStaticError, Reason};
pub use rolling::{RollingStart, rolling_start};
pub use roots::{BallRoots, Root, other_roots, root_warnings};
pub use solution::{Model, SOLUTION, Solution};
pub use solve::{Solved, solve};
pub use stability::{is_stable, ring_stability};
pub use start::{BallMotion, WarmStart};
pub use stiffness::{
    checked_traction_stiffness, doubtful_stiffness, is_wrong_stiffness, jones_harris_stiffness, traction_stiffness,
};
pub use tribodyn_bearing::{
    BallResult, Bearing, Cage, ContactResult, Modelling, OperatingPoint, RaceControl, Races, RingFreedom, Side,
    SolverSettings,
};
pub use tribodyn_traction::{PatchChoice, PatchRule};
pub use warm::{solve_from, solve_near};
