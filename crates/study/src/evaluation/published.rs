//! Published or measured figures beside those of a run.

use crate::error::StudyError;
use serde::Serialize;
use serde_json::Value;
use std::fs;
use std::path::Path;

const HEAD: &str = "id,quantity,published,tolerance,source";

/// A figure of the file.
struct Figure<'a> {
    id: &'a str,
    quantity: &'a str,
    published: f64,
    tolerance: f64,
    source: &'a str,
    line: usize,
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
    /// Whether the deviation is within the tolerance.
    pub met: bool,
    /// Where the value is published.
    pub source: String,
}

/// The figures of a CSV file beside the fields of `summary`.
///
/// # Errors
/// The file cannot be read, or a figure is refused with its line and column.
pub fn compared(path: &Path, summary: &Value) -> Result<Vec<Compared>, StudyError> {
    let text = fs::read_to_string(path).map_err(|source| StudyError::Read { path: path.to_owned(), source })?;
    let refused = |(line, column, message)| StudyError::Figures { path: path.to_owned(), line, column, message };
    let figures = figures(&text).map_err(refused)?;
    figures.iter().map(|figure| beside(figure, summary).map_err(refused)).collect()
}

/// Line and column, from 1, and what is wrong there.
type Refused = (usize, usize, String);

fn figures(text: &str) -> Result<Vec<Figure<'_>>, Refused> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    match lines.next() {
        Some((_, HEAD)) => {}
        Some((at, line)) => return Err((at + 1, 1, format!("the columns are `{line}`: they must be `{HEAD}`"))),
        None => return Err((1, 1, format!("the file is empty: its first line must be `{HEAD}`"))),
    }
    lines.map(|(at, line)| figure(at + 1, line)).collect()
}

fn figure(line: usize, text: &str) -> Result<Figure<'_>, Refused> {
    // The source may have commas of its own.
    let cells: Vec<&str> = text.splitn(5, ',').collect();
    let &[id, quantity, _, tolerance, source] = cells.as_slice() else {
        return Err((line, 1, format!("`{text}` has {} columns: there must be 5, `{HEAD}`", cells.len())));
    };
    let column = |cell: usize| 1 + cells[..cell].iter().map(|c| c.chars().count() + 1).sum::<usize>();
    let number = |cell: usize, name: &str| {
        let value = cells[cell].trim().parse().ok().filter(|v: &f64| v.is_finite());
        value.ok_or_else(|| (line, column(cell), format!("{name} = `{}`: must be a finite number", cells[cell])))
    };
    let (value, allowed) = (number(2, "published")?, number(3, "tolerance")?);
    if allowed < 0.0 {
        return Err((line, column(3), format!("tolerance = `{tolerance}`: must be 0 or greater")));
    }
    Ok(Figure {
        id: id.trim(),
        quantity: quantity.trim(),
        published: value,
        tolerance: allowed,
        source: source.trim().trim_matches('"'),
        line,
    })
}

fn beside(figure: &Figure, summary: &Value) -> Result<Compared, Refused> {
    let found = figure.quantity.split('.').try_fold(summary, |level, key| level.get(key));
    let computed = match found {
        Some(Value::Number(number)) => number.as_f64(),
        Some(Value::Null) => None,
        _ => {
            let column = figure.id.chars().count() + 2;
            let message = format!(
                "quantity = `{}`: must be a number of summary.json, such as cage_speed_mean_rpm or frequencies.ball_pass_outer_hz",
                figure.quantity
            );
            return Err((figure.line, column, message));
        }
    };
    Ok(Compared {
        id: figure.id.to_owned(),
        quantity: figure.quantity.to_owned(),
        published: figure.published,
        computed,
        tolerance: figure.tolerance,
        met: computed.is_some_and(|value| (value - figure.published).abs() <= figure.tolerance),
        source: figure.source.to_owned(),
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
