#![doc = include_str!("../README.md")]

mod error;
pub mod figures;
pub mod files;
pub mod hypotheses;
pub mod markers;
mod mean;
mod progress;
pub mod sensitivity;
pub mod table;
mod transient;
pub mod validate;

pub use error::{PaperError, listed};
pub use mean::{mean, rms};
pub use progress::Progress;
