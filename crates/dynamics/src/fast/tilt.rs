//! The kick of rings that tilt, after that of the balls: the forces that the balls have given a ring, at their arms,
//! and the turning of the ring itself, by the implicit midpoint rule. The balls follow the tilts as they do the
//! translations.

use super::Fast;
use super::friction::inverse_with_held;
use super::lanes::{Lane, WIDTH, blocks, lanes_of, put};
use super::scratch::force_of;
use crate::equations::Frame;
use crate::layout::AXIAL;
use crate::machine::Machine;
use crate::tilting::Tilting;
use nalgebra::{Matrix2, SMatrix, SVector, Vector2, Vector5};
use tribodyn_bearing::vectors::{cross, dot};
use tribodyn_bearing::{Races, RingState, Side};

/// Freedoms of the rings: x, y, z of the inner one, x, y of the outer one, tilts of both about x and y.
const RINGS: usize = 9;

impl Fast {
    /// How much faster the rings move at each ball at the end of a step (a, r, t), by blocks: their translations and
    /// tilts, with all that the balls do meanwhile to first order.
    pub(super) fn moved_by_tilting(
        &self,
        machine: &Machine,
        frame: &Frame,
        on_rings: &Vector5<f64>,
        h: f64,
    ) -> Vec<[Lane; 6]> {
        let (mut sum, mut given) = self.of_bodies(machine, frame, h);
        given.fixed_rows_mut::<5>(0).copy_from(on_rings);
        let moves: Vec<_> = (0..self.friction.len()).map(|index| self.moves(machine, frame, index)).collect();
        for (friction, moves) in self.friction.iter().zip(&moves) {
            sum -= moves.tr_mul(&(friction.force_on_rings() * moves)) * h;
        }
        let change = inverse_with_held(sum) * given * h;
        let mut moved = vec![[Lane::ZERO; 6]; blocks(moves.len())];
        for (index, moves) in moves.iter().enumerate() {
            let (block, at_ball) = (index / WIDTH, (moves * change).into());
            lanes_of(machine.layout, block, index % WIDTH).for_each(|k| put(&mut moved[block], k, at_ball));
        }
        moved
    }

    /// Masses and inertias of the rings' freedoms, infinite where they are held, less what their own turning takes in a
    /// step; and the moments on them.
    fn of_bodies(&self, machine: &Machine, frame: &Frame, h: f64) -> (SMatrix<f64, RINGS, RINGS>, SVector<f64, RINGS>) {
        let mut sum = SMatrix::<f64, RINGS, RINGS>::zeros();
        let mut given = SVector::<f64, RINGS>::zeros();
        let translations = machine.inner.free.map(|free| (free, machine.inner.mass)).into_iter();
        let translations = translations.chain(machine.outer.free.map(|free| (free, machine.outer.mass)));
        for (k, (free, mass)) in translations.enumerate() {
            sum[(k, k)] = if free { mass } else { f64::INFINITY };
        }
        for (side, ring) in frame.rings.iter() {
            let at = 5 + 2 * side as usize;
            let Some(tilting) = &machine.tilting[side] else {
                (at..at + 2).for_each(|k| sum[(k, k)] = f64::INFINITY);
                continue;
            };
            let by_balls = self.by_balls(machine, side, frame);
            let (body, moment) = turning(machine, (side, ring, tilting), by_balls, h);
            sum.fixed_view_mut::<2, 2>(at, at).copy_from(&body);
            given.fixed_rows_mut::<2>(at).copy_from(&moment);
        }
        (sum, given)
    }

    /// How the freedoms of the rings move them at the contacts of a ball (a, r, t).
    fn moves(&self, machine: &Machine, frame: &Frame, index: usize) -> SMatrix<f64, 6, RINGS> {
        let (pressed, balls, k) =
            (&self.scratch.pressed[index / WIDTH], &self.scratch.balls[index / WIDTH], index % WIDTH);
        let (axes, radius) = (pressed.axes(k), machine.bearing.geometry.ball_radius());
        let mut moves = SMatrix::<f64, 6, RINGS>::zeros();
        for (side, ring) in frame.rings.iter() {
            let (row, tilt) = (3 * side as usize, 5 + 2 * side as usize);
            let [n_a, n_r] = pressed.contact(side, k).pose.normal(side);
            let arm = machine.bearing.geometry.arm(side, axes, [balls[AXIAL].0[k], pressed.orbit_radius(k)], ring);
            let arm = [arm[0] + radius * n_a, arm[1] + radius * n_r, arm[2]];
            for (unit, direction) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
                let at_ball = axes.from_inertial(direction);
                // The outer ring does not move along z.
                let place = (side == Side::Inner || unit < 2).then_some(row + unit);
                let by_tilt = (unit < 2).then(|| cross(at_ball, arm));
                for i in 0..3 {
                    place.into_iter().for_each(|place| moves[(row + i, place)] = at_ball[i]);
                    by_tilt.into_iter().for_each(|moved| moves[(row + i, tilt + unit)] = moved[i]);
                }
            }
        }
        moves
    }

    /// Angular velocities of the rings after `h` under balls, their own turning, and the moments of a cage's lands.
    pub(super) fn kick_tilts(
        &self,
        machine: &Machine,
        y: &mut [f64],
        (frame, lands): (&Frame, &Races<[f64; 3]>),
        h: f64,
    ) {
        for (side, tilting) in machine.tilting.iter() {
            let Some(tilting) = tilting else { continue };
            let (by_balls, by_lands) = (self.by_balls(machine, side, frame), lands[side]);
            let by_all = [0, 1, 2].map(|k| by_balls[k] + by_lands[k]);
            let (body, moment) = turning(machine, (side, &frame.rings[side], tilting), by_all, h);
            let change = body.try_inverse().map_or(Vector2::zeros(), |inverse| inverse * moment * h);
            machine.layout.velocities_of_tilt(side).zip(change.iter()).for_each(|(k, by)| y[k] += by);
        }
    }

    /// Moment of the balls on a ring about its centre (x, y, z), N m.
    fn by_balls(&self, machine: &Machine, side: Side, frame: &Frame) -> [f64; 3] {
        let (ring, mut moment) = (&frame.rings[side], [0.0; 3]);
        for index in 0..machine.layout.balls {
            let (block, k) = (index / WIDTH, index % WIDTH);
            let (pressed, kick_forces) = (&self.scratch.pressed[block], &self.scratch.kick_forces[block]);
            let state = pressed.state(machine, &self.scratch.balls[block], k);
            let at_start = kick_forces.forces(side, k);
            let mean = force_of(&self.scratch.mean_forces[block], side, k);
            // What the force is in the mean of the step acts where it acts at its start: at the contact.
            let contact = pressed.contact(side, k);
            let [n_a, n_r] = contact.pose.normal(side);
            let radius = machine.bearing.geometry.ball_radius() + state.size.excess;
            let point = [n_a, n_r * contact.lean.cos, -n_r * contact.lean.sin].map(|n| n * radius);
            let change = [0, 1, 2].map(|i| mean[i] - at_start.force[i]);
            let by_change = cross(point, change);
            let about_ball = [0, 1, 2].map(|i| at_start.moment[i] + by_change[i]);
            let at = (ring, pressed.orbit_radius(k));
            let on_ball = machine.bearing.moment_about(side, &state, (mean, about_ball), at);
            let on_ball = state.frame.to_inertial(on_ball);
            (0..3).for_each(|i| moment[i] -= on_ball[i]);
        }
        moment
    }
}

/// Inertia of a ring that tilts across its axis, less what its own turning takes in a step by the implicit midpoint
/// rule, kg m², and the moment about x and y of others and of its own turning, N m.
fn turning(
    machine: &Machine,
    (side, ring, tilting): (Side, &RingState, &Tilting),
    by_others: [f64; 3],
    h: f64,
) -> (Matrix2<f64>, Vector2<f64>) {
    let axis = ring.axis();
    let along = dot(by_others, axis);
    let own = |turning: [f64; 3]| {
        let ring = RingState { turning: Some(turning), ..*ring };
        Vector2::from(machine.gyroscopic_moment(side, &ring))
    };
    let unit = |k: usize| {
        let mut w = [0.0; 3];
        w[k] = 1.0;
        w[2] = -axis[k] / axis[2];
        own(w)
    };
    let across = Vector2::new(by_others[0] - along * axis[0], by_others[1] - along * axis[1]);
    let inertia = Matrix2::from_diagonal_element(tilting.body.transverse_inertia);
    let body = inertia - Matrix2::from_columns(&[unit(0), unit(1)]) * (0.5 * h);
    (body, across + own(ring.turning.unwrap_or_default()))
}
