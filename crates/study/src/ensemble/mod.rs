//! Ensembles: transient runs of one case with values drawn at random, without recordings, in parallel.
//!
//! A member depends on the seed and its number alone, in a Latin hypercube on the number of members too, and not on
//! threads or on members that fail. Its numbers are those of a recorded run of the same values, to the last bit.

mod draw;
mod figures;
mod member;
mod normal;
mod numbers;
mod quantiles;
mod report;
mod spread;
mod table;

pub use draw::Sampling;
pub use member::Member;
#[cfg(feature = "parquet")]
pub(crate) use normal::normal_quantile;
pub(crate) use numbers::numbers_of;
pub use quantiles::Quantiles;
pub use report::{Cost, EnsembleReport, FailedMember, Varied};
pub use spread::Spread;
pub use table::{COMPLETE, EnsembleTable};

use crate::error::StudyError;
use crate::sweep::{Axis, Cell, Column};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tribodyn::Limits;
use tribodyn::{CaseFile, Change};

/// Most members: their rows are held in memory, a kilobyte each.
const MAX_MEMBERS: usize = 100_000;

/// Choices of an ensemble besides its spreads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EnsembleOptions {
    /// Number of members.
    pub members: usize,
    /// Seed of the draws.
    pub seed: u64,
    /// How the members lie in the space of the spreads.
    pub sampling: Sampling,
}

/// A case and the values that its members have.
///
/// ```no_run
/// use std::sync::atomic::AtomicBool;
/// use tribodyn_study::ensemble::{Ensemble, EnsembleOptions, Sampling, Spread};
/// use tribodyn::Limits;
/// use tribodyn_study::read_text;
///
/// let text = read_text("case.ron".as_ref(), &Limits::NORMAL)?;
/// let gap = Spread::parse("cage.pocket_gap=mm(0.2 ± 0.02)")?;
/// let options = EnsembleOptions { members: 16, seed: 1, sampling: Sampling::Independent };
/// let ensemble = Ensemble::new(("case.ron", text), &[], &[gap], options, &Limits::NORMAL)?;
/// let mut table = ensemble.table("table.csv".as_ref(), false)?;
/// let outcome = table.run(&AtomicBool::new(false), |_finished| ())?;
/// table.write(&outcome.members)?;
/// for figure in ensemble.report(&outcome).quantiles {
///     assert!(figure.p05 <= figure.p95);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Ensemble {
    /// The case with its fixed changes.
    base: CaseFile,
    limits: Limits,
    options: EnsembleOptions,
    spreads: Vec<Spread>,
    /// The values of all members, by spread.
    axes: Vec<Axis>,
    /// Columns of the figures.
    figures: Vec<Column>,
}

/// Members that are finished, in the order of their numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The members.
    pub members: Vec<Member>,
    /// Threads that shared them.
    pub threads: usize,
    /// Wall time of those that no earlier run had finished, s.
    pub wall_s: f64,
}

impl Ensemble {
    /// Draws the values of all members. `name` and `text` are those of the case file, `fixed` changes what all members
    /// share.
    ///
    /// # Errors
    /// A case that cannot be run, as it is or with all spreads at their middle; two changes of one value; no member or
    /// too many; values with which no member is a case.
    pub fn new(
        (name, text): (&str, String),
        fixed: &[Change],
        spreads: &[Spread],
        options: EnsembleOptions,
        limits: &Limits,
    ) -> Result<Self, StudyError> {
        let mut options = options;
        let counts: Option<Vec<usize>> = spreads.iter().map(Spread::count).collect();
        let grid = counts.filter(|_| options.sampling == Sampling::Grid);
        if let Some(counts) = &grid {
            options.members =
                counts.iter().try_fold(1, |all: usize, count| all.checked_mul(*count)).unwrap_or(usize::MAX);
        }
        if !(1..=MAX_MEMBERS).contains(&options.members) {
            return Err(StudyError::argument("members", options.members, format!("allowed are 1 to {MAX_MEMBERS}")));
        }
        let base = CaseFile::from_text(name, text, fixed, limits)?;
        base.run_inputs()?;
        check_paths(fixed, spreads)?;
        let drawn = || draw::shares(options.sampling, options.seed, options.members, spreads.len());
        let shares = grid.map_or_else(drawn, |counts| draw::grid(&counts));
        let axes = spreads.iter().zip(&shares).map(|(spread, shares)| Axis::new(&spread.setting(shares))).collect();
        let (spreads, limits, figures) = (spreads.to_vec(), *limits, figures::columns()?);
        let ensemble = Self { base, limits, options, spreads, axes, figures };
        ensemble.check()?;
        Ok(ensemble)
    }

    /// A wrong unit is wrong in the middle too; values at random may make an impossible case now and then.
    fn check(&self) -> Result<(), StudyError> {
        self.case(&self.spreads.iter().map(Spread::middle).collect::<Vec<_>>())?;
        match self.member_case(0) {
            Err(first) if (1..self.options.members).all(|number| self.member_case(number).is_err()) => Err(first),
            _ => Ok(()),
        }
    }

    /// The case with some changes, if it can be run.
    fn case(&self, changes: &[Change]) -> Result<CaseFile, StudyError> {
        let file = CaseFile::from_text(&self.base.name, self.base.text.clone(), changes, &self.limits)?;
        file.run_inputs()?;
        Ok(file)
    }

    fn member_case(&self, number: usize) -> Result<CaseFile, StudyError> {
        self.case(&self.axes.iter().map(|axis| axis.setting.change(number)).collect::<Vec<_>>())
    }

    /// Place of a member in a grid: the number of its first value, by its place in the list where it is none, and its
    /// other values in words. None where values are drawn.
    pub fn place(&self, number: usize) -> Option<(f64, String)> {
        if self.options.sampling != Sampling::Grid {
            return None;
        }
        let (first, others) = self.axes.split_first()?;
        let x = match first.cells.get(number)? {
            Cell::Number(value) => *value,
            _ => number as f64,
        };
        let name = |axis: &Axis| format!("{}={}", axis.setting.path, axis.setting.values[number]);
        Some((x, others.iter().map(name).collect::<Vec<_>>().join(", ")))
    }

    /// Name and unit of the first value of a grid.
    pub fn grid_axis(&self) -> Option<&str> {
        (self.options.sampling == Sampling::Grid).then(|| self.axes.first().map(|axis| axis.column.name.as_str()))?
    }

    /// Values of a figure of all members that have it, each with the number of its member.
    pub fn numbered(&self, quantity: &str, members: &[Member]) -> Vec<(usize, f64)> {
        let one =
            |member: &Member| self.values(quantity, std::slice::from_ref(member)).pop().map(|v| (member.number, v));
        members.iter().filter_map(one).collect()
    }

    /// Number of members.
    pub fn members(&self) -> usize {
        self.options.members
    }

    /// Runs all members on the threads of the current rayon pool, the next one on the next free thread. `finished` gets
    /// each as it is done. Once `stop` is set, members that are not done are left out.
    pub fn run(&self, stop: &AtomicBool, finished: impl Fn(&Member) + Sync) -> Outcome {
        let keep = |member: &Member| -> Result<(), std::convert::Infallible> {
            finished(member);
            Ok(())
        };
        let Ok(outcome) = self.run_some((0..self.options.members).collect(), stop, keep);
        outcome
    }

    /// Runs some members; what `keep` fails at ends it.
    fn run_some<E: Send>(
        &self,
        numbers: Vec<usize>,
        stop: &AtomicBool,
        keep: impl Fn(&Member) -> Result<(), E> + Sync,
    ) -> Result<Outcome, E> {
        let began = Instant::now();
        let run = |number: usize| {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let member = member::run_member(number, || self.member_case(number), stop)?;
            Some(keep(&member).map(|()| member))
        };
        let members = numbers.into_par_iter().with_max_len(1).filter_map(run).collect::<Result<_, E>>()?;
        Ok(Outcome { members, threads: rayon::current_num_threads(), wall_s: began.elapsed().as_secs_f64() })
    }
}

/// Refuses two changes of one value.
fn check_paths(fixed: &[Change], spreads: &[Spread]) -> Result<(), StudyError> {
    for (k, spread) in spreads.iter().enumerate() {
        let change = fixed.iter().find(|change| change.concerns(&spread.path)).map(Change::to_string);
        let other = || spreads[..k].iter().find(|other| other.meets(&spread.path)).map(Spread::to_string);
        if let Some(other) = change.or_else(other) {
            let given = format!("{}={}", spread.path, spread.text);
            return Err(StudyError::argument("vary", given, format!("{other} is about the same value")));
        }
    }
    Ok(())
}
