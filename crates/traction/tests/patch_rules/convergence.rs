//! Errors of the rules against a brute-force reference, on the loaded, the middle and the light ball.

use crate::contacts::{Contact, Measured, SCALES, contacts, measure, silver};
use tribodyn_traction::{
    CoatingLaw, PatchRule, PatchTraction, Quadrature, REFERENCE_RULE, RuleUse, TractionError, choose_rule, rule_error,
};

/// Cells of the brute-force reference; its error is about 5e-8 at 22 per m/s and 1e-6 at 100.
const CELLS: usize = 600;
const PAPER_RULE: PatchRule = PatchRule::PolarMidpoint { radial: 10, circumferential: 40 };

struct Bench {
    law: CoatingLaw,
    contacts: Vec<Contact>,
    exact: Vec<PatchTraction>,
}

impl Bench {
    fn new(scale: f64) -> Self {
        let (law, contacts) = (silver(), contacts(scale));
        assert_eq!(contacts.len(), 6);
        let exact = contacts.iter().map(|contact| contact.brute_force(&law, CELLS)).collect();
        Self { law, contacts, exact }
    }

    fn measure(&self, rule: PatchRule) -> Measured {
        measure(rule, &self.contacts, &self.law, &self.exact).unwrap()
    }

    /// The largest of the errors of force, moment and power.
    fn worst(&self, rule: PatchRule) -> f64 {
        self.measure(rule).errors.into_iter().fold(0.0, f64::max)
    }
}

#[test]
fn identity_reference_rule_agrees_with_brute_force() {
    for (scale, tolerance) in SCALES.into_iter().zip([1e-9, 1e-8, 1e-7, 4e-6]) {
        let bench = Bench::new(scale);
        let quadrature = Quadrature::new(REFERENCE_RULE).unwrap();
        for (contact, exact) in bench.contacts.iter().zip(&bench.exact) {
            let ours = contact.traction(&bench.law, &quadrature);
            let errors = contact.errors(&ours, exact);
            assert!(errors.iter().all(|&e| e < tolerance), "{scale} {}: {errors:?}", contact.name);
            let wear = (ours.wear_integral / exact.wear_integral - 1.0).abs();
            // Midpoints lose an order or two at the cone of |Δv|, so this is the brute force's own error.
            assert!(wear < 2e-7, "{scale} {}: wear integral {wear:e}", contact.name);
        }
    }
}

/// Fewest points of `rules` within the error of the paper's 400, as a share of them.
fn saving(bench: &Bench, rules: &[PatchRule]) -> f64 {
    let paper = bench.measure(PAPER_RULE);
    let enough = |m: &Measured| (0..3).all(|k| m.errors[k] <= paper.errors[k]);
    let fewest = rules
        .iter()
        .map(|&rule| bench.measure(rule))
        .filter(enough)
        .fold(f64::INFINITY, |fewest, measured| fewest.min(measured.points));
    paper.points / fewest
}

#[test]
fn identity_gauss_jacobi_saves_ten_of_eleven_points_at_small_scale() {
    let rules = [(2, 6), (2, 8), (3, 8), (4, 8)].map(|(radial, angles)| PatchRule::GaussJacobi { radial, angles });
    let ratio = saving(&Bench::new(1.0), &rules);
    println!("Gauss–Jacobi at 1 per m/s: {ratio:.1} times fewer points than 10 × 40 midpoints");
    assert!(ratio >= 10.0, "{ratio}");
}

#[test]
fn identity_split_strips_save_four_of_five_points_at_large_scale() {
    let rules = [(4, 3), (5, 3), (6, 3), (7, 3), (8, 4)].map(|(across, along)| PatchRule::SplitStrip { across, along });
    for scale in [5.0, 22.0, 100.0] {
        let ratio = saving(&Bench::new(scale), &rules);
        println!("split strips at {scale} per m/s: {ratio:.1} times fewer points than 10 × 40 midpoints");
        assert!(ratio >= 5.0, "{scale}: {ratio}");
    }
}

#[test]
fn identity_every_rule_converges() {
    let midpoint = [5, 10, 20, 40].map(|radial| PatchRule::PolarMidpoint { radial, circumferential: 4 * radial });
    let jacobi = [(2, 6), (4, 10), (8, 20), (12, 32)].map(|(radial, angles)| PatchRule::GaussJacobi { radial, angles });
    let strips = [(5, 3), (8, 4), (12, 6), (16, 8)].map(|(across, along)| PatchRule::SplitStrip { across, along });
    // By scale: how much each of the last three refinements must gain at least, and the error at the end.
    let expected = [
        (1.0, [(midpoint, 2.4, 3e-4), (jacobi, 3.0, 2e-6), (strips, 5.0, 1e-8)]),
        (22.0, [(midpoint, 2.4, 3e-4), (jacobi, 1.5, 6e-4), (strips, 3.0, 1e-6)]),
    ];
    for (scale, families) in expected {
        let bench = Bench::new(scale);
        for (rules, gain, last) in families {
            let errors = rules.map(|rule| bench.worst(rule));
            assert!(errors.windows(2).all(|pair| pair[0] > gain * pair[1]), "{scale} {:?}: {errors:?}", rules[0]);
            assert!(errors[3] < last, "{scale} {:?}: {errors:?}", rules[3]);
        }
    }
}

#[test]
fn limit_midpoint_rule_has_order_three_halves_from_the_edge() {
    let bench = Bench::new(1.0);
    let error = |radial| bench.worst(PatchRule::PolarMidpoint { radial, circumferential: 4 * radial });
    let order = (error(10) / error(40)).log2() / 2.0;
    assert!((order - 1.5).abs() < 0.1, "order {order}");
}

#[test]
fn identity_chosen_rule_keeps_its_target_and_costs_more_for_a_finer_one() {
    for (scale, by) in SCALES.into_iter().flat_map(|scale| [RuleUse::Solver, RuleUse::Run].map(|by| (scale, by))) {
        let bench = Bench::new(scale);
        let probes: Vec<_> = bench.contacts.iter().map(|contact| contact.probe(&bench.law)).collect();
        let mut points = 0.0;
        for target in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            let (rule, estimate) = choose_rule(target, &probes, by).unwrap();
            assert!(estimate <= target);
            // Against finer strips, but not the finest.
            let alone = rule_error(rule, &probes).unwrap();
            assert!((alone - estimate).abs() <= 0.1 * estimate, "{scale} {target:e} {rule:?}: {alone:e} {estimate:e}");
            let measured = bench.measure(rule);
            // Force and moment, as the estimate judges them; the reference's own error at 100 per m/s is 1e-6.
            assert!(measured.errors[0].max(measured.errors[1]) <= 1.05 * target + 2e-6 * (scale / 100.0).powi(2));
            assert!(measured.points >= points, "{scale} {target:e}: {rule:?}");
            points = measured.points;
        }
    }
}

#[test]
fn limit_target_beyond_the_finest_rule_is_refused_with_what_was_reached() {
    let (law, contacts) = (silver(), contacts(22.0));
    let probes: Vec<_> = contacts.iter().map(|contact| contact.probe(&law)).collect();
    let Err(TractionError::TargetNotReached { target, reached }) = choose_rule(1e-14, &probes, RuleUse::Solver) else {
        panic!("1e-14 cannot be reached");
    };
    assert!(target == 1e-14 && reached > 1e-14 && reached < 1e-6, "{reached:e}");
}
