//! What acts on the balls at a moment of the fast scheme, for samples: springs, traction and fluid in lanes, the rest
//! ball by ball.

use super::drift::{Stand, press};
use super::grip::{Grips, LINEAR, surroundings};
use super::lanes::{Lane, WIDTH, gather, get, put};
use super::{Fast, Scratch};
use crate::equations::{BallForces, Equations, Frame, Touched};
use crate::layout::BALL;
use crate::linear::LinearTraction;
use crate::machine::Machine;
use fearless_simd::dispatch;
use tribodyn_bearing::{BallState, RaceContact, Races, Side, Sliding};
use tribodyn_traction::{PatchTraction, RelativeMotion};

/// Reach of a linear traction for samples, over that for steps: half a step before a refresh the linear form must not
/// give way to an integral that serves only once.
const BEFORE_REFRESH: f64 = 1.5;
/// Numbers of a contact that slides: motion, rolling speed, how far it has sunk in, traction, and 1 where the linear
/// form is near, else 0.
const SLIDE: usize = 15;
type Slides = [[Lane; SLIDE]; 2];

/// A look at the balls, one after the other.
pub(crate) struct Look<'a> {
    fast: &'a Fast,
    machine: &'a Machine,
    stand: Stand,
    slides: Slides,
    grips: Grips,
}

impl Fast {
    /// Whether there are linear forms to look through.
    pub fn has_forms(&self) -> bool {
        !self.scratch.forms.is_empty()
    }

    /// A look at the balls with the linear forms of the last step.
    pub fn look<'a>(&'a self, machine: &'a Machine) -> Look<'a> {
        Look { fast: self, machine, stand: Stand::NONE, slides: [[Lane::ZERO; SLIDE]; 2], grips: Grips::NONE }
    }
}

impl Look<'_> {
    /// All that acts on ball `index` with the unknowns `b`; to be asked for the balls in the order of their numbers.
    #[inline]
    pub fn ball(&mut self, index: usize, y: &[f64], frame: &Frame) -> BallForces {
        let (machine, k) = (self.machine, index % WIDTH);
        if k == 0 {
            self.block(index / WIDTH, y, frame);
        }
        let b = machine.unknowns(index, y);
        let stand = &self.stand;
        let state = machine.state_at(stand.axes(k), stand.position(k), b);
        let (surfaces, r) = (Races::from_fn(|side| stand.surface(side, k)), stand.orbit_radius(k));
        let contacts = Races::from_fn(|side| self.contact(side, k));
        let touched = Touched { state, surfaces, orbit_radius: r, contacts, fluid: self.grips.fluid(k) };
        machine.together((index, b, frame), touched)
    }

    /// What is found in lanes.
    fn block(&mut self, block: usize, y: &[f64], frame: &Frame) {
        let Scratch { level, forms, .. } = &self.fast.scratch;
        let (machine, balls) = (self.machine, gather(self.machine.layout, y, block));
        press(*level, machine, (frame, &balls), &mut self.stand);
        let (stand, traction) = (&self.stand, &forms[block].traction);
        let (slides, grips) = (&mut self.slides, &mut self.grips);
        dispatch!(*level, _simd => {
            slide(machine, frame, (&balls, stand, traction), slides);
            surroundings(machine, (frame, &Lane::ZERO), (&balls, stand), grips);
        });
    }

    fn contact(&self, side: Side, k: usize) -> RaceContact {
        let (machine, normal) = (self.machine, self.stand.contact(side, k));
        #[rustfmt::skip]
        let [
            rolling, lateral, spin, about_lateral, about_rolling, rolling_speed, sunk,
            force_rolling, force_lateral, moment_normal, moment_lateral, moment_rolling, power, wear_integral, near,
        ] = get(&self.slides[side as usize], k);
        let motion = RelativeMotion { rolling, lateral, spin, about_lateral, about_rolling };
        let sliding = Sliding { normal: normal.pose.normal(side), motion, rolling_speed, sunk };
        #[rustfmt::skip]
        let linear = PatchTraction {
            force_rolling, force_lateral, moment_normal, moment_lateral, moment_rolling, power, wear_integral,
        };
        machine.bearing.race_contact(side, normal, &sliding, self.stand.bare(side, k), |patch| {
            if near > 0.0 { linear } else { machine.kernel.traction(&machine.bearing, patch) }
        })
    }
}

/// How the balls of a block slide on their races, and their tractions by the linear forms.
#[inline(always)]
fn slide(
    machine: &Machine,
    frame: &Frame,
    (balls, stand, forms): (&[Lane; BALL], &Stand, &[[Lane; LINEAR]; 2]),
    slides: &mut Slides,
) {
    let (mut out, frame) = ([[Lane::ZERO; SLIDE]; 2], *frame);
    for k in 0..WIDTH {
        let state = machine.state_at(stand.axes(k), stand.position(k), &get(balls, k));
        put(&mut out[0], k, numbers(machine, Side::Inner, (&frame, &state), (stand, &forms[0], k)));
        put(&mut out[1], k, numbers(machine, Side::Outer, (&frame, &state), (stand, &forms[1], k)));
    }
    *slides = out;
}

#[inline(always)]
fn numbers(
    machine: &Machine,
    side: Side,
    (frame, state): (&Frame, &BallState),
    (stand, form, k): (&Stand, &[Lane; LINEAR], usize),
) -> [f64; SLIDE] {
    let (contact, radius) = (stand.contact(side, k), machine.bearing.geometry.ball_radius());
    let Sliding { motion: m, rolling_speed, sunk, .. } =
        machine.sliding(side, &contact, state, (frame, stand.orbit_radius(k)));
    let linear = LinearTraction::from_numbers(|i| form[i].0[k]);
    let (change, near) = linear.reaches(&m, contact.load, (stand.bare(side, k), BEFORE_REFRESH), radius);
    let t = linear.traction(&m, &change);
    #[rustfmt::skip]
    let numbers = [
        m.rolling, m.lateral, m.spin, m.about_lateral, m.about_rolling, rolling_speed, sunk,
        t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling, t.power,
        t.wear_integral, if near { 1.0 } else { 0.0 },
    ];
    numbers
}
