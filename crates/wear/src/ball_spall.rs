//! Spalls of balls: the race rolls over a ball whose surface has lost material between two edges.

use crate::{Profile, Spall, Track, WearError};
use std::f64::consts::FRAC_PI_2;

/// The sink of a ball over a race by a spall of its own, for one race.
///
/// The ball turns about the edge that it stands on until it meets the other one. With the angle θ of the middle of the
/// spall from the contact, seen from the ball's centre, sin β = L/2r and ψ = β − |θ|, its centre comes nearer to the
/// race by
///
/// ```text
/// outer race  h = r (1 − cos ψ) − (R − sqrt(R² − r² sin² ψ))
/// inner race  h = r (1 − cos ψ) + (R − sqrt(R² − r² sin² ψ)),     ψ > 0,  h ≤ h_0
/// ```
///
/// with r and R of a [`Spall`] of a race and its edges, contact angle, mean over the ellipse and share of the load.
/// That share follows the place y of the contact across the spall, so that a contact may miss it.
#[derive(Debug, Clone, PartialEq)]
pub struct BallSpallPath {
    /// Along rolling, for all of the load.
    profile: Option<Profile>,
    /// Half of the spall's width and of the contact's, m.
    half_width: f64,
    semi_lateral: f64,
    /// Angles of an edge and of half of the contact's length, rad.
    half_angle: f64,
    contact_angle: f64,
}

/// Depth of a spall of a ball at a contact, m, with its derivatives by the angle along rolling, m/rad, and by the place
/// across it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BallSpallDepth {
    /// Depth, m.
    pub depth: f64,
    /// By the angle of the spall's middle from the contact along rolling, m/rad.
    pub by_angle: f64,
    /// By the distance of the spall's middle from the contact across rolling.
    pub by_across: f64,
}

/// Places of the path within half a contact length, and pieces of Simpson's rule over the contact: as for races.
const PER_CONTACT: f64 = 16.0;
const PIECES: usize = 128;
/// Most places of a path.
const MOST: f64 = 200_000.0;

impl BallSpallPath {
    /// The path of a spall of a ball, its `azimuth` and `across` left aside, over a race.
    ///
    /// # Errors
    /// [`WearError::Spall`] for values that no spall has.
    pub fn new(spall: &Spall, track: &Track) -> Result<Self, WearError> {
        spall.check(track)?;
        let r = track.ball_radius;
        let (half_angle, wide) = ((0.5 * spall.length / r).asin(), track.semi_rolling / r);
        let half = half_angle + spall.edge_radius / r + wide;
        if 2.0 * half / wide * PER_CONTACT > MOST || half > FRAC_PI_2 {
            return Err(WearError::Spall {
                name: "length",
                value: spall.length,
                allowed: "far below the ball's diameter",
            });
        }
        let count = 2 * (half / wide * PER_CONTACT).ceil().max(4.0) as usize;
        let step = 2.0 * half / count as f64;
        let mean = |place: f64| {
            let node = |k: usize| {
                let at = 2.0 * k as f64 / PIECES as f64 - 1.0;
                let weight = if k == 0 || k == PIECES { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
                weight * (1.0 - at * at) * sink(spall, track, place + wide * at)
            };
            0.5 / PIECES as f64 * (0..=PIECES).map(node).sum::<f64>()
        };
        let depth = |k: usize| if k == 0 || k == count { 0.0 } else { mean(step * k as f64 - half) };
        let depths: Vec<f64> = (0..=count).map(depth).collect();
        let there = depths.iter().any(|depth| *depth != 0.0);
        Ok(Self {
            profile: there.then(|| Profile::through(-half, step, &depths)),
            half_width: 0.5 * spall.width,
            semi_lateral: track.semi_lateral,
            half_angle,
            contact_angle: wide,
        })
    }

    /// Depth where the spall's middle stands at an angle from the contact along rolling (rad) and at a distance across
    /// (m).
    #[inline]
    pub fn at(&self, angle: f64, across: f64) -> BallSpallDepth {
        let Some(profile) = &self.profile else { return BallSpallDepth::default() };
        let (depth, by_angle) = profile.at(angle);
        if depth == 0.0 && by_angle == 0.0 {
            return BallSpallDepth::default();
        }
        // ∫ ¾ (1 − η²) from 0, and ¾ (1 − η²) itself.
        let part = |place: f64| {
            let eta = (place / self.semi_lateral).clamp(-1.0, 1.0);
            (0.25 * eta * (3.0 - eta * eta), 0.75 * (1.0 - eta * eta) / self.semi_lateral)
        };
        let (far, near) = (part(across + self.half_width), part(across - self.half_width));
        let share = far.0 - near.0;
        BallSpallDepth { depth: share * depth, by_angle: share * by_angle, by_across: (far.1 - near.1) * depth }
    }

    /// True if the ball sinks nowhere.
    pub fn is_flat(&self) -> bool {
        self.profile.is_none()
    }

    /// Angle of an edge from the middle as seen from the ball's centre, rad.
    pub fn half_angle(&self) -> f64 {
        self.half_angle
    }

    /// Half of the contact's length as seen from the ball's centre, rad.
    pub fn contact_angle(&self) -> f64 {
        self.contact_angle
    }

    /// Farthest that the spall's middle may stand beside the contact, m.
    pub fn reach_across(&self) -> f64 {
        self.half_width + self.semi_lateral
    }
}

/// Sink with all of the load at one point, m.
fn sink(spall: &Spall, track: &Track, angle: f64) -> f64 {
    let r = track.ball_radius;
    let rounded = r - spall.edge_radius;
    let reach = ((0.5 * spall.length + spall.edge_radius) / rounded).min(1.0).asin();
    let left = reach - angle.abs();
    if left <= 0.0 {
        return 0.0;
    }
    // The middles of rounded edges stand on a smaller circle and roll on a race that is nearer by their radius.
    let radius = track.radius / track.cosine + if track.outer { -spall.edge_radius } else { spall.edge_radius };
    let (sin, cos) = left.sin_cos();
    let across = (rounded * sin).powi(2);
    let of_ball = across / rounded / (1.0 + cos);
    let of_race = across / (radius + (radius * radius - across).max(0.0).sqrt());
    (if track.outer { of_ball - of_race } else { of_ball + of_race }).min(spall.depth)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 6205 of the Case Western rig.
    const BALL: f64 = 0.5 * 7.94e-3;
    const OUTER: Track = Track {
        ball_radius: BALL,
        radius: 0.5 * 39.04e-3 + BALL,
        outer: true,
        cosine: 1.0,
        semi_rolling: 6e-5,
        semi_lateral: 6e-4,
    };
    const INNER: Track = Track { radius: 0.5 * 39.04e-3 - BALL, outer: false, ..OUTER };

    fn spall(length: f64) -> Spall {
        Spall { azimuth: 0.0, length, width: 2e-3, depth: 1e-3, edge_radius: 0.0, across: 0.0 }
    }

    /// In the middle both edges touch: two chords of the length L, that of the ball and that of the race.
    #[test]
    fn limit_the_sink_in_the_middle_is_that_of_the_same_spall_of_a_race() {
        for track in [OUTER, INNER] {
            for length in [0.2e-3, 0.5e-3, 2e-3] {
                let [of_ball, of_race] = [BALL, track.radius].map(|r| r - (r * r - 0.25 * length * length).sqrt());
                let expected = if track.outer { of_ball - of_race } else { of_ball + of_race };
                let found = sink(&spall(length), &track, 0.0);
                assert!((found / expected - 1.0).abs() < 1e-6, "{length}: {found:e} {expected:e}");
                let of_race = spall(length).sink(&track, 0.0);
                assert!((found / of_race - 1.0).abs() < 1e-3, "{length}: {found:e} {of_race:e}");
            }
        }
    }

    /// On a flat race a ball with the edge under it stands at r cos ψ.
    #[test]
    fn limit_a_flat_race() {
        let flat = Track { radius: 1e3, ..OUTER };
        let spall = spall(1e-3);
        let reach = (0.5e-3 / BALL).asin();
        for share in [0.0, 0.3, 0.9] {
            let expected = BALL * (1.0 - (reach * (1.0 - share)).cos());
            let found = sink(&spall, &flat, share * reach);
            assert!((found - expected).abs() < 1e-5 * expected, "{share}: {found:e} {expected:e}");
        }
        assert_eq!(sink(&spall, &flat, 1.01 * reach), 0.0);
    }

    #[test]
    fn identity_depths_have_their_derivatives() {
        let path = BallSpallPath::new(&Spall { width: 1e-3, edge_radius: 1e-5, ..spall(0.8e-3) }, &INNER).unwrap();
        for (angle, across) in [(0.03, 2e-4), (-0.05, -4e-4), (0.08, 6e-4), (0.02, 9e-4)] {
            let here = path.at(angle, across);
            let by_angle = (path.at(angle + 1e-7, across).depth - path.at(angle - 1e-7, across).depth) / 2e-7;
            let by_across = (path.at(angle, across + 1e-9).depth - path.at(angle, across - 1e-9).depth) / 2e-9;
            assert!(here.depth > 0.0, "{angle} {across}");
            assert!((here.by_angle - by_angle).abs() < 1e-6, "{angle}: {} {by_angle}", here.by_angle);
            assert!((here.by_across - by_across).abs() < 1e-6, "{across}: {} {by_across}", here.by_across);
        }
        // A contact beside the spall, and one that is not there yet.
        assert_eq!(path.at(0.0, 1.11e-3), BallSpallDepth::default());
        assert_eq!(path.at(0.2, 0.0), BallSpallDepth::default());
    }

    #[test]
    fn limit_a_spall_without_depth_is_flat() {
        assert!(BallSpallPath::new(&Spall { depth: 0.0, ..spall(1e-3) }, &OUTER).unwrap().is_flat());
        assert!(BallSpallPath::new(&Spall { length: 9e-3, ..spall(1e-3) }, &OUTER).is_err());
    }
}
