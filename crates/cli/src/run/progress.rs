//! How far a run is, on standard error while it is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::{Duration, Instant};

/// Parts into which the bar divides the duration.
const PARTS: u64 = 10_000;

pub struct Progress {
    bar: ProgressBar,
    duration_s: f64,
    /// Simulated time at which this part of the run began, s.
    from_s: f64,
    began: Instant,
}

impl Progress {
    pub fn new(quiet: bool, duration_s: f64, from_s: f64) -> Self {
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(PARTS) };
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}") {
            bar.set_style(style);
        }
        Self { bar, duration_s, from_s, began: Instant::now() }
    }

    pub fn show(&self, time_s: f64) {
        self.bar.set_position((time_s / self.duration_s * PARTS as f64) as u64);
        let wall = self.began.elapsed().as_secs_f64();
        let done = time_s - self.from_s;
        if wall <= 0.0 || done <= 0.0 {
            return;
        }
        let left = Duration::from_secs_f64(((self.duration_s - time_s).max(0.0) * wall / done).min(1e9));
        let left = indicatif::HumanDuration(left);
        let factor = done / wall;
        self.bar.set_message(format!(
            "{} of {} s, {} times real time, {left} left",
            time(time_s),
            self.duration_s,
            significant(factor)
        ));
    }
}

/// A simulated time in s, with more digits where a run is slow.
fn time(time_s: f64) -> String {
    if time_s < 1e-3 { format!("{time_s:.3e}") } else { format!("{time_s:.4}") }
}

/// Two digits that matter.
pub fn significant(value: f64) -> String {
    let digits = if value == 0.0 { 0.0 } else { (1.0 - value.abs().log10().floor()).clamp(0.0, 9.0) };
    let digits = digits as usize;
    format!("{value:.digits$}")
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::{significant, time};

    #[test]
    fn limit_times_of_slow_runs_are_seen_to_grow() {
        assert_eq!([time(1.2345e-9), time(0.01234)], ["1.235e-9", "0.0123"]);
    }

    #[test]
    fn limit_factors_keep_two_digits() {
        assert_eq!([0.0123, 1.26, 47.0, 0.0].map(significant), ["0.012", "1.3", "47", "0"]);
    }
}
