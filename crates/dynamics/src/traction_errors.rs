//! How exact a run's tractions are: its patch rule, and the error of the linear traction between integrals.

use tribodyn_bearing::Scheme;
use tribodyn_traction::PatchChoice;

/// Error of the linear traction that a refresh may find, over the load. Most refreshes find two thirds of it and less,
/// and between them it is smaller.
pub(crate) const LINEAR_ERROR: f64 = 1e-3;
/// Error of a patch rule that does not show beside that of the linear traction, over it.
const RULE_OVER_LINEAR: f64 = 0.1;
/// Target at which the linear traction begins to be finer than [`LINEAR_ERROR`]. At a target of 1e-5, which is to carry
/// accelerations, it then errs by 1e-4, and a finer one changes those of the paper's case at 20 µs no more.
const FINEST_AT_FULL: f64 = 1e-4;
/// Accuracy below which the linear traction is finer than [`LINEAR_ERROR`], too: over 30 ms that leaves 8e-4 of the
/// mean torque of a 6206 in oil and 1.3e-3 of that of a 7210.
const ACCURATE_AT_FULL: f64 = 1e-3;
/// Accuracy that a given step counts as: the paper's case at 20 µs then errs no more than the Runge–Kutta method at 10
/// µs does, 4e-4 of the mean load.
const GIVEN_STEP: f64 = 1.4e-4;

/// Patch rule and linear error of a run. Those of the fast scheme come from the case's target and the accuracy asked
/// for: a rule much finer than the linear traction between its refreshes costs and brings nothing. Named rules are
/// taken as they are, and by the other schemes every rule is.
pub(crate) fn errors(scheme: Scheme, patch: PatchChoice) -> (PatchChoice, f64) {
    let asked = match scheme {
        Scheme::FastTo { accuracy } => accuracy,
        _ => GIVEN_STEP,
    };
    let full = LINEAR_ERROR * (asked / ACCURATE_AT_FULL).min(1.0);
    let (Scheme::Fast { .. } | Scheme::FastTo { .. }, PatchChoice::TargetError { relative }) = (scheme, patch) else {
        return (patch, full);
    };
    let linear = full.min(LINEAR_ERROR * (relative / FINEST_AT_FULL));
    (PatchChoice::TargetError { relative: relative.max(RULE_OVER_LINEAR * linear) }, linear)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_traction::PatchRule;

    #[test]
    fn limit_rule_and_linear_error_follow_the_target_together() {
        let fast = Scheme::Fast { step: 2e-5 };
        let to = |accuracy| Scheme::FastTo { accuracy };
        let of = |scheme, relative| match errors(scheme, PatchChoice::TargetError { relative }) {
            (PatchChoice::TargetError { relative }, linear) => [relative, linear],
            (PatchChoice::Named(rule), _) => unreachable!("{rule:?} for a target"),
        };
        let close =
            |a: [f64; 2], b: [f64; 2]| assert!(a.iter().zip(b).all(|(a, b)| (a / b - 1.0).abs() < 1e-12), "{a:?}");
        for target in [1e-3, 1e-4] {
            close(of(to(1e-3), target), [target, LINEAR_ERROR]);
            close(of(fast, target), [target, 0.14 * LINEAR_ERROR]);
        }
        // The finer of what target and accuracy ask for, not finer still.
        for scheme in [fast, to(1e-3), to(1e-4)] {
            close(of(scheme, 1e-5), [1e-5, 0.1 * LINEAR_ERROR]);
        }
        let named = PatchChoice::Named(PatchRule::SplitStrip { across: 5, along: 3 });
        let (kept, linear) = errors(fast, named);
        assert!(kept == named && (linear / LINEAR_ERROR - 0.14).abs() < 1e-12, "{kept:?} {linear}");
        assert_eq!(errors(to(1e-3), named), (named, LINEAR_ERROR));
        assert!((errors(to(1e-4), named).1 / LINEAR_ERROR - 0.1).abs() < 1e-12);
        let fine = PatchChoice::TargetError { relative: 1e-6 };
        assert_eq!(errors(Scheme::RungeKutta4 { step: 1e-5 }, fine).0, fine);
    }
}
