//! The equations of motion made linear about a steady orbit at one instant: the matrix of the natural modes.

use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::system::{BALL, OrbitSystem, VELOCITY};
use faer::Mat;
use nalgebra::SVector;
use num_dual::DualSVec64;
use std::f64::consts::TAU;
use tribodyn_bearing::{CageBody, LoadedPatch, Races, RingFreedom, RingState, Side, Support, Supports, TiltingRing};

/// Masses of all that moves besides the balls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bodies {
    /// The cage with its own damping, which an orbit may have raised.
    pub cage: CageBody,
    /// Damping ratio of the ball–race contacts.
    pub contact_damping: f64,
    /// Masses and supports of the rings.
    pub supports: Supports,
    /// Inertias and supports of rings that are free to tilt.
    pub tilting: Races<Option<TiltingRing>>,
}

/// Unknowns besides the balls: cage angle and speed, displacements and velocities of the rings, tilts and angular
/// velocities of each ring that is free to tilt.
const CAGE: usize = 2;
const INNER: usize = 6;
const OUTER: usize = 4;
const TILT: usize = 4;
const INPUTS: usize = BALL + CAGE + INNER + OUTER + 2 * TILT;
type Dual = DualSVec64<INPUTS>;

/// Where the unknowns stand in the matrix.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    /// Cage, after the balls.
    pub edge: usize,
    pub inner: usize,
    pub outer: usize,
    pub tilt: Races<Option<usize>>,
    pub len: usize,
}

impl Places {
    pub fn new(balls: usize, bodies: &Bodies) -> Self {
        let edge = BALL * balls;
        let (inner, outer) = (edge + CAGE, edge + CAGE + INNER);
        let mut len = outer + OUTER;
        let tilt = bodies.tilting.map(|body| {
            body.map(|_| {
                len += TILT;
                len - TILT
            })
        });
        Self { edge, inner, outer, tilt, len }
    }

    /// Place of an input of a ball's equations; none for a tilt that is held.
    fn of(&self, ball: usize, input: usize) -> Option<usize> {
        const OF_TILTS: usize = BALL + CAGE + INNER + OUTER;
        match input {
            0..BALL => Some(BALL * ball + input),
            BALL..OF_TILTS => Some(self.edge + input - BALL),
            _ => {
                let side = if input < OF_TILTS + TILT { Side::Inner } else { Side::Outer };
                self.tilt[side].map(|at| at + (input - OF_TILTS) % TILT)
            }
        }
    }
}

/// df/dy of balls, cage and rings.
pub(crate) fn matrix(newton: &Newton<'_>, orbit: &Orbit, bodies: &Bodies, places: &Places) -> Mat<f64> {
    let system = &newton.system;
    let count = system.bearing.geometry.ball_count;
    let Places { edge, inner, outer, tilt, len } = *places;
    let mut a = Mat::<f64>::zeros(len, len);
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
        for c in 0..INPUTS {
            let Some(place) = places.of(ball, c) else { continue };
            (0..BALL).for_each(|k| a[(BALL * ball + k, place)] += e.rate[k][c]);
            if cage_moves {
                a[(edge + 1, place)] += e.cage[c] / inertia;
            }
            (0..3).for_each(|k| a[(inner + 3 + k, place)] -= e.inner[k][c] / bodies.supports.inner.mass);
            (0..2).for_each(|k| a[(outer + 2 + k, place)] -= e.outer[k][c] / bodies.supports.outer.mass);
            for (side, body) in bodies.tilting.iter() {
                let Some((at, body)) = tilt[side].zip(body.as_ref()) else { continue };
                (0..2).for_each(|k| a[(at + 2 + k, place)] -= e.moments[side][k][c] / body.transverse_inertia);
            }
        }
    }
    let free = |k: usize| !matches!(newton.system.ring[k], RingFreedom::Held(_));
    support(&mut a, inner, &bodies.supports.inner, std::array::from_fn(free));
    support(&mut a, outer, &bodies.supports.outer, [true; 2]);
    for (side, body) in bodies.tilting.iter() {
        let Some((at, body)) = tilt[side].zip(body.as_ref()) else { continue };
        let TiltingRing { polar_inertia, transverse_inertia: mass, stiffness, damping, .. } = *body;
        support(&mut a, at, &Support { mass, stiffness, damping }, [true; 2]);
        // The moment −I_p Ω ω × e.
        let gyroscopic = polar_inertia / mass * system.speeds[side];
        a[(at + 2, at + 3)] -= gyroscopic;
        a[(at + 3, at + 2)] += gyroscopic;
    }
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

pub(crate) fn balance(a: &mut Mat<f64>, places: &Places) {
    let Places { edge, inner, outer, tilt, .. } = *places;
    let of_balls = (0..edge).filter(|at| at % BALL < VELOCITY);
    let of_tilts = [tilt.inner, tilt.outer].into_iter().flatten().flat_map(|at| at..at + 2);
    for at in of_balls.chain([edge]).chain(inner..inner + 3).chain(outer..outer + 2).chain(of_tilts) {
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
    /// Moments of the rings on the ball about x and y.
    moments: Races<[[f64; INPUTS]; 2]>,
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
    let rings = rings(&system, orbit, bodies, &seed);
    let traction = |patch: &LoadedPatch<'_, Dual>| bearing.linear_traction(patch, &system.kernel);
    let e = system.ball(pocket, &unknowns, cage_speed, &rings, traction);
    let slope = |value: &Dual| -> [f64; INPUTS] {
        value.eps.unwrap_generic(nalgebra::Const::<INPUTS>, nalgebra::Const::<1>).into()
    };
    let mut rate = e.rate.each_ref().map(slope);
    // The azimuth runs at the orbital speed, whatever the cage does.
    rate[2][BALL + 1] = 0.0;
    let [fx, fy, fz, ..] = e.ring.each_ref().map(slope);
    let moments = Races::from_fn(|side| {
        let contact = (&e.loads.contacts[side], e.loads.orbit_radius);
        let [x, y, _] = e.state.frame.to_inertial(bearing.ring_moment(side, &e.state, contact, &rings[side]));
        [slope(&x), slope(&y)]
    });
    Slopes { rate, cage: slope(&e.cage_torque), inner: [fx, fy, fz], outer: e.outer.each_ref().map(slope), moments }
}

/// Rings at the orbit, with their motion as unknowns; that of the balls and the cage comes first.
fn rings(
    system: &OrbitSystem<'_>,
    orbit: &Orbit,
    bodies: &Bodies,
    seed: &dyn Fn(f64, usize) -> Dual,
) -> Races<RingState<Dual>> {
    let (of_inner, of_outer, zero) = (BALL + CAGE, BALL + CAGE + INNER, Dual::from(0.0));
    let tilts = Races { inner: [orbit.ring[3], orbit.ring[4]], outer: [0.0; 2] };
    let any = bodies.tilting.iter().any(|(_, body)| body.is_some());
    let ring = |side: Side, displacement: [Dual; 3], velocity: [Dual; 3]| {
        let at = BALL + CAGE + INNER + OUTER + TILT * side as usize;
        let tilt: [Dual; 2] = std::array::from_fn(|k| seed(tilts[side][k], at + k));
        let turning = [0, 1].map(|k| seed(0.0, at + 2 + k));
        // Across the ring's axis.
        let along = turning[1] * tilt[0] - turning[0] * tilt[1];
        let tilting = bodies.tilting[side].is_some();
        let held = tilts[side].map(Dual::from);
        RingState {
            displacement,
            tilt: if tilting { tilt } else { held },
            velocity,
            speed: system.speeds[side].into(),
            turning: any.then_some(if tilting { [turning[0], turning[1], along] } else { [zero; 3] }),
        }
    };
    Races {
        inner: ring(
            Side::Inner,
            std::array::from_fn(|k| seed(orbit.ring[k], of_inner + k)),
            std::array::from_fn(|k| seed(0.0, of_inner + 3 + k)),
        ),
        outer: ring(
            Side::Outer,
            [seed(0.0, of_outer), seed(0.0, of_outer + 1), zero],
            [seed(0.0, of_outer + 2), seed(0.0, of_outer + 3), zero],
        ),
    }
}
