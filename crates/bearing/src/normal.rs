//! The normal part of the ball–race contacts: where the ball stands between the grooves and how hard it is pressed.

use crate::bearing::Bearing;
use crate::geometry::{ContactPose, Side};
use crate::interaction::in_azimuth_frame;
use crate::state::{BallPose, BallState, RingState};
use tribodyn_contact::{Ellipse, HertzContact, Scalar};
use tribodyn_wear::LocalSurface;

/// One contact without its traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalContact<D = f64> {
    /// Contact angle and approach.
    pub pose: ContactPose<D>,
    /// Normal load Q, N, of the elastic approach.
    pub load: D,
    /// Normal force N on ball and race, N: the load and the contact's damping, never pulling.
    pub force: D,
    /// Rate of the elastic approach, m/s; 0 where the bearing has no contact damping.
    pub closing_speed: D,
    /// Moment about the bearing's axis by which the ball slides down the slope of a groove that is not round, N m.
    pub slope_moment: D,
}

/// Both contacts of a ball without their traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalLoads<D = f64> {
    /// Inner contact.
    pub inner: NormalContact<D>,
    /// Outer contact.
    pub outer: NormalContact<D>,
    /// Radius of the orbit, m.
    pub orbit_radius: D,
    /// Tangential generalised force of the normal forces where a ring is off centre or a groove is not round, N.
    pub eccentricity: D,
}

impl<L> Bearing<L> {
    /// Contact angles, approaches and orbit radius of a ball.
    #[inline]
    pub fn pose<D: Scalar>(
        &self,
        azimuth: [D; 2],
        position: [D; 2],
        inner: &RingState<D>,
        outer: &RingState<D>,
    ) -> BallPose<D> {
        let g = &self.geometry;
        let ([x1, x2], [i, o]) = (position, [self.groove_shift(azimuth, inner), self.groove_shift(azimuth, outer)]);
        let a1 = i[0] - o[0] + g.centre_distance() * g.sin_contact_angle();
        let a2 = i[1] - o[1] + g.centre_distance() * g.cos_contact_angle();
        BallPose {
            inner: ContactPose::new(a1 - x1, a2 - x2, g.groove_offset(Side::Inner) + self.worn[0].depth),
            outer: ContactPose::new(x1, x2, g.groove_offset(Side::Outer) + self.worn[1].depth),
            orbit_radius: x2 + o[1] + g.groove_centre_radius(Side::Outer),
        }
    }

    /// Axial and radial shift of a ring's groove centre at an azimuth, m. Tilts act with the inner groove-centre radius.
    #[inline]
    fn groove_shift<D: Scalar>(&self, [sin, cos]: [D; 2], ring: &RingState<D>) -> [D; 2] {
        let [x, y, z] = ring.displacement;
        let lever = self.geometry.groove_centre_radius(Side::Inner);
        [z + (ring.tilt[0] * sin - ring.tilt[1] * cos) * lever, x * cos + y * sin]
    }

    /// Contact constants of a race: frozen at the free contact angle, or those of the actual one.
    #[inline]
    pub(crate) fn hertz<D: Scalar>(&self, side: Side, pose: &ContactPose<D>) -> HertzContact<D> {
        let race = self.race(side);
        if self.contact_at_actual_angle {
            let [rolling, lateral] = self.geometry.curvatures(side, pose.cos);
            if let Ok(hertz) = race.hertz_at(rolling, lateral) {
                return hertz;
            }
        }
        race.frozen()
    }

    /// Normal load and contact ellipse at a contact pose.
    pub fn contact_load<D: Scalar>(&self, side: Side, pose: &ContactPose<D>) -> (D, Ellipse<D>) {
        let hertz = self.hertz(side, pose);
        let load = hertz.load(pose.approach);
        (load, hertz.ellipse(load))
    }

    /// How hard a ball is pressed on both races, given the surfaces where it stands (inner, outer), their depth counted from
    /// that of [`Bearing::worn`].
    #[inline]
    pub fn normal_loads<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: [&RingState<D>; 2],
        surfaces: [&LocalSurface; 2],
    ) -> NormalLoads<D> {
        let pose = self.pose(ball.azimuth, ball.position, rings[0], rings[1]);
        let tangential = rings.map(|ring| in_azimuth_frame(ball.azimuth, ring.displacement)[2]);
        let contact =
            |side, pose, k: usize| self.normal_contact(side, pose, (ball, rings[k], tangential[k]), surfaces[k]);
        let (i, o) = (contact(Side::Inner, pose.inner, 0), contact(Side::Outer, pose.outer, 1));
        let off_centre = o.force * o.pose.cos * tangential[1] - i.force * i.pose.cos * tangential[0];
        let eccentricity = (off_centre + i.slope_moment + o.slope_moment) / pose.orbit_radius;
        NormalLoads { inner: i, outer: o, orbit_radius: pose.orbit_radius, eccentricity }
    }

    /// N = max(0, Q + c δ̇) with c = 2ζ sqrt(m dQ/dδ).
    #[inline]
    fn normal_contact<D: Scalar>(
        &self,
        side: Side,
        mut pose: ContactPose<D>,
        (ball, ring, tangential): (&BallState<D>, &RingState<D>, D),
        surface: &LocalSurface,
    ) -> NormalContact<D> {
        pose.approach -= surface.depth;
        let load = self.hertz(side, &pose).load(pose.approach);
        let (mut force, mut closing_speed) = (load, D::zero());
        if self.contact_damping != 0.0 {
            let [n_a, n_r] = pose.normal(side);
            let [v_a, v_r, _] = in_azimuth_frame(ball.azimuth, ring.velocity);
            // The groove centre under the ball moves with the ring and, where that is off centre, with the azimuth.
            let groove = v_r + tangential * ball.orbital_speed;
            let sinking = (ball.orbital_speed - ring.speed) * surface.slope;
            closing_speed = n_a * (ball.velocity[0] - v_a) + n_r * (ball.velocity[1] - groove) - sinking;
            if load.re() > 0.0 {
                let stiffness = load / pose.approach * 1.5;
                let damping = (stiffness * self.ball_mass).sqrt() * (2.0 * self.contact_damping);
                let damped = load + damping * closing_speed;
                force = if damped.re() > 0.0 { damped } else { D::zero() };
            }
        }
        NormalContact { pose, load, force, closing_speed, slope_moment: force * surface.slope }
    }
}
