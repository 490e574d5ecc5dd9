#![doc = include_str!("../README.md")]

mod case_file;
#[cfg(feature = "parquet")]
pub mod dataset;
mod difference;
pub mod ensemble;
mod error;
pub mod evaluation;
mod files;
mod fmu;
mod held;
mod holder;
mod journal;
mod life;
mod listing;
mod lock;
mod ours;
mod patience;
pub mod preload;
mod recovered;
pub mod run;
pub mod shaft;
pub mod survey;
pub mod sweep;
pub mod vibration;

pub use case_file::{layout_of, read_case, read_text};
pub use difference::SweepDifference;
pub use error::{StudyError, with_causes};
pub use files::StagedFiles;
pub use fmu::{FmuAnswer, FmuOptions, export_fmu};
pub use holder::Holder;
pub use life::{
    ActingLife, ActingOptions, ActingStride, ActingTable, Effects, FirstThrough, Life, LifeEnd, LifeOptions,
    LifeStride, LifeTable, Mission, Phase, acting_life, wear_life,
};
pub use listing::{Listed, listed};
pub use ours::Ours;
pub use patience::Patience;
pub use recovered::{Recovered, recover};
