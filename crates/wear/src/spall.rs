//! Spalls: places where material is gone, with two edges along the path of the ball.

use crate::{Profile, WearError};
use serde::{Deserialize, Serialize};

/// A spall of a raceway, in the ring's own frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spall {
    /// Azimuth of its middle, rad.
    pub azimuth: f64,
    /// Length L between the edges along the path, m.
    pub length: f64,
    /// Width across the groove, m.
    pub width: f64,
    /// Depth h_0 of the bottom below the raceway, m.
    pub depth: f64,
    /// Radius r_e to which the edges are rounded, m; 0 for sharp ones.
    pub edge_radius: f64,
    /// Distance of its middle across the groove from the middle of the contact, m.
    pub across: f64,
}

/// The raceway that a spall is in, as a ball that rolls along it sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Track {
    /// Radius r of the ball, m.
    pub ball_radius: f64,
    /// Radius R of the circle of the contacts about the bearing's axis, m.
    pub radius: f64,
    /// True if the ball runs inside that circle, as on an outer race.
    pub outer: bool,
    /// Cosine of the contact angle α: along the path the race is curved by cos α/R.
    pub cosine: f64,
    /// Half of the contact ellipse's length along the path b, m.
    pub semi_rolling: f64,
    /// Half of its length across the groove a, m.
    pub semi_lateral: f64,
}

/// The path of the centre of a ball over a spall.
///
/// A ball of radius r turns about the leading edge until it meets the trailing one, and then about that. On the circle
/// of radius R its centre sinks, at the distance θ from the middle of a spall with sharp edges, sin β = L/2R, by
///
/// ```text
/// outer race  h = R cos(β − |θ|) − sqrt(r² − R² sin²(β − |θ|)) − (R − r)
/// inner race  h = R + r − R cos(β − |θ|) − sqrt(r² − R² sin²(β − |θ|)),     |θ| < β,  h ≤ h_0
/// ```
///
/// to the bottom at most: two arcs with a cusp between them, where the rate of h jumps by 2 v tan ϑ, sin ϑ = L/2r, v
/// the speed of the centre about the ring's axis. Round edges put r + r_e for r, R ± r_e for R (outer, inner race) and
/// L + 2 r_e for L; at a contact angle α it is R/cos α for R and θ cos α for θ.
///
/// A contact is not a point: the arcs are averaged over the length 2b of its ellipse with the weights ¾ (1 − ξ²), the
/// Hertz pressure summed across the groove, and a spall that is narrower than the ellipse takes the share of the load
/// that the pressure has over its width. Ellipse and share are those of one load, so that a contact has a potential and
/// a ball that passes keeps its energy.
///
/// That the entry is a weak step and the blow comes where the ball meets the second edge is what signals show:
/// doi:10.1177/1687814017703007.
#[derive(Debug, Clone, PartialEq)]
pub struct SpallPath {
    profile: Option<Profile>,
    /// Angle of an edge from the middle, rad.
    half_angle: f64,
    /// Half of the contact's length, rad.
    contact_angle: f64,
    azimuth: f64,
}

/// Places of the path within half a contact length: the mean of a cusp errs by less than 1 % of it between them.
const PER_CONTACT: f64 = 16.0;
/// Most places of a path.
const MOST: usize = 200_000;
/// Pieces of Simpson's rule over the contact.
const PIECES: usize = 128;

impl Spall {
    /// Sink of the centre of a ball at a distance from the middle, rad, on sharp or round edges with all of the load at
    /// one point, m.
    pub fn sink(&self, track: &Track, distance: f64) -> f64 {
        let r = track.ball_radius + self.edge_radius;
        let radius = self.rounded(track);
        let left = self.reach(track) - distance.abs() * track.cosine;
        if left <= 0.0 {
            return 0.0;
        }
        let (sin, cos) = left.sin_cos();
        // r − sqrt(r² − R² sin²) and R (1 − cos) in forms that do not cancel.
        let across = (radius * sin).powi(2);
        let of_ball = across / (r + (r * r - across).max(0.0).sqrt());
        let of_ring = across / radius / (1.0 + cos);
        (if track.outer { of_ball - of_ring } else { of_ball + of_ring }).min(self.depth)
    }

    /// Radius of the circle on which the middles of the rounded edges lie, m.
    fn rounded(&self, track: &Track) -> f64 {
        track.radius / track.cosine + if track.outer { self.edge_radius } else { -self.edge_radius }
    }

    /// Angle from the middle at which a ball begins to sink, seen from the middle of the race's curvature, rad.
    fn reach(&self, track: &Track) -> f64 {
        ((0.5 * self.length + self.edge_radius) / self.rounded(track)).min(1.0).asin()
    }

    /// Part of the load of a contact that the spall's width takes, 0 to 1.
    pub fn share(&self, track: &Track) -> f64 {
        // ∫ ¾ (1 − η²) from 0.
        let part = |place: f64| {
            let eta = (place / track.semi_lateral).clamp(-1.0, 1.0);
            0.25 * eta * (3.0 - eta * eta)
        };
        part(self.across + 0.5 * self.width) - part(self.across - 0.5 * self.width)
    }

    /// The path of the centre of a ball over it.
    ///
    /// # Errors
    /// [`WearError::Spall`] for values that no spall has.
    pub fn path(&self, track: &Track) -> Result<SpallPath, WearError> {
        self.check(track)?;
        let half_angle = (0.5 * self.length * track.cosine / track.radius).asin() / track.cosine;
        let share = self.share(track);
        let wide = track.semi_rolling / track.radius;
        let half = self.reach(track) / track.cosine + wide;
        let count = (2.0 * half / wide * PER_CONTACT).ceil().max(8.0);
        if count > MOST as f64 {
            return Err(WearError::Spall {
                name: "length",
                value: self.length,
                allowed: "some thousand contacts long",
            });
        }
        // An even number puts a place on the cusp.
        let count = 2 * (0.5 * count).ceil() as usize;
        let step = 2.0 * half / count as f64;
        let mean = |place: f64| {
            let node = |k: usize| {
                let at = 2.0 * k as f64 / PIECES as f64 - 1.0;
                let weight = if k == 0 || k == PIECES { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
                weight * (1.0 - at * at) * self.sink(track, place + wide * at)
            };
            share * 0.5 / PIECES as f64 * (0..=PIECES).map(node).sum::<f64>()
        };
        let depth = |k: usize| if k == 0 || k == count { 0.0 } else { mean(step * k as f64 - half) };
        let depths: Vec<f64> = (0..=count).map(depth).collect();
        let there = depths.iter().any(|depth| *depth != 0.0);
        let profile = there.then(|| Profile::through(self.azimuth - half, step, &depths));
        Ok(SpallPath { profile, half_angle, contact_angle: wide, azimuth: self.azimuth })
    }

    pub(crate) fn check(&self, track: &Track) -> Result<(), WearError> {
        let refuse = |name, value, allowed| Err(WearError::Spall { name, value, allowed });
        let longest = 2.0 * track.ball_radius.min(track.radius);
        if !self.azimuth.is_finite() {
            return refuse("azimuth", self.azimuth, "a finite angle in rad");
        }
        if !(self.length > 0.0 && self.length < longest) {
            return refuse("length", self.length, "above 0 m and below the diameter of the ball");
        }
        if !(self.width > 0.0 && self.width.is_finite()) {
            return refuse("width", self.width, "finite and above 0 m");
        }
        if !(self.depth >= 0.0 && self.depth.is_finite()) {
            return refuse("depth", self.depth, "finite and at least 0 m");
        }
        if !(self.edge_radius >= 0.0 && 0.5 * self.length + 2.0 * self.edge_radius < 0.5 * longest) {
            return refuse("edge radius", self.edge_radius, "at least 0 m, and small enough for the ball to pass over");
        }
        if !self.across.is_finite() {
            return refuse("distance across the groove", self.across, "a finite length in m");
        }
        Ok(())
    }
}

impl SpallPath {
    /// Depth, m, and its derivative by the azimuth, m/rad, at an azimuth in the ring's own frame, rad.
    #[inline]
    pub fn at(&self, azimuth: f64) -> (f64, f64) {
        self.profile.as_ref().map_or((0.0, 0.0), |profile| profile.at(azimuth))
    }

    /// True if the ball sinks nowhere: the spall has no depth, or lies beside the contact.
    pub fn is_flat(&self) -> bool {
        self.profile.is_none()
    }

    /// Azimuth of its middle, rad.
    pub fn azimuth(&self) -> f64 {
        self.azimuth
    }

    /// Half of the contact's length along the path, rad.
    pub fn contact_angle(&self) -> f64 {
        self.contact_angle
    }

    /// Angle of an edge from the middle, rad.
    pub fn half_angle(&self) -> f64 {
        self.half_angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// 6205 of the Case Western rig.
    const BALL: f64 = 0.5 * 7.94e-3;
    const PITCH: f64 = 39.04e-3;
    const OUTER: Track = Track {
        ball_radius: BALL,
        radius: 0.5 * PITCH + BALL,
        outer: true,
        cosine: 1.0,
        semi_rolling: 6e-5,
        semi_lateral: 6e-4,
    };
    const INNER: Track = Track { radius: 0.5 * PITCH - BALL, outer: false, ..OUTER };

    fn spall(length: f64) -> Spall {
        Spall { azimuth: 0.4, length, width: 2e-3, depth: 1e-3, edge_radius: 0.0, across: 0.0 }
    }

    fn with_contact(track: Track, semi_rolling: f64) -> Track {
        Track { semi_rolling, ..track }
    }

    /// R cos β − sqrt(r² − L²/4) − (R − r) and its counterpart as they stand, by another program.
    #[test]
    fn code_sinks_in_the_middle_of_sharp_spalls() {
        for (length, outer, inner) in
            [(0.18e-3, 0.8479e-6, 1.2807e-6), (0.53e-3, 7.3595e-6, 11.1125e-6), (2e-3, 106.713e-6, 160.196e-6)]
        {
            let spall = spall(length);
            assert!((spall.sink(&OUTER, 0.0) / outer - 1.0).abs() < 6e-5, "{length} {}", spall.sink(&OUTER, 0.0));
            assert!((spall.sink(&INNER, 0.0) / inner - 1.0).abs() < 6e-5, "{length} {}", spall.sink(&INNER, 0.0));
            assert_eq!(Spall { depth: 0.3e-6, ..spall }.sink(&OUTER, 0.0), 0.3e-6);
        }
    }

    /// At 1797 r/min of the inner ring and L 0.53 mm, 2 v tan ϑ. Seen from the edge it is 2 ω R tan(ϑ − β) to first
    /// order. With R − r for R, the orbit for the race, that is the 0.16263 m/s of the project's model page, which
    /// mixes the two radii.
    #[test]
    fn identity_the_radial_velocity_jumps_at_the_cusp() {
        let cage = 0.5 * 1797.0 * TAU / 60.0 * (1.0 - 2.0 * BALL / PITCH);
        let spall = spall(0.53e-3);
        let slope = (spall.sink(&OUTER, 1e-9) - spall.sink(&OUTER, 0.0)) / 1e-9;
        let jump = -2.0 * slope * cage;
        let orbit = OUTER.radius - BALL;
        let angle = (0.5 * 0.53e-3 / BALL).asin();
        let by_centre = 2.0 * cage * (orbit + spall.sink(&OUTER, 0.0)) * angle.tan();
        assert!((jump / by_centre - 1.0).abs() < 1e-5 && (jump - 0.1958).abs() < 1e-4, "{jump} {by_centre}");
        let from_edge = 2.0 * cage * OUTER.radius * (angle - (0.5 * 0.53e-3 / OUTER.radius).asin()).tan();
        assert!((jump / from_edge - 1.0).abs() < 2e-3, "{jump} {from_edge}");
        assert!((from_edge * orbit / OUTER.radius - 0.16263).abs() < 1e-5);
    }

    #[test]
    fn identity_a_path_is_even_about_its_middle_and_its_slope_the_derivative() {
        for track in [OUTER, INNER] {
            let path = spall(0.53e-3).path(&track).unwrap();
            let half = path.half_angle() + track.semi_rolling / track.radius;
            for k in 0..400 {
                let distance = 1.05 * half * f64::from(k) / 400.0;
                let (left, right) = (path.at(0.4 - distance), path.at(0.4 + distance + TAU));
                assert!((left.0 - right.0).abs() < 1e-16 && (left.1 + right.1).abs() < 1e-9, "{distance}");
                let difference = (path.at(0.4 + distance + 1e-7).0 - path.at(0.4 + distance - 1e-7).0) / 2e-7;
                assert!((difference - path.at(0.4 + distance).1).abs() < 2e-6, "{distance}");
            }
            assert_eq!(path.at(0.4 + 1.001 * half), (0.0, 0.0));
        }
    }

    /// A longer contact takes from the cusp and leaves the area; a short one leaves the sharp sink.
    #[test]
    fn limit_a_contact_longer_than_the_spall_bridges_it() {
        let depth = |b: f64| spall(0.53e-3).path(&with_contact(OUTER, b)).unwrap().at(0.4).0;
        let sharp = spall(0.53e-3).sink(&OUTER, 0.0);
        assert!((depth(1e-6) / sharp - 1.0).abs() < 0.01, "{}", depth(1e-6));
        assert!(depth(6e-5) < 0.95 * sharp && depth(6e-4) < 0.5 * depth(6e-5));
        let area = |b: f64| {
            let path = spall(0.53e-3).path(&with_contact(OUTER, b)).unwrap();
            (0..20_000).map(|k| path.at(0.3 + 1e-5 * f64::from(k)).0).sum::<f64>()
        };
        assert!((area(6e-5) / area(1e-5) - 1.0).abs() < 2e-3);
        // A spall of a quarter of the contact's length against one as long as it: less than a sixteenth of the depth,
        // which sharp edges would give.
        let of_length = |length: f64| spall(length).path(&with_contact(OUTER, 1e-4)).unwrap().at(0.4).0;
        assert!(of_length(5e-5) < of_length(2e-4) / 16.0, "{} {}", of_length(5e-5), of_length(2e-4));
    }

    #[test]
    fn limit_a_narrow_spall_takes_its_share_of_the_load() {
        let share = |width: f64, across: f64| Spall { width, across, ..spall(0.53e-3) }.share(&OUTER);
        assert_eq!((share(1.2e-3, 0.0), share(5e-3, 1e-3), share(1e-4, 1e-3)), (1.0, 1.0, 0.0));
        // Half of the width has 11/16 of the load, and both halves have all of it.
        assert!((share(6e-4, 0.0) - 0.6875).abs() < 1e-12);
        assert!((share(6e-4, 3e-4) - 0.5).abs() < 1e-12 && (share(6e-4, -3e-4) - 0.5).abs() < 1e-12);
        let depth = |width: f64| Spall { width, ..spall(0.53e-3) }.path(&OUTER).unwrap().at(0.4).0;
        assert!((depth(6e-4) / depth(2e-3) - 0.6875).abs() < 1e-12);
    }

    /// A round edge lets the ball sink earlier and deeper, by what it takes off: on a flat race
    /// r + r_e − sqrt((r + r_e)² − (L/2 + r_e)²).
    #[test]
    fn limit_round_edges() {
        let flat = Track { radius: 1e3, ..OUTER };
        for edge_radius in [0.0, 1e-5, 1e-4] {
            let round = Spall { edge_radius, ..spall(0.53e-3) };
            let (r, x) = (BALL + edge_radius, 0.265e-3 + edge_radius);
            let expected = r - (r * r - x * x).sqrt();
            let found = round.sink(&flat, 0.0);
            assert!((found / expected - 1.0).abs() < 1e-5, "{edge_radius}: {found:e} {expected:e}");
            assert!(round.sink(&OUTER, 0.265e-3 / OUTER.radius + 1e-9) > 0.0 || edge_radius == 0.0);
        }
    }

    #[test]
    fn limit_values_that_no_spall_has_are_refused() {
        let good = spall(0.53e-3);
        for (bad, field) in [
            (Spall { azimuth: f64::NAN, ..good }, "azimuth"),
            (Spall { length: 8e-3, ..good }, "length"),
            (Spall { length: 0.0, ..good }, "length"),
            (Spall { width: 0.0, ..good }, "width"),
            (Spall { depth: -1e-9, ..good }, "depth"),
            (Spall { edge_radius: 4e-3, ..good }, "edge radius"),
            (Spall { across: f64::NAN, ..good }, "distance across the groove"),
        ] {
            assert!(matches!(bad.path(&OUTER), Err(WearError::Spall { name, .. }) if name == field), "{bad:?}");
        }
        assert!(Spall { depth: 0.0, ..good }.path(&OUTER).unwrap().is_flat());
        assert!(Spall { across: 3e-3, ..good }.path(&OUTER).unwrap().is_flat());
    }
}
