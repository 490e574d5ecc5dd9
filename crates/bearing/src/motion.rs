//! From the forces on a ball to its accelerations, in two parts: springs and friction.
//!
//! ```text
//! spring part    axial  (N on the ball)_a/m,  radial  (N)_r/m + r ω_m²,  orbital  (N)_t/(m r)
//! friction part  the same of traction, drag and pocket;  rotation  M/J − ω_m e_a × Ω
//! orbital speed, besides: −2 ṙ ω_m/r
//! ```
//!
//! Orbits, modes, explicit schemes and samples take [`Bearing::ball_motion`]; the fast scheme takes its drift from the
//! spring part, its kick from the friction part, and keeps m r² ω_m where the radius changes.

use crate::bearing::Bearing;
use crate::contact::{BallLoads, NormalLoads};
use crate::pocket::PocketLoad;
use crate::races::{Races, Side};
use crate::sliding::ContactForces;
use crate::state::{BallSize, BallState};
use tribodyn_contact::Scalar;

/// All that acts on a ball but the normal forces of its contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallFriction<D = f64> {
    /// Force and friction of the pocket.
    pub pocket: PocketLoad<D>,
    /// Fluid drag against the orbit, N.
    pub drag: D,
    /// Churning moment, N m.
    pub churning: [D; 3],
    /// Sum of the forces on the ball [a, r, t], N.
    pub force: [D; 3],
    /// Sum of the moments about the ball centre, N m.
    pub moment: [D; 3],
}

impl<D: Scalar> NormalLoads<D> {
    /// Sum of the normal forces on the ball [a, r, t], N.
    #[inline(always)]
    pub fn on_ball(&self) -> [D; 3] {
        let (i, o) = (self.contacts.inner.on_ball(Side::Inner), self.contacts.outer.on_ball(Side::Outer));
        [i[0] + o[0], i[1] + o[1], i[2] + o[2]]
    }
}

impl<D: Scalar> BallLoads<D> {
    /// The part that acts through the normals of the contacts.
    #[inline(always)]
    pub fn normal(&self) -> NormalLoads<D> {
        let Races { inner, outer } = &self.contacts;
        NormalLoads { contacts: Races { inner: inner.normal, outer: outer.normal }, orbit_radius: self.orbit_radius }
    }

    /// Tractions of both contacts.
    #[inline(always)]
    pub fn tractions(&self) -> Races<ContactForces<D>> {
        let Races { inner, outer } = &self.contacts;
        Races {
            inner: ContactForces { force: inner.traction_force, moment: inner.moment },
            outer: ContactForces { force: outer.traction_force, moment: outer.moment },
        }
    }
}

impl<D: Scalar> BallFriction<D> {
    /// Sums the tractions of both contacts, drag and churning, and the pocket on a circle of `pocket_radius`.
    #[inline(always)]
    pub fn new(
        traction: &Races<ContactForces<D>>,
        (drag, churning): (D, [D; 3]),
        (pocket, pocket_radius): (PocketLoad<D>, f64),
        orbit_radius: D,
    ) -> Self {
        let Races { inner: i, outer: o } = traction;
        // The pocket turns ball and cage with one torque.
        let along = pocket.force * pocket_radius / orbit_radius;
        Self {
            force: [
                i.force[0] + o.force[0] + pocket.friction[0],
                i.force[1] + o.force[1] + pocket.friction[1],
                i.force[2] + o.force[2] - drag + along,
            ],
            moment: [
                i.moment[0] + o.moment[0] + churning[0] + pocket.moment[0],
                i.moment[1] + o.moment[1] + churning[1] + pocket.moment[1],
                i.moment[2] + o.moment[2] + churning[2] + pocket.moment[2],
            ],
            pocket,
            drag,
            churning,
        }
    }
}

impl Bearing {
    /// Mass of a ball, kg.
    #[inline(always)]
    pub fn mass_of(&self, ball: &BallSize) -> f64 {
        self.ball_mass * ball.mass
    }

    /// Moment of inertia of a ball, kg m².
    #[inline(always)]
    pub fn inertia_of(&self, ball: &BallSize) -> f64 {
        self.ball_inertia * ball.inertia
    }

    /// Friction part and accelerations of a ball under its contacts, the fluid and a pocket on a circle of the radius
    /// beside it.
    #[inline(always)]
    pub fn ball_motion<D: Scalar>(
        &self,
        state: &BallState<D>,
        loads: &BallLoads<D>,
        pocket: (PocketLoad<D>, f64),
    ) -> (BallFriction<D>, [D; 6]) {
        let r = loads.orbit_radius;
        let friction = BallFriction::new(&loads.tractions(), (loads.drag, loads.churning), pocket, r);
        let by_springs = self.spring_acceleration(loads.normal().on_ball(), r, state);
        let by_friction = self.friction_acceleration(state, &friction, r);
        (friction, Self::acceleration(state, r, by_springs, by_friction))
    }

    /// Accelerations of a ball from those of its parts: of the axial and radial velocity (m/s²), the orbital speed and
    /// the angular velocity (rad/s²).
    #[inline(always)]
    pub fn acceleration<D: Scalar>(
        state: &BallState<D>,
        orbit_radius: D,
        [axial, radial, orbital]: [D; 3],
        by_friction: [D; 6],
    ) -> [D; 6] {
        let [a, r, t, about @ ..] = by_friction;
        let outward = state.velocity[1] * 2.0 * state.orbital_speed / orbit_radius;
        let [about_axis, about_radius, about_orbit] = about;
        [a + axial, r + radial, t + orbital - outward, about_axis, about_radius, about_orbit]
    }

    /// Accelerations of a ball by the normal forces on it [a, r, t], N: axial, radial, orbital.
    #[inline(always)]
    pub fn spring_acceleration<D: Scalar>(&self, force: [D; 3], orbit_radius: D, ball: &BallState<D>) -> [D; 3] {
        self.contact_springs().acceleration(force, orbit_radius, ball)
    }

    /// Accelerations of a ball by the friction part: axial, radial, orbital, and of the angular velocity with the
    /// turning of the azimuth frame, ω_m e_a × Ω = ω_m (−Ω_t e_r + Ω_r e_t), unless the gyroscopic moment is left out.
    #[inline(always)]
    pub fn friction_acceleration<D: Scalar>(
        &self,
        state: &BallState<D>,
        friction: &BallFriction<D>,
        orbit_radius: D,
    ) -> [D; 6] {
        let [_, omega_r, omega_t] = state.angular_velocity;
        let w = if self.modelling.has_gyroscopic_moment() { state.orbital_speed } else { D::zero() };
        let (over_mass, over_inertia) = (self.mass_of(&state.size).recip(), self.inertia_of(&state.size).recip());
        let [a, r, t] = friction.force.map(|f| f * over_mass);
        let [about_axis, about_radius, about_orbit] = friction.moment.map(|m| m * over_inertia);
        [a, r, t * orbit_radius.recip(), about_axis, about_radius + w * omega_t, about_orbit - w * omega_r]
    }
}
