//! Statistics, settling, periods.

use tribodyn_signal::{Period, Settling, SettlingRule, SignalError, Statistics, period, settling};

use crate::{assert_near, noise, sampled, sine};

#[test]
fn limit_moments_of_a_sine() {
    let s = Statistics::of(&sampled(1000, 1000.0, |t| 3.0 + 2.0 * sine(50.0, t))).unwrap();
    assert_near(s.mean, 3.0, 1e-12);
    assert_near(s.rms, 2f64.sqrt(), 1e-12);
    assert_near(s.rms_total, 11f64.sqrt(), 1e-12);
    assert_near(s.peak, 2.0, 1e-12);
    assert_near(s.peak_to_peak, 4.0, 1e-12);
    assert_near(s.crest_factor.unwrap(), 2f64.sqrt(), 1e-12);
    assert_near(s.kurtosis.unwrap(), 1.5, 1e-12);
    assert_near(s.skewness.unwrap(), 0.0, 1e-12);
    assert_eq!((s.minimum, s.maximum, s.count), (1.0, 5.0, 1000));
}

/// A Bernoulli variable with p = 0.2: kurtosis 3 + (1 − 6pq)/(pq) = 3.25, skewness (1 − 2p)/√(pq) = 1.5.
#[test]
fn limit_moments_of_a_pulse_train() {
    for scale in [1e-200, 1.0, 1e200] {
        let s = Statistics::of(&sampled(1000, 1.0, |t| if t % 5.0 == 0.0 { scale } else { 0.0 })).unwrap();
        assert_near(s.kurtosis.unwrap(), 3.25, 1e-9);
        assert_near(s.skewness.unwrap(), 1.5, 1e-9);
        assert_near(s.crest_factor.unwrap(), 2.0, 1e-9);
    }
}

#[test]
fn limit_even_noise_has_kurtosis_nine_fifths() {
    let s = Statistics::of(&noise(200_000)).unwrap();
    assert_near(s.kurtosis.unwrap(), 1.8, 0.01);
    assert_near(s.rms, 12f64.sqrt().recip(), 1e-3);
}

#[test]
fn limit_a_constant_has_no_shape() {
    let s = Statistics::of(&[0.1; 7]).unwrap();
    assert_eq!((s.kurtosis, s.crest_factor, s.skewness, s.rms), (None, None, None, 0.0));
    assert!(matches!(Statistics::of(&[]), Err(SignalError::TooFewSamples { .. })));
    assert!(matches!(Statistics::of(&[0.0, f64::INFINITY]), Err(SignalError::NotFinite { index: 1, .. })));
}

/// A mean that decays as exp(−t/τ) reaches the tolerance at τ ln(1/tolerance), the running mean by its average over the
/// window.
#[test]
fn limit_settling_time_of_a_decay() {
    let (tau, tolerance, window) = (0.1f64, 1e-3, 0.02);
    let samples = sampled(20_001, 10_000.0, |t| 5.0 + (-t / tau).exp() + 0.3 * sine(50.0, t));
    let rule = SettlingRule { window_s: window, mean_tolerance: tolerance, rms_tolerance: 0.1 };
    let found = settling(&samples, 10_000.0, rule).unwrap();
    let averaged = tau / window * (1.0 - (-window / tau).exp());
    assert_near(found.time_s.unwrap(), tau * (averaged / tolerance).ln(), 2e-3);
    assert_near(found.final_mean, 5.0, 1e-6);
    assert_near(found.final_rms, 0.3 / 2f64.sqrt(), 1e-6);
}

#[test]
fn limit_settling_sees_ripple_and_drift() {
    let rule = SettlingRule { window_s: 0.02, mean_tolerance: 0.01, rms_tolerance: 0.01 };
    let find = |f: &dyn Fn(f64) -> f64| settling(&sampled(10_000, 10_000.0, f), 10_000.0, rule).unwrap();
    let steady = find(&|_| 2.0);
    assert_eq!(steady, Settling { time_s: Some(0.0), final_mean: 2.0, final_rms: 0.0 });
    // The mean is steady throughout; the ripple ends at 0.4 s.
    let rippled = find(&|t| if t < 0.4 { sine(50.0, t) } else { 0.0 });
    assert_near(rippled.time_s.unwrap(), 0.4, 1e-3);
    assert_eq!(find(&|t| t).time_s, None);
    assert!(matches!(settling(&[0.0; 799], 10_000.0, rule), Err(SignalError::TooFewSamples { needed: 800, .. })));
}

#[test]
fn limit_period_of_a_signal_with_strong_harmonics() {
    // An orbit of 10.3 ms whose 13th harmonic is the strongest line, between samples.
    let orbit =
        |t: f64| 5800.0 + 4.0 * sine(1.0 / 0.0103, t) + 3.0 * sine(2.0 / 0.0103, t) + 5.0 * sine(13.0 / 0.0103, t);
    let found = period(&sampled(3000, 20_000.0, orbit), 20_000.0, [0.002, 0.05]).unwrap();
    assert_near(found.period_s, 0.0103, 2e-6);
    assert_near(found.correlation, 1.0, 1e-3);
}

#[test]
fn limit_period_of_noise_repeats_badly() {
    let Period { correlation, .. } = period(&noise(10_000), 1.0, [10.0, 1000.0]).unwrap();
    assert!(correlation < 0.1, "{correlation}");
}

#[test]
fn limit_periods_that_cannot_be_found_are_refused() {
    let ramp = sampled(100, 1.0, |t| t);
    assert!(matches!(period(&ramp, 1.0, [5.0, 40.0]), Err(SignalError::NoPeriod { .. })));
    assert!(matches!(period(&[0.0; 100], 1.0, [5.0, 40.0]), Err(SignalError::NoPeriod { .. })));
    assert!(matches!(period(&ramp, 1.0, [5.0, 51.0]), Err(SignalError::TooFewSamples { needed: 102, .. })));
    assert!(matches!(period(&ramp, 1.0, [40.0, 5.0]), Err(SignalError::Setting { .. })));
    assert!(matches!(period(&ramp, 1.0, [0.5, 5.0]), Err(SignalError::Setting { .. })));
}
