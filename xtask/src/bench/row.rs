//! One measured quantity.

use serde::Serialize;

/// A line of the table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The group it belongs to.
    pub group: &'static str,
    pub quantity: String,
    /// None where it could not be measured; the note says why.
    pub value: Option<f64>,
    pub unit: &'static str,
    /// Bound that it must not fall below, or exceed.
    pub limit: Option<Limit>,
    pub met: Option<bool>,
    pub note: String,
}

/// A promise.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    AtLeast(f64),
    AtMost(f64),
}

impl Row {
    pub fn new(group: &'static str, quantity: impl Into<String>, value: f64, unit: &'static str) -> Self {
        let (limit, met, note) = (None, None, String::new());
        Self { group, quantity: quantity.into(), value: Some(value), unit, limit, met, note }
    }

    /// A quantity that could not be measured.
    pub fn skipped(group: &'static str, quantity: impl Into<String>, why: impl Into<String>) -> Self {
        Self { value: None, note: why.into(), ..Self::new(group, quantity, 0.0, "") }
    }

    pub fn must_be(mut self, limit: Limit) -> Self {
        self.limit = Some(limit);
        self.met = self.value.map(|value| match limit {
            Limit::AtLeast(least) => value >= least,
            Limit::AtMost(most) => value <= most,
        });
        self
    }

    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }
}

pub const HEAD: [&str; 6] = ["group", "quantity", "value", "limit", "verdict", "note"];

pub fn cells(rows: &[Row]) -> Vec<Vec<String>> {
    let one = |row: &Row| {
        let value = row.value.map_or_else(|| "–".to_owned(), |value| format!("{} {}", digits(value), row.unit));
        let limit = match row.limit {
            Some(Limit::AtLeast(least)) => format!("≥ {}", digits(least)),
            Some(Limit::AtMost(most)) => format!("≤ {}", digits(most)),
            None => String::new(),
        };
        let verdict = row.met.map_or("", |met| if met { "met" } else { "missed" });
        let cells = [row.group, &row.quantity, value.trim_end(), &limit, verdict, &row.note];
        cells.map(str::to_owned).to_vec()
    };
    rows.iter().map(one).collect()
}

/// Three digits.
fn digits(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if !(1e-3..1e5).contains(&size) {
        format!("{value:.2e}")
    } else {
        let decimals = (2 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.decimals$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_three_digits_are_kept_at_any_size() {
        let values = [0.0, 1.2345e-4, 0.01234, 1.2345, 123.45, 12345.0, 1.2345e6];
        assert_eq!(values.map(digits), ["0", "1.23e-4", "0.0123", "1.23", "123", "12345", "1.23e6"]);
    }

    #[test]
    fn identity_a_verdict_follows_from_value_and_limit() {
        let row = |value, limit| Row::new("g", "q", value, "s").must_be(limit).met;
        assert_eq!(row(2.0, Limit::AtLeast(2.0)), Some(true));
        assert_eq!(row(1.9, Limit::AtLeast(2.0)), Some(false));
        assert_eq!(row(2.1, Limit::AtMost(2.0)), Some(false));
        assert_eq!(Row::skipped("g", "q", "why").must_be(Limit::AtMost(2.0)).met, None);
    }
}
