//! Envelopes.

use tribodyn_signal::{SignalError, envelope, envelope_spectrum};

use crate::{assert_near, noise, sampled, sine};

/// Carrier 3 kHz modulated by 60 % at 107 Hz, a stronger disturbance at 400 Hz.
fn modulated(t: f64) -> f64 {
    (1.0 + 0.6 * sine(107.0, t)) * sine(3000.0, t) + 5.0 * sine(400.0, t)
}

#[test]
fn limit_envelope_of_a_sine_is_its_amplitude() {
    for count in [1000, 999] {
        let rate = count as f64;
        let e = envelope(&sampled(count, rate, |t| 4.0 + 2.0 * sine(50.0, t)), rate, None).unwrap();
        assert!(e.iter().all(|v| (v - 2.0).abs() < 1e-12));
    }
}

#[test]
fn limit_modulation_is_the_line_of_the_envelope() {
    let samples = sampled(20_000, 20_000.0, modulated);
    let spectrum = envelope_spectrum(&samples, 20_000.0, Some([2500.0, 3500.0])).unwrap();
    assert_near(spectrum.mean, 1.0, 1e-9);
    let peak = spectrum.peaks(1, 0.0)[0];
    assert_near(peak.frequency_hz, 107.0, 1e-6);
    assert_near(peak.amplitude, 0.6, 1e-9);
    // Without the band the disturbance rules.
    let all = envelope_spectrum(&samples, 20_000.0, None).unwrap();
    assert!(all.peaks(1, 0.0)[0].frequency_hz > 2000.0);
}

#[test]
fn identity_the_signal_never_exceeds_its_envelope() {
    let samples = noise(5000);
    let mean = samples.iter().sum::<f64>() / 5000.0;
    let e = envelope(&samples, 1.0, None).unwrap();
    assert!(samples.iter().zip(&e).all(|(x, e)| (x - mean).abs() <= e + 1e-12));
}

#[test]
fn limit_bands_outside_are_refused() {
    let samples = noise(100);
    for band in [[-1.0, 10.0], [10.0, 60.0], [20.0, 20.0], [30.0, 20.0], [10.2, 10.7], [f64::NAN, 20.0]] {
        let refused = envelope(&samples, 100.0, Some(band)).unwrap_err();
        assert!(matches!(refused, SignalError::Band { nyquist_hz: 50.0, .. }), "{band:?} {refused}");
    }
    assert!(envelope(&samples, 100.0, Some([10.0, 50.0])).is_ok());
}
