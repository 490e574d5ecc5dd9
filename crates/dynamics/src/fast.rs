//! The fast fixed-step scheme: contact springs explicit and in short steps, friction once a step and linearly implicit.
//!
//! One step of length H is the symmetric composition drift(H/2), kick(H), drift(H/2):
//!
//! - The drift moves balls, rings and cage under contact forces, supports and loads, by the leapfrog method in
//!   polar coordinates, with the angular momentum m r² ω_m held while the radius changes. It needs no traction and costs little, so it may take several steps of its own.
//! - The kick changes the velocities v of each ball by traction, drag, churning, pocket and gyroscopic moment f at fixed position:
//!   v ← v + H (1 − ½ H A)⁻¹ f(v). With A = ∂f/∂v this is Rosenbrock's method of second order with one stage, stable for any
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
//! Both parts are of second order and the composition is symmetric, so the scheme is of second order down to that error.
//! Its error against a converged run is measured in `cargo xtask bench`.
//!
//! Sources: splitting, Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, chapters II.5 and VIII.4
//! (impulse method); H. H. Rosenbrock, Comput. J. 5 (1963) 329, doi:10.1093/comjnl/5.4.329.

use crate::forces::{Frame, Sums, Watch};
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, SPIN, VELOCITY};
use crate::linear::{Contacts, LINEAR_ERROR, LinearTraction, load_of};
use crate::machine::Machine;
use crate::pocket::PocketLoad;
use nalgebra::{Matrix5, Matrix6, SMatrix, Vector5, Vector6};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::traction::{PatchTraction, TractionLaw};
use tribodyn_bearing::{BallLoads, BallState, LoadedPatch, LocalSurface, NormalLoads, Side, in_ball_axes};

/// Time in which the common acceleration follows that of the drift, s: some periods of the contact springs, so that it does
/// not feed their vibration back (at a tenth of it the outer ring's acceleration doubles), and short against an orbit.
const SMOOTHING_TIME: f64 = 5e-4;
/// Steps between new matrices of the rings: they only predict, and turn with the balls by a degree or so.
const RINGS_EVERY: usize = 16;
/// Most steps that a linear traction serves.
const LONGEST_LINEAR: usize = 64;
/// Longest step of the drift over the period of the contact springs, as an angle: leapfrog is stable up to 2.
const DRIFT_ANGLE: f64 = 1.0;

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

/// Friction of one ball linearised: S is the stiffness of a patch, G and R its motion by the velocities of ball and ring;
/// ring velocities are (a, r, t) of the inner ring and of the outer, in the ball's azimuth frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Friction {
    /// (1 − ½ H A)⁻¹.
    inverse: Matrix6<f64>,
    /// Gᵀ S R: force on the ball by ring velocities.
    coupling: Matrix6<f64>,
    /// Rᵀ S R of both contacts: force on a ring by its own velocity.
    own: Matrix6<f64>,
    /// Change of the ball's velocities with the rings', (1 − ½ H A)⁻¹ ½ H M⁻¹ Gᵀ S R.
    follow: Matrix6<f64>,
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

impl Friction {
    const NONE: fn() -> Self = || Self {
        inverse: Matrix6::identity(),
        coupling: Matrix6::zeros(),
        own: Matrix6::zeros(),
        follow: Matrix6::zeros(),
    };
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
        let mut on_rings = Vector5::zeros();
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
            let change =
                friction.inverse * (kick_acceleration(machine, &grip, &pocket, &frame, b[RADIUS]) + common) * h;
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let [i, o] = grip.traction;
            let force = friction.coupling.tr_mul(&change) * 0.5 - Vector6::new(i[0], i[1], i[2], o[0], o[1], o[2]);
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
            let (sin, cos) = b[AZIMUTH].sin_cos();
            let friction = &self.friction[index];
            let rings = ring_in_ball_axes([sin, cos], &predicted);
            let change = friction.follow * rings;
            b[VELOCITY..].iter_mut().zip(change.iter()).for_each(|(v, c)| *v += c);
            let force = (friction.coupling.tr_mul(&change) + friction.own * rings) * 0.5;
            on_rings += in_inertial_axes([sin, cos], &force);
        }
        let [inner, outer] = [h / machine.inner.mass, h / machine.outer.mass];
        for k in (0..3).filter(|&k| machine.inner.free[k]) {
            y[l.inner() + 3 + k] += inner * on_rings[k];
        }
        for k in (0..2).filter(|&k| machine.outer.free[k]) {
            y[l.outer() + 2 + k] += outer * on_rings[3 + k];
        }
        y[l.cage() + 1] += h * cage_torque / machine.cage.inertia;
        self.smooth(h / SMOOTHING_TIME);
    }

    /// Lets the common acceleration follow that of the drift.
    fn smooth(&mut self, share: f64) {
        for (common, drift) in self.common.iter_mut().zip(&self.drift) {
            *common += share.min(1.0) * (drift - *common);
        }
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
        match linear.filter(|linear| linear.holds(&patch.motion, load, radius)) {
            Some(linear) => linear.traction(&patch.motion, load),
            None => machine.kernel.traction(&machine.bearing, patch),
        }
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
            holds = linear.holds(&motion, normal.load, bearing.geometry.ball_radius());
            let traction = linear.traction(&motion, normal.load);
            grip.add(machine, (k, side), axes, &traction, linear.semi_lateral());
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
            let given_back = (f.own + f.coupling.tr_mul(&f.follow)) * (0.5 * h);
            for column in 0..5 {
                let unit = Vector5::ith(column, 1.0);
                let force = in_inertial_axes([sin, cos], &(given_back * ring_in_ball_axes([sin, cos], &unit)));
                let mut slot = sum.column_mut(column);
                slot -= force;
            }
        }
        let free = [&machine.inner.free[..], &machine.outer.free[..]].concat();
        for k in (0..5).filter(|&k| !free[k]) {
            sum.row_mut(k).fill(0.0);
            sum.column_mut(k).fill(0.0);
            sum[(k, k)] = f64::INFINITY;
        }
        inverse_with_held(sum)
    }
}

/// Inverse of a matrix in which an infinite diagonal element stands for an axis that is held.
fn inverse_with_held(mut sum: Matrix5<f64>) -> Matrix5<f64> {
    let held: Vec<usize> = (0..5).filter(|&k| sum[(k, k)].is_infinite()).collect();
    held.iter().for_each(|&k| sum[(k, k)] = 1.0);
    let mut inverse = sum.try_inverse().unwrap_or_else(Matrix5::zeros);
    held.iter().for_each(|&k| inverse[(k, k)] = 0.0);
    inverse
}

/// (a, r, t) of inner and outer ring as (x, y, z) and (x, y).
fn in_inertial_axes([sin, cos]: [f64; 2], v: &Vector6<f64>) -> Vector5<f64> {
    Vector5::new(
        v[1] * cos - v[2] * sin,
        v[1] * sin + v[2] * cos,
        v[0],
        v[4] * cos - v[5] * sin,
        v[4] * sin + v[5] * cos,
    )
}

/// The other way round.
fn ring_in_ball_axes([sin, cos]: [f64; 2], v: &Vector5<f64>) -> Vector6<f64> {
    Vector6::new(
        v[2],
        v[0] * cos + v[1] * sin,
        v[1] * cos - v[0] * sin,
        0.0,
        v[3] * cos + v[4] * sin,
        v[4] * cos - v[3] * sin,
    )
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

/// Accelerations of balls, rings and cage by contact forces, supports, loads and the centrifugal force; of
/// the orbital speed, the rate of the angular momentum over m r². The centrifugal force is here and not in the glide so
/// that dampers see the velocity of the middle of a step and not half a step of it.
fn drift_acceleration<L: TractionLaw>(machine: &Machine<L>, t: f64, y: &[f64], a: &mut [f64], stands: &mut Vec<Stand>) {
    let l = machine.layout;
    stands.clear();
    let frame = machine.frame(t, y);
    let m = machine.bearing.ball_mass;
    let mut sums = Sums::default();
    for index in 0..l.balls {
        let b = &y[l.ball(index)..][..BALL];
        let (state, surfaces) = machine.ball_state(b, &frame);
        let normal =
            machine.bearing.normal_loads(&state, [&frame.rings[0], &frame.rings[1]], [&surfaces[0], &surfaces[1]]);
        stands.push(Stand { azimuth: state.azimuth, position: state.position, normal, surfaces });
        let ([n_a, n_r], [o_a, o_r]) =
            ([normal.inner.pose.sin, normal.inner.pose.cos], [normal.outer.pose.sin, normal.outer.pose.cos]);
        let (i, o) = (normal.inner.force, normal.outer.force);
        let at = l.ball(index);
        let r = normal.orbit_radius;
        a[at + VELOCITY] = (i * n_a - o * o_a) / m;
        a[at + VELOCITY + 1] = (i * n_r - o * o_r) / m + r * b[ORBIT] * b[ORBIT];
        a[at + ORBIT] = normal.eccentricity / (m * r);
        let on_inner = inertial(state.azimuth, [i * n_a, i * n_r, 0.0]);
        let on_outer = inertial(state.azimuth, [-o * o_a, -o * o_r, 0.0]);
        for k in 0..3 {
            sums.on_rings[0][k] -= on_inner[k];
            sums.on_rings[1][k] -= on_outer[k];
        }
    }
    let bodies = machine.bodies(t, &frame, &sums);
    a[l.cage() + 1] = bodies.cage;
    a[l.inner() + 3..l.inner() + 6].copy_from_slice(&bodies.inner);
    a[l.outer() + 2..l.outer() + 4].copy_from_slice(&bodies.outer);
}

/// Velocities by the drift's accelerations.
fn push<L>(machine: &Machine<L>, y: &mut [f64], (a, common): (&[f64], &[f64]), h: f64) {
    let l = machine.layout;
    for index in 0..l.balls {
        let at = l.ball(index);
        for k in at + VELOCITY..=at + ORBIT {
            y[k] += h * (a[k] - common[k]);
        }
    }
    y[l.cage() + 1] += h * a[l.cage() + 1];
    for k in (l.inner() + 3..l.inner() + 6).chain(l.outer() + 2..l.outer() + 4) {
        y[k] += h * a[k];
    }
}

/// Positions by the velocities: half a turn, the straight line, half a turn, the angular momentum held.
fn glide<L>(machine: &Machine<L>, t: f64, y: &mut [f64], h: f64) {
    let l = machine.layout;
    for index in 0..l.balls {
        let b = &mut y[l.ball(index)..][..BALL];
        let r = b[RADIUS];
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
        b[AXIAL] += h * b[VELOCITY];
        b[RADIUS] += h * b[VELOCITY + 1];
        b[ORBIT] *= (r / b[RADIUS]).powi(2);
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
    }
    y[l.cage()] += h * y[l.cage() + 1];
    for k in l.inner()..l.inner() + 3 {
        y[k] += h * y[k + 3];
    }
    for k in l.outer()..l.outer() + 2 {
        y[k] += h * y[k + 2];
    }
    // Prescribed speeds: the middle of the step is exact for speeds that change in proportion to time.
    for (k, speed) in machine.speeds.iter().enumerate() {
        y[l.angles() + k] += h * speed.at(t + 0.5 * h);
    }
}

/// [a, r, t] at an azimuth as (x, y, z).
fn inertial([sin, cos]: [f64; 2], [a, r, t]: [f64; 3]) -> [f64; 3] {
    [r * cos - t * sin, r * sin + t * cos, a]
}

/// The friction of a ball, linearised for a step of `h`.
fn friction<L: TractionLaw>(
    machine: &Machine<L>,
    state: &BallState,
    loads: &BallLoads,
    contacts: &[LinearTraction; 2],
    r: f64,
    h: f64,
) -> Friction {
    let mut jacobian = Matrix6::zeros();
    let (mut coupling, mut own) = (Matrix6::zeros(), Matrix6::zeros());
    for (k, (side, contact)) in [(Side::Inner, &loads.inner), (Side::Outer, &loads.outer)].into_iter().enumerate() {
        let stiffness = if contact.load > 0.0 { contacts[k].stiffness() } else { Matrix5::zeros() };
        let (by_ball, by_ring) = patch_motion(contact.pose.normal(side), r);
        let force = stiffness * by_ball;
        jacobian += by_ball.tr_mul(&force);
        coupling.fixed_view_mut::<6, 3>(0, 3 * k).copy_from(&force.tr_mul(&by_ring));
        own.fixed_view_mut::<3, 3>(3 * k, 3 * k).copy_from(&by_ring.tr_mul(&(stiffness * by_ring)));
    }
    let (m, j) = (machine.bearing.ball_mass, machine.bearing.ball_inertia);
    let mobility = Vector6::new(1.0 / m, 1.0 / m, 1.0 / (m * r * r), 1.0 / j, 1.0 / j, 1.0 / j);
    let mut a = Matrix6::from_diagonal(&mobility) * jacobian;
    // The gyroscopic moment, ω_m (Ω_t e_r − Ω_r e_t).
    a[(4, 5)] += state.orbital_speed;
    a[(4, 2)] += state.spin[2];
    a[(5, 4)] -= state.orbital_speed;
    a[(5, 2)] -= state.spin[1];
    // Friction only ever damps; a matrix that cannot be inverted is not one of friction.
    let inverse = (Matrix6::identity() - a * (0.5 * h)).try_inverse().unwrap_or_else(Matrix6::identity);
    let follow = inverse * Matrix6::from_diagonal(&mobility) * coupling * (0.5 * h);
    Friction { inverse, coupling, own, follow }
}

/// Motion of a patch (rolling, lateral, spin, about lateral, about rolling) by the six velocities of the ball and by the
/// translation (a, r, t) of the ring.
fn patch_motion([n_a, n_r]: [f64; 2], r: f64) -> (SMatrix<f64, 5, 6>, SMatrix<f64, 5, 3>) {
    #[rustfmt::skip]
    let by_ball = SMatrix::<f64, 5, 6>::from_row_slice(&[
        0.0, 0.0, r, 0.0, 0.0, 0.0,
        n_r, -n_a, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, n_a, n_r, 0.0,
        0.0, 0.0, 0.0, n_r, -n_a, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    ]);
    #[rustfmt::skip]
    let by_ring = SMatrix::<f64, 5, 3>::from_row_slice(&[
        0.0, 0.0, -1.0,
        -n_r, n_a, 0.0,
        0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
        0.0, 0.0, 0.0,
    ]);
    (by_ball, by_ring)
}
