//! Runs with spalls, waves and unequal balls: nothing where they have no size, mirrored where the bearing is, and the
//! times at which balls pass.

use crate::{case, run};
use std::f64::consts::TAU;
use tribodyn_dynamics::{Event, EventKind, Sample};

const SHORT: [(&str, &str); 3] =
    [("transient.duration", "s(0.001)"), ("recording.state_rate", "kHz(20)"), ("recording.ball_rate", "kHz(20)")];

fn samples(changes: &[(&str, &str)]) -> Vec<Sample> {
    run(&case(&[&SHORT[..], changes].concat())).1.samples
}

/// A spall of the outer race: azimuth in rad, length in mm.
fn spall(azimuth: f64, length: f64) -> String {
    format!("(race: Outer, azimuth: rad({azimuth}), length: mm({length}), width: mm(20), depth: um(300))")
}

#[test]
fn limit_without_size_no_bit_changes() {
    let wave = "(waves: [(order: 9, amplitude: um(0), phase: deg(30))])";
    let none = [
        ("deviations.inner", wave),
        ("deviations.outer", wave),
        ("deviations.balls", "Excess([um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0),um(0)])"),
        ("spalls", "[(race: Inner, azimuth: deg(5), length: mm(2), width: mm(2), depth: um(0))]"),
    ];
    for scheme in ["RungeKutta4(step: us(5))", "Fast(step: us(10))", "DormandPrince(tolerance: 1e-6, longest: us(10))"]
    {
        let scheme = ("transient.scheme", scheme);
        assert_eq!(samples(&[scheme]), samples(&[&none[..], &[scheme]].concat()), "{scheme:?}");
    }
}

/// Faults on one side of the load, and their mirror image on the other side, with the rings turning backwards.
#[test]
fn identity_a_mirrored_bearing_has_the_mirrored_motion() {
    let waves = |phase: f64| format!("(waves: [(order: 11, amplitude: um(1), phase: rad({phase}))])");
    let uneven = |sense: f64| -> Vec<Sample> {
        let spalls = format!("[{}]", spall(0.2 * sense, 3.0));
        let sizes: Vec<String> =
            (0..13).map(|ball| format!("um({})", if sense > 0.0 { ball } else { (13 - ball) % 13 } % 5)).collect();
        let sizes = format!("Excess([{}])", sizes.join(", "));
        let speed = format!("Constant(rpm({}))", 14000.0 * sense);
        samples(&[
            ("transient.scheme", "RungeKutta4(step: us(5))"),
            ("spalls", &spalls),
            ("deviations.outer", &waves(0.7 * sense)),
            ("deviations.inner", &waves(0.3 * sense)),
            ("deviations.balls", &sizes),
            ("speed.inner", &speed),
        ])
    };
    let (plain, mirrored) = (uneven(1.0), uneven(-1.0));
    let sound = samples(&[("transient.scheme", "RungeKutta4(step: us(5))")]);
    let mut moved = 0.0f64;
    for ((a, b), sound) in plain.iter().zip(&mirrored).zip(&sound) {
        let ([a_x, a_y, ..], [b_x, b_y, ..]) = (a.outer.acceleration_m_s2, b.outer.acceleration_m_s2);
        assert!((a_x - b_x).abs() < 1e-5 && (a_y + b_y).abs() < 1e-5, "{a_x} {b_x} {a_y} {b_y}");
        moved = moved.max((a_x - sound.outer.acceleration_m_s2[0]).abs());
        for (ball, of_plain) in a.balls.iter().enumerate() {
            let of_mirrored = &b.balls[(13 - ball) % 13];
            let [q, p] = [of_plain, of_mirrored].map(|ball| ball.contacts.outer.load_n);
            assert!((q - p).abs() < 1e-5, "{q} {p}");
        }
    }
    assert!(moved > 1.0, "{moved} m/s²");
}

/// Each ball is over the edges as far apart in time as its speed has it, and in the middle halfway.
#[test]
fn identity_passages_take_the_time_of_the_length() {
    for length in [0.5, 1.0, 2.0, 3.0] {
        let spalls = format!("[{}]", spall(0.2, length));
        let case = case(&[&SHORT[..], &[("transient.scheme", "Fast(step: us(2))"), ("spalls", &spalls)]].concat());
        let (_, keep) = run(&case);
        let radius = case.bearing().unwrap().track_radius(tribodyn_bearing::Side::Outer);
        let passed = |event: &Event| match event.kind {
            EventKind::SpallPassed { ball, entered_s, struck_s, left_s, .. } => {
                Some((ball, [entered_s, struck_s, left_s]))
            }
            _ => None,
        };
        let passages: Vec<_> = keep.events.iter().filter_map(passed).collect();
        assert!(!passages.is_empty(), "{length} mm");
        for (ball, [entered, struck, left]) in passages {
            let at = |time: f64| (time * 20e3).round() as usize;
            let speed = keep.samples[at(struck)].balls[ball].orbital_speed_rad_s;
            let expected = 1e-3 * length / (radius * speed);
            assert!(((left - entered) / expected - 1.0).abs() < 5e-3, "{length}: {} {expected}", left - entered);
            assert!(((struck - entered) / (left - entered) - 0.5).abs() < 5e-3);
        }
    }
}

/// Under thrust alone two spalls half a pitch apart push along the axis by turns: the first harmonic of their passing
/// frequency goes, the second stays.
#[test]
fn identity_two_spalls_half_a_pitch_apart_have_no_first_harmonic() {
    let line = |spalls: &str, order: f64| {
        let (_, keep) = run(&case(&[
            ("ring.x", "Force(N(0))"),
            ("transient.duration", "s(0.012)"),
            ("transient.scheme", "Fast(step: us(5))"),
            ("recording.state_rate", "kHz(20)"),
            ("recording.ball_rate", "kHz(1)"),
            ("transient.contact_damping", "0.05"),
            ("spalls", spalls),
        ]));
        let from = keep.samples.len() / 3;
        let speed = keep.samples.iter().map(|s| s.cage.speed_rad_s).sum::<f64>() / keep.samples.len() as f64;
        // Whole periods of the passing frequency.
        let period = TAU / (13.0 * speed) * 20e3;
        let count = ((keep.samples.len() - from) as f64 / period).floor() * period;
        let taken = &keep.samples[from..][..count.round() as usize];
        let sum = taken.iter().fold([0.0; 2], |[re, im], sample| {
            let (sin, cos) = (order * 13.0 * speed * sample.time_s).sin_cos();
            let a = sample.inner.acceleration_m_s2[2];
            [re + a * cos, im + a * sin]
        });
        2.0 * sum[0].hypot(sum[1]) / taken.len() as f64
    };
    let (one, both) =
        (format!("[{}]", spall(0.1, 1.0)), format!("[{}, {}]", spall(0.1, 1.0), spall(0.1 + 0.5 * TAU / 13.0, 1.0)));
    let ratio = line(&both, 1.0) / line(&one, 1.0);
    let second = line(&both, 2.0) / line(&one, 2.0);
    assert!(ratio < 0.05 && second > 1.5, "{ratio} {second}");
}

/// Under thrust, bearings whose balls are all of either size have cages of different speeds. A cage with one odd ball
/// goes at a speed between them, near that of the many, and holds the odd ball at the wall towards which it would run.
#[test]
fn limit_one_odd_ball_stands_at_a_wall_of_its_pocket() {
    let thrust = [
        ("ring.x", "Force(N(0))"),
        ("ring.y", "Force(N(0))"),
        ("transient.duration", "s(0.06)"),
        ("recording.state_rate", "kHz(5)"),
        ("recording.ball_rate", "kHz(5)"),
        ("transient.scheme", "Fast(step: us(10))"),
    ];
    let settled = |sizes: [f64; 13]| {
        let sizes = format!("Excess([{}])", sizes.map(|size| format!("um({size})")).join(", "));
        let samples = run(&case(&[&thrust[..], &[("deviations.balls", &sizes)]].concat())).1.samples;
        let late = samples[samples.len() / 2..].to_vec();
        let mean = |of: &dyn Fn(&Sample) -> f64| late.iter().map(of).sum::<f64>() / late.len() as f64;
        let pocket = |sample: &Sample| sample.balls[0].pocket.unwrap();
        let lead = mean(&|sample| pocket(sample).lead_rad);
        (mean(&|sample| sample.cage.speed_rad_s), lead, mean(&|sample| pocket(sample).force_n.abs()))
    };
    let one = |size: f64| std::array::from_fn(|ball| if ball == 0 { size } else { 0.0 });
    let ((small, ..), (large, ..), (mixed, lead, force)) =
        (settled([0.0; 13]), settled([40.0; 13]), settled(one(40.0)));
    assert!(small > large + 5.0 && mixed < small && small - mixed < 0.2 * (small - large), "{small} {mixed} {large}");
    // Larger balls are slower here.
    assert!(lead < 0.0 && force > 100.0, "{lead} {force}");
}
