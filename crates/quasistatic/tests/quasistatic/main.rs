//! The quasi-static models from the case file to the solution.

mod at_rest;
mod deviations;
mod identities;
mod limits;
mod published;
mod range;
mod roots;
mod similarity;
mod solver;

use tribodyn_case::{Case, set_value};
use tribodyn_quasistatic::{BallResult, Model, Solution, Solved, solve};

/// The 218 angular-contact bearing of the Jones–Harris literature.
const BEARING_218: &str = include_str!("../../../../fixtures/cases/bearing-218.ron");
/// The cryogenic bearing of the paper with its silver coating.
const PAPER_AG: &str = include_str!("../../../../fixtures/cases/paper-ag.ron");
/// Values that the paper does not publish, pinned for the tests here: the case file follows the identification. The
/// drag is about 200 N per ball.
const PINNED: [(&str, &str); 11] = [
    ("geometry.pitch_diameter", "mm(165)"),
    ("geometry.inner_groove", "Coefficient(0.527)"),
    ("geometry.outer_groove", "Coefficient(0.527)"),
    ("traction.slip_unit", "Scaled(per_m_s: 22.0)"),
    ("traction.order", "2"),
    ("materials.ball.young", "GPa(200)"),
    ("materials.inner.young", "GPa(200)"),
    ("materials.outer.young", "GPa(200)"),
    ("fluid.drag_coefficient", "0.32"),
    ("ring.x", "Force(kN(20))"),
    ("ring.z", "Force(kN(44))"),
];
/// A fixed patch rule: the tests here are about equilibrium, not about the choice of a rule.
const STRIPS: (&str, &str) = ("traction.patch", "SplitStrip(across: 8, along: 3)");

/// A case with some of its values replaced.
fn variant(text: &str, changes: &[(&str, &str)]) -> Case {
    let pinned = if text == PAPER_AG { &PINNED[..] } else { &[] };
    let changed = pinned.iter().chain(changes).fold(text.to_owned(), |text, (path, value)| {
        set_value(&text, path, value).unwrap_or_else(|e| panic!("{path}: {e}"))
    });
    Case::from_ron(&changed).unwrap_or_else(|e| panic!("{e}"))
}

fn solve_case(case: &Case, model: Model) -> Solved {
    let bearing = case.bearing().unwrap();
    solve(&bearing, &case.operating_point(), model).unwrap_or_else(|e| panic!("{e}"))
}

fn solution(text: &str, changes: &[(&str, &str)], model: Model) -> Solution {
    solve_case(&variant(text, changes), model).solution
}

/// Fails unless `actual` is within `tolerance` × |`expected`| of `expected`.
#[track_caller]
fn assert_near(what: &str, actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() <= tolerance * expected.abs(), "{what}: {actual:.12e}, expected {expected:.12e}");
}

/// Fails unless two balls are in the same state: loads, speeds, slips and losses.
#[track_caller]
fn assert_same_ball(what: &str, a: &BallResult, b: &BallResult, tolerance: f64) {
    let numbers = |ball: &BallResult| {
        [
            ("inner load", ball.contacts.inner.load_n, 1e4),
            ("outer load", ball.contacts.outer.load_n, 1e4),
            ("inner angle", ball.contacts.inner.angle_rad.to_degrees(), 20.0),
            ("outer angle", ball.contacts.outer.angle_rad.to_degrees(), 20.0),
            ("orbital speed", ball.orbital_speed_rad_s, 600.0),
            ("axial angular velocity", ball.angular_velocity_rad_s[0], 3000.0),
            ("radial angular velocity", ball.angular_velocity_rad_s[1], 3000.0),
            ("tangential angular velocity", ball.angular_velocity_rad_s[2], 3000.0),
            ("inner traction", ball.contacts.inner.friction.unwrap_or_default().traction_n[0], 1e3),
            ("outer lateral traction", ball.contacts.outer.friction.unwrap_or_default().traction_n[1], 1e3),
            ("inner loss", ball.contacts.inner.friction.unwrap_or_default().power_loss_w, 1e3),
            ("fluid loss", ball.fluid.unwrap_or_default().power_loss_w, 1e3),
        ]
    };
    for ((name, x, size), (_, y, _)) in numbers(a).into_iter().zip(numbers(b)) {
        assert!((x - y).abs() <= tolerance * size, "{what}, {name}: {x:.12e} and {y:.12e}");
    }
}
