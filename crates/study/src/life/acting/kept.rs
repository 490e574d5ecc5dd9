//! The table of a life in which wear acts, with the strides that are finished beside it until it is whole: each with
//! all that the next one goes on from, both grooves cell by cell.

use super::state::Acting;
use super::{ActingLife, ActingOptions, ActingStride, FirstThrough, Living, Mission, acting_life_after};
use crate::difference::SweepDifference;
use crate::error::StudyError;
use crate::journal;
use crate::life::Start;
use crate::life::strides::Strides;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::path::Path;
use tribodyn::CaseFile;
use tribodyn::answers::Equations;
use tribodyn_bearing::Side;
use tribodyn_wear::{GrooveField, TransferFilm};

/// A finished stride with all that the next one goes on from.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Kept {
    row: ActingStride,
    warnings: Vec<String>,
    first_through: Option<FirstThrough>,
    /// At the end of the stride, as all that follows.
    fields: [GrooveField; 2],
    film: TransferFilm,
    acting: Acting,
    starts: Vec<Option<Start>>,
    time: f64,
    revolutions: f64,
    phase: usize,
    /// Of the phase; absent where it lasts for ever, which JSON cannot say.
    left: Option<f64>,
}

/// A time that ends.
fn ending(time: f64) -> Option<f64> {
    Some(time).filter(|time| time.is_finite())
}

/// Keeps a finished stride, by its number.
pub(super) type Keep<'a> = &'a mut dyn FnMut(usize, &Kept) -> Result<(), StudyError>;

impl Living<'_> {
    /// All that the stride that has just ended leaves behind.
    pub(super) fn kept(&self) -> Kept {
        Kept {
            row: self.life.strides.last().cloned().unwrap_or_default(),
            warnings: self.life.warnings.clone(),
            first_through: self.life.first_through.clone(),
            fields: Side::BOTH.map(|side| self.grooves.fields[side].clone()),
            film: self.film,
            acting: self.acting,
            starts: self.starts.clone(),
            time: self.time,
            revolutions: self.revolutions,
            phase: self.phase,
            left: ending(self.left),
        }
    }

    /// Takes up the life behind a finished stride.
    pub(super) fn go_on_from(&mut self, kept: Kept) {
        let [inner, outer] = kept.fields;
        (self.grooves.fields.inner, self.grooves.fields.outer) = (inner, outer);
        (self.film, self.acting, self.starts) = (kept.film, kept.acting, kept.starts);
        (self.time, self.revolutions) = (kept.time, kept.revolutions);
        (self.phase, self.left) = (kept.phase, kept.left.unwrap_or(f64::INFINITY));
        (self.life.warnings, self.life.first_through) = (kept.warnings, kept.first_through);
        self.life.strides.push(kept.row);
    }
}

/// A warning of what the cage gives in an equilibrium.
pub(super) fn doubtful(options: &ActingOptions) -> Vec<String> {
    let warning = "the balls scrape the film off the cage by the pocket forces of an equilibrium, up to a hundred times \
                   those of a run: take --model steady-orbit";
    let doubtful = options.effects.transfer && options.equations == Equations::Traction;
    doubtful.then(|| warning.to_owned()).into_iter().collect()
}

/// Inputs by which two lives are the same.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Identity {
    tribodyn: String,
    case: String,
    model: String,
    effects: Vec<String>,
    strides: u32,
    until_s: Option<f64>,
    bare_limit: f64,
    /// Duration, s, and case of each phase of the mission.
    phases: Vec<(Option<f64>, String)>,
}

impl journal::Identity for Identity {
    fn difference(&self, found: &Self) -> Option<SweepDifference> {
        let ends = |i: &Self| (i.strides, i.until_s, i.bare_limit);
        match found {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.case != self.case => Some(SweepDifference::Case),
            o if o.model != self.model => Some(SweepDifference::Model { found: o.model.clone() }),
            o if o.effects != self.effects || o.phases != self.phases => Some(SweepDifference::Effects),
            o if ends(o) != ends(self) => Some(SweepDifference::Strides),
            _ => None,
        }
    }
}

/// A life in which wear acts, with its finished strides on disk, beside the table that they will make.
pub struct ActingTable<'a> {
    file: &'a CaseFile,
    mission: &'a Mission,
    options: &'a ActingOptions,
    strides: Strides<Kept>,
}

impl<'a> ActingTable<'a> {
    /// Opens the finished strides of a table, `.parquet` or `.csv` by its name, or begins with none; `restart` forgets
    /// those of a life that was stopped.
    ///
    /// # Errors
    /// A name with another ending, a table that another process writes, or finished strides of another life.
    pub fn open(
        file: &'a CaseFile,
        mission: &'a Mission,
        options: &'a ActingOptions,
        (path, restart): (&Path, bool),
    ) -> Result<Self, StudyError> {
        let identity = Identity {
            tribodyn: env!("CARGO_PKG_VERSION").to_owned(),
            case: file.text.clone(),
            model: options.equations.name().to_owned(),
            effects: options.effects.names().into_iter().map(str::to_owned).collect(),
            strides: options.strides,
            until_s: options.until_s,
            bare_limit: options.bare_limit,
            phases: mission.phases.iter().map(|phase| (ending(phase.duration_s), phase.file.text.clone())).collect(),
        };
        Ok(Self { file, mission, options, strides: Strides::open(path, &identity, restart)? })
    }

    /// Number of strides that an earlier run had finished.
    pub fn finished_strides(&self) -> usize {
        self.strides.finished()
    }

    /// [`acting_life`](super::acting_life) from the last finished stride on; each is safe on disk as soon as it is.
    ///
    /// # Errors
    /// Those of a life, and a stride that cannot be written.
    pub fn wear(&mut self, progress: impl FnMut(&ActingStride) -> ControlFlow<()>) -> Result<ActingLife, StudyError> {
        let (finished, mut keep) = self.strides.go_on();
        acting_life_after(self.file, self.mission, self.options, (finished, &mut keep), progress)
    }

    /// Writes the table, under its name only when it is whole; the finished strides beside it are removed.
    ///
    /// # Errors
    /// The table cannot be written.
    pub fn write(self, life: &ActingLife) -> Result<(), StudyError> {
        life.write_strides(self.strides.path())?;
        self.strides.delete()
    }
}
