//! Identification on problems whose answer is known.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use tribodyn_bearing::SearchWatch;
use tribodyn_case::{Case, set_value};
use tribodyn_identify::{Datum, Hypothesis, IdentifyError, LeastSquares, Problem, Quantity, Relation, identify};
use tribodyn_quasistatic::{Model, solve};

const CASE: &str = include_str!("../../../fixtures/cases/bearing-218.ron");

/// Loads and groove coefficients of the 218 bearing from angles, loads and speeds under raceway control: quick to
/// solve.
const PROBLEM: &str = r#"(
    name: "synthetic", case: "", seed: 5, starts: 4,
    parameters: [
        (name: "axial load", paths: ["ring.z.Force.N"], bounds: (15000, 30000)),
        (name: "inner coefficient", paths: ["geometry.inner_groove.Coefficient"], bounds: (0.515, 0.54)),
        (name: "outer coefficient", paths: ["geometry.outer_groove.Coefficient"], bounds: (0.515, 0.54)),
    ],
    runs: { "jh": (model: JonesHarris, set: {"modelling.contact_at_actual_angle": "false"}) },
    data: [
        (id: "speed", run: "jh", quantity: CageSpeed, value: 0, uncertainty: 0.5),
        (id: "p_i", run: "jh", quantity: PeakPressureInner(azimuth: 0), value: 0, uncertainty: 0.002),
        (id: "p_o", run: "jh", quantity: PeakPressureOuter(azimuth: 0), value: 0, uncertainty: 0.002),
        (id: "a_i", run: "jh", quantity: ContactAngleInner(azimuth: 0), value: 0, uncertainty: 0.05),
        (id: "a_o", run: "jh", quantity: ContactAngleOuter(azimuth: 0), value: 0, uncertainty: 0.05),
    ],
)"#;
const TRUTH: [(&str, f64); 3] = [
    ("ring.z.Force.N", 22_250.0),
    ("geometry.inner_groove.Coefficient", 0.5232),
    ("geometry.outer_groove.Coefficient", 0.5262),
];

fn true_figure(quantity: Quantity) -> f64 {
    let frozen = set_value(CASE, "modelling.contact_at_actual_angle", "false").unwrap();
    let set = |text: String, (path, value): &(&str, f64)| set_value(&text, path, &format!("{value:?}")).unwrap();
    let text = TRUTH.iter().fold(frozen, set);
    let case = Case::from_ron(&text).unwrap();
    let solved = solve(&case.bearing().unwrap(), &case.operating_point(), Model::JonesHarris).unwrap();
    quantity.of(&solved.solution)
}

/// A number from the standard normal distribution (Box–Muller).
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let mut uniform = || ((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
    let (a, b) = (uniform(), uniform());
    (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}

fn synthetic(noise_seed: Option<u64>) -> Problem {
    let mut problem = Problem::from_ron(PROBLEM).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(noise_seed.unwrap_or(0));
    for datum in &mut problem.data {
        let noise = noise_seed.map_or(0.0, |_| normal(&mut random) * datum.uncertainty);
        datum.value = true_figure(datum.quantity) + noise;
    }
    problem
}

#[test]
fn identity_exact_data_give_the_parameters_back() {
    let answer = &identify(&synthetic(None), CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    assert!(answer.cost < 1e-8, "cost {}", answer.cost);
    for (p, (_, truth)) in answer.parameters.iter().zip(TRUTH) {
        assert!((p.value - truth).abs() < 1e-3 * p.spread.max(1e-12), "{}: {} against {truth}", p.name, p.value);
        assert!(p.determined && !p.at_bound, "{}", p.name);
    }
    assert!(answer.sensitivity_check < 1e-3, "{}", answer.sensitivity_check);
}

#[test]
fn identity_noisy_data_give_the_parameters_within_two_spreads() {
    let mut inside = 0;
    for seed in 0..20 {
        let answer = &identify(&synthetic(Some(seed)), CASE, &|| (), &SearchWatch::default()).unwrap()[0];
        let within = |(p, (_, truth)): (&tribodyn_identify::ParameterResult, (&str, f64))| {
            (p.value - truth).abs() <= 2.0 * p.spread
        };
        inside += usize::from(answer.parameters.iter().zip(TRUTH).all(within));
    }
    // Three parameters within two standard deviations each: 86 to 95 % of the seeds, by their correlation.
    assert!(inside >= 18, "{inside} of 20 seeds");
}

#[test]
fn identity_the_seed_and_the_threads_do_not_change_the_answer() {
    let problem = synthetic(Some(3));
    let first = identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap();
    assert_eq!(first, identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap());
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    assert_eq!(first, one.install(|| identify(&problem, CASE, &|| (), &SearchWatch::default())).unwrap());
    let other = identify(&Problem { seed: 99, ..problem }, CASE, &|| (), &SearchWatch::default()).unwrap();
    for (a, b) in first[0].parameters.iter().zip(&other[0].parameters) {
        assert!((a.value - b.value).abs() < 0.05 * a.spread, "{}: {} and {}", a.name, a.value, b.value);
    }
}

#[test]
fn limit_an_undetermined_parameter_is_said_to_be_one() {
    // A cage speed alone cannot tell the two groove coefficients apart, and says little of either.
    let mut problem = synthetic(None);
    problem.data.truncate(1);
    let answer = &identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    let lost: Vec<_> = answer.parameters.iter().filter(|p| !p.determined).collect();
    assert!(lost.len() >= 2, "{:?}", answer.parameters);
    for p in lost {
        let measure = p.measure.as_ref().expect("a figure that would determine it");
        assert!(measure.contains("run \"jh\""), "{measure}");
    }
    assert!(answer.case_text.contains("not determined by the data"));
}

#[test]
fn identity_every_share_sums_to_one_with_the_weak_prior_left_out() {
    let answer = &identify(&synthetic(Some(1)), CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    for p in &answer.parameters {
        let sum: f64 = p.determined_by.iter().map(|(_, share)| share).sum();
        assert!(sum > 0.5 && sum <= 1.0 + 1e-9, "{}: {sum}", p.name);
    }
}

#[test]
fn limit_the_completed_case_is_a_case_with_sources() {
    let answer = &identify(&synthetic(Some(2)), CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    let case = Case::from_ron(&answer.case_text).unwrap();
    let source = format!("{:?}", case.sources["geometry.inner_groove"]);
    assert!(source.contains("Identified"), "{source}");
    assert!(case.sources.contains_key("ring.z") && !case.sources.contains_key("ring.z.Force"));
    assert!((case.geometry.ball_diameter - 0.02223).abs() < 1e-15, "published values stay");
}

/// Data of the three kinds for the true loads and grooves.
fn with_relations() -> Problem {
    let mut problem = synthetic(None);
    let inner = |datum: &Datum| Relation::RatioTo { run: datum.run.clone(), quantity: problem.data[1].quantity };
    let relation = inner(&problem.data[2]);
    let ratio = true_figure(problem.data[2].quantity) / true_figure(problem.data[1].quantity);
    problem.data[2] = Datum { relation, value: ratio, uncertainty: 1e-3, ..problem.data[2].clone() };
    let relation = Relation::Above { run: "jh".into(), quantity: problem.data[4].quantity };
    let order = Datum { id: "order".into(), relation, value: 2.0, uncertainty: 0.1, ..problem.data[3].clone() };
    problem.data.push(order);
    problem
}

#[test]
fn identity_ratios_and_orders_are_data() {
    let problem = with_relations();
    problem.check().unwrap();
    let answer = &identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    for (p, (_, truth)) in answer.parameters.iter().zip(TRUTH) {
        assert!((p.value - truth).abs() < 1e-2 * p.spread, "{}: {} against {truth}", p.name, p.value);
    }
    let order = answer.data.last().unwrap();
    assert!(order.computed > 2.0 && order.deviation == 0.0, "an order that holds says more: {order:?}");
    assert_eq!(answer.data[2].unit, "–");
    assert!(answer.conflicts.is_empty(), "{:?}", answer.conflicts);
    // An order that does not hold pulls as a value does.
    let mut broken = problem;
    broken.data.last_mut().unwrap().value = 40.0;
    let answer = &identify(&broken, CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    let order = answer.data.last().unwrap();
    assert!(order.deviation < 0.0 && (order.deviation - (order.computed - 40.0)).abs() < 1e-12, "{order:?}");
    assert!(answer.conflicts.iter().any(|c| c.starts_with("order is missed")), "{:?}", answer.conflicts);
}

#[test]
fn limit_the_evidence_is_the_integral_over_one_parameter() {
    let mut problem = synthetic(Some(4));
    problem.parameters.truncate(1);
    let found = &identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap()[0];
    let squares = LeastSquares::new(&problem, CASE, None).unwrap();
    let (best, wide) = (&found.parameters[0], 15_000.0);
    let cost = |coordinate: f64| squares.point(nalgebra::DVector::from_element(1, coordinate), None).unwrap().cost();
    let (from, to) = (best.value - 6.0 * best.spread, best.value + 6.0 * best.spread);
    let step = (to - from) / 120.0 / wide;
    let density = |k: usize| (-0.5 * cost((from - 15_000.0) / wide + k as f64 * step)).exp();
    let integral: f64 = (0..=120).map(density).sum::<f64>() * step;
    assert!((found.log_evidence - integral.ln()).abs() < 0.02, "{} against {}", found.log_evidence, integral.ln());
}

#[test]
fn limit_evidence_prefers_the_value_that_made_the_data() {
    let mut problem = synthetic(Some(4));
    let hypothesis = |name: &str, set: &[(&str, &str)]| Hypothesis {
        name: name.into(),
        set: set.iter().map(|(path, value)| ((*path).to_owned(), (*value).to_owned())).collect(),
        hold: if set.is_empty() { vec![] } else { vec!["inner coefficient".into()] },
        tie: Default::default(),
        priors: Default::default(),
    };
    let groove = "geometry.inner_groove.Coefficient";
    problem.hypotheses = vec![
        hypothesis("true", &[(groove, "0.5232")]),
        hypothesis("free", &[]),
        hypothesis("false", &[(groove, "0.53")]),
    ];
    let evidence: Vec<f64> =
        identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap().iter().map(|a| a.log_evidence).collect();
    // A free value explains as much and could have been anything; a false one explains nothing.
    assert!(evidence[0] > evidence[1] + 1.0 && evidence[1] > evidence[2] + 10.0, "{evidence:?}");
}

/// A second run with a load of its own, tied to the first or not.
const TWO: &str = r#"(
    name: "two", case: "", seed: 5, starts: 1, from_case: true,
    parameters: [
        (name: "load", paths: ["ring.z.Force.N"], bounds: (15000, 30000), runs: ["a"]),
        (name: "other", paths: ["ring.z.Force.N"], bounds: (15000, 30000), runs: ["b"]),
    ],
    runs: { "a": (model: JonesHarris), "b": (model: JonesHarris) },
    data: [
        (id: "a", run: "a", quantity: LoadInner(azimuth: 0), value: 2400, uncertainty: 1),
        (id: "b", run: "b", quantity: LoadInner(azimuth: 0), value: 2000, uncertainty: 1),
    ],
    hypotheses: [
        (name: "one", set: {}, tie: {"other": "load"}, priors: {"load": (mean: 20000, spread: 1e9)}),
        (name: "two", set: {}),
    ],
)"#;

#[test]
fn limit_tied_parameters_meet_the_mean_and_apart_each_its_own() {
    let problem = Problem::from_ron(TWO).unwrap();
    let answers = identify(&problem, CASE, &|| (), &SearchWatch::default()).unwrap();
    let [one, two] = [&answers[0], &answers[1]];
    assert_eq!((one.parameters.len(), two.parameters.len()), (1, 2));
    assert!(two.cost < 1e-6, "{}", two.cost);
    // Both runs are alike where they have one load, so it lies in the middle, 200 N from each.
    assert!((one.data[0].computed - one.data[1].computed).abs() < 1e-9);
    assert!((one.data[0].computed - 2200.0).abs() < 0.1 && (one.data_cost - 2.0 * 200f64.powi(2)).abs() < 1.0);
    assert_eq!(one.parameters[0].prior, Some((20000.0, 1e9)));
    assert_eq!(one.minima.iter().map(|minimum| minimum.starts).sum::<usize>(), 2, "the case is a start too");
    let squares = LeastSquares::new(&problem, CASE, Some(&problem.hypotheses[0])).unwrap();
    let text = squares.model.run_text("b", &[17_000.0]).unwrap();
    assert!(text.contains("17000.0") && squares.model.run_text("c", &[17_000.0]).is_none());
}

#[test]
fn limit_the_order_of_a_ratio_asks_for_no_more_than_its_figure() {
    let text =
        TWO.replace("value: 2000", r#"relation: RatioAbove(run: "a", quantity: LoadOuter(azimuth: 0)), value: 0.5"#);
    let problem = Problem::from_ron(&text).unwrap();
    let datum = &problem.data[1];
    assert_eq!((datum.deviation(0.7), datum.deviation(0.4), datum.unit()), (0.0, 0.4 - 0.5, "–"));
}

#[test]
fn limit_bad_hypotheses_are_refused_with_their_place() {
    let with = |from: &str, to: &str| Problem::from_ron(&TWO.replacen(from, to, 1)).unwrap_err().to_string();
    assert!(with(r#""other": "load""#, r#""other": "gap""#).contains("hypotheses[0].tie"));
    assert!(with(r#""other": "load""#, r#""other": "other""#).contains("hypotheses[0].tie"));
    assert!(with(r#"priors: {"load""#, r#"priors: {"gap""#).contains("hypotheses[0].priors"));
    assert!(with("spread: 1e9", "spread: 0").contains("spread above 0"));
    assert!(with(r#"runs: ["a"]"#, r#"runs: ["c"]"#).contains("parameters[0].runs"));
}

#[test]
fn limit_bad_problems_are_refused_with_their_place() {
    let with = |from: &str, to: &str| Problem::from_ron(&PROBLEM.replacen(from, to, 1)).unwrap_err().to_string();
    assert!(with("starts: 4", "starts: 0").contains("starts"));
    assert!(with("(15000, 30000)", "(30000, 15000)").contains("parameters[0].bounds"));
    assert!(with("run: \"jh\"", "run: \"x\"").contains("data[0].run"));
    let above = "value: 0, relation: Above(run: \"jh\", quantity: ShaftTorque)";
    assert!(with("value: 0", above).contains("data[0].relation.quantity"));
    assert!(with("value: 0", &above.replace("jh", "none")).contains("data[0].relation.run"));
    assert!(with("uncertainty: 0.5", "uncertainty: -1").contains("data[0].uncertainty"));
    assert!(with("seed: 5", "seeds: 5").contains("line 2"));
    let mut problem = synthetic(None);
    problem.parameters[0].paths = vec!["ring.z.Force".into()];
    assert!(matches!(identify(&problem, CASE, &|| (), &SearchWatch::default()), Err(IdentifyError::NotANumber { .. })));
    problem.parameters[0].paths = vec!["ring.w".into()];
    assert!(matches!(identify(&problem, CASE, &|| (), &SearchWatch::default()), Err(IdentifyError::Path { .. })));
    problem = synthetic(None);
    problem.data.push(Datum { value: f64::NAN, ..problem.data[0].clone() });
    assert!(problem.check().is_err());
}

/// A short run of the paper's bearing with the fast scheme.
const TRANSIENT: &str = r#"(
    name: "transient", case: "", seed: 1, starts: 1, difference: 0.02,
    parameters: [(name: "pocket gap", paths: ["cage.pocket_gap.mm"], bounds: (0.1, 1.0), scale: Log)],
    runs: {
        "run": (model: Transient, set: {}),
        "half": (model: Transient, set: {"ring.z": "Force(kN(27))"}),
        "solved": (model: Traction, set: {}),
    },
    data: [
        (id: "speed", run: "run", quantity: OrbitalSpeed, value: 0, uncertainty: 3),
        (id: "order", run: "run", quantity: OrbitalSpeedLeast, relation: Above(run: "run", quantity: OrbitalSpeedGreatest), value: 0, uncertainty: 3),
        (id: "peak", run: "run", quantity: OuterAccelerationPeak, relation: RatioTo(run: "half", quantity: OuterAccelerationPeak), value: 1, uncertainty: 0.1),
        (id: "statics", run: "solved", quantity: CageSpeed, value: 0, uncertainty: 3),
    ],
    search: {
        "transient.scheme": "Fast(step: us(20))",
        "transient.duration": "s(0.022)",
        "traction.patch": "TargetError(relative: 1e-3)",
    },
)"#;
const PAPER: &str = include_str!("../../../fixtures/cases/paper-ag.ron");

/// Figures of runs stand beside those of solutions, with relations between them.
#[test]
fn identity_data_of_short_runs() {
    let problem = Problem::from_ron(TRANSIENT).unwrap();
    let squares = LeastSquares::new(&problem, PAPER, None).unwrap();
    let at = |gap: f64| squares.point(vec![problem.parameters[0].coordinate(gap)].into(), None).unwrap();
    let point = at(0.71);
    let of = |id: &str| problem.data.iter().find(|d| d.id == id).unwrap().computed(&point.evaluation);
    let [low, high] = point.evaluation.settled["run"].orbital_limits_rpm;
    assert!(low > 5500.0 && high < 6000.0 && (low..high).contains(&of("speed")), "{low} {} {high}", of("speed"));
    assert_eq!(of("order"), low - high);
    // Case 1 of Table 4, and the run about it.
    assert!((of("statics") - 5804.4).abs() < 2.0 && (of("speed") - of("statics")).abs() < 30.0);
    assert!(of("peak") > 0.0);
    // A tight pocket narrows what a ball's speed does along its orbit.
    let [tight_low, tight_high] = at(0.1).evaluation.settled["run"].orbital_limits_rpm;
    assert!(tight_high - tight_low < 0.95 * (high - low), "{tight_low} {tight_high} {low} {high}");
}

#[test]
fn limit_quantities_and_runs_must_fit() {
    let of = |from: &str, to: &str| match Problem::from_ron(&TRANSIENT.replacen(from, to, 1)) {
        Err(IdentifyError::Value { field, .. }) => field,
        other => panic!("{other:?}"),
    };
    assert_eq!(of("quantity: OrbitalSpeed,", "quantity: CageSpeed,"), "data[0].quantity (speed)");
    assert_eq!(of("quantity: CageSpeed,", "quantity: FirstImpact,"), "data[3].quantity (statics)");
    assert_eq!(of("Above(run: \"run\"", "Above(run: \"solved\""), "data[1].relation.quantity (order)");
    assert_eq!(of("difference: 0.02", "difference: 0"), "difference");
}
