//! Which claims of Figures 13 to 24 the search for the paper's readings had in view, as it was declared before.

use super::row::{Evidence, Row};
use crate::error::PaperError;
use crate::table::Table;

const SPLIT: &str = include_str!("../../../../fixtures/identify/split.csv");

/// Rows with calibration as the evidence of those that the search had in view.
pub fn declared(mut rows: Vec<Row>) -> Result<Vec<Row>, PaperError> {
    let table = Table::read("split.csv", SPLIT)?;
    for line in table.rows() {
        let (claim, part) = (line.text("claim")?, line.text("part")?);
        let evidence = match part {
            "calibration" => Evidence::Calibration,
            "validation" => Evidence::Validation,
            _ => return Err(line.fail(format!("`{part}` is neither calibration nor validation"))),
        };
        rows.iter_mut().filter(|row| row.id == claim).for_each(|row| row.evidence = evidence);
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_at_least_25_claims_were_kept_out_of_the_search() {
        let table = Table::read("split.csv", SPLIT).unwrap();
        let parts: Vec<_> = table.rows().map(|line| line.text("part").unwrap().to_owned()).collect();
        assert_eq!(parts.len(), 55);
        assert!(parts.iter().filter(|part| *part == "validation").count() >= 25);
    }

    #[test]
    fn identity_rows_take_the_part_that_was_declared() {
        let row = |id: &str| Row::number(id.into(), String::new(), [1.0; 3]);
        let rows = declared(vec![row("F18.2"), row("F16.2"), row("T4.1")]).unwrap();
        assert_eq!(rows[0].evidence, Evidence::Validation);
        assert_eq!(rows[1].evidence, Evidence::Calibration);
        assert_eq!(rows[2].evidence, Evidence::Calibration);
    }
}
