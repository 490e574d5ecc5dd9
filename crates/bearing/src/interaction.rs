//! The ball–race interaction that the quasi-static and the transient solver share.
//!
//! Frame at the ball's azimuth φ: e_a axial (+Z), e_r radial outward, e_t = e_a × e_r along the orbit; vectors are
//! [a, r, t]. Forces and moments are those on the ball.

use crate::bearing::{Bearing, Race};
use crate::contact::NormalContact;
use crate::contact::{BallLoads, LoadedPatch, RaceContact};
use crate::modelling::RingCentre;
use crate::races::{Races, Side};
use crate::sliding::Sliding;
use crate::state::{BallState, RingState};
use crate::vectors::{add, cross};
use tribodyn_contact::{Ellipse, Scalar};
use tribodyn_traction::{Patch, PatchTraction, Quadrature, RelativeMotion};
use tribodyn_wear::LocalSurface;

impl Bearing {
    /// The surfaces where nothing has changed since the case began.
    pub fn surfaces(&self) -> Races<LocalSurface> {
        self.worn.map(|worn| LocalSurface { depth: 0.0, ..worn })
    }

    /// All that races as the case has them and fluid do to a ball, traction by the generic quadrature.
    pub fn ball_loads<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        quadrature: &Quadrature,
    ) -> BallLoads<D> {
        self.ball_loads_with(ball, rings, self.surfaces().each_ref(), |patch| self.plain_traction(patch, quadrature))
    }

    /// All that races and fluid do to a ball, given the surfaces where it stands and a function that integrates
    /// traction over a loaded patch.
    pub fn ball_loads_with<D: Scalar>(
        &self,
        ball: &BallState<D>,
        rings: Races<&RingState<D>>,
        surfaces: Races<&LocalSurface>,
        mut traction: impl FnMut(&LoadedPatch<'_, D>) -> PatchTraction<D>,
    ) -> BallLoads<D> {
        let normal = self.normal_loads(ball, rings, surfaces);
        let contacts = Races::from_fn(|side| {
            let contact = normal.contacts[side];
            let sliding = self.sliding(side, &contact, ball, (rings[side], normal.orbit_radius));
            self.race_contact(side, contact, &sliding, surfaces[side].bare, &mut traction)
        });
        let (drag, churning) = self.fluid_loads(ball, normal.orbit_radius, rings.inner.speed);
        BallLoads { contacts, orbit_radius: normal.orbit_radius, drag, churning }
    }

    /// Drag against the orbit (N) and churning moment (N m) of the fluid on a ball.
    #[inline(always)]
    pub fn fluid_loads<D: Scalar>(&self, ball: &BallState<D>, orbit_radius: D, inner_speed: D) -> (D, [D; 3]) {
        match &self.fluid {
            Some(fluid) => (
                fluid.drag_on(ball, orbit_radius, inner_speed),
                fluid.churning.map_or([D::zero(); 3], |c| c.moment_vector(ball.angular_velocity)),
            ),
            None => (D::zero(), [D::zero(); 3]),
        }
    }

    /// A contact with its traction, from its parts: how it is pressed, how it slides, and a function that integrates
    /// traction over a loaded patch.
    #[inline]
    pub fn race_contact<D: Scalar>(
        &self,
        side: Side,
        normal: NormalContact<D>,
        sliding: &Sliding<D>,
        bare: f64,
        traction: impl FnOnce(&LoadedPatch<'_, D>) -> PatchTraction<D>,
    ) -> RaceContact<D> {
        let ellipse = self.ellipse(side, &normal);
        let traction = if normal.load.re() > 0.0 {
            traction(&self.loaded_patch(side, &normal, &ellipse, sliding, bare))
        } else {
            PatchTraction::zero()
        };
        RaceContact::new(side, normal, ellipse, sliding, traction)
    }

    /// How a ball moves against a race at a contact.
    #[inline(always)]
    pub fn sliding<D: Scalar>(
        &self,
        side: Side,
        contact: &NormalContact<D>,
        ball: &BallState<D>,
        (ring, orbit_radius): (&RingState<D>, D),
    ) -> Sliding<D> {
        let sunk = self.sunk(side, contact, &ball.size);
        if ring.turning.is_some() {
            return self.sliding_in_meridian((side, contact, sunk), ball, (ring, orbit_radius));
        }
        let normal = contact.pose.normal(side);
        let (motion, rolling_speed) = self.relative_motion((normal, sunk), ball, ring, orbit_radius);
        Sliding { normal, motion, rolling_speed, sunk, meridian: None }
    }

    /// The patch of a contact, ready for its traction integral.
    #[inline]
    pub fn loaded_patch<D: Scalar>(
        &self,
        side: Side,
        contact: &NormalContact<D>,
        ellipse: &Ellipse<D>,
        sliding: &Sliding<D>,
        bare: f64,
    ) -> LoadedPatch<'_, D> {
        let race = &self.races[side];
        let tribology = self.tribology.as_ref();
        let Sliding { motion, rolling_speed, .. } = *sliding;
        let patch = self.patch(race, ellipse);
        let elastic = self.elastic.as_ref();
        LoadedPatch { side, race, tribology, load: contact.load, patch, motion, rolling_speed, bare, elastic }
    }

    /// The contact ellipse under a normal contact.
    #[inline]
    pub fn ellipse<D: Scalar>(&self, side: Side, contact: &NormalContact<D>) -> Ellipse<D> {
        self.hertz(side, &contact.pose).ellipse_at(contact.pose.approach)
    }

    /// The ball's rigid motion against a race in the axes of a patch with the outward normal (a, r), `sunk` (m) into
    /// the sphere of the ball, and the rolling speed.
    #[inline(always)]
    pub fn relative_motion<D: Scalar>(
        &self,
        ([n_a, n_r], sunk): ([D; 2], D),
        ball: &BallState<D>,
        ring: &RingState<D>,
        orbit_radius: D,
    ) -> (RelativeMotion<D>, D) {
        let r_b = self.geometry.ball_radius();
        let centre = self.axis_of_rotation(ball, ring);
        let ring_velocity = ball.frame.from_inertial(ring.velocity);
        // W = v_ball − v_race − ω e_a × (r_c e_r − x_race).
        let along = orbit_radius * ball.orbital_speed - ring_velocity[2] - ring.speed * (orbit_radius - centre[1]);
        let axial = ball.velocity[0] - ring_velocity[0];
        let radial = ball.velocity[1] - ring_velocity[1] - ring.speed * centre[2];
        let w = [ball.angular_velocity[0] - ring.speed, ball.angular_velocity[1], ball.angular_velocity[2]];
        let (about_lateral, about_rolling) = (w[0] * n_r - w[1] * n_a, w[2]);
        let motion = RelativeMotion {
            rolling: along - about_lateral * sunk,
            lateral: axial * n_r - radial * n_a + about_rolling * sunk,
            spin: w[0] * n_a + w[1] * n_r,
            about_lateral,
            about_rolling,
        };
        // Surface speeds along e_t as seen from the orbiting frame: ball ω × r n, race (ω_race − ω_m) e_a × r.
        let r_b = -sunk + r_b;
        let about_orbit = ball.angular_velocity[0] - ball.orbital_speed;
        let ball_surface = (about_orbit * n_r - ball.angular_velocity[1] * n_a) * r_b;
        let race_surface = (ring.speed - ball.orbital_speed) * (orbit_radius + n_r * r_b);
        (motion, (ball_surface + race_surface) * 0.5)
    }

    /// Where the axis about which a ring turns stands, in the ball's azimuth frame, m.
    #[inline(always)]
    fn axis_of_rotation<D: Scalar>(&self, ball: &BallState<D>, ring: &RingState<D>) -> [D; 3] {
        match self.modelling.ring_centre {
            Some(RingCentre::Inertial) => [D::zero(); 3],
            _ => ball.frame.from_inertial(ring.displacement),
        }
    }

    /// The patch under a contact ellipse.
    #[inline]
    pub fn patch<D: Scalar>(&self, race: &Race, ellipse: &Ellipse<D>) -> Patch<D> {
        Patch {
            semi_lateral: ellipse.semi_lateral(),
            semi_rolling: ellipse.semi_rolling(),
            peak_pressure: ellipse.peak_pressure,
            ball_radius: self.geometry.ball_radius(),
            surface_radius: race.surface_radius,
        }
    }

    /// Force of a ring on a ball as its reaction on the ring has it [a, r, t], N.
    #[inline(always)]
    pub fn reaction<D: Scalar>(&self, side: Side, contact: &RaceContact<D>) -> [D; 3] {
        let [a, r, t] = contact.normal.on_ring(side, self.ring_offset);
        let traction = contact.traction_force;
        [traction[0] - a, traction[1] - r, traction[2] - t]
    }

    /// Force on the balls by the inner ring (X, Y, Z, N), its moment about the ring's centre (X, Y, N m) and the torque
    /// about Z (N m) of one ball: the reaction acts on the ring.
    pub fn ring_action<D: Scalar>(&self, ball: &BallState<D>, loads: &BallLoads<D>, ring: &RingState<D>) -> [D; 6] {
        let contact = &loads.contacts.inner;
        let force = self.reaction(Side::Inner, contact);
        let arm = self.geometry.arm(Side::Inner, ball.frame, [ball.position[0], loads.orbit_radius], ring);
        let moment = add(contact.moment, cross(arm, force));
        let [x, y, z] = ball.frame.to_inertial(force);
        let [moment_x, moment_y, _] = ball.frame.to_inertial(moment);
        [x, y, z, moment_x, moment_y, self.ring_torque(ball, contact, loads.orbit_radius, ring)]
    }

    /// Torque (N m) about its axis that a ring puts on a ball; the reaction brakes the ring. The normal force points to
    /// the ring's axis of rotation and has no part in it, but on a groove that is not round.
    #[inline(always)]
    pub fn ring_torque<D: Scalar>(
        &self,
        ball: &BallState<D>,
        contact: &RaceContact<D>,
        orbit_radius: D,
        ring: &RingState<D>,
    ) -> D {
        let centre = self.axis_of_rotation(ball, ring);
        let [_, radial, along] = contact.traction_force;
        (orbit_radius - centre[1]) * along + centre[2] * radial + contact.moment[0] + contact.normal.slope_moment
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::BearingSpec;
    use crate::frame::AzimuthFrame;
    use crate::modelling::{Modelling, PatchSurfaces, RollingRadius};
    use crate::state::BallSize;
    use crate::test_bearing::spec;
    use tribodyn_traction::{PatchRule, TangentialElasticity};

    const INNER_SPEED: f64 = 1400.0;

    fn bearing() -> Bearing {
        Bearing::new(spec()).unwrap()
    }

    fn strips() -> Quadrature {
        Quadrature::new(PatchRule::SplitStrip { across: 8, along: 3 }).unwrap()
    }

    /// Pressed on both races by 50 µm of axial ring displacement, orbiting and spinning as given.
    fn loads(
        bearing: &Bearing,
        angular_velocity: [f64; 3],
        orbit: f64,
        speeds: [f64; 2],
    ) -> (BallState, BallLoads, RingState) {
        let g = &bearing.geometry;
        let along = g.groove_offset(Side::Outer) + 2e-5;
        let (sin, cos) = (g.sin_contact_angle(), g.cos_contact_angle());
        let ball = BallState {
            frame: AzimuthFrame { sin: 0.6, cos: 0.8 },
            position: [along * sin, along * cos],
            velocity: [0.0; 2],
            orbital_speed: orbit,
            angular_velocity,
            size: BallSize::NOMINAL,
        };
        let inner = RingState { displacement: [0.0, 0.0, 5e-5 / sin], ..RingState::centred(speeds[0]) };
        let outer = RingState::centred(speeds[1]);
        let loads = bearing.ball_loads(&ball, Races { inner: &inner, outer: &outer }, &strips());
        assert!(loads.contacts.inner.normal.load > 100.0 && loads.contacts.outer.normal.load > 100.0);
        (ball, loads, inner)
    }

    #[test]
    fn limit_turning_together_slides_nowhere() {
        let (_, loads, _) = loads(&bearing(), [INNER_SPEED, 0.0, 0.0], INNER_SPEED, [INNER_SPEED; 2]);
        for contact in [loads.contacts.inner, loads.contacts.outer] {
            let [along, across] = contact.motion.centre_slip(0.01508);
            assert!(along.abs() < 1e-10 && across == 0.0 && contact.motion.spin.abs() < 1e-10);
            // 1e-13 of 100 m/s of slip, times the slope of the steepest curves.
            assert!(contact.traction.force_rolling.abs() < 1e-9 * contact.normal.load);
        }
    }

    /// The power that ball and inner ring lose together at their contact is that of friction:
    /// F·v + M·Ω − torque ω_i = −∬ κ p |Δv|.
    #[test]
    fn identity_power_at_the_inner_contact_is_friction() {
        let with = |modelling| Bearing::new(BearingSpec { modelling, ..spec() }).unwrap();
        let plain = spec().modelling;
        let fine = PatchSurfaces::Elastic { strips: 16, cells: 256 };
        for (bearing, allowed) in [
            (bearing(), 1e-10),
            (with(Modelling { rolling_radius: Some(RollingRadius::Deformed), ..plain }), 1e-10),
            // True slip and forces agree as the cells get finer.
            (with(Modelling { patch: Some(fine), ..plain }), 3e-4),
            (with(Modelling { patch: Some(fine), rolling_radius: Some(RollingRadius::Deformed), ..plain }), 3e-4),
        ] {
            for (angular_velocity, orbit) in [([-3300.0, 1000.0, 0.0], 620.0), ([-2000.0, -300.0, 150.0], 300.0)] {
                let (ball, loads, inner) = loads(&bearing, angular_velocity, orbit, [INNER_SPEED, 0.0]);
                let [.., torque] = bearing.ring_action(&ball, &loads, &inner);
                let contact = &loads.contacts.inner;
                let on_ball: f64 = contact.moment.iter().zip(angular_velocity).map(|(m, w)| m * w).sum();
                let lost = contact.force[2] * loads.orbit_radius * orbit + on_ball - torque * INNER_SPEED;
                let friction = contact.traction.power;
                assert!(friction > 1.0, "{friction} W");
                let scale = (torque * INNER_SPEED).abs().max(friction);
                assert!((lost + friction).abs() < allowed * scale, "{lost} {friction} {allowed:e}");
            }
        }
    }

    /// The middle of the patch stands nearer to the ball's centre by its part of the approach, half between bodies of
    /// one steel: the slip there is that of the bodies at this radius.
    #[test]
    fn identity_a_deformed_ball_slides_as_at_the_smaller_radius() {
        let modelling = Modelling { rolling_radius: Some(RollingRadius::Deformed), ..spec().modelling };
        let deformed = Bearing::new(BearingSpec { modelling, ..spec() }).unwrap();
        let at = |bearing: &Bearing| loads(bearing, [-3300.0, 1000.0, 20.0], 620.0, [INNER_SPEED, 0.0]).1;
        let (plain, sunk) = (at(&bearing()), at(&deformed));
        for side in Side::BOTH {
            let (a, b) = (&plain.contacts[side], &sunk.contacts[side]);
            let radius = 0.01508 - 0.5 * a.normal.pose.approach;
            let expected = a.motion.centre_slip(radius);
            let found = b.motion.centre_slip(0.01508);
            for (e, f) in expected.iter().zip(found) {
                assert!((e - f).abs() < 1e-10, "{e} {f}");
            }
            assert!((a.motion.centre_slip(0.01508)[0] - expected[0]).abs() > 1e-3);
        }
    }

    /// Without tangential flexibility the elastic patch is the rigid one.
    #[test]
    fn limit_stiff_surfaces_are_the_rigid_patch() {
        let modelling =
            Modelling { patch: Some(PatchSurfaces::Elastic { strips: 12, cells: 128 }), ..spec().modelling };
        let mut elastic = Bearing::new(BearingSpec { modelling, ..spec() }).unwrap();
        let at = |bearing: &Bearing| loads(bearing, [-3300.0, 1000.0, 20.0], 620.0, [INNER_SPEED, 0.0]).1;
        let (rigid, soft) = (at(&bearing()), at(&elastic));
        let stiff = TangentialElasticity::new(1e18, 0.28).unwrap();
        elastic.elastic.as_mut().unwrap().pairs = Races { inner: stiff.clone(), outer: stiff };
        let stiff = at(&elastic);
        for side in Side::BOTH {
            let apart = |loads: &BallLoads| {
                let (a, b) = (&rigid.contacts[side], &loads.contacts[side]);
                let square = |k: usize| (a.traction_force[k] - b.traction_force[k]).powi(2);
                (0..3).map(square).sum::<f64>().sqrt() / a.normal.load
            };
            assert!(apart(&stiff) < 1e-4, "{:e}", apart(&stiff));
            assert!(apart(&soft) > 3.0 * apart(&stiff), "{:e} {:e}", apart(&soft), apart(&stiff));
        }
    }

    #[test]
    fn identity_ring_pushes_as_hard_as_the_ball_is_pushed() {
        let bearing = bearing();
        let (ball, loads, inner) = loads(&bearing, [-3300.0, 1000.0, 0.0], 620.0, [INNER_SPEED, 0.0]);
        let [x, y, z, ..] = bearing.ring_action(&ball, &loads, &inner);
        let back = ball.frame.from_inertial([x, y, z]);
        for (a, b) in back.iter().zip(loads.contacts.inner.force) {
            assert!((a - b).abs() < 1e-12 * loads.contacts.inner.normal.load, "{a} {b}");
        }
    }
}
