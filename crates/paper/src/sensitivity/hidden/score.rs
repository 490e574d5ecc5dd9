//! How well a set meets the dynamic rows that the search may see.

use crate::error::PaperError;
use crate::validate::{Evidence, Row, Verdict};
use std::cmp::Ordering;

/// Rows met, and how near all of them are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Score {
    pub met: usize,
    /// Sum of a part of one for each row: one on its value, a half at its limit, next to nothing far from it. A count
    /// without steps, which a search can follow where the count stands still.
    pub near: f64,
}

/// Rows that are orders or shapes: their limit, and how far from it they are as good as met or missed. The widths are
/// the validation's tolerances: 0.1 % of speeds and their ratios, 25 % of accelerations; for a time half of its limit.
const ORDERS: [(&str, f64, f64); 6] = [
    ("F13.1.test", 0.48, 0.1),
    ("F13.2.settling", 0.1, 0.05),
    ("F22.1.text", 1.0, 0.25),
    ("F22.1.conclusion", 1.0, 0.25),
    ("F22.2", 1.0, 0.001),
    ("F22.4", 1.0, 0.25),
];

impl Score {
    /// Of the rows among these that the search may see.
    ///
    /// # Errors
    ///
    /// An order that has no limit here.
    pub fn of(rows: &[Row]) -> Result<Self, PaperError> {
        let mut score = Self { met: 0, near: 0.0 };
        for row in rows.iter().filter(|row| row.evidence == Evidence::Calibration) {
            score.met += usize::from(row.verdict == Verdict::Met);
            let off = off(row)?;
            // A row with nothing to measure is as far off as can be.
            score.near += if off.is_finite() { 1.0 / (1.0 + off.powi(3)) } else { 0.0 };
        }
        Ok(score)
    }

    /// The lower count and the lower nearness of two scores.
    pub fn worse(&self, other: &Self) -> Self {
        Self { met: self.met.min(other.met), near: self.near.min(other.near) }
    }

    /// The set with most rows first, with the nearest of those first.
    pub fn decide(&self, other: &Self) -> Ordering {
        other.met.cmp(&self.met).then(other.near.total_cmp(&self.near))
    }

    /// The set to go on from first: both count, as a row that is just met may be missed next door.
    pub fn lead(&self, other: &Self) -> Ordering {
        let sum = |score: &Self| score.met as f64 + score.near;
        sum(other).total_cmp(&sum(self))
    }
}

/// Distance from a row's value, 1 at its limit.
fn off(row: &Row) -> Result<f64, PaperError> {
    if let (Some(deviation), Some(tolerance)) = (row.deviation, row.tolerance) {
        return Ok((deviation / tolerance).abs());
    }
    let found = ORDERS.iter().find(|(id, ..)| *id == row.id);
    let (_, limit, width) = found.ok_or_else(|| PaperError::Check {
        what: "search for hidden values",
        findings: vec![format!("{}: no limit of this order is known", row.id)],
    })?;
    let margin = row.computed.map_or(f64::INFINITY, |computed| (computed - limit).abs() / width);
    Ok(if row.verdict == Verdict::Met { (1.0 - margin).max(0.0) } else { 1.0 + margin })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(id: &str, computed: f64, met: bool) -> Row {
        Row {
            computed: Some(computed).filter(|value| value.is_finite()),
            deviation: None,
            tolerance: None,
            verdict: if met { Verdict::Met } else { Verdict::Missed },
            ..Row::number(id.to_owned(), String::new(), [0.0; 3])
        }
    }

    #[test]
    fn limit_a_row_at_its_limit_counts_half() {
        let near = |row: Row| Score::of(&[row]).unwrap().near;
        let number = |computed| Row::number(String::new(), String::new(), [10.0, computed, 2.0]);
        assert_eq!([10.0, 12.0, 8.0].map(|computed| near(number(computed))), [1.0, 0.5, 0.5]);
        assert!(near(number(11.0)) > 0.8 && near(number(14.0)) < 0.2 && near(number(f64::NAN)) == 0.0);
        assert_eq!(near(order("F22.2", 1.0, true)), 0.5);
        assert_eq!(near(order("F22.2", 1.001, true)), 1.0);
        assert!((near(order("F22.4", 0.75, false)) - 1.0 / 9.0).abs() < 1e-12);
        assert_eq!(near(order("F22.4", f64::NAN, false)), 0.0);
    }

    #[test]
    fn limit_rows_that_are_kept_out_do_not_count_and_unknown_orders_are_refused() {
        let hidden = Row { evidence: Evidence::Validation, ..order("F23.1.load", 1.0, true) };
        assert_eq!(Score::of(std::slice::from_ref(&hidden)).unwrap(), Score { met: 0, near: 0.0 });
        assert!(Score::of(&[Row { evidence: Evidence::Calibration, ..hidden }]).is_err());
    }

    #[test]
    fn identity_the_count_decides_and_both_lead() {
        let [lucky, sound] = [Score { met: 9, near: 7.0 }, Score { met: 8, near: 8.5 }];
        assert_eq!(lucky.decide(&sound), Ordering::Less);
        assert_eq!(lucky.lead(&sound), Ordering::Greater);
        assert_eq!(lucky.worse(&sound), Score { met: 8, near: 7.0 });
    }
}
