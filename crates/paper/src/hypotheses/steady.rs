//! Figures 14 and 16 to 18 by equilibria, and by the steady orbits of the four cases: the paper does not say which of
//! its models drew them.

use super::fitted::set_of_figures;
use super::{APART, GROUPS, RESULT};
use crate::error::PaperError;
use crate::files;
use crate::progress::{Progress, in_time};
use crate::table::{Table, markdown};
use crate::transient::AUTHORS;
use crate::validate::{Row, Verdict, azimuth_rows_by_orbits, azimuth_rows_of};
use std::fmt::Write;
use tribodyn_orbit::POINTS;

const STEADY: &str = "fixtures/expected/hypotheses-steady.csv";
const HEAD: [&str; 4] = ["authors equilibria", "authors orbits", "figures equilibria", "figures orbits"];
/// Balls of the bearing.
const BALLS: usize = 13;
/// The row about the sign of a slide-to-roll ratio, and that with the other sign.
const SIGN: &str = "F17.2";
const OTHER_SIGN: &str = "F17.2 with ξ of the other sign";

/// The text of the set that the figures of the committed result ask for.
fn figures() -> Result<String, PaperError> {
    let table = Table::read(RESULT, &files::read(&files::root().join(RESULT))?)?;
    let [.., group] = &GROUPS;
    let (problem, case) = group.read()?;
    let none = || PaperError::Check { what: "hypotheses", findings: vec![format!("no `{APART}` in {RESULT}")] };
    let hypothesis = problem.hypotheses.iter().find(|h| h.name == APART).ok_or_else(none)?;
    let line = table.rows().find(|row| row.text("hypothesis").is_ok_and(|name| name == APART)).ok_or_else(none)?;
    let values: Result<Vec<f64>, _> = line.text("values")?.split(' ').map(str::parse).collect();
    let values = values.map_err(|_| line.fail("`values` are no numbers".to_owned()))?;
    let failed = |source| PaperError::Identify { hypothesis: APART.to_owned(), source: Box::new(source) };
    set_of_figures(&problem, &case, hypothesis, &values).map_err(failed)
}

/// Works out all rows by both models and writes them.
///
/// # Errors
///
/// No committed set of the figures, a case without equilibrium. A case without a steady orbit leaves its column empty.
pub fn run(progress: Progress) -> Result<(), PaperError> {
    let cases = [("authors", files::read(&files::root().join(AUTHORS.ag))?), ("figures", figures()?)];
    let mut columns: Vec<(Vec<Row>, usize)> = Vec::new();
    for (name, text) in &cases {
        columns.push((azimuth_rows_of(name, text, None)?, BALLS));
        let orbits = in_time(&format!("orbits, {name}"), progress, || azimuth_rows_by_orbits(name, text));
        let orbits = orbits.unwrap_or_else(|reason| {
            progress(&format!("{name}: {reason}"));
            Vec::new()
        });
        columns.push((orbits, POINTS));
    }
    let mut text = format!(
        "# our own output; rewritten by `cargo xtask hypotheses`\n# what decides the rows of Figures 14 and 16 to 18, * \
        where the row is met, by equilibria and by steady orbits, of the authors' case and of the set that the figures \
        ask for\nrow,{}\n",
        HEAD.join(",")
    );
    for row in &columns[0].0 {
        let same = |rows: &Vec<Row>| rows.iter().find(|other| other.id == row.id).cloned();
        let of = |(rows, _): &(Vec<Row>, usize)| same(rows).map_or("–".to_owned(), |row| cell(&row));
        let _ = writeln!(text, "{},{}", row.id, columns.iter().map(of).collect::<Vec<_>>().join(","));
        if row.id == SIGN {
            let of =
                |(rows, places): &(Vec<Row>, usize)| same(rows).map_or("–".to_owned(), |row| turned(&row, *places));
            let _ = writeln!(text, "{OTHER_SIGN},{}", columns.iter().map(of).collect::<Vec<_>>().join(","));
        }
    }
    files::write(&files::root().join(STEADY), text.as_bytes())
}

fn cell(row: &Row) -> String {
    format!("{}{}", row.computed_text(), if row.verdict == Verdict::Met { "*" } else { "" })
}

/// Places with the stated sign if the paper's slide-to-roll ratio has the opposite one of ours; both cases with
/// differential slip count.
fn turned(row: &Row, places: usize) -> String {
    let right = row.computed.map_or(f64::NAN, |own| 2.0 * places as f64 - own);
    format!("{right:.0}{}", if right == 2.0 * places as f64 { "*" } else { "" })
}

/// The page's table.
pub fn block() -> Result<String, PaperError> {
    let table = Table::read(STEADY, &files::read(&files::root().join(STEADY))?)?;
    let cells = |row: crate::table::Row<'_>| {
        let cells = table.columns().iter().map(|column| row.text(column).map(str::to_owned));
        cells.collect::<Result<Vec<_>, _>>()
    };
    let rows = table.rows().map(cells).collect::<Result<Vec<_>, _>>()?;
    let head: Vec<&str> = table.columns().iter().map(String::as_str).collect();
    Ok(markdown(&head, &rows))
}
