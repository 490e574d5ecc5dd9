#![doc = include_str!("../README.md")]

mod azimuth;
mod block;
mod cage;
mod driver;
mod jones_harris;
mod methods;
mod problem;
mod report;
mod roots;
mod secant;
mod settle;
mod solution;
mod solve;
mod with_traction;

#[cfg(test)]
mod branch_test;
#[cfg(test)]
mod jacobian_test;

pub use azimuth::{AzimuthRule, OverAzimuth, ball_numbers};
pub use block::{RingFreedom, SolverStatistics};
pub use problem::{OperatingPoint, Place, QuasiStaticError};
pub use roots::{BallRoots, Root, other_roots, root_warnings};
pub use solution::{BallSolution, Model, Solution};
pub use solve::{BallMotion, Solved, WarmStart, solve, solve_from};
