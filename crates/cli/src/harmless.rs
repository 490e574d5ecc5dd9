//! Texts from files and other people that must not steer a terminal.

pub use tribodyn_report::words::{steers, visible};

/// A text of several lines that cannot steer a terminal.
pub fn harmless(text: &str) -> String {
    text.chars().map(|c| if steers(c) { '\u{fffd}' } else { c }).collect()
}
