//! The ball–race interaction that the quasi-static and the transient solver share.
//!
//! Frame at the ball's azimuth φ: e_a axial (+Z), e_r radial outward, e_t = e_a × e_r along the orbit; vectors are
//! [a, r, t]. Forces and moments are those on the ball.

use crate::bearing::{Bearing, Race};
use crate::geometry::Side;
use crate::normal::NormalContact;
use crate::state::{BallLoads, BallState, LoadedPatch, RaceContact, RingState, add};
use tribodyn_contact::{Ellipse, Scalar};
use tribodyn_traction::{FastPatch, fast_patch_traction, linear_patch_traction};
use tribodyn_traction::{Patch, PatchLaw, PatchTraction, Quadrature, RelativeMotion, TractionLaw, patch_traction};
use tribodyn_wear::LocalSurface;

impl<L: TractionLaw> Bearing<L> {
    /// The surfaces where nothing has changed since the case began: inner, outer.
    pub fn surfaces(&self) -> [LocalSurface; 2] {
        self.worn.map(|worn| LocalSurface { depth: 0.0, ..worn })
    }

    /// All that races as the case has them and fluid do to a ball, traction by the generic quadrature.
    pub fn ball_loads<D: Scalar>(
        &self,
        ball: &BallState<D>,
        inner: &RingState<D>,
        outer: &RingState<D>,
        quadrature: &Quadrature,
    ) -> BallLoads<D> {
        self.ball_loads_with(ball, [inner, outer], self.surfaces().each_ref(), |patch| {
            self.plain_traction(patch, quadrature)
        })
    }

    /// The traction of a patch by the generic quadrature; where the coating is partly gone, of both surfaces by their
    /// shares.
    pub fn plain_traction<D: Scalar>(&self, p: &LoadedPatch<'_, D, L>, quadrature: &Quadrature) -> PatchTraction<D> {
        let by = |law: &L| patch_traction(&p.patch, &p.motion, p.rolling_speed, &self.patch_law(law), quadrature);
        p.blend(by)
    }

    /// [`Self::plain_traction`] by the kernel that works on several nodes at a time.
    pub fn fast_traction(&self, p: &LoadedPatch<'_, f64, L>, kernel: &FastPatch) -> PatchTraction {
        p.blend(|law| fast_patch_traction(kernel, &p.patch, &p.motion, p.rolling_speed, &self.patch_law(law)))
    }

    /// [`Self::fast_traction`] with first derivatives, under the conditions of [`linear_patch_traction`].
    pub fn linear_traction<D: Scalar>(&self, p: &LoadedPatch<'_, D, L>, kernel: &FastPatch) -> PatchTraction<D> {
        p.blend(|law| linear_patch_traction(kernel, &p.patch, &p.motion, p.rolling_speed, &self.patch_law(law)))
    }

    /// All that races and fluid do to a ball, given the surfaces where it stands (inner, outer) and who integrates
    /// traction over a loaded patch.
    pub fn ball_loads_with<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: [&RingState<D>; 2],
        surfaces: [&LocalSurface; 2],
        mut traction: impl FnMut(&LoadedPatch<'_, D, L>) -> PatchTraction<D>,
    ) -> BallLoads<D> {
        let normal = self.normal_loads(ball, rings, surfaces);
        let radius = normal.orbit_radius;
        let mut contact = |side, normal, k: usize| {
            self.race_contact(side, normal, (ball, rings[k], radius), surfaces[k].bare, &mut traction)
        };
        let (i, o) = (contact(Side::Inner, normal.inner, 0), contact(Side::Outer, normal.outer, 1));
        let (drag, churning) = self.fluid_loads(ball, radius, rings[0].speed);
        BallLoads { inner: i, outer: o, orbit_radius: radius, drag, churning, eccentricity: normal.eccentricity }
    }

    /// Drag against the orbit (N) and churning moment (N m) of the fluid on a ball.
    #[inline]
    pub fn fluid_loads<D: Scalar>(&self, ball: &BallState<D>, orbit_radius: D, inner_speed: D) -> (D, [D; 3]) {
        match &self.fluid {
            Some(fluid) => (
                fluid.drag.force(orbit_radius * (ball.orbital_speed - inner_speed * fluid.swirl)),
                fluid.churning.map_or([D::zero(); 3], |c| c.moment_vector(ball.spin)),
            ),
            None => (D::zero(), [D::zero(); 3]),
        }
    }

    fn race_contact<D: Scalar>(
        &self,
        side: Side,
        normal: NormalContact<D>,
        (ball, ring, orbit_radius): (&BallState<D>, &RingState<D>, D),
        bare: f64,
        traction: &mut impl FnMut(&LoadedPatch<'_, D, L>) -> PatchTraction<D>,
    ) -> RaceContact<D> {
        let NormalContact { pose, load, force: normal_force, closing_speed, slope_moment } = normal;
        let ellipse = self.hertz(side, &pose).ellipse(load);
        let [n_a, n_r] = pose.normal(side);
        let (motion, rolling_speed) = self.relative_motion([n_a, n_r], ball, ring, orbit_radius);
        let race = self.race(side);
        let traction = if load.re() > 0.0 {
            let patch = self.patch(race, &ellipse);
            traction(&LoadedPatch { race, patch, motion, rolling_speed, bare })
        } else {
            PatchTraction::zero()
        };
        let (traction_force, moment) = in_ball_axes([n_a, n_r], &traction);
        let force = [traction_force[0] - normal_force * n_a, traction_force[1] - normal_force * n_r, traction_force[2]];
        RaceContact {
            pose,
            load,
            normal_force,
            closing_speed,
            ellipse,
            motion,
            rolling_speed,
            traction,
            traction_force,
            force,
            moment,
            slope_moment,
        }
    }

    /// The ball's rigid motion against a race in the axes of a patch with the outward normal (a, r), and the rolling speed.
    #[inline]
    pub fn relative_motion<D: Scalar>(
        &self,
        [n_a, n_r]: [D; 2],
        ball: &BallState<D>,
        ring: &RingState<D>,
        orbit_radius: D,
    ) -> (RelativeMotion<D>, D) {
        let r_b = self.geometry.ball_radius();
        let centre = self.axis_of_rotation(ball, ring);
        let ring_velocity = in_azimuth_frame(ball.azimuth, ring.velocity);
        // W = v_ball − v_race − ω e_a × (r_c e_r − x_race).
        let along = orbit_radius * ball.orbital_speed - ring_velocity[2] - ring.speed * (orbit_radius - centre[1]);
        let axial = ball.velocity[0] - ring_velocity[0];
        let radial = ball.velocity[1] - ring_velocity[1] - ring.speed * centre[2];
        let w = [ball.spin[0] - ring.speed, ball.spin[1], ball.spin[2]];
        let motion = RelativeMotion {
            rolling: along,
            lateral: axial * n_r - radial * n_a,
            spin: w[0] * n_a + w[1] * n_r,
            about_lateral: w[0] * n_r - w[1] * n_a,
            about_rolling: w[2],
        };
        // Surface speeds along e_t as seen from the orbiting frame: ball ω × r_b n, race (ω_race − ω_m) e_a × r.
        let about_orbit = ball.spin[0] - ball.orbital_speed;
        let ball_surface = (about_orbit * n_r - ball.spin[1] * n_a) * r_b;
        let race_surface = (ring.speed - ball.orbital_speed) * (orbit_radius + n_r * r_b);
        (motion, (ball_surface + race_surface) * 0.5)
    }

    /// Where the axis about which a ring turns stands, in the ball's azimuth frame, m.
    #[inline]
    fn axis_of_rotation<D: Scalar>(&self, ball: &BallState<D>, ring: &RingState<D>) -> [D; 3] {
        if self.ring_turns_about_own_centre {
            in_azimuth_frame(ball.azimuth, ring.displacement)
        } else {
            [D::zero(); 3]
        }
    }

    /// The patch under a contact ellipse.
    #[inline]
    pub fn patch<D: Scalar>(&self, race: &Race<L>, ellipse: &Ellipse<D>) -> Patch<D> {
        Patch {
            semi_lateral: ellipse.semi_lateral(),
            semi_rolling: ellipse.semi_rolling(),
            peak_pressure: ellipse.peak_pressure,
            ball_radius: self.geometry.ball_radius(),
            surface_radius: race.surface_radius,
            moment_arm: self.moment_arm,
        }
    }

    /// A traction law with the case's choices.
    pub fn patch_law<'a>(&self, law: &'a L) -> PatchLaw<'a, L> {
        PatchLaw { law, slip_unit: self.slip_unit, pressure: self.pressure_choice }
    }

    /// Force on the balls by the inner ring (X, Y, Z, N), its moment about the ring's centre (X, Y, N m) and the torque
    /// about Z (N m) of one ball: the reaction acts on the ring.
    pub fn ring_action<D: Scalar>(&self, ball: &BallState<D>, loads: &BallLoads<D>, ring: &RingState<D>) -> [D; 6] {
        let [sin, cos] = ball.azimuth;
        let g = &self.geometry;
        let force = loads.inner.force;
        let centre = in_azimuth_frame(ball.azimuth, ring.displacement);
        // Ball centre from the ring's centre, which lies in the plane of its unloaded groove centres.
        let arm = [
            ball.position[0] - centre[0] - g.centre_distance() * g.sin_contact_angle(),
            loads.orbit_radius - centre[1],
            -centre[2],
        ];
        let moment = add(loads.inner.moment, cross(arm, force));
        [
            force[1] * cos - force[2] * sin,
            force[1] * sin + force[2] * cos,
            force[0],
            moment[1] * cos - moment[2] * sin,
            moment[1] * sin + moment[2] * cos,
            self.ring_torque(ball, &loads.inner, loads.orbit_radius, ring),
        ]
    }

    /// Torque (N m) about its axis that a ring puts on a ball; the reaction brakes the ring. The normal force points to the
    /// ring's axis of rotation and has no part in it, but on a groove that is not round.
    pub fn ring_torque<D: Scalar>(
        &self,
        ball: &BallState<D>,
        contact: &RaceContact<D>,
        orbit_radius: D,
        ring: &RingState<D>,
    ) -> D {
        let centre = self.axis_of_rotation(ball, ring);
        let [_, radial, along] = contact.traction_force;
        (orbit_radius - centre[1]) * along + centre[2] * radial + contact.moment[0] + contact.slope_moment
    }
}

/// (x, y, z) of the inertial frame as [a, r, t] at an azimuth given by its sine and cosine.
#[inline]
pub fn in_azimuth_frame<D: Scalar>([sin, cos]: [D; 2], [x, y, z]: [D; 3]) -> [D; 3] {
    [z, x * cos + y * sin, y * cos - x * sin]
}

/// Traction of a patch with the outward normal (a, r) as force and moment on the ball, [a, r, t].
#[inline]
pub fn in_ball_axes<D: Scalar>([n_a, n_r]: [D; 2], traction: &PatchTraction<D>) -> ([D; 3], [D; 3]) {
    // e_y = (n_r, −n_a, 0).
    let lateral = traction.force_lateral;
    let force = [lateral * n_r, -(lateral * n_a), traction.force_rolling];
    let moment = [
        traction.moment_lateral * n_r + traction.moment_normal * n_a,
        traction.moment_normal * n_r - traction.moment_lateral * n_a,
        traction.moment_rolling,
    ];
    (force, moment)
}

fn cross<D: Scalar>(a: [D; 3], b: [D; 3]) -> [D; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;
    use tribodyn_traction::PatchRule;

    const INNER_SPEED: f64 = 1400.0;

    fn bearing() -> Bearing {
        let text = include_str!("../../../fixtures/cases/paper-handset.ron");
        Bearing::new(&Case::from_ron(text).unwrap()).unwrap()
    }

    fn strips() -> Quadrature {
        Quadrature::new(PatchRule::SplitStrip { across: 8, along: 3 }).unwrap()
    }

    /// Pressed on both races by 50 µm of axial ring displacement, orbiting and spinning as given.
    fn loads(bearing: &Bearing, spin: [f64; 3], orbit: f64, speeds: [f64; 2]) -> (BallState, BallLoads, RingState) {
        let g = &bearing.geometry;
        let along = g.groove_offset(Side::Outer) + 2e-5;
        let (sin, cos) = (g.sin_contact_angle(), g.cos_contact_angle());
        let ball = BallState {
            azimuth: [0.6, 0.8],
            position: [along * sin, along * cos],
            velocity: [0.0; 2],
            orbital_speed: orbit,
            spin,
        };
        let inner = RingState { displacement: [0.0, 0.0, 5e-5 / sin], ..RingState::centred(speeds[0]) };
        let loads = bearing.ball_loads(&ball, &inner, &RingState::centred(speeds[1]), &strips());
        assert!(loads.inner.load > 100.0 && loads.outer.load > 100.0);
        (ball, loads, inner)
    }

    #[test]
    fn limit_turning_together_slides_nowhere() {
        let (_, loads, _) = loads(&bearing(), [INNER_SPEED, 0.0, 0.0], INNER_SPEED, [INNER_SPEED; 2]);
        for contact in [loads.inner, loads.outer] {
            let [along, across] = contact.motion.centre_slip(0.01508);
            assert!(along.abs() < 1e-10 && across == 0.0 && contact.motion.spin.abs() < 1e-10);
            // 1e-13 of 100 m/s of slip, times the slope of the steepest curves.
            assert!(contact.traction.force_rolling.abs() < 1e-9 * contact.load);
        }
    }

    /// What ball and inner ring lose together at their contact is friction: F·v + M·Ω − torque ω_i = −∬ κ p |Δv|.
    #[test]
    fn identity_power_at_the_inner_contact_is_friction() {
        let bearing = bearing();
        for (spin, orbit) in [([-3300.0, 1000.0, 0.0], 620.0), ([-2000.0, -300.0, 150.0], 300.0)] {
            let (ball, loads, inner) = loads(&bearing, spin, orbit, [INNER_SPEED, 0.0]);
            let [.., torque] = bearing.ring_action(&ball, &loads, &inner);
            let contact = &loads.inner;
            let on_ball: f64 = contact.moment.iter().zip(spin).map(|(m, w)| m * w).sum();
            let lost = contact.force[2] * loads.orbit_radius * orbit + on_ball - torque * INNER_SPEED;
            let friction = contact.traction.power;
            assert!(friction > 1.0, "{friction} W");
            assert!((lost + friction).abs() < 1e-10 * (torque * INNER_SPEED).abs().max(friction), "{lost} {friction}");
        }
    }

    #[test]
    fn identity_ring_pushes_as_hard_as_the_ball_is_pushed() {
        let bearing = bearing();
        let (ball, loads, inner) = loads(&bearing, [-3300.0, 1000.0, 0.0], 620.0, [INNER_SPEED, 0.0]);
        let [x, y, z, ..] = bearing.ring_action(&ball, &loads, &inner);
        let back = in_azimuth_frame(ball.azimuth, [x, y, z]);
        for (a, b) in back.iter().zip(loads.inner.force) {
            assert!((a - b).abs() < 1e-12 * loads.inner.load, "{a} {b}");
        }
    }
}
