//! From a bearing at an operating point to its steady orbit.

use crate::collocation::{Orbit, Radau};
use crate::modes::{Bodies, Mode, modes};
use crate::newton::{Newton, OrbitStatistics};
use crate::residual::{Residual, Scales};
use crate::solution::{SteadyOrbit, solution};
use crate::stiffness::stiffness;
use crate::system::{BALL, OrbitSystem};
use crate::{OrbitError, mesh, start, statics};
use tribodyn_bearing::{Bearing, CageBody, OperatingPoint, Races, RingOffset};
use tribodyn_quasistatic::{StiffnessMatrix, rolling_start};
use tribodyn_traction::{FastPatch, PatchRule};

/// Stiffness that centres a ball in its pocket over that of the pocket: settles where a cage hangs that no ball
/// touches.
const CENTRING: f64 = 1e-8;
/// The cheap rule on which the neighbourhood of the orbit is found.
const SCOUT: PatchRule = PatchRule::SplitStrip { across: 5, along: 3 };
/// Rounds of sending the balls round and correcting cage and ring.
const ROUNDS: usize = 25;
/// Border residual, over its scales, at which the neighbourhood is found.
const FOUND: f64 = 3e-2;
/// The same where Newton's method on all unknowns takes over from that on cage and ring.
const CLOSE: f64 = 1e-4;
/// Change over the scales at which an interval is solved while the neighbourhood is looked for, and when it is found.
const ROUGHLY: f64 = 1e-4;
const CLOSELY: f64 = 1e-8;
/// Change of cage speed in one round, relative; of the ring, over its scale.
const SPEED_CHANGE: f64 = 0.02;
const RING_CHANGE: f64 = 5.0;
/// Jacobians of a first and of any other attempt on a mesh.
const PATIENCE: usize = 14;
/// Turns in which the balls settle.
const TURNS: usize = 5;
/// Meshes on which the orbit of first order is solved where three points an interval fail.
const FIRST_ORDER: [usize; 3] = [144, 288, 576];

/// Settings of the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitSettings {
    /// Intervals round the orbit, each with three points of collocation.
    pub intervals: usize,
    /// Largest relative residual of any balance.
    pub tolerance: f64,
    /// Damping ratio ζ of the ball–race contacts that the orbit has at least.
    pub contact_damping: f64,
    /// Damping of the pockets that the orbit has at least, as χ of Hunt and Crossley times a hundredth of the orbital
    /// velocity.
    pub pocket_damping: f64,
}

impl Default for OrbitSettings {
    /// 60 intervals, 1e-10; damping that ends the bouncing of idle balls, which has no part in a mean: at a χ v of 10
    /// a ball keeps a tenth of the velocity with which it meets the wall.
    fn default() -> Self {
        Self { intervals: 60, tolerance: 1e-10, contact_damping: 0.1, pocket_damping: 10.0 }
    }
}

/// An orbit to start a neighbouring problem from.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitStart {
    orbit: Orbit,
    rule: PatchRule,
    rule_error: f64,
    speed_error: Option<f64>,
    scales: Scales,
    speeds: Races<f64>,
}

/// A steady orbit with what is needed to go on from it.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedOrbit {
    /// The orbit.
    pub solution: SteadyOrbit,
    /// Statistics of the solver.
    pub statistics: OrbitStatistics,
    /// Start for a neighbouring problem; none for a bearing at rest.
    pub start: Option<OrbitStart>,
}

/// The bearing as the orbit has it: offsets of the rings exact, contacts damped.
fn prepared(bearing: &Bearing, settings: &OrbitSettings) -> Bearing {
    let mut bearing = bearing.clone();
    bearing.ring_offset = RingOffset::Exact;
    bearing.contact_damping = bearing.contact_damping.max(settings.contact_damping);
    bearing
}

fn system<'a>(
    bearing: &'a Bearing,
    (point, cage): (&OperatingPoint, &CageBody),
    (rule, speed): (PatchRule, f64),
    settings: &OrbitSettings,
) -> Result<OrbitSystem<'a>, OrbitError> {
    let mut cage = *cage;
    let slow = 0.01 * (speed * cage.pocket.radius).abs();
    cage.pocket.damping = cage.pocket.damping.max(settings.pocket_damping / slow);
    Ok(OrbitSystem {
        bearing,
        surfaces: bearing.surfaces(),
        speeds: Races { inner: point.inner_speed, outer: point.outer_speed },
        ring: point.ring,
        kernel: FastPatch::new(rule)?,
        direction: speed.signum(),
        centring: CENTRING * cage.pocket.stiffness,
        cage,
    })
}

/// Solves for the steady orbit from a cold start.
///
/// # Errors
/// [`OrbitError::NotConverged`] with the balance that is furthest from being met.
pub fn steady_orbit(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
) -> Result<SolvedOrbit, OrbitError> {
    let bearing = &prepared(bearing, settings);
    let rolling = rolling_start(bearing, point)?;
    let speed = start::cage_speed(&rolling);
    if speed == 0.0 {
        return Ok(statics::at_rest(bearing, point, cage, (&rolling, FastPatch::new(rolling.rule)?)));
    }
    let scales = start::scales(bearing, &point.ring, &rolling, speed);
    let mut newton = Newton::new(system(bearing, (point, cage), (rolling.rule, speed), settings)?, scales);
    let fine = std::mem::replace(&mut newton.system.kernel, FastPatch::new(SCOUT)?);
    newton.radau = Radau::euler();
    let sent = start::sent_round(&newton.system, &newton.scales, &rolling, speed);
    let near = neighbourhood(&mut newton, sent)?;
    newton.system.kernel = fine;
    let found = collocated(&mut newton, &near, settings)?;
    finish(&newton, found, (point, rolling.rule, rolling.rule_error))
}

/// Solves from the orbit of a neighbouring problem, on its mesh and with its patch rule; from a cold start where that
/// fails.
///
/// # Errors
/// As [`steady_orbit`].
pub fn steady_orbit_from(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    near: &OrbitStart,
) -> Result<SolvedOrbit, OrbitError> {
    let warm = prepared(bearing, settings);
    let mut orbit = near.orbit.clone();
    // Rolling is in proportion to the speeds, seen from the outer ring.
    let share = (point.inner_speed - point.outer_speed) / (near.speeds.inner - near.speeds.outer);
    if share.is_finite() && share > 0.0 && share != 1.0 {
        let faster = |w: f64| point.outer_speed + (w - near.speeds.outer) * share;
        orbit.cage_speed = faster(orbit.cage_speed);
        for y in orbit.values.iter_mut().flatten() {
            (BALL - 4..BALL).for_each(|k| y[k] = if k == BALL - 4 { faster(y[k]) } else { y[k] * share });
        }
    }
    let system = system(&warm, (point, cage), (near.rule, orbit.cage_speed), settings)?;
    let mut newton = Newton::new(system, near.scales);
    if orbit.stages == 1 {
        newton.radau = Radau::euler();
    }
    let (orbit, residual) = newton.run(orbit, settings.tolerance, PATIENCE);
    if residual.worst.relative <= settings.tolerance {
        let found = Found { orbit, residual, speed_error: near.speed_error };
        return finish(&newton, found, (point, near.rule, near.rule_error));
    }
    steady_orbit(bearing, point, cage, settings)
}

/// The solver at a solution.
fn at<'a>(
    bearing: &'a Bearing,
    (point, cage): (&OperatingPoint, &CageBody),
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<Newton<'a>, OrbitError> {
    let system = system(bearing, (point, cage), (solved.rule, solved.orbit.cage_speed), settings)?;
    let mut newton = Newton::new(system, solved.scales);
    if solved.orbit.stages == 1 {
        newton.radau = Radau::euler();
    }
    Ok(newton)
}

/// Stiffness of the inner ring on its steady orbit: mean forces (N) and moments (N m) against displacements x, y, z
/// (m) and tilts (rad), by row; balls and cage condensed.
///
/// # Errors
/// [`OrbitError::Singular`] where a displacement of the ring meets no resistance.
pub fn orbit_stiffness(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<StiffnessMatrix, OrbitError> {
    let bearing = &prepared(bearing, settings);
    stiffness(&mut at(bearing, (point, cage), settings, solved)?, &solved.orbit)
}

/// Natural modes of balls, cage and rings in their steady orbit, at the instant when pocket 0 stands at azimuth 0.
///
/// # Errors
/// [`OrbitError::Eigenvalues`].
pub fn orbit_modes(
    bearing: &Bearing,
    point: &OperatingPoint,
    bodies: &Bodies,
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<Vec<Mode>, OrbitError> {
    let bearing = &prepared(bearing, settings);
    modes(&at(bearing, (point, &bodies.cage), settings, solved)?, &solved.orbit, bodies)
}

/// Cage speed and ring nearly right, the balls sent round with them by Euler's implicit method.
fn neighbourhood(newton: &mut Newton<'_>, mut orbit: Orbit) -> Result<Orbit, OrbitError> {
    for _ in 0..ROUNDS {
        let moved = newton.sweep(&mut orbit, ROUGHLY);
        let residual = newton.residual(&orbit);
        let off = residual.border.iter().map(|v| v * v).sum::<f64>().sqrt();
        if off < FOUND && moved < 1.0 {
            break;
        }
        let linear = newton.linearise(&orbit)?;
        let step = newton.step(&linear, &residual);
        let faster = (step.border[0] * newton.scales.border[0]).abs();
        let ring = step.border[1..].iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let share = 1f64.min(SPEED_CHANGE * orbit.cage_speed.abs() / faster).min(RING_CHANGE / ring);
        orbit = newton.apply(&orbit, &step, share);
    }
    Ok(orbit)
}

/// Newton's method on cage speed and ring alone, the balls sent round to their periodic motion after each step.
/// Slower than that on all unknowns, but no ball is asked to follow a slope over a contact that it loses.
fn reduced(newton: &mut Newton<'_>, mut orbit: Orbit) -> Result<Orbit, OrbitError> {
    let settle = |newton: &mut Newton<'_>, orbit: &mut Orbit| {
        for _ in 0..TURNS {
            let moved = newton.sweep(orbit, CLOSELY);
            if moved < 1e-2 {
                break;
            }
        }
        let residual = newton.residual(orbit);
        let off = residual.border.iter().map(|v| v * v).sum::<f64>().sqrt();
        (off, residual)
    };
    let (mut off, mut residual) = settle(newton, &mut orbit);
    for _ in 0..ROUNDS {
        if off < CLOSE {
            break;
        }
        let linear = newton.linearise(&orbit)?;
        let step = newton.step(&linear, &residual);
        let faster = (step.border[0] * newton.scales.border[0]).abs();
        let ring = step.border[1..].iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let mut share = 1f64.min(SPEED_CHANGE * orbit.cage_speed.abs() / faster).min(RING_CHANGE / ring);
        loop {
            let mut trial = newton.apply(&orbit, &step, share);
            if share < newton.longest(&step) {
            } else {
                trial.values.clone_from(&orbit.values);
            }
            let (after, r) = settle(newton, &mut trial);
            if after < (1.0 - 0.1 * share) * off || share < 0.05 {
                (orbit, off, residual) = (trial, after, r);
                break;
            }
            share *= 0.4;
        }
    }
    Ok(orbit)
}

/// The orbit from its neighbourhood: by three points an interval where Newton's method finds it from there, else from
/// the orbit of first order on a finer mesh, else that itself.
fn collocated(newton: &mut Newton<'_>, near: &Orbit, settings: &OrbitSettings) -> Result<Found, OrbitError> {
    let euler = Radau::euler();
    if let Some(found) = third_order(newton, near, settings, settings.intervals) {
        return Ok(found);
    }
    let mut before = None;
    let mut near = near.clone();
    let mut left = None;
    for (refined, fine) in FIRST_ORDER.into_iter().enumerate() {
        newton.radau = euler;
        let ends = (0..=fine).map(|j| j as f64 / fine as f64).collect();
        let orbit = reduced(newton, near.on(&euler, ends, &euler))?;
        let (orbit, residual) = newton.run(orbit, settings.tolerance, PATIENCE);
        if residual.worst.relative > settings.tolerance {
            left = Some((residual, orbit));
            continue;
        }
        near = orbit;
        if let Some(found) = third_order(newton, &near, settings, settings.intervals * (3 + refined) / 2) {
            return Ok(found);
        }
        newton.radau = euler;
        // The error of first order halves with the step.
        let error = before.map(|speed: f64| (near.cage_speed / speed - 1.0).abs());
        before = Some(near.cage_speed);
        if refined + 1 == FIRST_ORDER.len() {
            return Ok(Found { orbit: near, residual, speed_error: error });
        }
    }
    let (residual, orbit) = left.ok_or(OrbitError::Singular)?;
    Err(OrbitError::not_converged(&newton.system, &orbit, &residual.worst, settings.tolerance))
}

/// An orbit that meets its equations.
struct Found {
    orbit: Orbit,
    residual: Residual,
    /// Of the cage, relative, where the orbit is of first order.
    speed_error: Option<f64>,
}

fn third_order(newton: &mut Newton<'_>, near: &Orbit, settings: &OrbitSettings, intervals: usize) -> Option<Found> {
    let (euler, third) = (Radau::euler(), Radau::third());
    let ends = mesh::graded(&newton.system, &euler, near, intervals);
    newton.radau = third;
    let (orbit, residual) = newton.run(near.on(&euler, ends, &third), settings.tolerance, PATIENCE);
    (residual.worst.relative <= settings.tolerance).then_some(Found { orbit, residual, speed_error: None })
}

fn finish(
    newton: &Newton<'_>,
    found: Found,
    (point, rule, rule_error): (&OperatingPoint, PatchRule, f64),
) -> Result<SolvedOrbit, OrbitError> {
    let Found { orbit, residual, speed_error } = found;
    let solution = solution(newton, &orbit, (residual.worst.relative, rule_error, speed_error));
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let start = OrbitStart { orbit, rule, rule_error, speed_error, scales: newton.scales, speeds };
    Ok(SolvedOrbit { solution, statistics: newton.statistics, start: Some(start) })
}
