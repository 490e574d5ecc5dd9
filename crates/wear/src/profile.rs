//! Races that are not round: waviness, spalls with two edges, measured profiles.

use crate::WearError;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// A wave round a raceway: `A cos(n (φ − φ_0))` deeper than the round race, φ in the ring's own frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Wave {
    /// Waves in one turn n.
    pub order: u32,
    /// Amplitude A, m.
    pub amplitude: f64,
    /// Azimuth φ_0 of a deepest place, rad.
    pub azimuth: f64,
}

/// Waves of the orders `first` to `last` with amplitudes `A_n = A (n/first)^(−p)` and phases drawn at random from a seed:
/// ground races have spectra that fall off about so.
///
/// The seed gives the same waves everywhere (SplitMix64: S. Vigna, public domain).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WaveSpectrum {
    /// Lowest order, at least 1.
    pub first: u32,
    /// Highest order.
    pub last: u32,
    /// Amplitude of the lowest order A, m.
    pub amplitude: f64,
    /// Exponent p.
    pub exponent: f64,
    /// Seed of the phases.
    pub seed: u64,
}

impl WaveSpectrum {
    /// The waves.
    pub fn waves(&self) -> Vec<Wave> {
        let mut state = self.seed;
        let mut turn = || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
        };
        let wave = |order: u32| {
            let amplitude = self.amplitude * (f64::from(order) / f64::from(self.first)).powf(-self.exponent);
            Wave { order, amplitude, azimuth: TAU * turn() / f64::from(order) }
        };
        (self.first..=self.last).map(wave).collect()
    }
}

/// A spall with two edges along the path of the ball.
///
/// A rigid ball of radius r turns about the leading edge until it meets the trailing one, and then about that. On the
/// circle of radius R that its contacts make its centre sinks, at the distance θ from the middle of a spall of the length
/// L, sin β = L/2R, by
///
/// ```text
/// outer race  h = R cos(β − |θ|) − sqrt(r² − R² sin²(β − |θ|)) − (R − r)
/// inner race  h = R + r − R cos(β − |θ|) − sqrt(r² − R² sin²(β − |θ|)),   |θ| ≤ β,   h ≤ h_0
/// ```
///
/// to the bottom h_0 at most: two arcs with a cusp, at which the radial velocity jumps by 2 v tan ϑ, sin ϑ = L/2r,
/// v the speed of the centre about the axis: the line from the edge to the centre stands at ϑ to the radius there. What the contact presses on is an ellipse, and edges are
/// rounded: the arcs are averaged over the half-length b along the path with the weights `¾ (1 − ξ²)` of a Hertz pressure
/// summed across the groove, and a spall narrower than the ellipse takes only its share of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spall {
    /// Middle, rad, in the ring's own frame.
    pub azimuth: f64,
    /// Length L along the path, m.
    pub length: f64,
    /// Depth h_0 of its bottom, m.
    pub depth: f64,
    /// Half-length b over which edges and contact are spread along the path, m.
    pub spread: f64,
    /// Share of the load that the spall would have carried, 0 to 1.
    pub share: f64,
}

/// Radii that a spall is seen with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Radius of the ball, m.
    pub ball_radius: f64,
    /// Radius of the circle of the contacts about the bearing's axis, m.
    pub radius: f64,
    /// Whether the ball runs inside it, as on an outer race.
    pub outer: bool,
}

/// Depth of a raceway below the round one where it is known at places along its azimuth.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Profile {
    /// First place, rad, in the ring's own frame.
    begin: f64,
    /// Distance of the places, rad.
    step: f64,
    /// Depth at the places, m; 0 before the first and after the last.
    depth: Vec<f64>,
    /// Its derivative by the azimuth there, m/rad.
    slope: Vec<f64>,
}

/// Places of a spall's profile within its spread: a quarter of a per cent of the sink is left between them.
const PER_SPREAD: f64 = 16.0;
/// Most places of one profile.
const MOST: usize = 200_000;
/// Nodes of the mean over the spread.
const NODES: usize = 65;

impl Spall {
    /// Sink of a rigid ball at a distance from the middle, rad, with sharp edges and all of the load, m.
    pub fn sink(&self, track: &Track, distance: f64) -> f64 {
        let Track { ball_radius: r, radius, outer } = *track;
        let left = (0.5 * self.length / radius).asin() - distance.abs();
        if left <= 0.0 {
            return 0.0;
        }
        let (sin, cos) = left.sin_cos();
        // R (cos − 1) + r − sqrt(r² − R² sin²) in the form that does not cancel.
        let across = (radius * sin).powi(2);
        let ball = across / (r + (r * r - across).max(0.0).sqrt());
        let ring = across / radius / (1.0 + cos);
        (if outer { ball - ring } else { ball + ring }).min(self.depth)
    }

    /// The path of the ball's centre over the spall.
    ///
    /// # Errors
    /// [`WearError::Defect`] for values that no spall has, a length above that of the ball's radius among them.
    pub fn profile(&self, track: &Track) -> Result<Profile, WearError> {
        let refuse = |name, value, allowed| Err(WearError::Defect { name, value, allowed });
        if !self.azimuth.is_finite() {
            return refuse("azimuth", self.azimuth, "a finite angle in rad");
        }
        if !(self.length > 0.0 && self.length <= track.ball_radius) {
            return refuse("length", self.length, "above 0 m and at most the radius of the ball");
        }
        if !(self.depth > 0.0 && self.depth.is_finite()) {
            return refuse("depth", self.depth, "finite and above 0 m");
        }
        if !(self.spread > 0.0 && self.spread <= track.ball_radius) {
            return refuse("spread", self.spread, "above 0 m and at most the radius of the ball");
        }
        if !(0.0..=1.0).contains(&self.share) {
            return refuse("share", self.share, "0 to 1");
        }
        let wide = self.spread / track.radius;
        let half = (0.5 * self.length / track.radius).asin() + wide;
        let count = (2.0 * half / wide * PER_SPREAD).ceil().max(8.0) as usize;
        if count > MOST {
            return refuse("spread", self.spread, "at least a few thousandths of the length");
        }
        let step = 2.0 * half / count as f64;
        let mean = |place: f64| {
            // Simpson's rule over the spread.
            let node = |k: usize| {
                let at = 2.0 * k as f64 / (NODES - 1) as f64 - 1.0;
                let simpson = if k == 0 || k == NODES - 1 { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
                simpson * (1.0 - at * at) * self.sink(track, place + wide * at)
            };
            self.share * 0.75 * 2.0 / (3.0 * (NODES - 1) as f64) * (0..NODES).map(node).sum::<f64>()
        };
        let depth: Vec<f64> = (0..=count).map(|k| if k == 0 || k == count { 0.0 } else { mean(step * k as f64 - half) }).collect();
        Ok(Profile::through(self.azimuth - half, step, depth))
    }
}

impl Profile {
    /// The profile through depths (m) at even places from `begin` (rad) on, `step` rad apart, with the first and last one
    /// at 0: measured ones begin and end on the round race.
    ///
    /// # Errors
    /// [`WearError::Defect`] for fewer than three depths, numbers that are not finite, a step that is not above 0, ends
    /// that are not 0, more than a turn.
    pub fn new(begin: f64, step: f64, depth: Vec<f64>) -> Result<Self, WearError> {
        let refuse = |name, value, allowed| Err(WearError::Defect { name, value, allowed });
        if !begin.is_finite() {
            return refuse("begin", begin, "a finite angle in rad");
        }
        if depth.len() < 3 || !(step > 0.0 && step * (depth.len() - 1) as f64 <= TAU) {
            return refuse("step", step, "above 0 rad, at least three places within a turn");
        }
        if let Some(bad) = depth.iter().find(|depth| !depth.is_finite()) {
            return refuse("depth", *bad, "finite");
        }
        if let Some(end) = [depth[0], depth[depth.len() - 1]].into_iter().find(|end| *end != 0.0) {
            return refuse("depth at the ends", end, "0 m");
        }
        Ok(Self::through(begin, step, depth))
    }

    fn through(begin: f64, step: f64, depth: Vec<f64>) -> Self {
        let last = depth.len() - 1;
        let slope = |k: usize| if k == 0 || k == last { 0.0 } else { (depth[k + 1] - depth[k - 1]) / (2.0 * step) };
        let slope = (0..=last).map(slope).collect();
        Self { begin, step, depth, slope }
    }

    /// Checks what was stored.
    pub(crate) fn check(&self) -> Result<(), WearError> {
        if self.slope.len() != self.depth.len() {
            let (name, allowed) = ("number of slopes", "that of the depths");
            return Err(WearError::Defect { name, value: self.slope.len() as f64, allowed });
        }
        Self::new(self.begin, self.step, self.depth.clone()).map(|_| ())
    }

    /// Depth, m, and its derivative by the azimuth, m/rad: both continuous (cubic Hermite).
    #[inline]
    pub fn at(&self, azimuth: f64) -> (f64, f64) {
        let turned = azimuth - self.begin;
        let place = (turned - TAU * (turned * (1.0 / TAU)).floor()) / self.step;
        let k = place as usize;
        if k + 1 >= self.depth.len() {
            return (0.0, 0.0);
        }
        let t = place - k as f64;
        let (a, b) = (self.depth[k], self.depth[k + 1]);
        let (c, d) = (self.step * self.slope[k], self.step * self.slope[k + 1]);
        // Powers of t about the left place.
        let (two, three) = (3.0 * (b - a) - 2.0 * c - d, 2.0 * (a - b) + c + d);
        (a + t * (c + t * (two + t * three)), (c + t * (2.0 * two + 3.0 * t * three)) / self.step)
    }
}

impl Wave {
    pub(crate) fn check(&self) -> Result<(), WearError> {
        let refuse = |name, value, allowed| Err(WearError::Defect { name, value, allowed });
        if !self.amplitude.is_finite() {
            return refuse("amplitude", self.amplitude, "finite");
        }
        if !self.azimuth.is_finite() {
            return refuse("azimuth", self.azimuth, "a finite angle in rad");
        }
        Ok(())
    }

    /// Depth, m, and its derivative by the azimuth, m/rad.
    #[inline]
    pub fn at(&self, azimuth: f64) -> (f64, f64) {
        let order = f64::from(self.order);
        let (sin, cos) = (order * (azimuth - self.azimuth)).sin_cos();
        (self.amplitude * cos, -order * self.amplitude * sin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 6205 of the Case Western rig.
    const BALL: f64 = 0.5 * 7.94e-3;
    const PITCH: f64 = 39.04e-3;
    const OUTER: Track = Track { ball_radius: BALL, radius: 0.5 * PITCH + BALL, outer: true };
    const INNER: Track = Track { ball_radius: BALL, radius: 0.5 * PITCH - BALL, outer: false };

    fn spall(length: f64, spread: f64) -> Spall {
        Spall { azimuth: 0.4, length, depth: 1e-3, spread, share: 1.0 }
    }

    /// Computed apart from this code, with R cos β − sqrt(r² − L²/4) − (R − r) as it stands.
    #[test]
    fn limit_sinks_in_the_middle_of_sharp_spalls() {
        for (length, outer, inner) in
            [(0.18e-3, 0.8479e-6, 1.2807e-6), (0.53e-3, 7.3595e-6, 11.1125e-6), (2e-3, 106.713e-6, 160.196e-6)]
        {
            let spall = spall(length, 1e-5);
            assert!((spall.sink(&OUTER, 0.0) / outer - 1.0).abs() < 6e-5, "{length} {}", spall.sink(&OUTER, 0.0));
            assert!((spall.sink(&INNER, 0.0) / inner - 1.0).abs() < 6e-5, "{length} {}", spall.sink(&INNER, 0.0));
            let shallow = Spall { depth: 0.3e-6, ..spall };
            assert_eq!(shallow.sink(&OUTER, 0.0), 0.3e-6);
        }
    }

    /// 2 v tan ϑ at 1797 r/min of the inner ring, L 0.53 mm. By small angles it is the speed of the contact, R ω, times
    /// 2 (ϑ − β); with the speed of the centre instead it would come out at 0.16263 m/s, (R − r)/R of this.
    #[test]
    fn identity_the_radial_velocity_jumps_at_the_cusp() {
        let cage = 0.5 * 1797.0 * TAU / 60.0 * (1.0 - 2.0 * BALL / PITCH);
        let spall = spall(0.53e-3, 1e-5);
        let slope = (spall.sink(&OUTER, 1e-9) - spall.sink(&OUTER, 0.0)) / 1e-9;
        let speed = cage * (0.5 * PITCH + spall.sink(&OUTER, 0.0));
        let angle = (0.5 * 0.53e-3 / BALL).asin();
        let jump = -2.0 * slope * cage;
        assert!((jump / (2.0 * speed * angle.tan()) - 1.0).abs() < 1e-5, "{jump}");
        let by_contact = 2.0 * cage * OUTER.radius * (angle - (0.5 * 0.53e-3 / OUTER.radius).asin());
        assert!((jump / by_contact - 1.0).abs() < 5e-3 && (jump - 0.1958).abs() < 1e-4, "{jump} {by_contact}");
    }

    #[test]
    fn identity_a_profile_is_even_about_its_middle_and_its_slope_its_derivative() {
        let profile = spall(0.53e-3, 60e-6).profile(&OUTER).unwrap();
        let half = 0.5 * 0.53e-3 / OUTER.radius + 60e-6 / OUTER.radius;
        for k in 0..400 {
            let distance = 1.05 * half * f64::from(k) / 400.0;
            let (left, right) = (profile.at(0.4 - distance), profile.at(0.4 + distance + TAU));
            assert!((left.0 - right.0).abs() < 1e-16 && (left.1 + right.1).abs() < 1e-9, "{distance}");
            let difference = (profile.at(0.4 + distance + 1e-7).0 - profile.at(0.4 + distance - 1e-7).0) / 2e-7;
            assert!((difference - profile.at(0.4 + distance).1).abs() < 2e-6, "{distance}");
        }
        assert_eq!(profile.at(0.4 + 1.001 * half), (0.0, 0.0));
    }

    /// Blunting takes from the cusp and leaves the area; with a short spread the sharp sink is left.
    #[test]
    fn limit_a_contact_longer_than_the_spall_bridges_it() {
        let depth = |spread: f64| spall(0.53e-3, spread).profile(&OUTER).unwrap().at(0.4).0;
        let sharp = spall(0.53e-3, 1e-5).sink(&OUTER, 0.0);
        assert!((depth(1e-6) / sharp - 1.0).abs() < 0.01, "{}", depth(1e-6));
        assert!(depth(6e-5) < 0.95 * sharp && depth(3e-4) < 0.5 * depth(6e-5));
        let area = |spread: f64| {
            let profile = spall(0.53e-3, spread).profile(&OUTER).unwrap();
            (0..20_000).map(|k| profile.at(0.3 + 1e-5 * f64::from(k)).0).sum::<f64>()
        };
        assert!((area(6e-5) / area(1e-5) - 1.0).abs() < 2e-3);
        let half = Spall { share: 0.5, ..spall(0.53e-3, 6e-5) }.profile(&OUTER).unwrap();
        assert!((half.at(0.4).0 / depth(6e-5) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn limit_a_spectrum_of_waves_falls_off_and_repeats_with_its_seed() {
        let spectrum = WaveSpectrum { first: 2, last: 40, amplitude: 1e-6, exponent: 1.5, seed: 7 };
        let waves = spectrum.waves();
        assert_eq!((waves.len(), waves[0].order, waves[38].order), (39, 2, 40));
        assert!((waves[2].amplitude / 1e-6 - 2f64.powf(-1.5)).abs() < 1e-12);
        assert_eq!(waves, spectrum.waves());
        assert_ne!(waves, WaveSpectrum { seed: 8, ..spectrum }.waves());
        let (depth, slope) = Wave { order: 9, amplitude: 2e-7, azimuth: 0.1 }.at(0.1 + TAU / 36.0);
        assert!(depth.abs() < 1e-20 && (slope + 9.0 * 2e-7).abs() < 1e-18);
    }

    #[test]
    fn limit_values_that_no_spall_or_profile_has_are_refused() {
        let refused = |spall: Spall, field: &str| {
            let error = spall.profile(&OUTER).unwrap_err();
            assert!(matches!(error, WearError::Defect { name, .. } if name == field), "{error}");
        };
        refused(Spall { length: 5e-3, ..spall(1e-3, 1e-5) }, "length");
        refused(Spall { spread: 0.0, ..spall(1e-3, 1e-5) }, "spread");
        refused(Spall { share: 1.5, ..spall(1e-3, 1e-5) }, "share");
        refused(Spall { depth: 0.0, ..spall(1e-3, 1e-5) }, "depth");
        assert!(Profile::new(0.0, 0.1, vec![0.0, 1e-6, 1e-7]).is_err());
        assert!(Profile::new(0.0, 4.0, vec![0.0, 1e-6, 0.0]).is_err());
        assert_eq!(Profile::new(0.0, 0.1, vec![0.0, 1e-6, 0.0]).unwrap().at(0.1).0, 1e-6);
    }
}
