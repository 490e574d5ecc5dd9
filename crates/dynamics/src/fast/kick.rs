//! The kick: friction at fixed position, linearly implicit.

use super::Fast;
use super::cage::Halfway;
use super::depths::depths;
use super::friction::{in_inertial_axes, inverse_with_held, linear_friction, stiffnesses};
use super::kick_forces::{Forms, KickForces, follow, respond, surroundings, tractions};
use super::lanes::{Lane, WIDTH, blocks, filled, get, lanes_of};
use super::scratch::Scratch;
use crate::equations::{Equations, Frame};
use crate::layout::Layout;
use crate::linear::Contacts;
use crate::machine::Machine;
use crate::watch::Watch;
use fearless_simd::dispatch;
use nalgebra::{Matrix5, Vector5};
use tribodyn_bearing::{Races, Side, Wrench};

/// Steps between new matrices of the rings: they only predict, and turn with the balls by some ten degrees. Where balls
/// strike, loads change several times over within so many steps, and a new one is made in each.
const RINGS_EVERY: usize = 16;
/// Most steps that a linear traction serves: its reach bounds all that it depends on, and this what a reach misses.
const LONGEST_LINEAR: u64 = 512;

impl Fast {
    /// Every ball by itself with the rings held, then the rings with what the balls leave, then the balls again by what
    /// the rings moved. The rings receive to the last digit what the balls give.
    pub(super) fn kick<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let l = equations.machine().layout;
        let frame = equations.machine().frame(t, y);
        self.make_room(l);
        let halfway = self.halfway(equations.machine_mut(), &frame, h);
        let renew = self.is_other_step(h);
        if renew {
            self.step = h;
        }
        self.follow_drift(equations.machine(), h);
        let mut on_rings = self.ring_common(equations.machine());
        self.find_depths(equations.machine_mut(), &frame, h);
        let (mut on_cage, mut reaction) = ((0.0, Wrench::default()), [Lane::ZERO; 6]);
        for block in 0..blocks(l.balls) {
            self.find_forces(equations, block, (&frame, halfway.as_ref(), renew), &mut on_cage);
            let scratch = &mut self.scratch;
            let balls = &mut scratch.balls[block];
            let found = (&mut scratch.beyond[block], &mut scratch.mean_forces[block], &mut reaction);
            let at = (&scratch.pressed[block], &scratch.forms[block], &scratch.kick_forces[block]);
            let (equations, given) = (&*equations, (&scratch.given_back[block], h));
            dispatch!(scratch.level, _simd => respond(equations, balls, at, given, found));
            (0..filled(l, block)).for_each(|k| on_rings += of_translations(&reaction, k));
        }
        let machine = equations.machine();
        if renew || self.rings_last == 0 || machine.is_damaged() {
            self.rings = self.ring_matrix(machine, h);
            self.rings_last = RINGS_EVERY;
        }
        self.rings_last -= 1;
        let predicted: [f64; 5] = (self.rings * on_rings * h).into();
        let moved = l.any_tilts().then(|| self.moved_by_tilting(machine, &frame, &on_rings, h));
        let scratch = &mut self.scratch;
        for block in 0..blocks(l.balls) {
            let balls = &mut scratch.balls[block];
            let found = (&mut scratch.beyond[block], &mut scratch.mean_forces[block], &mut reaction);
            let at = (&scratch.pressed[block], &scratch.forms[block]);
            match &moved {
                Some(moved) => follow::<true>(balls, (predicted, &moved[block]), at, found),
                None => {
                    dispatch!(scratch.level, _simd => follow::<false>(balls, (predicted, &[Lane::ZERO; 6]), at, found))
                }
            }
            (0..filled(l, block)).for_each(|k| on_rings += of_translations(&reaction, k));
        }
        let lands = machine.kick_free_cage(y, (&frame, &on_cage.1), h);
        self.kick_tilts(machine, y, (&frame, &lands.on_rings), h);
        let ([x, y_, z], [outer_x, outer_y, _]) = (lands.force.inner, lands.force.outer);
        on_rings -= Vector5::new(x, y_, z, outer_x, outer_y);
        push_bodies(machine, y, (&on_rings, on_cage.0), h);
    }

    /// Memory for the balls; the linear forms by lanes follow from those by balls.
    fn make_room(&mut self, l: Layout) {
        let balls = l.balls;
        if self.friction.len() != balls {
            self.friction.resize_with(balls, super::friction::LinearFriction::NONE);
            self.contacts.resize(balls, Contacts::default());
            self.scratch.forms.clear();
        }
        if self.scratch.forms.is_empty() {
            self.scratch.forms.resize(blocks(balls), Forms::NONE);
            self.scratch.kick_forces.resize(blocks(balls), KickForces::NONE);
            self.scratch.mean_forces.resize(blocks(balls), [Lane::ZERO; 6]);
            for ball in 0..balls {
                let (block, lanes) = (ball / WIDTH, lanes_of(l, ball / WIDTH, ball % WIDTH));
                self.scratch.forms[block].set_tractions(lanes.clone(), &self.contacts[ball], [true; 2]);
                self.scratch.forms[block].set_friction(lanes, &self.friction[ball]);
            }
        }
    }

    /// How deep balls are in the walls of their pockets, and how soft those are for it.
    fn find_depths(&mut self, machine: &mut Machine, frame: &Frame, h: f64) {
        let Scratch { level, balls, pressed, places, kick_forces, .. } = &mut self.scratch;
        let mut touching = 0;
        for (block, (balls, pressed)) in balls.iter().zip(pressed.iter()).enumerate() {
            let (at, of_all) = ((frame, &places[block]), &*machine);
            let depth = dispatch!(*level, _simd => depths(of_all, at, (balls, pressed)));
            touching += (0..filled(machine.layout, block)).filter(|&k| depth.0[k] > 0.0).count();
            kick_forces[block].depth = depth;
        }
        machine.fit_pockets(touching, h);
    }

    /// Tractions of the balls of a block from their linear forms where those still hold, else integrated and linearised
    /// anew, and what fluid and pockets do. Adds torque, force and moment on the cage.
    fn find_forces<E: Equations>(
        &mut self,
        equations: &mut E,
        block: usize,
        (frame, halfway, renew): (&Frame, Option<&Halfway>, bool),
        on_cage: &mut (f64, Wrench),
    ) {
        let machine = equations.machine();
        let (balls, first) = (filled(machine.layout, block), WIDTH * block);
        let scratch = &mut self.scratch;
        let at = (&scratch.balls[block], &scratch.pressed[block], &scratch.forms[block]);
        let (equations_now, kick_forces, now) = (&*equations, &mut scratch.kick_forces[block], self.steps as f64);
        if equations_now.machine().layout.any_tilts() {
            tractions::<E, true>(equations_now, (frame, now), at, kick_forces);
        } else {
            dispatch!(scratch.level, _simd => tractions::<E, false>(equations_now, (frame, now), at, kick_forces));
        }
        dispatch!(scratch.level, _simd => surroundings(equations_now, frame, (at.0, at.1), kick_forces));
        self.used += 2 * balls as u64;
        // Oil in a pocket acts on a ball wherever it is.
        let oiled = equations.machine().cage.pocket.film.is_some();
        for k in 0..balls {
            let kick_forces = &self.scratch.kick_forces[block];
            let old =
                Races { inner: !kick_forces.is_near(Side::Inner, k), outer: !kick_forces.is_near(Side::Outer, k) };
            let touches = oiled || kick_forces.depth.0[k] > 0.0;
            let renew_friction = renew || !kick_forces.friction_is_of_loaded(k);
            if old.inner || old.outer || renew_friction {
                self.refresh(equations, (first + k, frame), old.map(|old| old || renew), renew_friction);
            }
            self.press_on_marked(equations.machine(), (block, k));
            let mut pocket_wear = 0.0;
            if touches {
                let machine = equations.machine();
                let pocket = match halfway {
                    Some(there) => machine.pocket_load(first + k, &there.balls[first + k], &there.frame),
                    None => machine.pocket_kick((first + k, &get(&self.scratch.balls[block], k)), frame, self.step),
                };
                self.scratch.kick_forces[block].set_pocket(lanes_of(machine.layout, block, k), &pocket);
                pocket_wear = machine.pocket_wear(&pocket);
                on_cage.0 += pocket.cage_torque;
                machine.react_on_cage(frame, (&pocket, &get(&self.scratch.balls[block], k)), &mut on_cage.1);
            }
            let Scratch { pressed, forms, kick_forces, .. } = &self.scratch;
            let (pressed, forms, kick_forces) = (&pressed[block], &forms[block], &kick_forces[block]);
            let machine = equations.machine_mut();
            let loaded = Races::from_fn(|side| pressed.load(side, k) > 0.0);
            machine.watch[first + k] = Watch {
                wear: Races::from_fn(|side| machine.bearing.wear_rate(side, kick_forces.wear[side as usize].0[k])),
                pocket_wear,
                semi_lateral: Races::from_fn(|side| if loaded[side] { forms.semi_lateral(side, k) } else { 0.0 }),
                loaded,
            };
        }
    }

    /// Makes the linear traction of those contacts of a ball anew whose own is `old`, from a form in the table or from
    /// the integral over the patch, and its friction where that does not serve any more, or where `renew`.
    fn refresh<E: Equations>(&mut self, equations: &E, (index, frame): (usize, &Frame), old: Races<bool>, renew: bool) {
        let machine = equations.machine();
        let bearing = &machine.bearing;
        let (block, k) = (index / WIDTH, index % WIDTH);
        let pressed = &self.scratch.pressed[block];
        let state = &pressed.state(equations, &self.scratch.balls[block], k);
        let (normal, kick_forces, lanes) =
            (pressed.normal(k), &mut self.scratch.kick_forces[block], lanes_of(machine.layout, block, k));
        let contacts = &mut self.contacts[index];
        for (side, contact) in normal.contacts.iter().filter(|(side, _)| old[*side]) {
            contacts.last[side as usize] = self.steps + LONGEST_LINEAR;
            if contact.load <= 0.0 {
                continue;
            }
            let sliding = equations.sliding(side, contact, state, (&frame.rings[side], normal.orbit_radius));
            let ellipse = bearing.ellipse(side, contact);
            let patch = bearing.loaded_patch(side, contact, &ellipse, &sliding, pressed.bare(side, k));
            let form = &mut contacts.of[side as usize];
            let list = (side, self.scratch.level, &mut self.scratch.table[side as usize]);
            let (traction, integrated) = self.table.traction(list, form, (machine, &patch, self.linear_error));
            self.refreshed += u64::from(integrated);
            kick_forces.set_forces(side, lanes.clone(), &sliding.on_ball(&traction));
            kick_forces.wear[side as usize].0[k] = traction.wear_integral;
        }
        let (friction, forms) = (&mut self.friction[index], &mut self.scratch.forms[block]);
        forms.set_tractions(lanes.clone(), contacts, [old.inner, old.outer]);
        let stiffness = stiffnesses(machine, state, &normal, (&contacts.of, self.step));
        if renew || !friction.serves(&stiffness, self.step) {
            *friction = linear_friction(machine, state, &normal, (&contacts.of, stiffness), self.step);
            forms.set_friction(lanes, friction);
        }
    }

    /// Moments of the normal forces on a ball that is not round.
    fn press_on_marked(&mut self, machine: &Machine, (block, k): (usize, usize)) {
        if machine.layout.marked == 0 || machine.ball_surfaces.slot(WIDTH * block + k).is_none() {
            return;
        }
        let Scratch { pressed, kick_forces, .. } = &mut self.scratch;
        for side in Side::BOTH {
            let force = pressed[block].contact(side, k).force;
            let moment = pressed[block].turn(side, k).map(|turn| force * turn);
            kick_forces[block].add_moment(side, lanes_of(machine.layout, block, k), moment);
        }
    }

    fn ring_matrix(&self, machine: &Machine, h: f64) -> Matrix5<f64> {
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        let mut sum = Matrix5::from_diagonal(&Vector5::new(inner, inner, inner, outer, outer));
        for (index, f) in self.friction.iter().enumerate() {
            let axes = self.scratch.pressed[index / WIDTH].axes(index % WIDTH);
            let force = f.force_on_rings();
            // By the rings' velocities along x, y and z, which is the axial direction; then the forces are turned.
            let [x, y] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|unit| axes.from_inertial(unit));
            let turned = |first: usize, [_, radial, along]: [f64; 3]| {
                force.column(first + 1) * radial + force.column(first + 2) * along
            };
            let columns = [turned(0, x), turned(0, y), force.column(0).into(), turned(3, x), turned(3, y)];
            for (k, column) in columns.iter().enumerate() {
                let mut slot = sum.column_mut(k);
                slot -= in_inertial_axes(axes, &(column * h));
            }
        }
        let free = machine.inner.free.iter().chain(&machine.outer.free);
        for (k, _) in free.enumerate().filter(|(_, free)| !**free) {
            sum[(k, k)] = f64::INFINITY;
        }
        inverse_with_held(sum)
    }

    /// The common force on the rings that the kick gives back, N.
    fn ring_common(&self, machine: &Machine) -> Vector5<f64> {
        let l = machine.layout;
        let (i, o) = (&self.given_back[l.inner() + 3..], &self.given_back[l.outer() + 2..]);
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        Vector5::new(inner * i[0], inner * i[1], inner * i[2], outer * o[0], outer * o[1])
    }
}

/// Force of a ball on the freedoms of the rings, x, y, z and x, y, N.
fn of_translations(reaction: &[Lane; 6], k: usize) -> Vector5<f64> {
    let [x, y, z, outer_x, outer_y, _] = get(reaction, k);
    Vector5::new(x, y, z, outer_x, outer_y)
}

/// Velocities of rings and cage after `h` under the balls' forces and their torque on the cage.
fn push_bodies(machine: &Machine, y: &mut [f64], (on_rings, cage_torque): (&Vector5<f64>, f64), h: f64) {
    let l = machine.layout;
    let [inner, outer] = [h / machine.inner.mass, h / machine.outer.mass];
    for k in (0..3).filter(|&k| machine.inner.free[k]) {
        y[l.inner() + 3 + k] += inner * on_rings[k];
    }
    for k in (0..2).filter(|&k| machine.outer.free[k]) {
        y[l.outer() + 2 + k] += outer * on_rings[3 + k];
    }
    if machine.free_cage.is_none() {
        y[l.cage() + 1] += h * cage_torque / machine.cage.inertia;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::{Started, start};
    use tribodyn_case::{Case, set_value};

    /// Balls that leave the load do not grip the race any more. They went on to for up to 512 steps.
    #[test]
    fn limit_balls_without_load_grip_no_race() {
        let changes = [("ring.x", "Force(kN(6))"), ("ring.z", "Force(kN(2))")];
        let text = include_str!("../../../../fixtures/cases/angular-7210.ron").to_owned();
        let text = changes.iter().fold(text, |t, (path, value)| set_value(&t, path, value).unwrap());
        let case = Case::from_ron(&text).unwrap();
        let Started { mut machine, mut state, .. } = start(case.run_inputs().unwrap(), None).unwrap();
        let (mut scheme, h, mut lost) = (Fast::default(), 2e-5, 0);
        let mut before = vec![Races { inner: true, outer: true }; machine.layout.balls];
        for step in 0..1000 {
            scheme.step(&mut machine, h * f64::from(step), &mut state, h);
            for (ball, (friction, before)) in scheme.friction.iter().zip(&mut before).enumerate() {
                for side in Side::BOTH {
                    let loaded = scheme.scratch.pressed[ball / WIDTH].load(side, ball % WIDTH) > 0.0;
                    let own = 3 * side as usize;
                    let grips = friction.coupling.fixed_view::<6, 3>(0, own).norm() > 0.0;
                    assert_eq!(grips, loaded, "ball {ball}, {side:?}, step {step}");
                    lost += usize::from(before[side] && !loaded);
                    before[side] = loaded;
                }
            }
        }
        assert!(lost > 3, "balls lost their load {lost} times");
    }
}
