//! The weight of a row: in how many of the changes of the sensitivity study it is missed, and in how many draws of all
//! unprinted values from their priors. A row that is missed in none of them says little when it is met.

use super::row::{Evidence, Row, Verdict, Weight};
use crate::error::PaperError;
use crate::files;
use crate::table::Table;

/// Rows of Figures 13 to 24 with one thing changed in all runs of the authors' reading.
const CHANGES: &str = "sensitivity-rows-authors.csv";
/// Rows of Figures 13 to 24 that are missed with all unprinted values drawn from their priors.
pub const DRAWS: &str = "prior-draws.csv";
/// Name of the line without a change.
const UNCHANGED: &str = "as identified";

/// Gives each row of Figures 13 to 24 its weight.
pub fn weighed(rows: Vec<Row>) -> Result<Vec<Row>, PaperError> {
    let read = |name: &str| Table::read(name, &files::read(&super::expected::folder().join(name))?);
    from_tables(rows, &read(CHANGES)?, &read(DRAWS)?)
}

fn from_tables(mut rows: Vec<Row>, table: &Table, draws: &Table) -> Result<Vec<Row>, PaperError> {
    for row in rows.iter_mut().filter(|row| row.of_figures() && row.evidence != Evidence::Beside) {
        let mut weight = Weight { missed: 0, changes: 0, missed_in_draws: 0, draws: 0 };
        for line in draws.rows() {
            let missed = line.text("missed")?;
            if missed != "–" {
                weight.missed_in_draws += usize::from(missed.split(' ').any(|id| id == row.id));
                weight.draws += 1;
            }
        }
        // Of a row that stands for a pair of claims, no change decides.
        for line in table.rows().filter(|line| line.first() != UNCHANGED) {
            let lost = line.text("lost")?;
            if lost == "–" {
                continue;
            }
            let missed = match table.columns().contains(&row.id) {
                true => !line.text(&row.id)?.ends_with('*'),
                false => lost.split(' ').any(|id| id == row.id),
            };
            weight.missed += usize::from(missed);
            weight.changes += 1;
        }
        row.weight = Some(weight).filter(|_| matches!(row.verdict, Verdict::Met | Verdict::Missed));
    }
    Ok(rows)
}

/// Sentence on how many of the rows kept out of the search are met, beside the averages over changes and draws; none
/// without weights.
pub fn null(rows: &[Row]) -> Option<String> {
    let kept = || {
        let validation = rows.iter().filter(|row| row.evidence == Evidence::Validation);
        validation.filter_map(|row| Some((row.weight?, row.verdict == Verdict::Met)))
    };
    let changes = kept().map(|(weight, _)| weight.changes).max()?;
    let met = |(weight, _): (Weight, bool)| 1.0 - weight.missed as f64 / weight.changes.max(1) as f64;
    let expected: f64 = kept().map(met).sum();
    let ours = kept().filter(|(_, met)| *met).count();
    let sure = kept().filter(|(weight, _)| weight.missed == 0).count();
    let hopeless = kept().filter(|(weight, _)| weight.missed == weight.changes).count();
    let open = || kept().filter(|(weight, _)| weight.missed > 0 && weight.missed < weight.changes);
    let open_expected: f64 = open().map(met).sum();
    let draws = kept().map(|(weight, _)| weight.draws).max()?;
    let drawn = |(weight, _): (Weight, bool)| 1.0 - weight.missed_in_draws as f64 / weight.draws.max(1) as f64;
    let of_draws: f64 = kept().map(drawn).sum();
    Some(format!(
        "Of the {} claims of Figures 13 to 24 among them {ours} are met; with one thing changed, {changes} times, \
        {expected:.1} are met on the average. {sure} of the {} fail in no change and {hopeless} in every one: those \
        rows tell little. Of the {} between, {} are met, {open_expected:.1} with one thing changed. With all that the \
        paper does not print drawn from its priors, {draws} times, {of_draws:.1} of the {} are met on the average",
        kept().count(),
        kept().count(),
        open().count(),
        open().filter(|(_, met)| *met).count(),
        kept().count(),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_weight_counts_changes_in_which_a_row_is_missed() {
        let text = "change,lost,F17.1\nas identified,none,1\nfirst,F18.2 F20.1.load,2*\nsecond,F18.2,1\nfailed,–,–\n";
        let row = |id: &str, met: bool| Row {
            evidence: Evidence::Validation,
            ..Row::number(id.into(), String::new(), [1.0, if met { 1.0 } else { 2.0 }, 0.1])
        };
        let rows = vec![row("F17.1", false), row("F18.2", true), row("F21.1", true), row("T4.1", true)];
        let draws = "draw,missed\ndraw 0,F17.1 F18.2\ndraw 1,–\ndraw 2,none\ndraw 3,F18.2\n";
        let read = |text| Table::read("t", text).unwrap();
        let rows = from_tables(rows, &read(text), &read(draws)).unwrap();
        let weight = |missed, missed_in_draws| Some(Weight { missed, changes: 2, missed_in_draws, draws: 3 });
        let found: Vec<_> = rows.iter().map(|row| row.weight).collect();
        assert_eq!(found, [weight(1, 1), weight(2, 2), weight(0, 0), None]);
        let sentence = null(&rows).unwrap();
        assert!(sentence.starts_with("Of the 3 claims of Figures 13 to 24 among them 2 are met"), "{sentence}");
        assert!(
            sentence.contains("1.5 are met on the average. 1 of the 3 fail in no change and 1 in every"),
            "{sentence}"
        );
        assert!(sentence.contains("Of the 1 between, 0 are met, 0.5 with one thing changed. "), "{sentence}");
        assert!(sentence.ends_with("3 times, 2.0 of the 3 are met on the average"), "{sentence}");
        assert_eq!(null(&rows[3..]), None);
    }
}
