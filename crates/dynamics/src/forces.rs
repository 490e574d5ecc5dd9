//! Sums over the balls: rings and cage, powers and energies at a time and state.

use crate::equations::{BallForces, Equations, Frame};
use crate::layout::{BALL, Layout, VELOCITY};
use crate::machine::Machine;
use crate::watch::Watch;
use tribodyn_bearing::vectors::dot;
use tribodyn_bearing::{AzimuthFrame, FREE_CAGE, NormalContact, PocketLoad, Races, Side, Wrench};

/// Sums over all balls.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Sums {
    /// Force of the balls on the rings (x, y, z), N.
    pub on_rings: Races<[f64; 3]>,
    /// Torque of the rings on the balls, N m.
    pub torque: Races<f64>,
    /// Moment of a ring that is free to tilt on the balls about its centre (x, y, z), N m.
    pub moment: Races<[f64; 3]>,
    /// Torque of the balls on the cage about the bearing's axis, N m.
    pub cage_torque: f64,
    /// Force and moment of the balls on a free cage.
    pub on_cage: Wrench,
    pub powers: BallPowers,
}

/// Powers lost by the balls, W, and the energy they hold, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BallPowers {
    pub friction: Races<f64>,
    pub drag: f64,
    pub churning: f64,
    pub contact_damping: f64,
    pub pocket_friction: f64,
    pub pocket_damping: f64,
    pub energy: f64,
}

/// Accelerations of rings and cage and the powers that belong to them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct BodyForces {
    pub inner: [f64; 3],
    pub outer: [f64; 2],
    pub cage: f64,
    /// Rates of the unknowns of a free cage beside angle and speed.
    pub free_cage: Option<[f64; FREE_CAGE]>,
    /// Rates of tilts and angular velocities of rings that are free to tilt.
    pub tilt: Races<Option<[f64; 4]>>,
    pub fluid_torque: f64,
    /// Torques of the rings' drives, N m.
    pub torque: Races<f64>,
    pub shaft_power: f64,
    pub load_power: f64,
    pub support_loss: f64,
    pub cage_loss: f64,
    /// Of rings, cage and supports, J.
    pub energy: f64,
}

impl Machine {
    /// Adds a force on the balls' side of a contact [a, r, t] to the reaction on a ring.
    #[inline(always)]
    fn react(sums: &mut Sums, side: Side, axes: AzimuthFrame, on_ball: [f64; 3]) {
        let on_ball = axes.to_inertial(on_ball);
        let sum = &mut sums.on_rings[side];
        (sum[0], sum[1], sum[2]) = (sum[0] - on_ball[0], sum[1] - on_ball[1], sum[2] - on_ball[2]);
    }

    /// Adds the forces of a ball on rings and cage, and its powers.
    #[inline(always)]
    pub fn add_ball(&self, b: &BallForces, velocity: [f64; 2], frame: &Frame, sums: &mut Sums) {
        self.add_contact(Side::Inner, b, frame, sums);
        self.add_contact(Side::Outer, b, frame, sums);
        let (s, r) = (&b.state, b.orbit_radius);
        let (f, p) = (&b.friction, &mut sums.powers);
        sums.cage_torque += f.pocket.cage_torque;
        if let Some(pose) = &frame.free_cage {
            sums.on_cage.react(pose, &f.pocket, (s.frame, self.place_in_bearing(s.position[0], r)));
        }
        p.drag += f.drag * r * s.orbital_speed;
        p.churning -= dot(f.churning, s.angular_velocity);
        p.pocket_friction += f.pocket.friction_power;
        p.pocket_damping += f.pocket.damping_power;
        let [v_a, v_r] = velocity;
        let along = r * s.orbital_speed;
        let speed = v_a * v_a + v_r * v_r + along * along;
        p.energy += 0.5 * self.bearing.mass_of(&s.size) * speed
            + 0.5 * self.bearing.inertia_of(&s.size) * dot(s.angular_velocity, s.angular_velocity)
            + f.pocket.energy;
    }

    #[inline(always)]
    fn add_contact(&self, side: Side, b: &BallForces, frame: &Frame, sums: &mut Sums) {
        let contact = &b.contacts[side];
        Self::react(sums, side, b.state.frame, self.bearing.reaction(side, contact));
        let ring = &frame.rings[side];
        if ring.turning.is_some() {
            let moment = self.bearing.ring_moment(side, &b.state, (contact, b.orbit_radius), ring);
            sums.add_moment(side, b.state.frame.to_inertial(moment), ring.axis());
        } else {
            sums.torque[side] += self.bearing.ring_torque(&b.state, contact, b.orbit_radius, ring);
        }
        sums.powers.friction[side] += contact.traction.power;
        let normal = &contact.normal;
        sums.powers.contact_damping += (normal.force - normal.load) * normal.closing_speed;
        sums.powers.energy += elastic_energy(normal);
    }

    /// Elastic energy of the contacts of a ball with its number and the unknowns `b`, J.
    pub fn elastic_energy(&self, index: usize, b: &[f64], frame: &Frame) -> f64 {
        let (axes, position, surfaces) = self.place(index, b, frame);
        let state = self.state_at((axes, self.bearing.ball_size(index)), position, b);
        let normal = self.normal_loads(&state, &surfaces, frame);
        normal.contacts.iter().map(|(_, contact)| elastic_energy(contact)).sum()
    }

    /// Rings and cage under the sums of the balls.
    pub fn bodies(&self, t: f64, frame: &Frame, sums: &Sums) -> BodyForces {
        let mut f = BodyForces::default();
        let Races { inner, outer } = &frame.rings;
        let (lands, on_rings) = self.lands_and_rings(frame, sums);
        for i in 0..3 {
            if !self.inner.free[i] {
                continue;
            }
            let (x, v, load) = (inner.displacement[i], inner.velocity[i], self.loads[i].at(t));
            f.inner[i] = (load + on_rings.inner[i] + self.inner.force(i, x, v)) / self.inner.mass;
            f.load_power += load * v;
            let stretch = x - self.inner.reference[i];
            f.energy += 0.5 * (self.inner.mass * v * v + self.inner.stiffness[i] * stretch * stretch);
            f.support_loss += self.inner.damping[i] * v * v;
        }
        for i in 0..2 {
            if !self.outer.free[i] {
                continue;
            }
            let (x, v) = (outer.displacement[i], outer.velocity[i]);
            f.outer[i] = (on_rings.outer[i] + self.outer.force(i, x, v)) / self.outer.mass;
            let stretch = x - self.outer.reference[i];
            f.energy += 0.5 * (self.outer.mass * v * v + self.outer.stiffness[i] * stretch * stretch);
            f.support_loss += self.outer.damping[i] * v * v;
        }
        let speeds = Races { inner: inner.speed, outer: outer.speed };
        let [guidance, drag] = self.cage.fluid_torques(frame.cage[1], speeds);
        f.fluid_torque = guidance + drag;
        f.cage = (sums.cage_torque + f.fluid_torque) / self.cage.inertia;
        f.cage_loss = -f.fluid_torque * frame.cage[1];
        if lands.is_none() {
            f.energy += 0.5 * self.cage.inertia * frame.cage[1] * frame.cage[1];
        }
        f.torque = sums.torque;
        if let Some(land) = &self.cage.guidance {
            f.torque[land.side] += guidance;
            f.cage_loss += guidance * speeds[land.side];
        }
        if let Some(lands) = &lands {
            self.free_body(frame, sums, lands, &mut f);
        }
        for side in Side::BOTH {
            let of_lands = lands.as_ref().map_or([0.0; 3], |lands| lands.on_rings[side]);
            let by_others = [0, 1, 2].map(|k| of_lands[k] - sums.moment[side][k]);
            self.tilting_body(side, t, (frame, by_others), &mut f);
        }
        f.shaft_power = f.torque.inner * speeds.inner + f.torque.outer * speeds.outer;
        f
    }
}

/// Elastic energy of a contact, J: the work of a force that grows with the power 3/2 of the approach.
#[inline(always)]
fn elastic_energy(normal: &NormalContact) -> f64 {
    0.4 * normal.load * normal.pose.approach.max(0.0)
}

/// All balls at a time and state, traction by the machine's kernel; `each` sees every one.
pub(crate) fn evaluate<E: Equations>(
    equations: &E,
    t: f64,
    y: &[f64],
    mut each: impl FnMut(usize, &BallForces),
) -> (Frame, Sums, BodyForces) {
    let machine = equations.machine();
    let frame = machine.frame(t, y);
    let mut sums = Sums::default();
    for index in 0..machine.layout.balls {
        let b = machine.unknowns(index, y);
        let forces = equations.ball(index, b, &frame, |patch, _| machine.kernel.traction(&machine.bearing, patch));
        machine.add_ball(&forces, [b[VELOCITY], b[VELOCITY + 1]], &frame, &mut sums);
        each(index, &forces);
    }
    let bodies = machine.bodies(t, &frame, &sums);
    (frame, sums, bodies)
}

impl Sums {
    /// Adds the moment of a ring that is free to tilt on a ball.
    #[inline(always)]
    pub fn add_moment(&mut self, side: Side, moment: [f64; 3], axis: [f64; 3]) {
        self.torque[side] += dot(moment, axis);
        (0..3).for_each(|k| self.moment[side][k] += moment[k]);
    }

    /// All that the balls lose, W.
    pub fn losses(&self) -> f64 {
        let p = &self.powers;
        p.friction.inner
            + p.friction.outer
            + p.drag
            + p.churning
            + p.contact_damping
            + p.pocket_friction
            + p.pocket_damping
    }
}

/// The equations of motion as those of first order.
pub(crate) trait System {
    /// Time derivative of the unknowns `y` at time `t` in s.
    fn derivative(&mut self, t: f64, y: &[f64], dy: &mut [f64]);

    /// The same as a function, for the schemes.
    fn rates(&mut self) -> impl FnMut(f64, &[f64], &mut [f64]) {
        |t, y, dy| self.derivative(t, y, dy)
    }
}

impl<E: Equations> System for E {
    fn derivative(&mut self, t: f64, y: &[f64], dy: &mut [f64]) {
        let l = self.machine().layout;
        let mut watch = std::mem::take(&mut self.machine_mut().watch);
        let (frame, sums, bodies) = evaluate(self, t, y, |index, ball| {
            let at = l.ball(index);
            dy[at..at + 3].copy_from_slice(&y[at + VELOCITY..at + VELOCITY + 3]);
            dy[at + VELOCITY..at + BALL].copy_from_slice(&ball.acceleration);
            watch[index] = self.machine().watch(ball);
            self.machine().turn_ball(index, &ball.state, (y, dy));
        });
        self.machine_mut().watch = watch;
        body_derivative(l, &frame, &sums, &bodies, dy);
    }
}

/// The derivatives of everything but the balls.
pub(crate) fn body_derivative(l: Layout, frame: &Frame, sums: &Sums, f: &BodyForces, dy: &mut [f64]) {
    let [c, i, o, a, w] = [l.cage(), l.inner(), l.outer(), l.angles(), l.work()];
    let Races { inner, outer } = &frame.rings;
    dy[c..c + 2].copy_from_slice(&[frame.cage[1], f.cage]);
    if let Some(rates) = &f.free_cage {
        dy[l.free()].copy_from_slice(rates);
    }
    for (side, rates) in f.tilt.iter() {
        dy[l.tilt(side)].copy_from_slice(rates.as_ref().map_or(&[][..], |rates| rates));
    }
    dy[i..i + 3].copy_from_slice(&inner.velocity);
    dy[i + 3..i + 6].copy_from_slice(&f.inner);
    dy[o..o + 2].copy_from_slice(&outer.velocity[..2]);
    dy[o + 2..o + 4].copy_from_slice(&f.outer);
    dy[a..a + 2].copy_from_slice(&[inner.speed, outer.speed]);
    let put_in = f.shaft_power + f.load_power;
    let lost = sums.losses() + f.support_loss + f.cage_loss;
    dy[w..w + 3].copy_from_slice(&[put_in, lost, f.shaft_power.abs() + f.load_power.abs()]);
}

impl Machine {
    pub fn watch(&self, ball: &BallForces) -> Watch {
        let contacts = &ball.contacts;
        Watch {
            wear: Races::from_fn(|side| self.bearing.wear_rate(side, contacts[side].traction.wear_integral)),
            pocket_wear: self.pocket_wear(&ball.friction.pocket),
            semi_lateral: contacts.each_ref().map(|contact| contact.ellipse.semi_lateral()),
            loaded: contacts.each_ref().map(|contact| contact.normal.load > 0.0),
        }
    }

    /// Wear rate of a pocket, m³/s.
    pub fn pocket_wear(&self, pocket: &PocketLoad) -> f64 {
        self.bearing.pocket_wear_rate(pocket.sliding_power())
    }
}
