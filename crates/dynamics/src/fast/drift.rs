//! The drift: motion under contact springs, supports, loads and the centrifugal force.

use super::lanes::{InUse, Lane, WIDTH, ball_in, filled, get, lanes_of, put, sin_cos};
use crate::equations::{Equations, Frame};
use crate::forces::Sums;
use crate::layout::{AXIAL, AZIMUTH, BALL, RADIUS};
use crate::machine::Machine;
use fearless_simd::{Level, dispatch};
use tribodyn_bearing::{
    AzimuthFrame, BallSize, BallState, ContactPose, ContactSprings, Lean, NormalContact, NormalLoads, Races,
    RingOffset, Side,
};
use tribodyn_wear::LocalSurface;

/// The balls of a block at the position that the drift evaluated last: the kick at the same position needs it again.
#[derive(Debug, Clone)]
pub(super) struct Pressed {
    pub in_use: InUse,
    /// Depth, slope and bare part of the surfaces.
    surfaces: [[Lane; 3]; 2],
    /// Derivatives of the depths by rotations of balls with spalls.
    turns: [[Lane; 3]; 2],
    /// Sizes of the balls.
    sizes: [Lane; 3],
    found: Found,
}

/// Numbers of a normal contact, and which of them is the load.
const CONTACT: usize = 12;
const LOAD: usize = 8;

/// Contacts, accelerations and normal forces by the springs there.
#[derive(Debug, Clone)]
struct Found {
    /// sin φ, cos φ.
    axes: [Lane; 2],
    position: [Lane; 2],
    orbit_radius: Lane,
    contacts: [[Lane; CONTACT]; 2],
    /// Of axial and radial velocity and orbital speed.
    acceleration: [Lane; 3],
    /// Normal forces on the balls' side of the contacts (x, y, z), N.
    on_rings: [[Lane; 3]; 2],
}

impl Found {
    const NONE: Self = Self {
        axes: [Lane::ZERO; 2],
        position: [Lane::ZERO; 2],
        orbit_radius: Lane::ZERO,
        contacts: [[Lane::ZERO; CONTACT]; 2],
        acceleration: [Lane::ZERO; 3],
        on_rings: [[Lane::ZERO; 3]; 2],
    };
}

impl Pressed {
    pub const NONE: Self = Self {
        in_use: InUse::NONE,
        surfaces: [[Lane::ZERO; 3]; 2],
        turns: [[Lane::ZERO; 3]; 2],
        sizes: [Lane::ZERO, Lane::all(1.0), Lane::all(1.0)],
        found: Found::NONE,
    };

    /// State of a ball of a block with the unknowns `balls`.
    #[inline(always)]
    pub fn state<E: Equations>(&self, equations: &E, balls: &[Lane; BALL], k: usize) -> BallState {
        self.state_of(equations, &get(balls, k), k)
    }

    /// The same from the unknowns `b` of the ball.
    #[inline(always)]
    pub fn state_of<E: Equations>(&self, equations: &E, b: &[f64; BALL], k: usize) -> BallState {
        equations.state_at((self.axes(k), size(&self.sizes, k)), self.position(k), b)
    }

    #[inline(always)]
    pub fn axes(&self, k: usize) -> AzimuthFrame {
        let [sin, cos] = get(&self.found.axes, k);
        AzimuthFrame { sin, cos }
    }

    #[inline(always)]
    pub fn position(&self, k: usize) -> [f64; 2] {
        get(&self.found.position, k)
    }

    #[inline(always)]
    pub fn orbit_radius(&self, k: usize) -> f64 {
        self.found.orbit_radius.0[k]
    }

    #[inline(always)]
    pub fn surface(&self, side: Side, k: usize) -> LocalSurface {
        let [depth, slope, bare] = get(&self.surfaces[side as usize], k);
        LocalSurface { depth, slope, bare, ..LocalSurface::NEW }
    }

    /// Derivative of the depth by a rotation of the ball, m/rad.
    pub fn turn(&self, side: Side, k: usize) -> [f64; 3] {
        get(&self.turns[side as usize], k)
    }

    #[inline(always)]
    pub fn bare(&self, side: Side, k: usize) -> f64 {
        self.surfaces[side as usize][2].0[k]
    }

    /// Axial and radial acceleration, m/s².
    #[inline(always)]
    pub fn acceleration_in_plane(&self, k: usize) -> [f64; 2] {
        [self.found.acceleration[0].0[k], self.found.acceleration[1].0[k]]
    }

    /// Mass of a ball over the nominal one.
    #[inline(always)]
    pub fn relative_mass(&self, k: usize) -> f64 {
        self.sizes[1].0[k]
    }

    pub fn acceleration(&self) -> &[Lane; 3] {
        &self.found.acceleration
    }

    pub fn set_acceleration(&mut self, acceleration: [Lane; 3]) {
        self.found.acceleration = acceleration;
    }

    /// Normal load, N.
    pub fn load(&self, side: Side, k: usize) -> f64 {
        self.found.contacts[side as usize][LOAD].0[k]
    }

    #[inline(always)]
    pub fn contact(&self, side: Side, k: usize) -> NormalContact {
        let [
            sin,
            cos,
            approach,
            lean_sin,
            lean_cos,
            curvature,
            farther,
            climb,
            load,
            force,
            closing_speed,
            slope_moment,
        ] = get(&self.found.contacts[side as usize], k);
        let lean = Lean { sin: lean_sin, cos: lean_cos, curvature, farther, climb };
        NormalContact { pose: ContactPose { sin, cos, approach }, lean, load, force, closing_speed, slope_moment }
    }

    pub fn normal(&self, k: usize) -> NormalLoads {
        let contacts = Races::from_fn(|side| self.contact(side, k));
        NormalLoads { contacts, orbit_radius: self.orbit_radius(k) }
    }
}

#[inline(always)]
fn size(sizes: &[Lane; 3], k: usize) -> BallSize {
    let [excess, mass, inertia] = get(sizes, k);
    BallSize { excess, mass, inertia }
}

#[inline(always)]
fn numbers(c: &NormalContact) -> [f64; CONTACT] {
    let (pose, lean) = (&c.pose, &c.lean);
    #[rustfmt::skip]
    let numbers = [
        pose.sin, pose.cos, pose.approach, lean.sin, lean.cos, lean.curvature, lean.farther, lean.climb,
        c.load, c.force, c.closing_speed, c.slope_moment,
    ];
    numbers
}

/// The balls of a block under their springs by `model`; `groove` is the radius of the outer groove centres.
#[inline(always)]
fn springs<E: Equations>(
    equations: &E,
    frame: &Frame,
    (balls, surfaces, sizes): (&[Lane; BALL], &[[Lane; 3]; 2], &[Lane; 3]),
    (model, groove): (ContactSprings, f64),
    found: (&mut Found, InUse),
) {
    let (frame, model) = (frame.held(), model.with_exact_offset());
    match model.undamped() {
        Some(model) => each_by_springs(equations, &frame, (balls, surfaces, sizes), (model, groove), found),
        None => each_by_springs(equations, &frame, (balls, surfaces, sizes), (model, groove), found),
    }
}

/// The loop of [`springs`].
#[inline(always)]
fn each_by_springs<E: Equations>(
    equations: &E,
    frame: &Frame,
    (balls, surfaces, sizes): (&[Lane; BALL], &[[Lane; 3]; 2], &[Lane; 3]),
    (model, groove): (ContactSprings, f64),
    (found, in_use): (&mut Found, InUse),
) {
    // Copies, which what is found cannot overlap: with more to be checked the compiler makes no vector instructions.
    let (balls, surfaces, sizes) = (&balls.clone(), &surfaces.clone(), &sizes.clone());
    for k in in_use.lanes() {
        let b = get(balls, k);
        let (sin, cos) = sin_cos(b[AZIMUTH]);
        let axes = AzimuthFrame { sin, cos };
        let position = Machine::position(axes, [b[AXIAL], b[RADIUS]], frame, groove);
        let state = equations.state_at((axes, size(sizes, k)), position, &b);
        let ([d_i, s_i, b_i], [d_o, s_o, b_o]) = (get(&surfaces[0], k), get(&surfaces[1], k));
        let inner = LocalSurface { depth: d_i, slope: s_i, bare: b_i, ..LocalSurface::NEW };
        let outer = LocalSurface { depth: d_o, slope: s_o, bare: b_o, ..LocalSurface::NEW };
        let rings = Races { inner: &frame.rings.inner, outer: &frame.rings.outer };
        let springs = equations.springs(model.normal_loads(&state, rings, Races { inner: &inner, outer: &outer }));
        put(&mut found.axes, k, [sin, cos]);
        put(&mut found.position, k, position);
        let r = springs.normal.orbit_radius;
        found.orbit_radius.0[k] = r;
        put(&mut found.acceleration, k, model.acceleration(springs.force, r, &state));
        let Races { inner, outer } = &springs.normal.contacts;
        put(&mut found.contacts[0], k, numbers(inner));
        put(&mut found.contacts[1], k, numbers(outer));
        let [a, r, t] = inner.on_ring(Side::Inner, model.ring_offset());
        put(&mut found.on_rings[0], k, axes.to_inertial([-a, -r, -t]));
        let [a, r, t] = outer.on_ring(Side::Outer, model.ring_offset());
        put(&mut found.on_rings[1], k, axes.to_inertial([-a, -r, -t]));
    }
}

/// The same ball by ball, for contact constants that follow the contact angle, rings that tilt and balls with spalls.
fn springs_by_angle<E: Equations>(
    equations: &E,
    (frame, block, balls): (&Frame, usize, &[Lane; BALL]),
    pressed: &mut Pressed,
) {
    let machine = equations.machine();
    let model = machine.bearing.contact_springs();
    let groove = machine.bearing.geometry.groove_centre_radius(Side::Outer);
    for k in 0..filled(machine.layout, block) {
        let b = get(balls, k);
        let (sin, cos) = sin_cos(b[AZIMUTH]);
        let axes = AzimuthFrame { sin, cos };
        let position = Machine::position(axes, [b[AXIAL], b[RADIUS]], frame, groove);
        let state = equations.state_at((axes, size(&pressed.sizes, k)), position, &b);
        let surfaces = Races::from_fn(|side| LocalSurface { turn: pressed.turn(side, k), ..pressed.surface(side, k) });
        let springs = equations.springs(machine.normal_loads(&state, &surfaces, frame));
        let acceleration = equations.spring_acceleration(&springs, &state);
        let found = &mut pressed.found;
        for lane in lanes_of(machine.layout, block, k) {
            put(&mut found.axes, lane, [sin, cos]);
            put(&mut found.position, lane, position);
            found.orbit_radius.0[lane] = springs.normal.orbit_radius;
            put(&mut found.acceleration, lane, acceleration);
            for (side, contact) in springs.normal.contacts.iter() {
                put(&mut found.contacts[side as usize], lane, numbers(contact));
                let [a, r, t] = contact.on_ring(side, model.ring_offset());
                put(&mut found.on_rings[side as usize], lane, axes.to_inertial([-a, -r, -t]));
            }
        }
    }
}

/// Accelerations of balls, rings and cage by the spring part, supports and loads; of the orbital speed, the rate of the
/// angular momentum over m r². The centrifugal force is here and not in the glide so that dampers see the velocity of
/// the middle of a step and not half a step of it. Those of the balls are in `stands`, the others in `a`.
pub(super) fn drift_acceleration<E: Equations>(
    level: Level,
    equations: &E,
    (t, y): (f64, &[f64]),
    balls: &[[Lane; BALL]],
    (a, pressed): (&mut [f64], &mut [Pressed]),
) {
    let machine = equations.machine();
    let l = machine.layout;
    // All that acts on a free cage is in the kick.
    let frame = machine.frame_of_rings(t, y);
    let mut sums = Sums::default();
    for (block, (balls, out)) in balls.iter().zip(pressed).enumerate() {
        press(level, equations, (&frame, block, balls), out);
        for k in 0..filled(l, block) {
            for side in Side::BOTH {
                let on_ball = get(&out.found.on_rings[side as usize], k);
                (0..3).for_each(|i| sums.on_rings[side][i] -= on_ball[i]);
            }
        }
        if l.any_tilts() {
            moments(equations, (&frame, block, balls), out, &mut sums);
        }
    }
    let bodies = machine.bodies(t, &frame, &sums);
    a[l.cage() + 1] = if l.free_cage { 0.0 } else { bodies.cage };
    a[l.inner() + 3..l.inner() + 6].copy_from_slice(&bodies.inner);
    a[l.outer() + 2..l.outer() + 4].copy_from_slice(&bodies.outer);
    for (side, ring) in frame.rings.iter() {
        let (Some(tilting), Some([.., x, y])) = (&machine.tilting[side], bodies.tilt[side]) else { continue };
        // What turns with the ring is in the kick.
        let [own_x, own_y] = machine.gyroscopic_moment(side, ring);
        let inertia = tilting.body.transverse_inertia;
        a[l.velocities_of_tilt(side)].copy_from_slice(&[x - own_x / inertia, y - own_y / inertia]);
    }
}

/// Adds the moments of the normal forces of rings that tilt on the balls of a block.
fn moments<E: Equations>(
    equations: &E,
    (frame, block, balls): (&Frame, usize, &[Lane; BALL]),
    pressed: &Pressed,
    sums: &mut Sums,
) {
    let machine = equations.machine();
    for k in 0..filled(machine.layout, block) {
        let state = pressed.state(equations, balls, k);
        for (side, ring) in frame.rings.iter().filter(|(side, _)| machine.layout.tilting[*side]) {
            let of_normal = (pressed.contact(side, k).on_ball(side), [0.0; 3]);
            let moment = machine.bearing.moment_about(side, &state, of_normal, (ring, pressed.orbit_radius(k)));
            sums.add_moment(side, state.frame.to_inertial(moment), ring.axis());
        }
    }
}

/// How the balls of a block, by its number, are pressed on their races.
pub(super) fn press<E: Equations>(
    level: Level,
    equations: &E,
    (frame, block, balls): (&Frame, usize, &[Lane; BALL]),
    out: &mut Pressed,
) {
    let machine = equations.machine();
    out.in_use = InUse::of(machine.layout, block);
    surfaces(level, machine, (frame, block, balls), (&mut out.surfaces, &mut out.turns));
    sizes(machine, block, &mut out.sizes);
    let springs_of = machine.bearing.contact_springs();
    let exact = springs_of.ring_offset() == RingOffset::Exact;
    if machine.bearing.modelling.contact_at_actual_angle || machine.layout.one_by_one() || !exact {
        return springs_by_angle(equations, (frame, block, balls), out);
    }
    let model = (springs_of, machine.bearing.geometry.groove_centre_radius(Side::Outer));
    let Pressed { surfaces, sizes, found, in_use, .. } = &mut *out;
    dispatch!(level, _simd => springs(equations, frame, (balls, surfaces, sizes), model, (found, *in_use)));
}

/// The sizes of the balls of a block; equal ones are those of [`Pressed::NONE`].
fn sizes(machine: &Machine, block: usize, out: &mut [Lane; 3]) {
    if machine.bearing.deviations.balls.is_empty() {
        return;
    }
    for k in 0..WIDTH {
        let BallSize { excess, mass, inertia } = machine.bearing.ball_size(ball_in(machine.layout, block, k));
        put(out, k, [excess, mass, inertia]);
    }
}

/// The surfaces under the balls of a block.
fn surfaces(
    level: Level,
    machine: &Machine,
    (frame, block, balls): (&Frame, usize, &[Lane; BALL]),
    (out, turns): (&mut [[Lane; 3]; 2], &mut [[Lane; 3]; 2]),
) {
    if machine.is_even() {
        for (side, new) in machine.new_surfaces().iter() {
            out[side as usize] = [new.depth, new.slope, new.bare].map(Lane::all);
        }
        return;
    }
    let mut seen = [[Lane::ZERO; 2]; 2];
    dispatch!(level, _simd => seen_from_rings(&frame.held(), balls, &mut seen));
    for k in 0..filled(machine.layout, block) {
        for side in Side::BOTH {
            let surface = machine.surface(side, WIDTH * block + k, get(&seen[side as usize], k), frame);
            for lane in lanes_of(machine.layout, block, k) {
                put(&mut out[side as usize], lane, [surface.depth, surface.slope, surface.bare]);
                if machine.layout.marked > 0 {
                    put(&mut turns[side as usize], lane, surface.turn);
                }
            }
        }
    }
}

/// How the balls of a block are [`Machine::seen_from`] the rings.
#[inline(always)]
fn seen_from_rings(frame: &Frame, balls: &[Lane; BALL], seen: &mut [[Lane; 2]; 2]) {
    for k in 0..WIDTH {
        let b = get(balls, k);
        let (sin, cos) = sin_cos(b[AZIMUTH]);
        let axes = AzimuthFrame { sin, cos };
        put(&mut seen[0], k, Machine::seen_from(Side::Inner, axes, &b, frame));
        put(&mut seen[1], k, Machine::seen_from(Side::Outer, axes, &b, frame));
    }
}
