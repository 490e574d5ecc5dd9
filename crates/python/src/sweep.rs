//! Sweeps: a grid or samples, solved in memory, into the command's tables, or part by part.

use crate::answers::equations;
use crate::convert::to_python;
use crate::error;
use crate::runs::pool;
use crate::watch::watched_by;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use tribodyn::Limits;
use tribodyn_study::StudyError;
use tribodyn_study::sweep::{
    Cell, Column, Count, Grid, Kind, Options, Part, Plan, SampleRows, Setting, Shard, Sweep, merge, solve_chunks,
    write_part,
};

/// The rows of a sweep.
#[pyclass(frozen, name = "Grid", module = "tribodyn._native")]
pub struct NativeGrid {
    grid: Arc<Grid>,
    cold: bool,
}

/// Values of a path: a list, or text as the command has it.
#[derive(FromPyObject)]
pub enum Values {
    /// `kN(10..60 by 5)`.
    Text(String),
    /// One by one.
    List(Vec<String>),
}

fn setting(py: Python<'_>, path: &str, values: Values) -> PyResult<Setting> {
    match values {
        Values::Text(text) => {
            let refused = |allowed: String| error::argument(py, path, &text, &allowed);
            Setting::parse(&format!("{path}={text}")).map_err(refused)
        }
        Values::List(values) if values.is_empty() => {
            Err(error::argument(py, path, "[]", "allowed is one value or more"))
        }
        Values::List(values) => Ok(Setting::of(path, values)),
    }
}

#[pymethods]
impl NativeGrid {
    /// Every combination of values; without `checked`, of a sweep that another process has checked.
    #[staticmethod]
    fn product(
        py: Python<'_>,
        case: (String, String),
        values: Vec<(String, Values)>,
        model_and_cold: (String, bool),
        checked: bool,
    ) -> PyResult<Self> {
        let (model, cold) = model_and_cold;
        let model = equations(py, &model)?;
        let settings: Vec<Setting> =
            values.into_iter().map(|(path, values)| setting(py, &path, values)).collect::<PyResult<_>>()?;
        let (name, text) = case;
        let pool = pool(py, 0)?;
        let grid = py.detach(|| {
            pool.install(|| match checked {
                true => Grid::new(&name, text, &settings, (model, &Limits::NORMAL)),
                false => Grid::unchecked(&name, text, &settings, (model, &Limits::NORMAL)),
            })
        });
        Ok(Self { grid: Arc::new(grid.map_err(|failure| error::study(py, failure))?), cold })
    }

    /// Rows with their own values of all paths: those from `first` on, of `total`.
    #[staticmethod]
    fn samples(
        py: Python<'_>,
        case: (String, String),
        values: Vec<(String, Vec<String>)>,
        rows: (usize, usize),
        model_and_cold: (String, bool),
    ) -> PyResult<Self> {
        let (model, cold) = model_and_cold;
        let model = equations(py, &model)?;
        if values.is_empty() || values.iter().any(|(_, values)| values.is_empty()) {
            return Err(error::argument(py, "samples", "none", "allowed is one path and one sample or more"));
        }
        let settings: Vec<Setting> = values.into_iter().map(|(path, values)| Setting::of(&path, values)).collect();
        let (name, text) = case;
        let rows = SampleRows { first: rows.0, total: rows.1 };
        let grid = Grid::samples(&name, text, &settings, rows, (model, &Limits::NORMAL));
        Ok(Self { grid: Arc::new(grid.map_err(|failure| error::study(py, failure))?), cold })
    }

    /// Rows of the whole sweep.
    #[getter]
    fn rows(&self) -> usize {
        self.grid.rows
    }

    /// Chunks of the whole sweep: rows that are solved one after the other.
    #[getter]
    fn chunks(&self) -> usize {
        self.grid.chunks()
    }

    /// Rows of a chunk; the last one may have fewer.
    #[getter]
    fn chunk_rows(&self) -> usize {
        self.grid.chunk_rows()
    }

    /// Names of the columns of a table.
    fn columns(&self) -> Vec<String> {
        self.grid.table_columns().into_iter().map(|column| column.name).collect()
    }

    /// Names of the columns of swept values.
    fn swept(&self) -> Vec<String> {
        self.grid.columns().map(|column| column.name).collect()
    }

    /// The text of a row's case, None where a path is not in it, and its swept values by the names of their columns.
    fn row<'py>(&self, py: Python<'py>, row: usize) -> PyResult<(Option<String>, Bound<'py, PyDict>)> {
        if row >= self.grid.rows {
            let allowed = format!("allowed is 0 to below {}", self.grid.rows);
            return Err(error::argument(py, "row", &row.to_string(), &allowed));
        }
        let swept = PyDict::new(py);
        for (column, cell) in self.grid.columns().zip(self.grid.cells(row)) {
            match cell {
                Cell::Integer(value) => swept.set_item(column.name, value)?,
                Cell::Number(value) => swept.set_item(column.name, value)?,
                Cell::Truth(value) => swept.set_item(column.name, value)?,
                Cell::Text(value) => swept.set_item(column.name, value)?,
                Cell::Null => swept.set_item(column.name, py.None())?,
            }
        }
        Ok((self.grid.text(row), swept))
    }

    /// Plan of the sweep, and about how long it would take.
    fn plan<'py>(&self, py: Python<'py>, threads: usize) -> PyResult<Bound<'py, PyAny>> {
        let pool = pool(py, threads)?;
        let (grid, cold) = (Arc::clone(&self.grid), self.cold);
        let threads = pool.current_num_threads();
        let stop = Arc::clone(&grid.stop);
        let (plan, _) = watched_by(py, None, (false, stop), move |_| Plan::new(&grid, Shard::ALL, cold, threads))?;
        to_python(py, &plan)
    }

    /// Columns of some chunks, by name. `progress` gets the number of rows that are solved.
    fn solve<'py>(
        &self,
        py: Python<'py>,
        chunks: (usize, usize),
        threads: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (grid, cold, pool) = (Arc::clone(&self.grid), self.cold, pool(py, threads)?);
        let columns = grid.table_columns();
        let kinds: Vec<Column> = columns.clone();
        let stop = Arc::clone(&grid.stop);
        let (solved, stopped) = watched_by(py, progress, (true, stop), move |watch| {
            let take = |rows: Vec<Vec<Cell>>| {
                watch.add(rows.len() as f64);
                (!watch.stopped()).then(|| transposed(&kinds, rows))
            };
            pool.install(|| solve_chunks(&grid, chunks.0..chunks.1.min(grid.chunks()), cold, take))
        })?;
        match (solved, stopped) {
            (_, Some(stopped)) => Err(stopped),
            (Some(parts), None) => arrays(py, &columns, parts),
            (None, None) => Err(error::internal(py, "the sweep has ended before its time")),
        }
    }

    /// Solves some chunks and writes their table. Gives rows, and rows without a solution.
    fn write_part(
        &self,
        py: Python<'_>,
        chunks: (usize, usize),
        path: PathBuf,
        threads: usize,
    ) -> PyResult<(usize, usize)> {
        let (grid, cold, pool) = (Arc::clone(&self.grid), self.cold, pool(py, threads)?);
        let part = Part { chunks: chunks.0..chunks.1.min(grid.chunks()), cold };
        let stop = Arc::clone(&grid.stop);
        let (written, stopped) = watched_by(py, None, (true, stop), move |watch| {
            pool.install(|| write_part(&grid, &part, &path, |_| !watch.stopped()))
        })?;
        match (written.map_err(|failure| error::study(py, failure))?, stopped) {
            (_, Some(stopped)) => Err(stopped),
            (Some(Count { rows, failed, .. }), None) => Ok((rows, failed)),
            (None, None) => Err(error::internal(py, "the part has ended before its time")),
        }
    }

    /// The command's sweep: a table, with finished rows beside it until it is whole. Gives rows, rows without a
    /// solution, implausible rows, and rows of an earlier sweep.
    fn write_table(
        &self,
        py: Python<'_>,
        table: PathBuf,
        shard: &str,
        restart: bool,
        threads: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<(usize, usize, usize, usize)> {
        let shard = Shard::parse(shard).map_err(|allowed| error::argument(py, "shard", shard, &allowed))?;
        let (grid, cold, pool) = (Arc::clone(&self.grid), self.cold, pool(py, threads)?);
        let stop = Arc::clone(&grid.stop);
        let (written, stopped) = watched_by(py, progress, (true, stop), move |watch| {
            let mut sweep = Sweep::open(&grid, &Options { table, shard, cold, restart })?;
            let resumed = sweep.finished_rows();
            watch.add(resumed as f64);
            pool.install(|| {
                sweep.solve(|rows| {
                    watch.add(rows as f64);
                    if watch.stopped() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                })
            })?;
            let count = sweep.write_table()?;
            sweep.forget_rows()?;
            Ok::<_, StudyError>((count.rows, count.failed, count.implausible, resumed))
        })?;
        match (written, stopped) {
            (_, Some(stopped)) => Err(stopped),
            (written, None) => written.map_err(|failure| error::study(py, failure)),
        }
    }
}

/// Tables of one sweep as one table. Gives rows, rows without a solution, and implausible rows.
#[pyfunction]
pub fn merge_tables(
    py: Python<'_>,
    tables: Vec<PathBuf>,
    output: PathBuf,
    force: bool,
) -> PyResult<(usize, usize, usize)> {
    let merged = py.detach(|| merge(&tables, &output, force));
    merged.map(|merged| (merged.rows, merged.failed, merged.implausible)).map_err(|failure| error::study(py, failure))
}

/// A column of some rows.
enum Data {
    Integers(Vec<Option<i64>>),
    Numbers(Vec<f64>),
    Truths(Vec<bool>),
    Texts(Vec<Option<String>>),
}

fn transposed(columns: &[Column], rows: Vec<Vec<Cell>>) -> Vec<Data> {
    let mut data: Vec<Data> = columns.iter().map(|column| Data::of(column.kind)).collect();
    for row in rows {
        data.iter_mut().zip(row).for_each(|(data, cell)| data.push(cell));
    }
    data
}

impl Data {
    fn of(kind: Kind) -> Self {
        match kind {
            Kind::Integer => Self::Integers(Vec::new()),
            Kind::Number => Self::Numbers(Vec::new()),
            Kind::Truth => Self::Truths(Vec::new()),
            Kind::Text => Self::Texts(Vec::new()),
        }
    }

    fn push(&mut self, cell: Cell) {
        match (self, cell) {
            (Self::Integers(all), Cell::Integer(value)) => all.push(Some(value)),
            (Self::Integers(all), _) => all.push(None),
            (Self::Numbers(all), Cell::Number(value)) => all.push(value),
            (Self::Numbers(all), _) => all.push(f64::NAN),
            (Self::Truths(all), cell) => all.push(cell == Cell::Truth(true)),
            (Self::Texts(all), Cell::Text(text)) => all.push(Some(text)),
            (Self::Texts(all), _) => all.push(None),
        }
    }

    fn append(&mut self, more: Self) {
        match (self, more) {
            (Self::Integers(all), Self::Integers(more)) => all.extend(more),
            (Self::Numbers(all), Self::Numbers(more)) => all.extend(more),
            (Self::Truths(all), Self::Truths(more)) => all.extend(more),
            (Self::Texts(all), Self::Texts(more)) => all.extend(more),
            _ => {}
        }
    }

    /// As an array; whole numbers of which some are absent are floating-point numbers.
    fn array<'py>(self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(match self {
            Self::Integers(all) if all.iter().all(Option::is_some) => {
                PyArray1::from_vec(py, all.into_iter().flatten().collect()).into_any()
            }
            Self::Integers(all) => {
                let numbers = all.into_iter().map(|value| value.map_or(f64::NAN, |value| value as f64));
                PyArray1::from_vec(py, numbers.collect()).into_any()
            }
            Self::Numbers(all) => PyArray1::from_vec(py, all).into_any(),
            Self::Truths(all) => PyArray1::from_vec(py, all).into_any(),
            Self::Texts(all) => PyList::new(py, all)?.into_any(),
        })
    }
}

/// Columns of some rows as arrays by name.
pub fn table_arrays<'py>(py: Python<'py>, columns: &[Column], rows: Vec<Vec<Cell>>) -> PyResult<Bound<'py, PyDict>> {
    arrays(py, columns, vec![transposed(columns, rows)])
}

fn arrays<'py>(py: Python<'py>, columns: &[Column], parts: Vec<Vec<Data>>) -> PyResult<Bound<'py, PyDict>> {
    let mut whole: Vec<Data> = columns.iter().map(|column| Data::of(column.kind)).collect();
    for part in parts {
        whole.iter_mut().zip(part).for_each(|(whole, part)| whole.append(part));
    }
    let dict = PyDict::new(py);
    for (column, data) in columns.iter().zip(whole) {
        dict.set_item(&column.name, data.array(py)?)?;
    }
    Ok(dict)
}
