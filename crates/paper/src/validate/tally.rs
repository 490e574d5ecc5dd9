//! Counts of rows of Figures 13 to 24.

use super::pairs;
use super::row::{Evidence, Row, Verdict};

/// Rows of Figures 13 to 24 that are met, of so many; claims that exclude each other are left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tally {
    /// Of those that the search may see.
    pub view: Share,
    /// Of those that are kept out of it.
    pub kept: Share,
}

/// A count of so many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share(pub usize, pub usize);

impl std::fmt::Display for Share {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} of {}", self.0, self.1)
    }
}

impl Tally {
    pub fn of(rows: Vec<Row>) -> Self {
        let rows = pairs::joined(rows);
        let share = |evidence: Evidence| {
            let part = || rows.iter().filter(|row| row.of_figures() && row.evidence == evidence);
            let open = part().filter(|row| matches!(row.verdict, Verdict::Met | Verdict::Missed)).count();
            Share(part().filter(|row| row.verdict == Verdict::Met).count(), open)
        };
        Self { view: share(Evidence::Calibration), kept: share(Evidence::Validation) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_claims_that_exclude_each_other_are_not_counted() {
        let row = |id: &str, evidence, computed| Row {
            evidence,
            ..Row::number(id.to_owned(), String::new(), [1.0, computed, 0.1])
        };
        let (view, kept) = (Evidence::Calibration, Evidence::Validation);
        let rows = vec![
            row("F14.3", view, 1.0),
            row("F16.2", view, 2.0),
            row("F22.1.text", view, 1.0),
            row("F22.1.conclusion", view, 2.0),
            row("F18.2", kept, 1.0),
            row("T4.1", view, 1.0),
        ];
        assert_eq!(Tally::of(rows), Tally { view: Share(1, 2), kept: Share(1, 1) });
        assert_eq!(Share(1, 2).to_string(), "1 of 2");
    }
}
