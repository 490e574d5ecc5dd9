//! The table of an ensemble: a row a member.

use super::member::Member;
use super::{Ensemble, Outcome, Sampling};
use crate::difference::SweepDifference;
use crate::error::StudyError;
use crate::journal::{self, Journal};
use crate::lock::OutputLock;
use crate::sweep::{Cell, Column, Format, Kind, Rows, decode, encode, write_rows};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::sync::{Mutex, PoisonError};

/// The column that says whether a member came to its end.
pub const COMPLETE: &str = "complete";

/// Identity of an ensemble: two with the same one are the same.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    tribodyn: String,
    /// The case's text with the changes that all members share.
    case: String,
    vary: Vec<String>,
    members: usize,
    seed: u64,
    sampling: Sampling,
}

impl journal::Identity for Identity {
    fn difference(&self, found: &Self) -> Option<SweepDifference> {
        let draws = |i: &Self| (i.vary.clone(), i.members, i.seed, i.sampling);
        match found {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.case != self.case => Some(SweepDifference::Case),
            o if draws(o) != draws(self) => Some(SweepDifference::Draws),
            _ => None,
        }
    }
}

/// A table that is not written yet; the rows of finished members are beside it until it is.
pub struct EnsembleTable<'a> {
    ensemble: &'a Ensemble,
    path: PathBuf,
    format: Format,
    journal: Journal,
    /// Members that an earlier run had finished.
    resumed: Vec<Member>,
    /// Let go of after everything else.
    _lock: OutputLock,
}

impl EnsembleTable<'_> {
    /// Number of members that an earlier run had finished.
    pub fn resumed(&self) -> usize {
        self.resumed.len()
    }

    /// [`Ensemble::run`] of the members that are not finished yet; each is safe on disk as soon as it is.
    ///
    /// # Errors
    /// A finished member cannot be written.
    pub fn run(&mut self, stop: &AtomicBool, finished: impl Fn(&Member) + Sync) -> Result<Outcome, StudyError> {
        let ensemble = self.ensemble;
        let open: Vec<usize> = (0..ensemble.members()).filter(|number| !self.journal.has(*number)).collect();
        let journal = Mutex::new(&mut self.journal);
        let keep = |member: &Member| {
            let mut cells = ensemble.row(member);
            cells.extend([Cell::Number(member.simulated_s), Cell::Number(member.wall_s)]);
            cells.push(member.processor_s.map_or(Cell::Null, Cell::Number));
            let line = encode(&cells) + "\n";
            journal.lock().unwrap_or_else(PoisonError::into_inner).append(member.number, &line)?;
            finished(member);
            Ok::<_, StudyError>(())
        };
        let mut outcome = ensemble.run_some(open, stop, keep)?;
        outcome.members.extend(self.resumed.iter().cloned());
        outcome.members.sort_by_key(|member| member.number);
        Ok(outcome)
    }

    /// Writes a row for each of the members. The table gets its name when it is whole; the finished rows beside it are
    /// removed once it has all members.
    ///
    /// # Errors
    /// The table cannot be written.
    pub fn write(self, members: &[Member]) -> Result<(), StudyError> {
        let columns = self.ensemble.columns();
        let rows: Vec<Vec<Cell>> = members.iter().map(|member| self.ensemble.row(member)).collect();
        write_rows(&Rows::in_memory(&self.path, &columns, &rows), self.format, self.ensemble.notes())?;
        if members.len() == self.ensemble.members() { self.journal.delete() } else { Ok(()) }
    }
}

impl Ensemble {
    /// Columns of the table: the member's number, the varied values, whether it is complete, its figures, why not.
    pub fn columns(&self) -> Vec<Column> {
        let varied = self.axes.iter().map(|axis| axis.column.clone());
        let before = [Column::new("member", Kind::Integer, false)].into_iter().chain(varied);
        let figures = self.figures.iter().cloned();
        let error = [Column::new("error", Kind::Text, true)];
        before.chain([Column::new(COMPLETE, Kind::Truth, false)]).chain(figures).chain(error).collect()
    }

    /// Columns of a finished member on disk: those of the table, then what the member took.
    fn kept_columns(&self) -> Vec<Column> {
        let cost = ["simulated_s", "wall_s", "processor_s"].map(|name| Column::new(name, Kind::Number, true));
        self.columns().into_iter().chain(cost).collect()
    }

    /// The fields of a member's row, in the order of [`Self::columns`].
    pub fn row(&self, member: &Member) -> Vec<Cell> {
        let varied = self.axes.iter().map(|axis| axis.cells[member.number].clone());
        let mut cells: Vec<Cell> = [Cell::Integer(member.number as i64)].into_iter().chain(varied).collect();
        match &member.figures {
            Ok(figures) => {
                cells.push(Cell::Truth(true));
                cells.extend(figures.iter().cloned());
                cells.push(Cell::Null);
            }
            Err(why) => {
                cells.push(Cell::Truth(false));
                cells.extend(self.figures.iter().map(|_| Cell::Null));
                cells.push(Cell::Text(why.clone()));
            }
        }
        cells
    }

    /// The member of a finished row on disk; none where the row is not one.
    fn member(&self, line: &str) -> Option<Member> {
        let cells = decode(line.trim_end_matches('\n'), &self.kept_columns())?;
        let [Cell::Integer(number), ..] = cells[..] else { return None };
        let complete = 1 + self.axes.len();
        let error = complete + 1 + self.figures.len();
        let seconds = |at: usize| if let Cell::Number(seconds) = cells[at] { Some(seconds) } else { None };
        Some(Member {
            number: usize::try_from(number).ok()?,
            figures: match (&cells[complete], &cells[error]) {
                (Cell::Truth(true), _) => Ok(cells[complete + 1..error].to_vec()),
                (_, Cell::Text(why)) => Err(why.clone()),
                _ => return None,
            },
            simulated_s: seconds(error + 1)?,
            wall_s: seconds(error + 2)?,
            processor_s: seconds(error + 3),
            resumed: true,
        })
    }

    /// The table to write, `.parquet` or `.csv` by its name; nobody else writes it meanwhile. Members that a stopped
    /// run of this ensemble had finished are taken from beside it, unless `restart` forgets them.
    ///
    /// # Errors
    /// A name with another ending, a table that another process writes, or finished members of another ensemble.
    pub fn table(&self, path: &Path, restart: bool) -> Result<EnsembleTable<'_>, StudyError> {
        let format = Format::of(path)?;
        let lock = OutputLock::take(path)?;
        let one = |number: usize| (number < self.options.members).then_some((number, number..number + 1));
        let journal = Journal::open(path, &self.identity(), &one, &self.kept_columns(), restart)?;
        let unread = || StudyError::Write {
            path: journal.path().to_owned(),
            source: std::io::Error::new(std::io::ErrorKind::InvalidData, "a finished member cannot be read"),
        };
        let resumed = journal.read().map(|line| self.member(&line?).ok_or_else(unread)).collect::<Result<_, _>>()?;
        Ok(EnsembleTable { ensemble: self, path: path.to_owned(), format, journal, resumed, _lock: lock })
    }

    fn identity(&self) -> Identity {
        Identity {
            tribodyn: env!("CARGO_PKG_VERSION").to_owned(),
            case: self.base.text.clone(),
            vary: self.spreads.iter().map(|spread| format!("{}={}", spread.path, spread.text)).collect(),
            members: self.options.members,
            seed: self.options.seed,
            sampling: self.options.sampling,
        }
    }

    /// The notes on its ensemble in the file of a table, where that has a place for them.
    fn notes(&self) -> Vec<(String, String)> {
        let Identity { tribodyn, case, vary, members, seed, .. } = self.identity();
        [
            ("version", tribodyn),
            ("case", case),
            ("vary", vary.join("\n")),
            ("members", members.to_string()),
            ("seed", seed.to_string()),
        ]
        .map(|(name, value)| (format!("tribodyn.{name}"), value))
        .into()
    }
}
