//! Errors of strips and cells, and their choice from a target.

use crate::contacts::{SCALES, contacts, silver};
use crate::steel;
use tribodyn_traction::{ElasticProbe, Fastsim, FastsimRule, TractionError, choose_fastsim_rule, fastsim_rule_error};

#[test]
fn identity_errors_fall_with_cells_and_strips() {
    let (law, elasticity) = (silver(), steel());
    for scale in SCALES {
        let contacts = contacts(scale);
        let probes: Vec<_> =
            contacts.iter().map(|c| ElasticProbe { contact: c.probe(&law), elasticity: &elasticity }).collect();
        let error = |across, cells| fastsim_rule_error(FastsimRule { across, cells }, &probes).unwrap();
        let errors = [8, 16, 32, 64].map(|cells| error(24, cells));
        println!("{scale}: cells {errors:?}, strips {:?}", [4, 6, 8, 12].map(|across| error(across, 64)));
        // At large slip scales the slip passes the curve's peak within the strips, and a kink travels over the cells.
        let order = (errors[0] / errors[3]).log2() / 3.0;
        assert!(order > if scale < 10.0 { 2.3 } else { 0.9 }, "{scale}: {errors:?}");
        assert!(errors[0] < 7e-4 && errors[3] < 1e-4, "{scale}: {errors:?}");
    }
}

#[test]
fn identity_chosen_rule_keeps_its_target() {
    let (law, elasticity) = (silver(), steel());
    for scale in [1.0, 100.0] {
        let contacts = contacts(scale);
        let probes: Vec<_> =
            contacts.iter().map(|c| ElasticProbe { contact: c.probe(&law), elasticity: &elasticity }).collect();
        let mut last = 0;
        for target in [1e-2, 1e-3, 1e-4] {
            let (rule, error) = choose_fastsim_rule(target, &probes).unwrap();
            println!("{scale} {target:e}: {rule:?} {error:e}");
            assert!(error <= target && rule.across * rule.cells >= last);
            assert_eq!(error, fastsim_rule_error(rule, &probes).unwrap());
            last = rule.across * rule.cells;
        }
        let error = choose_fastsim_rule(1e-14, &probes).unwrap_err();
        assert!(matches!(error, TractionError::TargetNotReached { reached, .. } if reached > 1e-14 && reached < 1e-4));
    }
}

#[test]
fn limit_no_cells_are_refused() {
    for (across, cells) in [(0, 8), (8, 0), (8, 1)] {
        assert!(matches!(Fastsim::new(FastsimRule { across, cells }), Err(TractionError::NoPoints)));
    }
}
