//! Rings that tilt and spalls of balls: what they come to, and refusals with their place.

use super::*;
use tribodyn_bearing::Races;

const AG: &str = include_str!("../../../fixtures/cases/paper-ag.ron");
const TILT: &str = "(inertia: Cylinder(bore: mm(120), outside: mm(150), width: mm(40)),
    stiffness: (Nm_per_mrad(2), Nm_per_rad(3000)), damping: (Nm_s_per_rad(1), Nm_s_per_rad(2)))";

fn changed(changes: &[(&str, &str)]) -> Result<Case, CaseError> {
    let text = changes.iter().fold(AG.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    Case::from_ron(&text)
}

const LOADED: [(&str, &str); 2] = [("ring.tilt_x", "Moment(Nm(5))"), ("ring.tilt_y", "Moment(Nm(0))")];

/// A cylinder of 12 kg: m (a² + b²)/2 about its axis, and half of it with m w²/12 across.
#[test]
fn identity_a_cylinder_has_its_moments_of_inertia() {
    let outer = TILT.replace("damping", "askew: (mrad(0.2), mrad(-0.1)), damping");
    let case = changed(&[&LOADED[..], &[("supports.tilt", TILT), ("supports.outer_tilt", &outer)]].concat()).unwrap();
    let Races { inner, outer } = case.run_inputs().unwrap().tilting;
    let (tilting, outer) = (inner.unwrap(), outer.unwrap());
    assert_eq!((tilting.askew, outer.askew), ([0.0; 2], [2e-4, -1e-4]));
    assert!((outer.polar_inertia / tilting.polar_inertia - 5.0 / 12.0).abs() < 1e-12, "{outer:?}");
    let polar = 12.0 * (0.06f64.powi(2) + 0.075f64.powi(2)) / 2.0;
    assert!((tilting.polar_inertia / polar - 1.0).abs() < 1e-12, "{tilting:?}");
    let transverse = 0.5 * polar + 12.0 * 0.04f64.powi(2) / 12.0;
    assert!((tilting.transverse_inertia / transverse - 1.0).abs() < 1e-12, "{tilting:?}");
    assert_eq!((tilting.stiffness, tilting.damping), ([2000.0, 3000.0], [1.0, 2.0]));
}

#[test]
fn limit_impossible_tilts_and_spalls_of_balls_are_refused() {
    let with = |from: &str, to: &str| TILT.replace(from, to);
    let (x, wide, inertia) = (LOADED[0], with("outside: mm(150)", "outside: mm(110)"), with("mm(40)", "mm(0)"));
    let given = TILT.replace(
        "Cylinder(bore: mm(120), outside: mm(150), width: mm(40))",
        "Given(polar: kg_m2(0.05), transverse: kg_m2(0.02))",
    );
    let soft = with("Nm_per_rad(3000)", "Nm_per_rad(-1)");
    let (loose, far) =
        (with("Nm_per_rad(3000)", "Nm_per_rad(0)"), with("damping:", "askew: (mrad(60), mrad(0)), damping:"));
    let floating = loose.replace("damping:", "askew: (mrad(1), mrad(0)), damping:");
    let spall = |ball: usize| format!("(ball: {ball}, angle: deg(8), length: mm(1.5), width: mm(4), depth: um(9))");
    let (none, long) = (format!("[{}]", spall(13)), format!("[{}]", spall(1).replace("mm(1.5)", "mm(15)")));
    for (changes, path, message) in [
        (vec![("supports.tilt", &loose[..])], "ring.tilt_y", "is held where supports.tilt has no stiffness"),
        (vec![x, LOADED[1], ("supports.tilt", &wide)], "Cylinder.outside", "greater than the bore, 120 mm"),
        (vec![x, LOADED[1], ("supports.tilt", &inertia)], "Cylinder.width", "greater than 0"),
        (vec![x, LOADED[1], ("supports.tilt", &given)], "Given.transverse", "at least half of the polar one"),
        (vec![x, LOADED[1], ("supports.tilt", &soft)], "supports.tilt.stiffness[1]", "at least 0"),
        (
            vec![x, LOADED[1], ("supports.tilt", TILT), ("modelling.ring_centre", "Inertial")],
            "modelling.ring_centre",
            "must be Displaced",
        ),
        (vec![("supports.outer_tilt", &loose)], "supports.outer_tilt.stiffness[1]", "greater than 0"),
        (vec![("supports.outer_tilt", &far)], "supports.outer_tilt.askew[0]", "between -50 and 50 mrad"),
        (vec![x, LOADED[1], ("supports.tilt", &floating)], "supports.tilt.stiffness", "greater than 0 about both axes"),
        (vec![("ball_spalls", &none)], "ball_spalls[0].ball", "0 to 12"),
        (vec![("ball_spalls", &long)], "ball_spalls[0].length", "at most four tenths of the ball diameter, 12.06"),
    ] {
        let error = changed(&changes).unwrap_err().to_string();
        assert!(error.contains(path) && error.contains(message), "{path}: {error}");
    }
}
