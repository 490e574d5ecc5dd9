//! Which of its equilibria a ball comes to that loses the inner race while it rolls.

use crate::block::RING;
use crate::jones_harris::{Typical, kinematics};
use crate::settle::follow_ball;
use crate::solve::traction_system;
use crate::{Model, RingFreedom, other_roots, solve};
use tribodyn_bearing::{BallSize, Bearing, OperatingPoint, Races};
use tribodyn_case::{Case, set_value};

/// A bearing on a wider pitch circle in about 200 N of drag per ball.
const DRAGGED: [(&str, &str); 7] = [
    ("geometry.pitch_diameter", "mm(165)"),
    ("geometry.inner_groove", "Coefficient(0.527)"),
    ("geometry.outer_groove", "Coefficient(0.527)"),
    ("traction.slip_unit", "Scaled(per_m_s: 22.0)"),
    ("fluid.drag_coefficient", "0.32"),
    ("ring.x", "Force(kN(20))"),
    ("ring.z", "Force(kN(44))"),
];
/// Points at which one ball may stand still, free of both races, or be driven at some speed below rolling: whether in
/// much drag, shares of radial load, axial load and speed, and that ball.
const POINTS: [(bool, [f64; 3], usize); 4] = [
    (false, [0.3, 0.02, 1.0], 2),
    (true, [0.5, 1.0 / 44.0, 0.5], 11),
    (true, [2.0, 0.3, 2.0], 10),
    (true, [0.5, 0.1, 2.0], 10),
];
/// Step and duration of the stages in which the ball is followed, s: a ball rolls off its traction in microseconds and
/// slows down in seconds.
const STAGES: [[f64; 2]; 4] = [[1e-6, 5e-4], [1e-5, 1e-2], [1e-4, 1.0], [1e-3, 20.0]];

fn problem(dragged: bool, [radial, axial, speed]: [f64; 3]) -> (Bearing, OperatingPoint) {
    let text = include_str!("../../../fixtures/cases/paper-ag.ron").to_owned();
    let changes = if dragged { &DRAGGED[..] } else { &[] };
    let patch = ("traction.patch", "SplitStrip(across: 8, along: 3)");
    let text = changes.iter().chain([&patch]).fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let case = Case::from_ron(&text).unwrap();
    let mut point = case.operating_point();
    for (freedom, share) in [(0, radial), (2, axial)] {
        let RingFreedom::Loaded(load) = &mut point.ring[freedom] else { panic!("a load") };
        *load *= share;
    }
    point.inner_speed *= speed;
    (case.bearing().unwrap(), point)
}

/// Started rolling, the ball loses the inner race at once, slows down in the fluid until its centrifugal force lets it
/// touch the inner race again, and is driven from then on: the solver's equilibrium, not the standstill that
/// the search finds as well.
#[test]
fn limit_a_ball_thrown_off_the_inner_race_comes_to_the_driven_equilibrium() {
    for (dragged, factors, index) in POINTS {
        let (bearing, point) = problem(dragged, factors);
        let start = solve(&bearing, &point, Model::Traction).unwrap_or_else(|e| panic!("{e}")).warm_start.unwrap();
        let roots = &other_roots(&bearing, &point, &start).unwrap()[index];
        assert!(roots.solution.skids() && roots.solution.stable(), "{roots:?}");
        assert!(roots.others.iter().any(|root| !root.driven && root.orbital_speed_rad_s.abs() < 1e-3), "{roots:?}");

        let typical = Typical::new(&bearing, &point.ring, Races { inner: point.inner_speed, outer: point.outer_speed });
        let system = traction_system(&bearing, &point, typical, start.rule()).unwrap();
        let (ring, found): ([f64; RING], _) = (start.ring(), start.state.balls[index]);
        let (_, loads, _) = system.evaluate(index, found, ring);
        let pose = loads.pose();
        let rolling = kinematics(&bearing, (&pose, &BallSize::NOMINAL), system.speeds, false, true);
        let mut ball =
            [found[0], found[1], rolling.angular_velocity[0], rolling.angular_velocity[1], 0.0, rolling.orbital_speed];
        let mut lost = false;
        for stage in STAGES {
            ball = follow_ball(&system, index, ball, ring, stage, 1e-9).ball;
            lost |= system.evaluate(index, ball, ring).1.contacts.inner.normal.load == 0.0;
        }
        assert!(lost, "{factors:?}: never off the inner race");
        let (orbit, expected) = (ball[5], found[5]);
        assert!((orbit - expected).abs() < 1e-4 * expected, "{factors:?}: {orbit} and {expected} rad/s");
    }
}
