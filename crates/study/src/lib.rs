#![doc = include_str!("../README.md")]

pub mod answers;
mod case_file;
mod difference;
pub mod ensemble;
mod error;
pub mod evaluation;
mod files;
mod holder;
mod journal;
mod life;
mod limits;
mod lock;
mod ours;
pub mod pair;
mod patience;
pub mod plausibility;
pub mod preload;
pub mod rating;
pub mod run;
pub mod shaft;
pub mod sheet;
pub mod survey;
pub mod sweep;
pub mod vibration;

pub use case_file::{CaseFile, Change, path_and_value, read_text};
pub use difference::SweepDifference;
pub use error::{RefusedCase, StudyError, with_causes};
pub use files::StagedFiles;
pub use holder::Holder;
pub use life::{Life, LifeEnd, LifeOptions, LifeStride, LifeTable, wear_life};
pub use limits::Limits;
pub use ours::Ours;
pub use patience::Patience;
