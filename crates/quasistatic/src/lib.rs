//! Quasi-static equilibrium of a ball bearing: Jones–Harris with raceway control, and six balances per ball with the
//! traction integrals of both contacts.
//!
//! # Equations
//! ```text
//! 0 = Q_i sin α_i − Q_o sin α_o + T_a
//! 0 = Q_i cos α_i − Q_o cos α_o + T_r + m r_c ω_m²
//! 0 = T_t − F_d + (1/r_c)(−Q_i cos α_i x_i·e_t + Q_o cos α_o x_o·e_t)
//! 0 = M_i + M_o + M_d − J ω_m e_a × Ω
//! 0 = load on the ring − Σ (force of the ring on the balls), for each loaded freedom
//! ```
//! Jones–Harris replaces traction by raceway control: ω_m/ω_i = (1 − γ' cos α_i)/(1 + cos(α_i − α_o)) and
//! tan β = sin α_o/(cos α_o + γ') under outer control, γ' = D/d_m, and the gyroscopic moment carried by friction at the
//! controlling race.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | Q, α | contact load, contact angle | N, rad |
//! | T, M | traction on the ball and its moment | N, N m |
//! | F_d, M_d | drag, churning moment | N, N m |
//! | r_c, ω_m | radius and speed of the orbit | m, rad/s |
//! | Ω, J, m | absolute angular velocity, moment of inertia, mass of a ball | rad/s, kg m², kg |
//!
//! Sources: Jones 1960, doi:10.1115/1.3662587; Lubricants 2025, 13(8), 352, doi:10.3390/lubricants13080352, sections 3
//! and 4.3.3.
//!
//! A ball may have several equilibria, or only a skidding one: [`solve`] finds the one that a rolling ball comes to, and
//! [`other_roots`] searches for others on request. A ball that the ring's motion frees of the inner race does not always end at
//! rest: it slows down in the fluid, its centrifugal force falls, it may touch the inner race again and be driven at a speed below
//! rolling. Followed in small steps of time at four points where both ends exist, such a ball comes to the driven one, as [`solve`]
//! does; no run from rolling was seen to end in the other, where it stands still, free of both races.
//!
//! Limits: each ball is in equilibrium at its own azimuth, so ω_m differs from ball to ball and the orbit is not
//! followed in time; the cage acts on no ball (its pocket force is worked out afterwards). The crate prints nothing
//! and reads nothing.

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
pub use block::SolverStatistics;
pub use problem::{Place, QuasiStaticError};
pub use roots::{BallRoots, Root, other_roots, root_warnings};
pub use solution::{BallSolution, Model, Solution};
pub use solve::{BallMotion, Solved, WarmStart, solve, solve_from};
pub use tribodyn_bearing::{Bearing, Cage, OperatingPoint, RaceControl, RingFreedom, SolverSettings};
pub use tribodyn_traction::PatchRule;
