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
use crate::modes_matrix::{Bodies, Places, balance, matrix};
use crate::newton::Newton;
use crate::settings::OrbitSettings;
use crate::solved::OrbitStart;
use crate::system::{BALL, OMEGA, OrbitSystem, VELOCITY};
use serde::Serialize;
use std::f64::consts::TAU;
use tribodyn_bearing::{Bearing, OperatingPoint, Races, Side, TiltingRing};

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
    /// Shares of the kinetic energy of inner ring, outer ring, balls' translation, balls' rotation, cage.
    pub energy_shares: EnergyShares,
    /// Amplitudes of the inner ring along x, y, z over the largest of the translations of all bodies.
    pub inner_ring: [f64; 3],
    /// Amplitudes of the outer ring along x, y.
    pub outer_ring: [f64; 2],
    /// Amplitudes of the tilts of an inner ring that is free to tilt, about x, y, times the pitch radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner_tilt: Option<[f64; 2]>,
    /// The same of the outer ring.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outer_tilt: Option<[f64; 2]>,
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
    /// Rotation of the balls.
    pub ball_rotation: f64,
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
            (self.ball_rotation, "ball rotation"),
            (self.cage, "cage"),
        ];
        parts.into_iter().fold((0.0, "none"), |best, part| if part.0 > best.0 { part } else { best }).1
    }
}

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

/// Growth of a small disturbance of a ball over a turn: the largest multiplier, a sentence where it grows. Where no
/// ball touches its pocket one is 1: a ball may go before or behind as it likes.
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
    let places = Places::new(newton.system.bearing.geometry.ball_count, bodies);
    let mut matrix = matrix(newton, orbit, bodies, &places);
    balance(&mut matrix, &places);
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
        modes.push(shape(&newton.system, (bodies, &places), (re, im), &size));
    }
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(modes)
}

/// Parts of the kinetic energy of a motion with these amplitudes.
fn energies(
    system: &OrbitSystem<'_>,
    (bodies, places): (&Bodies, &Places),
    size: &dyn Fn(usize) -> f64,
) -> EnergyShares {
    let count = system.bearing.geometry.ball_count;
    let Places { edge, inner, outer, tilt, .. } = *places;
    let radius = 0.5 * system.bearing.geometry.pitch_diameter;
    let (m, j) = (system.bearing.ball_mass, system.bearing.ball_inertia);
    let (mut balls, mut ball_rotation) = (0.0, 0.0);
    for ball in 0..count {
        let at = |k: usize| size(BALL * ball + k);
        balls += m * (at(VELOCITY).powi(2) + at(VELOCITY + 1).powi(2) + (radius * at(VELOCITY + 2)).powi(2));
        ball_rotation += j * (0..3).map(|k| at(OMEGA + k).powi(2)).sum::<f64>();
    }
    let cage = bodies.cage.inertia * size(edge + 1).powi(2);
    let inner_ring = bodies.supports.inner.mass * (0..3).map(|k| size(inner + 3 + k).powi(2)).sum::<f64>();
    let outer_ring = bodies.supports.outer.mass * (0..2).map(|k| size(outer + 2 + k).powi(2)).sum::<f64>();
    let turning = |side: Side| {
        let turns =
            |(at, body): (usize, TiltingRing)| body.transverse_inertia * (size(at + 2).powi(2) + size(at + 3).powi(2));
        tilt[side].zip(bodies.tilting[side]).map_or(0.0, turns)
    };
    let (inner_ring, outer_ring) = (inner_ring + turning(Side::Inner), outer_ring + turning(Side::Outer));
    let total = (balls + ball_rotation + cage + inner_ring + outer_ring).max(f64::MIN_POSITIVE);
    EnergyShares {
        inner_ring: inner_ring / total,
        outer_ring: outer_ring / total,
        balls: balls / total,
        ball_rotation: ball_rotation / total,
        cage: cage / total,
    }
}

fn shape(
    system: &OrbitSystem<'_>,
    (bodies, places): (&Bodies, &Places),
    (re, im): (f64, f64),
    size: &dyn Fn(usize) -> f64,
) -> Mode {
    let count = system.bearing.geometry.ball_count;
    let Places { inner, outer, tilt, .. } = *places;
    let radius = 0.5 * system.bearing.geometry.pitch_diameter;
    let energy_shares = energies(system, (bodies, places), size);
    let mut inner_ring: [f64; 3] = std::array::from_fn(|k| size(inner + k));
    let mut outer_ring: [f64; 2] = std::array::from_fn(|k| size(outer + k));
    let mut balls: Vec<[f64; 3]> =
        (0..count).map(|b| [size(BALL * b), size(BALL * b + 1), radius * size(BALL * b + 2)]).collect();
    let mut tilts = tilt.map(|at| at.map(|at| [radius * size(at), radius * size(at + 1)]));
    let of_tilts = tilts.iter().flat_map(|(_, tilts)| tilts.iter().flatten());
    let all = inner_ring.iter().chain(&outer_ring).chain(balls.iter().flatten()).chain(of_tilts);
    let largest = all.fold(f64::MIN_POSITIVE, |m, v| m.max(*v));
    let Races { inner: inner_tilt, outer: outer_tilt } = &mut tilts;
    let of_tilts = inner_tilt.iter_mut().chain(outer_tilt).flatten();
    let of_rings = inner_ring.iter_mut().chain(&mut outer_ring);
    of_rings.chain(balls.iter_mut().flatten()).chain(of_tilts).for_each(|v| *v /= largest);
    let modulus = re.hypot(im);
    Mode {
        frequency_hz: im / TAU,
        damping_ratio: if re == 0.0 { 0.0 } else { -re / modulus },
        growth_rate_per_s: re,
        energy_shares,
        inner_ring,
        outer_ring,
        inner_tilt: tilts.inner,
        outer_tilt: tilts.outer,
        balls,
    }
}
