//! A file of signals: columns of numbers sampled together.

use crate::error::StudyError;
use std::path::Path;

/// One signal of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name; its number, from 1, where the file has none.
    pub name: String,
    /// Samples, in the unit of the file.
    pub values: Vec<f64>,
}

/// The signals of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalFile {
    /// Signals in the order of the file.
    pub columns: Vec<Column>,
    /// Sampling rate, Hz, where the file says it.
    pub rate_hz: Option<f64>,
    /// Line of the first sample in a file of text.
    pub first_line: Option<usize>,
    /// The text of the case, where the file is the recording of a run.
    pub case_text: Option<String>,
    /// Warnings of that run.
    pub warnings: Vec<String>,
}

impl SignalFile {
    /// Signals without anything beside them.
    pub(super) fn of(columns: Vec<Column>, rate_hz: Option<f64>) -> Self {
        Self { columns, rate_hz, first_line: None, case_text: None, warnings: Vec::new() }
    }

    /// The column of a name, or of a number from 1.
    pub fn column(&self, name: &str) -> Option<&Column> {
        let by_name = self.columns.iter().find(|column| column.name == name);
        by_name.or_else(|| self.columns.get(name.parse::<usize>().ok()?.checked_sub(1)?))
    }

    /// Names of all columns with the number of their samples.
    pub(super) fn names(&self) -> String {
        let shown = |column: &Column| format!("{} ({})", column.name, column.values.len());
        self.columns.iter().take(40).map(shown).collect::<Vec<_>>().join(", ")
    }
}

/// A file that is refused for what is in it.
pub(super) fn damaged(path: &Path, why: impl std::fmt::Display) -> StudyError {
    StudyError::Signals(path.to_owned(), format!(" {why}"))
}
