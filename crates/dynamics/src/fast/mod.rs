//! The fast fixed-step scheme: contact springs explicit and in short steps, friction once a step and linearly implicit.
//!
//! One step of length H is the symmetric composition drift(H/2), kick(H), drift(H/2):
//!
//! - The drift moves balls, rings and cage under contact forces, supports and loads, by the leapfrog method in polar
//!   coordinates, with the angular momentum m r² ω_m held while the radius changes. It needs no traction and costs
//!   little, so it may take several steps of its own.
//! - The kick changes the velocities v of each ball by traction, drag, churning, pocket and gyroscopic moment f at
//!   fixed position: v ← v + H R(H A) f(v), R(X) = γ W + (1 − γ) W², W = (1 − γ X)⁻¹, γ = 1 − 1/√2. With A = ∂f/∂v this
//!   is of second order with one evaluation of f, in the manner of Rosenbrock, and L-stable: what is stiff settles,
//!   whatever the slope of the traction curve. A is symmetric in the velocities that do work, A = −M⁻¹ Gᵀ S G with the
//!   patch stiffness S, and may be a little old: then the method is still consistent, and the error grows with its age.
//!
//! Most of the accelerations of the two parts cancel: contact forces push the ball where friction holds it. A common
//! part g, the drift's acceleration smoothed over some steps, is therefore taken from the drift and given back in the
//! kick. Without it the steady state would be off by what an inexact A makes of the large terms, in proportion to H.
//! The kick gives back the mean of g before and after its smoothing, which is just what the two half drifts went
//! without: linear and angular momentum then hold to second order.
//!
//! Traction itself is linear between refreshes: the closed-form derivative of the patch integral by motion and load
//! serves until the slip has moved by as much as keeps the error, seen at every refresh, near [`LINEAR_ERROR`] of the
//! load.
//!
//! Both parts are of second order and the composition is symmetric, so the scheme is of second order, down to the error
//! of the linear traction, below which there is no order. Its error against a converged run is measured in `cargo xtask
//! bench`.
//!
//! Sources: splitting, Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, chapters II.5 and VIII.4
//! (impulse method); H. H. Rosenbrock, Comput. J. 5 (1963) 329, doi:10.1093/comjnl/5.4.329.

mod drift;
mod friction;

use crate::equations::{Equations, Frame};
use crate::layout::{AZIMUTH, BALL, Layout, VELOCITY};
use crate::linear::{Contacts, LINEAR_ERROR, LinearTraction};
use crate::machine::Machine;
use crate::watch::Watch;
use drift::{drift_acceleration, glide, push};
use friction::{LinearFriction, in_inertial_axes, inverse_with_held, linear_friction, ring_in_ball_axes};
use nalgebra::{Matrix5, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::{
    AzimuthFrame, BallState, ContactForces, LoadedPatch, LocalSurface, NormalLoads, Races, Side, Sliding,
};
use tribodyn_traction::PatchTraction;

/// Time in which the common acceleration follows that of the drift, s: some periods of the contact springs, so that it
/// does not feed their vibration back (at a tenth of it the outer ring's acceleration doubles), and short against an
/// orbit.
const SMOOTHING_TIME: f64 = 5e-4;
/// The same for the rings, s: they vibrate at lower frequencies.
const RING_SMOOTHING_TIME: f64 = 5e-3;
/// Steps between new matrices of the rings: they only predict, and turn with the balls by a degree or so.
const RINGS_EVERY: usize = 16;
/// Most steps that a linear traction serves.
const LONGEST_LINEAR: usize = 64;
/// Reach of a linear traction for samples, over that for steps: half a step before a refresh the linear form must not
/// give way to an integral that serves only once.
const BEFORE_REFRESH: f64 = 1.5;
/// Longest step of the drift over the period of the contact springs, as an angle: leapfrog is stable up to 2.
const DRIFT_ANGLE: f64 = 1.4;

/// Pieces of half a step's drift: `highest` is the frequency of the contact springs in Hz.
pub(crate) fn pieces(h: f64, highest: f64) -> usize {
    (0.5 * h * TAU * highest / DRIFT_ANGLE).ceil().max(1.0) as usize
}

/// Memory of the scheme.
#[derive(Debug, Clone, Serialize, Deserialize, PartialEq)]
pub(crate) struct Fast {
    /// Error of the linear traction over the load that a refresh may find.
    linear_error: f64,
    friction: Vec<LinearFriction>,
    contacts: Vec<Contacts>,
    /// Inverse of the rings' masses less what friction gives back, inertial axes: x, y, z of the inner, x, y of the
    /// outer.
    rings: Matrix5<f64>,
    /// Steps until that matrix is made anew.
    rings_last: usize,
    /// Step for which the inverses are.
    step: f64,
    /// Accelerations of the drift at the present position, their smoothed part, which the drift goes without, and that
    /// part as the kick gives it back: the mean of before and after, so that nothing of it is lost or made.
    drift: Vec<f64>,
    common: Vec<f64>,
    given_back: Vec<f64>,
    /// Whether they are there.
    ready: bool,
    /// Where the balls stood when the drift was last evaluated.
    #[serde(skip)]
    stands: Vec<Stand>,
    /// Contacts integrated over their patch, and contacts used.
    refreshed: u64,
    used: u64,
}

/// What the drift finds of a ball and the kick at the same position needs again.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Stand {
    axes: AzimuthFrame,
    position: [f64; 2],
    normal: NormalLoads,
    surfaces: Races<LocalSurface>,
}

/// Tractions on a ball in the kick.
struct Grip {
    state: BallState,
    traction: Races<ContactForces>,
    watch: Watch,
}

impl Grip {
    const NO_TRACTION: ContactForces = ContactForces { force: [0.0; 3], moment: [0.0; 3] };

    fn new(state: BallState) -> Self {
        let traction = Races { inner: Self::NO_TRACTION, outer: Self::NO_TRACTION };
        Self { state, traction, watch: Watch::default() }
    }

    fn add(&mut self, machine: &Machine, side: Side, sliding: &Sliding, traction: &PatchTraction, semi_lateral: f64) {
        self.traction[side] = sliding.on_ball(traction);
        self.watch.wear[side] = machine.bearing.wear_rate(side, traction.wear_integral);
        self.watch.semi_lateral[side] = semi_lateral;
        self.watch.loaded[side] = true;
    }
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
            rings: Matrix5::zeros(),
            rings_last: 0,
            step: 0.0,
            drift: Vec::new(),
            common: Vec::new(),
            given_back: Vec::new(),
            ready: false,
            stands: Vec::new(),
            refreshed: 0,
            used: 0,
        }
    }

    /// From `y` at `t` over `h`, in place. `highest` is the frequency of the contact springs in Hz.
    pub fn step<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64, highest: f64) {
        let pieces = pieces(h, highest);
        self.drift(equations, t, y, 0.5 * h, pieces);
        self.kick(equations, t + 0.5 * h, y, h);
        self.drift(equations, t + 0.5 * h, y, 0.5 * h, pieces);
    }

    fn drift<E: Equations>(&mut self, equations: &E, t: f64, y: &mut [f64], span: f64, pieces: usize) {
        let machine = equations.machine();
        let h = span / pieces as f64;
        if !self.ready {
            self.drift.resize(y.len(), 0.0);
            drift_acceleration(equations, t, y, &mut self.drift, &mut self.stands);
            self.common = self.drift.clone();
            self.given_back = self.drift.clone();
            self.ready = true;
        }
        for piece in 0..pieces {
            push(machine, y, (&self.drift, &self.common), 0.5 * h);
            glide(machine, t + piece as f64 * h, y, h);
            drift_acceleration(equations, t + (piece + 1) as f64 * h, y, &mut self.drift, &mut self.stands);
            push(machine, y, (&self.drift, &self.common), 0.5 * h);
        }
    }

    /// Every ball by itself with the rings held, then the rings with what the balls leave, then the balls again by what
    /// the rings moved. The rings receive to the last digit what the balls give.
    fn kick<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let l = equations.machine().layout;
        let frame = equations.machine().frame(t, y);
        if self.friction.len() != l.balls {
            self.friction.resize(l.balls, LinearFriction::NONE());
            self.contacts.resize(l.balls, Contacts::default());
        }
        // Steps between multiples of one number differ in their last digits.
        let renew = (self.step - h).abs() > 1e-6 * h;
        if renew {
            self.step = h;
        }
        self.smooth(l, h);
        let mut on_rings = self.ring_common(equations.machine());
        let mut cage_torque = 0.0;
        for index in 0..l.balls {
            let at = l.ball(index);
            let b = &mut y[at..][..BALL];
            let grip = self.grip(equations, index, b, &frame, renew);
            let r = self.stands[index].normal.orbit_radius;
            let part = equations.friction(index, (b, &grip.state), &grip.traction, (&frame, r));
            cage_torque += part.pocket.cage_torque;
            let machine = equations.machine_mut();
            machine.watch[index] = grip.watch;
            machine.watch[index].pocket_wear = machine.pocket_wear(&part.pocket);
            let friction = &self.friction[index];
            let common = Vector6::from_column_slice(&self.given_back[at + VELOCITY..at + BALL]);
            let acceleration = Vector6::from(equations.friction_acceleration(&grip.state, &part, r));
            let push = (acceleration + common) * h;
            let [change, mean] = [friction.response[0] * push, friction.response[1] * push];
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let (i, o) = (grip.traction.inner.force, grip.traction.outer.force);
            let force = friction.coupling.tr_mul(&mean) - Vector6::new(i[0], i[1], i[2], o[0], o[1], o[2]);
            on_rings += in_inertial_axes(grip.state.frame, &force);
        }
        let machine = equations.machine();
        if renew || self.rings_last == 0 {
            self.rings = self.ring_matrix(machine, y, h);
            self.rings_last = RINGS_EVERY;
        }
        self.rings_last -= 1;
        let predicted = self.rings * on_rings * h;
        for index in 0..l.balls {
            let b = &mut y[l.ball(index)..][..BALL];
            let axes = self.stands[index].axes;
            let friction = &self.friction[index];
            let rings = ring_in_ball_axes(axes, &predicted);
            let [change, mean] = [friction.follow[0] * rings, friction.follow[1] * rings];
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let force = friction.coupling.tr_mul(&mean) + friction.on_rings(&rings) * 0.5;
            on_rings += in_inertial_axes(axes, &force);
        }
        push_bodies(machine, y, (&on_rings, cage_torque), h);
    }

    /// Lets the common acceleration follow that of the drift.
    fn smooth(&mut self, l: Layout, h: f64) {
        for (k, ((common, given), drift)) in
            self.common.iter_mut().zip(&mut self.given_back).zip(&self.drift).enumerate()
        {
            let time = if k < l.cage() { SMOOTHING_TIME } else { RING_SMOOTHING_TIME };
            let before = *common;
            *common += (h / time).min(1.0) * (drift - before);
            *given = 0.5 * (before + *common);
        }
    }

    /// The common force on the rings that the kick gives back, N.
    fn ring_common(&self, machine: &Machine) -> Vector5<f64> {
        let l = machine.layout;
        let (i, o) = (&self.given_back[l.inner() + 3..], &self.given_back[l.outer() + 2..]);
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        Vector5::new(inner * i[0], inner * i[1], inner * i[2], outer * o[0], outer * o[1])
    }

    /// Traction of a patch of ball `index` from the linear form where that holds, for samples.
    pub fn traction(&self, machine: &Machine, index: usize, patch: &LoadedPatch<'_, f64>) -> PatchTraction {
        let linear = self.contacts.get(index).map(|c| &c.of[patch.side as usize]);
        linear
            .and_then(|linear| {
                linear.at(&patch.motion, patch.load, (patch.bare, BEFORE_REFRESH), patch.patch.ball_radius)
            })
            .unwrap_or_else(|| machine.kernel.traction(&machine.bearing, patch))
    }

    /// Lengths of the memory: friction, contacts, the drift's accelerations, their common part, and what is given back.
    pub fn sizes(&self) -> [usize; 5] {
        [self.friction.len(), self.contacts.len(), self.drift.len(), self.common.len(), self.given_back.len()]
    }

    /// True once accelerations of the drift are there.
    pub fn is_ready(&self) -> bool {
        self.ready
    }

    /// All numbers that are remembered.
    pub fn values(&self) -> impl Iterator<Item = f64> + '_ {
        let lists = self.drift.iter().chain(&self.common).chain(&self.given_back).chain(self.rings.iter());
        let contacts = self.contacts.iter().flat_map(|c| c.of.iter().flat_map(LinearTraction::values));
        let friction = self.friction.iter().flat_map(LinearFriction::values);
        lists.copied().chain([self.step, self.linear_error]).chain(contacts).chain(friction)
    }

    /// Contacts integrated over their patch, and contacts used.
    pub fn patches(&self) -> [u64; 2] {
        [self.refreshed, self.used]
    }

    /// Traction on a ball from its linear form where that still holds, else integrated and linearised anew.
    fn grip<E: Equations>(&mut self, equations: &E, index: usize, b: &[f64], frame: &Frame, renew: bool) -> Grip {
        let machine = equations.machine();
        let bearing = &machine.bearing;
        let stand = &self.stands[index];
        let normal = &stand.normal;
        let state = equations.state_at(stand.axes, stand.position, b);
        let sliding = |side| equations.sliding(side, &normal.contacts[side], &state, (frame, normal.orbit_radius));
        self.used += 2;
        let contacts = &mut self.contacts[index];
        contacts.age += 1;
        let mut grip = Grip::new(state);
        let mut holds = !renew && contacts.age <= LONGEST_LINEAR;
        for (side, contact) in normal.contacts.iter() {
            if !holds || contact.load <= 0.0 {
                continue;
            }
            let (sliding, linear) = (sliding(side), &contacts.of[side as usize]);
            let reach = (stand.surfaces[side].bare, 1.0);
            let traction = linear.at(&sliding.motion, contact.load, reach, bearing.geometry.ball_radius());
            holds = traction.is_some();
            if let Some(traction) = traction {
                grip.add(machine, side, &sliding, &traction, linear.semi_lateral());
            }
        }
        if holds {
            return grip;
        }
        self.refreshed += 2;
        let mut grip = Grip::new(state);
        for (side, contact) in normal.contacts.iter().filter(|(_, contact)| contact.load > 0.0) {
            let sliding = sliding(side);
            let ellipse = bearing.ellipse(side, contact);
            let patch = bearing.loaded_patch(side, contact, &ellipse, &sliding, stand.surfaces[side].bare);
            let traction = contacts.of[side as usize].refresh(machine, &patch, self.linear_error);
            grip.add(machine, side, &sliding, &traction, ellipse.semi_lateral());
        }
        contacts.age = 0;
        self.friction[index] = linear_friction(machine, &state, normal, &contacts.of, self.step);
        grip
    }

    fn ring_matrix(&self, machine: &Machine, y: &[f64], h: f64) -> Matrix5<f64> {
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        let mut sum = Matrix5::from_diagonal(&Vector5::new(inner, inner, inner, outer, outer));
        for (index, f) in self.friction.iter().enumerate() {
            let axes = AzimuthFrame::at(y[machine.layout.ball(index) + AZIMUTH]);
            let given_back = f.coupling.tr_mul(&f.follow[1]);
            for column in 0..5 {
                let unit = ring_in_ball_axes(axes, &Vector5::ith(column, 1.0));
                let force = in_inertial_axes(axes, &((given_back * unit + f.on_rings(&unit) * 0.5) * h));
                let mut slot = sum.column_mut(column);
                slot -= force;
            }
        }
        let free = machine.inner.free.iter().chain(&machine.outer.free);
        for (k, _) in free.enumerate().filter(|(_, free)| !**free) {
            sum.row_mut(k).fill(0.0);
            sum.column_mut(k).fill(0.0);
            sum[(k, k)] = f64::INFINITY;
        }
        inverse_with_held(sum)
    }
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
    y[l.cage() + 1] += h * cage_torque / machine.cage.inertia;
}
