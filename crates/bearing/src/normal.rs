//! The normal part of the ball–race contacts: where the ball stands between the grooves and how hard it is pressed.

use crate::bearing::Bearing;
use crate::contact::{BallPose, NormalContact, NormalLoads};
use crate::frame::AzimuthFrame;
use crate::geometry::{ContactPose, Geometry};
use crate::lean::{Lean, RingOffset};
use crate::races::{Races, Side};
use crate::state::{BallState, RingState};
use tribodyn_contact::{Ellipse, HertzContact, Scalar};
use tribodyn_wear::LocalSurface;

/// Shift of a groove centre at a ball's azimuth, m.
#[derive(Debug, Clone, Copy)]
struct GrooveShift<D> {
    axial: D,
    radial: D,
    tangential: D,
    /// Derivative of the axial shift by the azimuth, m/rad.
    climb: D,
}

/// All of a bearing that the normal part of its contacts needs, by value: a loop over many balls that has its own copy
/// need not fear that what it writes changes it.
#[derive(Debug, Clone, Copy)]
pub struct ContactSprings {
    geometry: Geometry,
    /// Depth of the surfaces all round when the case begins, m.
    worn: Races<f64>,
    ring_offset: RingOffset,
    contact_damping: f64,
    ball_mass: f64,
    /// Contact constants at the free contact angle.
    frozen: Races<HertzContact>,
}

impl ContactSprings {
    /// How a ring's offset is taken.
    #[inline(always)]
    pub fn ring_offset(&self) -> RingOffset {
        self.ring_offset
    }

    /// The same with offsets taken exactly: a loop over lanes that has to choose gets no vector instructions.
    #[inline(always)]
    pub fn with_exact_offset(self) -> Self {
        Self { ring_offset: RingOffset::Exact, ..self }
    }

    /// The same without damping, if it has none: for such loops, too.
    #[inline(always)]
    pub fn undamped(self) -> Option<Self> {
        (self.contact_damping == 0.0).then_some(Self { contact_damping: 0.0, ..self })
    }

    /// How hard a ball is pressed on both races of rings whose tilts are held, with the contact constants of the free
    /// contact angle.
    #[inline(always)]
    pub fn normal_loads<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        surfaces: Races<&LocalSurface>,
    ) -> NormalLoads<D> {
        self.loads_of_held(ball, rings, surfaces, |side, _| self.frozen[side].lift())
    }

    /// The contact ellipse at an elastic approach (m), with the contact constants of the free contact angle.
    #[inline(always)]
    pub fn ellipse(&self, side: Side, approach: f64) -> Ellipse {
        self.frozen[side].ellipse_at(approach)
    }

    /// Accelerations of a ball by the normal forces on it [a, r, t], N: axial, radial, orbital.
    #[inline(always)]
    pub fn acceleration<D: Scalar>(&self, force: [D; 3], orbit_radius: D, ball: &BallState<D>) -> [D; 3] {
        let (over_mass, r, w) = (1.0 / (self.ball_mass * ball.size.mass), orbit_radius, ball.orbital_speed);
        let [a, r_force, t] = force.map(|f| f * over_mass);
        [a, r_force + r * w * w, t * r.recip()]
    }

    /// Contact angles, approaches and orbit radius of a ball.
    #[inline(always)]
    fn pose<D: Scalar>(&self, frame: AzimuthFrame<D>, position: [D; 2], rings: Races<&RingState<D>>) -> BallPose<D> {
        let g = &self.geometry;
        let [x1, x2] = position;
        let (i, o) = (self.groove_shift(frame, rings.inner), self.groove_shift(frame, rings.outer));
        let orbit_radius = x2 + o.radial + g.groove_centre_radius(Side::Outer);
        let lean = Races { inner: self.lean(&i, orbit_radius), outer: self.lean(&o, orbit_radius) };
        let axial = i.axial - o.axial + g.centre_distance() * g.sin_contact_angle() - x1;
        let radial = i.radial - o.radial + g.radial_distance() - x2 - lean.inner.farther;
        let contacts = Races {
            inner: ContactPose::new(axial, radial, g.groove_offset(Side::Inner) + self.worn.inner),
            outer: ContactPose::new(x1, x2 + lean.outer.farther, g.groove_offset(Side::Outer) + self.worn.outer),
        };
        BallPose { contacts, lean, orbit_radius }
    }

    /// Shift of a ring's groove centre at an azimuth. Tilts act with the inner groove-centre radius.
    #[inline(always)]
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

    #[inline(always)]
    fn lean<D: Scalar>(&self, shift: &GrooveShift<D>, orbit_radius: D) -> Lean<D> {
        let x = shift.tangential;
        match self.ring_offset {
            RingOffset::FirstOrder => {
                let zero = D::zero();
                let curvature = orbit_radius.recip();
                Lean { sin: x * curvature, cos: D::one(), curvature, farther: zero, climb: zero }
            }
            RingOffset::Exact => {
                let along = orbit_radius - shift.radial;
                let arm = (along * along + x * x).sqrt();
                let climb = shift.climb * orbit_radius.recip();
                // 1/arm and 1/(arm + along) by one division.
                let (sum, over) = (arm + along, (arm * (arm + along)).recip());
                let curvature = sum * over;
                Lean { sin: x * curvature, cos: along * curvature, curvature, farther: x * x * (arm * over), climb }
            }
        }
    }

    #[inline(always)]
    fn loads_of_held<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        surfaces: Races<&LocalSurface>,
        hertz: impl Fn(Side, &ContactPose<D>) -> HertzContact<D>,
    ) -> NormalLoads<D> {
        let BallPose { contacts: poses, lean, orbit_radius: r } = self.pose(ball.frame, ball.position, rings);
        let (inner, outer) = ((Side::Inner, poses.inner, lean.inner), (Side::Outer, poses.outer, lean.outer));
        let contacts = Races {
            inner: self.normal_contact(inner, (ball, r, rings.inner), surfaces.inner, &hertz),
            outer: self.normal_contact(outer, (ball, r, rings.outer), surfaces.outer, &hertz),
        };
        NormalLoads { contacts, orbit_radius: r }
    }

    pub(crate) fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    /// Distance of the ball centre from a groove centre without approach, m.
    pub(crate) fn free_length(&self, side: Side) -> f64 {
        self.geometry.groove_offset(side) + self.worn[side]
    }

    /// N = max(0, Q + c δ̇) with c = 2ζ sqrt(m dQ/dδ).
    #[inline(always)]
    pub(crate) fn normal_contact<D: Scalar>(
        &self,
        (side, mut pose, lean): (Side, ContactPose<D>, Lean<D>),
        (ball, orbit_radius, ring): (&BallState<D>, D, &RingState<D>),
        surface: &LocalSurface,
        hertz: impl Fn(Side, &ContactPose<D>) -> HertzContact<D>,
    ) -> NormalContact<D> {
        pose.approach -= surface.depth;
        let hertz = hertz(side, &pose);
        let load = hertz.load(pose.approach);
        let (mut force, mut closing_speed) = (load, D::zero());
        if self.contact_damping != 0.0 {
            let [n_a, n_r] = pose.normal(side);
            let [v_a, v_r, v_t] = ball.frame.from_inertial(ring.velocity);
            let along = orbit_radius * ball.orbital_speed;
            let [outward, round] = lean.turn([ball.velocity[1] - v_r, along - v_t]);
            let mut sinking = (round * lean.curvature - ring.speed) * surface.slope;
            // One by one: the compiler does not see through a comparison of lists in time to make vector instructions.
            let [a, r, t] = surface.turn;
            if a != 0.0 || r != 0.0 || t != 0.0 {
                sinking = sinking
                    + (ball.angular_velocity[0] - ring.speed) * a
                    + ball.angular_velocity[1] * r
                    + ball.angular_velocity[2] * t;
            }
            closing_speed = n_a * (ball.velocity[0] - v_a - (along - v_t) * lean.climb) + n_r * outward - sinking;
            if load.re() > 0.0 {
                let stiffness = hertz.tangent_stiffness(pose.approach);
                let damping = (stiffness * (self.ball_mass * ball.size.mass)).sqrt() * (2.0 * self.contact_damping);
                let damped = load + damping * closing_speed;
                force = if damped.re() > 0.0 { damped } else { D::zero() };
            }
        }
        NormalContact { pose, lean, load, force, closing_speed, slope_moment: force * surface.slope }
    }
}

impl Bearing {
    /// The bearing's data for the normal part of its contacts.
    #[inline(always)]
    pub fn contact_springs(&self) -> ContactSprings {
        ContactSprings {
            geometry: self.geometry,
            worn: Races { inner: self.worn.inner.depth, outer: self.worn.outer.depth },
            ring_offset: self.ring_offset,
            contact_damping: self.contact_damping,
            ball_mass: self.ball_mass,
            frozen: Races { inner: self.races.inner.frozen(), outer: self.races.outer.frozen() },
        }
    }

    /// Contact angles, approaches and orbit radius of a ball.
    #[inline]
    pub fn pose<D: Scalar>(
        &self,
        frame: AzimuthFrame<D>,
        position: [D; 2],
        rings: Races<&RingState<D>>,
    ) -> BallPose<D> {
        self.contact_springs().pose(frame, position, rings)
    }

    /// Contact constants of a race: frozen at the free contact angle, or those of the actual one.
    #[inline]
    pub fn hertz<D: Scalar>(&self, side: Side, pose: &ContactPose<D>) -> HertzContact<D> {
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
        let (springs, hertz) = (self.contact_springs(), |side, pose: &ContactPose<D>| self.hertz(side, pose));
        if rings.inner.turning.is_some() {
            return springs.loads_of_tilting(ball, rings, surfaces, hertz);
        }
        springs.loads_of_held(ball, rings, surfaces, hertz)
    }
}
