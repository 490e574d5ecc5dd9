//! The low-pass filter before decimation: bands, delay, memory.

use crate::{noise, sine};
use std::f64::consts::{PI, TAU};
use tribodyn_signal::{Decimator, DecimatorMemory};

/// Factors from the least to where the internal rate hardly matters.
const FACTORS: [usize; 5] = [1, 2, 3, 16, 64];

/// Mean of a sine of a frequency over the interval of `1/rate` before `end`.
fn mean_of_sine(frequency: f64, end: f64, rate: f64) -> f64 {
    let half = 0.5 / rate;
    let lowered = (PI * frequency / rate).sin() / (PI * frequency / rate);
    lowered * sine(frequency, end - half)
}

/// Outputs for a sine of a frequency over the output rate, from a filter at rest.
fn outputs(filter: &Decimator, frequency: f64, count: usize) -> Vec<f64> {
    let (mut memory, rate) = (filter.settled([0.0]), filter.factor() as f64);
    let inputs = (1..=count * filter.factor()).map(|j| mean_of_sine(frequency, j as f64 / rate, rate));
    inputs.filter_map(|x| filter.push(&mut memory, [x])).map(|[y]| y).collect()
}

/// The window smooths the sinc that the filter gives back, by the less the faster the inputs come.
fn ripple(factor: usize) -> f64 {
    5e-5 + 6e-4 / (factor * factor) as f64
}

#[test]
fn limit_the_pass_band_is_flat() {
    for factor in FACTORS {
        let filter = Decimator::new(factor).unwrap();
        let worst = (0..=130).map(|k| (filter.gain(3e-3 * f64::from(k)) - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < ripple(factor), "{factor}: {worst:e}");
    }
}

/// From half the output rate to half the internal one, side lobe by side lobe near the edge.
#[test]
fn limit_the_stop_band_is_80_db_down() {
    for factor in FACTORS.into_iter().filter(|factor| *factor > 1) {
        let filter = Decimator::new(factor).unwrap();
        let near = (500..1000).map(|k| 1e-3 * f64::from(k));
        let far = (0..300).map(|k| 1.0 + (0.5 * factor as f64 - 1.0) * f64::from(k) / 299.0);
        let worst = near.chain(far).map(|f| filter.gain(f).abs()).fold(0.0, f64::max);
        let attenuation = -20.0 * worst.log10();
        assert!(attenuation > Decimator::STOP_ATTENUATION_DB, "{factor}: {attenuation} dB");
    }
}

/// A sine comes back as it was [`Decimator::DELAY`] output intervals ago.
#[test]
fn limit_the_delay_is_a_whole_number_of_outputs() {
    for factor in [1, 2, 16] {
        let filter = Decimator::new(factor).unwrap();
        for frequency in [0.01, 0.123, 0.3, 0.39] {
            let all = outputs(&filter, frequency, 200);
            let settled = all.iter().enumerate().skip(2 * Decimator::DELAY);
            // The first output ends one interval after the start.
            let exact = |m: usize| sine(frequency, m as f64 + 1.0 - Decimator::DELAY as f64);
            let worst = settled.map(|(m, y)| (y - exact(m)).abs()).fold(0.0, f64::max);
            assert!(worst < ripple(factor), "{factor}, {frequency}: {worst:e}");
        }
    }
}

/// Vibration that would fold into the band is gone; sampled as it is it would come back whole.
#[test]
fn limit_nothing_folds() {
    let filter = Decimator::new(16).unwrap();
    for frequency in [0.51, 0.565, 0.7, 1.2, 3.9] {
        let left = outputs(&filter, frequency, 200).into_iter().skip(60).fold(0.0f64, |most, y| most.max(y.abs()));
        let sampled = (0..200).map(|m| sine(frequency, f64::from(m))).fold(0.0f64, |most, y| most.max(y.abs()));
        assert!(left < 1e-4 && sampled > 0.5, "{frequency}: {left:e}, {sampled}");
    }
}

/// A difference of the integral at the ends is the mean between them: the filter differentiates.
#[test]
fn identity_differences_of_a_velocity_give_the_acceleration() {
    let filter = Decimator::new(8).unwrap();
    let (mut memory, omega) = (filter.settled([0.0]), TAU * 0.2);
    let velocity = |j: usize| -(omega * j as f64 / 8.0).cos() / omega;
    let inputs = (1..=1600).map(|j| 8.0 * (velocity(j) - velocity(j - 1)));
    let found: Vec<f64> = inputs.filter_map(|x| filter.push(&mut memory, [x])).map(|[y]| y).collect();
    let exact = |m: usize| (omega * (m as f64 + 1.0 - Decimator::DELAY as f64)).sin();
    let worst = (60..200).map(|m| (found[m] - exact(m)).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-4, "{worst:e}");
}

#[test]
fn identity_a_settled_filter_gives_back_what_it_had() {
    let filter = Decimator::new(5).unwrap();
    let mut memory = filter.settled([3.0, -2.0]);
    for _ in 0..500 {
        if let Some(values) = filter.push(&mut memory, [3.0, -2.0]) {
            assert!((values[0] - 3.0).abs() < 1e-13 && (values[1] + 2.0).abs() < 1e-13, "{values:?}");
        }
    }
}

/// Saved as text at any input and taken up again, to the last bit.
#[test]
fn identity_a_saved_memory_goes_on_to_the_same_bits() {
    let filter = Decimator::new(7).unwrap();
    let inputs = noise(1000);
    let (mut whole, mut saved) = (filter.settled([0.1]), filter.settled([0.1]));
    for x in inputs {
        let text = serde_json::to_string(&saved).unwrap();
        saved = serde_json::from_str::<DecimatorMemory>(&text).unwrap();
        assert!(filter.remembers(&saved, 1) && !filter.remembers(&saved, 2));
        assert_eq!(filter.push(&mut whole, [x]), filter.push(&mut saved, [x]));
    }
    assert_eq!(whole, saved);
}

#[test]
fn limit_a_factor_of_nothing_is_refused() {
    assert!(Decimator::new(0).is_err());
}
