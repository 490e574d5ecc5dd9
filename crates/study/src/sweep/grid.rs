//! The rows of a sweep: every combination of the swept values, in the order of the options, the last varying fastest;
//! or samples, which give each row its own value of every path.

use super::axis::{Axis, AxisSummary};
use super::columns::{Cell, Column};
use super::setting::Setting;
use crate::error::StudyError;
use crate::patience::Patience;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tribodyn::Limits;
use tribodyn::answers::Equations;
use tribodyn::{CaseFile, Change};
use tribodyn_bearing::SearchWatch;
use tribodyn_case::{Case, CaseError, Template, set_value};

/// Most rows of a grid, far beyond any computing time.
const MAX_ROWS: usize = 1_000_000_000;
/// Rows that are solved one after the other, each starting from a neighbour among them. A constant of the format: it
/// decides which rows start cold, and must depend neither on threads nor on shards.
const CHUNK: Range<usize> = 8..65;

/// How rows take the values of the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Order {
    /// Every combination.
    Product,
    /// Each row the next value of all axes; these begin with this row.
    Samples { first: usize },
}

/// Part of a study by samples that one process has: the rows from `first` on, of so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampleRows {
    /// First row.
    pub first: usize,
    /// Rows of the whole study.
    pub total: usize,
}

/// The case, what is swept in it, and what each row is solved by.
pub struct Grid {
    /// Equations of every row.
    pub model: Equations,
    /// Name of the case file, for messages.
    name: String,
    /// The case file as it is.
    original: String,
    /// Changes of a single value.
    fixed: Vec<Change>,
    /// The case's text with them.
    base: String,
    /// That text with room for the axes, where each has a place of its own in it.
    template: Option<Template>,
    limits: Limits,
    axes: Vec<Axis>,
    order: Order,
    /// Number of rows.
    pub rows: usize,
    /// Processor time of a row, s, after which its search is ended; infinite where it may take what it takes.
    pub time_limit_s: f64,
    /// Once set, the searches of all rows end and no further row is begun.
    pub stop: Arc<AtomicBool>,
}

impl Grid {
    /// Checks every value before anything is solved.
    ///
    /// # Errors
    /// Settings that overlap or make too many rows, and the first value that is refused.
    pub fn new(
        name: &str,
        original: String,
        settings: &[Setting],
        (model, limits): (Equations, &Limits),
    ) -> Result<Self, StudyError> {
        let grid = Self::unchecked(name, original, settings, (model, limits))?;
        grid.check()?;
        Ok(grid)
    }

    /// [`Self::new`] without a look at the values: for one of many processes that share a sweep which was checked.
    ///
    /// # Errors
    /// Settings that overlap or make too many rows, and a single value that is refused.
    pub fn unchecked(
        name: &str,
        original: String,
        settings: &[Setting],
        (model, limits): (Equations, &Limits),
    ) -> Result<Self, StudyError> {
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
        Self::over(name, original, (fixed, axes, Order::Product, rows), (model, limits))
    }

    /// Samples: each row has the next value of every setting. Of these, the first and the last row are checked; what
    /// is wrong with another one stands in its row.
    ///
    /// # Errors
    /// Settings of different lengths, settings that overlap, and a first row that is refused like the last.
    pub fn samples(
        name: &str,
        original: String,
        settings: &[Setting],
        rows: SampleRows,
        (model, limits): (Equations, &Limits),
    ) -> Result<Self, StudyError> {
        let count = settings.first().map_or(0, Setting::count);
        if let Some(other) = settings.iter().find(|setting| setting.count() != count) {
            let message = format!("allowed are as many samples of each path: {} has {count}", settings[0].path);
            return Err(StudyError::argument("samples", format!("{} of {}", other.count(), other.path), message));
        }
        for (i, first) in settings.iter().enumerate() {
            if let Some(second) = settings[i + 1..].iter().find(|second| first.change(0).concerns(&second.path)) {
                let [first, second] = [first.path.clone(), second.path.clone()];
                return Err(StudyError::Overlap { first, second });
            }
        }
        if rows.total > MAX_ROWS {
            return Err(StudyError::TooManyRows { limit: MAX_ROWS });
        }
        let axes = settings.iter().map(Axis::new).collect();
        let order = Order::Samples { first: rows.first };
        let grid = Self::over(name, original, (Vec::new(), axes, order, rows.total), (model, limits))?;
        // Values drawn at random may make an impossible case now and then; a wrong unit is wrong in all rows.
        let bad = |row| grid.text(row).is_none_or(|text| !grid.sound(&text));
        if rows.first == 0 && bad(0) && bad(count.saturating_sub(1)) {
            return Err(grid.refusal(0));
        }
        Ok(grid)
    }

    fn over(
        name: &str,
        original: String,
        (fixed, axes, order, rows): (Vec<Change>, Vec<Axis>, Order, usize),
        (model, limits): (Equations, &Limits),
    ) -> Result<Self, StudyError> {
        let (name, base) = (name.to_owned(), String::new());
        let (limits, time_limit_s) = (*limits, f64::INFINITY);
        let mut grid = Self {
            model,
            name,
            original,
            fixed,
            base,
            template: None,
            limits,
            axes,
            order,
            rows,
            time_limit_s,
            stop: Arc::default(),
        };
        // The first row stands for the case without axes too: messages come from there.
        grid.base = grid.original.clone();
        for change in &grid.fixed {
            grid.base = match change.apply(&grid.base) {
                Ok(text) => text,
                Err(_) => return Err(grid.refusal(0)),
            };
        }
        let paths: Vec<&str> = grid.axes.iter().map(|axis| axis.setting.path.as_str()).collect();
        grid.template = Template::new(&grid.base, &paths);
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

    /// Error of a row that is refused, in words that blame the option.
    fn refusal(&self, row: usize) -> StudyError {
        let swept = self.axes.iter().zip(self.indices(row)).map(|(axis, i)| axis.setting.change(i));
        let changes: Vec<Change> = self.fixed.iter().cloned().chain(swept).collect();
        match CaseFile::from_text(&self.name, self.original.clone(), &changes, &self.limits)
            .and_then(|file| file.bearing_for(self.model.purpose()))
        {
            Err(failure) => failure.into(),
            // Texts are refused by the same reader: there is nothing that only one of both refuses.
            Ok(_) => StudyError::RefusalLost { row },
        }
    }

    /// True for a case with all that the model needs, within the limits.
    fn sound(&self, text: &str) -> bool {
        self.case(text).is_ok_and(|case| case.require(self.model.purpose()).is_ok() && case.bearing().is_ok())
    }

    /// The case of a row's text, within the limits.
    pub(crate) fn case(&self, text: &str) -> Result<Case, CaseError> {
        let case = Case::from_ron(text)?;
        self.limits.check(text, &case).map(|()| case)
    }

    /// The link of one row's search to a limit on its time, s.
    pub(crate) fn watch(&self, limit_s: f64) -> SearchWatch {
        let patience = Patience::of_seconds(limit_s).ended_with(Arc::clone(&self.stop));
        SearchWatch::new(Arc::new(patience))
    }

    /// True if no further row is begun.
    pub(crate) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
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
        if let Order::Samples { first } = self.order {
            return vec![row - first; self.axes.len()];
        }
        let place = |(axis, stride): (&Axis, usize)| row / stride % axis.cells.len();
        self.axes.iter().zip(self.strides()).map(place).collect()
    }

    /// How far apart two rows are: steps along the axes, or relative differences of samples.
    pub(crate) fn distance(&self, a: usize, b: usize) -> f64 {
        let pairs = self.indices(a).into_iter().zip(self.indices(b));
        let apart = |(axis, (a, b)): (&Axis, (usize, usize))| match (self.order, &axis.cells[a], &axis.cells[b]) {
            (Order::Product, ..) => a.abs_diff(b) as f64,
            (_, Cell::Number(a), Cell::Number(b)) if a != b => (a - b).abs() / (a.abs() + b.abs()),
            (_, a, b) => f64::from(a != b),
        };
        self.axes.iter().zip(pairs).map(apart).sum()
    }

    /// Ways from `near` to `row`, one step along one axis, by differences of rows that add up to it: the best first.
    ///
    /// With three rows in a line, or two beside two others, what is left of a smooth function is of third order in the
    /// steps of the grid, with one difference of second order.
    pub(crate) fn ways(&self, near: usize, row: usize) -> Vec<Vec<[usize; 2]>> {
        if matches!(self.order, Order::Samples { .. }) || self.distance(near, row) != 1.0 || near > row {
            return Vec::new();
        }
        let step = row - near;
        let strides = self.strides();
        let indices = self.indices(row);
        let along = |stride: usize| strides.iter().zip(&indices).find(|(s, _)| **s == stride).map_or(0, |(_, i)| *i);
        let beside = strides.iter().zip(&indices).filter(|(stride, i)| **stride != step && **i > 0);
        let beside: Vec<[usize; 2]> = beside.map(|(stride, _)| [near - stride, row - stride]).collect();
        let mut ways = Vec::new();
        if along(step) >= 2 {
            let straight = [near - step, near];
            // The difference along the line grows as it does beside it, or as it has grown so far.
            ways.extend(beside.iter().map(|&[from, to]| vec![straight, [from, to], [from, from - step]]));
            if along(step) >= 3 {
                ways.push(vec![straight, straight, [near - step, near - 2 * step]]);
            }
            ways.push(vec![straight]);
        }
        ways.extend(beside.into_iter().map(|pair| vec![pair]));
        ways
    }

    /// The text of a row's case; `None` where a path is not in it.
    pub fn text(&self, row: usize) -> Option<String> {
        if let Some(template) = &self.template {
            let values: Vec<&str> =
                self.axes.iter().zip(self.indices(row)).map(|(axis, i)| axis.setting.values[i].as_str()).collect();
            return template.with(&values);
        }
        let mut text = self.base.clone();
        for (axis, i) in self.axes.iter().zip(self.indices(row)) {
            text = set_value(&text, &axis.setting.path, &axis.setting.values[i]).ok()?;
        }
        Some(text)
    }

    /// The swept values of a row, as they stand in the table.
    pub fn cells(&self, row: usize) -> impl Iterator<Item = Cell> {
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

    /// Summary of the axes, for people and programs.
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
