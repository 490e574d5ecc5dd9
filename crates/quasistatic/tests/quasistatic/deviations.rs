//! Equilibria of a bearing with waviness and unequal balls, at one place of its balls after another.

use crate::{BEARING_218, assert_near, solution};
use tribodyn_quasistatic::Model::{JonesHarris, Traction};

const ANGULAR_7210: &str = include_str!("../../../../fixtures/cases/angular-7210.ron");

/// A 6205 with the grooves 0.52 and 0.53 at rest.
const SIZE: [(&str, &str); 17] = [
    ("geometry.ball_count", "9"),
    ("geometry.ball_diameter", "mm(7.94)"),
    ("geometry.pitch_diameter", "mm(39.04)"),
    ("geometry.inner_groove", "Coefficient(0.52)"),
    ("geometry.outer_groove", "Coefficient(0.53)"),
    ("materials.ball.young", "GPa(208)"),
    ("materials.inner.young", "GPa(208)"),
    ("materials.outer.young", "GPa(208)"),
    ("materials.ball.poisson", "0.3"),
    ("materials.inner.poisson", "0.3"),
    ("materials.outer.poisson", "0.3"),
    ("ring.y", "Force(N(0))"),
    ("ring.tilt_x", "Held(mrad(0))"),
    ("ring.tilt_y", "Held(mrad(0))"),
    ("speed.inner", "Constant(rpm(0))"),
    ("numerics.tolerance", "1e-12"),
    ("modelling.contact_at_actual_angle", "false"),
];
/// Under thrust.
const THRUST: [(&str, &str); 3] =
    [("geometry.fit", "ContactAngle(deg(15))"), ("ring.x", "Force(N(0))"), ("ring.z", "Force(N(300))")];

/// Displacement x, y, z of the inner ring, nm.
fn displaced(load: &[(&str, &str)], changes: &[(&str, &str)]) -> [f64; 3] {
    solution(BEARING_218, &[&SIZE[..], load, changes].concat(), JonesHarris).ring_displacement_m.map(|u| 1e9 * u)
}

/// The same under thrust, against the bearing without deviations, as a ring or the balls go on by 5° at a time over one
/// pitch of the balls.
fn going_on(what: &str, deviation: (&str, &str)) -> Vec<[f64; 3]> {
    let plain = displaced(&THRUST, &[]);
    let at = |step: u32| {
        let angle = format!("deg({})", 5 * step);
        let found = displaced(&THRUST, &[deviation, (what, &angle)]);
        [found[0], found[1], found[2] - plain[2]]
    };
    (0..8).map(at).collect()
}

fn wave(order: u32) -> String {
    format!("[(order: {order}, amplitude: um(0.2), phase: deg(0))]")
}

/// The part that turns under a wave of each race, and the periods that the pitch of the balls goes over.
const RACES: [[&str; 2]; 2] =
    [["deviations.outer.waves", "deviations.position.ball"], ["deviations.inner.waves", "deviations.position.inner"]];

/// Reference numbers of another program, which solves the ring's three balances with Hertz contacts at rest; printed
/// to six digits.
#[test]
fn code_waves_of_a_multiple_of_the_balls_push_along_the_axis_and_their_neighbours_across() {
    assert_near("thrust, z", displaced(&THRUST, &[])[2], 19_297.6, 3e-6);
    for [waves, what] in RACES {
        // The mean sinks by what unequal loads make of the stiffness, some nanometres; nothing turns.
        for order in [2, 7, 11] {
            for [x, y, z] in going_on(what, (waves, &wave(order))) {
                assert!(x.hypot(y) < 1e-4 && (z + 2.791).abs() < 1e-4, "order {order}: {x} {y} {z}");
            }
        }
        let axial = going_on(what, (waves, &wave(9)));
        let of_pitch = |k: usize| std::f64::consts::TAU * k as f64 / 8.0;
        let first = axial.iter().enumerate().map(|(k, u)| 0.25 * u[2] * of_pitch(k).cos()).sum::<f64>();
        assert_near("order 9, axial", first, 605.702, 3e-6);
        assert!(axial.iter().all(|[x, y, _]| x.hypot(*y) < 1e-6));
    }
}

/// A circle of the ring at nine times the speed of the balls (or of the inner ring), forwards for one order less than
/// there are balls, backwards for one more; the inner ring carries its wave with it.
#[test]
fn code_waves_beside_a_multiple_of_the_balls_turn_the_ring_on_a_circle() {
    for [waves, what] in RACES {
        for (order, sense) in [(8, 1.0), (10, -1.0)] {
            for (k, [x, y, _]) in going_on(what, (waves, &wave(order))).into_iter().enumerate() {
                assert_near("circle", x.hypot(y), 209.695, 3e-6);
                let turned = (5.0 * k as f64).to_radians();
                // Balls that go on by φ have the circle at ±9 φ; a ring that turns by φ has it at ∓n φ.
                let at = sense * turned * if waves.contains("outer") { 9.0 } else { -f64::from(order) };
                assert!((x - 209.695 * at.cos()).hypot(y - 209.695 * at.sin()) < 1e-3, "{order} {k}: {x} {y}");
            }
        }
    }
}

#[test]
fn code_a_larger_ball_turns_the_ring_on_a_circle_with_itself() {
    let sizes = "Excess([um(1), um(0), um(0), um(0), um(0), um(0), um(0), um(0), um(0)])";
    for (k, [x, y, _]) in going_on("deviations.position.ball", ("deviations.balls", sizes)).into_iter().enumerate() {
        let (sin, cos) = (5.0 * k as f64).to_radians().sin_cos();
        assert_near("circle", x.hypot(y), 238.747, 3e-6);
        assert!((x + 238.747 * cos).hypot(y + 238.747 * sin) < 1e-3, "{k}: {x} {y}");
    }
}

/// Balls that pass under a radial load lift and lower the ring though nothing is uneven.
#[test]
fn code_a_loaded_ring_rises_and_falls_as_balls_pass() {
    let load = [
        ("geometry.fit", "RadialClearance(um(10))"),
        ("ring.x", "Force(N(500))"),
        ("ring.z", "Force(N(0))"),
        ("modelling.contact_at_actual_angle", "true"),
    ];
    let x = |angle: &str| displaced(&load, &[("deviations.position.ball", angle)])[0];
    assert_near("a ball below", x("deg(0)"), 15_060.1, 1e-5);
    assert_near("a ball on either side", x("deg(20)"), 15_217.5, 1e-5);
}

/// Pure rolling: on an orbit of the radius R a ball of the radius r with the contact angle α goes round
/// (1 − r cos α/R)/2 times as fast as the inner ring. Under thrust a ball that is too large stands at a flatter angle,
/// which makes it faster, and rolls on a larger radius, which makes it slower. With traction, where spin and curvature
/// move the points of pure rolling within the patches, the same without them: balls pressed radially between races that
/// are flat across.
#[test]
fn limit_a_larger_ball_orbits_as_fast_as_geometry_has_it() {
    let mut sizes = vec!["um(0)"; 15];
    sizes[4] = "um(20)";
    let sizes = format!("Excess([{}])", sizes.join(", "));
    // So slowly that contact angles at both races are equal to 1e-5.
    let changes =
        [("ring.x", "Force(N(0))"), ("speed.inner", "Constant(rpm(100))"), ("deviations.balls", sizes.as_str())];
    let pressed = [
        ("geometry.fit", "RadialClearance(um(-40))"),
        // An inner ring that gives way turns about another axis.
        ("ring.x", "Held(um(0))"),
        ("ring.y", "Held(um(0))"),
        ("ring.z", "Held(um(0))"),
        ("traction.differential_slip", "false"),
    ];
    for (model, load) in [(JonesHarris, &pressed[..0]), (JonesHarris, &pressed), (Traction, &pressed)] {
        let found = solution(ANGULAR_7210, &[&changes, load].concat(), model);
        let speed = |ball: usize| found.balls[ball].orbital_speed_rad_s / found.inner_speed_rad_s;
        let rolling = |ball: usize, radius: f64| {
            let ball = &found.balls[ball];
            let [i, o] = [ball.contacts.inner, ball.contacts.outer].map(|c| radius * c.angle_rad.cos());
            // Jones and Harris take the free pitch circle.
            let orbit = if model == JonesHarris { 35e-3 } else { ball.orbit_radius_m };
            (orbit - i) / (2.0 * orbit + o - i)
        };
        let radius = 0.5 * 12.7e-3;
        // Against its opposite, so that what is common to all balls drops out.
        let behind = speed(4) - speed(11);
        let expected = rolling(4, radius + 10e-6) - rolling(11, radius);
        let of_size = expected - (rolling(4, radius) - rolling(11, radius));
        let off = (behind - expected).abs();
        assert!(of_size < -9e-5 && off < 0.03 * of_size.abs(), "{model:?}: {behind:e} for {expected:e}, {of_size:e}");
    }
}

/// Deviations of no size and a place that is that of the drawing change no bit.
#[test]
fn limit_without_size_nothing_changes() {
    let none = [
        ("deviations.inner.waves", "[(order: 9, amplitude: um(0), phase: deg(30))]"),
        ("deviations.outer.spectrum", "(first: 2, last: 50, amplitude: um(0), exponent: 1, seed: 4)"),
        ("deviations.balls", "Excess([um(0), um(0), um(0), um(0), um(0), um(0), um(0), um(0), um(0)])"),
    ];
    assert_eq!(displaced(&THRUST, &none), displaced(&THRUST, &[]));
    // A ring that is turned under its balls by a whole pitch of a wave is where it was.
    let waves = ("deviations.inner.waves", "[(order: 10, amplitude: um(0.2), phase: deg(0))]");
    let there = displaced(&THRUST, &[waves, ("deviations.position.inner", "deg(36)")]);
    let before = displaced(&THRUST, &[waves]);
    assert!(there.iter().zip(before).all(|(a, b)| (a - b).abs() < 1e-6));
}
