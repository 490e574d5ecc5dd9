//! Measured signals: files with their columns, and what they say of a bearing.

mod ask;
mod bearing;
mod csv;
mod mat;
#[cfg(feature = "parquet")]
mod parquet;
mod question;
mod read;
mod recording;
mod signal_file;
#[cfg(test)]
mod tests;
mod wav;

pub use ask::{SignalQuestion, diagnosed};
pub use bearing::{bearing_of_case, bearing_of_numbers};
pub use question::{Analysis, QUIET, Speed, Window, analysis};
pub use signal_file::{Column, SignalFile};
