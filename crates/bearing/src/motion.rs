//! From the forces on a ball to its accelerations, in two parts: springs and friction.
//!
//! ```text
//! spring part    axial  (N on the ball)_a/m,  radial  (N)_r/m + r ω_m²,  orbital  (N)_t/(m r)
//! friction part  the same of traction, drag and pocket;  spin  M/J − ω_m e_a × Ω
//! orbital speed, besides: −2 ṙ ω_m/r
//! ```

use crate::bearing::Bearing;
use crate::pocket::PocketLoad;
use crate::races::Races;
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

    /// Accelerations of a ball by the normal forces on it [a, r, t], N: axial, radial, orbital.
    #[inline(always)]
    pub fn spring_acceleration<D: Scalar>(&self, force: [D; 3], orbit_radius: D, ball: &BallState<D>) -> [D; 3] {
        self.contact_springs().acceleration(force, orbit_radius, ball)
    }

    /// Accelerations of a ball by the friction part: axial, radial, orbital, and of the spin with the turning of the
    /// azimuth frame, ω_m e_a × Ω = ω_m (−Ω_t e_r + Ω_r e_t), unless the gyroscopic moment is left out.
    #[inline(always)]
    pub fn friction_acceleration<D: Scalar>(
        &self,
        state: &BallState<D>,
        friction: &BallFriction<D>,
        orbit_radius: D,
    ) -> [D; 6] {
        let [_, spin_r, spin_t] = state.spin;
        let w = if self.modelling.has_gyroscopic_moment() { state.orbital_speed } else { D::zero() };
        let (over_mass, over_inertia) = (self.mass_of(&state.size).recip(), self.inertia_of(&state.size).recip());
        let [a, r, t] = friction.force.map(|f| f * over_mass);
        let [about_axis, about_radius, about_orbit] = friction.moment.map(|m| m * over_inertia);
        [a, r, t * orbit_radius.recip(), about_axis, about_radius + w * spin_t, about_orbit - w * spin_r]
    }
}
