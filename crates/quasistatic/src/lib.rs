//! (filled by the quasi-static work)
mod solution;
pub use solution::{BallSolution, Model, Solution};
