//! Accelerations sampled at the rate of a rig against those of the same motion seen sixteen times as often.

use crate::{Keep, STRIPS};
use tribodyn_case::{Case, set_value};
use tribodyn_dynamics::{FilterBands, Run, Sample};
use tribodyn_signal::{BearingFrequencies, Decimator, Spectrum, Window};

/// The paper's bearing with a defect: contacts vibrate at 14 kHz.
const DEFECT: &str = include_str!("../../../../fixtures/cases/paper-ag-defect.ron");
/// The rig's rate, Hz.
const RATE: f64 = 25_600.0;
/// Samples of the fine rate to one of the rig's.
const FINER: usize = 16;
/// Samples behind a spectrum: lines 50 Hz apart.
const COUNT: usize = 512;
/// From here on a line counts, over the highest: 40 dB below it.
const COUNTS: f64 = 0.01;

/// The case with its defect on a race, at a state rate.
fn case(race: &str, rate_hz: f64) -> Case {
    let defects = format!("[(race: {race}, azimuth: deg(0), width: deg(4), depth: um(2), bare: 1)]");
    let rate = format!("Hz({rate_hz})");
    let changes = [
        STRIPS,
        ("defects", &defects),
        ("transient.duration", "s(0.0305)"),
        ("recording.state_rate", &rate),
        ("recording.ball_rate", "kHz(1)"),
    ];
    let text = changes.iter().fold(DEFECT.to_owned(), |text, (path, value)| set_value(&text, path, value).unwrap());
    Case::from_ron(&text).unwrap()
}

fn samples(case: &Case) -> Vec<Sample> {
    let mut keep = Keep::default();
    let _ = Run::new(case.run_inputs().unwrap()).unwrap().advance(f64::INFINITY, &mut keep).unwrap();
    keep.samples
}

fn spectrum(samples: &[Sample], rate_hz: f64, get: fn(&Sample) -> f64) -> Spectrum {
    let signal: Vec<f64> = samples.iter().map(get).collect();
    Spectrum::of(&signal, rate_hz, Window::Hann).unwrap()
}

/// Lines of the pass band, line 0 left out.
fn passed(spectrum: &Spectrum) -> &[f64] {
    let end = spectrum.frequency_hz.partition_point(|hz| *hz <= Decimator::PASS_BAND * RATE);
    &spectrum.amplitude[1..end]
}

fn rms(lines: &[f64]) -> f64 {
    lines.iter().map(|a| a * a).sum::<f64>().sqrt()
}

/// Largest deviation of a line that counts, as a part of what it should be.
fn worst(found: &[f64], exact: &[f64]) -> f64 {
    let least = COUNTS * exact.iter().fold(0.0f64, |most, a| most.max(*a));
    let counting = found.iter().zip(exact).filter(|(a, b)| a.max(**b) > least);
    counting.map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
}

/// Runs a defect at both rates; the lines named must agree, and so must all that count. Sampled as they are,
/// accelerations have lines that did not occur: without the filter this fails.
fn check(race: &str, lines: impl Fn(&BearingFrequencies) -> Vec<f64>) {
    let coarse_case = case(race, RATE);
    let options = coarse_case.run_inputs().unwrap().options;
    let delay = FilterBands::new(options.scheme, options.state_rate).delay_s() * RATE;
    assert_eq!(delay, Decimator::DELAY as f64);
    let (coarse, fine) = (samples(&coarse_case), samples(&case(race, RATE * FINER as f64)));
    // What the filtered samples show is as much earlier as the filter is late.
    let end = coarse.len();
    let fine_end = FINER * (end - Decimator::DELAY);
    let recorded = &coarse[end - COUNT..];
    let exact = &fine[fine_end - FINER * COUNT..fine_end];
    let exact = spectrum(exact, RATE * FINER as f64, |s| s.outer.acceleration_point_m_s2[0]);
    let filtered = spectrum(recorded, RATE, |s| s.outer.acceleration_m_s2[0]);
    let point = spectrum(recorded, RATE, |s| s.outer.acceleration_point_m_s2[0]);
    let last = &coarse[end - 1];
    let (cage, inner, balls) = (last.cage.speed_rad_s, last.inner.speed_rad_s, last.balls.len());
    let frequencies = BearingFrequencies::from_run(cage, 0.0, inner, 0.0, balls).unwrap();
    for hz in lines(&frequencies) {
        let height = |s: &Spectrum| s.amplitude_near(hz, 50.0);
        let ratio = height(&filtered) / height(&exact);
        assert!((ratio - 1.0).abs() < 0.05, "{race}: {hz} Hz is {} of {}", height(&filtered), height(&exact));
    }
    let off = worst(passed(&filtered), passed(&exact));
    assert!(off < 0.05, "{race}: a line is off by {off:.3}");
    let ratio = rms(passed(&filtered)) / rms(passed(&exact));
    assert!((ratio - 1.0).abs() < 0.02, "{race}: rms {ratio:.4}");
    let unfiltered = worst(passed(&point), passed(&exact));
    assert!(unfiltered > 1.0, "{race}: without the filter {unfiltered:.3}");
    // Most of what folds lies within the contact modes.
    let beyond = exact.frequency_hz.partition_point(|hz| *hz < 0.5 * RATE);
    let share = (rms(&exact.amplitude[beyond..]) / rms(&exact.amplitude)).powi(2);
    assert!(share > 0.05, "{race}: {share:.3} of the variance is beyond half the rate");
    println!(
        "{race}: lines within {off:.1e} (as they are {unfiltered:.0}), rms {ratio:.5}, {share:.3} beyond {:.0} Hz",
        0.5 * RATE
    );
}

#[test]
fn identity_an_inner_race_defect_shows_lines_that_occur() {
    // The passing frequency with side lines at the turns of the shaft.
    check("Inner", |f| (-3..=3).map(|k| f.ball_pass_inner_hz + f64::from(k) * f.shaft_hz).collect());
}

#[test]
fn identity_an_outer_race_defect_shows_lines_that_occur() {
    check("Outer", |f| (1..=6).map(|k| f.ball_pass_outer_hz * f64::from(k)).collect());
}
