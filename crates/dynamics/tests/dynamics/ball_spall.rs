//! A spall of a ball in a whole run: how often it strikes, and whether its signal tells it.

use super::Keep;
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{EventKind, Run};
use tribodyn_signal::{Fault, Kinematics, Search, Shaft, diagnose};

const RATE: f64 = 25_600.0;

fn bearing() -> Kinematics {
    Kinematics {
        ball_count: 9,
        ball_diameter_m: 9.525e-3,
        pitch_diameter_m: 46e-3,
        contact_angle_rad: 0.0,
        inner_turns: 1.0,
        outer_turns: 0.0,
    }
}

/// Waves of the races without damage: tones at the rate of the balls, which are no blows.
#[test]
fn identity_waves_alone_are_not_told_as_damage() {
    let waves =
        |seed: u32| format!("(spectrum: (first: 2, last: 100, amplitude: um(0.5), exponent: 1.5, seed: {seed}))");
    let form = format!("(inner: {}, outer: {}, balls: Grade(grade: 10, seed: 3))", waves(11), waves(12));
    let changes = [
        ("transient.start", "QuasiStatic"),
        ("transient.scheme", "Fast(step: us(4))"),
        ("transient.contact_damping", "0.25"),
        ("transient.duration", "s(0.3)"),
        ("lubricant.patch", "TargetError(relative: 1e-3)"),
        ("recording", "(state_rate: kHz(25.6), ball_rate: Hz(100))"),
        ("deviations", &form),
    ];
    let text = include_str!("../../../../fixtures/cases/oil-6206.ron").to_owned();
    let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let mut run = Run::new(Case::from_ron(&text).unwrap().run_inputs().unwrap()).unwrap();
    let mut keep = Keep::default();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap();
    let signal: Vec<f64> = keep.samples.iter().skip(512).map(|s| s.outer.acceleration_m_s2[0]).collect();
    let search = Search { quiet: 0.1, ..Search::default() };
    let found = diagnose(&signal, RATE, Shaft::Near(50.0), &bearing(), search).unwrap();
    assert_eq!(found.verdict.fault, None, "{:?}", found.verdict.reasons);
    let inner = found.evidence.iter().find(|e| e.fault == Fault::Inner).unwrap();
    assert!(inner.log_chance < -8.0 && inner.modulation > 0.1, "it has the lines of waves: {inner:?}");
}

/// Both races meet the spall once a turn of the ball, and the verdict on the housing's signal is the ball. With waves
/// of the races and a lot of balls of grade 10; contacts are damped as those in oil are.
#[test]
fn identity_a_spall_of_a_ball_strikes_at_its_frequency_and_is_told() {
    let waves = "(spectrum: (first: 2, last: 60, amplitude: um(0.5), exponent: 1.5, seed: 1))";
    let form = format!("(inner: {waves}, outer: {waves}, balls: Grade(grade: 10, seed: 1))");
    let spall = "[(ball: 0, angle: deg(20), length: mm(1.5), width: mm(3), depth: um(150), edge_radius: um(20))]";
    let changes = [
        ("transient.start", "QuasiStatic"),
        ("transient.scheme", "Fast(step: us(2))"),
        ("transient.contact_damping", "0.25"),
        ("transient.duration", "s(0.4)"),
        ("recording", "(state_rate: kHz(25.6), ball_rate: Hz(100))"),
        ("deviations", &form),
        ("ball_spalls", spall),
    ];
    let text = include_str!("../../../../fixtures/cases/oil-6206.ron").to_owned();
    let text = changes.iter().fold(text, |text, (path, value)| set_value(&text, path, value).unwrap());
    let mut run = Run::new(Case::from_ron(&text).unwrap().run_inputs().unwrap()).unwrap();
    let mut keep = Keep::default();
    let _ = run.advance(f64::INFINITY, &mut keep).unwrap();

    let bearing = bearing();
    let strikes = 0.4 * 50.0 * bearing.per_turn().unwrap().ball_defect_hz;
    let passed = |at_inner: bool| {
        let is = |kind: &EventKind| match kind {
            EventKind::SpallPassed { inner, of_ball: true, .. } => *inner == at_inner,
            _ => false,
        };
        keep.events.iter().filter(|event| is(&event.kind)).count() as f64
    };
    for inner in [true, false] {
        assert!((passed(inner) - 0.5 * strikes).abs() < 2.5, "{inner}: {} of {strikes}", passed(inner));
    }
    let signal: Vec<f64> = keep.samples.iter().skip(1024).map(|s| s.outer.acceleration_m_s2[0]).collect();
    let found = diagnose(&signal, RATE, Shaft::Near(50.0), &bearing, Search::default()).unwrap();
    assert_eq!(found.verdict.fault, Some(Fault::Ball), "{:?}", found.verdict.reasons);
    let ball = found.evidence.iter().find(|e| e.fault == Fault::Ball).unwrap();
    assert!(ball.sidebands_log_chance.is_some_and(|chance| chance < -4.0), "{ball:?}");
}
