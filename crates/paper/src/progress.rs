//! Progress of long work.

use std::time::Instant;

/// Receives a line at a time: what is done and how long it took, or what is noteworthy.
pub type Progress<'a> = &'a dyn Fn(&str);

/// Does something and reports how long it took.
pub fn in_time<T>(what: &str, progress: Progress, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    progress(&format!("{what}: {:.1} s", start.elapsed().as_secs_f64()));
    result
}
