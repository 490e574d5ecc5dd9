//! Lightly loaded, fast bearings.

use super::*;
use tribodyn_bearing::RingFreedom;
use tribodyn_case::{Case, set_value};

/// The paper's bearing on a wider pitch circle in much drag, under hardly any thrust: all balls fall from rolling into
/// skidding, each with the load that the others leave it.
fn skidding(axial: f64) -> (Bearing, OperatingPoint) {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let changes = [
        ("geometry.pitch_diameter", "mm(165)"),
        ("traction.slip_unit", "Scaled(per_m_s: 22.0)"),
        ("fluid.drag_coefficient", "0.32"),
        ("traction.patch", "SplitStrip(across: 8, along: 3)"),
    ];
    let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let mut point = case.operating_point();
    point.ring[0] = RingFreedom::Loaded(0.3 * axial);
    point.ring[2] = RingFreedom::Loaded(axial);
    (case.bearing().unwrap(), point)
}

/// The residual that the way without pseudo-time leaves.
fn without_rescue(bearing: &Bearing, point: &OperatingPoint) -> f64 {
    let Rolling { system, elastic, solved } = rolling_state(bearing, point, false);
    let start = release_idle_balls(&system, solved.unwrap_or(elastic).state);
    let rule = PatchRule::SplitStrip { across: 8, along: 3 };
    let traction = traction_system(bearing, point, system.typical, rule).unwrap();
    let settled = settle(&traction, &settle(&traction, &start, SCOUTED, FROM_AFAR), SETTLED, FROM_NEAR);
    newton(&traction, settled, point).worst().residual
}

/// A bearing that skids as a whole has its equilibrium found, by whatever way, or says that it skids; nothing that
/// Newton's method finds alone is lost.
#[test]
fn limit_a_bearing_that_skids_as_a_whole_converges_or_says_so() {
    let (mut alone, mut found) = (0, 0);
    for axial in [0.5, 2.0, 10.0, 50.0, 500.0] {
        let (bearing, point) = skidding(axial);
        alone += usize::from(without_rescue(&bearing, &point) <= point.numerics.tolerance);
        match solve(&bearing, &point, Model::Traction) {
            Ok(solved) => {
                found += 1;
                assert!(solved.solution.residual <= point.numerics.tolerance);
                assert!((solved.solution.ring_load_n[2] - axial).abs() < 1e-6 * axial.max(1.0), "{axial} N");
            }
            Err(QuasiStaticError::NotConverged { reason, .. }) => {
                assert!(matches!(*reason, Reason::Skidding { .. }), "{axial} N: {reason}");
            }
            Err(other) => panic!("{axial} N: {other}"),
        }
    }
    assert!(found >= alone && found >= 2, "{found} of 5 found, {alone} by Newton's method alone");
}

#[test]
fn limit_reasons_say_what_helps() {
    let text = |reason: Reason| reason.to_string();
    assert!(text(Reason::Rounding { attainable: 1e-9 }).contains("numerics.tolerance to 1e-9"));
    let skidding = Reason::Skidding { skidding: 9, idle: 4, balls: 13, cage_speed_rpm: 812.0, rolling_rpm: 5800.0 };
    assert!(text(skidding).contains("9 of 13 balls skid, 4 are off the inner race"), "{}", text(skidding));
    let control = |friction| text(Reason::RacewayControl { friction, speed_share: 0.78 });
    assert!(
        control(0.03).contains("up to 78 % of this speed") && control(f64::INFINITY).contains("cannot hold a ball")
    );
}

/// A tolerance below what rounding leaves is answered with one that can be met, and not with a search for another root.
#[test]
fn limit_a_tolerance_below_rounding_is_answered_with_one_that_can_be_met() {
    let (bearing, mut point) = skidding(44e3);
    point.numerics.tolerance = 1e-15;
    let error = solve(&bearing, &point, Model::Traction).unwrap_err();
    let QuasiStaticError::NotConverged { reason, .. } = &error else { panic!("{error}") };
    let Reason::Rounding { attainable } = **reason else { panic!("another reason: {error}") };
    point.numerics.tolerance = attainable;
    assert!(attainable <= 1e-10 && solve(&bearing, &point, Model::Traction).is_ok(), "{attainable:e}");
}

fn of_survey(text: &str) -> (Bearing, OperatingPoint) {
    let case = Case::from_ron(text).unwrap();
    (case.bearing().unwrap(), case.operating_point())
}

/// Newton's method alone finds no way in rings that turn against each other; over slower ones it does.
#[test]
fn limit_raceway_control_is_found_over_slower_bearings() {
    let (bearing, point) = of_survey(include_str!("../../../fixtures/survey/1-01405.ron"));
    let solved = solve(&bearing, &point, Model::JonesHarris).unwrap();
    assert!(solved.statistics.rescues > 0, "{:?}: the case no longer shows what it is for", solved.statistics);
    assert!(solved.solution.residual <= point.numerics.tolerance);
}

/// A ball that the inner race does not press on is not held by it: its gyroscopic moment is left to the outer one.
#[test]
fn limit_a_race_without_load_leaves_the_gyroscopic_moment_to_the_other() {
    let (bearing, point) = of_survey(include_str!("../../../fixtures/survey/1-00027.ron"));
    assert_eq!(bearing.modelling.race_control, Some(RaceControl::Inner));
    let solution = solve(&bearing, &point, Model::JonesHarris).unwrap().solution;
    assert!(solution.residual <= point.numerics.tolerance);
    let idle = solution.balls.iter().filter(|ball| ball.contacts.inner.load_n == 0.0).count();
    assert!(idle > 0 && idle < bearing.geometry.ball_count, "{idle} balls");
}
