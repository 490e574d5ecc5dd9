//! Several equilibria of a ball.

use crate::{PAPER_AG, STRIPS, variant};
use tribodyn_quasistatic::Model::Traction;
use tribodyn_quasistatic::{BallRoots, other_roots, root_warnings, solve};

/// The paper's bearing in about 200 N of drag per ball, under loads in kN.
fn roots(axial: &str, radial: &str, drag: &str) -> Vec<BallRoots> {
    let (z, x) = (format!("Force(kN({axial}))"), format!("Force(kN({radial}))"));
    let changes = [STRIPS, ("ring.z", z.as_str()), ("ring.x", x.as_str()), ("fluid.drag_coefficient", drag)];
    let case = variant(PAPER_AG, &changes);
    let (bearing, point) = (case.bearing().unwrap(), case.operating_point());
    let solved = solve(&bearing, &point, Traction).unwrap_or_else(|e| panic!("{e}"));
    other_roots(&bearing, &point, &solved.warm_start.unwrap()).unwrap()
}

#[test]
fn limit_heavily_loaded_balls_have_one_stable_rolling_root() {
    let all = roots("44", "20", "0.32");
    assert_eq!(all.len(), 13);
    for ball in &all {
        assert!(ball.solution.rolls() && ball.solution.stable() && ball.others.is_empty(), "{ball:?}");
    }
    assert!(root_warnings(&all).is_empty());
}

/// At the edge of the load zone a ball rolls on either of two roots; what the search calls stable attracts, so followed
/// from elsewhere the ball ends there.
#[test]
fn limit_ball_at_the_edge_of_the_load_zone_has_two_stable_roots() {
    let all = roots("12", "20", "0.32");
    let second = all.iter().find_map(|ball| {
        let other = ball.others.iter().find(|root| root.driven && root.stable())?;
        Some((ball, other))
    });
    let (ball, other) = second.expect("a ball with two");
    assert!(ball.solution.stable() && ball.solution.rolls(), "the solution is the rolling one: {ball:?}");
    assert!(ball.solution.orbital_speed_rad_s > other.orbital_speed_rad_s + 1.0, "{ball:?}");
    assert!(other.load_inner_n > 0.0 && other.load_outer_n > other.load_inner_n, "{other:?}");
}

/// Under 12 kN of thrust and 20 kN of radial load the balls opposite the load lose the inner race, and their neighbours
/// are driven too little to roll against the drag.
#[test]
fn limit_warnings_name_balls_that_skid_and_balls_without_drive() {
    let all = roots("12", "20", "0.32");
    let warnings = root_warnings(&all);
    for (index, ball) in all.iter().enumerate() {
        let name = format!("ball {index} (");
        let warning = warnings.iter().find(|text| text.starts_with(&name));
        let says = |words: &str| warning.is_some_and(|text| text.contains(words));
        assert_eq!(says("nothing drives the ball"), !ball.solution.driven, "{ball:?} {warning:?}");
        assert_eq!(says("only skidding"), ball.solution.skids(), "{ball:?} {warning:?}");
        assert_eq!(
            says("several equilibria"),
            ball.solution.rolls() && !ball.others.is_empty(),
            "{ball:?} {warning:?}"
        );
    }
    assert!(all[0].solution.rolls() && all[1].solution.rolls());
    assert!(all[4].solution.skids() && all[9].solution.skids());
    assert!(!all[6].solution.driven && !all[7].solution.driven);
}
