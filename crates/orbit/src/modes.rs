//! Natural modes of a bearing in its steady orbit: the equations of motion of balls, cage and rings made linear where
//! they stand at one instant, and the eigenvalues of their matrix.
//!
//! ```text
//! dy/dt = f(y),  A = df/dy,  A v = λ v:   frequency |Im λ|/2π,  damping ratio −Re λ/|λ|,  unstable where Re λ > 0
//! ```
//!
//! The matrix changes while balls pass; with the balls' azimuths frozen the modes are those of that instant. A mode
//! that grows at one instant dies out at the next: what becomes of a disturbance in the long run the multipliers of the
//! orbit over a whole turn say.

use crate::OrbitError;
use crate::attempt::{Problem, found, prepared};
use crate::collocation::Orbit;
use crate::damping::KEEPS;
use crate::newton::Newton;
use crate::settings::OrbitSettings;
use crate::solved::OrbitStart;
use crate::system::{BALL, OrbitSystem, SPIN, VELOCITY};
use faer::Mat;
use nalgebra::SVector;
use num_dual::DualSVec64;
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_bearing::{
    Bearing, CageBody, LoadedPatch, OperatingPoint, Races, RingFreedom, RingState, Support, Supports,
};

/// Masses of all that moves besides the balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bodies {
    /// The cage with its own damping, which an orbit may have raised.
    pub cage: CageBody,
    /// Damping ratio of the ball–race contacts.
    pub contact_damping: f64,
    /// Masses and supports of the rings.
    pub supports: Supports,
}

/// Natural modes of a bearing, and what becomes of a small disturbance of its orbit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitModes {
    /// By growing frequency, with pocket 0 of the cage at azimuth 0.
    pub modes: Vec<Mode>,
    /// Largest modulus of a Floquet multiplier: what is left, a turn of the cage later, of a small disturbance of a
    /// ball while cage and rings keep to the orbit. Above 1 it grows.
    pub multiplier: f64,
    /// The same as a rate, 1/s.
    pub growth_rate_per_s: f64,
    /// Sentences on what makes them doubtful.
    pub warnings: Vec<String>,
}

/// One natural mode: a pair of complex eigenvalues.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mode {
    /// Frequency of the damped oscillation, Hz.
    pub frequency_hz: f64,
    /// Damping ratio; negative where the mode grows at the instant it belongs to, 0 where it cannot be told from
    /// rounding.
    pub damping_ratio: f64,
    /// Real part of the eigenvalue, 1/s; positive where the mode grows at that instant, 0 where it cannot be told from
    /// rounding.
    pub growth_rate_per_s: f64,
    /// Shares of the kinetic energy of inner ring, outer ring, balls' translation, balls' spin, cage.
    pub energy_shares: EnergyShares,
    /// Amplitudes of the inner ring along x, y, z over the largest of the translations of all bodies.
    pub inner_ring: [f64; 3],
    /// Amplitudes of the outer ring along x, y.
    pub outer_ring: [f64; 2],
    /// Amplitudes of each ball: axial, radial, along the orbit.
    pub balls: Vec<[f64; 3]>,
}

/// Parts of a mode's kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct EnergyShares {
    /// Inner ring.
    pub inner_ring: f64,
    /// Outer ring.
    pub outer_ring: f64,
    /// Ball centres.
    pub balls: f64,
    /// Spin of the balls.
    pub spin: f64,
    /// Cage.
    pub cage: f64,
}

impl EnergyShares {
    /// Part of the rings and the cage; the rest is that of the balls.
    pub fn bodies(&self) -> f64 {
        self.inner_ring + self.outer_ring + self.cage
    }

    /// The largest part by name.
    pub fn leader(&self) -> &'static str {
        let parts = [
            (self.inner_ring, "inner ring"),
            (self.outer_ring, "outer ring"),
            (self.balls, "balls"),
            (self.spin, "ball spin"),
            (self.cage, "cage"),
        ];
        parts.into_iter().fold((0.0, "none"), |best, part| if part.0 > best.0 { part } else { best }).1
    }
}

/// Unknowns besides the balls: cage angle and speed, then displacements and velocities of the rings.
const CAGE: usize = 2;
const INNER: usize = 6;
const OUTER: usize = 4;
const BODIES: usize = CAGE + INNER + OUTER;
const INPUTS: usize = BALL + BODIES;
type Dual = DualSVec64<INPUTS>;

/// Frequency below which a motion counts as one that creeps, Hz.
const CREEP: f64 = 1e-3;
/// Part of the matrix's norm that rounding brings into an eigenvalue.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Natural modes of balls, cage and rings in their steady orbit, at the instant when pocket 0 stands at azimuth 0, and
/// what becomes of a small disturbance over a turn. Balls have the masses, pockets the stiffness and damping of the
/// bearing, whatever the orbit was found with.
///
/// # Errors
/// [`OrbitError::Eigenvalues`].
pub fn orbit_modes(
    bearing: &Bearing,
    point: &OperatingPoint,
    bodies: &Bodies,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<OrbitModes, OrbitError> {
    let mut bearing = prepared(bearing, settings);
    bearing.contact_damping = bodies.contact_damping;
    let problem = Problem { bearing: &bearing, point, cage: &bodies.cage, settings };
    let (mut newton, orbit) = (found(problem, solved)?, &solved.orbit);
    (newton.system.cage, newton.system.settling) = (bodies.cage, 0.0);
    let modes = modes(&newton, orbit, bodies)?;
    let (multiplier, growing) = multiplier(&mut newton, orbit)?;
    let turn = std::f64::consts::TAU / orbit.cage_speed.abs();
    let warnings = solved.sentences().into_iter().chain(growing).collect();
    Ok(OrbitModes { modes, multiplier, growth_rate_per_s: multiplier.ln() / turn, warnings })
}

/// What becomes of a small disturbance of a ball over a turn: the largest multiplier, a sentence where it grows. Where
/// no ball touches its pocket one is 1: a ball may go before or behind as it likes.
fn multiplier(newton: &mut Newton<'_>, orbit: &Orbit) -> Result<(f64, Option<String>), OrbitError> {
    let multiplier = newton.multiplier(orbit)?;
    let grows = (multiplier > KEEPS).then(|| {
        format!(
            "this orbit is unstable: a small deviation of a ball grows {multiplier:.2} times in a turn, so that a run \
             swings about the orbit, and its means differ"
        )
    });
    Ok((multiplier, grows))
}

/// Modes of a converged orbit, with the cage's pocket 0 at azimuth 0, by growing frequency; motions that merely creep
/// are left out.
fn modes(newton: &Newton<'_>, orbit: &Orbit, bodies: &Bodies) -> Result<Vec<Mode>, OrbitError> {
    let mut matrix = matrix(newton, orbit, bodies);
    balance(&mut matrix, newton.system.bearing.geometry.ball_count);
    let eigen = matrix.eigen().map_err(|_| OrbitError::Eigenvalues)?;
    let (values, vectors) = (eigen.S(), eigen.U());
    let rounding = ROUNDING * matrix.norm_l2();
    let mut modes = Vec::new();
    for k in 0..matrix.nrows() {
        let (re, im) = (values[k].re, values[k].im);
        if im <= (TAU * CREEP).max(1e-3 * orbit.cage_speed.abs()) {
            continue;
        }
        let re = if re.abs() <= rounding { 0.0 } else { re };
        let size = |row: usize| vectors[(row, k)].re.hypot(vectors[(row, k)].im);
        modes.push(shape(&newton.system, bodies, (re, im), &size));
    }
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(modes)
}

/// Parts of the kinetic energy of a motion with these amplitudes.
pub(crate) fn energies(system: &OrbitSystem<'_>, bodies: &Bodies, size: &dyn Fn(usize) -> f64) -> EnergyShares {
    let count = system.bearing.geometry.ball_count;
    let edge = BALL * count;
    let (inner, outer) = (edge + CAGE, edge + CAGE + INNER);
    let radius = 0.5 * system.bearing.geometry.pitch_diameter;
    let (m, j) = (system.bearing.ball_mass, system.bearing.ball_inertia);
    let (mut balls, mut spin) = (0.0, 0.0);
    for ball in 0..count {
        let at = |k: usize| size(BALL * ball + k);
        balls += m * (at(VELOCITY).powi(2) + at(VELOCITY + 1).powi(2) + (radius * at(VELOCITY + 2)).powi(2));
        spin += j * (0..3).map(|k| at(SPIN + k).powi(2)).sum::<f64>();
    }
    let cage = bodies.cage.inertia * size(edge + 1).powi(2);
    let inner_ring = bodies.supports.inner.mass * (0..3).map(|k| size(inner + 3 + k).powi(2)).sum::<f64>();
    let outer_ring = bodies.supports.outer.mass * (0..2).map(|k| size(outer + 2 + k).powi(2)).sum::<f64>();
    let total = (balls + spin + cage + inner_ring + outer_ring).max(f64::MIN_POSITIVE);
    EnergyShares {
        inner_ring: inner_ring / total,
        outer_ring: outer_ring / total,
        balls: balls / total,
        spin: spin / total,
        cage: cage / total,
    }
}

fn shape(system: &OrbitSystem<'_>, bodies: &Bodies, (re, im): (f64, f64), size: &dyn Fn(usize) -> f64) -> Mode {
    let count = system.bearing.geometry.ball_count;
    let edge = BALL * count;
    let (inner, outer) = (edge + CAGE, edge + CAGE + INNER);
    let radius = 0.5 * system.bearing.geometry.pitch_diameter;
    let energy_shares = energies(system, bodies, size);
    let mut inner_ring: [f64; 3] = std::array::from_fn(|k| size(inner + k));
    let mut outer_ring: [f64; 2] = std::array::from_fn(|k| size(outer + k));
    let mut balls: Vec<[f64; 3]> =
        (0..count).map(|b| [size(BALL * b), size(BALL * b + 1), radius * size(BALL * b + 2)]).collect();
    let all = inner_ring.iter().chain(&outer_ring).chain(balls.iter().flatten());
    let largest = all.fold(f64::MIN_POSITIVE, |m, v| m.max(*v));
    inner_ring.iter_mut().chain(&mut outer_ring).chain(balls.iter_mut().flatten()).for_each(|v| *v /= largest);
    let modulus = re.hypot(im);
    Mode {
        frequency_hz: im / TAU,
        damping_ratio: if re == 0.0 { 0.0 } else { -re / modulus },
        growth_rate_per_s: re,
        energy_shares,
        inner_ring,
        outer_ring,
        balls,
    }
}

/// df/dy of balls, cage and rings.
fn matrix(newton: &Newton<'_>, orbit: &Orbit, bodies: &Bodies) -> Mat<f64> {
    let system = &newton.system;
    let count = system.bearing.geometry.ball_count;
    let edge = BALL * count;
    let mut a = Mat::<f64>::zeros(edge + BODIES, edge + BODIES);
    let (inner, outer) = (edge + CAGE, edge + CAGE + INNER);
    a[(edge, edge + 1)] = 1.0;
    let speeds = newton.system.speeds.map(num_dual::Dual64::from);
    let (_, braking): (f64, f64) = num_dual::first_derivative(
        |speed| {
            let [guidance, drag] = bodies.cage.fluid_torques(speed, speeds);
            guidance + drag
        },
        orbit.cage_speed,
    );
    let inertia = bodies.cage.inertia;
    let cage_moves = inertia > 0.0;
    if cage_moves {
        a[(edge + 1, edge + 1)] = braking / inertia;
    }
    for ball in 0..count {
        let turn = system.turn(TAU * ball as f64 / count as f64);
        let e = derivatives(newton, orbit, bodies, turn);
        let place = |c: usize| if c < BALL { BALL * ball + c } else { edge + c - BALL };
        for c in 0..INPUTS {
            (0..BALL).for_each(|k| a[(BALL * ball + k, place(c))] += e.rate[k][c]);
            if cage_moves {
                a[(edge + 1, place(c))] += e.cage[c] / inertia;
            }
            (0..3).for_each(|k| a[(inner + 3 + k, place(c))] -= e.inner[k][c] / bodies.supports.inner.mass);
            (0..2).for_each(|k| a[(outer + 2 + k, place(c))] -= e.outer[k][c] / bodies.supports.outer.mass);
        }
    }
    let free = |k: usize| !matches!(newton.system.ring[k], RingFreedom::Held(_));
    support(&mut a, inner, &bodies.supports.inner, std::array::from_fn(free));
    support(&mut a, outer, &bodies.supports.outer, [true; 2]);
    if !cage_moves {
        clear(&mut a, edge);
        clear(&mut a, edge + 1);
    }
    a
}

/// Springs and dampers of a ring whose displacements begin at `at`; an axis that is held does not move.
fn support<const N: usize>(a: &mut Mat<f64>, at: usize, body: &Support<N>, free: [bool; N]) {
    for k in 0..N {
        if free[k] {
            a[(at + k, at + N + k)] = 1.0;
            a[(at + N + k, at + k)] -= body.stiffness[k] / body.mass;
            a[(at + N + k, at + N + k)] -= body.damping[k] / body.mass;
        } else {
            clear(a, at + k);
            clear(a, at + N + k);
        }
    }
}

/// A frequency between those of rings and of contacts, rad/s: displacements are counted in velocities over it, so
/// that stiffness over mass does not drown the small entries.
const MIDDLE: f64 = 3e4;

fn balance(a: &mut Mat<f64>, count: usize) {
    let edge = BALL * count;
    let (inner, outer) = (edge + CAGE, edge + CAGE + INNER);
    let of_balls = (0..count).flat_map(|ball| (0..VELOCITY).map(move |k| BALL * ball + k));
    for at in of_balls.chain([edge]).chain(inner..inner + 3).chain(outer..outer + 2) {
        for k in 0..a.nrows() {
            a[(at, k)] *= MIDDLE;
            a[(k, at)] /= MIDDLE;
        }
    }
}

/// Takes an unknown out.
fn clear(a: &mut Mat<f64>, at: usize) {
    for k in 0..a.nrows() {
        a[(at, k)] = 0.0;
        a[(k, at)] = 0.0;
    }
}

/// Slopes of all that a ball does.
struct Slopes {
    rate: [[f64; INPUTS]; BALL],
    cage: [f64; INPUTS],
    inner: [[f64; INPUTS]; 3],
    outer: [[f64; INPUTS]; 2],
}

fn derivatives(newton: &Newton<'_>, orbit: &Orbit, bodies: &Bodies, turn: f64) -> Slopes {
    let mut bearing = newton.system.bearing.clone();
    bearing.contact_damping = bodies.contact_damping;
    let held = &newton.system;
    let system = OrbitSystem {
        bearing: &bearing,
        surfaces: held.surfaces,
        cage: bodies.cage,
        speeds: held.speeds,
        ring: held.ring,
        kernel: held.kernel.clone(),
        origin: held.origin,
        direction: held.direction,
        centring: 0.0,
        settling: 0.0,
        held: None,
    };
    let seed = |value: f64, k: usize| {
        let mut direction = SVector::<f64, INPUTS>::zeros();
        direction[k] = 1.0;
        Dual::new(value, num_dual::Derivative::some(direction))
    };
    let y = orbit.at(&newton.radau, turn);
    // The azimuth takes the place of the lead, from which the cage's angle is taken off.
    let mut unknowns: [Dual; BALL] = std::array::from_fn(|k| seed(y[k], k));
    let cage_angle = seed(0.0, BALL);
    unknowns[2] -= cage_angle;
    let pocket = cage_angle + system.azimuth(turn);
    let cage_speed = seed(orbit.cage_speed, BALL + 1);
    let [x, vx] = [BALL + CAGE, BALL + CAGE + 3];
    let [ox, ov] = [BALL + CAGE + INNER, BALL + CAGE + INNER + 2];
    let inner = RingState {
        displacement: std::array::from_fn(|k| seed(orbit.ring[k], x + k)),
        tilt: [orbit.ring[3].into(), orbit.ring[4].into()],
        velocity: std::array::from_fn(|k| seed(0.0, vx + k)),
        speed: system.speeds.inner.into(),
        turning: None,
    };
    let outer = RingState {
        displacement: [seed(0.0, ox), seed(0.0, ox + 1), 0.0.into()],
        tilt: [0.0.into(); 2],
        velocity: [seed(0.0, ov), seed(0.0, ov + 1), 0.0.into()],
        speed: system.speeds.outer.into(),
        turning: None,
    };
    let traction = |patch: &LoadedPatch<'_, Dual>| bearing.linear_traction(patch, &system.kernel);
    let e = system.ball(pocket, &unknowns, cage_speed, &Races { inner, outer }, traction);
    let slope = |value: &Dual| -> [f64; INPUTS] {
        value.eps.unwrap_generic(nalgebra::Const::<INPUTS>, nalgebra::Const::<1>).into()
    };
    let mut rate = e.rate.each_ref().map(slope);
    // The azimuth runs at the orbital speed, whatever the cage does.
    rate[2][BALL + 1] = 0.0;
    let [fx, fy, fz, ..] = e.ring.each_ref().map(slope);
    Slopes { rate, cage: slope(&e.cage_torque), inner: [fx, fy, fz], outer: e.outer.each_ref().map(slope) }
}
