//! The grid: every combination of the swept values, in the order of the options, the last varying fastest.

use super::columns::{Cell, Column, Kind};
use super::values;
use crate::case_file::{CaseFile, Change};
use crate::error::StudyError;
use crate::limits::Limits;
use rayon::prelude::*;
use serde::Serialize;
use std::ops::Range;
use tribodyn_case::{Case, CaseError, Purpose, set_value};

/// Most rows of a grid, far beyond any computing time.
const MAX_ROWS: usize = 1_000_000_000;
/// Rows that are solved one after the other, each starting from a neighbour among them. A constant of the format: it
/// decides which rows start cold, and must depend neither on threads nor on shards.
const CHUNK: Range<usize> = 8..65;

/// Values for one place of the case: `PATH=VALUES`.
#[derive(Debug, Clone)]
pub struct Setting {
    /// Stands before the setting in messages.
    prefix: &'static str,
    path: String,
    values: Vec<String>,
}

impl Setting {
    /// Reads `PATH=VALUES`, such as `ring.z.Force=kN(10..60 by 5)`.
    ///
    /// # Errors
    /// A text that says what is wrong and what is allowed.
    pub fn parse(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((path, list)) if !path.trim().is_empty() && !list.trim().is_empty() => {
                Ok(Self { prefix: "", path: path.trim().to_owned(), values: values::expand(list)? })
            }
            _ => {
                Err("allowed is PATH=VALUES, such as ring.z.Force=kN(10),kN(20) or ring.z.Force=kN(10..60 by 5)"
                    .to_owned())
            }
        }
    }

    /// Number of values.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// With a text that stands before the setting in messages, such as the name of an option.
    pub fn prefixed(self, prefix: &'static str) -> Self {
        Self { prefix, ..self }
    }

    fn change(&self, index: usize) -> Change {
        Change::new(format!("{}{}={}", self.prefix, self.path, self.values[index]), &self.path, &self.values[index])
    }
}

/// A path with the values that it takes.
#[derive(Debug)]
struct Axis {
    setting: Setting,
    column: Column,
    cells: Vec<Cell>,
}

/// The case and what is swept in it.
pub struct Grid {
    /// Name of the case file, for messages.
    name: String,
    /// The case file as it is.
    original: String,
    /// Changes of a single value.
    fixed: Vec<Change>,
    /// The case's text with them.
    base: String,
    limits: Limits,
    axes: Vec<Axis>,
    /// Number of rows.
    pub rows: usize,
}

impl Grid {
    /// Checks every value before anything is solved.
    ///
    /// # Errors
    /// Settings that overlap or make too many rows, and the first value that is refused.
    pub fn new(name: &str, original: String, settings: &[Setting], limits: &Limits) -> Result<Self, StudyError> {
        let (single, swept): (Vec<_>, Vec<_>) = settings.iter().partition(|s| s.values.len() == 1);
        for (i, first) in swept.iter().enumerate() {
            let second = swept[i + 1..].iter().find(|second| first.change(0).concerns(&second.path));
            if let Some(second) = second {
                let [first, second] = [first.path.clone(), second.path.clone()];
                return Err(StudyError::Overlap { first, second });
            }
        }
        let count = |rows: usize, s: &&Setting| rows.checked_mul(s.values.len()).filter(|n| *n <= MAX_ROWS);
        let rows = swept.iter().try_fold(1, count).ok_or(StudyError::TooManyRows { limit: MAX_ROWS })?;
        let fixed: Vec<Change> = single.iter().map(|s| s.change(0)).collect();
        let axes = swept.into_iter().map(Axis::new).collect();
        let mut grid =
            Self { name: name.to_owned(), original, fixed, base: String::new(), limits: *limits, axes, rows };
        // The first row stands for the case without axes too: messages come from there.
        grid.base = grid.original.clone();
        for change in &grid.fixed {
            grid.base = match change.apply(&grid.base) {
                Ok(text) => text,
                Err(_) => return Err(grid.refusal(0)),
            };
        }
        grid.check()?;
        Ok(grid)
    }

    /// Each value with the first values of the other axes, or, where the case is refused with these, with their last.
    fn check(&self) -> Result<(), StudyError> {
        let strides = self.strides();
        let last = self.rows - 1;
        for (axis, stride) in self.axes.iter().zip(&strides) {
            let far = last - (axis.cells.len() - 1) * stride;
            let bad = |i: &usize| {
                self.text(i * stride).is_none_or(|t| !self.sound(&t))
                    && self.text(far + i * stride).is_none_or(|t| !self.sound(&t))
            };
            if let Some(i) = (0..axis.cells.len()).into_par_iter().find_first(bad) {
                return Err(self.refusal(i * stride));
            }
        }
        if self.axes.is_empty() && !self.sound(&self.base) {
            return Err(self.refusal(0));
        }
        Ok(())
    }

    /// What is wrong with a row, in words that blame the option.
    fn refusal(&self, row: usize) -> StudyError {
        let swept = self.axes.iter().zip(self.indices(row)).map(|(axis, i)| axis.setting.change(i));
        let changes: Vec<Change> = self.fixed.iter().cloned().chain(swept).collect();
        match CaseFile::from_text(&self.name, self.original.clone(), &changes, &self.limits)
            .and_then(|file| file.bearing_for(Purpose::Traction))
        {
            Err(failure) => failure,
            // Texts are refused by the same reader: there is nothing that only one of both refuses.
            Ok(_) => StudyError::RefusalLost { row },
        }
    }

    /// True for a case with all that the traction model needs, within the limits.
    fn sound(&self, text: &str) -> bool {
        self.case(text).is_ok_and(|case| case.require(Purpose::Traction).is_ok() && case.bearing().is_ok())
    }

    /// The case of a row's text, within the limits.
    pub(crate) fn case(&self, text: &str) -> Result<Case, CaseError> {
        let case = Case::from_ron(text)?;
        self.limits.check(text, &case).map(|()| case)
    }

    /// Distance in rows of neighbours along each axis.
    fn strides(&self) -> Vec<usize> {
        let mut strides = vec![1; self.axes.len()];
        for k in (1..self.axes.len()).rev() {
            strides[k - 1] = strides[k] * self.axes[k].cells.len();
        }
        strides
    }

    /// Which value of each axis a row has.
    pub(crate) fn indices(&self, row: usize) -> Vec<usize> {
        let place = |(axis, stride): (&Axis, usize)| row / stride % axis.cells.len();
        self.axes.iter().zip(self.strides()).map(place).collect()
    }

    /// The text of a row's case; `None` where a path is not in it.
    pub(crate) fn text(&self, row: usize) -> Option<String> {
        let mut text = self.base.clone();
        for (axis, i) in self.axes.iter().zip(self.indices(row)) {
            text = set_value(&text, &axis.setting.path, &axis.setting.values[i]).ok()?;
        }
        Some(text)
    }

    /// The swept values of a row, as they stand in the table.
    pub(crate) fn cells(&self, row: usize) -> impl Iterator<Item = Cell> {
        self.axes.iter().zip(self.indices(row)).map(|(axis, i)| axis.cells[i].clone())
    }

    /// The columns of the swept values.
    pub fn columns(&self) -> impl Iterator<Item = Column> {
        self.axes.iter().map(|axis| axis.column.clone())
    }

    /// The values of each axis, as they stand in the table.
    pub fn axis_cells(&self) -> impl Iterator<Item = Vec<Cell>> {
        self.axes.iter().map(|axis| axis.cells.clone())
    }

    /// Rows in a chunk; the last one may have fewer. Small grids have small chunks, so that they too can be shared out.
    pub fn chunk_rows(&self) -> usize {
        (self.rows / 64).clamp(CHUNK.start, CHUNK.end - 1)
    }

    /// Number of chunks.
    pub fn chunks(&self) -> usize {
        self.rows.div_ceil(self.chunk_rows())
    }

    /// The rows of a chunk.
    pub fn chunk(&self, index: usize) -> Range<usize> {
        let length = self.chunk_rows();
        index * length..self.rows.min((index + 1) * length)
    }

    /// What is swept, for people and programs.
    pub fn summary(&self) -> Vec<AxisSummary> {
        let summary = |axis: &Axis| AxisSummary {
            column: axis.column.name.clone(),
            path: axis.setting.path.clone(),
            values: axis.cells.len(),
            first: axis.setting.values[0].clone(),
            last: axis.setting.values[axis.cells.len() - 1].clone(),
        };
        self.axes.iter().map(summary).collect()
    }

    /// The case's text with the changes of a single value.
    pub(crate) fn base(&self) -> &str {
        &self.base
    }

    /// All values of all axes, by path.
    pub(crate) fn values(&self) -> Vec<(&str, &[String])> {
        self.axes.iter().map(|axis| (axis.setting.path.as_str(), axis.setting.values.as_slice())).collect()
    }
}

/// One axis in a few words.
#[derive(Debug, Clone, Serialize)]
pub struct AxisSummary {
    /// Name of its column, with the unit.
    pub column: String,
    /// Place in the case.
    pub path: String,
    /// Number of values.
    pub values: usize,
    /// First value, as in a case file.
    pub first: String,
    /// Last value, as in a case file.
    pub last: String,
}

impl Axis {
    /// Numbers of one unit, plain numbers and truth values keep their kind; anything else is text.
    fn new(setting: &Setting) -> Self {
        let values = &setting.values;
        let texts = || values.iter().map(|v| Cell::Text(v.clone())).collect();
        let quantities: Option<Vec<_>> = values.iter().map(|v| quantity(v)).collect();
        let truths: Option<Vec<bool>> = values.iter().map(|v| v.parse().ok()).collect();
        let (name, kind, cells) = match (quantities, truths) {
            (Some(q), _) if q.iter().all(|(names, _)| *names == q[0].0) => {
                let name = match q[0].0.split_last() {
                    None => setting.path.clone(),
                    // The names around a unit are steps of the path to it.
                    Some((unit, steps)) => format!("{} [{unit}]", [&[setting.path.as_str()], steps].concat().join(".")),
                };
                (name, Kind::Number, q.iter().map(|(_, v)| Cell::Number(*v)).collect())
            }
            (_, Some(truths)) => (setting.path.clone(), Kind::Truth, truths.into_iter().map(Cell::Truth).collect()),
            _ => (setting.path.clone(), Kind::Text, texts()),
        };
        Self { setting: setting.clone(), column: Column { name, kind, optional: false }, cells }
    }
}

/// `Force(kN(10))` as the names before the number, and the number.
fn quantity(value: &str) -> Option<(Vec<&str>, f64)> {
    let (mut names, mut rest) = (Vec::new(), value.trim());
    while let Some((name, inside)) = rest.split_once('(') {
        names.push(name.trim());
        rest = inside.strip_suffix(')')?.trim();
    }
    let plain = names.iter().all(|n| !n.is_empty() && n.chars().all(|c| c.is_alphanumeric() || c == '_'));
    let number = rest.parse::<f64>().ok().filter(|v| v.is_finite() && plain)?;
    Some((names, number))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> (String, Kind, Vec<Cell>) {
        let axis = Axis::new(&Setting::parse(text).unwrap());
        (axis.column.name, axis.column.kind, axis.cells)
    }

    #[test]
    fn limit_columns_are_named_after_path_and_unit() {
        let numbers = |values: &[f64]| values.iter().map(|v| Cell::Number(*v)).collect::<Vec<_>>();
        assert_eq!(axis("a.b=kN(1),kN( 2 )"), ("a.b [kN]".to_owned(), Kind::Number, numbers(&[1.0, 2.0])));
        assert_eq!(
            axis("a=Force(kN(1)),Force(kN(2))"),
            ("a.Force [kN]".to_owned(), Kind::Number, numbers(&[1.0, 2.0]))
        );
        assert_eq!(axis("a=1,2.5"), ("a".to_owned(), Kind::Number, numbers(&[1.0, 2.5])));
        assert_eq!(axis("a=true,false"), ("a".to_owned(), Kind::Truth, vec![Cell::Truth(true), Cell::Truth(false)]));
        for mixed in
            ["a=N(1),kN(2)", "a=Peak,Local", "a=kN(1),2", "a=(x: 1),(x: 2)", "a=f(1,2),f(3,4)", "a=kN(nan),kN(1)"]
        {
            assert_eq!(axis(mixed).1, Kind::Text, "{mixed}");
        }
    }
}
