//! Readings of the paper weighed against each other: each fitted on its own, with its evidence, and with the rows of
//! Figures 13 to 24 that the fitted set meets.

mod adapt;
mod document;
mod fitted;
mod steady;

pub use document::{outdated, rewrite};

use crate::error::PaperError;
use crate::files;
use crate::progress::{Progress, in_time};
use fitted::fit;
use tribodyn_identify::{Problem, Relation};

/// File of the committed result.
const RESULT: &str = "fixtures/expected/hypotheses.csv";
const HEAD: &str = "data,hypothesis,squares,of_data,ln_evidence,bounds,worst_speed,worst_pressure,view_steady,\
    kept_steady,view,kept,d_m,values";

/// The hypothesis whose figures have a set of their own; it is in the last group.
const APART: &str = "two sets: tables and figures apart";

/// Hypotheses with the same data, whose evidence can be compared.
struct Group {
    /// Short name, in the result.
    name: &'static str,
    /// Problem file, relative to the workspace.
    file: &'static str,
    /// Standard uncertainty of a speed in r/min and a pressure in GPa, instead of those of the file.
    rounding: Option<[f64; 2]>,
    /// Parts of the names of the hypotheses that are fitted; all without any.
    only: &'static [&'static str],
}

const GROUPS: [Group; 3] = [
    Group { name: "tables", file: "fixtures/identify/paper-weighed.ron", rounding: None, only: &[] },
    Group {
        name: "tables at their last digit",
        file: "fixtures/identify/paper-weighed.ron",
        rounding: Some([0.4, 0.004]),
        only: &["authors: ", "classical: ", "printed sign", "no gyroscopic"],
    },
    Group { name: "tables and figures", file: "fixtures/identify/paper-two-sets.ron", rounding: None, only: &[] },
];

impl Group {
    /// The problem with its case's text.
    fn read(&self) -> Result<(Problem, String), PaperError> {
        let path = files::root().join(self.file);
        let wrong = |source| PaperError::Identify { hypothesis: self.file.to_owned(), source: Box::new(source) };
        let mut problem = Problem::from_ron(&files::read(&path)?).map_err(wrong)?;
        if let Some([speed, pressure]) = self.rounding {
            for datum in problem.data.iter_mut().filter(|d| d.relation == Relation::Value) {
                datum.uncertainty = if datum.quantity.unit() == "r/min" { speed } else { pressure };
            }
        }
        problem.hypotheses.retain(|h| self.only.is_empty() || self.only.iter().any(|part| h.name.contains(part)));
        let case = files::read(&path.with_file_name(&problem.case))?;
        Ok((problem, case))
    }
}

/// Fits all hypotheses, counts the rows that they meet, and writes the result; with `only`, the lines of those that do
/// not have it in their names stay.
///
/// # Errors
///
/// A problem or a result cannot be read, or the result not written. A fit that fails is noted in the result.
pub fn run(only: Option<&str>, progress: Progress) -> Result<(), PaperError> {
    let path = files::root().join(RESULT);
    let before = if only.is_some() { files::read(&path)? } else { String::new() };
    let mut lines = Vec::new();
    for group in &GROUPS {
        let (problem, case) = group.read()?;
        for hypothesis in &problem.hypotheses {
            let key = format!("{},{},", group.name, hypothesis.name);
            let kept = before.lines().find(|line| line.starts_with(&key));
            if let Some(line) = kept.filter(|_| only.is_some_and(|part| !hypothesis.name.contains(part))) {
                lines.push(line.to_owned());
                continue;
            }
            let found = in_time(&key, progress, || fit(&problem, &case, hypothesis, progress));
            let cells = found.unwrap_or_else(|reason| {
                progress(&format!("{key} {reason}"));
                fitted::nothing()
            });
            lines.push(format!("{key}{cells}"));
        }
    }
    let text = format!(
        "# our own output; rewritten by `cargo xtask hypotheses`\n# squares with priors and of the data; ln evidence \
        by Laplace's approximation, to be compared between lines of the same data; parameters at a bound; worst \
        deviation of Table 4 in percent and of Table 5 in GPa; rows of Figures 14 and 16 to 18, then of Figures 13 to \
        24, met by the fitted set, those that a search may see and those that are kept out\n{HEAD}\n{}\n",
        lines.join("\n")
    );
    files::write(&path, text.as_bytes())?;
    steady::run(progress)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;
    use tribodyn_identify::{Hypothesis, LeastSquares};

    fn committed() -> Table {
        Table::read(RESULT, &files::read(&files::root().join(RESULT)).unwrap()).unwrap()
    }

    /// A group's problem with its case and each hypothesis that is fitted.
    fn each(mut of: impl FnMut(&Group, &Problem, &str, &Hypothesis)) {
        for group in &GROUPS {
            let (problem, case) = group.read().unwrap();
            problem.hypotheses.iter().for_each(|hypothesis| of(group, &problem, &case, hypothesis));
        }
    }

    fn number(group: &str, hypothesis: &str, column: &str) -> f64 {
        let table = committed();
        let mut rows = table.rows().filter(|row| row.first() == group);
        rows.find(|row| row.text("hypothesis").unwrap() == hypothesis).unwrap().number(column).unwrap()
    }

    #[test]
    fn identity_every_hypothesis_can_be_fitted_and_has_a_line() {
        let mut count = 0;
        each(|group, problem, case, hypothesis| {
            LeastSquares::new(problem, case, Some(hypothesis)).unwrap();
            let table = committed();
            let mut rows = table.rows().filter(|row| row.first() == group.name);
            assert!(rows.any(|row| row.text("hypothesis").unwrap() == hypothesis.name), "{}", hypothesis.name);
            assert!(!hypothesis.name.contains(','), "{}", hypothesis.name);
            count += 1;
        });
        assert_eq!(committed().rows().count(), count);
    }

    /// The committed values of some hypotheses, solved again, give the committed squares.
    #[test]
    fn regress_committed_values_give_their_squares() {
        let some = ["authors; slip in percent of rolling", "authors; Eq. 5 with absolute speeds", APART];
        let mut count = 0;
        each(|group, problem, case, hypothesis| {
            if !some.contains(&hypothesis.name.as_str()) {
                return;
            }
            let mut squares = LeastSquares::new(problem, case, Some(hypothesis)).unwrap();
            squares.model.adapt = adapt::named(&hypothesis.name);
            let table = committed();
            let mut rows = table.rows().filter(|row| row.first() == group.name);
            let row = rows.find(|row| row.text("hypothesis").unwrap() == hypothesis.name).unwrap();
            let values: Vec<f64> = row.text("values").unwrap().split(' ').map(|value| value.parse().unwrap()).collect();
            let at = squares.parameters().zip(&values).map(|(parameter, value)| parameter.coordinate(*value));
            let at: Vec<f64> = at.collect();
            let cost = squares.point(at.into(), None).unwrap().cost();
            let expected = row.number("squares").unwrap();
            assert!((cost - expected).abs() < 0.06 + 0.01 * expected, "{}: {cost} and {expected}", hypothesis.name);
            count += 1;
        });
        assert_eq!(count, some.len());
    }

    /// One set is two sets that are alike: its squares cannot be fewer.
    #[test]
    fn identity_two_sets_leave_no_more_squares_than_one() {
        let squares = |name: &str| number("tables and figures", name, "squares");
        assert!(squares(APART) <= squares("one set for tables and figures"));
    }
}
