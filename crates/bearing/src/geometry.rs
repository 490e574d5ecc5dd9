//! Groove-centre geometry of an angular-contact ball bearing (Jones).

use crate::BearingError;
use crate::races::{Races, Side};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use tribodyn_contact::Scalar;

/// Main dimensions of a bearing, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimensions {
    /// Number of balls N_b.
    pub ball_count: usize,
    /// Ball diameter D, m.
    pub ball_diameter: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Inner groove radius over ball diameter, f_i.
    pub inner_coefficient: f64,
    /// Outer groove radius over ball diameter, f_o.
    pub outer_coefficient: f64,
    /// Contact angle or radial clearance, one gives the other.
    pub fit: Fit,
}

/// The free contact state of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fit {
    /// Free contact angle α0, rad.
    ContactAngle(f64),
    /// Diametral (radial internal) clearance P_d, m: cos α0 = 1 − P_d/(2A). Below 0 the balls are pressed radially, and
    /// α0 is 0.
    RadialClearance(f64),
}

/// The sides of a groove that have a shoulder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Shoulders {
    /// Both: the race carries thrust either way, as in deep-groove bearings and those with a split ring.
    Both,
    /// The one on which a positive axial load presses the balls; the other side is relieved.
    One,
}

/// The unloaded bearing, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Geometry {
    /// Number of balls N_b.
    pub ball_count: usize,
    /// Ball diameter D, m.
    pub ball_diameter: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Inner groove radius over ball diameter, f_i.
    pub inner_coefficient: f64,
    /// Outer groove radius over ball diameter, f_o.
    pub outer_coefficient: f64,
    /// Free contact angle α0, rad, its sine and cosine: every contact of every ball asks for them.
    contact_angle: [f64; 3],
    /// Diametral interference of balls that are pressed radially without load, m; 0 where there is clearance.
    interference: f64,
    /// Shoulders of the grooves; absent where they are not known.
    pub shoulders: Option<Races<Shoulders>>,
}

impl Geometry {
    /// Largest diametral interference over the distance of the groove centres: beyond it no ring is still elastic.
    pub const INTERFERENCE_MAX: f64 = 0.1;

    /// Works out the free contact angle.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] for a radial clearance that no contact angle has.
    pub fn new(dimensions: Dimensions) -> Result<Self, BearingError> {
        let Dimensions { ball_count, ball_diameter, pitch_diameter, inner_coefficient, outer_coefficient, fit } =
            dimensions;
        let (contact_angle, interference) = match fit {
            Fit::ContactAngle(angle) => (angle, 0.0),
            Fit::RadialClearance(clearance) => {
                let centre_distance = (inner_coefficient + outer_coefficient - 1.0) * ball_diameter;
                let (least, most) = (-Self::INTERFERENCE_MAX * centre_distance, 2.0 * centre_distance);
                if !(least..=most).contains(&clearance) {
                    return Err(BearingError::Clearance { clearance, least, most });
                }
                // At most 1, where rounding of a clearance of 0 would leave more.
                let cosine = (1.0 - clearance / most).min(1.0);
                (cosine.acos(), (-clearance).max(0.0))
            }
        };
        Ok(Self {
            ball_count,
            ball_diameter,
            pitch_diameter,
            inner_coefficient,
            outer_coefficient,
            contact_angle: [contact_angle, contact_angle.sin(), contact_angle.cos()],
            interference,
            shoulders: None,
        })
    }

    /// The same bearing with its grooves' shoulders.
    pub fn with_shoulders(self, shoulders: Option<Races<Shoulders>>) -> Self {
        Self { shoulders, ..self }
    }

    /// True where a groove has a shoulder on one side only, so that the bearing carries thrust along +Z alone.
    pub fn is_one_sided(&self) -> bool {
        self.shoulders.is_some_and(|shoulders| Side::BOTH.iter().any(|side| shoulders[*side] == Shoulders::One))
    }

    /// Free contact angle α0, rad.
    pub fn contact_angle(&self) -> f64 {
        self.contact_angle[0]
    }

    /// sin α0.
    #[inline]
    pub fn sin_contact_angle(&self) -> f64 {
        self.contact_angle[1]
    }

    /// cos α0.
    #[inline]
    pub fn cos_contact_angle(&self) -> f64 {
        self.contact_angle[2]
    }

    /// Ball radius r_b, m.
    #[inline(always)]
    pub fn ball_radius(&self) -> f64 {
        0.5 * self.ball_diameter
    }

    /// Distance A = (f_i + f_o − 1) D of the two groove centres, unloaded, m.
    #[inline(always)]
    pub fn centre_distance(&self) -> f64 {
        (self.inner_coefficient + self.outer_coefficient - 1.0) * self.ball_diameter
    }

    /// Diametral clearance that belongs to the free contact angle, P_d = 2A (1 − cos α0), m; below 0 where the balls
    /// are pressed radially.
    pub fn radial_clearance(&self) -> f64 {
        2.0 * self.centre_distance() * (1.0 - self.cos_contact_angle()) - self.interference
    }

    /// Diametral interference of balls that are pressed radially without load, m; 0 where there is clearance.
    pub fn interference(&self) -> f64 {
        self.interference
    }

    /// Radial distance of the circles of groove centres, A cos α0 without interference, m.
    #[inline(always)]
    pub fn radial_distance(&self) -> f64 {
        self.centre_distance() * self.cos_contact_angle() + 0.5 * self.interference
    }

    /// Axial play from one contact side to the other under no load, 2A sin α0, m.
    pub fn axial_play(&self) -> f64 {
        2.0 * self.centre_distance() * self.sin_contact_angle()
    }

    /// Distance of the unloaded ball centre from a groove centre, (f − ½) D, m.
    #[inline(always)]
    pub fn groove_offset(&self, side: Side) -> f64 {
        (self.coefficient(side) - 0.5) * self.ball_diameter
    }

    /// Groove radius over ball diameter.
    #[inline(always)]
    pub fn coefficient(&self, side: Side) -> f64 {
        match side {
            Side::Inner => self.inner_coefficient,
            Side::Outer => self.outer_coefficient,
        }
    }

    /// Radius of the circle of groove centres about the ring's axis, m.
    #[inline(always)]
    pub fn groove_centre_radius(&self, side: Side) -> f64 {
        let offset = self.groove_offset(side) * self.cos_contact_angle();
        match side {
            Side::Inner => 0.5 * self.pitch_diameter + offset + 0.5 * self.interference,
            Side::Outer => 0.5 * self.pitch_diameter - offset,
        }
    }

    /// Radius of the bottom of a groove, m.
    pub fn groove_bottom_radius(&self, side: Side) -> f64 {
        let groove = self.coefficient(side) * self.ball_diameter;
        match side {
            Side::Inner => self.groove_centre_radius(side) - groove,
            Side::Outer => self.groove_centre_radius(side) + groove,
        }
    }

    /// Radius of the deformed contact across the groove, R_c = 2 r_b r_e/(r_b + r_e) (Heathcote), m.
    pub fn surface_radius(&self, side: Side) -> f64 {
        let (ball, groove) = (self.ball_radius(), self.coefficient(side) * self.ball_diameter);
        2.0 * ball * groove / (ball + groove)
    }

    /// Sums of the two bodies' curvatures along rolling and across the groove, 1/m, at contact angle cosine `cos`.
    pub fn curvatures<D: Scalar>(&self, side: Side, cos: D) -> [D; 2] {
        let ball = 2.0 / self.ball_diameter;
        let gamma = cos * (self.ball_diameter / self.pitch_diameter);
        let rolling = match side {
            Side::Inner => gamma / (-gamma + 1.0) * ball,
            Side::Outer => -(gamma / (gamma + 1.0)) * ball,
        };
        let groove = 1.0 / (self.coefficient(side) * self.ball_diameter);
        [rolling + ball, D::from(ball - groove)]
    }
}

/// Where the ball sits between the groove centres: what both contacts need to know.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPose<D = f64> {
    /// sin α.
    pub sin: D,
    /// cos α.
    pub cos: D,
    /// Elastic approach δ, m; negative where there is a gap.
    pub approach: D,
}

impl<D: Scalar> ContactPose<D> {
    /// From the vector (axial, radial) between groove centre and ball centre and the unloaded distance.
    #[inline(always)]
    pub fn new(axial: D, radial: D, offset: f64) -> Self {
        let length = (axial * axial + radial * radial).sqrt();
        let over = length.recip();
        Self { sin: axial * over, cos: radial * over, approach: length - offset }
    }

    /// Outward normal from the ball centre, (axial, radial) components.
    #[inline(always)]
    pub fn normal(&self, side: Side) -> [D; 2] {
        match side {
            Side::Inner => [-self.sin, -self.cos],
            Side::Outer => [self.sin, self.cos],
        }
    }
}

impl ContactPose {
    /// Contact angle, rad.
    #[inline(always)]
    pub fn angle(&self) -> f64 {
        angle(self.sin, self.cos)
    }
}

/// Of (arctan t − t)/t³ in t², |t| ≤ tan π/16: Taylor's, the next term is below 2e-17 of the sum.
const ARCTAN: [f64; 11] = [
    -1.0 / 3.0,
    1.0 / 5.0,
    -1.0 / 7.0,
    1.0 / 9.0,
    -1.0 / 11.0,
    1.0 / 13.0,
    -1.0 / 15.0,
    1.0 / 17.0,
    -1.0 / 19.0,
    1.0 / 21.0,
    -1.0 / 23.0,
];

/// Angle from −π to π of a sine and a cosine whose squares sum up to one, without a branch or a call, to 6e-16 of it.
#[inline(always)]
fn angle(sin: f64, cos: f64) -> f64 {
    let (s, c) = (sin.abs(), cos.abs());
    // Cosines of the half and the quarter of the angle in the first quadrant, and the tangent of its eighth.
    let half = (0.5 * (1.0 + c)).sqrt();
    let quarter = (0.5 * (1.0 + half)).sqrt();
    let t = s / (4.0 * half * quarter * (1.0 + quarter));
    let z = t * t;
    let mut sum = ARCTAN[10];
    for i in 0..10 {
        sum = sum * z + ARCTAN[9 - i];
    }
    let first = 8.0 * (t + t * z * sum);
    let size = if cos < 0.0 { PI - first } else { first };
    if sin < 0.0 { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_angles_are_those_of_the_library() {
        for k in -100_000..=100_000 {
            let (sin, cos) = (f64::from(k) * PI / 1e5).sin_cos();
            let exact = sin.atan2(cos);
            assert!((angle(sin, cos) - exact).abs() <= 6e-16 * exact.abs().max(0.25), "{} {exact}", angle(sin, cos));
        }
        // Small angles keep their digits.
        assert!((angle(1e-9, 1.0) / 1e-9 - 1.0).abs() < 3e-16);
    }

    fn dimensions(fit: Fit) -> Dimensions {
        Dimensions {
            ball_count: 13,
            ball_diameter: 0.03016,
            pitch_diameter: 0.165,
            inner_coefficient: 0.527,
            outer_coefficient: 0.53,
            fit,
        }
    }

    #[test]
    fn identity_contact_angle_and_clearance_give_each_other() {
        let angle = Geometry::new(dimensions(Fit::ContactAngle(18f64.to_radians()))).unwrap();
        let clearance = Geometry::new(dimensions(Fit::RadialClearance(angle.radial_clearance()))).unwrap();
        assert!((clearance.contact_angle() - angle.contact_angle()).abs() < 1e-13);
    }

    #[test]
    fn limit_excessive_clearance_is_refused() {
        assert!(matches!(Geometry::new(dimensions(Fit::RadialClearance(0.01))), Err(BearingError::Clearance { .. })));
    }

    #[test]
    fn identity_groove_centres_lie_one_centre_distance_apart() {
        let g = Geometry::new(dimensions(Fit::ContactAngle(0.3))).unwrap();
        let radial = g.groove_centre_radius(Side::Inner) - g.groove_centre_radius(Side::Outer);
        assert!((radial - g.centre_distance() * 0.3f64.cos()).abs() < 1e-16);
    }

    /// With α = 0 the curvature along rolling is that of the groove bottom, radius (d_m ∓ D)/2.
    #[test]
    fn limit_curvatures_of_a_radial_contact() {
        let g = Geometry::new(dimensions(Fit::ContactAngle(0.0))).unwrap();
        for (side, bottom, groove) in
            [(Side::Inner, 2.0 / (0.165 - 0.03016), 0.527f64), (Side::Outer, -2.0 / (0.165 + 0.03016), 0.53)]
        {
            let [rolling, lateral]: [f64; 2] = g.curvatures(side, 1.0);
            assert!((rolling - (2.0 / 0.03016 + bottom)).abs() < 1e-12 * rolling, "{side:?}: {rolling}");
            assert!((lateral - (2.0 - 1.0 / groove) / 0.03016).abs() < 1e-12 * lateral, "{side:?}: {lateral}");
        }
    }

    #[test]
    fn identity_pose_from_angle_and_approach() {
        let (length, angle) = (8.5e-4, 0.4f64);
        let pose = ContactPose::new(length * angle.sin(), length * angle.cos(), 8e-4);
        assert!((pose.sin.atan2(pose.cos) - angle).abs() < 1e-15);
        assert!((pose.approach - 5e-5).abs() < 1e-18);
        let ([inner, _], [outer, _]) = (pose.normal(Side::Inner), pose.normal(Side::Outer));
        assert!(inner == -outer && outer > 0.0);
    }
}
