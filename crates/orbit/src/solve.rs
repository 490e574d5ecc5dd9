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

/// Stiffness that centres a ball in its pocket over that of the pocket: settles where a cage hangs that no ball touches.
const CENTRING: f64 = 1e-8;
/// The cheap rule on which the neighbourhood of the orbit is found.
const SCOUT: PatchRule = PatchRule::SplitStrip { across: 5, along: 3 };
/// Rounds of sending the balls round and correcting cage and ring.
const ROUNDS: usize = 25;
/// Border residual, over its scales, at which the neighbourhood is found.
const FOUND: f64 = 3e-2;
/// Change of cage speed in one round, relative; of the ring, over its scale.
const SPEED_CHANGE: f64 = 0.02;
const RING_CHANGE: f64 = 5.0;
/// Jacobians of a first and of any other attempt on a mesh.
const PATIENCE: usize = 14;
/// Attempts, each on a mesh half as fine again.
const ATTEMPTS: usize = 4;

/// Settings of the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitSettings {
    /// Intervals round the orbit, each with three points of collocation.
    pub intervals: usize,
    /// Largest relative residual of any balance.
    pub tolerance: f64,
    /// Damping ratio ζ of the ball–race contacts that the orbit has at least.
    pub contact_damping: f64,
    /// Damping of the pockets that the orbit has at least, as χ of Hunt and Crossley times a hundredth of the orbital velocity.
    pub pocket_damping: f64,
}

impl Default for OrbitSettings {
    /// 60 intervals, 1e-10; damping that ends the bouncing of idle balls, which has no part in a mean: at a χ v of 10 a ball
    /// keeps a tenth of the velocity with which it meets the wall.
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
    let (orbit, residual) = collocated(&mut newton, &near, settings)?;
    finish(&newton, orbit, &residual, (point, rolling.rule, rolling.rule_error))
}

/// Solves from the orbit of a neighbouring problem, on its mesh and with its patch rule; from a cold start where that fails.
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
    let (orbit, residual) = newton.run(orbit, settings.tolerance, PATIENCE);
    if residual.worst.relative <= settings.tolerance {
        return finish(&newton, orbit, &residual, (point, near.rule, near.rule_error));
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
    Ok(Newton::new(system, solved.scales))
}

/// Stiffness of the inner ring on its steady orbit: mean forces (N) and moments (N m) against displacements x, y, z (m) and tilts
/// (rad), by row; balls and cage condensed.
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
        let moved = newton.sweep(&mut orbit);
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

/// The collocated orbit from the neighbourhood, on finer meshes where the first one is too coarse.
fn collocated(
    newton: &mut Newton<'_>,
    near: &Orbit,
    settings: &OrbitSettings,
) -> Result<(Orbit, Residual), OrbitError> {
    let (euler, third) = (Radau::euler(), Radau::third());
    let mut intervals = settings.intervals;
    let mut left = None;
    for attempt in 0..ATTEMPTS {
        let ends = mesh::graded(&newton.system, &euler, near, intervals);
        newton.radau = third;
        let mut orbit = near.on(&euler, ends, &third);
        if attempt > 0 {
            newton.sweep(&mut orbit);
            newton.sweep(&mut orbit);
        }
        let (orbit, residual) = newton.run(orbit, settings.tolerance, PATIENCE);
        if residual.worst.relative <= settings.tolerance {
            return Ok((orbit, residual));
        }
        left = Some((residual, orbit));
        intervals += intervals / 2;
    }
    let (residual, orbit) = left.ok_or(OrbitError::Singular)?;
    Err(OrbitError::not_converged(&newton.system, &orbit, &residual.worst, settings.tolerance))
}

fn finish(
    newton: &Newton<'_>,
    orbit: Orbit,
    residual: &Residual,
    (point, rule, rule_error): (&OperatingPoint, PatchRule, f64),
) -> Result<SolvedOrbit, OrbitError> {
    let solution = solution(newton, &orbit, residual.worst.relative, rule_error);
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let start = OrbitStart { orbit, rule, rule_error, scales: newton.scales, speeds };
    Ok(SolvedOrbit { solution, statistics: newton.statistics, start: Some(start) })
}
