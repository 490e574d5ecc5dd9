//! How the solver gets there: steps, warm starts, failures.

use crate::{BEARING_218, PAPER_AG, STRIPS, assert_near, assert_same_ball, solve_case, variant};
use tribodyn_case::Case;
use tribodyn_quasistatic::Model::{JonesHarris, Traction};
use tribodyn_quasistatic::{
    PatchRule, Place, QuasiStaticError, RingFreedom, SolverStatistics, WarmStart, solve, solve_from, solve_near,
};

#[test]
fn regress_solver_steps() {
    let steps = |name: &str, text: &str, changes: &[(&str, &str)], model| {
        let statistics = solve_case(&variant(text, changes), model).statistics;
        let SolverStatistics { accepted, rejected, jacobians, .. } = statistics;
        format!("{name}: {accepted} kept, {rejected} rejected, {jacobians} Jacobians\n")
    };
    let light = [STRIPS, ("ring.z", "Force(kN(1))"), ("ring.x", "Force(kN(10))")];
    let all = [
        steps("218 Jones-Harris", BEARING_218, &[], JonesHarris),
        steps("paper Jones-Harris", PAPER_AG, &[], JonesHarris),
        steps("paper case 1", PAPER_AG, &[STRIPS], Traction),
        steps("paper case 4", PAPER_AG, &[STRIPS, FIXED, NO_DIFFERENTIAL], Traction),
        steps("light axial load", PAPER_AG, &light, Traction),
    ];
    insta::assert_snapshot!(all.concat(), @"
    218 Jones-Harris: 12 kept, 0 rejected, 8 Jacobians
    paper Jones-Harris: 14 kept, 0 rejected, 10 Jacobians
    paper case 1: 20 kept, 0 rejected, 12 Jacobians
    paper case 4: 19 kept, 0 rejected, 12 Jacobians
    light axial load: 27 kept, 0 rejected, 20 Jacobians
    ");
}

const FIXED: (&str, &str) = ("traction.varying", "false");
const NO_DIFFERENTIAL: (&str, &str) = ("traction.differential_slip", "false");

#[test]
fn identity_warm_start_leads_to_the_same_solution_in_few_steps() {
    let case = variant(PAPER_AG, &[STRIPS]);
    let bearing = case.bearing().unwrap();
    let point = case.operating_point();
    let start = solve(&bearing, &point, Traction).unwrap().warm_start.unwrap();
    let same = solve_from(&bearing, &point, &start).unwrap();
    assert_eq!(same.statistics.accepted, 0, "a solution is a solution");
    let mut near = point.clone();
    near.ring[0] = RingFreedom::Loaded(20.4e3);
    near.inner_speed *= 1.01;
    let warm = solve_from(&bearing, &near, &start).unwrap();
    let cold = solve(&bearing, &near, Traction).unwrap();
    // Each step divides the residual by about ten: the slopes hold the few nodes of this rule fast.
    assert!(warm.statistics.accepted <= 9 && warm.statistics.jacobians <= 2, "{:?}", warm.statistics);
    assert_near("cage speed", warm.solution.cage_speed_rpm, cold.solution.cage_speed_rpm, 1e-9);
    for (a, b) in warm.solution.balls.iter().zip(&cold.solution.balls) {
        assert_same_ball("warm", a, b, 1e-7);
    }
}

/// The rule that a target error leads to is kept by the warm start.
#[test]
fn identity_target_error_is_met_and_kept() {
    let case = variant(PAPER_AG, &[("traction.patch", "TargetError(relative: 1e-4)")]);
    let bearing = case.bearing().unwrap();
    let point = case.operating_point();
    let solved = solve(&bearing, &point, Traction).unwrap();
    let estimate = solved.solution.patch_error_estimate.unwrap();
    assert!(estimate > 0.0 && estimate <= 1.5e-4, "{estimate}");
    let again = solve_from(&bearing, &point, &solved.warm_start.unwrap()).unwrap();
    assert_near("cage speed", again.solution.cage_speed_rpm, solved.solution.cage_speed_rpm, 1e-12);
}

#[test]
fn convergence_moved_start_is_one_order_better_than_a_near_one() {
    let case = variant(PAPER_AG, &[STRIPS]);
    let bearing = case.bearing().unwrap();
    let at = |share: f64| {
        let mut point = case.operating_point();
        point.ring[0] = RingFreedom::Loaded(2e4 * (1.0 + share));
        point.inner_speed *= 1.0 + share;
        solve(&bearing, &point, Traction).unwrap().warm_start.unwrap()
    };
    let from_goal = |start: &WarmStart, goal: &WarmStart| {
        start
            .balls()
            .zip(goal.balls())
            .map(|(a, b)| (a.angular_velocity[0] / b.angular_velocity[0] - 1.0).abs())
            .fold(0.0, f64::max)
    };
    let errors = [0.04, 0.02].map(|step| {
        let [first, second, goal] = [0.0, step, 2.0 * step].map(at);
        let moved = second.moved(&first, &second).unwrap();
        [from_goal(&second, &goal), from_goal(&moved, &goal)]
    });
    let [[near, moved], [near_half, moved_half]] = errors;
    assert!((1.8..2.2).contains(&(near / near_half)) && (3.2..5.0).contains(&(moved / moved_half)), "{errors:?}");
    assert!(moved < 0.1 * near, "{errors:?}");
}

#[test]
fn limit_a_rule_too_coarse_for_the_target_is_chosen_anew() {
    let case = variant(PAPER_AG, &[("traction.patch", "TargetError(relative: 1e-5)")]);
    let bearing = case.bearing().unwrap();
    let point = case.operating_point();
    let mut coarse = point.clone();
    coarse.patch = Some(PatchRule::SplitStrip { across: 5, along: 3 }.into());
    let start = solve(&bearing, &coarse, Traction).unwrap().warm_start.unwrap();
    let [kept, anew] = [solve_from, solve_near].map(|solve| solve(&bearing, &point, &start).unwrap());
    assert!(kept.solution.patch_error_estimate.unwrap() > 1e-5);
    assert!(anew.solution.patch_error_estimate.unwrap() <= 1e-5);
    let cold = solve(&bearing, &point, Traction).unwrap();
    assert_eq!(anew.warm_start.unwrap().rule(), cold.warm_start.unwrap().rule());
    assert_near("cage speed", anew.solution.cage_speed_rpm, cold.solution.cage_speed_rpm, 1e-9);
}

#[test]
fn limit_too_few_iterations_name_the_worst_balance() {
    for model in [JonesHarris, Traction] {
        let case = variant(PAPER_AG, &[STRIPS, ("numerics", "(max_iterations: 1)")]);
        let error = solve(&case.bearing().unwrap(), &case.operating_point(), model).unwrap_err();
        let QuasiStaticError::NotConverged { place, equation, residual, tolerance, .. } = &error else {
            panic!("another error: {error}");
        };
        assert!(*residual > *tolerance && *tolerance == 1e-10);
        let text = error.to_string();
        let name = match place {
            Place::Ball { index, azimuth_deg } => {
                assert_near("azimuth", *azimuth_deg, 360.0 / 13.0 * *index as f64, 1e-12);
                format!("ball {index} at")
            }
            Place::Ring => "the inner ring".to_owned(),
        };
        assert!(text.contains(&name) && text.contains(equation) && text.contains(&format!("{residual:.3e}")), "{text}");
    }
}

/// A bearing without traction is enough for Jones–Harris; what a model lacks is named.
#[test]
fn limit_a_model_without_what_it_uses_is_refused() {
    let missing = |case: &Case, model| match solve(&case.bearing().unwrap(), &case.operating_point(), model) {
        Err(QuasiStaticError::Missing { model: of, missing }) if of == model => missing.len(),
        other => panic!("{other:?}"),
    };
    let mut case = variant(BEARING_218, &[]);
    assert_eq!(missing(&case, Traction), 4);
    case.modelling.race_control = None;
    assert_eq!(missing(&case, JonesHarris), 1);
    let mut case = variant(PAPER_AG, &[STRIPS]);
    case.modelling.ring_centre = None;
    assert_eq!(missing(&case, Traction), 1);
    (case.modelling.race_control, case.modelling.centrifugal_at_free_pitch) = (None, None);
    assert_eq!(missing(&case, JonesHarris), 2);
}

/// A close inner and a wide open outer groove, light thrust, twice the speed: the balls without inner contact have no
/// raceway control, but with traction every ball has its equilibrium.
#[test]
fn limit_traction_converges_where_raceway_control_does_not() {
    let changes = [
        STRIPS,
        ("geometry.inner_groove", "Coefficient(0.51)"),
        ("geometry.outer_groove", "Coefficient(0.56)"),
        ("ring.x", "Force(kN(40))"),
        ("ring.z", "Force(kN(0.88))"),
        ("speed.inner", "Constant(rpm(28000))"),
    ];
    let case = variant(PAPER_AG, &changes);
    let (bearing, point) = (case.bearing().unwrap(), case.operating_point());
    assert!(solve(&bearing, &point, JonesHarris).is_err());
    let s = solve(&bearing, &point, Traction).unwrap_or_else(|e| panic!("{e}")).solution;
    assert!(s.residual <= 1e-10 && s.balls.iter().any(|ball| ball.contacts.inner.load_n == 0.0));
    // Balls without drive, which stand still by themselves, do not slow the cage.
    let pressed = s.balls.iter().filter(|b| b.contacts.inner.load_n > 0.0 && b.contacts.outer.load_n > 0.0);
    let speeds: Vec<f64> = pressed.map(|ball| ball.orbital_speed_rad_s).collect();
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    assert!((s.cage_speed_rpm / (mean * 30.0 / std::f64::consts::PI) - 1.0).abs() < 1e-12, "{speeds:?}");
}
