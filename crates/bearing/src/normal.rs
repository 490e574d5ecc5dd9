//! The normal part of the ball–race contacts: where the ball stands between the grooves and how hard it is pressed.

use crate::bearing::Bearing;
use crate::frame::AzimuthFrame;
use crate::geometry::ContactPose;
use crate::races::{Races, Side};
use crate::state::{BallPose, BallState, RingState};
use tribodyn_contact::{Ellipse, HertzContact, Scalar};
use tribodyn_wear::LocalSurface;

/// How the offset of a ring's axis enters the distance of a ball from its groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingOffset {
    /// Along the radius of the ball alone, as in Jones's equations and the programs built on them: energy and angular
    /// momentum hold, linear momentum to first order in the offset over the radius.
    FirstOrder,
    /// By the distance of the ball from the ring's own axis, and with the climb of a tilted groove along the orbit: linear
    /// momentum holds too, and so does energy where a ring is tilted. Transient runs take it.
    Exact,
}

/// The direction from a ring's axis to a ball against the radius of the ball's orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lean<D = f64> {
    /// Sine of the angle between them, positive where the ring's axis lies ahead of the ball.
    pub sin: D,
    /// Cosine of it.
    pub cos: D,
    /// Distance of the ball centre from the ring's axis, m.
    pub arm: D,
    /// Growth of that distance by the offset along the orbit, m.
    farther: D,
    /// Axial climb of the groove of a tilted ring along the orbit, over the way.
    climb: D,
}

impl<D: Scalar> Lean<D> {
    /// (radial, tangential) components in the ball's azimuth frame as components along and across the direction from the
    /// ring's axis.
    #[inline]
    fn turn(&self, [r, t]: [D; 2]) -> [D; 2] {
        [r * self.cos - t * self.sin, t * self.cos + r * self.sin]
    }
}

/// Shift of a groove centre at a ball's azimuth, m.
#[derive(Debug, Clone, Copy)]
struct GrooveShift<D> {
    axial: D,
    radial: D,
    tangential: D,
    /// Derivative of the axial shift by the azimuth, m/rad.
    climb: D,
}

/// One contact without its traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalContact<D = f64> {
    /// Contact angle and approach.
    pub pose: ContactPose<D>,
    /// Where the ring's axis stands.
    pub lean: Lean<D>,
    /// Normal load Q, N, of the elastic approach.
    pub load: D,
    /// Normal force N on ball and race, N: the load and the contact's damping, never pulling.
    pub force: D,
    /// Rate of the elastic approach, m/s; 0 where the bearing has no contact damping.
    pub closing_speed: D,
    /// Moment about the ring's axis by which the ball slides down the slope of a groove that is not round, N m.
    pub slope_moment: D,
}

/// Both contacts of a ball without their traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalLoads<D = f64> {
    /// Both contacts.
    pub contacts: Races<NormalContact<D>>,
    /// Radius of the orbit, m.
    pub orbit_radius: D,
}

impl<D: Scalar> NormalContact<D> {
    /// The normal force on the ball [a, r, t], N. It has a part along the orbit where the ring is off centre or tilted and
    /// where the groove is not round.
    #[inline]
    pub fn on_ball(&self, side: Side) -> [D; 3] {
        let [n_a, n_r] = self.pose.normal(side);
        let (outward, round) = (-(self.force * n_r), self.slope_moment / self.lean.arm);
        let (sin, cos, axial) = (self.lean.sin, self.lean.cos, -(self.force * n_a));
        [axial, outward * cos + round * sin, round * cos - outward * sin - axial * self.lean.climb]
    }

    /// The normal force on the ring [a, r, t], N: the opposite of that on the ball, or its axial and radial part where the
    /// ring's offset is taken to first order, which is the derivative of the same potential.
    #[inline]
    pub fn on_ring(&self, side: Side, offset: RingOffset) -> [D; 3] {
        match offset {
            RingOffset::Exact => self.on_ball(side).map(|f| -f),
            RingOffset::FirstOrder => {
                let [n_a, n_r] = self.pose.normal(side);
                [self.force * n_a, self.force * n_r, D::zero()]
            }
        }
    }
}

impl Bearing {
    /// Contact angles, approaches and orbit radius of a ball.
    #[inline]
    pub fn pose<D: Scalar>(
        &self,
        frame: AzimuthFrame<D>,
        position: [D; 2],
        rings: Races<&RingState<D>>,
    ) -> BallPose<D> {
        let g = &self.geometry;
        let [x1, x2] = position;
        let shift = rings.map(|ring| self.groove_shift(frame, ring));
        let (i, o) = (shift.inner, shift.outer);
        let orbit_radius = x2 + o.radial + g.groove_centre_radius(Side::Outer);
        let lean = shift.map(|shift| self.lean(&shift, orbit_radius));
        let axial = i.axial - o.axial + g.centre_distance() * g.sin_contact_angle() - x1;
        let radial = i.radial - o.radial + g.radial_distance() - x2 - lean.inner.farther;
        let contacts = Races {
            inner: ContactPose::new(axial, radial, g.groove_offset(Side::Inner) + self.worn.inner.depth),
            outer: ContactPose::new(x1, x2 + lean.outer.farther, g.groove_offset(Side::Outer) + self.worn.outer.depth),
        };
        BallPose { contacts, lean, orbit_radius }
    }

    /// Shift of a ring's groove centre at an azimuth. Tilts act with the inner groove-centre radius.
    #[inline]
    fn groove_shift<D: Scalar>(&self, frame: AzimuthFrame<D>, ring: &RingState<D>) -> GrooveShift<D> {
        let [axial, radial, tangential] = frame.from_inertial(ring.displacement);
        let lever = self.geometry.groove_centre_radius(Side::Inner);
        let slope = ring.tilt[0] * frame.sin - ring.tilt[1] * frame.cos;
        let axial = axial + slope * lever;
        let climb = ring.tilt[0] * frame.cos + ring.tilt[1] * frame.sin;
        match self.ring_offset {
            RingOffset::FirstOrder => GrooveShift { axial, radial, tangential, climb: D::zero() },
            // A ring that is off centre has its slope a little farther along.
            RingOffset::Exact => {
                let (axial, by_azimuth) = (axial - climb * tangential, climb * (radial + lever) + slope * tangential);
                GrooveShift { axial, radial, tangential, climb: by_azimuth }
            }
        }
    }

    #[inline]
    fn lean<D: Scalar>(&self, shift: &GrooveShift<D>, orbit_radius: D) -> Lean<D> {
        let x = shift.tangential;
        match self.ring_offset {
            RingOffset::FirstOrder => {
                let zero = D::zero();
                Lean { sin: x / orbit_radius, cos: D::one(), arm: orbit_radius, farther: zero, climb: zero }
            }
            RingOffset::Exact => {
                let along = orbit_radius - shift.radial;
                let arm = (along * along + x * x).sqrt();
                let climb = shift.climb / orbit_radius;
                Lean { sin: x / arm, cos: along / arm, arm, farther: x * x / (arm + along), climb }
            }
        }
    }

    /// Contact constants of a race: frozen at the free contact angle, or those of the actual one.
    #[inline]
    pub(crate) fn hertz<D: Scalar>(&self, side: Side, pose: &ContactPose<D>) -> HertzContact<D> {
        let race = &self.races[side];
        if self.modelling.contact_at_actual_angle {
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

    /// How hard a ball is pressed on both races, given the surfaces where it stands, their depth counted from that of
    /// [`Bearing::worn`].
    #[inline]
    pub fn normal_loads<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        surfaces: Races<&LocalSurface>,
    ) -> NormalLoads<D> {
        let pose = self.pose(ball.frame, ball.position, rings);
        let contacts = Races::from_fn(|side| self.normal_contact(side, &pose, (ball, rings[side]), surfaces[side]));
        NormalLoads { contacts, orbit_radius: pose.orbit_radius }
    }

    /// N = max(0, Q + c δ̇) with c = 2ζ sqrt(m dQ/dδ).
    #[inline]
    fn normal_contact<D: Scalar>(
        &self,
        side: Side,
        ball_pose: &BallPose<D>,
        (ball, ring): (&BallState<D>, &RingState<D>),
        surface: &LocalSurface,
    ) -> NormalContact<D> {
        let (mut pose, lean) = (ball_pose.contacts[side], ball_pose.lean[side]);
        pose.approach -= surface.depth;
        let load = self.hertz(side, &pose).load(pose.approach);
        let (mut force, mut closing_speed) = (load, D::zero());
        if self.contact_damping != 0.0 {
            let [n_a, n_r] = pose.normal(side);
            let [v_a, v_r, v_t] = ball.frame.from_inertial(ring.velocity);
            let along = ball_pose.orbit_radius * ball.orbital_speed;
            let [outward, round] = lean.turn([ball.velocity[1] - v_r, along - v_t]);
            let sinking = (round / lean.arm - ring.speed) * surface.slope;
            closing_speed = n_a * (ball.velocity[0] - v_a - (along - v_t) * lean.climb) + n_r * outward - sinking;
            if load.re() > 0.0 {
                let stiffness = load / pose.approach * 1.5;
                let damping = (stiffness * self.ball_mass).sqrt() * (2.0 * self.contact_damping);
                let damped = load + damping * closing_speed;
                force = if damped.re() > 0.0 { damped } else { D::zero() };
            }
        }
        NormalContact { pose, lean, load, force, closing_speed, slope_moment: force * surface.slope }
    }
}
