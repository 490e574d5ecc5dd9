//! Transient runs of the paper's bearing: which there are, how they are run, what is kept of them.

mod orbit;
mod plans;
mod trace;

pub use orbit::{RPM, SECTORS, Window};
pub use plans::{AUTHORS, CLASSICAL, Change, FAST, Plan, Reading, Set};
pub use trace::{StateSample, Trace};

use crate::error::PaperError;
use crate::files;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{Run, RunError};
use tribodyn_identify::Adapt;
use tribodyn_record::{RunRecorder, RunRecording};

/// A finished run.
#[derive(Debug)]
pub struct Transient {
    pub label: String,
    pub case: Case,
    pub trace: Trace,
    /// Mean orbital speed of the quasi-static solution at the start, r/min.
    pub start_rpm: f64,
}

impl Transient {
    /// The last whole orbits of the second half of the run, where the start has died out.
    pub fn settled(&self) -> Window<'_> {
        Window::settled(&self.trace)
    }

    /// Warnings that the solver gave.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        self.trace.warnings.iter().map(String::as_str)
    }
}

/// Runs all plans on all cores and returns them in their order; recordings go into the folder if there is one.
pub fn run_all(plans: &[Plan], recordings: Option<&Path>) -> Result<Vec<Transient>, PaperError> {
    if let Some(folder) = recordings {
        std::fs::create_dir_all(folder).map_err(|source| PaperError::Write { path: folder.to_owned(), source })?;
    }
    let one = |index: usize| {
        let plan = &plans[index];
        run(plan, recordings.map(|folder| folder.join(format!("dynamic-{}.mcap", plan.id))))
    };
    on_all_cores(plans.len(), one).into_iter().collect()
}

/// Does pieces of work, by their numbers, on all cores; the results are in the order of the numbers.
pub fn on_all_cores<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(count);
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, T)>> = Mutex::new(Vec::new());
    let turn = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return;
            }
            let result = work(index);
            done.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push((index, result));
        }
    };
    std::thread::scope(|scope| (0..workers).for_each(|_| drop(scope.spawn(turn))));
    let mut finished = done.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    finished.sort_by_key(|(index, _)| *index);
    finished.into_iter().map(|(_, result)| result).collect()
}

fn run(plan: &Plan, recording: Option<PathBuf>) -> Result<Transient, PaperError> {
    let file = plan.file.to_owned();
    let refused = |source| PaperError::Case { file: file.clone(), source: Box::new(source) };
    let mut text = files::read(&files::root().join(&plan.file))?;
    for (path, value) in &plan.changes {
        text = set_value(&text, path, value).map_err(refused)?;
    }
    let case = Case::from_ron(&text).map_err(refused)?;
    let failed = |source| PaperError::Transient { run: plan.id.clone(), source: Box::new(source) };
    let mut inputs =
        case.run_inputs().map_err(|source| PaperError::Inputs { run: plan.id.clone(), source: Box::new(source) })?;
    if let Some(Adapt(change)) = &plan.adapt {
        let point = inputs.operating_point_at(0.0);
        change(&mut inputs.bearing, &point);
    }
    let mut solver = Run::new(inputs.clone()).map_err(failed)?;
    let recorder = match &recording {
        None => None,
        Some(path) => {
            let generator = concat!("tribodyn xtask ", env!("CARGO_PKG_VERSION"));
            let (facts, warnings) = (&[], &[]);
            let (case_text, name, inputs, scheme) = (&text, &case.name, &inputs, solver.scheme());
            let recording = RunRecording { case_text, name, inputs, scheme, facts, warnings, generator };
            Some(RunRecorder::create(path, &recording)?)
        }
    };
    let mut observer = trace::Observing { trace: Trace::new(&case), recorder };
    let _ = solver.advance(f64::INFINITY, &mut observer).map_err(|error| match error {
        RunError::Dynamics(source) => failed(source),
        RunError::Observer(source) => PaperError::Record(source),
    })?;
    if let Some(recorder) = observer.recorder {
        recorder.finish()?;
    }
    Ok(Transient {
        label: plan.label.clone(),
        start_rpm: solver.solution().cage_speed_rpm,
        trace: observer.trace,
        case,
    })
}
