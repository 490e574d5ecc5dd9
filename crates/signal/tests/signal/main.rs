//! Signals with known spectra, envelopes, orders and moments.

mod bearing;
mod decimation;
mod diagnosis;
mod modulation;
mod orders;
mod spectra;
mod time;

use std::f64::consts::TAU;

/// Samples of a function of time, s.
fn sampled(count: usize, rate_hz: f64, f: impl Fn(f64) -> f64) -> Vec<f64> {
    (0..count).map(|n| f(n as f64 / rate_hz)).collect()
}

/// A sine of amplitude 1.
fn sine(frequency_hz: f64, time_s: f64) -> f64 {
    (TAU * frequency_hz * time_s).sin()
}

/// Even noise from −½ to ½, always the same (a linear congruential generator with Knuth's MMIX constants).
fn noise(count: usize) -> Vec<f64> {
    let mut state = 42u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..count).map(|_| next()).collect()
}

#[track_caller]
fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} ± {tolerance}");
}
