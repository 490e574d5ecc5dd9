//! Check that the work of a run balances, with the likely cause where it does not.
//!
//! Drives, loads, friction, drag, dampers, pockets, the cage, stored energy and what wear takes out of the contacts are
//! all counted. What is left over is the scheme's, or that of a choice of model whose forces and powers do not belong
//! together.

use tribodyn_bearing::Scheme;
use tribodyn_case::Case;

/// Part of the work put in, %, beyond which a run is warned of. Below their bound explicit schemes leave some 10⁻⁷ %;
/// the fast one leaves up to 0.1 % at the steps that it is meant for.
const OFF_BALANCE_EXPLICIT_PERCENT: f64 = 1e-3;
const OFF_BALANCE_FAST_PERCENT: f64 = 1.0;

/// Judgement on the balance of a run's work.
#[derive(Debug, Clone, PartialEq)]
pub enum Judgement {
    /// Within what the scheme leaves.
    Balanced,
    /// Off, with the most likely reason.
    Off {
        /// Missing work and its cause, a sentence.
        reason: String,
        /// True if a choice of model and not the length of the steps is to blame.
        by_model: bool,
    },
}

/// An imbalance of work for people, %.
pub fn imbalance(percent: f64) -> String {
    if percent.abs() < 1e-3 { format!("{percent:.1e}") } else { format!("{percent:.4}") }
}

/// Judges the work missing at the end of a run over all work put in, %. A run that put no work in has nothing to miss.
pub fn judge(imbalance_percent: f64, case: &Case) -> Judgement {
    let Some(transient) = case.transient.as_ref() else { return Judgement::Balanced };
    let most = match transient.scheme {
        Scheme::Fast { .. } | Scheme::FastTo { .. } => OFF_BALANCE_FAST_PERCENT,
        _ => OFF_BALANCE_EXPLICIT_PERCENT,
    };
    // What is not a number is off as well.
    if imbalance_percent.abs() <= most {
        return Judgement::Balanced;
    }
    let choices = choices_without_balance(case);
    let because = if choices.is_empty() {
        by_steps(transient.scheme, transient.wear_acceleration)
    } else {
        format!(
            "{}; so the powers of this run hold to about that, and shorter steps do not change it",
            choices.join(", and ")
        )
    };
    let missing = imbalance(imbalance_percent.abs());
    Judgement::Off {
        reason: format!("{missing} % of the work put in is not accounted for at the end: {because}"),
        by_model: !choices.is_empty(),
    }
}

/// Choices of the case whose forces and powers do not belong together.
fn choices_without_balance(case: &Case) -> Vec<&'static str> {
    let mut choices = Vec::new();
    if case.modelling.contact_at_actual_angle {
        choices
            .push("contact constants that follow the contact angle (contact_at_actual_angle: true) have no potential");
    }
    choices
}

/// The blame where all forces have their power: the scheme, with what helps.
fn by_steps(scheme: Scheme, wear_acceleration: f64) -> String {
    let wear = if wear_acceleration > 1.0 {
        format!(
            "; wear {wear_acceleration:.0e} times as fast as it is moves the races within a step, so lower that too"
        )
    } else {
        String::new()
    };
    let steps = match scheme {
        Scheme::DormandPrince { tolerance, .. } => format!(
            "the tolerance of {tolerance:.0e} is too coarse for this run, and its powers and accelerations may be wrong; lower it"
        ),
        Scheme::Fast { .. } => by_sums("the steps are too long", "shorter steps"),
        Scheme::FastTo { accuracy } => {
            by_sums(&format!("the accuracy of {accuracy:.0e} is too coarse"), "a smaller one")
        }
        _ => "the steps are too long for this run, and its powers and accelerations may be wrong; shorten them or take another scheme".to_owned(),
    };
    steps + &wear
}

/// The blame of the fast scheme, which sums work over samples: it is not always the steps.
fn by_sums(coarse: &str, finer: &str) -> String {
    format!(
        "balls that begin beside their orbit, or strike, settle within a step, which the fast scheme's sum of work \
         misses; if they do neither, {coarse}, and powers and accelerations may be wrong: compare with {finer} or \
         another scheme"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_case::set_value;

    /// Reason and whether the model is to blame.
    fn judged(percent: f64, changes: &[(&str, &str)]) -> Option<(String, bool)> {
        let text = include_str!("../../../../fixtures/cases/paper-ag-worn.ron").to_owned();
        let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
        match judge(percent, &Case::from_ron(&text).unwrap()) {
            Judgement::Balanced => None,
            Judgement::Off { reason, by_model } => Some((reason, by_model)),
        }
    }

    #[test]
    fn limit_wear_does_not_silence_the_balance() {
        let (reason, by_model) = judged(104.0, &[("transient.wear_acceleration", "1e4")]).unwrap();
        assert!(reason.starts_with("104.0000 % of the work") && reason.contains("wear 1e4 times"), "{reason}");
        assert!(!by_model);
        assert_eq!(judged(0.0, &[("transient.wear_acceleration", "1e4")]), None);
    }

    #[test]
    fn limit_a_choice_of_model_is_named_and_not_the_step() {
        let angle = ("modelling.contact_at_actual_angle", "true");
        let (reason, by_model) = judged(3.0, &[angle]).unwrap();
        assert!(by_model && reason.contains("contact_at_actual_angle") && !reason.contains("too long"), "{reason}");
    }

    #[test]
    fn limit_each_scheme_has_its_own_advice_and_limit() {
        let fast = ("transient.scheme", "Fast(step: us(5))");
        assert_eq!(judged(0.9, &[fast]), None);
        assert!(judged(-1.1, &[fast]).unwrap().0.contains("steps are too long"));
        let by_accuracy = ("transient.scheme", "FastTo(accuracy: 0.001)");
        assert!(judged(2.0, &[by_accuracy]).unwrap().0.contains("accuracy of 1e-3 is too coarse"));
        assert!(judged(0.002, &[]).unwrap().0.contains("tolerance of 1e-6"));
        assert!(judged(f64::NAN, &[fast]).is_some() && judged(f64::INFINITY, &[]).is_some());
    }
}
