//! Which sweep finished rows and tables belong to.

use super::grid::Grid;
use super::shard::Shard;
use crate::difference::SweepDifference;
use crate::error::StudyError;
use crate::journal;
use serde::{Deserialize, Serialize};

/// Identity of a sweep: two with the same one are the same.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Identity {
    /// Version of the command; another may give other numbers.
    pub tribodyn: String,
    /// The case's text with the changes of a single value.
    pub case: String,
    /// Name of the model.
    pub model: String,
    /// Swept paths and their values.
    pub swept: Vec<(String, Vec<String>)>,
    pub shard: Shard,
    pub cold: bool,
}

impl Identity {
    pub fn new(grid: &Grid, shard: Shard, cold: bool) -> Self {
        let swept = grid.values().into_iter().map(|(path, values)| (path.to_owned(), values.to_vec())).collect();
        let (tribodyn, model) = (env!("CARGO_PKG_VERSION").to_owned(), grid.model.name().to_owned());
        Self { tribodyn, case: grid.base().to_owned(), model, swept, shard, cold }
    }

    /// Notes on the sweep in the file of its table.
    pub fn notes(&self) -> Result<Vec<(String, String)>, StudyError> {
        let note = |name: &str, value| (name.to_owned(), value);
        Ok(vec![
            note(NOTES[0], self.tribodyn.clone()),
            note(NOTES[1], self.case.clone()),
            note(NOTES[2], self.model.clone()),
            note(NOTES[3], serde_json::to_string(&self.swept)?),
            note(SHARD_NOTE, self.shard.to_string()),
        ])
    }
}

impl journal::Identity for Identity {
    fn difference(&self, other: &Self) -> Option<SweepDifference> {
        match other {
            o if o.tribodyn != self.tribodyn => Some(SweepDifference::Version { found: o.tribodyn.clone() }),
            o if o.case != self.case => Some(SweepDifference::Case),
            o if o.model != self.model => Some(SweepDifference::Model { found: o.model.clone() }),
            o if o.swept != self.swept => Some(SweepDifference::Values),
            o if o.shard != self.shard => Some(SweepDifference::Shard { found: o.shard.to_string() }),
            o if o.cold != self.cold => Some(SweepDifference::Cold),
            _ => None,
        }
    }
}

/// Keys in the file of a table that are the same for all parts of a sweep: version, case, model, swept values.
pub const NOTES: [&str; 4] = ["tribodyn.version", "tribodyn.case", "tribodyn.model", "tribodyn.swept"];
/// Key of the part.
pub const SHARD_NOTE: &str = "tribodyn.shard";
