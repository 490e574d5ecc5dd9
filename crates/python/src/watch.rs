//! Long work beside a Python that still listens: progress is told and an interrupt is heard some times a second.

use crate::error::internal;
use pyo3::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, mpsc};
use std::time::Duration;
use tribodyn_bearing::SearchWatch;
use tribodyn_study::Patience;

/// Time between looks at the interpreter.
const LOOK_EVERY: Duration = Duration::from_millis(50);

/// Progress of work, and the flag that asks it to end.
#[derive(Default)]
pub struct Watch {
    stop: Arc<AtomicBool>,
    done: AtomicU64,
}

impl Watch {
    /// Work that is done, in a unit of the caller's.
    pub fn reached(&self, done: f64) {
        self.done.store(done.to_bits(), Ordering::Relaxed);
    }

    /// Adds to the work that is done.
    pub fn add(&self, part: f64) {
        let more = |bits| Some((f64::from_bits(bits) + part).to_bits());
        // The closure always gives a value: there is no failure.
        let _ = self.done.fetch_update(Ordering::Relaxed, Ordering::Relaxed, more);
    }

    /// True if the work is to end.
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// By which searches of the work are ended.
    pub fn searches(&self) -> SearchWatch {
        SearchWatch::new(Arc::new(Patience::of_seconds(f64::INFINITY).ended_with(Arc::clone(&self.stop))))
    }
}

/// Does work on a thread of its own. `progress` is called with what is done; an interrupt, or an exception of
/// `progress`, asks the work to end. With `wait` the work is given the time to end in order; without, it is left to
/// itself, its result lost. Gives the result with the exception that came in between, if any.
pub fn watched<R: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    wait: bool,
    work: impl FnOnce(&Watch) -> R + Send + 'static,
) -> PyResult<(R, Option<PyErr>)> {
    watched_by(py, progress, (wait, Arc::default()), work)
}

/// [`watched`] with a flag of one's own that asks the work to end.
pub fn watched_by<R: Send + 'static>(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    (wait, stop): (bool, Arc<AtomicBool>),
    work: impl FnOnce(&Watch) -> R + Send + 'static,
) -> PyResult<(R, Option<PyErr>)> {
    stop.store(false, Ordering::Relaxed);
    let watch = Arc::new(Watch { stop, done: AtomicU64::default() });
    let (sender, receiver) = mpsc::channel();
    let of_work = Arc::clone(&watch);
    std::thread::spawn(move || {
        let result = catch_unwind(AssertUnwindSafe(|| work(&of_work)));
        // Nobody may wait for it any more.
        let _ = sender.send(result);
    });
    let receiver = std::sync::Mutex::new(receiver);
    let mut exception: Option<PyErr> = None;
    loop {
        let received = py.detach(|| receiver.lock().ok().map(|receiver| receiver.recv_timeout(LOOK_EVERY)));
        match received {
            // Work that is done before the first look has its end told, too.
            Some(Ok(Ok(result))) => {
                let exception = exception.or_else(|| tell(progress, &watch).err());
                return Ok((result, exception));
            }
            Some(Ok(Err(_))) => return Err(internal(py, "the calculation has panicked")),
            Some(Err(mpsc::RecvTimeoutError::Timeout)) => {}
            _ => return Err(internal(py, "the calculation has vanished")),
        }
        if exception.is_none() {
            exception = look(py, progress, &watch).err();
            if exception.is_some() {
                watch.stop.store(true, Ordering::Relaxed);
            }
        }
        if !wait && let Some(exception) = exception.take() {
            return Err(exception);
        }
    }
}

/// Hears signals and tells the progress.
fn look(py: Python<'_>, progress: Option<&Bound<'_, PyAny>>, watch: &Watch) -> PyResult<()> {
    py.check_signals()?;
    tell(progress, watch)
}

/// Calls `progress` with what is done.
fn tell(progress: Option<&Bound<'_, PyAny>>, watch: &Watch) -> PyResult<()> {
    match progress {
        Some(progress) => progress.call1((f64::from_bits(watch.done.load(Ordering::Relaxed)),)).map(drop),
        None => Ok(()),
    }
}

/// Work that searches: the limit on its processor time, s, ends it, and so does an interrupt.
pub fn searching<R: Send + 'static>(
    py: Python<'_>,
    limit_s: f64,
    work: impl FnOnce(SearchWatch) -> R + Send + 'static,
) -> PyResult<R> {
    let patience = Arc::new(Patience::of_seconds(limit_s));
    let link = SearchWatch::new(patience.clone());
    let done = watched(py, None, false, move |_| work(link));
    if done.is_err() {
        patience.stop();
    }
    done.map(|(result, _)| result)
}
