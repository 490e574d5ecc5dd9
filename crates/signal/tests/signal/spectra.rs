//! Amplitudes, peaks between lines, Parseval, harmonics, densities.

use proptest::prelude::*;
use tribodyn_signal::{Segments, SignalError, Spectrum, Statistics, Window, welch};

use crate::{assert_near, noise, sampled, sine};

const ALL: [Window; 3] = [Window::Hann, Window::Rectangular, Window::FlatTop];

#[test]
fn limit_sine_on_a_line_has_its_amplitude_with_every_window() {
    let samples = sampled(1000, 1000.0, |t| 5.0 + 2.5 * sine(100.0, t) + 0.5 * sine(250.0, t + 1e-4));
    for window in ALL {
        let spectrum = Spectrum::of(&samples, 1000.0, window).unwrap();
        assert_eq!(spectrum.line_spacing_hz(), 1.0);
        assert_eq!(spectrum.nyquist_hz(), 500.0);
        assert_near(spectrum.mean, 5.0, 1e-12);
        assert_near(spectrum.amplitude[0], 0.0, 1e-12);
        assert_near(spectrum.amplitude[100], 2.5, 1e-9);
        assert_near(spectrum.amplitude[250], 0.5, 1e-9);
        assert_near(spectrum.amplitude[400], 0.0, 1e-9);
    }
}

#[test]
fn limit_cosine_at_half_the_rate_has_its_amplitude() {
    let samples: Vec<f64> = (0..64).map(|n| if n % 2 == 0 { 3.0 } else { -3.0 }).collect();
    for window in ALL {
        let spectrum = Spectrum::of(&samples, 2.0, window).unwrap();
        assert_near(spectrum.amplitude[32], 3.0, 1e-12);
    }
}

#[test]
fn limit_sine_between_lines_is_found_where_it_is() {
    for window in ALL {
        for tenth in 0..10 {
            let frequency = 2000.0 + 0.1 * f64::from(tenth);
            let samples = sampled(10_000, 10_000.0, |t| 0.7 * sine(frequency, t + 3e-5));
            let peak = Spectrum::of(&samples, 10_000.0, window).unwrap().peaks(1, 0.0)[0];
            // Without a window the image at negative frequency leaks as 1/distance, 4000 lines away.
            let tolerance = if window == Window::Rectangular { 3e-4 } else { 1e-6 };
            assert_near(peak.frequency_hz, frequency, tolerance);
            assert_near(peak.amplitude, 0.7, tolerance);
        }
    }
}

#[test]
fn limit_raw_lines_between_fall_by_the_scalloping_loss() {
    let samples = sampled(1000, 1000.0, |t| sine(200.5, t));
    let highest =
        |window| Spectrum::of(&samples, 1000.0, window).unwrap().amplitude.iter().copied().fold(0.0, f64::max);
    assert_near(highest(Window::Hann), 0.8488, 1e-3);
    assert_near(highest(Window::Rectangular), std::f64::consts::FRAC_2_PI, 2e-3);
    assert_near(highest(Window::FlatTop), 0.9989, 1e-3);
}

#[test]
fn identity_variance_by_lines_is_that_of_the_weighted_samples() {
    for count in [999, 1000] {
        let samples: Vec<f64> = noise(count).iter().map(|x| x + 7.0).collect();
        let plain = Statistics::of(&samples).unwrap().rms.powi(2);
        assert_near(Spectrum::of(&samples, 50.0, Window::Rectangular).unwrap().variance(), plain, 1e-14);
        for window in ALL {
            let weights = window.weights(count);
            let total: f64 = weights.iter().sum();
            let mean = samples.iter().zip(&weights).map(|(x, w)| x * w).sum::<f64>() / total;
            let weighted: f64 = samples.iter().zip(&weights).map(|(x, w)| (w * (x - mean)).powi(2)).sum();
            let expected = weighted / weights.iter().map(|w| w * w).sum::<f64>();
            assert_near(Spectrum::of(&samples, 50.0, window).unwrap().variance(), expected, 1e-14);
        }
    }
}

#[test]
fn limit_peaks_come_by_height_and_keep_their_distance() {
    let samples = sampled(8000, 8000.0, |t| sine(500.0, t) + 3.0 * sine(1200.3, t) + 2.0 * sine(1206.3, t));
    let spectrum = Spectrum::of(&samples, 8000.0, Window::Hann).unwrap();
    let found: Vec<f64> = spectrum.peaks(3, 4.0).iter().map(|p| p.frequency_hz.round()).collect();
    assert_eq!(found, [1200.0, 1206.0, 500.0]);
    let apart: Vec<f64> = spectrum.peaks(2, 20.0).iter().map(|p| p.frequency_hz.round()).collect();
    assert_eq!(apart, [1200.0, 500.0]);
    assert_near(spectrum.amplitude_near(1205.0, 2.0), 2.0, 0.02);
    assert_near(spectrum.amplitude_near(3000.0, 0.0), 0.0, 1e-4);
    assert!(spectrum.amplitude_near(9000.0, 1.0) == 0.0);
}

#[test]
fn limit_harmonics_only_make_up_the_whole_variance() {
    let cage = 96.37;
    let harmonics = |t| sine(cage, t) + 0.5 * sine(2.0 * cage, t) + 0.25 * sine(13.0 * cage, t);
    let pure = Spectrum::of(&sampled(20_000, 20_000.0, harmonics), 20_000.0, Window::Hann).unwrap();
    let family = pure.harmonic_family(cage, 20, 0.5).unwrap();
    assert!(family.variance_share > 0.999 && family.line_share < 0.02, "{family:?}");
    let strong: Vec<_> = family.lines.iter().filter(|l| l.amplitude > 0.01).collect();
    assert_eq!(strong.iter().map(|l| l.order).collect::<Vec<_>>(), [1, 2, 13]);
    for (line, amplitude) in strong.iter().zip([1.0, 0.5, 0.25]) {
        assert_near(line.amplitude, amplitude, 1e-4);
        assert_near(line.off_lines, 0.0, 1e-3);
        assert!(line.floor_amplitude < 1e-4 * amplitude);
    }

    // A line of twice the power of the first harmonic that belongs to another family.
    let other = |t| harmonics(t) + 2f64.sqrt() * sine(333.3, t);
    let mixed = Spectrum::of(&sampled(20_000, 20_000.0, other), 20_000.0, Window::Hann).unwrap();
    let own = 1.0 + 0.25 + 0.0625;
    let family = mixed.harmonic_family(cage, 20, 0.5).unwrap();
    assert_near(family.variance_share, own / (own + 2.0), 1e-3);
}

#[test]
fn limit_a_detuned_family_is_off_by_the_lines_it_is_off() {
    let samples = sampled(10_000, 10_000.0, |t| sine(100.0, t) + sine(500.0, t));
    let spectrum = Spectrum::of(&samples, 10_000.0, Window::Hann).unwrap();
    let family = spectrum.harmonic_family(99.8, 5, 1.5).unwrap();
    // Peaks of rounding are peaks too.
    let strong = family.lines.iter().filter(|l| l.amplitude > 1e-9);
    let off: Vec<(usize, f64)> = strong.map(|l| (l.order, l.off_lines)).collect();
    assert_eq!(off.iter().map(|l| l.0).collect::<Vec<_>>(), [1, 5]);
    assert_near(off[0].1, 0.2, 1e-3);
    assert_near(off[1].1, 1.0, 1e-3);
    let refused = spectrum.harmonic_family(5.0, 5, 1.0).unwrap_err();
    assert!(matches!(refused, SignalError::Fundamental { least_hz, .. } if (least_hz - 6.0).abs() < 1e-9));
}

#[test]
fn limit_noise_has_no_family() {
    let spectrum = Spectrum::of(&noise(20_000), 20_000.0, Window::Hann).unwrap();
    let family = spectrum.harmonic_family(96.37, 50, 1.0).unwrap();
    assert_near(family.variance_share, family.line_share, 0.15 * family.line_share);
    let above: f64 =
        family.lines.iter().map(|l| l.amplitude / l.floor_amplitude).sum::<f64>() / family.lines.len() as f64;
    assert!((0.5..3.0).contains(&above), "{above}");
}

#[test]
fn limit_density_of_white_noise_is_flat_and_holds_its_variance() {
    let samples = noise(200_000);
    let density = welch(&samples, 1000.0, Segments::half_overlapping(1000)).unwrap();
    assert_eq!(density.segment_count, 399);
    // Even noise of width 1: variance 1/12 over 500 Hz.
    assert_near(density.variance(0.0, 500.0), 1.0 / 12.0, 1e-3);
    assert_near(density.variance(100.0, 199.5), 1.0 / 60.0, 5e-4);
    assert_near(density.density_per_hz[250], 1.0 / 6000.0, 0.2 / 6000.0);
}

#[test]
fn identity_density_of_a_sine_holds_half_its_squared_amplitude() {
    let samples = sampled(10_240, 1024.0, |t| 3.0 * sine(100.0, t));
    for window in ALL {
        let segments = Segments { length: 1024, overlap: 300, window };
        assert_near(welch(&samples, 1024.0, segments).unwrap().variance(90.0, 110.0), 4.5, 1e-9);
    }
}

#[test]
fn limit_bad_input_is_refused() {
    let hann = |samples: &[f64], rate| Spectrum::of(samples, rate, Window::Hann).unwrap_err();
    assert_eq!(hann(&[1.0; 3], 1.0), SignalError::TooFewSamples { count: 3, needed: 4 });
    assert_eq!(hann(&[1.0; 8], 0.0), SignalError::Rate { rate_hz: 0.0 });
    assert!(matches!(hann(&[1.0; 8], f64::NAN), SignalError::Rate { .. }));
    assert!(matches!(hann(&[1.0, f64::NAN, 0.0, 0.0], 1.0), SignalError::NotFinite { index: 1, .. }));
    let refused = welch(&[0.0; 100], 1.0, Segments::half_overlapping(101)).unwrap_err();
    assert_eq!(refused, SignalError::Segments { segment: 101, overlap: 50, count: 100 });
}

#[test]
fn identity_spectrum_survives_json() {
    let spectrum = Spectrum::of(&noise(64), 10.0, Window::FlatTop).unwrap();
    let text = serde_json::to_string(&spectrum).unwrap();
    let back: Spectrum = serde_json::from_str(&text).unwrap();
    assert_eq!(back.window, Window::FlatTop);
    assert!(text.contains("frequency_hz") && back.amplitude.len() == 33);
}

proptest! {
    #![proptest_config(ProptestConfig {
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(352),
        ..ProptestConfig::with_cases(64)
    })]

    /// Any sine well away from both ends, at any phase, in a record of any length.
    #[test]
    fn identity_any_sine_is_found(
        place in 30.0..170.0f64, phase in 0.0..6.3f64, amplitude in 1e-9..1e9f64, count in 400usize..450,
    ) {
        let rate = count as f64;
        let samples = sampled(count, rate, |t| amplitude * (std::f64::consts::TAU * place * t + phase).sin());
        let peak = Spectrum::of(&samples, rate, Window::Hann).unwrap().peaks(1, 0.0)[0];
        prop_assert!((peak.frequency_hz - place).abs() < 1e-3, "{} {}", peak.frequency_hz, place);
        prop_assert!((peak.amplitude / amplitude - 1.0).abs() < 1e-3);
    }
}
