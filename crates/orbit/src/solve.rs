//! From a bearing at an operating point to its steady orbit.

use crate::collocation::Orbit;
use crate::modes::{Bodies, Mode, modes};
use crate::newton::Newton;
use crate::residual::Found;
use crate::search::{PATIENCE, SETTLING, WORK, damped, find, sliding};
use crate::settings::OrbitSettings;
use crate::solution::{Placed, placed, solution};
use crate::solved::{OrbitStart, SolvedOrbit};
use crate::start::less_tilted;
use crate::stiffness::stiffness;
use crate::system::OrbitSystem;
use crate::way::{Eased, Way, ladder};
use crate::{OrbitError, OrbitReason, start, statics};
use tribodyn_bearing::{BallLoads, Bearing, CageBody, OperatingPoint, Races, RingOffset};
use tribodyn_quasistatic::{RollingStart, StiffnessMatrix, rolling_start};
use tribodyn_traction::{FastPatch, PatchChoice, PatchRule, choose_rule};

/// Stiffness that centres a ball in its pocket over that of the pocket: settles where a cage hangs that no ball
/// touches.
const CENTRING: f64 = 1e-8;

/// Error of an interval, over what is allowed, up to which the mesh of a neighbour serves.
const DRIFTED: f64 = 2.0;
/// Patches by which slopes are taken at first from a neighbour, and the Jacobians after which those of the patches
/// themselves are: where a cage hangs that no ball touches, slopes must be right to the last. As many lead from the
/// nearest to the orbit or not at all.
const HURRY: usize = 3;
const NEXT_DOOR: usize = 2;
const SLOPES: PatchRule = PatchRule::SplitStrip { across: 12, along: 4 };

/// Shares of the inner ring's speed at which balls that slide on it might roll.
const SLIDING: [f64; 7] = [0.7, 0.5, 0.35, 0.25, 0.15, 0.08, 0.03];

/// First step on the way from a ring without tilt, by how much the next is longer, or shorter where it leads nowhere,
/// and steps that are tried.
const LED: f64 = 0.25;
const LONGER: f64 = 1.5;
const SHORTER: f64 = 0.4;
const ATTEMPTS: usize = 25;

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
    (rule, speed, origin): (PatchRule, f64, f64),
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
        origin,
        direction: speed.signum(),
        centring: CENTRING * cage.pocket.stiffness,
        settling: 0.0,
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
    let problem = (bearing, point, cage, settings);
    let error = match begun(problem, (bearing, 1.0), find) {
        Err(error @ OrbitError::NotConverged { .. }) => error,
        other => return other,
    };
    // Control by the inner race may have no balls on it that outer control leaves there.
    let mut guessed = bearing.clone();
    guessed.modelling.race_control = None;
    let slid = || {
        let rolling = begun(problem, (&guessed, 1.0), find).ok();
        rolling.or_else(|| SLIDING.iter().find_map(|share| begun(problem, (&guessed, *share), sliding).ok()))
    };
    let slid = if skids(&error) { slid() } else { None };
    slid.or_else(|| led(problem, &guessed)).ok_or(error)
}

fn skids(error: &OrbitError) -> bool {
    matches!(error, OrbitError::NotConverged { reason: OrbitReason::GrossSkidding { .. }, .. })
}

/// The orbit by a search that begins with the balls of a bearing, those that would roll if the inner ring turned at a
/// share of its speed: the slower, the less centrifugal force takes them off it.
fn begun<F>(
    (bearing, point, cage, settings): (&Bearing, &OperatingPoint, &CageBody, &OrbitSettings),
    (guessed, share): (&Bearing, f64),
    search: F,
) -> Result<SolvedOrbit, OrbitError>
where
    F: for<'a> FnOnce(
        &mut Newton<'a>,
        (&OperatingPoint, &RollingStart),
        &Way<'a>,
        &OrbitSettings,
    ) -> Result<(Found, Eased), OrbitError>,
{
    let mut slower = point.clone();
    if share != 1.0 {
        slower.inner_speed = point.outer_speed + share * (point.inner_speed - point.outer_speed);
    }
    let rolling = rolling_start(guessed, &slower)?;
    let speed = start::cage_speed(&rolling);
    if speed == 0.0 {
        return Ok(statics::at_rest(bearing, point, cage, (&rolling, FastPatch::new(rolling.rule)?)));
    }
    let origin = bearing.azimuth(start::hardest(&rolling));
    let system = system(bearing, (point, cage), (rolling.rule, speed, origin), settings)?;
    let scales = start::scales((bearing, &cage.pocket), &point.ring, &rolling, speed);
    let ladder = ladder(bearing, (&rolling, speed));
    let way = Way::new(&system, &ladder, (&rolling, scales.force))?;
    let mut newton = Newton::new(system, scales);
    let (found, eased) = search(&mut newton, (point, &rolling), &way, settings)
        .map_err(|error| error.because(reason(&rolling, bearing, speed)))?;
    finish(&mut newton, found, (point, settings), eased)
}

/// The orbit by way of rings that are tilted less, each from the orbit of the one before.
fn led(
    (bearing, point, cage, settings): (&Bearing, &OperatingPoint, &CageBody, &OrbitSettings),
    guessed: &Bearing,
) -> Option<SolvedOrbit> {
    let first = less_tilted(point, 0.0);
    if first == *point {
        return None;
    }
    let mut reached = begun((bearing, &first, cage, settings), (guessed, 1.0), find).ok()?;
    let (mut share, mut step) = (0.0, LED);
    for _ in 0..ATTEMPTS {
        let next = f64::min(share + step, 1.0);
        match warm((bearing, &less_tilted(point, next), cage, settings), reached.start.as_ref()?) {
            Some(solved) if next == 1.0 => return Some(solved),
            Some(solved) => (reached, share, step) = (solved, next, step * LONGER),
            None => step *= SHORTER,
        }
    }
    None
}

/// The orbit from that of a neighbour, if not by the shortest way; none where that does not lead to it.
fn warm(
    (bearing, point, cage, settings): (&Bearing, &OperatingPoint, &CageBody, &OrbitSettings),
    near: &OrbitStart,
) -> Option<SolvedOrbit> {
    let eased = near.eased.of(bearing);
    let orbit = near.at_speeds(point);
    let start = OrbitStart { orbit: orbit.clone(), ..near.clone() };
    let mut newton = at(&eased, (point, cage), settings, &start).ok()?;
    let goal = (settings.tolerance, PATIENCE);
    let met = newton.met(orbit.clone(), goal).or_else(|| newton.closed(orbit.clone(), settings.tolerance));
    let cheap = FastPatch::new(SLOPES).ok()?;
    let fitted = met.and_then(|found| fitted(&mut newton, found, (settings, cheap)));
    let found = match fitted {
        Some(found) => found,
        None => damped(&mut newton, &orbit, settings, (&SETTLING, WORK)).ok()?,
    };
    finish(&mut newton, found, (point, settings), near.eased).ok()
}

/// The likely reason why no orbit of a bearing was found.
fn reason(rolling: &RollingStart, bearing: &Bearing, speed: f64) -> OrbitReason {
    let centrifugal_share = start::centrifugal_force(bearing, speed) / start::mean_load(rolling);
    if centrifugal_share > 1.0 {
        OrbitReason::GrossSkidding { centrifugal_share }
    } else if rolling.inner_loads.iter().any(|load| *load <= 0.0) {
        OrbitReason::IdleBalls { centrifugal_share }
    } else {
        OrbitReason::Unknown
    }
}

/// Solves from the orbit of a neighbouring problem, on its mesh and with its patch rule, the mesh made finer where it
/// errs; from a cold start where that fails.
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
    if let Some(solved) = hurried((bearing, point, cage, settings), near, (HURRY, fitted))? {
        return Ok(solved);
    }
    let led = warm((&prepared(bearing, settings), point, cage, settings), near);
    led.map_or_else(|| steady_orbit(bearing, point, cage, settings), Ok)
}

/// The same where the neighbour is so near that a few steps lead to the orbit on its mesh; none where a cold start is
/// as cheap.
///
/// # Errors
/// As [`steady_orbit`].
pub fn steady_orbit_near(
    bearing: &Bearing,
    point: &OperatingPoint,
    cage: &CageBody,
    settings: &OrbitSettings,
    near: &OrbitStart,
) -> Result<Option<SolvedOrbit>, OrbitError> {
    hurried((bearing, point, cage, settings), near, (NEXT_DOOR, as_it_is))
}

/// Makes of an orbit on a neighbour's mesh one to answer with; none where that is not worth it.
type Serve = fn(&mut Newton<'_>, Found, (&OrbitSettings, FastPatch)) -> Option<Found>;

/// The orbit by full steps and so many Jacobians with cheap slopes, first on the mesh of a neighbour; none where that
/// does not lead to it.
fn hurried(
    (bearing, point, cage, settings): (&Bearing, &OperatingPoint, &CageBody, &OrbitSettings),
    near: &OrbitStart,
    (jacobians, serve): (usize, Serve),
) -> Result<Option<SolvedOrbit>, OrbitError> {
    let eased = near.eased.of(&prepared(bearing, settings));
    let orbit = near.at_speeds(point);
    let start = OrbitStart { orbit: orbit.clone(), ..near.clone() };
    let mut newton = at(&eased, (point, cage), settings, &start)?;
    let cheap = FastPatch::new(SLOPES)?;
    newton.slopes_by = Some(cheap.clone());
    let found = newton.by_full_steps(orbit, settings.tolerance, (jacobians, near.jacobian.clone()));
    newton.slopes_by = None;
    let found = found.and_then(|found| serve(&mut newton, found, (settings, cheap)));
    found.map(|found| finish(&mut newton, found, (point, settings), near.eased)).transpose()
}

/// True if a mesh errs by little more than is allowed.
fn fits(newton: &mut Newton<'_>, orbit: &Orbit, (settings, cheap): (&OrbitSettings, &FastPatch)) -> bool {
    let errors = newton.with_patches(cheap.clone(), |newton| newton.errors(orbit, settings.mesh_error));
    errors.iter().all(|error| *error <= DRIFTED)
}

/// An orbit on a neighbour's mesh, where that errs by no more than is allowed.
fn as_it_is(newton: &mut Newton<'_>, found: Found, (settings, cheap): (&OrbitSettings, FastPatch)) -> Option<Found> {
    fits(newton, &found.0, (settings, &cheap)).then_some(found)
}

/// An orbit on a neighbour's mesh, or on a finer one where that errs by more than is allowed.
fn fitted(newton: &mut Newton<'_>, found: Found, (settings, cheap): (&OrbitSettings, FastPatch)) -> Option<Found> {
    let goal = (settings.tolerance, PATIENCE);
    if fits(newton, &found.0, (settings, &cheap)) {
        return Some(found);
    }
    let found = newton.halved(found, settings.mesh_error, goal);
    if fits(newton, &found.0, (settings, &cheap)) {
        Some(found)
    } else {
        newton.refined(found, settings.mesh_error, goal)
    }
}

/// The solver at a solution.
fn at<'a>(
    bearing: &'a Bearing,
    (point, cage): (&OperatingPoint, &CageBody),
    settings: &OrbitSettings,
    solved: &OrbitStart,
) -> Result<Newton<'a>, OrbitError> {
    let of = (solved.rule, solved.orbit.cage_speed, solved.origin);
    let mut system = OrbitSystem { settling: solved.settling, ..system(bearing, (point, cage), of, settings)? };
    system.cage.pocket.stiffness *= solved.eased.pocket_stiffness;
    Ok(Newton::new(system, solved.scales))
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
    let bearing = &solved.eased.of(&prepared(bearing, settings));
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
    let bearing = &solved.eased.of(&prepared(bearing, settings));
    modes(&at(bearing, (point, &bodies.cage), settings, solved)?, &solved.orbit, bodies)
}

/// The answer: the orbit by a rule that is good enough on it, where the one that was taken, for balls that roll or at a
/// neighbour, is not.
fn finish(
    newton: &mut Newton<'_>,
    found: Found,
    (point, settings): (&OperatingPoint, &OrbitSettings),
    eased: Eased,
) -> Result<SolvedOrbit, OrbitError> {
    let (found, balls, patch_error) = sharpened(newton, found, (point, settings))?;
    let solution = solution(newton, &found, (&balls, patch_error), &eased);
    let (orbit, _) = found;
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let jacobian = newton.last.take().filter(|last| last.is_of(&orbit));
    let (origin, settling) = (newton.system.origin, newton.system.settling);
    let rule = newton.system.kernel.quadrature().rule();
    let start = OrbitStart { orbit, jacobian, rule, origin, settling, eased, scales: newton.scales, speeds };
    Ok(SolvedOrbit { solution, statistics: newton.statistics, start: Some(start) })
}

/// The balls where those of an equilibrium stand.
fn balls(newton: &Newton<'_>, (orbit, _): &Found) -> Vec<Placed> {
    placed(newton, orbit, newton.system.bearing.geometry.ball_count).collect()
}

/// The orbit with its balls and the error of their patches, by a finer rule where that is more than the problem allows
/// and the orbit is found with it.
fn sharpened(
    newton: &mut Newton<'_>,
    found: Found,
    (point, settings): (&OperatingPoint, &OrbitSettings),
) -> Result<(Found, Vec<Placed>, f64), OrbitError> {
    let bearing = newton.system.bearing;
    let placed = balls(newton, &found);
    let loads: Vec<BallLoads> = placed.iter().map(|(_, _, e)| e.loads).collect();
    let error = bearing.patch_error(newton.system.kernel.quadrature().rule(), loads.clone())?;
    let target = point.patch.filter(|patch| bearing.elastic.is_none() && !patch.allows(Some(error)));
    let Some(PatchChoice::TargetError { relative }) = target else { return Ok((found, placed, error)) };
    let probes: Vec<_> = bearing.probes(loads).into_iter().map(|(_, probe)| probe).collect();
    let (rule, better) = choose_rule(relative, &probes)?;
    let kernel = FastPatch::new(rule)?;
    let goal = (settings.tolerance, PATIENCE);
    let Some(sharp) = newton.with_patches(kernel.clone(), |newton| newton.met(found.0.clone(), goal)) else {
        return Ok((found, placed, error));
    };
    newton.system.kernel = kernel;
    let placed = balls(newton, &sharp);
    Ok((sharp, placed, better))
}
