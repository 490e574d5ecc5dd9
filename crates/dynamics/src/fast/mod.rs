//! The fast fixed-step scheme: contact springs explicit and in short steps, friction once a step and linearly implicit.
//!
//! One step of length H is the symmetric composition drift(H/2), kick(H), drift(H/2):
//!
//! - The drift moves balls, rings and cage under contact forces, supports and loads, by the leapfrog method in
//!   polar coordinates, with the angular momentum m r² ω_m held while the radius changes. It needs no traction and costs little, so it may take several steps of its own.
//! - The kick changes the velocities v of each ball by traction, drag, churning, pocket and gyroscopic moment f at fixed position:
//!   v ← v + H R(H A) f(v), R(X) = γ W + (1 − γ) W², W = (1 − γ X)⁻¹, γ = 1 − 1/√2. With A = ∂f/∂v this is of second order with
//!   one evaluation of f, in the manner of Rosenbrock, and L-stable: what is stiff settles, whatever the
//!   slope of the traction curve. A is symmetric in the velocities that do work, A = −M⁻¹ Gᵀ S G with the patch
//!   stiffness S, and may be a little old: then the method is still consistent, and the error grows with its age.
//!
//! Most of the accelerations of the two parts cancel: contact forces push the ball where friction holds it. A common part g,
//! the drift's acceleration smoothed over some steps, is therefore taken from the drift and given to the kick. Without it
//! the steady state would be off by what an inexact A makes of the large terms, in proportion to H.
//!
//! Traction itself is linear between refreshes: the closed-form derivative of the patch integral by motion and load serves
//! until the slip has moved by as much as keeps the error, seen at every refresh, near [`LINEAR_ERROR`] of the load.
//!
//! Both parts are of second order and the composition is symmetric, so the scheme is of second order where the common part
//! changes slowly against its smoothing; where it does not, as right after the start, the order falls towards the first
//! (1.2 seen), and below the error of the linear traction there is none.
//! Its error against a converged run is measured in `cargo xtask bench`.
//!
//! Sources: splitting, Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, chapters II.5 and VIII.4
//! (impulse method); H. H. Rosenbrock, Comput. J. 5 (1963) 329, doi:10.1093/comjnl/5.4.329.

mod drift;
mod friction;

use crate::forces::{Frame, Watch};
use crate::layout::{AZIMUTH, BALL, Layout, ORBIT, RADIUS, SPIN, VELOCITY};
use crate::linear::{Contacts, LINEAR_ERROR, LinearTraction, load_of};
use crate::machine::Machine;
use crate::pocket::PocketLoad;
use drift::{drift_acceleration, glide, push};
use friction::{Friction, friction, in_inertial_axes, inverse_with_held, ring_in_ball_axes};
use nalgebra::{Matrix5, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::traction::{PatchTraction, TractionLaw};
use tribodyn_bearing::{BallState, LoadedPatch, LocalSurface, NormalLoads, Side, in_ball_axes};

/// Time in which the common acceleration follows that of the drift, s: some periods of the contact springs, so that it does
/// not feed their vibration back (at a tenth of it the outer ring's acceleration doubles), and short against an orbit.
const SMOOTHING_TIME: f64 = 5e-4;
/// The same for the rings, s: they vibrate at lower frequencies.
const RING_SMOOTHING_TIME: f64 = 5e-3;
/// Steps between new matrices of the rings: they only predict, and turn with the balls by a degree or so.
const RINGS_EVERY: usize = 16;
/// Most steps that a linear traction serves.
const LONGEST_LINEAR: usize = 64;
/// Reach of a linear traction for samples, over that for steps: half a step before a refresh the linear form must not give
/// way to an integral that serves only once.
const BEFORE_REFRESH: f64 = 1.5;
/// Longest step of the drift over the period of the contact springs, as an angle: leapfrog is stable up to 2.
const DRIFT_ANGLE: f64 = 1.4;

/// Memory of the scheme.
#[derive(Debug, Clone, Serialize, Deserialize, PartialEq)]
pub(crate) struct Fast {
    /// Error of the linear traction over the load that a refresh may find.
    linear_error: f64,
    friction: Vec<Friction>,
    contacts: Vec<Contacts>,
    /// Inverse of the rings' masses less what friction gives back, inertial axes: x, y, z of the inner, x, y of the outer.
    rings: Matrix5<f64>,
    /// Steps until that matrix is made anew.
    rings_last: usize,
    /// Step for which the inverses are.
    step: f64,
    /// Accelerations of the drift at the present position, and their smoothed part that the kick takes over.
    drift: Vec<f64>,
    common: Vec<f64>,
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
    azimuth: [f64; 2],
    position: [f64; 2],
    normal: NormalLoads,
    surfaces: [LocalSurface; 2],
}

/// What the kick does to a ball, N and N m.
struct Grip {
    state: BallState,
    /// Traction at inner and outer contact.
    traction: [[f64; 3]; 2],
    moment: [f64; 3],
    watch: Watch,
}

impl Grip {
    fn add<L>(
        &mut self,
        machine: &Machine<L>,
        (k, side): (usize, Side),
        axes: [f64; 2],
        traction: &PatchTraction,
        semi_lateral: f64,
    ) {
        let (force, moment) = in_ball_axes(axes, traction);
        self.traction[k] = force;
        (0..3).for_each(|i| self.moment[i] += moment[i]);
        self.watch.wear[k] = machine.archard(side).rate(traction.wear_integral);
        self.watch.semi_lateral[k] = semi_lateral;
        self.watch.loaded[k] = true;
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
            ready: false,
            stands: Vec::new(),
            refreshed: 0,
            used: 0,
        }
    }

    /// From `y` at `t` over `h`, in place. `highest` is the frequency of the contact springs in Hz.
    pub fn step<L: TractionLaw>(&mut self, machine: &mut Machine<L>, t: f64, y: &mut [f64], h: f64, highest: f64) {
        let pieces = (0.5 * h * TAU * highest / DRIFT_ANGLE).ceil().max(1.0) as usize;
        self.drift(machine, t, y, 0.5 * h, pieces);
        self.kick(machine, t + 0.5 * h, y, h);
        self.drift(machine, t + 0.5 * h, y, 0.5 * h, pieces);
    }

    fn drift<L: TractionLaw>(&mut self, machine: &Machine<L>, t: f64, y: &mut [f64], span: f64, pieces: usize) {
        let h = span / pieces as f64;
        if !self.ready {
            self.drift.resize(y.len(), 0.0);
            drift_acceleration(machine, t, y, &mut self.drift, &mut self.stands);
            self.common = self.drift.clone();
            self.ready = true;
        }
        for piece in 0..pieces {
            push(machine, y, (&self.drift, &self.common), 0.5 * h);
            glide(machine, t + piece as f64 * h, y, h);
            drift_acceleration(machine, t + (piece + 1) as f64 * h, y, &mut self.drift, &mut self.stands);
            push(machine, y, (&self.drift, &self.common), 0.5 * h);
        }
    }

    /// Every ball by itself with the rings held, then the rings with what the balls leave, then the balls again by what
    /// the rings moved. The rings receive to the last digit what the balls give.
    fn kick<L: TractionLaw>(&mut self, machine: &mut Machine<L>, t: f64, y: &mut [f64], h: f64) {
        let l = machine.layout;
        let frame = machine.frame(t, y);
        if self.friction.len() != l.balls {
            self.friction.resize(l.balls, Friction::NONE());
            self.contacts.resize(l.balls, Contacts::default());
        }
        // Steps between multiples of one number differ in their last digits.
        let renew = (self.step - h).abs() > 1e-6 * h;
        if renew {
            self.step = h;
        }
        let mut on_rings = self.ring_common(machine);
        let mut cage_torque = 0.0;
        for index in 0..l.balls {
            let at = l.ball(index);
            let b = &mut y[at..][..BALL];
            let grip = self.grip(machine, index, b, &frame, renew);
            let pocket = machine.pocket_load(index, b, &frame);
            cage_torque += pocket.cage_torque;
            machine.watch[index] = grip.watch;
            machine.watch[index].wear[2] = machine.pocket_wear(&pocket);
            let friction = &self.friction[index];
            let common = Vector6::from_column_slice(&self.common[at + VELOCITY..at + BALL]);
            let push = (kick_acceleration(machine, &grip, &pocket, &frame, b[RADIUS]) + common) * h;
            let [change, mean] = [friction.response[0] * push, friction.response[1] * push];
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let [i, o] = grip.traction;
            let force = friction.coupling.tr_mul(&mean) - Vector6::new(i[0], i[1], i[2], o[0], o[1], o[2]);
            let state = &grip.state;
            on_rings += in_inertial_axes(state.azimuth, &force);
        }
        if renew || self.rings_last == 0 {
            self.rings = self.ring_matrix(machine, y, h);
            self.rings_last = RINGS_EVERY;
        }
        self.rings_last -= 1;
        let predicted = self.rings * on_rings * h;
        for index in 0..l.balls {
            let b = &mut y[l.ball(index)..][..BALL];
            let azimuth = self.stands[index].azimuth;
            let friction = &self.friction[index];
            let rings = ring_in_ball_axes(azimuth, &predicted);
            let [change, mean] = [friction.follow[0] * rings, friction.follow[1] * rings];
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let force = friction.coupling.tr_mul(&mean) + friction.on_rings(&rings) * 0.5;
            on_rings += in_inertial_axes(azimuth, &force);
        }
        let [inner, outer] = [h / machine.inner.mass, h / machine.outer.mass];
        for k in (0..3).filter(|&k| machine.inner.free[k]) {
            y[l.inner() + 3 + k] += inner * on_rings[k];
        }
        for k in (0..2).filter(|&k| machine.outer.free[k]) {
            y[l.outer() + 2 + k] += outer * on_rings[3 + k];
        }
        y[l.cage() + 1] += h * cage_torque / machine.cage.inertia;
        self.smooth(l, h);
    }

    /// Lets the common acceleration follow that of the drift.
    fn smooth(&mut self, l: Layout, h: f64) {
        let follow = |common: &mut [f64], drift: &[f64], time: f64| {
            let share = (h / time).min(1.0);
            common.iter_mut().zip(drift).for_each(|(c, d)| *c += share * (d - *c));
        };
        let (balls, rings) = self.common.split_at_mut(l.cage());
        follow(balls, &self.drift, SMOOTHING_TIME);
        follow(rings, &self.drift[l.cage()..], RING_SMOOTHING_TIME);
    }

    /// What the kick takes over from the drift of the rings, N.
    fn ring_common<L: TractionLaw>(&self, machine: &Machine<L>) -> Vector5<f64> {
        let l = machine.layout;
        let (i, o) = (&self.common[l.inner() + 3..], &self.common[l.outer() + 2..]);
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        Vector5::new(inner * i[0], inner * i[1], inner * i[2], outer * o[0], outer * o[1])
    }

    /// Traction of a patch of ball `index` from the linear form where that holds, for samples.
    pub fn traction<L: TractionLaw>(
        &self,
        machine: &Machine<L>,
        index: usize,
        patch: &LoadedPatch<'_, f64, L>,
    ) -> PatchTraction {
        let linear = self.contacts.get(index).map(|c| &c.of[usize::from(!patch.is_inner(&machine.bearing))]);
        let (load, radius) = (load_of(patch), patch.patch.ball_radius);
        linear
            .and_then(|linear| linear.at(&patch.motion, load, (patch.bare, BEFORE_REFRESH), radius))
            .unwrap_or_else(|| machine.kernel.traction(&machine.bearing, patch))
    }

    /// Contacts integrated over their patch, and contacts used.
    pub fn patches(&self) -> [u64; 2] {
        [self.refreshed, self.used]
    }

    /// Traction on a ball from its linear form where that still holds, else integrated and linearised anew.
    fn grip<L: TractionLaw>(
        &mut self,
        machine: &Machine<L>,
        index: usize,
        b: &[f64],
        frame: &Frame,
        renew: bool,
    ) -> Grip {
        let bearing = &machine.bearing;
        let stand = &self.stands[index];
        let state = BallState {
            azimuth: stand.azimuth,
            position: stand.position,
            velocity: [b[VELOCITY], b[VELOCITY + 1]],
            orbital_speed: b[ORBIT],
            spin: [b[SPIN], b[SPIN + 1], b[SPIN + 2]],
        };
        self.used += 2;
        let contacts = &mut self.contacts[index];
        contacts.age += 1;
        let mut grip = Grip { state, traction: [[0.0; 3]; 2], moment: [0.0; 3], watch: Watch::default() };
        let mut holds = !renew && contacts.age <= LONGEST_LINEAR;
        for (k, (side, normal)) in
            [(Side::Inner, &stand.normal.inner), (Side::Outer, &stand.normal.outer)].into_iter().enumerate()
        {
            if !holds || normal.load <= 0.0 {
                continue;
            }
            let axes = normal.pose.normal(side);
            let (motion, _) = bearing.relative_motion(axes, &state, &frame.rings[k], stand.normal.orbit_radius);
            let linear = &contacts.of[k];
            let traction =
                linear.at(&motion, normal.load, (stand.surfaces[k].bare, 1.0), bearing.geometry.ball_radius());
            holds = traction.is_some();
            if let Some(traction) = traction {
                grip.add(machine, (k, side), axes, &traction, linear.semi_lateral());
            }
        }
        if holds {
            return grip;
        }
        self.refreshed += 2;
        let tolerance = self.linear_error;
        let (rings, surfaces) = ([&frame.rings[0], &frame.rings[1]], stand.surfaces.each_ref());
        let loads = bearing.ball_loads_with(&state, rings, surfaces, |patch| {
            contacts.of[usize::from(!patch.is_inner(bearing))].refresh(machine, patch, tolerance)
        });
        contacts.age = 0;
        self.friction[index] = friction(machine, &state, &loads, &contacts.of, b[RADIUS], self.step);
        let mut grip = Grip { state, traction: [[0.0; 3]; 2], moment: [0.0; 3], watch: Watch::default() };
        for (k, (side, c)) in [(Side::Inner, &loads.inner), (Side::Outer, &loads.outer)].into_iter().enumerate() {
            if c.load > 0.0 {
                grip.add(machine, (k, side), c.pose.normal(side), &c.traction, c.ellipse.semi_lateral());
            }
        }
        grip
    }

    fn ring_matrix<L: TractionLaw>(&self, machine: &Machine<L>, y: &[f64], h: f64) -> Matrix5<f64> {
        let (inner, outer) = (machine.inner.mass, machine.outer.mass);
        let mut sum = Matrix5::from_diagonal(&Vector5::new(inner, inner, inner, outer, outer));
        for (index, f) in self.friction.iter().enumerate() {
            let (sin, cos) = y[machine.layout.ball(index) + AZIMUTH].sin_cos();
            let given_back = f.coupling.tr_mul(&f.follow[1]);
            for column in 0..5 {
                let unit = ring_in_ball_axes([sin, cos], &Vector5::ith(column, 1.0));
                let force = in_inertial_axes([sin, cos], &((given_back * unit + f.on_rings(&unit) * 0.5) * h));
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

/// Accelerations of a ball by all that the drift leaves out: traction, drag, churning, pocket and gyroscopic moment.
fn kick_acceleration<L: TractionLaw>(
    machine: &Machine<L>,
    grip: &Grip,
    pocket: &PocketLoad,
    frame: &Frame,
    r: f64,
) -> Vector6<f64> {
    let (m, j) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
    let ([i, o], s) = (grip.traction, &grip.state);
    let (drag, churning) = machine.bearing.fluid_loads(s, r, frame.rings[0].speed);
    let w = s.orbital_speed;
    let along = i[2] + o[2] - drag + pocket.force * machine.cage.pocket.radius / r;
    Vector6::new(
        (i[0] + o[0] + pocket.friction[0]) / m,
        (i[1] + o[1] + pocket.friction[1]) / m,
        along / (m * r),
        (grip.moment[0] + churning[0] + pocket.moment[0]) / j,
        (grip.moment[1] + churning[1] + pocket.moment[1]) / j + w * s.spin[2],
        (grip.moment[2] + churning[2]) / j - w * s.spin[1],
    )
}
