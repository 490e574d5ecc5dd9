//! Contacts of rings that are free to tilt: rigid bodies turned about any axis, each contact in the plane through the
//! ring's own axis and the ball's centre. Force and moment on the ring are the opposite of those on the ball at the
//! ball's centre, so that energy, momentum and angular momentum hold whatever the tilt.

use crate::bearing::Bearing;
use crate::contact::{NormalContact, NormalLoads, RaceContact};
use crate::frame::AzimuthFrame;
use crate::geometry::{ContactPose, Geometry};
use crate::lean::Lean;
use crate::normal::ContactSprings;
use crate::races::{Races, Side};
use crate::sliding::Sliding;
use crate::state::{BallState, RingState};
use crate::vectors::{add, cross, dot};
use tribodyn_contact::{HertzContact, Scalar};
use tribodyn_wear::LocalSurface;

/// A ball as a ring sees it, in the ball's axes [a, r, t].
#[derive(Debug, Clone, Copy)]
struct Meridian<D> {
    /// The ring's axis, outwards to the ball, and round the ring.
    axes: [[D; 3]; 3],
    /// Ball centre from the ring's centre, m.
    arm: [D; 3],
    /// The same along the axis and away from it, m.
    along: D,
    radius: D,
}

impl Geometry {
    /// A ball's centre from the ring's centre [a, r, t], m, which lies in the plane of the ring's unloaded groove
    /// centres, by its axial position against the outer groove centres and the radius of its orbit, m.
    #[inline]
    pub fn arm<D: Scalar>(
        &self,
        side: Side,
        frame: AzimuthFrame<D>,
        [axial, orbit_radius]: [D; 2],
        ring: &RingState<D>,
    ) -> [D; 3] {
        let plane = if side == Side::Inner { self.centre_distance() * self.sin_contact_angle() } else { 0.0 };
        let [a, r, t] = frame.from_inertial(ring.displacement);
        [axial - a - plane, orbit_radius - r, -t]
    }

    /// A ball with its axial position against the outer groove centres and the radius of its orbit, m.
    #[inline]
    fn meridian<D: Scalar>(
        &self,
        side: Side,
        frame: AzimuthFrame<D>,
        ball: [D; 2],
        ring: &RingState<D>,
    ) -> Meridian<D> {
        let axis = frame.from_inertial(ring.axis());
        let arm = self.arm(side, frame, ball, ring);
        let along = dot(arm, axis);
        let across = add(arm, axis.map(|x| -(x * along)));
        let radius = dot(across, across).sqrt();
        let over = radius.recip();
        let outward = across.map(|x| x * over);
        Meridian { axes: [axis, outward, cross(axis, outward)], arm, along, radius }
    }
}

impl<D: Scalar> Meridian<D> {
    /// Velocity of the ring at the ball's centre but for its rotation about its axis, m/s.
    fn carried(&self, frame: AzimuthFrame<D>, ring: &RingState<D>) -> [D; 3] {
        add(frame.from_inertial(ring.velocity), cross(turning(frame, ring), self.arm))
    }
}

/// Angular velocity of a ring across its axis, rad/s.
fn turning<D: Scalar>(frame: AzimuthFrame<D>, ring: &RingState<D>) -> [D; 3] {
    frame.from_inertial(ring.turning.unwrap_or([D::zero(); 3]))
}

impl ContactSprings {
    /// How hard a ball is pressed on both races of rings that are free to tilt.
    pub(crate) fn loads_of_tilting<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        surfaces: Races<&LocalSurface>,
        hertz: impl Fn(Side, &ContactPose<D>) -> HertzContact<D>,
    ) -> NormalLoads<D> {
        let [_, outer, _] = ball.frame.from_inertial(rings.outer.displacement);
        let orbit_radius = ball.position[1] + outer + self.geometry().groove_centre_radius(Side::Outer);
        let contacts = Races::from_fn(|side| {
            let seen = self.geometry().meridian(side, ball.frame, [ball.position[0], orbit_radius], rings[side]);
            let (pose, lean) = self.pose_in_meridian(side, &seen);
            let velocity = ball.frame.to_inertial(seen.carried(ball.frame, rings[side]));
            let moved = RingState { velocity, ..*rings[side] };
            self.normal_contact((side, pose, lean), (ball, orbit_radius, &moved), surfaces[side], &hertz)
        });
        NormalLoads { contacts, orbit_radius }
    }

    /// Contact angle and lean, in the ball's axes, of the normal in the ring's meridian.
    fn pose_in_meridian<D: Scalar>(&self, side: Side, seen: &Meridian<D>) -> (ContactPose<D>, Lean<D>) {
        let groove = self.geometry().groove_centre_radius(side);
        let (axial, radial) = match side {
            Side::Inner => (-seen.along, -seen.radius + groove),
            Side::Outer => (seen.along, seen.radius - groove),
        };
        let own = ContactPose::new(axial, radial, self.free_length(side));
        let [axis, outward, _] = &seen.axes;
        let [sin, r, t] = [0, 1, 2].map(|k| axis[k] * own.sin + outward[k] * own.cos);
        let size = (r * r + t * t).sqrt();
        let cos = if r.re() < 0.0 { -size } else { size };
        let over = cos.recip();
        let zero = D::zero();
        let lean = Lean { sin: -(t * over), cos: r * over, curvature: seen.radius.recip(), farther: zero, climb: zero };
        (ContactPose { sin, cos, approach: own.approach }, lean)
    }
}

impl Bearing {
    /// How a ball slides on a ring that is free to tilt.
    pub(crate) fn sliding_in_meridian<D: Scalar>(
        &self,
        (side, contact, sunk): (Side, &NormalContact<D>, D),
        ball: &BallState<D>,
        (ring, orbit_radius): (&RingState<D>, D),
    ) -> Sliding<D> {
        let seen = self.geometry.meridian(side, ball.frame, [ball.position[0], orbit_radius], ring);
        let own = |v: [D; 3]| seen.axes.map(|axis| dot(v, axis));
        let [n_a, n_r] = contact.pose.normal(side);
        let [along, outward, _] = own([n_a, n_r * contact.lean.cos, -(n_r * contact.lean.sin)]);
        let normal = [along, outward];
        let moving = [ball.velocity[0], ball.velocity[1], orbit_radius * ball.orbital_speed];
        let [v_a, v_r, v_t] = own(add(moving, seen.carried(ball.frame, ring).map(|v| -v)));
        let about = turning(ball.frame, ring);
        let of_ball = BallState {
            velocity: [v_a, v_r],
            orbital_speed: v_t * seen.radius.recip(),
            angular_velocity: own(add(ball.angular_velocity, about.map(|w| -w))),
            ..*ball
        };
        let of_ring = RingState::centred(ring.speed);
        let (motion, rolling_speed) = self.relative_motion((normal, sunk), &of_ball, &of_ring, seen.radius);
        Sliding { normal, motion, rolling_speed, sunk, meridian: Some(seen.axes) }
    }

    /// Moment of a ring on a ball about the ring's centre [a, r, t], N m; the reaction turns the ring.
    pub fn ring_moment<D: Scalar>(
        &self,
        side: Side,
        ball: &BallState<D>,
        (contact, orbit_radius): (&RaceContact<D>, D),
        ring: &RingState<D>,
    ) -> [D; 3] {
        self.moment_about(side, ball, (contact.force, contact.moment), (ring, orbit_radius))
    }

    /// The same of a force at the ball's centre and a moment [a, r, t].
    pub fn moment_about<D: Scalar>(
        &self,
        side: Side,
        ball: &BallState<D>,
        (force, moment): ([D; 3], [D; 3]),
        (ring, orbit_radius): (&RingState<D>, D),
    ) -> [D; 3] {
        let seen = self.geometry.meridian(side, ball.frame, [ball.position[0], orbit_radius], ring);
        add(moment, cross(seen.arm, force))
    }
}
