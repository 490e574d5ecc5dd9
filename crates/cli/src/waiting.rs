//! A sign of life on standard error, while it is a terminal.

use indicatif::ProgressBar;
use std::time::Duration;

/// Shown while an orbit or the start of a run is sought, which takes minutes where many balls skid; it goes when it is
/// dropped.
pub struct Waiting(ProgressBar);

impl Waiting {
    /// With a few words on what takes the time.
    pub fn new(quiet: bool, words: &'static str) -> Self {
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new_spinner() };
        bar.set_message(words);
        bar.enable_steady_tick(Duration::from_millis(200));
        Self(bar)
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
