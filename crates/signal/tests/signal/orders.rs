//! Order tracking.

use std::f64::consts::TAU;

use tribodyn_signal::{SignalError, Spectrum, Window, order_spectrum, resample_by_angle};

use crate::{assert_near, sampled, sine};

const RATE: f64 = 10_000.0;

/// Shaft from 10 to 30 turns per second in 5 s: 100 turns.
fn sweep() -> (Vec<f64>, Vec<f64>) {
    let speed = sampled(50_001, RATE, |t| TAU * (10.0 + 4.0 * t));
    let turns = |t: f64| 10.0 * t + 2.0 * t * t;
    let samples = sampled(50_001, RATE, |t| {
        2.0 * (TAU * 7.2 * turns(t)).sin() + (TAU * 13.0 * turns(t)).cos() + 0.5 * (TAU * 1.0 * turns(t)).cos()
    });
    (samples, speed)
}

#[test]
fn limit_a_sweep_is_a_line_over_orders_and_none_over_frequency() {
    let (samples, speed) = sweep();
    let orders = order_spectrum(&samples, RATE, &speed, None, Window::Hann).unwrap();
    let peaks = orders.peaks(3, 0.1);
    for (peak, (order, amplitude)) in peaks.iter().zip([(7.2, 2.0), (13.0, 1.0), (1.0, 0.5)]) {
        assert_near(peak.order, order, 1e-4);
        assert_near(peak.amplitude, amplitude, 1e-3);
    }
    let frequencies = Spectrum::of(&samples, RATE, Window::Hann).unwrap();
    assert!(frequencies.amplitude.iter().all(|a| *a < 0.3));
}

#[test]
fn identity_direction_of_rotation_does_not_matter() {
    let (samples, speed) = sweep();
    let back: Vec<f64> = speed.iter().map(|w| -w).collect();
    let one = resample_by_angle(&samples, RATE, &speed, Some(64)).unwrap();
    assert_eq!(one, resample_by_angle(&samples, RATE, &back, Some(64)).unwrap());
    assert_eq!((one.turns, one.samples_per_turn, one.values.len()), (100, 64, 6400));
}

#[test]
fn limit_constant_speed_only_changes_the_axis() {
    let samples = sampled(10_001, RATE, |t| sine(175.0, t));
    let speed = vec![TAU * 25.0; 10_001];
    let found = resample_by_angle(&samples, RATE, &speed, None).unwrap();
    assert_eq!((found.turns, found.samples_per_turn), (25, 400));
    for (n, value) in found.values.iter().enumerate() {
        assert_near(*value, samples[n], 1e-9);
    }
    let peak = order_spectrum(&samples, RATE, &speed, None, Window::FlatTop).unwrap().peaks(1, 0.0)[0];
    assert_near(peak.order, 7.0, 1e-6);
    assert_near(peak.amplitude, 1.0, 1e-6);
}

/// The 8-point polynomial's error grows with the eighth power of the frequency: 3e-5 at a tenth of the rate.
#[test]
fn limit_interpolation_error_is_that_of_its_order() {
    let worst = |part: f64| {
        let samples = sampled(10_001, RATE, |t| sine(part * RATE, t));
        let found = resample_by_angle(&samples, RATE, &vec![TAU; 10_001], Some(70_000)).unwrap();
        let exact = |n: usize| sine(part * RATE, n as f64 / 70_000.0);
        (100..69_900).map(|n| (found.values[n] - exact(n)).abs()).fold(0.0, f64::max)
    };
    assert!(worst(0.1) < 3e-5, "{}", worst(0.1));
    assert!((2e-3..7e-3).contains(&worst(0.2)), "{}", worst(0.2));
}

#[test]
fn limit_standing_and_reversing_shafts_are_refused() {
    let refuse = |speed: &[f64]| resample_by_angle(&[0.0; 100], 10.0, speed, None).unwrap_err();
    let mut speed = vec![50.0; 100];
    speed[40] = 0.0;
    assert_eq!(refuse(&speed), SignalError::Speed { index: 40, speed_rad_s: 0.0 });
    speed[40] = 0.1;
    assert!(matches!(refuse(&speed), SignalError::SpeedRange { limit: 64, .. }));
    assert_eq!(refuse(&speed[..50]), SignalError::SpeedCount { speeds: 50, count: 100 });
    assert!(matches!(refuse(&[0.1; 100]), SignalError::TooFewTurns { turns } if turns < 0.2));
    let coarse = resample_by_angle(&[0.0; 100], 10.0, &[5.0; 100], Some(3)).unwrap_err();
    assert_eq!(coarse, SignalError::TooFewSamples { count: 3, needed: 4 });
}
