//! The balls of a block in the kick, all by linear forms: tractions, responses, and what follows from the rings.

use super::drift::Pressed;
use super::friction::LinearFriction;
use super::lanes::{Lane, get, put};
use crate::equations::{Equations, Frame};
use crate::layout::{BALL, VELOCITY};
use crate::linear::{Contacts, LinearTraction};
use nalgebra::Matrix6;
use std::ops::Range;
use tribodyn_bearing::{AzimuthFrame, BallState, ContactForces, PocketLoad, Races, RingState, Side, Sliding};
use tribodyn_traction::PatchTraction;

/// Numbers of a linear traction, and of a linear friction.
pub(super) const LINEAR: usize = LinearTraction::NUMBERS;

/// The linear forms of the balls of a block.
#[derive(Debug, Clone)]
pub(super) struct Forms {
    pub traction: [[Lane; LINEAR]; 2],
    /// Last steps that the tractions serve.
    last: [Lane; 2],
    /// 1 where friction was made for a contact with load, else 0.
    loaded: [Lane; 2],
    response: [[Lane; 36]; 2],
    coupling: [Lane; 36],
    own: [[Lane; 9]; 2],
    follow: [[Lane; 36]; 2],
}

impl Forms {
    pub const NONE: Self = Self {
        traction: [[Lane::ZERO; LINEAR]; 2],
        last: [Lane::ZERO; 2],
        loaded: [Lane::ZERO; 2],
        response: [[Lane::ZERO; 36]; 2],
        coupling: [Lane::ZERO; 36],
        own: [[Lane::ZERO; 9]; 2],
        follow: [[Lane::ZERO; 36]; 2],
    };

    /// Takes over the tractions of one ball, those of the sides that are `new`.
    pub fn set_tractions(&mut self, lanes: Range<usize>, contacts: &Contacts, new: [bool; 2]) {
        for (i, k) in (0..2).filter(|&i| new[i]).flat_map(|i| lanes.clone().map(move |k| (i, k))) {
            put(&mut self.traction[i], k, contacts.of[i].numbers());
            self.last[i].0[k] = contacts.last[i] as f64;
        }
    }

    /// Takes over the friction of one ball.
    pub fn set_friction(&mut self, lanes: Range<usize>, friction: &LinearFriction) {
        for k in lanes {
            let six = |to: &mut [Lane; 36], m: &Matrix6<f64>| put(to, k, flat(m.data.0));
            six(&mut self.coupling, &friction.coupling);
            for i in 0..2 {
                six(&mut self.response[i], &friction.response[i]);
                six(&mut self.follow[i], &friction.follow[i]);
                put(&mut self.own[i], k, flat(friction.own[i].data.0));
                self.loaded[i].0[k] = if friction.loaded()[i] { 1.0 } else { 0.0 };
            }
        }
    }
}

impl Forms {
    /// Lateral semi-axis of a contact where it was linearised, m.
    pub fn semi_lateral(&self, side: Side, k: usize) -> f64 {
        self.traction[side as usize][LinearTraction::SEMI_LATERAL].0[k]
    }
}

/// The elements of a matrix, column by column.
fn flat<const N: usize, const COLUMNS: usize, const ALL: usize>(m: [[f64; N]; COLUMNS]) -> [f64; ALL] {
    let mut all = [0.0; ALL];
    all.iter_mut().zip(m.as_flattened()).for_each(|(to, from)| *to = *from);
    all
}

/// Forces, moments and wear of the balls of a block, as the kick finds them.
#[derive(Debug, Clone)]
pub(super) struct KickForces {
    /// 1 where the linear traction of the inner, or the outer, contact serves, else 0.
    near: [Lane; 2],
    /// 1 where friction was made for those contacts that have load, else 0.
    of_loaded: Lane,
    /// Force and moment on the ball by the inner, then the outer contact.
    forces: [[Lane; 6]; 2],
    /// Wear integrals.
    pub wear: [Lane; 2],
    /// Drag (N) and churning (N m).
    fluid: [Lane; 4],
    /// How far the ball is pressed into the wall of its pocket, m.
    pub depth: Lane,
    /// Force, friction and its moment by the pocket: of those balls alone that touch it.
    pocket: [Lane; 6],
}

impl KickForces {
    pub const NONE: Self = Self {
        near: [Lane::ZERO; 2],
        of_loaded: Lane::ZERO,
        forces: [[Lane::ZERO; 6]; 2],
        wear: [Lane::ZERO; 2],
        fluid: [Lane::ZERO; 4],
        depth: Lane::ZERO,
        pocket: [Lane::ZERO; 6],
    };

    pub fn is_near(&self, side: Side, k: usize) -> bool {
        self.near[side as usize].0[k] > 0.0
    }

    pub fn friction_is_of_loaded(&self, k: usize) -> bool {
        self.of_loaded.0[k] > 0.0
    }

    #[inline(always)]
    pub fn forces(&self, side: Side, k: usize) -> ContactForces {
        let [a, b, c, d, e, f] = get(&self.forces[side as usize], k);
        ContactForces { force: [a, b, c], moment: [d, e, f] }
    }

    /// Drag (N) and churning (N m) of a ball.
    #[inline(always)]
    pub fn fluid(&self, k: usize) -> (f64, [f64; 3]) {
        let [drag, x, y, z] = get(&self.fluid, k);
        (drag, [x, y, z])
    }

    #[inline(always)]
    fn pocket(&self, k: usize) -> PocketLoad {
        let [force, axial, radial, moment @ ..] = get(&self.pocket, k);
        PocketLoad { force, friction: [axial, radial], moment, ..PocketLoad::none() }
    }

    pub fn set_pocket(&mut self, lanes: Range<usize>, of: &PocketLoad) {
        let ([axial, radial], [a, r, t]) = (of.friction, of.moment);
        lanes.for_each(|k| put(&mut self.pocket, k, [of.force, axial, radial, a, r, t]));
    }

    /// Adds a moment on a ball by a contact.
    pub fn add_moment(&mut self, side: Side, lanes: Range<usize>, moment: [f64; 3]) {
        lanes.for_each(|k| (0..3).for_each(|i| self.forces[side as usize][3 + i].0[k] += moment[i]));
    }

    pub fn set_forces(&mut self, side: Side, lanes: Range<usize>, of: &ContactForces) {
        let ([a, b, c], [d, e, f]) = (of.force, of.moment);
        lanes.for_each(|k| put(&mut self.forces[side as usize], k, [a, b, c, d, e, f]));
    }
}

/// How a ball slides on a race, its traction by the linear form, none where there is no load, and 1 where the form is
/// near, else 0: within `share` of its reach.
#[inline(always)]
pub(super) fn slide<E: Equations>(
    equations: &E,
    side: Side,
    (ring, state): (&RingState, &BallState),
    (pressed, form, k): (&Pressed, &[Lane; LINEAR], usize),
    share: f64,
) -> (Sliding, PatchTraction, f64) {
    let ball_radius = equations.machine().bearing.geometry.ball_radius();
    let contact = pressed.contact(side, k);
    let sliding = equations.sliding(side, &contact, state, (ring, pressed.orbit_radius(k)));
    let linear = LinearTraction::from_numbers(|i| form[i].0[k]);
    let (rolls, at) = ((&sliding.motion, sliding.rolling_speed), (pressed.bare(side, k), share));
    let (change, near) = linear.reaches(rolls, contact.load, at, ball_radius);
    // A contact without load has no traction, and no linear form that could fail. A factor, since the compiler would
    // branch for a choice.
    let loaded = contact.load > 0.0;
    let traction = linear.traction(&sliding.motion, &change).times(if loaded { 1.0 } else { 0.0 });
    (sliding, traction, if loaded & !near { 0.0 } else { 1.0 })
}

/// Force and moment on a ball by one contact, the wear integral, and 1 where its linear form is near, else 0.
#[inline(always)]
fn contact<E: Equations>(
    equations: &E,
    side: Side,
    at: (&RingState, &BallState),
    form: (&Pressed, &[Lane; LINEAR], usize),
) -> ([f64; 6], f64, f64) {
    let (sliding, traction, near) = slide(equations, side, at, form, 1.0);
    let ContactForces { force: [a, b, c], moment: [d, e, f] } = sliding.on_ball(&traction);
    ([a, b, c, d, e, f], traction.wear_integral, near)
}

/// Tractions of the balls of a block from their linear forms, and whether those serve in step `now`; and whether their
/// friction was made for those contacts that have load.
#[inline(always)]
pub(super) fn tractions<E: Equations, const TILTS: bool>(
    equations: &E,
    (frame, now): (&Frame, f64),
    (balls, pressed, forms): (&[Lane; BALL], &Pressed, &Forms),
    kick_forces: &mut KickForces,
) {
    // No ring that tilts, or no vector instructions.
    let (out, rings) = (kick_forces, frame.rings.map(|ring| if TILTS { ring } else { ring.held() }));
    out.pocket = [Lane::ZERO; 6];
    for k in pressed.in_use.lanes() {
        let state = pressed.state(equations, balls, k);
        let as_made = |side: Side| (pressed.load(side, k) > 0.0) == (forms.loaded[side as usize].0[k] > 0.0);
        out.of_loaded.0[k] = if as_made(Side::Inner) & as_made(Side::Outer) { 1.0 } else { 0.0 };
        let (forces, wear, near) =
            contact(equations, Side::Inner, (&rings.inner, &state), (pressed, &forms.traction[0], k));
        put(&mut out.forces[0], k, forces);
        (out.wear[0].0[k], out.near[0].0[k]) = (wear, if now > forms.last[0].0[k] { 0.0 } else { near });
        let (forces, wear, near) =
            contact(equations, Side::Outer, (&rings.outer, &state), (pressed, &forms.traction[1], k));
        put(&mut out.forces[1], k, forces);
        (out.wear[1].0[k], out.near[1].0[k]) = (wear, if now > forms.last[1].0[k] { 0.0 } else { near });
    }
}

/// The fluid's drag on the balls of a block and its churning.
#[inline(always)]
pub(super) fn surroundings<E: Equations>(
    equations: &E,
    frame: &Frame,
    (balls, pressed): (&[Lane; BALL], &Pressed),
    kick_forces: &mut KickForces,
) {
    let (mut out, machine, inner_speed) = ([Lane::ZERO; 4], equations.machine(), frame.rings.inner.speed);
    // What there is of the fluid is asked outside of the loops, which would else not become vector instructions.
    if let Some(fluid) = machine.bearing.fluid {
        for k in pressed.in_use.lanes() {
            let state = pressed.state(equations, balls, k);
            out[0].0[k] = fluid.drag_on(&state, pressed.orbit_radius(k), inner_speed);
        }
        if let Some(churning) = fluid.churning {
            for k in pressed.in_use.lanes() {
                let state = pressed.state(equations, balls, k);
                let [x, y, z] = churning.moment_vector(state.angular_velocity);
                (out[1].0[k], out[2].0[k], out[3].0[k]) = (x, y, z);
            }
        }
    }
    kick_forces.fluid = out;
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
fn inertial(axes: AzimuthFrame, [a, r, t, outer_a, outer_r, outer_t]: [f64; 6]) -> [f64; 6] {
    let [x, y, z] = axes.to_inertial([a, r, t]);
    let [outer_x, outer_y, outer_z] = axes.to_inertial([outer_a, outer_r, outer_t]);
    [x, y, z, outer_x, outer_y, outer_z]
}

/// Velocities of the balls of a block with their changes.
#[inline(always)]
fn add_velocities(balls: &mut [Lane; BALL], changes: &[Lane; 6]) {
    for (lane, change) in balls[VELOCITY..].iter_mut().zip(changes) {
        lane.0.iter_mut().zip(change.0).for_each(|(v, change)| *v += change);
    }
}

/// Changes of the velocities of a ball in a step of `h` by all accelerations of the friction part and by those given
/// back.
#[inline(always)]
fn push<E: Equations>(
    equations: &E,
    (b, given_back, h): (&[f64; BALL], [f64; 3], f64),
    (pressed, kick_forces, k): (&Pressed, &KickForces, usize),
) -> [f64; 6] {
    let (state, r) = (pressed.state_of(equations, b, k), pressed.orbit_radius(k));
    let traction = Races { inner: kick_forces.forces(Side::Inner, k), outer: kick_forces.forces(Side::Outer, k) };
    let friction = equations.friction(&traction, kick_forces.fluid(k), kick_forces.pocket(k), r);
    let a = equations.friction_acceleration(&state, &friction, r);
    let [axial, radial, orbital] = given_back;
    [(a[0] + axial) * h, (a[1] + radial) * h, (a[2] + orbital) * h, a[3] * h, a[4] * h, a[5] * h]
}

/// By how much mean velocities are beyond the middle of their change, mean forces of the inner and the outer contact on
/// the ball (a, r, t), N, and forces on the rings.
type Found<'a> = (&'a mut [Lane; 6], &'a mut [Lane; 6], &'a mut [Lane; 6]);

/// Every ball by itself with the rings held over a step of `h`, by how much its mean velocity is `beyond` the middle of
/// its change, the mean forces of its contacts, and the force on the rings, inertial axes.
#[inline(always)]
pub(super) fn respond<E: Equations>(
    equations: &E,
    balls: &mut [Lane; BALL],
    (pressed, forms, kick_forces): (&Pressed, &Forms, &KickForces),
    (given_back, h): (&[Lane; 3], f64),
    (beyond, mean_forces, reaction): Found<'_>,
) {
    let (mut changes, mut on_rings) = ([Lane::ZERO; 6], [Lane::ZERO; 6]);
    let now = &*balls;
    for k in pressed.in_use.lanes() {
        let push = push(equations, (&get(now, k), get(given_back, k), h), (pressed, kick_forces, k));
        let (change, mean) = (times(&forms.response[0], push, k), times(&forms.response[1], push, k));
        let (i, o) = (get(&kick_forces.forces[0], k), get(&kick_forces.forces[1], k));
        let back = transposed(&forms.coupling, mean, k);
        let force = [back[0] - i[0], back[1] - i[1], back[2] - i[2], back[3] - o[0], back[4] - o[1], back[5] - o[2]];
        put(&mut changes, k, change);
        (0..6).for_each(|i| beyond[i].0[k] = mean[i] - 0.5 * change[i]);
        (0..6).for_each(|i| mean_forces[i].0[k] = -force[i]);
        put(&mut on_rings, k, inertial(pressed.axes(k), force));
    }
    add_velocities(balls, &changes);
    *reaction = on_rings;
}

/// The balls follow the motion of the rings, and push on them, both in inertial axes. Where `TILTS`, rings tilt too,
/// and `moved` has how they move at each ball (a, r, t).
#[inline(always)]
pub(super) fn follow<const TILTS: bool>(
    balls: &mut [Lane; BALL],
    (rings, moved): ([f64; 5], &[Lane; 6]),
    (pressed, forms): (&Pressed, &Forms),
    (beyond, mean_forces, reaction): Found<'_>,
) {
    let (mut changes, mut on_rings) = ([Lane::ZERO; 6], [Lane::ZERO; 6]);
    for k in pressed.in_use.lanes() {
        let axes = pressed.axes(k);
        let [a, r, t] = axes.from_inertial([rings[0], rings[1], rings[2]]);
        let [_, outer_r, outer_t] = axes.from_inertial([rings[3], rings[4], 0.0]);
        let rings = if TILTS { get(moved, k) } else { [a, r, t, 0.0, outer_r, outer_t] };
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
        (0..6).for_each(|i| beyond[i].0[k] += mean[i] - 0.5 * change[i]);
        (0..6).for_each(|i| mean_forces[i].0[k] -= force[i]);
        put(&mut on_rings, k, inertial(axes, force));
    }
    add_velocities(balls, &changes);
    *reaction = on_rings;
}
