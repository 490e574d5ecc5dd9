//! Results of a run, gathered from its messages as they are recorded: nothing has to be read back for the summary.

use super::gathered::Gathered;
use super::warnings::{Tested, Warnings};
use tribodyn_case::Case;
use tribodyn_record::{BallRow, Channel, RecordError, RunItem, StateRow, WearRow};

/// Rows, worn volumes, warnings and pressures of a run.
#[derive(Debug, Clone)]
pub(crate) struct Tally {
    pub states: Gathered,
    pub wear: Option<WearRow>,
    pub warnings: Warnings,
    pub pressures: Vec<Tested>,
}

impl Tally {
    pub fn new(case: &Case) -> Self {
        Self { states: Gathered::default(), wear: None, warnings: Warnings::default(), pressures: Tested::of(case) }
    }

    /// Takes in rings, cage and powers at one time.
    pub fn add_state(&mut self, row: &StateRow) {
        self.states.add(*row);
    }

    /// Takes in all balls at one time.
    pub fn add_balls(&mut self, rows: &[BallRow]) {
        self.pressures.iter_mut().for_each(|race| race.add(rows));
    }

    /// Takes in an encoded message; those for the eye only say nothing.
    pub fn add(&mut self, channel: &Channel, data: &[u8]) -> Result<(), RecordError> {
        let decode = |source| RecordError::Decode { topic: channel.topic.to_owned(), source };
        if let Some(item) = RunItem::decode(channel.schema, data).map_err(decode)? {
            self.take(item);
        }
        Ok(())
    }

    /// Takes in a part of a run.
    pub fn take(&mut self, item: RunItem) {
        match item {
            RunItem::State(row) => self.add_state(&row),
            RunItem::Balls(_, balls) => self.add_balls(&balls),
            RunItem::Wear(row) => self.wear = Some(row),
            RunItem::Log(row) => self.warnings.add(&row),
            _ => {}
        }
    }
}
