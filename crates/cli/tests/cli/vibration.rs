//! `vibration`: a verdict with figures on a signal of known impacts, and what is refused.

use super::{Scratch, run_words};
use std::f64::consts::TAU;

/// Two seconds of impacts at BPFO of a 6205 that turns at 1797 r/min, ringing at 3.1 kHz, in noise.
fn signal() -> String {
    let (rate, pass) = (12_000.0, 3.5848 * 29.95);
    let mut state = 1u64;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let sample = |n: usize| {
        let t = n as f64 / rate;
        let since = (t * pass).fract() / pass;
        let ring = (-600.0 * since).exp() * (TAU * 3100.0 * since).sin();
        format!("{}\n", ring + 0.3 * (TAU * 29.95 * t).sin() + 0.5 * noise())
    };
    (0..24_000).map(sample).collect()
}

#[test]
fn limit_an_outer_race_is_told_and_drawn() {
    let scratch = Scratch::new();
    let file = scratch.file("signal.csv", format!("acceleration\n{}", signal()));
    let (file, folder) = (file.display().to_string(), scratch.0.join("out"));
    let command = format!("vibration {file} --rate 12000 --bearing 9,7.94,39.04 --speed 1797");
    let answer = run_words(&format!("{command} --json -o {}", folder.display())).json();
    assert_eq!(answer["verdict"]["fault"], "outer");
    let cage = answer["cage"]["speed_rpm"].as_f64().unwrap();
    assert!((cage / (3.5848 / 9.0 * 1797.0) - 1.0).abs() < 1e-3, "{cage}");
    for name in ["vibration.json", "envelope-spectrum.svg", "kurtogram.png", "signal.svg"] {
        assert!(folder.join(name).is_file(), "{name}");
    }
    // The sense of rotation says nothing here.
    assert_eq!(run_words(&command.replace("1797", "-1797 --json")).json()["verdict"]["fault"], "outer");
    for (options, message) in [
        ("--rate 12000 --bearing 9,7.94,39.04", "--speed: it is missing"),
        ("--rate 12000 --speed 1797", "--bearing"),
        ("--bearing 9,7.94,39.04 --speed 1797", "--rate"),
        ("--rate 12000 --bearing 9,7.94,39.04 --speed 0", "--speed 0"),
        ("--rate 12000 --bearing 9,7.94,39.04 --speed 1797 --slip 40", "--slip 40"),
        ("--rate 12000 --bearing 9,79.4,39.04 --speed 1797", "--bearing 9,79.4,39.04: 9 balls of 79.4 mm on"),
    ] {
        run_words(&format!("vibration {file} {options}")).fails(2, &[message]);
    }
}

/// Velocities need accelerations in m/s²; the third band of testers is beyond 12 kHz of samples.
#[test]
fn limit_velocities_are_those_of_accelerations() {
    let scratch = Scratch::new();
    let bands = |name: &str| {
        let file = scratch.file("signal.csv", format!("{name}\n{}", signal())).display().to_string();
        let answer =
            run_words(&format!("vibration {file} --rate 12000 --bearing 9,7.94,39.04 --speed 1797 --json")).json();
        answer["velocity_bands"].as_array().unwrap().clone()
    };
    assert!(bands("volts").is_empty());
    let found = bands("a_m_s2");
    assert_eq!(found.len(), 2, "{found:?}");
    assert_eq!((found[1]["low_hz"].as_f64(), found[1]["high_hz"].as_f64()), (Some(300.0), Some(1800.0)));
    assert!(found[1]["peak_m_s"].as_f64() > found[1]["rms_m_s"].as_f64(), "{found:?}");
}

/// A 6206 of class V2 by its middle band: of deep groove bearings at the speed of testers alone.
#[test]
fn limit_a_bearing_on_a_tester_has_a_class() {
    let scratch = Scratch::new();
    let rate = 25_600.0;
    let tone = |micrometres_s: f64, hz: f64, t: f64| {
        let omega = TAU * hz;
        1e-6 * micrometres_s * 2f64.sqrt() * omega * (omega * t).sin()
    };
    let sample = |n: usize| {
        let t = n as f64 / rate;
        tone(67.0, 120.0, t) + tone(102.0, 900.0, t) + tone(30.0, 4000.0, t)
    };
    let text: String = (0..20_480).map(|n| format!("{}\n", sample(n))).collect();
    let file = scratch.file("tester.csv", format!("a_m_s2\n{text}")).display().to_string();
    let class = |bearing: &str, speed: f64| {
        let command = format!("vibration {file} --rate {rate} --bearing {bearing} --speed {speed}");
        run_words(&format!("{command} --json")).json()["velocity_class"].clone()
    };
    let found = class("6206", 1800.0);
    assert_eq!(found["name"], "V2");
    assert_eq!(found["limits_m_s"].as_array().unwrap().len(), 3);
    // 102 µm/s are more than V3 allows a bore of 25 mm, and V2.
    assert_eq!(class("6205", 1800.0)["name"], "V1");
    for (bearing, speed) in [("6206", 3000.0), ("7206B", 1800.0), ("9,9.525,46", 1800.0)] {
        assert!(class(bearing, speed).is_null(), "{bearing} at {speed}");
    }
    run_words(&format!("vibration {file} --rate {rate} --bearing 9,9.525 --speed 1800"))
        .fails(2, &["--bearing 9,9.525", "such as 9,7.94,39.04"]);
}
