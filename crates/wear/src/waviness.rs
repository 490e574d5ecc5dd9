//! Waviness of a raceway: a Fourier series over the azimuth, from a list or from a seeded spectrum.

use crate::{Profile, Random, WearError};
use std::f64::consts::TAU;

/// Highest order: at 20 000 waves in a turn a wave is shorter than any contact.
pub const HIGHEST_ORDER: u32 = 20_000;
/// Places of the profile within the shortest wave: the cubic errs by 3e-7 of its amplitude.
const PER_WAVE: usize = 64;

/// A wave round a raceway, A cos(n φ + ψ) deeper than the round one, φ in the ring's own frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Order n, the waves in one turn.
    pub order: u32,
    /// Amplitude A, m.
    pub amplitude: f64,
    /// Phase ψ, rad.
    pub phase: f64,
}

/// Waves of the orders `first` to `last` with the amplitudes A_n = A_1 n^(−p) and phases at random: the form of the
/// spectra of ground and honed races.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveSpectrum {
    /// Lowest order, at least 1.
    pub first: u32,
    /// Highest order.
    pub last: u32,
    /// Amplitude A_1 that order 1 would have, m.
    pub amplitude: f64,
    /// Exponent p.
    pub exponent: f64,
    /// Seed of the phases: the same on every machine.
    pub seed: u64,
}

impl Wave {
    /// Depth, m, and its derivative by the azimuth, m/rad.
    pub fn at(&self, azimuth: f64) -> (f64, f64) {
        let order = f64::from(self.order);
        let (sin, cos) = (order * azimuth + self.phase).sin_cos();
        (self.amplitude * cos, -order * self.amplitude * sin)
    }

    /// Refuses amplitudes and phases that are not finite, and orders beyond a least and a highest one.
    pub(crate) fn check(&self, (least, highest): (u32, u32), allowed: &'static str) -> Result<(), WearError> {
        let refuse = |name, value, allowed| Err(WearError::Wave { name, value, allowed });
        if !(least..=highest).contains(&self.order) {
            return refuse("order", f64::from(self.order), allowed);
        }
        if !self.amplitude.is_finite() {
            return refuse("amplitude", self.amplitude, "a finite length in m");
        }
        if !self.phase.is_finite() {
            return refuse("phase", self.phase, "a finite angle in rad");
        }
        Ok(())
    }
}

impl WaveSpectrum {
    /// The waves. A phase depends on seed and order alone, not on the range.
    pub fn waves(&self) -> impl Iterator<Item = Wave> + '_ {
        (self.first..=self.last).map(|order| Wave {
            order,
            amplitude: self.amplitude * f64::from(order).powf(-self.exponent),
            phase: Random::new(self.seed, u64::from(order)).between(0.0, TAU),
        })
    }
}

/// The profile of a race with some waves; none where all of them have no amplitude, so that such a race is round to
/// the last bit.
///
/// # Errors
/// [`WearError::Wave`] for an order beyond 1 to [`HIGHEST_ORDER`], and amplitudes and phases that are not finite.
pub fn waviness(waves: &[Wave]) -> Result<Option<Profile>, WearError> {
    waves.iter().try_for_each(|wave| wave.check((1, HIGHEST_ORDER), "1 to 20000"))?;
    let there = || waves.iter().filter(|wave| wave.amplitude != 0.0);
    let Some(highest) = there().map(|wave| wave.order).max() else { return Ok(None) };
    let sum = |azimuth: f64| {
        there().map(|wave| wave.at(azimuth)).fold((0.0, 0.0), |sum, wave| (sum.0 + wave.0, sum.1 + wave.1))
    };
    Ok(Some(Profile::around(PER_WAVE * highest as usize, sum)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_profile_of_waves_is_their_sum_and_its_slope_the_derivative() {
        let waves: Vec<Wave> =
            WaveSpectrum { first: 2, last: 40, amplitude: 1e-6, exponent: 1.0, seed: 7 }.waves().collect();
        let profile = waviness(&waves).unwrap().unwrap();
        for k in -500..500 {
            let azimuth = 0.017 * f64::from(k);
            let sum = waves.iter().map(|wave| wave.at(azimuth));
            let (depth, slope) = sum.fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
            let found = profile.at(azimuth);
            assert!((found.0 - depth).abs() < 2e-13 && (found.1 - slope).abs() < 1e-9, "{azimuth}");
            let difference = (profile.at(azimuth + 1e-6).0 - profile.at(azimuth - 1e-6).0) / 2e-6;
            assert!((difference - found.1).abs() < 1e-8, "{azimuth}");
        }
        // Whole turns do not matter, and the seam is none.
        let (a, b) = (profile.at(TAU - 1e-12), profile.at(-1e-12 - 3.0 * TAU));
        assert!((a.0 - b.0).abs() < 1e-18 && (a.1 - b.1).abs() < 1e-14);
    }

    #[test]
    fn limit_a_spectrum_falls_off_and_repeats_with_its_seed() {
        let spectrum = WaveSpectrum { first: 2, last: 40, amplitude: 1e-6, exponent: 1.5, seed: 7 };
        let waves: Vec<Wave> = spectrum.waves().collect();
        assert_eq!((waves.len(), waves[0].order, waves[38].order), (39, 2, 40));
        assert!((waves[2].amplitude / 1e-6 - 0.125).abs() < 1e-12);
        assert!(spectrum.waves().eq(waves.iter().copied()));
        let shorter = WaveSpectrum { first: 5, last: 9, ..spectrum };
        assert!(shorter.waves().eq(waves[3..8].iter().copied()));
        assert!(WaveSpectrum { seed: 8, ..spectrum }.waves().zip(&waves).all(|(a, b)| a.phase != b.phase));
    }

    #[test]
    fn limit_waves_without_amplitude_leave_the_race_round() {
        let flat = Wave { order: 9, amplitude: 0.0, phase: 1.0 };
        assert_eq!(waviness(&[flat]), Ok(None));
        for (wave, field) in [
            (Wave { order: 0, ..flat }, "order"),
            (Wave { amplitude: f64::NAN, ..flat }, "amplitude"),
            (Wave { phase: f64::INFINITY, ..flat }, "phase"),
        ] {
            assert!(matches!(waviness(&[wave]), Err(WearError::Wave { name, .. }) if name == field));
        }
    }
}
