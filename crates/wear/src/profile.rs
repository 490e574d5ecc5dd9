//! Depth of a raceway below the round one as a table over the azimuth.

use std::f64::consts::TAU;
use std::sync::Arc;

/// Depth below the round raceway at even places along the azimuth, and a cubic through each two of them with their
/// slopes: depth and slope are continuous, and the slope is the derivative of the depth to the last digit, so that a
/// ball that rolls over it keeps its energy.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// First place, rad, in the ring's own frame.
    begin: f64,
    /// Distance of the places, rad.
    step: f64,
    /// Depth at each place, m, and its derivative by the azimuth times the distance, m.
    places: Arc<[[f64; 2]]>,
    /// True if it goes once round; else the raceway is round before the first place and after the last.
    around: bool,
}

impl Profile {
    /// A profile once round with this many places, from depth (m) and slope (m/rad) at an azimuth (rad).
    pub(crate) fn around(count: usize, at: impl Fn(f64) -> (f64, f64)) -> Self {
        let step = TAU / count as f64;
        let place = |k: usize| {
            let (depth, slope) = at(step * (k % count) as f64);
            [depth, step * slope]
        };
        Self { begin: 0.0, step, places: (0..=count).map(place).collect(), around: true }
    }

    /// A profile through depths (m) at places `step` (rad) apart from `begin` (rad) on; first and last are to be 0.
    pub(crate) fn through(begin: f64, step: f64, depths: &[f64]) -> Self {
        let last = depths.len() - 1;
        let slope = |k: usize| if k == 0 || k == last { 0.0 } else { 0.5 * (depths[k + 1] - depths[k - 1]) };
        Self { begin, step, places: (0..=last).map(|k| [depths[k], slope(k)]).collect(), around: false }
    }

    /// Depth, m, and its derivative by the azimuth, m/rad, at an azimuth in the ring's own frame, rad.
    #[inline]
    pub fn at(&self, azimuth: f64) -> (f64, f64) {
        let turned = azimuth - self.begin;
        let place = (turned - TAU * (turned * (1.0 / TAU)).floor()) / self.step;
        let last = self.places.len() - 1;
        let k = if place < last as f64 {
            place as usize
        } else if self.around {
            // Rounding may lead past the last place, and a motion beyond all numbers leads nowhere.
            last - 1
        } else {
            return (0.0, 0.0);
        };
        let t = place - k as f64;
        let ([a, c], [b, d]) = (self.places[k], self.places[k + 1]);
        // Powers of t about the left place.
        let (two, three) = (3.0 * (b - a) - 2.0 * c - d, 2.0 * (a - b) + c + d);
        (a + t * (c + t * (two + t * three)), (c + t * (2.0 * two + 3.0 * t * three)) / self.step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run whose motion goes beyond all numbers ends with a sentence, not in here.
    #[test]
    fn limit_places_beyond_all_numbers_are_round() {
        let through = Profile::through(0.1, 0.01, &[0.0, 1e-6, 1e-6, 0.0]);
        let around = Profile::around(64, |azimuth: f64| (azimuth.cos(), -azimuth.sin()));
        for azimuth in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(through.at(azimuth), (0.0, 0.0));
            assert!(around.at(azimuth).0.is_nan());
        }
        for azimuth in [1e30, -1e30, f64::MAX, f64::MIN] {
            assert!(through.at(azimuth).0.is_finite() && !around.at(azimuth).0.is_infinite(), "{azimuth}");
        }
        assert!(through.at(0.115).0 > 0.9e-6 && (around.at(1.0).0 - 1f64.cos()).abs() < 1e-4);
    }
}
