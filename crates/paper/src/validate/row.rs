//! One row of the validation table.

use serde::Serialize;

/// Kind of evidence of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Evidence {
    /// The case's unpublished parameters are chosen with this figure in view: agreement shows that they can be.
    Calibration,
    /// The equations give back what follows from their own input.
    Verification,
    /// No parameter was chosen with this figure in view.
    Validation,
    /// Not a claim of the paper, or one that is counted already: shown, not counted.
    Beside,
}

impl Evidence {
    pub fn name(self) -> &'static str {
        match self {
            Self::Calibration => "calibration",
            Self::Verification => "verification",
            Self::Validation => "validation",
            Self::Beside => "beside",
        }
    }
}

/// Verdict of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    Met,
    Missed,
    /// Claims of the paper exclude each other: no result decides.
    Contradictory,
    NotYet,
}

impl Verdict {
    pub const ALL: [Self; 4] = [Self::Met, Self::Missed, Self::Contradictory, Self::NotYet];

    pub fn name(self) -> &'static str {
        match self {
            Self::Met => "met",
            Self::Missed => "missed",
            Self::Contradictory => "contradictory",
            Self::NotYet => "not-yet",
        }
    }
}

/// Statement of the paper: a number, or a sentence.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Stated {
    Number(f64),
    Text(&'static str),
}

/// In how many changes a row is missed, of those whose runs were solved, and in how many draws from the priors.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Weight {
    pub missed: usize,
    pub changes: usize,
    pub missed_in_draws: usize,
    pub draws: usize,
}

/// Published against computed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    pub id: String,
    pub evidence: Evidence,
    /// Compared quantity, in words.
    pub quantity: String,
    pub published: Stated,
    pub computed: Option<f64>,
    pub unit: &'static str,
    pub deviation: Option<f64>,
    /// Allowed deviation, in the row's unit; none for orders and shapes, whose limit is in the note.
    pub tolerance: Option<f64>,
    pub verdict: Verdict,
    pub note: String,
    /// In how many changes of the sensitivity study, and draws from the priors, the row is missed; absent where that
    /// was not studied.
    pub weight: Option<Weight>,
    /// Decimals worth printing.
    #[serde(skip)]
    pub decimals: usize,
}

/// A claim that is an order or a shape.
pub struct Claim {
    pub id: &'static str,
    pub evidence: Evidence,
    pub text: &'static str,
    /// The quantity that decides.
    pub measured: &'static str,
    pub unit: &'static str,
}

impl Row {
    /// A number with an absolute tolerance.
    pub fn number(id: String, quantity: String, [published, computed, tolerance]: [f64; 3]) -> Self {
        let deviation = computed - published;
        Self {
            id,
            evidence: Evidence::Calibration,
            quantity,
            published: Stated::Number(published),
            computed: Some(computed),
            unit: "",
            deviation: Some(deviation),
            tolerance: Some(tolerance),
            verdict: if deviation.abs() <= tolerance { Verdict::Met } else { Verdict::Missed },
            note: String::new(),
            weight: None,
            decimals: 3,
        }
    }

    /// An order or shape that a measured quantity decides.
    pub fn claim(claim: &Claim, computed: f64, met: bool, note: String) -> Self {
        Self {
            id: claim.id.to_owned(),
            evidence: claim.evidence,
            quantity: claim.measured.to_owned(),
            published: Stated::Text(claim.text),
            computed: Some(computed).filter(|c| c.is_finite()),
            unit: claim.unit,
            deviation: None,
            tolerance: None,
            verdict: if met && computed.is_finite() { Verdict::Met } else { Verdict::Missed },
            note,
            weight: None,
            decimals: 3,
        }
    }

    /// True of the claims of Figures 13 to 24.
    pub fn of_figures(&self) -> bool {
        let number = self.id.strip_prefix('F').and_then(|rest| rest.split('.').next()).and_then(|n| n.parse().ok());
        number.is_some_and(|n: u32| (13..=24).contains(&n))
    }

    pub fn published_text(&self) -> String {
        match &self.published {
            Stated::Number(value) => format!("{value:.0$}", self.published_decimals()),
            Stated::Text(text) => (*text).to_owned(),
        }
    }

    /// Published numbers are printed no finer than the paper has them: cage speeds are whole numbers.
    fn published_decimals(&self) -> usize {
        match self.unit {
            "r/min" => 0,
            "GPa" | "%" => 2,
            _ => self.decimals,
        }
    }

    pub fn computed_text(&self) -> String {
        self.computed.map_or("–".to_owned(), |value| format!("{value:.0$}", self.decimals))
    }

    /// Deviation; what is far below the tolerance depends on the machine's last bits and is not printed.
    pub fn deviation_text(&self) -> String {
        match (self.deviation, self.tolerance) {
            (Some(d), Some(t)) if d.abs() < 1e-3 * t => "≈ 0".to_owned(),
            (Some(d), Some(t)) if t < 1e-6 => format!("{d:+.1e}"),
            (Some(d), _) => format!("{d:+.0$}", self.decimals),
            (None, _) => "–".to_owned(),
        }
    }

    /// `12 of 73`.
    pub fn weight_text(&self) -> String {
        self.weight.map_or("–".to_owned(), |w| format!("{} of {}", w.missed, w.changes))
    }

    pub fn draws_text(&self) -> String {
        self.weight.map_or("–".to_owned(), |w| format!("{} of {}", w.missed_in_draws, w.draws))
    }

    pub fn tolerance_text(&self) -> String {
        match self.tolerance {
            Some(t) if t < 1e-6 => format!("{t:.1e}"),
            Some(t) => format!("{t:.0$}", self.decimals),
            None => "–".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_a_number_is_met_up_to_its_tolerance_on_both_sides() {
        let verdict = |computed| Row::number(String::new(), String::new(), [10.0, computed, 0.5]).verdict;
        assert_eq!([9.5, 10.5].map(verdict), [Verdict::Met; 2]);
        assert_eq!([9.49, 10.51, f64::NAN].map(verdict), [Verdict::Missed; 3]);
    }

    #[test]
    fn limit_a_claim_without_a_finite_measure_is_missed() {
        let claim = Claim { id: "x", evidence: Evidence::Validation, text: "rises", measured: "ratio", unit: "" };
        let row = Row::claim(&claim, f64::INFINITY, true, String::new());
        assert_eq!((row.verdict, row.computed), (Verdict::Missed, None));
        assert_eq!(Row::claim(&claim, 2.0, true, String::new()).verdict, Verdict::Met);
        assert_eq!(Row::claim(&claim, 2.0, false, String::new()).verdict, Verdict::Missed);
    }
}
