//! Missed rows of Figures 13 to 24, and the changes that turn them.

use super::changes;
use crate::error::PaperError;
use crate::files;
use crate::progress::{Progress, in_time};
use crate::table::{Table, markdown};
use crate::transient::{AUTHORS, CLASSICAL, Change, Reading, Set};
use crate::validate::{Evidence, Row, Verdict, azimuth_rows, dynamic_rows};

/// Cases whose missed rows are looked at.
pub struct Cases {
    reading: &'static Reading,
    /// The committed result.
    result: &'static str,
    /// Name in the document.
    name: &'static str,
}

pub const AUTHORS_CASE: Cases = Cases {
    reading: &AUTHORS,
    result: "fixtures/expected/sensitivity-rows-authors.csv",
    name: "the paper's case (`paper-authors-ag.ron`)",
};
pub const CLASSICAL_CASE: Cases = Cases {
    reading: &CLASSICAL,
    result: "fixtures/expected/sensitivity-rows.csv",
    name: "the classical reading (`paper-ag.ron`)",
};

/// Names of changes that the document lists for a row; the rest is a number.
const LISTED: usize = 3;
/// Columns beside those of the rows: the name, and the rows that the change makes miss.
const BESIDE: [&str; 2] = ["change", "lost"];

fn line(name: &str, rows: Result<Vec<Row>, PaperError>, [missed, met]: [&[String]; 2], progress: Progress) -> String {
    let rows = match rows {
        Ok(rows) => rows,
        Err(reason) => {
            progress(&format!("{name}: {reason}"));
            return format!("{name},–{}", ",–".repeat(missed.len()));
        }
    };
    let verdict = |id: &String| rows.iter().find(|row| row.id == *id);
    let lost: Vec<&str> =
        met.iter().filter(|id| verdict(id).is_none_or(|row| row.verdict != Verdict::Met)).map(String::as_str).collect();
    let cell = |id: &String| {
        verdict(id).map_or("–".to_owned(), |row| {
            let star = if row.verdict == Verdict::Met { "*" } else { "" };
            format!("{}{star}", row.computed_text())
        })
    };
    let cells: Vec<String> = missed.iter().map(cell).collect();
    let lost = if lost.is_empty() { "none".to_owned() } else { lost.join(" ") };
    format!("{name},{lost},{}", cells.join(","))
}

impl Cases {
    /// Rows over azimuth and those of the dynamic model.
    fn rows(&self, change: &Change, set: &Set) -> Result<Vec<Row>, PaperError> {
        let mut rows = azimuth_rows(self.reading.ag, &change.values)?;
        rows.extend(dynamic_rows(set)?);
        Ok(rows)
    }

    /// Makes the runs and writes the result; where only some changes are wanted, the lines of the others stay.
    pub fn run(&self, base: &Set, only: Option<&str>, progress: Progress) -> Result<(), PaperError> {
        let rows = self.rows(&Change::none("as identified"), base)?;
        let of = |wanted: Verdict| -> Vec<String> {
            let judged = rows.iter().filter(|row| row.verdict == wanted && row.evidence != Evidence::Verification);
            judged.map(|row| row.id.clone()).collect()
        };
        let (mut missed, mut met) = (of(Verdict::Missed), of(Verdict::Met));
        let path = files::root().join(self.result);
        let before = if only.is_some() { files::read(&path)? } else { String::new() };
        if only.is_some() {
            // Lines that stay have the columns that they have.
            let table = Table::read(self.result, &before)?;
            missed = table.columns().iter().filter(|id| !BESIDE.contains(&id.as_str())).cloned().collect();
            met.retain(|id| !missed.contains(id));
        }
        let kept = |name: &str| before.lines().find(|line| line.split(',').next() == Some(name)).map(str::to_owned);
        let wanted = |name: &str| only.is_none_or(|part| name.contains(part));
        let changed = |change: &Change| self.rows(change, &Set::changed(self.reading, change)?);
        let one = |change: &Change| match kept(&change.name) {
            Some(line) if !wanted(&change.name) => line,
            _ => {
                let rows = in_time(&change.name, progress, || changed(change));
                line(&change.name, rows, [&missed, &met], progress)
            }
        };
        let lines: Vec<String> = changes::all(self.reading)?.iter().map(one).collect();
        let text = format!(
            "# our own output; rewritten by `cargo xtask sensitivity`\n# what decides the missed rows of Figures 13 to \
            24, with one thing changed in all runs, fast scheme at 20 us; * where the row is met then, – where a run \
            failed or nothing is left to measure\n# lost: rows that are met without the change and missed with \
            it\n{},{}\n{}\n",
            BESIDE.join(","),
            missed.join(","),
            lines.join("\n")
        );
        files::write(&path, text.as_bytes())
    }

    /// The document's table: a row of the paper on each line.
    pub fn block(&self) -> Result<String, PaperError> {
        let text = files::read(&files::root().join(self.result))?;
        let table = Table::read(self.result, &text)?;
        let changes: Vec<_> = table.rows().collect();
        let columns = table.columns().iter().filter(|column| !BESIDE.contains(&column.as_str()));
        let out = columns.map(|id| cells(id, &changes)).collect::<Result<Vec<_>, _>>()?;
        let head = ["row", "as identified", "least", "greatest", "met with"];
        let (name, result) = (self.name, self.result);
        let count = changes.len().saturating_sub(1);
        let costs = costs(&changes)?;
        Ok(format!(
            "What decides each missed row of Figures 13 to 24 of {name}, and what {count} changes make of it, one at a \
            time in all runs (`{result}` has them all):\n\n{}\n{costs}\n",
            markdown(&head, &out)
        ))
    }
}

/// A line of the document's table.
fn cells(id: &str, changes: &[crate::table::Row<'_>]) -> Result<Vec<String>, PaperError> {
    let mut cells = vec![id.to_owned()];
    let [mut least, mut most]: [Extreme; 2] = [None, None];
    let mut turned = Vec::new();
    for (index, row) in changes.iter().enumerate() {
        let Some((number, met)) = value(row.text(id)?) else { continue };
        if index == 0 {
            cells.push(row.text(id)?.to_owned());
            continue;
        }
        least = least.filter(|(l, _)| *l <= number).or(Some((number, row.first())));
        most = most.filter(|(m, _)| *m >= number).or(Some((number, row.first())));
        if met {
            turned.push(row.first());
        }
    }
    let extreme = |e: Extreme| e.map_or("–".to_owned(), |(v, name)| format!("{v} ({name})"));
    cells.extend([extreme(least), extreme(most), listed(&turned)]);
    Ok(cells)
}

/// Value of a cell, and whether the row is met.
fn value(cell: &str) -> Option<(f64, bool)> {
    let number = cell.trim_end_matches('*').parse().ok().filter(|v: &f64| v.is_finite())?;
    Some((number, cell.ends_with('*')))
}

/// An extreme value and the change that made it.
type Extreme<'a> = Option<(f64, &'a str)>;

fn listed(names: &[&str]) -> String {
    match names.len() {
        0 => "none".to_owned(),
        n if n > LISTED => format!("{} and {} more", names[..LISTED].join("; "), n - LISTED),
        _ => names.join("; "),
    }
}

/// Number of changes that turn a row and leave the met rows alone.
fn costs(changes: &[crate::table::Row<'_>]) -> Result<String, PaperError> {
    let mut free = Vec::new();
    for row in changes.iter().skip(1) {
        let turned: Vec<&str> = row
            .columns()
            .iter()
            .filter(|id| !BESIDE.contains(&id.as_str()) && row.text(id).is_ok_and(|cell| cell.ends_with('*')))
            .map(String::as_str)
            .collect();
        if !turned.is_empty() && row.text("lost")? == "none" {
            free.push(format!("{} ({})", row.first(), turned.join(", ")));
        }
    }
    Ok(match free.as_slice() {
        [] => "Each change that turns a row makes others miss that are met without it.".to_owned(),
        free => format!(
            "Of the changes that turn a row, these make none miss that is met without them: {}.",
            free.join("; ")
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_cells_hold_a_number_and_a_verdict() {
        assert_eq!(value("-1.25*"), Some((-1.25, true)));
        assert_eq!(value("264"), Some((264.0, false)));
        assert_eq!((value("–"), value("NaN")), (None, None));
        assert_eq!(listed(&["a"; 9]), "a; a; a and 6 more");
    }
}
