//! Data sets of vibration signals with labels: transient runs of bearings with and without spalls, what sensors see of
//! them, and when each ball was over each edge.
//!
//! A member follows from the plan and its number alone, not from threads or from members that fail. Bearings are split
//! into those for training and those for tests, so that no bearing is in both.

mod mat;
mod members;
mod parquet;
mod row;
mod sensor;
mod signal;

use crate::case_file::read_text;
use crate::difference::SweepDifference;
use crate::error::StudyError;
use crate::files::StagedFiles;
use crate::journal::{self, Journal};
use crate::lock::OutputLock;
use crate::sweep::{Cell, Column, decode, encode};
use ::parquet::errors::ParquetError;
use members::Individual;
use rayon::prelude::*;
use row::List;
use serde::{Deserialize, Serialize};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;
use tribodyn::{AnswerError, CaseFile, Limits, RefusedCase};
use tribodyn_bearing::Translation;
use tribodyn_case::{CaseError, DatasetPlan};

/// Name of the table in the folder of a data set.
pub const TABLE: &str = "members.parquet";
/// Folder of the MATLAB files in it.
pub const MAT: &str = "mat";

/// A plan with the texts of its cases.
pub struct Dataset {
    plan: DatasetPlan,
    text: String,
    cases: Vec<(String, String)>,
    individuals: Vec<Individual>,
    limits: Limits,
}

/// Two data sets are the same where these are.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    tribodyn: String,
    plan: String,
    cases: Vec<String>,
}

impl journal::Identity for Identity {
    fn difference(&self, found: &Self) -> Option<SweepDifference> {
        match found {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.cases != self.cases => Some(SweepDifference::Case),
            o if o.plan != self.plan => Some(SweepDifference::Plan),
            _ => None,
        }
    }
}

/// The state of a data set after a call.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DatasetReport {
    /// Members of the set.
    pub members: usize,
    /// Those that are finished.
    pub finished: usize,
    /// Those of the finished ones that have no signal.
    pub failed: usize,
    /// Those of the finished ones whose runs warn.
    pub warned: usize,
    /// Bearings for training.
    pub bearings_train: usize,
    /// Bearings for tests.
    pub bearings_test: usize,
    /// Members that were run now.
    pub run: usize,
    /// Threads that shared them.
    pub threads: usize,
    /// Wall time of that, s.
    pub wall_s: f64,
    /// Members a second and thread; absent where none was run.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub members_per_s_and_thread: Option<f64>,
    /// Why the first member without a signal has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_failure: Option<String>,
    /// Warnings of the first member that has any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_warnings: Option<String>,
    /// The table; absent until the set is whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table: Option<PathBuf>,
    /// Folder of the MATLAB files.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mat: Option<PathBuf>,
}

impl Dataset {
    /// Reads a plan and its cases; members of every bearing are tried as far as their case files go.
    ///
    /// # Errors
    /// A plan or a case that cannot be read or is impossible.
    pub fn read(path: &Path, limits: &Limits) -> Result<Self, StudyError> {
        let text = read_text(path, limits)?;
        let name = path.display().to_string();
        let refused = |error| {
            let (file, text) = (name.clone(), text.clone());
            StudyError::from(AnswerError::Case(Box::new(RefusedCase { file, options: String::new(), text, error })))
        };
        let plan = DatasetPlan::from_ron(&text).map_err(&refused)?;
        let labels = row::labels();
        for (k, sensor) in plan.sensors.iter().enumerate() {
            if labels.iter().any(|(column, _)| column.name == sensor.name) {
                let taken: Vec<&str> = labels.iter().map(|(column, _)| column.name.as_str()).collect();
                let message = format!("is a column of the labels; taken are {}", taken.join(", "));
                return Err(refused(CaseError::at(&text, &format!("sensors[{k}].name"), message)));
            }
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        let case = |case: &String| {
            let path = folder.join(case);
            Ok::<_, StudyError>((path.display().to_string(), read_text(&path, limits)?))
        };
        let cases = plan.cases.iter().map(case).collect::<Result<_, _>>()?;
        let individuals = members::individuals(&plan);
        let dataset = Self { plan, text: text.clone(), cases, individuals, limits: *limits };
        let each = dataset.plan.loads.len() * dataset.plan.speeds.len();
        for bearing in 0..dataset.individuals.len() {
            let of_plan = |error| match error {
                AnswerError::Case(case) => match in_plan(&dataset, bearing * each, &case.error) {
                    Some(error) => refused(error),
                    None => AnswerError::Case(case).into(),
                },
                other => other.into(),
            };
            dataset.case_of(bearing * each).map_err(of_plan)?.run_inputs()?;
        }
        Ok(dataset)
    }

    /// Number of members.
    pub fn members(&self) -> usize {
        self.plan.members()
    }

    fn case_of(&self, member: usize) -> Result<CaseFile, AnswerError> {
        let choice = members::choice(&self.plan, &self.individuals, member);
        let (name, text) = &self.cases[choice.individual.case];
        choice.case(&self.plan, (name, text), &self.limits)
    }

    /// The fields of a member; none where `stop` was set before its end.
    fn row(&self, member: usize, stop: &AtomicBool) -> Option<Vec<Cell>> {
        let choice = members::choice(&self.plan, &self.individuals, member);
        let file = self.case_of(member).map_err(|error| error.to_string());
        let loads = file.as_ref().map_or(choice.load, |file| [&file.case.ring.x, &file.case.ring.z].map(force));
        let found = match file.and_then(|file| signal::signals(&self.plan, &choice, (member, &file), stop)) {
            Ok(Some(signals)) => Ok(signals),
            Ok(None) => return None,
            Err(why) => Err(why),
        };
        Some(row::row(&self.plan, (member, &choice), loads, &found))
    }

    /// Runs the members that are not finished yet on the threads of the current rayon pool, and writes the table (and,
    /// with `mat`, a MATLAB file for each member) once all are. Finished members stand beside the table until then:
    /// the same call goes on from there, unless `restart` forgets them. `finished` gets the number of finished ones at
    /// first, and is called as each more is done.
    ///
    /// # Errors
    /// A folder that another process writes, finished members of another plan, what cannot be written.
    pub fn make(
        &self,
        folder: &Path,
        (mat, restart): (bool, bool),
        stop: &AtomicBool,
        finished: impl Fn(usize) + Sync,
    ) -> Result<DatasetReport, StudyError> {
        std::fs::create_dir_all(folder).map_err(|source| StudyError::Write { path: folder.to_owned(), source })?;
        let table = folder.join(TABLE);
        let _lock = OutputLock::take(&table)?;
        let columns = row::columns(&self.plan);
        let plain: Vec<Column> = columns.iter().map(|(column, _)| column.clone()).collect();
        let one = |number: usize| (number < self.members()).then_some((number, number..number + 1));
        let mut journal = Journal::open(&table, &self.identity(), &one, &plain, restart)?;
        let open: Vec<usize> = (0..self.members()).filter(|number| !journal.has(*number)).collect();
        finished(self.members() - open.len());
        let (began, count) = (Instant::now(), Mutex::new(0));
        let kept = Mutex::new(&mut journal);
        let run = |number: &usize| {
            let stopped = stop.load(Ordering::Relaxed);
            let Some(cells) = (!stopped).then(|| self.row(*number, stop)).flatten() else { return Ok(()) };
            let line = encode(&cells) + "\n";
            kept.lock().unwrap_or_else(PoisonError::into_inner).append(*number, &line)?;
            *count.lock().unwrap_or_else(PoisonError::into_inner) += 1;
            finished(1);
            Ok::<_, StudyError>(())
        };
        open.par_iter().with_max_len(1).try_for_each(run)?;
        let (wall_s, run) = (began.elapsed().as_secs_f64(), count.into_inner().unwrap_or_else(PoisonError::into_inner));
        let finished = self.members() - open.len() + run;
        let mut report = self.report((wall_s, run, finished), &journal, &plain)?;
        if report.finished == self.members() {
            self.write(folder, &columns, &journal, mat)?;
            journal.delete()?;
            (report.table, report.mat) = (Some(table), mat.then(|| folder.join(MAT)));
        }
        Ok(report)
    }

    fn report(
        &self,
        (wall_s, run, finished): (f64, usize, usize),
        journal: &Journal,
        columns: &[Column],
    ) -> Result<DatasetReport, StudyError> {
        let place = |name: &str| columns.iter().position(|column| column.name == name).unwrap_or_default();
        let [warnings, error] = ["warnings", "error"].map(place);
        let (mut warned, mut first_warnings, mut failed, mut first_failure) = (0, None, 0, None);
        for line in journal.read() {
            let Some(row) = decode(line?.trim_end_matches('\n'), columns) else { continue };
            if let Cell::Text(why) = &row[error] {
                failed += 1;
                first_failure.get_or_insert_with(|| why.clone());
            }
            if let Cell::Text(said) = &row[warnings]
                && !said.is_empty()
            {
                warned += 1;
                first_warnings.get_or_insert_with(|| said.clone());
            }
        }
        let threads = rayon::current_num_threads();
        let bearings_test = self.individuals.iter().filter(|individual| individual.test).count();
        Ok(DatasetReport {
            members: self.members(),
            finished,
            failed,
            warned,
            bearings_train: self.individuals.len() - bearings_test,
            bearings_test,
            run,
            threads,
            wall_s,
            members_per_s_and_thread: (run > 0).then(|| run as f64 / wall_s / threads as f64),
            first_failure,
            first_warnings,
            table: None,
            mat: None,
        })
    }

    fn write(
        &self,
        folder: &Path,
        columns: &[(Column, Option<List>)],
        journal: &Journal,
        mat: bool,
    ) -> Result<(), StudyError> {
        let plain: Vec<Column> = columns.iter().map(|(column, _)| column.clone()).collect();
        let path = folder.join(TABLE);
        let unread = || StudyError::Write {
            path: journal.path().to_owned(),
            source: std::io::Error::new(std::io::ErrorKind::InvalidData, "a finished member cannot be read"),
        };
        let rows = || journal.read().map(|line| decode(line?.trim_end_matches('\n'), &plain).ok_or_else(unread));
        let mut staged = StagedFiles::new(folder, true)?;
        let file = staged.create(TABLE.to_owned())?;
        let failed = |source| StudyError::Write { path: path.clone(), source };
        let kept = file.try_clone().map_err(failed)?;
        let written =
            parquet::write(BufWriter::new(file), columns, self.notes(), rows().map(|row| row.map_err(Failed::Study)));
        written.map_err(|failure| match failure {
            Failed::Study(error) => error,
            Failed::Parquet(error) => failed(std::io::Error::other(error)),
        })?;
        kept.sync_all().map_err(failed)?;
        if mat {
            let mut files = StagedFiles::new(&folder.join(MAT), true)?;
            for (member, row) in rows().enumerate() {
                files.write(mat::name(member), &mat::file(columns, &row?))?;
            }
            files.publish()?;
        }
        staged.publish()?;
        mat::remove_from(&folder.join(MAT), if mat { self.members() } else { 0 })
    }

    fn identity(&self) -> Identity {
        let cases = self.cases.iter().map(|(_, text)| text.clone()).collect();
        Identity { tribodyn: env!("CARGO_PKG_VERSION").to_owned(), plan: self.text.clone(), cases }
    }

    /// Notes in the file: the plan and its cases.
    fn notes(&self) -> Vec<(String, String)> {
        let note = |name: &str, value: &str| (format!("tribodyn.{name}"), value.to_owned());
        let mut notes = vec![note("version", env!("CARGO_PKG_VERSION")), note("plan", &self.text)];
        notes.extend(
            self.plan.cases.iter().zip(&self.cases).map(|(name, (_, text))| note(&format!("case.{name}"), text)),
        );
        notes
    }
}

/// A constant force; none where it changes or the ring is held.
fn force(translation: &Translation) -> Option<f64> {
    if let Translation::Force(force) = translation { Some(*force) } else { None }
}

/// The error of a member's case at the field of the plan from which the refused value comes; none for a value of the
/// case itself.
fn in_plan(dataset: &Dataset, member: usize, error: &CaseError) -> Option<CaseError> {
    let plan = &dataset.plan;
    let choice = members::choice(plan, &dataset.individuals, member);
    let length = plan.lengths.iter().position(|length| Some(length.0) == choice.individual.length);
    let spall = error.path.strip_prefix("spalls[0].").or_else(|| error.path.strip_prefix("ball_spalls[0]."));
    let path = match (error.path.as_str(), spall) {
        (_, Some("length")) => format!("lengths[{}]", length?),
        (_, Some(field @ ("width" | "depth" | "edge_radius"))) => format!("spall.{field}"),
        (path, _) if path.starts_with("speed.inner") => "speeds[0]".to_owned(),
        (path, _) if path.starts_with("ring.x") => "loads[0].radial".to_owned(),
        (path, _) if path.starts_with("ring.z") && plan.loads[0].axial.is_some() => "loads[0].axial".to_owned(),
        (path, _) if plan.deviations.is_some() && path.starts_with("deviations.balls") => "deviations.balls".to_owned(),
        (path, _) if plan.deviations.is_some() && path.contains(".spectrum") => path.replace(".spectrum", ""),
        ("transient.duration", _) => "duration".to_owned(),
        ("recording" | "recording.state_rate", _) => "rate".to_owned(),
        _ => return None,
    };
    let message = format!("in {}: {}", plan.cases[choice.individual.case], error.message);
    Some(CaseError::at(&dataset.text, &path, message))
}

/// Why a table is not written.
enum Failed {
    Study(StudyError),
    Parquet(ParquetError),
}

impl From<ParquetError> for Failed {
    fn from(error: ParquetError) -> Self {
        Self::Parquet(error)
    }
}
