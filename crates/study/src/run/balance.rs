//! Whether the work of a run balances, and what is to blame where it does not.

use tribodyn_case::{Case, SchemeSpec};

/// Part of the work put in, %, beyond which a run is warned of. Below their bound explicit schemes leave some 10⁻⁷ %;
/// the fast one leaves up to 0.1 % at the steps that it is meant for.
const OFF_BALANCE_EXPLICIT_PERCENT: f64 = 1e-3;
const OFF_BALANCE_FAST_PERCENT: f64 = 1.0;

/// What the balance of a run's work says.
#[derive(Debug, Clone, PartialEq)]
pub enum Judgement {
    /// Within what the scheme leaves.
    Balanced,
    /// Off, with the most likely reason, a sentence.
    Off {
        /// What is missing, and why.
        reason: String,
    },
}

/// An imbalance of work for people, %.
pub fn imbalance(percent: f64) -> String {
    if percent.abs() < 1e-3 { format!("{percent:.1e}") } else { format!("{percent:.4}") }
}

/// Judges the work missing at the end of a run over all work put in, %.
pub fn judge(imbalance_percent: f64, case: &Case) -> Judgement {
    let Some(transient) = case.transient.as_ref() else { return Judgement::Balanced };
    // Wear takes energy out of the contacts, and contact constants that follow the angle have no potential: neither is
    // in the balance.
    if transient.wear_acceleration > 0.0 || case.numerics.contact_at_actual_angle {
        return Judgement::Balanced;
    }
    let most = match transient.scheme {
        SchemeSpec::Fast { .. } => OFF_BALANCE_FAST_PERCENT,
        _ => OFF_BALANCE_EXPLICIT_PERCENT,
    };
    if imbalance_percent.abs() <= most {
        return Judgement::Balanced;
    }
    let reason = format!(
        "{} % of the work put in is not accounted for at the end: the steps are too long for this run, and its powers and accelerations may be wrong; shorten them or take another scheme",
        imbalance(imbalance_percent.abs())
    );
    Judgement::Off { reason }
}
