//! The traction-coupled equilibrium: six balances per ball, no assumption on raceway control.
//!
//! Unknowns of a ball: X1, X2, the angular velocity ω relative to the orbiting frame (axial, radial, tangential) and
//! ω_m. Source: the ball equations of Lubricants 2025, 13(8), 352, section 3, with the time derivatives zero (its cases
//! 1 to 4).

use crate::block::{AXIAL, BALL, Balance, BlockSystem, OMEGA, ORBIT, RADIAL, RING};
use crate::jones_harris::{Typical, ring_state};
use tribodyn_bearing::{
    AzimuthFrame, BallLoads, BallState, Bearing, LoadedPatch, Races, RingFreedom, RingState, Scalar, SearchWatch,
};
use tribodyn_traction::{FastPatch, PatchTraction};

/// Names of the balances, for error messages.
pub(crate) const EQUATIONS: [&str; BALL] =
    ["axial force", "radial force", "axial moment", "radial moment", "tangential moment", "tangential force"];

/// The equations of one bearing at one operating point.
pub(crate) struct WithTraction<'a> {
    pub bearing: &'a Bearing,
    pub ring: [RingFreedom; RING],
    pub speeds: Races<f64>,
    pub kernel: FastPatch,
    pub typical: Typical,
    pub watch: SearchWatch,
}

/// A ball, all that acts on it, and the inner ring.
pub(crate) type Loaded<D = f64> = (BallState<D>, BallLoads<D>, RingState<D>);

impl WithTraction<'_> {
    /// The state of a ball and all that acts on it.
    pub fn evaluate(&self, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> Loaded {
        self.evaluate_with(index, ball, ring, |patch| self.bearing.fast_traction(patch, &self.kernel))
    }

    fn evaluate_with<D: Scalar>(
        &self,
        index: usize,
        ball: [D; BALL],
        ring: [D; RING],
        traction: impl FnMut(&LoadedPatch<'_, D>) -> PatchTraction<D>,
    ) -> Loaded<D> {
        let inner = ring_state(ring, self.speeds.inner);
        let outer = RingState::centred(D::from(self.speeds.outer));
        let state = BallState {
            frame: AzimuthFrame::at(self.bearing.azimuth(index)).lift(),
            position: [ball[AXIAL], ball[RADIAL]],
            velocity: [D::zero(); 2],
            orbital_speed: ball[ORBIT],
            angular_velocity: [ball[OMEGA] + ball[ORBIT], ball[OMEGA + 1], ball[OMEGA + 2]],
            size: self.bearing.ball_size(index),
        };
        let rings = Races { inner: &inner, outer: &outer };
        let loads =
            self.bearing.ball_loads_with(&state, rings, self.bearing.surfaces_under(index).each_ref(), traction);
        (state, loads, inner)
    }

    fn balance<D: Scalar>(&self, (state, loads, inner): Loaded<D>) -> Balance<D> {
        let mass = self.bearing.mass_of(&state.size);
        let centrifugal = loads.orbit_radius * state.orbital_speed * state.orbital_speed * mass;
        // J ω_m e_a × Ω = J ω_m (−Ω_t e_r + Ω_r e_t).
        let inertia = self.bearing.inertia_of(&state.size);
        let turning = if self.bearing.modelling.has_gyroscopic_moment() { inertia } else { 0.0 };
        let inertia = state.orbital_speed * turning;
        let gyroscopic = [-(inertia * state.angular_velocity[2]), inertia * state.angular_velocity[1]];
        let (force, moment) = (loads.force(), loads.moment());
        let residual = [
            force[0],
            force[1] + centrifugal,
            moment[0],
            moment[1] - gyroscopic[0],
            moment[2] - gyroscopic[1],
            force[2],
        ];
        let size = |d: D| d.re().abs();
        let norm = |v: [D; 3]| v.iter().map(|c| c.re() * c.re()).sum::<f64>().sqrt();
        // Slip in the last digit of a surface speed moves traction by up to 1e-12 of the load at the steepest slip
        // scales: friction is judged against a tenth of what the contacts can carry, or a dry bearing never converges.
        let floor = self
            .typical
            .floor()
            .max(0.01 * (size(loads.contacts.inner.normal.load) + size(loads.contacts.outer.normal.load)));
        let both = |k: usize| size(loads.contacts.inner.force[k]) + size(loads.contacts.outer.force[k]);
        let turning = (norm(loads.contacts.inner.moment)
            + norm(loads.contacts.outer.moment)
            + norm(loads.churning)
            + size(gyroscopic[0]).hypot(size(gyroscopic[1])))
        .max(floor * self.bearing.geometry.ball_radius());
        let scale = [
            both(0).max(floor),
            (both(1) + size(centrifugal)).max(floor),
            turning,
            turning,
            turning,
            (both(2) + size(loads.drag)).max(floor),
        ];
        let [x, y, z, mx, my, _] = self.bearing.ring_action(&state, &loads, &inner);
        let total = norm(loads.contacts.inner.force) + floor;
        let lever = self.typical.radius;
        Balance {
            residual,
            scale,
            ring: [x, y, z, mx, my],
            ring_scale: [total, total, total, total * lever, total * lever],
        }
    }
}

impl BlockSystem for WithTraction<'_> {
    fn ring(&self) -> &[RingFreedom; RING] {
        &self.ring
    }

    fn ball<D: Scalar>(&self, index: usize, ball: [D; BALL], ring: [D; RING]) -> Balance<D> {
        let traction = |patch: &LoadedPatch<'_, D>| self.bearing.linear_traction(patch, &self.kernel);
        self.balance(self.evaluate_with(index, ball, ring, traction))
    }

    fn ball_value(&self, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> Balance<f64> {
        self.balance(self.evaluate(index, ball, ring))
    }

    fn weights(&self) -> ([f64; BALL], [f64; RING]) {
        let t = &self.typical;
        let fastest = self.speeds.inner.abs().max(self.speeds.outer.abs()).max(1.0);
        let (turn, push) = (t.force * self.bearing.geometry.ball_radius() / fastest, t.force / fastest);
        ([t.stiffness, t.stiffness, turn, turn, turn, push], t.ring_weights())
    }

    fn inertia(&self) -> [f64; BALL] {
        let j = self.bearing.ball_inertia;
        // The position follows at once, but a ball that touches nothing must not make the step singular.
        let floating = 1e-13 * self.typical.stiffness;
        [floating, floating, j, j, j, self.bearing.ball_mass * self.typical.radius]
    }

    fn goes_on(&self) -> bool {
        !self.watch.stops()
    }

    fn step_limits(&self) -> ([f64; BALL], [f64; RING]) {
        let g = &self.bearing.geometry;
        let fastest = self.speeds.inner.abs().max(self.speeds.outer.abs()).max(1.0);
        let turning = 0.2 * fastest * g.pitch_diameter / g.ball_diameter;
        let position = self.typical.position_limit();
        ([position, position, turning, turning, turning, 0.1 * fastest], self.typical.ring_limits())
    }
}
