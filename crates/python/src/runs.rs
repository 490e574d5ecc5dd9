//! Long work: runs in time, lives of coatings, identification.

use crate::answers::equations;
use crate::case::NativeCase;
use crate::convert::to_python;
use crate::error::{self, internal};
use crate::watch::{Watch, watched};
use pyo3::prelude::*;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tribodyn::{AnswerError, CaseFile, Change, Limits};
use tribodyn_bearing::SearchWatch;
use tribodyn_identify::{IdentifyError, Problem, identify as identified};
use tribodyn_study::run::{Beginning, PreparedRun};
use tribodyn_study::{
    ActingOptions, Effects, LifeOptions, Mission, StudyError, acting_life as study_acting_life, read_text, wear_life,
};

/// Runs a case in time and records it. `progress` gets the simulated time, s. The answer is the command's, with where
/// the run was stopped, and the exception that stopped it.
#[pyfunction]
pub fn run<'py>(
    py: Python<'py>,
    case: &NativeCase,
    output: PathBuf,
    duration: Option<f64>,
    beginning: &str,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyAny>, Option<PyErr>)> {
    let beginning = match beginning {
        "new" => Beginning::New,
        "resume" => Beginning::Resume,
        "restart" => Beginning::Restart,
        other => return Err(error::argument(py, "beginning", other, "allowed are new, resume, restart")),
    };
    let (file, limits) = (Arc::clone(&case.file), case.limits);
    let (ended, stopped) = watched(py, progress, true, move |watch| {
        let lasting = duration.map(|seconds| with_duration(&file, seconds, &limits)).transpose()?;
        record(lasting.as_ref().unwrap_or(&file), &output, beginning, watch)
    })?;
    match (ended, stopped) {
        (Ok(answer), stopped) => Ok((to_python(py, &answer)?, stopped)),
        (Err(failure), None) => Err(error::study(py, failure)),
        (Err(_), Some(stopped)) => Err(stopped),
    }
}

/// The case with another duration.
fn with_duration(file: &CaseFile, seconds: f64, limits: &Limits) -> Result<CaseFile, AnswerError> {
    // A duration alone makes no section: the news is all that is missing, and not the path.
    if file.case.transient.is_none() {
        file.run_inputs()?;
    }
    let change = Change::new(format!("duration = {seconds}"), "transient.duration", &format!("s({seconds})"));
    CaseFile::from_text(&file.name, file.text.clone(), &[change], limits)
}

fn record(file: &CaseFile, output: &Path, beginning: Beginning, watch: &Watch) -> Result<Value, StudyError> {
    let session = PreparedRun::new(file, output, beginning)?.begin(None)?;
    let outcome = session.complete(|time_s| {
        watch.reached(time_s);
        if watch.stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let mut answer = serde_json::to_value(&outcome.report)?;
    answer["stopped_s"] = json!(outcome.stopped.map(|stopped| stopped.simulated_s));
    Ok(answer)
}

/// Wears the raceways of a bearing until a coating is through, a time (h) is over, or wear has added a clearance (um).
#[pyfunction]
pub fn life<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: &str,
    strides: u32,
    limits: (Option<f64>, Option<f64>),
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (until, clearance_limit) = limits;
    if !(1..=10_000).contains(&strides) {
        return Err(error::argument(py, "strides", &strides.to_string(), "allowed is 1 to 10000"));
    }
    if let Some(hours) = until.filter(|hours| !(*hours > 0.0 && hours.is_finite())) {
        return Err(error::argument(py, "until", &hours.to_string(), "allowed is a number of hours above 0"));
    }
    if let Some(um) = clearance_limit.filter(|um| !(*um > 0.0 && um.is_finite())) {
        return Err(error::argument(py, "clearance_limit", &um.to_string(), "allowed is a number of um above 0"));
    }
    let file = Arc::clone(&case.file);
    let options = LifeOptions {
        strides,
        until_s: until.map(|hours| hours * 3600.0),
        clearance_limit_m: clearance_limit.map(|um| um * 1e-6),
        equations: equations(py, model)?,
        watch: SearchWatch::default(),
    };
    let (life, stopped) = watched(py, progress, true, move |watch| {
        let options = LifeOptions { watch: watch.searches(), ..options };
        wear_life(&file, options, |_| {
            watch.add(1.0);
            if watch.stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    })?;
    match stopped {
        Some(stopped) => Err(stopped),
        None => to_python(py, &life.map_err(|failure| error::study(py, failure))?),
    }
}

/// [`life`] with wear that acts on the bearing; `files` are the tables of strides and of worn cells.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "those of the command")]
pub fn acting_life<'py>(
    py: Python<'py>,
    case: &NativeCase,
    model: &str,
    strides: u32,
    until: Option<f64>,
    acting: Vec<String>,
    bare_limit: f64,
    mission: Option<PathBuf>,
    files: (Option<PathBuf>, Option<PathBuf>),
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    if !(1..=10_000).contains(&strides) {
        return Err(error::argument(py, "strides", &strides.to_string(), "allowed is 1 to 10000"));
    }
    if let Some(hours) = until.filter(|hours| !(*hours > 0.0 && hours.is_finite())) {
        return Err(error::argument(py, "until", &hours.to_string(), "allowed is a number of hours above 0"));
    }
    if !(bare_limit > 0.0 && bare_limit <= 1.0) {
        return Err(error::argument(
            py,
            "bare_limit",
            &bare_limit.to_string(),
            "allowed is a number above 0, at most 1",
        ));
    }
    let file = Arc::clone(&case.file);
    let study = |failure| error::study(py, failure);
    let options = ActingOptions {
        effects: Effects::named(acting.iter().map(String::as_str)).map_err(study)?,
        strides,
        until_s: until.map(|hours| hours * 3600.0),
        bare_limit,
        equations: equations(py, model)?,
        watch: SearchWatch::default(),
    };
    let mission = match mission {
        Some(path) => read_text(&path, &Limits::NORMAL).and_then(|text| Mission::read(&text, &file, &Limits::NORMAL)),
        None => Mission::steady(&file, &Limits::NORMAL),
    };
    let mission = mission.map_err(study)?;
    let (life, stopped) = watched(py, progress, true, move |watch| {
        let options = ActingOptions { watch: watch.searches(), ..options };
        let life = study_acting_life(&file, &mission, &options, |_| {
            watch.add(1.0);
            if watch.stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })?;
        if !watch.stopped() {
            files.0.map_or(Ok(()), |path| life.write_strides(&path))?;
            files.1.map_or(Ok(()), |path| life.write_map(&path))?;
        }
        Ok::<_, StudyError>(life)
    })?;
    match stopped {
        Some(stopped) => Err(stopped),
        None => to_python(py, &life.map_err(|failure| error::study(py, failure))?),
    }
}

/// A problem file with its case.
struct Posed {
    problem: Problem,
    case: String,
}

/// Reads a problem with its case, which stands beside it.
fn posed(py: Python<'_>, path: &Path, seed: Option<u64>, starts: Option<usize>) -> PyResult<Posed> {
    let name = path.display().to_string();
    let refused = |failure: IdentifyError| error::identify(py, &name, &failure);
    let unread = |failure| error::study(py, failure);
    let text = read_text(path, &Limits::NORMAL).map_err(unread)?;
    let mut problem = Problem::from_ron(&text).map_err(refused)?;
    problem.seed = seed.unwrap_or(problem.seed);
    problem.starts = starts.unwrap_or(problem.starts);
    problem.check().map_err(refused)?;
    let case = path.parent().unwrap_or(Path::new("")).join(&problem.case);
    Ok(Posed { problem, case: read_text(&case, &Limits::NORMAL).map_err(unread)? })
}

/// Identifies unknown parameters under each hypothesis of a problem file. `progress` gets the number of starts.
#[pyfunction]
pub fn identify<'py>(
    py: Python<'py>,
    path: PathBuf,
    seed: Option<u64>,
    starts: Option<usize>,
    threads: usize,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let Posed { problem, case } = posed(py, &path, seed, starts)?;
    let pool = pool(py, threads)?;
    let (answers, _) = watched(py, progress, false, move |watch| {
        let told = || watch.add(1.0);
        pool.install(|| identified(&problem, &case, &told, &watch.searches()))
    })?;
    let answers = answers.map_err(|failure| error::identify(py, &path.display().to_string(), &failure))?;
    to_python(py, &answers)
}

/// Number of starts of a problem file, for all its hypotheses.
#[pyfunction]
pub fn identification_starts(py: Python<'_>, path: PathBuf, starts: Option<usize>) -> PyResult<usize> {
    let Posed { problem, .. } = posed(py, &path, None, starts)?;
    Ok((problem.starts + usize::from(problem.from_case)) * problem.hypotheses.len().max(1))
}

/// Threads for one call; none outlives it, so that a process may be forked. 0 is one for each core.
pub fn pool(py: Python<'_>, threads: usize) -> PyResult<rayon::ThreadPool> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|failure| internal(py, &failure.to_string()))
}
