//! The kick of an inner ring that tilts, after that of the balls: the forces that the balls have given the ring, at
//! their arms, and the turning of the ring itself, by the implicit midpoint rule. Friction that damps the tilt is
//! implicit like that on the ring's translations.

use super::Fast;
use super::lanes::{Lane, WIDTH, filled, get};
use crate::equations::Frame;
use crate::layout::Layout;
use crate::machine::Machine;
use nalgebra::{Matrix2, Vector2};
use tribodyn_bearing::Side;
use tribodyn_bearing::vectors::cross;

/// Mean force of each ball on an inner ring that tilts over a step (x, y, z), N.
#[derive(Debug, Default)]
pub(super) struct OnInner(Vec<[f64; 3]>);

impl OnInner {
    /// Adds forces of the balls of a block; of rings that do not tilt nothing is kept.
    pub fn add(&mut self, l: Layout, block: usize, forces: &[Lane; 5]) {
        if !l.tilting {
            return;
        }
        self.0.resize(l.balls, [0.0; 3]);
        for k in 0..filled(l, block) {
            let [x, y, z, ..] = get(forces, k);
            let sum = &mut self.0[WIDTH * block + k];
            *sum = [sum[0] + x, sum[1] + y, sum[2] + z];
        }
    }
}

impl Fast {
    pub(super) fn kick_tilt(&self, machine: &Machine, y: &mut [f64], (frame, on_inner): (&Frame, &OnInner), h: f64) {
        let Some(tilting) = &machine.tilting else { return };
        let ring = &frame.rings.inner;
        let (mut moment, mut damping) = ([0.0; 3], Matrix2::zeros());
        for (index, force) in on_inner.0.iter().enumerate() {
            let (block, k) = (index / WIDTH, index % WIDTH);
            let (stand, grips) = (&self.scratch.stands[block], &self.scratch.grips[block]);
            let state = stand.state(machine, &self.scratch.balls[block], k);
            let at_start = grips.forces(Side::Inner, k);
            let mean = state.frame.from_inertial(force.map(|f| -f));
            // What the force is in the mean of the step acts where it acts at its start: at the contact.
            let contact = stand.contact(Side::Inner, k);
            let [n_a, n_r] = contact.pose.normal(Side::Inner);
            let radius = machine.bearing.geometry.ball_radius() + state.size.excess;
            let point = [n_a, n_r * contact.lean.cos, -n_r * contact.lean.sin].map(|n| n * radius);
            let change = [0, 1, 2].map(|i| mean[i] - at_start.force[i]);
            let by_change = cross(point, change);
            let about_ball = [0, 1, 2].map(|i| at_start.moment[i] + by_change[i]);
            let r = stand.orbit_radius(k);
            let on_ball = machine.bearing.moment_about(Side::Inner, &state, (mean, about_ball), (ring, r));
            let on_ball = state.frame.to_inertial(on_ball);
            (0..3).for_each(|i| moment[i] -= on_ball[i]);
            let friction = &self.friction[index];
            let axial = friction.coupling.column(0).dot(&friction.follow[1].column(0)) + 0.5 * friction.own[0][(0, 0)];
            let lever = Vector2::new(state.frame.sin, -state.frame.cos) * r;
            damping += lever * lever.transpose() * axial;
        }
        let axis = ring.axis();
        let along = (0..3).map(|i| moment[i] * axis[i]).sum::<f64>();
        let own = |turning: [f64; 3]| {
            let ring = tribodyn_bearing::RingState { turning: Some(turning), ..*ring };
            Vector2::from(machine.gyroscopic_moment(&ring))
        };
        let unit = |k: usize| {
            let mut w = [0.0; 3];
            w[k] = 1.0;
            w[2] = -axis[k] / axis[2];
            own(w)
        };
        let turned = Matrix2::from_columns(&[unit(0), unit(1)]);
        let matrix = Matrix2::from_diagonal_element(tilting.body.transverse_inertia) - (damping + turned * 0.5) * h;
        let given = Vector2::new(moment[0] - along * axis[0], moment[1] - along * axis[1])
            + own(ring.turning.unwrap_or_default());
        let change = matrix.try_inverse().map_or(Vector2::zeros(), |inverse| inverse * given * h);
        machine.layout.velocities_of_tilt().zip(change.iter()).for_each(|(k, by)| y[k] += by);
    }
}
