//! The page of the hypotheses, from the committed result.

use super::{GROUPS, RESULT, steady};
use crate::error::PaperError;
use crate::files;
use crate::markers::replaced;
use crate::table::{Row, Table, markdown};

const DOCUMENT: &str = "docs/zhang2025/hypotheses.md";
const BEGIN: &str = "<!-- hypotheses:begin -->";
const END: &str = "<!-- hypotheses:end -->";

/// Rewrites the page's tables from the committed result.
///
/// # Errors
///
/// The result or the page cannot be read, or the page not written.
pub fn rewrite() -> Result<(), PaperError> {
    let [_, now] = document()?;
    files::write(&files::root().join(DOCUMENT), now.as_bytes())
}

/// Says so where the page's tables are not those of the committed result.
///
/// # Errors
///
/// The result or the page cannot be read.
pub fn outdated() -> Result<Option<String>, PaperError> {
    let [was, now] = document()?;
    Ok((was != now).then(|| format!("{DOCUMENT}: not the committed result: run `cargo xtask fixtures`")))
}

/// The page before and after its tables are made.
fn document() -> Result<[String; 2], PaperError> {
    let text = files::read(&files::root().join(DOCUMENT))?;
    let table = Table::read(RESULT, &files::read(&files::root().join(RESULT))?)?;
    let now = replaced(DOCUMENT, &text, &block(&table)?, [BEGIN, END])?;
    Ok([text, now])
}

fn block(table: &Table) -> Result<String, PaperError> {
    let head = [
        "hypothesis",
        "squares (of the data)",
        "ln evidence",
        "T4, worst %",
        "T5, worst GPa",
        "at a bound",
        "d_m, mm",
        "F14–F18 in view",
        "kept out",
        "F13–F24 in view",
        "kept out",
    ];
    let mut out = String::new();
    for group in &GROUPS {
        let rows: Vec<Row> = table.rows().filter(|row| row.first() == group.name).collect();
        let best = rows.iter().filter_map(|row| row.number("ln_evidence").ok()).fold(f64::NEG_INFINITY, f64::max);
        let mut cells = rows.iter().map(|row| line(row, best)).collect::<Result<Vec<_>, _>>()?;
        // The most evidence first; what could not be fitted last.
        let evidence = |cells: &Vec<String>| cells[2].replace('−', "-").parse().unwrap_or(f64::NEG_INFINITY);
        cells.sort_by(|a, b| f64::total_cmp(&evidence(b), &evidence(a)));
        let digits = group.rounding.map_or(String::new(), |[speed, pressure]| {
            format!(" σ {speed} r/min and {pressure} GPa, what is lost by rounding to the printed digits.")
        });
        let sigma = if digits.is_empty() { " σ 3 r/min and 0.01 GPa." } else { &digits };
        out += &format!("Data: {}.{sigma}\n\n{}\n", group.name, markdown(&head, &cells));
    }
    out += "What decides the rows of Figures 14 and 16 to 18 by equilibria and by steady orbits, * where the row is \
        met;\n*figures* is the set of the figures in the hypothesis of two sets:\n\n";
    Ok(out + &steady::block()? + "\nReproduced by `cargo xtask hypotheses`.\n")
}

fn line(row: &Row, best: f64) -> Result<Vec<String>, PaperError> {
    let cell = |column: &str| row.text(column).map(str::to_owned);
    let evidence = row.number("ln_evidence").map_or("–".to_owned(), |value| format!("{:.1}", value - best));
    Ok(vec![
        cell("hypothesis")?,
        format!("{} ({})", cell("squares")?, cell("of_data")?),
        evidence.replace('-', "−"),
        cell("worst_speed")?,
        cell("worst_pressure")?,
        cell("bounds")?,
        cell("d_m")?,
        cell("view_steady")?,
        cell("kept_steady")?,
        cell("view")?,
        cell("kept")?,
    ])
}
