//! A free cage in the fast scheme: the drift moves it on, the kick has all that acts on it. A thin film is as stiff as
//! friction, and like it linearly implicit, with the method of the kick: v ← v + H R(H A) f(v), A = ∂f/∂v, of the lands
//! exactly and each time anew. Weight and film, or weight and an edge, are in one f, so that what settles within a step
//! settles where they balance.

use super::Fast;
use super::lanes::{WIDTH, get};
use crate::cage::Lands;
use crate::equations::Frame;
use crate::layout::{AZIMUTH, BALL, OMEGA, RADIUS, VELOCITY};
use crate::machine::Machine;
use nalgebra::{Matrix6, Vector6};
use std::f64::consts::FRAC_1_SQRT_2;
use tribodyn_bearing::{
    AzimuthFrame, CagePose, FreeCage, PocketLoad, Races, RingState, Side, Wrench, WrenchSlope, quaternion_rate,
};

/// γ of the kick's method, 1 − 1/√2.
const GAMMA: f64 = 1.0 - FRAC_1_SQRT_2;

/// A pose with its velocities changed.
fn moving(mut pose: CagePose, by: &Vector6<f64>) -> CagePose {
    for k in 0..3 {
        pose.velocity[k] += by[k];
        pose.omega[k] += by[3 + k];
    }
    pose
}

/// A cage at a position, with the force and moment of its balls.
struct Kicked<'a> {
    machine: &'a Machine,
    cage: &'a FreeCage,
    pose: &'a CagePose,
    rings: &'a Races<RingState>,
    of_balls: &'a Wrench,
}

impl Kicked<'_> {
    /// Accelerations (x, y, z; about x, y, z), and their slopes by velocity and angular velocity.
    fn accelerations(&self) -> (Vector6<f64>, Matrix6<f64>) {
        let (pose, mut wrench, mut slope) = (self.pose, *self.of_balls, WrenchSlope::default());
        for land in &self.cage.lands {
            let load = land.load(pose, self.machine.about_land(land.side, self.rings));
            wrench.add_at([0.0; 3], load.on_cage.force, load.on_cage.moment);
            slope.0.as_flattened_mut().iter_mut().zip(load.slope.0.as_flattened()).for_each(|(sum, of)| *sum += of);
        }
        let body = &self.machine.cage;
        let speeds = Races { inner: self.rings.inner.speed, outer: self.rings.outer.speed };
        let (of_fluid, by_speed) = body.fluid_torque_and_slope(pose.omega[2], speeds);
        wrench.moment[2] += of_fluid;
        slope.0[5][5] += by_speed;
        let (rates, about_z) = self.cage.rates(pose, &wrench, body.inertia);
        let [_, _, _, x, y, z, about_x, about_y, ..] = rates;
        let slopes = self.cage.slopes_of_rates(pose, &slope, body.inertia);
        (Vector6::new(x, y, z, about_x, about_y, about_z), Matrix6::from_fn(|row, column| slopes[column][row]))
    }

    /// Changes of velocity and angular velocity over `h`.
    fn change(&self, h: f64) -> Vector6<f64> {
        let (f, slopes) = self.accelerations();
        let decomposed = (Matrix6::identity() - slopes * (GAMMA * h)).lu();
        // Films and edges only take power: the matrix has an inverse.
        let Some((once, twice)) = decomposed.solve(&f).and_then(|once| Some((once, decomposed.solve(&once)?))) else {
            return f * h;
        };
        (once * GAMMA + twice * (1.0 - GAMMA)) * h
    }
}

/// A free cage and its balls in the middle of a kick, as far as what presses them on each other moves them: there
/// pockets push, so that friction takes what it should to second order.
pub(super) struct Halfway {
    pub frame: Frame,
    pub balls: Vec<[f64; BALL]>,
}

impl Fast {
    /// A free cage half a kick on; none where no ball touches it. Sets how much friction stops a ball within the kick,
    /// with all the others that touch: where it hardly slides, more would drive it to and fro and put energy in.
    pub(super) fn halfway(&self, machine: &mut Machine, frame: &Frame, h: f64) -> Option<Halfway> {
        let (cage, pose) = (machine.free_cage.as_ref()?, frame.free_cage?);
        let ball = |index: usize| get(&self.scratch.balls[index / WIDTH], index % WIDTH);
        let (all, at) = (0..machine.layout.balls, (frame.cage, Some(&pose)));
        let oiled = machine.cage.pocket.film.is_some();
        let touches = |index: &usize| oiled || machine.pocket_depth(*index, &ball(*index), at)[0] > 0.0;
        let touching: Vec<_> = all.clone().filter(touches).collect();
        if touching.is_empty() {
            machine.hold = f64::INFINITY;
            return None;
        }
        let mut balls: Vec<_> = all.map(ball).collect();
        let (mass, inertia) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
        let pocket = &machine.cage.pocket;
        let of_ball = mass.recip() + pocket.ball_radius * pocket.ball_radius / inertia;
        let least = machine.cage.inertia.min(cage.transverse_inertia);
        let of_cage = cage.mass.recip() + pocket.radius * pocket.radius / least;
        machine.hold = 1.0 / (h * (of_ball + touching.len() as f64 * of_cage));
        let mut on_cage = Wrench::default();
        for index in touching {
            let b = &mut balls[index];
            let load = machine.pocket_load(index, b, frame);
            machine.react_on_cage(frame, (&load, b), &mut on_cage);
            let [axial, radial] = load.friction;
            for (k, force) in [axial, radial, load.force / b[RADIUS]].into_iter().enumerate() {
                b[VELOCITY + k] += 0.5 * h * force / mass;
            }
            (0..3).for_each(|k| b[OMEGA + k] += 0.5 * h * load.moment[k] / inertia);
        }
        let ([x, y, z], [a, b, c]) = machine.free_cage.as_ref()?.response(&pose, &on_cage, machine.cage.inertia);
        let pose = moving(pose, &(Vector6::new(x, y, z, a, b, c) * (0.5 * h)));
        Some(Halfway { frame: Frame { free_cage: Some(pose), ..frame.clone() }, balls })
    }
}

impl Machine {
    /// Adds the reaction of a pocket on a free cage.
    pub(super) fn react_on_cage(&self, frame: &Frame, (load, b): (&PocketLoad, &[f64]), on_cage: &mut Wrench) {
        if let Some(pose) = &frame.free_cage {
            on_cage.react(pose, load, (AzimuthFrame::at(b[AZIMUTH]), self.ball_place(b)));
        }
    }

    /// Velocities of a free cage after a time (s) under all that acts on it. Returns what its lands do meanwhile: the
    /// forces are the means, to the last digit, moments those in the middle.
    pub(super) fn kick_free_cage(&self, y: &mut [f64], (frame, of_balls): (&Frame, &Wrench), h: f64) -> Lands {
        let (Some(cage), Some(pose)) = (&self.free_cage, &frame.free_cage) else { return Lands::default() };
        let kicked = Kicked { machine: self, cage, pose, rings: &frame.rings, of_balls };
        let change = kicked.change(h);
        let order = [5, 0, 1, 2, 3, 4];
        self.layout.velocities_of_cage().zip(order).for_each(|(k, of)| y[k] += change[of]);
        // What the lands gave the cage, the rings get back to the last digit.
        let all = [0, 1, 2].map(|k| cage.mass * (change[k] / h - cage.gravity[k]) - of_balls.force[k]);
        let sides = Side::BOTH.map(|side| cage.lands.iter().any(|land| land.side == side));
        let mut lands = if sides == [true; 2] || self.layout.any_tilts() {
            self.lands_at(&moving(*pose, &(change * 0.5)), &frame.rings)
        } else {
            Lands::default()
        };
        match sides {
            [false, false] => {}
            [true, false] => lands.force.inner = all,
            [false, true] => lands.force.outer = all,
            [true, true] => lands.force.outer = [0, 1, 2].map(|k| all[k] - lands.force.inner[k]),
        }
        lands
    }

    /// Position and quaternion of a free cage after a time, s: by the rate in the middle, which keeps the length to the
    /// fourth order.
    pub(super) fn glide_free_cage(&self, y: &mut [f64], h: f64) {
        if self.free_cage.is_none() {
            return;
        }
        let (speed, at) = (y[self.layout.cage() + 1], self.layout.free());
        let [x, v, omega, q] = [0, 3, 6, 8].map(|part| at.start + part);
        (0..3).for_each(|k| y[x + k] += h * y[v + k]);
        let omega = [y[omega], y[omega + 1], speed];
        let now: [f64; 4] = std::array::from_fn(|k| y[q + k]);
        let first = quaternion_rate(omega, now);
        let middle = std::array::from_fn(|k| now[k] + 0.5 * h * first[k]);
        let rate = quaternion_rate(omega, middle);
        (0..4).for_each(|k| y[q + k] += h * rate[k]);
    }
}
