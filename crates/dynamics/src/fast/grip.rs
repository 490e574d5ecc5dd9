//! The balls of a block in the kick, all by linear forms: tractions, responses, and what follows from the rings.

use super::drift::Stand;
use super::friction::LinearFriction;
use super::lanes::{Lane, WIDTH, get, put};
use crate::equations::{Equations, Frame};
use crate::layout::{BALL, VELOCITY};
use crate::linear::LinearTraction;
use nalgebra::Matrix6;
use tribodyn_bearing::{AzimuthFrame, BallState, ContactForces, Side};

/// Numbers of a linear traction, and of a linear friction.
const LINEAR: usize = LinearTraction::NUMBERS;

/// The linear forms of the balls of a block.
#[derive(Debug, Clone)]
pub(super) struct Forms {
    traction: [[Lane; LINEAR]; 2],
    response: [[Lane; 36]; 2],
    coupling: [Lane; 36],
    own: [[Lane; 9]; 2],
    follow: [[Lane; 36]; 2],
}

impl Forms {
    pub const NONE: Self = Self {
        traction: [[Lane::ZERO; LINEAR]; 2],
        response: [[Lane::ZERO; 36]; 2],
        coupling: [Lane::ZERO; 36],
        own: [[Lane::ZERO; 9]; 2],
        follow: [[Lane::ZERO; 36]; 2],
    };

    /// Takes over the forms of one ball; of its tractions those of the sides that are `new`.
    pub fn set(&mut self, k: usize, (traction, new): (&[LinearTraction; 2], [bool; 2]), friction: &LinearFriction) {
        let six = |lanes: &mut [Lane; 36], m: &Matrix6<f64>| put(lanes, k, flat(m.data.0));
        six(&mut self.coupling, &friction.coupling);
        for i in 0..2 {
            if new[i] {
                put(&mut self.traction[i], k, traction[i].numbers());
            }
            six(&mut self.response[i], &friction.response[i]);
            six(&mut self.follow[i], &friction.follow[i]);
            put(&mut self.own[i], k, flat(friction.own[i].data.0));
        }
    }
}

/// The elements of a matrix, column by column.
fn flat<const N: usize, const COLUMNS: usize, const ALL: usize>(m: [[f64; N]; COLUMNS]) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    all.iter_mut().zip(m.as_flattened()).for_each(|(to, from)| *to = *from);
    all
}

/// What the kick finds of the balls of a block.
#[derive(Debug, Clone)]
pub(super) struct Grips {
    /// 1 where the linear traction of the inner, or the outer, contact serves, else 0.
    near: [Lane; 2],
    /// Force and moment on the ball by the inner, then the outer contact.
    forces: [[Lane; 6]; 2],
    /// Wear integrals.
    pub wear: [Lane; 2],
    /// Changes of the velocities by all accelerations of the friction part.
    pub push: [Lane; 6],
}

impl Grips {
    pub const NONE: Self =
        Self { near: [Lane::ZERO; 2], forces: [[Lane::ZERO; 6]; 2], wear: [Lane::ZERO; 2], push: [Lane::ZERO; 6] };

    pub fn is_near(&self, side: Side, k: usize) -> bool {
        self.near[side as usize].0[k] > 0.0
    }

    pub fn forces(&self, side: Side, k: usize) -> ContactForces {
        let [a, b, c, d, e, f] = get(&self.forces[side as usize], k);
        ContactForces { force: [a, b, c], moment: [d, e, f] }
    }

    pub fn set_forces(&mut self, side: Side, k: usize, of: &ContactForces) {
        let ([a, b, c], [d, e, f]) = (of.force, of.moment);
        put(&mut self.forces[side as usize], k, [a, b, c, d, e, f]);
    }
}

/// Force and moment on a ball by one contact, the wear integral, and 1 where its linear form serves, else 0.
#[inline(always)]
fn contact<E: Equations>(
    equations: &E,
    side: Side,
    (frame, state): (&Frame, &BallState),
    (stand, form, k): (&Stand, &[Lane; LINEAR], usize),
) -> ([f64; 6], f64, f64) {
    let ball_radius = equations.machine().bearing.geometry.ball_radius();
    let contact = stand.contact(side, k);
    let sliding = equations.sliding(side, &contact, state, (frame, stand.orbit_radius(k)));
    let linear = LinearTraction::from_numbers(|i| form[i].0[k]);
    let (change, serves) = linear.reaches(&sliding.motion, contact.load, (stand.bare(side, k), 1.0), ball_radius);
    let traction = linear.traction(&sliding.motion, &change);
    let ContactForces { force: [a, b, c], moment: [d, e, f] } = sliding.on_ball(&traction);
    // A contact without load has no traction, and no linear form that could fail. A factor, since the compiler would
    // branch for a choice.
    let loaded = contact.load > 0.0;
    let share = if loaded { 1.0 } else { 0.0 };
    let forces = [share * a, share * b, share * c, share * d, share * e, share * f];
    (forces, share * traction.wear_integral, if loaded & !serves { 0.0 } else { 1.0 })
}

/// Tractions of the balls of a block from their linear forms, and whether those serve.
#[inline(always)]
pub(super) fn tractions<E: Equations>(
    equations: &E,
    frame: &Frame,
    (balls, stand, forms): (&[Lane; BALL], &Stand, &Forms),
    grips: &mut Grips,
) {
    let (mut out, frame) = (Grips::NONE, *frame);
    for k in 0..WIDTH {
        let state = equations.state_at(stand.axes(k), stand.position(k), &get(balls, k));
        let (forces, wear, near) = contact(equations, Side::Inner, (&frame, &state), (stand, &forms.traction[0], k));
        put(&mut out.forces[0], k, forces);
        (out.wear[0].0[k], out.near[0].0[k]) = (wear, near);
        let (forces, wear, near) = contact(equations, Side::Outer, (&frame, &state), (stand, &forms.traction[1], k));
        put(&mut out.forces[1], k, forces);
        (out.wear[1].0[k], out.near[1].0[k]) = (wear, near);
    }
    *grips = out;
}

/// m v.
#[inline(always)]
#[allow(clippy::needless_range_loop)] // as for the lanes themselves
fn times(m: &[Lane; 36], v: [f64; 6], k: usize) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for column in 0..6 {
        for row in 0..6 {
            sum[row] += m[6 * column + row].0[k] * v[column];
        }
    }
    sum
}

/// mᵀ v.
#[inline(always)]
#[allow(clippy::needless_range_loop)] // as for the lanes themselves
fn transposed(m: &[Lane; 36], v: [f64; 6], k: usize) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for column in 0..6 {
        for row in 0..6 {
            sum[column] += m[6 * column + row].0[k] * v[row];
        }
    }
    sum
}

/// (a, r, t) of inner and outer ring as (x, y, z) and (x, y).
#[inline(always)]
fn inertial(axes: AzimuthFrame, [a, r, t, outer_a, outer_r, outer_t]: [f64; 6]) -> [f64; 5] {
    let [x, y, z] = axes.to_inertial([a, r, t]);
    let [outer_x, outer_y, _] = axes.to_inertial([outer_a, outer_r, outer_t]);
    [x, y, z, outer_x, outer_y]
}

/// Velocities of the balls of a block with their changes.
#[inline(always)]
fn add_velocities(balls: &mut [Lane; BALL], changes: &[Lane; 6]) {
    for (lane, change) in balls[VELOCITY..].iter_mut().zip(changes) {
        lane.0.iter_mut().zip(change.0).for_each(|(v, change)| *v += change);
    }
}

/// Every ball by itself with the rings held, and the force on the rings, inertial axes.
#[inline(always)]
pub(super) fn respond(
    balls: &mut [Lane; BALL],
    (stand, forms, grips): (&Stand, &Forms, &Grips),
    reaction: &mut [Lane; 5],
) {
    let (mut changes, mut on_rings) = ([Lane::ZERO; 6], [Lane::ZERO; 5]);
    for k in 0..WIDTH {
        let push = get(&grips.push, k);
        let (change, mean) = (times(&forms.response[0], push, k), times(&forms.response[1], push, k));
        let (i, o) = (get(&grips.forces[0], k), get(&grips.forces[1], k));
        let back = transposed(&forms.coupling, mean, k);
        let force = [back[0] - i[0], back[1] - i[1], back[2] - i[2], back[3] - o[0], back[4] - o[1], back[5] - o[2]];
        put(&mut changes, k, change);
        put(&mut on_rings, k, inertial(stand.axes(k), force));
    }
    add_velocities(balls, &changes);
    *reaction = on_rings;
}

/// What the motion of the rings, inertial axes, does to the balls, and the force on the rings, inertial axes.
#[inline(always)]
pub(super) fn follow(
    balls: &mut [Lane; BALL],
    rings: [f64; 5],
    (stand, forms): (&Stand, &Forms),
    reaction: &mut [Lane; 5],
) {
    let (mut changes, mut on_rings) = ([Lane::ZERO; 6], [Lane::ZERO; 5]);
    for k in 0..WIDTH {
        let axes = stand.axes(k);
        let [a, r, t] = axes.from_inertial([rings[0], rings[1], rings[2]]);
        let [_, outer_r, outer_t] = axes.from_inertial([rings[3], rings[4], 0.0]);
        let rings = [a, r, t, 0.0, outer_r, outer_t];
        let (change, mean) = (times(&forms.follow[0], rings, k), times(&forms.follow[1], rings, k));
        let mut force = transposed(&forms.coupling, mean, k);
        for row in 0..3 {
            for column in 0..3 {
                let [inner, outer] = [forms.own[0][3 * column + row].0[k], forms.own[1][3 * column + row].0[k]];
                force[row] += 0.5 * (inner * rings[column]);
                force[3 + row] += 0.5 * (outer * rings[3 + column]);
            }
        }
        put(&mut changes, k, change);
        put(&mut on_rings, k, inertial(axes, force));
    }
    add_velocities(balls, &changes);
    *reaction = on_rings;
}
