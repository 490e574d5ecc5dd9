//! Sums over the nodes of a film at one temperature.

use super::nodes::{Group, Kept};
use super::state::{INPUTS, State};
use super::stress::{Sloped, blended, by_temperature, sheared};
use crate::MovingPatch;
use crate::fast::lanes::{Lanes, fused, totals};
use fearless_simd::prelude::*;

/// Force along and across, moments about the normal, the lateral axis and the rolling direction, and power.
pub(super) const OUTPUTS: usize = 6;
pub(super) type Outputs = [f64; OUTPUTS];
/// Entries of a symmetric matrix of the five inputs of the motion, row by row up to the diagonal.
pub(super) const STIFFNESS: usize = 15;

/// Integrals and their slope by the temperature.
pub(super) struct Values {
    pub value: Outputs,
    pub wear: f64,
    pub by_temperature: Outputs,
}

/// Slopes of the integrals but for the temperature.
pub(super) struct Slopes {
    /// −∂(force and moments)/∂(motion).
    pub stiffness: [f64; STIFFNESS],
    /// Of the power by the motion.
    pub power_by_motion: [f64; 5],
    /// By the inputs of [`State`].
    pub by_state: [Outputs; INPUTS],
    /// Of the wear integral by the logarithm of the load.
    pub wear_by_load: f64,
}

/// A contact's lengths, m, and speeds.
struct Frame {
    a: f64,
    b: f64,
    radius: f64,
    flatness: f64,
}

/// Where eight nodes stand, m.
struct Place<S: Simd> {
    x: Lanes<S>,
    y: Lanes<S>,
    bow: Lanes<S>,
    arm: Lanes<S>,
}

impl Frame {
    fn new(contact: &MovingPatch) -> Self {
        let patch = &contact.patch;
        Self {
            a: patch.semi_lateral,
            b: patch.semi_rolling,
            radius: patch.ball_radius,
            flatness: 0.5 / patch.surface_radius,
        }
    }

    #[inline(always)]
    fn place<S: Simd>(&self, at: &Group<S>) -> Place<S> {
        let (x, y) = (at.x * self.b, at.y * self.a);
        let bow = y * y * self.flatness;
        Place { x, y, bow, arm: -bow + self.radius }
    }
}

/// Adds a force per area times area along and across on the ball, with its power, to the outputs.
#[inline(always)]
fn add<S: Simd>(sum: &mut [Lanes<S>; OUTPUTS], place: &Place<S>, [fx, fy]: [Lanes<S>; 2], power: Lanes<S>) {
    sum[0] += fx;
    sum[1] += fy;
    sum[2] = fused(place.x, fy, fused(-place.y, fx, sum[2]));
    sum[3] = fused(place.arm, fx, sum[3]);
    sum[4] = fused(-place.arm, fy, sum[4]);
    sum[5] += power;
}

/// Adds a stress (Pa) against the sliding velocity.
#[inline(always)]
fn drag<S: Simd>(sum: &mut [Lanes<S>; OUTPUTS], place: &Place<S>, at: &Group<S>, over_speed: Lanes<S>) {
    let (fx, fy) = (-(over_speed * at.u), -(over_speed * at.v));
    add(sum, place, [fx, fy], over_speed * at.speed * at.speed);
}

/// Integrals and their slope by the temperature.
#[inline(always)]
pub(super) fn values<S: Simd>(simd: S, film: &Sloped, contact: &MovingPatch, nodes: &[Kept]) -> Values {
    let nothing = Lanes::splat(simd, 0.0);
    let (mut value, mut warmer, mut wear) = ([nothing; OUTPUTS], [nothing; OUTPUTS], nothing);
    let frame = Frame::new(contact);
    for kept in nodes {
        let at = &kept.group(simd);
        let place = frame.place(at);
        let sheared = sheared(film, at);
        let share = at.area / at.speed;
        drag(&mut value, &place, at, share * blended(film, at, &sheared));
        drag(&mut warmer, &place, at, share * by_temperature(film, at, &sheared));
        wear = fused(at.area * at.pressure, at.speed, wear);
    }
    let [wear] = totals(&[wear]);
    Values { value: totals(&value), wear, by_temperature: totals(&warmer) }
}

/// Integrals and all their slopes.
#[inline(always)]
pub(super) fn slopes<S: Simd>(
    simd: S,
    film: &Sloped,
    (contact, state): (&MovingPatch, &State),
    nodes: &[Kept],
) -> (Values, Slopes) {
    let mut sums = Sums::new(simd, (contact, state));
    for kept in nodes {
        sums.node(film, &kept.group(simd));
    }
    sums.close()
}

struct Sums<'a, S: Simd> {
    frame: Frame,
    contact: &'a MovingPatch,
    /// Slopes of ln h and of the share of asperities by the inputs of [`State`].
    film: [[f64; 2]; INPUTS],
    /// d ln V/dV, s/m.
    creep_by_speed: f64,
    value: [Lanes<S>; OUTPUTS],
    warmer: [Lanes<S>; OUTPUTS],
    by_state: [[Lanes<S>; OUTPUTS]; INPUTS],
    stiffness: [Lanes<S>; STIFFNESS],
    power_by_motion: [Lanes<S>; 5],
    /// Wear and its slope by the load.
    wear: [Lanes<S>; 2],
}

impl<'a, S: Simd> Sums<'a, S> {
    #[inline(always)]
    fn new(simd: S, (contact, state): (&'a MovingPatch, &State)) -> Self {
        let nothing = Lanes::splat(simd, 0.0);
        let none = [nothing; OUTPUTS];
        Self {
            frame: Frame::new(contact),
            contact,
            film: std::array::from_fn(|input| [state.gap.by[input] / state.gap.value, state.share.by[input]]),
            creep_by_speed: contact.log_speed_slope(),
            value: none,
            warmer: none,
            by_state: [none; INPUTS],
            stiffness: [nothing; STIFFNESS],
            power_by_motion: [nothing; 5],
            wear: [nothing; 2],
        }
    }

    #[inline(always)]
    fn node(&mut self, film: &Sloped, at: &Group<S>) {
        let place = self.frame.place(at);
        let sheared = sheared(film, at);
        let inverse = Lanes::splat(at.x.token(), 1.0) / at.speed;
        let share = at.area * inverse;
        let (wet, dry) = (1.0 - film.at.share, film.at.share);
        let stress = blended(film, at, &sheared);
        let over_speed = share * stress;
        drag(&mut self.value, &place, at, over_speed);
        drag(&mut self.warmer, &place, at, share * by_temperature(film, at, &sheared));

        // τ by ln |Δv|, by ln p, by ln h, by ln V through the bodies, and by the share of asperities.
        let newton = sheared.by_newton * wet;
        let by_speed = fused(at.dry_slope, dry, newton);
        let stiffer = at.rise_slope * film.at.stress.stiffness * sheared.yielding;
        let limited = fused(newton, stiffer, sheared.by_limit * wet);
        let by_pressure = fused(at.dry - at.dry_slope, dry, limited);
        let by_gap = -(newton * sheared.yielding);
        let by_creep = -newton - by_gap - at.dry_slope * dry;
        let by_share = at.dry - sheared.stress;

        let [load, speed, sliding] = self.film;
        let pressed = fused(fused(stress, 2.0, by_pressure), 1.0 / 3.0, fused(by_gap, load[0], by_share * load[1]));
        let faster = fused(by_creep, self.creep_by_speed, fused(by_gap, speed[0], by_share * speed[1]));
        drag(&mut self.by_state[1], &place, at, share * faster);
        drag(&mut self.by_state[2], &place, at, share * fused(by_gap, sliding[0], by_share * sliding[1]));
        self.move_with(&place, at, (over_speed, fused(by_speed, share, -over_speed)), (inverse, share * pressed));
    }

    /// Slopes by the motion, and by the load the nodes of which grow with it: from the stress over the speed and the
    /// bend by which this changes with the speed, both times the area.
    #[inline(always)]
    fn move_with(
        &mut self,
        place: &Place<S>,
        at: &Group<S>,
        (over_speed, bend): (Lanes<S>, Lanes<S>),
        (inverse, pressed): (Lanes<S>, Lanes<S>),
    ) {
        let (eu, ev) = (at.u * inverse, at.v * inverse);
        let (bend_u, power) = (bend * eu, fused(over_speed, 2.0, bend));
        let (k11, k12, k22) = (fused(bend_u, eu, over_speed), bend_u * ev, fused(bend * ev, ev, over_speed));
        let Place { x, y, bow, arm } = *place;
        let (spin1, spin2) = (fused(x, k12, -(y * k11)), fused(x, k22, -(y * k12)));
        let (arm11, arm12, arm22) = (arm * k11, arm * k12, arm * k22);
        let spins = fused(x, spin2, -(y * spin1));
        let terms = [
            k11,
            k12,
            k22,
            spin1,
            spin2,
            spins,
            arm11,
            arm12,
            arm * spin1,
            arm * arm11,
            -arm12,
            -arm22,
            -(arm * spin2),
            -(arm * arm12),
            arm * arm22,
        ];
        for (sum, term) in self.stiffness.iter_mut().zip(terms) {
            *sum += term;
        }
        let (pu, pv) = (power * at.u, power * at.v);
        let terms = [pu, pv, fused(x, pv, -(y * pu)), arm * pu, -(arm * pv)];
        for (sum, term) in self.power_by_motion.iter_mut().zip(terms) {
            *sum += term;
        }

        // By ln Q: the nodes move a third of their distance outwards, the area grows by two thirds.
        let (motion, third) = (&self.contact.motion, 1.0 / 3.0);
        let du = fused(y, -motion.spin * third, bow * (-2.0 * third * motion.about_lateral));
        let dv = fused(x, motion.spin * third, bow * (2.0 * third * motion.about_rolling));
        let fx = -fused(k11, du, fused(k12, dv, pressed * at.u));
        let fy = -fused(k12, du, fused(k22, dv, pressed * at.v));
        let dot = fused(at.u, du, at.v * dv);
        let sum = &mut self.by_state[0];
        add(sum, place, [fx, fy], fused(power, dot, pressed * at.speed * at.speed));
        let (gx, gy) = (-(over_speed * at.u) * third, -(over_speed * at.v) * third);
        sum[2] += fused(x, gy, -(y * gx));
        sum[3] = fused(bow * -2.0, gx, sum[3]);
        sum[4] = fused(bow * 2.0, gy, sum[4]);
        let flow = at.area * at.pressure;
        self.wear[0] = fused(flow, at.speed, self.wear[0]);
        self.wear[1] = fused(flow, fused(dot, inverse, at.speed), self.wear[1]);
    }

    #[inline(always)]
    fn close(self) -> (Values, Slopes) {
        let [wear, wear_by_load] = totals(&self.wear);
        let [load, speed, sliding] = &self.by_state;
        (
            Values { value: totals(&self.value), wear, by_temperature: totals(&self.warmer) },
            Slopes {
                stiffness: totals(&self.stiffness),
                power_by_motion: totals(&self.power_by_motion),
                by_state: [totals(load), totals(speed), totals(sliding)],
                wear_by_load,
            },
        )
    }
}
