//! The fast fixed-step scheme: contact springs explicit and in short steps, friction once a step and linearly implicit.
//!
//! One step of length H is half a kick, drift(H), half a kick:
//!
//! - The drift moves balls, rings and cage under contact forces, supports and loads, by the leapfrog method in polar
//!   coordinates, with the angular momentum m r² ω_m held while the radius changes. It needs no traction and costs
//!   little, so it may take several steps of its own, where the contact springs are stiffer than one would bear, or
//!   have the balls implicit in them. Dampers and the centrifugal force see the velocity that is expected at the end of
//!   such a step.
//! - The kick changes the velocities v of each ball by traction, drag, churning, pocket and gyroscopic moment f at
//!   fixed position: v ← v + H R(H A) f(v), R(X) = γ W + (1 − γ) W², W = (1 − γ X)⁻¹, γ = 1 − 1/√2. With A = ∂f/∂v this
//!   is of second order with one evaluation of f, in the manner of Rosenbrock, and L-stable: what is stiff settles,
//!   whatever the slope of the traction curve. A is symmetric in the velocities that do work, A = −M⁻¹ Gᵀ S G with the
//!   patch stiffness S, and may be a little old: then the method is still consistent, and the error grows with its age.
//!   A kick is found once, where two steps meet; half of its change goes to each of them.
//!
//! Most of the accelerations of the two parts cancel: contact forces push the ball where friction holds it. A common
//! part, the drift's acceleration without what vibrates of it, is therefore taken from the drift and given back in the
//! kick (`common`). Without it the steady state would be off by what an inexact A makes of the large terms, and motions
//! of the rings by the first order of H.
//!
//! Samples have the state between two steps, with what leapfrog swings too far taken back, the velocities of the balls
//! in the mean of the kick there, and its mean forces: what the kick gave to rings and balls, whose power is then that
//! which the contacts lose. In the middle of a kick the velocity of a ball that grips is off by half of its change, and
//! the friction by as much as there is unsteady force.
//!
//! Traction itself is linear between refreshes: the closed-form derivative of the patch integral by motion and load
//! serves until the slip has moved by as much as keeps the error, seen at every refresh, near [`LINEAR_ERROR`] of the
//! load. A contact that another came by before takes the form of that one ([`Table`]).
//!
//! Both parts are of second order and the composition is symmetric, so the scheme is of second order, down to the error
//! of the linear traction, below which there is no order. Its error against a converged run is measured in `cargo xtask
//! bench`.
//!
//! Sources: splitting, Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, chapters II.5 and VIII.4
//! (impulse method); H. H. Rosenbrock, Comput. J. 5 (1963) 329, doi:10.1093/comjnl/5.4.329.

mod cage;
mod common;
mod depths;
mod drift;
mod friction;
mod glide;
mod halves;
mod implicit;
mod kick;
mod kick_forces;
mod lanes;
mod longest;
mod numbers;
mod orientation;
mod sample;
mod scratch;
mod table;
mod tilt;

use crate::equations::Equations;
use crate::layout::{Layout, VELOCITY};
use crate::linear::{Contacts, LinearTraction};
use crate::machine::Machine;
use crate::traction_errors::LINEAR_ERROR;
use depths::Places;
use drift::{Pressed, drift_acceleration, press};
use fearless_simd::dispatch;
use friction::LinearFriction;
use glide::{glide_balls, glide_bodies, push_balls, push_bodies};
use lanes::{Lane, WIDTH, are_those, blocks, gather, gather_from, scatter, scatter_from};
use longest::{Longest, Pieces};
use nalgebra::Matrix5;
pub(crate) use sample::Room;
use scratch::Scratch;
use serde::{Deserialize, Serialize};
use table::Table;

/// Steps between checks of how long the drift's pieces may be.
const CHECK_EVERY: u64 = 8;

/// Memory of the scheme.
#[derive(Debug, Clone, Serialize, Deserialize, PartialEq)]
pub(crate) struct Fast {
    /// Error of the linear traction over the load that a refresh may find.
    linear_error: f64,
    friction: Vec<LinearFriction>,
    contacts: Vec<Contacts>,
    /// Linear forms that contacts came by before.
    table: Table,
    /// Inverse of the rings' masses less what friction gives back, inertial axes: x, y, z of the inner, x, y of the
    /// outer.
    rings: Matrix5<f64>,
    /// Steps until that matrix is made anew.
    rings_last: usize,
    /// Step for which the inverses are.
    step: f64,
    /// Steps made.
    steps: u64,
    /// Accelerations of the drift at the present position, and the common part that the drift goes without. Those of
    /// the balls are in lanes while steps are made.
    drift: Vec<f64>,
    common: Vec<f64>,
    /// That part as the kick gives it back to rings and cage: the mean of before and after, so that nothing of it is
    /// lost or made.
    #[serde(skip)]
    given_back: Vec<f64>,
    /// True once accelerations of the drift are there.
    ready: bool,
    /// Mean accelerations of cage and rings by the drift over the last step.
    #[serde(skip)]
    mean: Vec<f64>,
    /// Velocities of cage and rings at the start of a piece of the drift.
    #[serde(skip)]
    before: Vec<f64>,
    /// Changes of the velocities by the second half of the last kick. Those of the balls are in lanes while steps are
    /// made.
    half: Vec<f64>,
    /// By how much the mean velocities in the last kick are beyond the middle of their change.
    beyond: Vec<f64>,
    /// Longest pieces of the drift that are stable.
    longest: Longest,
    /// Length of the last pieces, s.
    piece: f64,
    /// The same of the balls where they are explicit, else 0: what vibrates then has the displacement of its velocity.
    piece_of_balls: f64,
    /// The balls in lanes, on which a step works.
    #[serde(skip)]
    scratch: Scratch,
    /// Contacts integrated over their patch, and contacts used.
    refreshed: u64,
    used: u64,
}

impl Default for Fast {
    fn default() -> Self {
        Self::with_linear_error(LINEAR_ERROR)
    }
}

impl Fast {
    /// A scheme whose linear traction may err by this part of the load.
    pub fn with_linear_error(linear_error: f64) -> Self {
        Self {
            linear_error,
            friction: Vec::new(),
            contacts: Vec::new(),
            table: Table::default(),
            rings: Matrix5::zeros(),
            rings_last: 0,
            step: 0.0,
            steps: 0,
            drift: Vec::new(),
            common: Vec::new(),
            given_back: Vec::new(),
            ready: false,
            mean: Vec::new(),
            before: Vec::new(),
            half: Vec::new(),
            beyond: Vec::new(),
            longest: Longest::ANY,
            piece: 0.0,
            piece_of_balls: 0.0,
            scratch: Scratch::default(),
            refreshed: 0,
            used: 0,
        }
    }

    /// Part of the load by which the linear traction may err.
    pub fn linear_error(&self) -> f64 {
        self.linear_error
    }

    /// From `y` at `t` over `h`, in place: the second half of the last kick, the drift, the first half of a new kick.
    pub fn step<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let l = equations.machine().layout;
        self.enter(equations, t, y);
        if self.is_other_step(h) {
            self.begin(equations, t, y, h);
        }
        self.steps += 1;
        self.second_half(l, y);
        self.drift(equations, t, y, h);
        self.find_kick(equations, t + h, y, h);
        for (block, balls) in self.scratch.balls.iter().enumerate() {
            scatter(l, balls, block, y);
        }
    }

    /// True where the memory is not for steps of `h`. Steps between multiples of one number differ in their last
    /// digits.
    fn is_other_step(&self, h: f64) -> bool {
        (self.step - h).abs() > 1e-6 * h
    }

    /// Takes the balls over into lanes, where they stay from one step to the next.
    fn enter<E: Equations>(&mut self, equations: &E, t: f64, y: &[f64]) {
        let l = equations.machine().layout;
        let scratch = &mut self.scratch;
        if scratch.balls.len() != blocks(l.balls) {
            scratch.balls.extend((0..blocks(l.balls)).map(|block| gather(l, y, block)));
        }
        debug_assert!(
            // A motion beyond all numbers is not equal to itself; the run finds it after the step.
            y.iter().any(|value| value.is_nan())
                || scratch.balls.iter().enumerate().all(|(block, balls)| are_those(l, balls, block, y)),
            "the state is not that of the last step"
        );
        let fresh = !self.ready || scratch.pressed.len() != blocks(l.balls);
        if fresh {
            scratch.pressed.resize(blocks(l.balls), Pressed::NONE);
            scratch.places = (0..blocks(l.balls)).map(|block| Places::new(equations.machine(), block)).collect();
            scratch.common.resize(blocks(l.balls), [Lane::ZERO; 3]);
            scratch.given_back.resize(blocks(l.balls), [Lane::ZERO; 3]);
            self.given_back.resize(y.len(), 0.0);
            self.before.resize(y.len(), 0.0);
            self.mean.resize(y.len(), 0.0);
            scratch.mean.resize(blocks(l.balls), [Lane::ZERO; 3]);
            scratch.before.resize(blocks(l.balls), [Lane::ZERO; 3]);
        }
        if !self.ready {
            self.half.resize(y.len(), 0.0);
            self.beyond.resize(y.len(), 0.0);
            self.drift.resize(y.len(), 0.0);
            let found = (&mut self.drift[..], &mut scratch.pressed[..]);
            drift_acceleration(scratch.level, equations, (t, y), &scratch.balls, found);
            for (block, pressed) in scratch.pressed.iter().enumerate() {
                scatter_from(l, pressed.acceleration(), block, (&mut self.drift, VELOCITY));
            }
            self.common.clone_from(&self.drift);
            self.ready = true;
        }
        if fresh {
            let scratch = &mut self.scratch;
            let frame = equations.machine().frame_of_rings(t, y);
            for (block, pressed) in scratch.pressed.iter_mut().enumerate() {
                // Where the balls stand: implicit ones begin their next step with it.
                press(scratch.level, equations, (&frame, block, &scratch.balls[block]), pressed);
                pressed.set_acceleration(gather_from(l, (&self.drift, VELOCITY), block));
                scratch.common[block] = gather_from(l, (&self.common, VELOCITY), block);
            }
            let lanes =
                |from: &[f64]| (0..blocks(l.balls)).map(|block| gather_from(l, (from, VELOCITY), block)).collect();
            (scratch.half, scratch.beyond) = (lanes(&self.half), lanes(&self.beyond));
        }
    }

    /// Takes what is in lanes into the memory: to be called before that is kept.
    pub fn settle(&mut self, l: Layout) {
        let Scratch { pressed, common, half, beyond, .. } = &self.scratch;
        for (block, beyond) in beyond.iter().enumerate() {
            scatter_from(l, beyond, block, (&mut self.beyond, VELOCITY));
        }
        for (block, ((pressed, common), half)) in pressed.iter().zip(common).zip(half).enumerate() {
            scatter_from(l, pressed.acceleration(), block, (&mut self.drift, VELOCITY));
            scatter_from(l, common, block, (&mut self.common, VELOCITY));
            scatter_from(l, half, block, (&mut self.half, VELOCITY));
        }
    }

    /// Motion under springs, supports and loads over `span`.
    fn drift<E: Equations>(&mut self, equations: &E, t: f64, y: &mut [f64], span: f64) {
        let machine = equations.machine();
        let l = machine.layout;
        let Pieces { count: pieces, implicit } = self.longest.pieces(span);
        let h = span / pieces as f64;
        (self.piece, self.piece_of_balls) = (h, if implicit { 0.0 } else { h });
        self.mean.fill(0.0);
        self.scratch.mean.fill([Lane::ZERO; 3]);
        let half = (0.5 * h, 0.5 / pieces as f64);
        for piece in 0..pieces {
            self.remember_velocities(l, y);
            self.push(machine, y, half);
            self.remember_azimuths(machine);
            let Scratch { level, balls, before, pressed, .. } = &mut self.scratch;
            for ((balls, before), pressed) in balls.iter_mut().zip(before).zip(pressed) {
                dispatch!(*level, _simd => glide_balls(balls, before, pressed.in_use, h));
            }
            self.turn_marked(machine, y, h);
            glide_bodies(machine, t + piece as f64 * h, y, h);
            self.swap_ahead(l, y, (piece + 1) as f64 / pieces as f64);
            let t = t + (piece + 1) as f64 * h;
            if implicit {
                self.settle_on_springs(equations, (t, y), h);
            } else {
                let Scratch { level, balls, pressed, .. } = &mut self.scratch;
                drift_acceleration(*level, equations, (t, y), balls, (&mut self.drift, pressed));
            }
            self.swap_back(l, y);
            self.push(machine, y, half);
        }
        // A ball that strikes is pressed many times as hard from one step to the next.
        if machine.is_damaged() || self.steps.is_multiple_of(CHECK_EVERY) {
            self.longest = self.longest_pieces(machine);
        }
    }

    /// Velocities by the drift's accelerations less their common part over a time, s, which is a share of the step.
    fn push(&mut self, machine: &Machine, y: &mut [f64], (h, share): (f64, f64)) {
        let strike = machine.is_damaged();
        let Scratch { level, balls, common, pressed, mean, .. } = &mut self.scratch;
        for (((balls, pressed), common), mean) in balls.iter_mut().zip(pressed).zip(common).zip(mean) {
            dispatch!(*level, _simd => push_balls(balls, (pressed, common), mean, (h, share, strike)));
        }
        push_bodies(machine.layout, y, (&self.drift, &self.common), &mut self.mean, (h, share));
    }

    /// Pieces of the drift of a step.
    pub fn pieces(&self, step: f64) -> usize {
        self.longest.pieces(step).count
    }

    /// Lengths of the memory: friction, contacts, the drift's accelerations, their common part, half kicks and what the
    /// means of kicks are beyond them.
    pub fn sizes(&self) -> [usize; 6] {
        let [balls, contacts] = [self.friction.len(), self.contacts.len()];
        [balls, contacts, self.drift.len(), self.common.len(), self.half.len(), self.beyond.len()]
    }

    /// Most linear forms of a race that are kept for other contacts, and how many may be.
    pub fn table_size(&self) -> [usize; 2] {
        self.table.size()
    }

    /// True if a ball touched the wall of its pocket in the last kick, which was at the end of the last step.
    pub fn touches_pocket(&self, ball: usize) -> bool {
        self.scratch.kick_forces[ball / WIDTH].depth.0[ball % WIDTH] > 0.0
    }

    /// True once accelerations of the drift are there.
    pub fn is_ready(&self) -> bool {
        self.ready
    }

    /// All numbers that are remembered.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let lists =
            self.drift.iter().chain(&self.common).chain(&self.half).chain(&self.beyond).chain(self.rings.iter());
        let contacts = self.contacts.iter().flat_map(|c| c.of.iter().flat_map(LinearTraction::values));
        let friction = self.friction.iter().flat_map(LinearFriction::values);
        lists
            .copied()
            .chain([self.step, self.linear_error, self.piece, self.piece_of_balls])
            .chain(contacts)
            .chain(self.table.values())
            .chain(friction)
    }

    /// Contacts integrated over their patch, and contacts used.
    pub fn patches(&self) -> [u64; 2] {
        [self.refreshed, self.used]
    }
}
