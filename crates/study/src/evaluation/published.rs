//! Published or measured figures beside those of a run.

use crate::case_file::read_text;
use crate::error::StudyError;
use serde::Serialize;
use serde_json::Value;
use std::path::Path;
use tribodyn::Limits;

const HEAD: &str = "id,quantity,published,tolerance,source";

/// A figure of the file.
struct Figure {
    id: String,
    quantity: String,
    published: f64,
    tolerance: f64,
    source: String,
    line: usize,
    /// Column of the quantity.
    column: usize,
}

/// A figure beside that of the run.
#[derive(Debug, Serialize)]
pub struct Compared {
    /// Name of the figure in its file.
    pub id: String,
    /// Field of `summary.json`, with dots between the levels; its name ends in the unit.
    pub quantity: String,
    /// Published value, in the unit of the quantity.
    pub published: f64,
    /// None where the run has no such value.
    pub computed: Option<f64>,
    /// Largest deviation that is still met.
    pub tolerance: f64,
    /// True if the deviation is within the tolerance.
    pub met: bool,
    /// Where the value is published.
    pub source: String,
}

/// The figures of a CSV file beside the fields of `summary`.
///
/// # Errors
/// The file cannot be read, or a figure is refused with its line and column.
pub fn compared(path: &Path, summary: &Value, limits: &Limits) -> Result<Vec<Compared>, StudyError> {
    let text = read_text(path, limits)?;
    let refused = |(line, column, message)| StudyError::Figures { path: path.to_owned(), line, column, message };
    let figures = figures(&text).map_err(refused)?;
    figures.iter().map(|figure| beside(figure, summary).map_err(refused)).collect()
}

/// Line and column, from 1, and what is wrong there.
type Refused = (usize, usize, String);

fn figures(text: &str) -> Result<Vec<Figure>, Refused> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    match lines.next() {
        Some((_, line)) if line.trim_end() == HEAD => {}
        Some((at, line)) => {
            return Err((at + 1, 1, format!("the columns are `{}`: they must be `{HEAD}`", short(line))));
        }
        None => return Err((1, 1, format!("the file is empty: its first line must be `{HEAD}`"))),
    }
    lines.map(|(at, line)| figure(at + 1, line)).collect()
}

fn figure(line: usize, text: &str) -> Result<Figure, Refused> {
    let cells = cells(text).map_err(|(column, message)| (line, column, message))?;
    let [id, quantity, _, tolerance, source] = cells.as_slice() else {
        let text = short(text);
        return Err((line, 1, format!("`{text}` has {} columns: there must be 5, `{HEAD}`", cells.len())));
    };
    let number = |cell: usize, name: &str| {
        let Cell { column, text } = &cells[cell];
        let value = text.trim().parse().ok().filter(|v: &f64| v.is_finite());
        value.ok_or_else(|| (line, *column, format!("{name} = `{}`: must be a finite number", short(text))))
    };
    let (value, allowed) = (number(2, "published")?, number(3, "tolerance")?);
    if allowed < 0.0 {
        let text = short(&tolerance.text);
        return Err((line, tolerance.column, format!("tolerance = `{text}`: must be 0 or greater")));
    }
    let trimmed = |cell: &Cell| cell.text.trim().to_owned();
    Ok(Figure {
        id: trimmed(id),
        quantity: trimmed(quantity),
        published: value,
        tolerance: allowed,
        source: trimmed(source),
        line,
        column: quantity.column,
    })
}

/// A field of a line with its column, from 1.
struct Cell {
    column: usize,
    text: String,
}

/// The fields of a line, after RFC 4180: one that begins with a quotation mark ends with one, and may have commas, and
/// doubled quotation marks, in between. The fifth field may have commas without that too: sources often do.
fn cells(text: &str) -> Result<Vec<Cell>, (usize, String)> {
    let mut cells = Vec::new();
    let mut rest = text;
    loop {
        let column = 1 + text[..text.len() - rest.len()].chars().count();
        let trimmed = rest.trim_start();
        let (cell, after) = match trimmed.strip_prefix('"') {
            Some(quoted) => unquoted(quoted).ok_or_else(|| (column, "a quotation mark is not closed".to_owned()))?,
            None if cells.len() == 4 => (rest.to_owned(), ""),
            None => {
                let end = rest.find(',').unwrap_or(rest.len());
                (rest[..end].to_owned(), &rest[end..])
            }
        };
        cells.push(Cell { column, text: cell });
        let after = after.trim_start();
        match after.strip_prefix(',') {
            Some(next) => rest = next,
            None if after.is_empty() => return Ok(cells),
            None => {
                let column = 1 + text[..text.len() - after.len()].chars().count();
                return Err((column, format!("`{}` stands behind a closed quotation mark", short(after))));
            }
        }
    }
}

/// The text up to a closing quotation mark, and what comes after it.
fn unquoted(text: &str) -> Option<(String, &str)> {
    let mut value = String::new();
    let mut rest = text;
    loop {
        let (before, after) = rest.split_once('"')?;
        value += before;
        match after.strip_prefix('"') {
            Some(next) => {
                value.push('"');
                rest = next;
            }
            None => return Some((value, after)),
        }
    }
}

/// Enough of a value for a message.
fn short(text: &str) -> String {
    let end = text.char_indices().nth(80).map_or(text.len(), |(end, _)| end);
    if end < text.len() { format!("{}…", &text[..end]) } else { text.to_owned() }
}

/// Reads a text of figures, for trials with damaged ones: none of them may do worse than be refused.
#[doc(hidden)]
pub fn is_figures(text: &str) -> bool {
    figures(text).is_ok()
}

fn beside(figure: &Figure, summary: &Value) -> Result<Compared, Refused> {
    let found = figure.quantity.split('.').try_fold(summary, |level, key| level.get(key));
    let computed = match found {
        Some(Value::Number(number)) => number.as_f64(),
        Some(Value::Null) => None,
        _ => {
            let message = format!(
                "quantity = `{}`: must be a number of summary.json, such as cage_speed_mean_rpm or frequencies.ball_pass_outer_hz",
                short(&figure.quantity)
            );
            return Err((figure.line, figure.column, message));
        }
    };
    Ok(Compared {
        id: figure.id.clone(),
        quantity: figure.quantity.clone(),
        published: figure.published,
        computed,
        tolerance: figure.tolerance,
        met: computed.is_some_and(|value| (value - figure.published).abs() <= figure.tolerance),
        source: figure.source.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_figure_is_met_up_to_its_tolerance() {
        let summary = serde_json::json!({"speed_rpm": 5793.0, "wear": {"at_s": null}});
        let text = format!(
            "# speeds\n{HEAD}\nA,speed_rpm,5799,6,\"a paper, page 3\"\nB,speed_rpm,5799,5.9,\nC,wear.at_s,1,1,x\n"
        );
        let all: Vec<_> = figures(&text).unwrap().iter().map(|f| beside(f, &summary).unwrap()).collect();
        assert_eq!(all.iter().map(|c| c.met).collect::<Vec<_>>(), [true, false, false]);
        assert_eq!((all[0].source.as_str(), all[2].computed), ("a paper, page 3", None));
    }

    #[test]
    fn limit_fields_may_be_quoted_and_a_byte_order_mark_stand_in_front() {
        let text = format!(
            "\u{feff}{HEAD}\r\n\"A, \"\"first\"\"\",speed_rpm,\"5799\", \"6\" ,\"a paper, page 3\"\r\nB,x,1,2,a, b, c\r\n"
        );
        let all = figures(&text).unwrap();
        assert_eq!((all[0].id.as_str(), all[0].published, all[0].tolerance), ("A, \"first\"", 5799.0, 6.0));
        assert_eq!((all[0].source.as_str(), all[1].source.as_str()), ("a paper, page 3", "a, b, c"));
        let of = |row: &str| figures(&format!("{HEAD}\n{row}")).map(|_| ()).unwrap_err();
        assert_eq!((of("\"A,x,1,1,s").1, of("\"A\"x,x,1,1,s").1, of("\"A\",x,\"one\",1,s").1), (1, 4, 7));
        assert!(of(&format!("A,x,{},1,s", "9x".repeat(1000))).2.len() < 200);
    }

    #[test]
    fn limit_every_place_of_a_bad_file_is_named() {
        let of = |rows: &str| figures(&format!("{HEAD}\n{rows}")).map(|_| ()).unwrap_err();
        assert_eq!((of("A,x,12,1").0, of("A,x,12,1").1), (2, 1));
        assert_eq!((of("A,x,twelve,1,s").0, of("A,x,twelve,1,s").1), (2, 5));
        assert_eq!((of("A,x,12,-1,s").0, of("A,x,12,-1,s").1), (2, 8));
        assert_eq!(figures("").map(|_| ()).unwrap_err().0, 1);
        assert!(figures("name,value\n").map(|_| ()).unwrap_err().2.contains(HEAD));
        let figure = figure(2, "A,speed,1,1,s").unwrap();
        let (line, column, message) = beside(&figure, &serde_json::json!({})).unwrap_err();
        assert!((line, column) == (2, 3) && message.contains("speed"), "{message}");
    }
}
