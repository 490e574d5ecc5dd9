//! Procedures on bearing models: what takes more than one solution, or more than one sitting.
//!
//! | module | procedure | result |
//! |---|---|---|
//! | [`wear_life`] | wear of the coatings by strides between equilibria, until one is through | [`Life`] |
//! | [`run`] | a transient run with checkpoints, taken up again after a stop | recording (MCAP), [`run::RunReport`] |
//! | [`evaluation`] | quantities of a recording, beside published figures | [`evaluation::quantities::Quantities`] |
//! | [`sweep`] | equilibria over a grid of case values, in parallel, taken up again after a stop | table (CSV, Parquet) |
//!
//! A procedure takes a [`CaseFile`] and a plain structure of options and gives back a plain structure of numbers, in SI
//! units unless a field's name ends in another one. It prints nothing and ends no process: progress goes to a callback,
//! which can also stop the procedure, and every failure is a [`StudyError`].
//!
//! # Limits
//!
//! - Procedures write files where they are told to, under temporary names until they are whole.
//! - What the numbers look like on a terminal or a page is left to the caller.

mod case_file;
mod error;
pub mod evaluation;
mod files;
mod life;
pub mod run;
pub mod sweep;

pub use case_file::{CaseFile, Change, read_text};
pub use error::{RefusedCase, StudyError, SweepDifference, with_causes};
pub use files::StagedFiles;
pub use life::{Life, LifeOptions, LifeStride, wear_life};
