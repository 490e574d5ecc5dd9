//! What a row of the table holds.

use std::fmt::Write;
use tribodyn_quasistatic::{BallSolution, QuasiStaticError, Solution};

/// One field of a row.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A whole number.
    Integer(i64),
    /// A number in the unit of the column.
    Number(f64),
    /// Yes or no.
    Truth(bool),
    /// Words.
    Text(String),
    /// What a row without a solution has in place of numbers.
    Null,
}

/// What all fields of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Whole numbers.
    Integer,
    /// Numbers in one unit.
    Number,
    /// Yes or no.
    Truth,
    /// Words.
    Text,
}

/// A column of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name, with the unit.
    pub name: String,
    /// Kind of all fields.
    pub kind: Kind,
    /// Whether fields may be null.
    pub optional: bool,
}

impl Column {
    pub(crate) fn new(name: &str, kind: Kind, optional: bool) -> Self {
        Self { name: name.to_owned(), kind, optional }
    }
}

/// The column that says whether a row is a solution.
pub const CONVERGED: &str = "converged";

/// A column of results: its name, and its value for a solution.
type Figure = (&'static str, fn(&Solution) -> f64);

/// Figures of a solution; names and units as in the answer of `solve --json`, `max` and `min` over the balls, magnitudes
/// where the sign only says which body is faster, powers and wear rates summed over the balls.
const FIGURES: [Figure; 34] = [
    ("cage_speed_rpm", |s| s.cage_speed_rpm),
    ("ring_displacement_x_m", |s| s.ring_displacement_m[0]),
    ("ring_displacement_y_m", |s| s.ring_displacement_m[1]),
    ("ring_displacement_z_m", |s| s.ring_displacement_m[2]),
    ("ring_tilt_x_rad", |s| s.ring_tilt_rad[0]),
    ("ring_tilt_y_rad", |s| s.ring_tilt_rad[1]),
    ("shaft_torque_nm", |s| s.shaft_torque_nm),
    ("power_loss_inner_w", |s| sum(s, |b| b.power_loss_inner_w)),
    ("power_loss_outer_w", |s| sum(s, |b| b.power_loss_outer_w)),
    ("power_loss_fluid_w", |s| sum(s, |b| b.power_loss_fluid_w)),
    ("load_inner_min_n", |s| min(s, |b| b.load_inner_n)),
    ("load_inner_max_n", |s| max(s, |b| b.load_inner_n)),
    ("load_outer_min_n", |s| min(s, |b| b.load_outer_n)),
    ("load_outer_max_n", |s| max(s, |b| b.load_outer_n)),
    ("peak_pressure_inner_max_pa", |s| max(s, |b| b.peak_pressure_inner_pa)),
    ("peak_pressure_outer_max_pa", |s| max(s, |b| b.peak_pressure_outer_pa)),
    ("slide_to_roll_inner_max", |s| max(s, |b| b.slide_to_roll_inner.abs())),
    ("slide_to_roll_outer_max", |s| max(s, |b| b.slide_to_roll_outer.abs())),
    ("spin_ratio_inner_max_per_m", |s| max(s, |b| b.spin_ratio_inner.abs())),
    ("spin_ratio_outer_max_per_m", |s| max(s, |b| b.spin_ratio_outer.abs())),
    ("wear_rate_inner_m3_s", |s| sum(s, |b| b.wear_rate_inner_m3_s)),
    ("wear_rate_outer_m3_s", |s| sum(s, |b| b.wear_rate_outer_m3_s)),
    ("wear_rate_cage_m3_s", |s| sum(s, |b| b.wear_rate_cage_m3_s)),
    ("contact_angle_inner_min_deg", |s| min(s, |b| b.contact_angle_inner_deg)),
    ("contact_angle_inner_max_deg", |s| max(s, |b| b.contact_angle_inner_deg)),
    ("contact_angle_outer_min_deg", |s| min(s, |b| b.contact_angle_outer_deg)),
    ("contact_angle_outer_max_deg", |s| max(s, |b| b.contact_angle_outer_deg)),
    ("orbital_speed_min_rad_s", |s| min(s, |b| b.orbital_speed_rad_s)),
    ("orbital_speed_max_rad_s", |s| max(s, |b| b.orbital_speed_rad_s)),
    ("cage_force_max_n", |s| max(s, |b| b.cage_force_n.abs())),
    ("ring_load_x_n", |s| s.ring_load_n[0]),
    ("ring_load_y_n", |s| s.ring_load_n[1]),
    ("ring_load_z_n", |s| s.ring_load_n[2]),
    ("patch_error_estimate", |s| s.patch_error_estimate.unwrap_or(f64::NAN)),
];

fn sum(s: &Solution, of: impl Fn(&BallSolution) -> f64) -> f64 {
    s.balls.iter().map(of).sum()
}

fn max(s: &Solution, of: impl Fn(&BallSolution) -> f64) -> f64 {
    s.balls.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

fn min(s: &Solution, of: impl Fn(&BallSolution) -> f64) -> f64 {
    s.balls.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// All columns: the row's number, the swept values, what came of it.
pub(crate) fn columns(swept: impl Iterator<Item = Column>) -> Vec<Column> {
    let mut columns = vec![Column::new("row", Kind::Integer, false)];
    columns.extend(swept);
    columns.push(Column::new(CONVERGED, Kind::Truth, false));
    columns.push(Column::new("residual", Kind::Number, true));
    columns.push(Column::new("iterations", Kind::Integer, true));
    columns.extend(FIGURES.iter().map(|(name, _)| Column::new(name, Kind::Number, true)));
    columns.push(Column::new("balls_in_contact", Kind::Integer, true));
    columns.push(Column::new("warnings", Kind::Integer, true));
    columns.push(Column::new("error", Kind::Text, true));
    columns
}

/// Why a row has no solution.
pub(crate) struct Unsolved {
    /// What is left of the equations, and the steps taken, where they were tried.
    tried: Option<(f64, usize)>,
    message: String,
}

impl Unsolved {
    /// A combination of values that is no case.
    pub fn refused(message: impl ToString) -> Self {
        Self { tried: None, message: message.to_string() }
    }
}

impl From<QuasiStaticError> for Unsolved {
    fn from(error: QuasiStaticError) -> Self {
        let tried = match &error {
            QuasiStaticError::NotConverged { residual, iterations, .. } => Some((*residual, *iterations)),
            QuasiStaticError::Missing { .. } | QuasiStaticError::Traction(_) => None,
        };
        Self { tried, message: error.to_string() }
    }
}

/// A row as a line of text, without its end.
pub(crate) fn line(row: usize, swept: impl Iterator<Item = Cell>, outcome: &Result<Solution, Unsolved>) -> String {
    let count = |n: usize| Cell::Integer(n as i64);
    let mut cells = vec![count(row)];
    cells.extend(swept);
    match outcome {
        Ok(s) => {
            let touching = s.balls.iter().filter(|b| b.load_inner_n > 0.0).count();
            cells.extend([Cell::Truth(true), Cell::Number(s.residual), count(s.iterations)]);
            cells.extend(FIGURES.iter().map(|(_, figure)| Cell::Number(figure(s))));
            cells.extend([count(touching), count(s.warnings.len()), Cell::Null]);
        }
        Err(unsolved) => {
            let (residual, iterations) = match unsolved.tried {
                Some((residual, iterations)) => (Cell::Number(residual), count(iterations)),
                None => (Cell::Null, Cell::Null),
            };
            cells.extend([Cell::Truth(false), residual, iterations]);
            // Figures, balls in contact, warnings.
            cells.extend(std::iter::repeat_n(Cell::Null, FIGURES.len() + 2));
            cells.push(Cell::Text(unsolved.message.clone()));
        }
    }
    encode(&cells)
}

/// Fields as one line of CSV: numbers in the shortest form that reads back as the same, strings in quotes where needed.
pub(crate) fn encode(cells: &[Cell]) -> String {
    let mut line = String::new();
    for (i, cell) in cells.iter().enumerate() {
        if i > 0 {
            line.push(',');
        }
        // Writing to a string does not fail.
        let _ = match cell {
            Cell::Integer(n) => write!(line, "{n}"),
            Cell::Number(v) => write!(line, "{v:?}"),
            Cell::Truth(t) => write!(line, "{t}"),
            Cell::Text(text) => write!(line, "{}", quoted(text)),
            Cell::Null => Ok(()),
        };
    }
    line
}

/// A string as a field of CSV, on one line.
fn quoted(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    if text.is_empty() || text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// The names of the columns as a line of CSV.
pub(crate) fn header(columns: &[Column]) -> String {
    encode(&columns.iter().map(|column| Cell::Text(column.name.clone())).collect::<Vec<_>>())
}

/// The fields of a line; `None` where it is not a whole row of these columns.
pub(crate) fn decode(line: &str, columns: &[Column]) -> Option<Vec<Cell>> {
    let fields = split(line)?;
    if fields.len() != columns.len() {
        return None;
    }
    let cell = |((text, quoted), column): ((String, bool), &Column)| {
        if text.is_empty() && !quoted {
            return column.optional.then_some(Cell::Null);
        }
        match column.kind {
            Kind::Integer => text.parse().ok().map(Cell::Integer),
            Kind::Number => text.parse().ok().map(Cell::Number),
            Kind::Truth => text.parse().ok().map(Cell::Truth),
            Kind::Text => Some(Cell::Text(text)),
        }
    };
    fields.into_iter().zip(columns).map(cell).collect()
}

/// Cuts a line of CSV into fields, each with whether it was in quotes.
fn split(line: &str) -> Option<Vec<(String, bool)>> {
    let mut fields = Vec::new();
    let mut rest = line;
    loop {
        let (field, after) = if let Some(mut inside) = rest.strip_prefix('"') {
            let mut text = String::new();
            loop {
                let (part, after) = inside.split_once('"')?;
                text.push_str(part);
                let Some(more) = after.strip_prefix('"') else { break ((text, true), after) };
                text.push('"');
                inside = more;
            }
        } else {
            let end = rest.find(',').unwrap_or(rest.len());
            ((rest[..end].to_owned(), false), &rest[end..])
        };
        fields.push(field);
        match after.strip_prefix(',') {
            Some(more) => rest = more,
            None => return after.is_empty().then_some(fields),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_what_is_written_reads_back() {
        let kinds = [Kind::Integer, Kind::Number, Kind::Number, Kind::Truth, Kind::Text, Kind::Text, Kind::Number];
        let columns: Vec<Column> = kinds.into_iter().map(|kind| Column::new("c", kind, true)).collect();
        let text = |t: &str| Cell::Text(t.to_owned());
        let cells = [
            Cell::Integer(-3),
            Cell::Number(0.1 + 0.2),
            Cell::Number(1.234e-300),
            Cell::Truth(false),
            text("a \"b\", c"),
            text(""),
            Cell::Null,
        ];
        let line = encode(&cells);
        assert_eq!(line, "-3,0.30000000000000004,1.234e-300,false,\"a \"\"b\"\", c\",\"\",");
        assert_eq!(decode(&line, &columns).unwrap(), cells);
        for bad in ["", "-3", &line[..20], &line[..line.len() - 2], &format!("{line},"), &line.replace("-3", "x")] {
            assert_eq!(decode(bad, &columns), None, "{bad}");
        }
    }
}
