//! Contents of a row of the table.

use std::fmt::Write;
use tribodyn_bearing::BallResult;
use tribodyn_bearing::quantities::{OfBall, Over, joined};
use tribodyn_orbit::{OrbitError, SteadyOrbit};
use tribodyn_quasistatic::{QuasiStaticError, SOLUTION, Solution};

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
    /// Absent: a number that the model does not have, or a row without a solution.
    Null,
}

/// Kind of all fields of a column.
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
    /// True if fields may be null.
    pub optional: bool,
}

impl Column {
    pub(crate) fn new(name: &str, kind: Kind, optional: bool) -> Self {
        Self { name: name.to_owned(), kind, optional }
    }
}

/// The column that says whether a row is a solution.
pub const CONVERGED: &str = "converged";

/// The column that names what no bearing does.
pub const IMPLAUSIBLE: &str = "implausible";

/// A row with a solution.
pub(crate) struct Solved {
    /// With the balls where they stand in an equilibrium.
    pub solution: Solution,
    /// The balls of an orbit round it, where the model has one.
    pub round: Option<Round>,
    /// Number of sentences that `solve` has on it.
    pub warnings: usize,
    /// Names of what no bearing does.
    pub implausible: Option<String>,
}

impl Solved {
    /// A number for all balls, of an orbit over its whole turn.
    fn over(&self, quantity: &OfBall, over: Over) -> Option<f64> {
        match &self.round {
            None => quantity.over(over, &self.solution.balls),
            Some(round) if over == Over::Sum => round.sum(quantity, self.solution.balls.len()),
            Some(round) => quantity.over(over, &round.points),
        }
    }
}

/// An orbit: a ball at places round it, and the mean powers of all balls that `solve` has, by name, W.
pub(crate) struct Round {
    points: Vec<BallResult>,
    powers: [(&'static str, f64); 3],
}

impl Round {
    pub fn of(orbit: &SteadyOrbit, points: Vec<BallResult>) -> Self {
        let [inner, outer] = orbit.friction_w;
        let powers = [("power_loss_inner", inner), ("power_loss_outer", outer), ("power_loss_fluid", orbit.fluid_w)];
        Self { points, powers }
    }

    /// Mean over the turn of the sum over all balls.
    fn sum(&self, quantity: &OfBall, balls: usize) -> Option<f64> {
        let of_ball = |ball: &BallResult| quantity.get(ball);
        let values: Vec<f64> = self.points.iter().map(of_ball).collect::<Option<_>>()?;
        if let Some((_, power)) = self.powers.iter().find(|(name, _)| *name == quantity.name()) {
            return Some(*power);
        }
        // A ball is longest where it is slow.
        let times = self.points.iter().map(|ball| 1.0 / ball.orbital_speed_rad_s.abs().max(f64::EPSILON));
        let (sum, time) =
            values.iter().zip(times).fold((0.0, 0.0), |(sum, all), (value, time)| (sum + value * time, all + time));
        Some(balls as f64 * sum / time)
    }
}

/// A column of results: its name, and its value for a row.
type Figure = (String, Box<dyn Fn(&Solved) -> Option<f64>>);

/// Numbers of a solution by name and in the unit of `solve --json`: those of the bearing, then those that the table of
/// quantities has for all balls.
fn figures() -> impl Iterator<Item = Figure> {
    let of_bearing = SOLUTION.iter().map(|q| -> Figure {
        let unit = q.facts.unit;
        (joined(&[q.facts.name, unit.suffix]), Box::new(move |s| (q.get)(&s.solution).map(|value| value * unit.per_si)))
    });
    let of_balls = OfBall::over_balls().map(|(q, over)| -> Figure {
        let unit = q.facts().unit;
        (q.over_name(over, unit), Box::new(move |s| s.over(&q, over).map(|value| value * unit.per_si)))
    });
    of_bearing.chain(of_balls)
}

/// All columns: the row's number, the swept values, what came of it.
pub(crate) fn columns(swept: impl Iterator<Item = Column>) -> Vec<Column> {
    let mut columns = vec![Column::new("row", Kind::Integer, false)];
    columns.extend(swept);
    columns.push(Column::new(CONVERGED, Kind::Truth, false));
    columns.push(Column::new("residual", Kind::Number, true));
    columns.push(Column::new("iterations", Kind::Integer, true));
    columns.extend(figures().map(|(name, _)| Column::new(&name, Kind::Number, true)));
    columns.push(Column::new("balls_in_contact", Kind::Integer, true));
    columns.push(Column::new("warnings", Kind::Integer, true));
    columns.push(Column::new(IMPLAUSIBLE, Kind::Text, true));
    columns.push(Column::new("error", Kind::Text, true));
    columns
}

/// Why a row has no solution.
pub(crate) struct Unsolved {
    /// Residual of the equations and number of steps taken, where they were tried.
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
            _ => None,
        };
        Self { tried, message: error.to_string() }
    }
}

impl From<OrbitError> for Unsolved {
    fn from(error: OrbitError) -> Self {
        Self { tried: None, message: error.to_string() }
    }
}

/// The fields of a row.
pub(crate) fn cells(row: usize, swept: impl Iterator<Item = Cell>, outcome: &Result<Solved, Unsolved>) -> Vec<Cell> {
    let count = |n: usize| Cell::Integer(n as i64);
    let mut cells = vec![count(row)];
    cells.extend(swept);
    match outcome {
        Ok(solved) => {
            let s = &solved.solution;
            let touching = s.balls.iter().filter(|b| b.contacts.inner.load_n > 0.0).count();
            cells.extend([Cell::Truth(true), Cell::Number(s.residual), count(s.iterations)]);
            cells.extend(figures().map(|(_, figure)| figure(solved).map_or(Cell::Null, Cell::Number)));
            let implausible = solved.implausible.clone().map_or(Cell::Null, Cell::Text);
            cells.extend([count(touching), count(solved.warnings), implausible, Cell::Null]);
        }
        Err(unsolved) => {
            let (residual, iterations) = match unsolved.tried {
                Some((residual, iterations)) => (Cell::Number(residual), count(iterations)),
                None => (Cell::Null, Cell::Null),
            };
            cells.extend([Cell::Truth(false), residual, iterations]);
            // Figures, balls in contact, warnings, what is implausible.
            cells.extend(std::iter::repeat_n(Cell::Null, figures().count() + 3));
            cells.push(Cell::Text(unsolved.message.clone()));
        }
    }
    cells
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
