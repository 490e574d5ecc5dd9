//! A search for an operating point: what it is at, on standard error, and the time that it may take.

use crate::failure::Failure;
use indicatif::ProgressBar;
use std::io::{IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tribodyn::CaseFile;
use tribodyn::plausibility::estimate;
use tribodyn_bearing::{SearchStage, SearchWatch};
use tribodyn_study::{Patience, StudyError};

/// The limit on a search.
#[derive(clap::Args)]
pub struct TimeArguments {
    /// Stop the search for an operating point after this much processor time, s; inf for no limit
    #[arg(long = "time-limit", value_name = "S", default_value_t = 60.0, value_parser = seconds)]
    pub limit_s: f64,
}

fn seconds(text: &str) -> Result<f64, String> {
    let found: Option<f64> = text.parse().ok().filter(|seconds| *seconds > 0.0);
    found.ok_or_else(|| "allowed are seconds above 0, or inf".to_owned())
}

/// Seconds of processor time after which a line says on a standard error that is no terminal what takes the time.
const QUIET_S: f64 = 2.0;
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A search that is shown while it goes on.
pub struct Search {
    patience: Arc<Patience>,
    limit_s: f64,
    file: String,
    done: Arc<AtomicBool>,
    strides: Arc<AtomicUsize>,
    shown: Option<JoinHandle<()>>,
}

impl Search {
    /// Says first what the loads of the case come to, should that be too much for its bearing.
    pub fn begin(file: &CaseFile, time: &TimeArguments) -> Self {
        let patience = Arc::new(Patience::of_seconds(time.limit_s));
        let done = Arc::new(AtomicBool::new(false));
        let terminal = std::io::stderr().is_terminal();
        // The answer has the same sentence among its warnings, so that a pipe needs none before.
        if terminal && let Some(warning) = load_warning(file) {
            tell(&format!("warning: {warning}"));
        }
        let strides = Arc::new(AtomicUsize::new(0));
        let (seen, ended, limit_s) = (Arc::clone(&patience), Arc::clone(&done), time.limit_s);
        let counted = Arc::clone(&strides);
        let shown = std::thread::Builder::new().spawn(move || show(&seen, (&ended, &counted), limit_s, terminal)).ok();
        Self { patience, limit_s, file: file.name.clone(), done, strides, shown }
    }

    /// For a life: one operating point after the other, for as long as that takes.
    pub fn of_strides(file: &CaseFile) -> Self {
        Self::begin(file, &TimeArguments { limit_s: f64::INFINITY })
    }

    /// Counts a finished stride.
    pub fn stride(&self) {
        self.strides.fetch_add(1, Ordering::Relaxed);
    }

    /// The link for those who search.
    pub fn watch(&self) -> SearchWatch {
        SearchWatch::new(self.patience.clone())
    }

    /// The failure of the search as a person reads it.
    pub fn failed(&self, error: impl Into<StudyError>) -> Failure {
        let error = error.into();
        if error.is_ended() {
            let stage =
                self.patience.reached().map_or_else(String::new, |stage| format!(", while trying {}", words(stage)));
            return Failure::OutOfTime { file: self.file.clone(), limit_s: self.limit_s, stage };
        }
        error.into()
    }
}

impl Drop for Search {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Relaxed);
        if let Some(shown) = self.shown.take() {
            shown.thread().unpark();
            // A thread that only shows has nothing to say about the search.
            let _ = shown.join();
        }
    }
}

fn load_warning(file: &CaseFile) -> Option<String> {
    let bearing = file.bearing().ok()?;
    estimate(&file.case, &bearing)?.warning(&file.case, (&file.text, &bearing))
}

/// A stage in words.
fn words(stage: SearchStage) -> String {
    let rpm = |speed: f64| format!(" (cage at {:.0} r/min)", speed * 30.0 / std::f64::consts::PI);
    format!("{}{}", stage.name, stage.cage_speed.map_or_else(String::new, rpm))
}

/// A line that changes on a terminal, or one line elsewhere.
fn show(patience: &Patience, (done, strides): (&AtomicBool, &AtomicUsize), limit_s: f64, terminal: bool) {
    let began = Instant::now();
    let bar = if terminal { ProgressBar::new_spinner() } else { ProgressBar::hidden() };
    let mut told = false;
    while !done.load(Ordering::Relaxed) {
        let seconds = began.elapsed().as_secs_f64();
        let stage = patience.reached().map_or_else(|| "rolling balls".to_owned(), words);
        let strides = match strides.load(Ordering::Relaxed) {
            0 => String::new(),
            finished => format!("{finished} strides finished; "),
        };
        bar.set_message(format!("{strides}seeking the operating point: {stage}, {seconds:.0} s"));
        bar.tick();
        if !terminal && !told && patience.spent_s() > QUIET_S {
            told = true;
            let limit = format!("; it may take {limit_s} s of processor time (--time-limit)");
            let limit = if limit_s.is_finite() { limit } else { String::new() };
            tell(&format!("seeking the operating point: {stage}{limit}"));
        }
        std::thread::park_timeout(LOOK_EVERY);
    }
    bar.finish_and_clear();
}

/// A line on standard error; where nobody reads it nothing can be done.
fn tell(text: &str) {
    let _ = writeln!(std::io::stderr(), "{}", crate::harmless::harmless(text));
}

#[cfg(test)]
mod tests {
    use super::seconds;

    #[test]
    fn limit_of_time_is_above_nothing() {
        assert_eq!([seconds("2.5"), seconds("inf")], [Ok(2.5), Ok(f64::INFINITY)]);
        assert!(["0", "-1", "nan", "x"].iter().all(|text| seconds(text).is_err()));
    }
}
