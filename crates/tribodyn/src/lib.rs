#![doc = include_str!("../README.md")]

pub mod answers;
mod case_file;
mod error;
mod limits;
pub mod pair;
pub mod plausibility;
pub mod rating;
mod refused;
pub mod sheet;

pub use case_file::{CaseFile, Change, path_and_value, without_mark};
pub use error::AnswerError;
pub use limits::{Limits, lifted};
pub use refused::RefusedCase;

// What answers are made of, so that a program needs this crate only.
pub use tribodyn_bearing::{
    BallResult, Bearing, ContactResult, OperatingPoint, Races, SearchObserver, SearchStage, SearchWatch, Side,
    Translation,
};
pub use tribodyn_case::{Case, CaseError};
pub use tribodyn_catalogue::{
    Envelope, Given, KnownBalls, NewCase, NewLubricant, Ratings, find as find_bearing, search as search_bearings,
};
pub use tribodyn_orbit::{OrbitSettings, SteadyOrbit, steady_orbit};
pub use tribodyn_quasistatic::{Model, Solution, StiffnessMatrix, solve};
