//! Attempts at the orbit of a bearing: from balls that roll, and from the orbit of a neighbour.

use crate::chain::Jacobian;
use crate::coarse::Coarse;
use crate::collocation::Orbit;
use crate::events::Events;
use crate::homotopy::{Homotopy, Regularization, ladder};
use crate::newton::Newton;
use crate::residual::Found;
use crate::search::{PATIENCE, closed_near, damped};
use crate::settings::OrbitSettings;
use crate::solution::{Placed, placed, solution};
use crate::solved::{OrbitStart, SolvedOrbit};
use crate::system::OrbitSystem;
use crate::{OrbitError, OrbitReason, start, statics};
use tribodyn_bearing::{BallLoads, Bearing, CageBody, OperatingPoint, Races, RingOffset};
use tribodyn_quasistatic::{RollingStart, rolling_start};
use tribodyn_traction::{FastPatch, PatchChoice, PatchRule, RuleUse};

/// Stiffness that centres a ball in its pocket over that of the pocket: settles where a cage hangs that no ball
/// touches.
const CENTRING: f64 = 1e-8;
/// Error of an interval, over what is allowed, up to which the mesh of a neighbour serves; and over that of a neighbour
/// whose own mesh could not be made finer.
const DRIFTED: f64 = 2.0;
const NO_WORSE: f64 = 1.2;
/// Jacobians from an orbit to itself by another patch rule.
const FEW: usize = 3;
/// Patches by which slopes are taken at first from a neighbour.
pub(crate) const SLOPES: PatchRule = PatchRule::SplitStrip { across: 12, along: 4 };

/// Jacobians with cheap slopes from a neighbour, after which those of the patches themselves are taken: where a cage
/// hangs that no ball touches, slopes must be right to the last. As many lead from the nearest to the orbit or not at
/// all.
const HURRY: usize = 3;

/// A bearing at an operating point.
#[derive(Clone, Copy)]
pub(crate) struct Problem<'a> {
    pub bearing: &'a Bearing,
    pub point: &'a OperatingPoint,
    pub cage: &'a CageBody,
    pub settings: &'a OrbitSettings,
}

/// The bearing as the orbit has it: offsets of the rings exact, contacts damped.
pub(crate) fn prepared(bearing: &Bearing, settings: &OrbitSettings) -> Bearing {
    let mut bearing = bearing.clone();
    bearing.ring_offset = RingOffset::Exact;
    bearing.contact_damping = bearing.contact_damping.max(settings.contact_damping);
    bearing
}

fn system<'a>(
    Problem { bearing, point, cage, settings }: Problem<'a>,
    (rule, speed, origin): (PatchRule, f64, f64),
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
        held: None,
        cage,
    })
}

/// The orbit by a search that begins with the balls of another bearing or of rings at other speeds.
pub(crate) fn begun<F>(
    problem: Problem<'_>,
    (guessed, slower): (&Bearing, &OperatingPoint),
    search: F,
) -> Result<SolvedOrbit, OrbitError>
where
    F: for<'a> FnOnce(&mut Newton<'a>, &RollingStart, &Homotopy<'a>) -> Result<(Found, Regularization), OrbitError>,
{
    let Problem { bearing, point, cage, .. } = problem;
    if point.watch.stops() {
        return Err(OrbitError::Ended);
    }
    if [slower.inner_speed, slower.outer_speed] == [0.0; 2] {
        return statics::still(bearing, point, cage);
    }
    let rolling = rolling_start(guessed, slower)?;
    let speed = start::cage_speed(&rolling);
    if speed == 0.0 {
        return Err(OrbitError::CageStands);
    }
    point.watch.stage("balls that roll", Some(speed));
    let origin = bearing.azimuth(start::hardest(&rolling));
    let system = system(problem, (rolling.rule, speed, origin))?;
    let scales = start::scales((bearing, &cage.pocket), &point.ring, (start::mean_load(&rolling), speed));
    let ladder = ladder(bearing, (&rolling, speed));
    let homotopy = Homotopy::new(&system, &ladder, (&rolling, scales.force))?;
    let mut newton = Newton::new(system, scales, point.watch.clone());
    let (found, regularization) =
        search(&mut newton, &rolling, &homotopy).map_err(|error| error.because(reason(&rolling, bearing, speed)))?;
    finish(&mut newton, found, (problem, None), regularization)
}

/// The orbit by one of the searches of `search.rs`, from the balls of a bearing as they would roll.
pub(crate) fn rolled<F>(problem: Problem<'_>, guessed: &Bearing, search: F) -> Result<SolvedOrbit, OrbitError>
where
    F: for<'a> FnOnce(
        &mut Newton<'a>,
        (&OperatingPoint, &RollingStart),
        &Homotopy<'a>,
        &OrbitSettings,
    ) -> Result<(Found, Regularization), OrbitError>,
{
    let Problem { point, settings, .. } = problem;
    begun(problem, (guessed, point), |newton, rolling, homotopy| search(newton, (point, rolling), homotopy, settings))
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

/// Makes of an orbit on a neighbour's mesh one to answer with; none where that is not worth it.
pub(crate) type Serve = fn(&mut Newton<'_>, Found, &OrbitSettings) -> Option<Found>;

/// The orbit by full steps and few Jacobians with cheap slopes, first on the mesh of a neighbour; none where that
/// does not lead to it.
pub(crate) fn hurried(
    problem: Problem<'_>,
    near: &OrbitStart,
    serve: Serve,
) -> Result<Option<SolvedOrbit>, OrbitError> {
    let Problem { bearing, point, settings, .. } = problem;
    let regularized = near.regularization.of(&prepared(bearing, settings));
    let orbit = near.at_speeds(point);
    let mut newton = at(Problem { bearing: &regularized, ..problem }, near, &orbit)?;
    newton.slopes_by = Some(FastPatch::new(SLOPES)?);
    let met = newton.by_full_steps(orbit, settings.tolerance, (HURRY, near.jacobian.clone()));
    newton.slopes_by = None;
    let met = met.and_then(|found| serve(&mut newton, found, settings));
    met.map(|found| finish(&mut newton, found, (problem, Some(near)), near.regularization)).transpose()
}

/// The orbit from that of a neighbour, if not by the shortest way; none where that does not lead to it.
pub(crate) fn warm(problem: Problem<'_>, near: &OrbitStart, patience: (&[f64], usize)) -> Option<SolvedOrbit> {
    let regularized = near.regularization.of(problem.bearing);
    let orbit = near.at_speeds(problem.point);
    let mut newton = at(Problem { bearing: &regularized, ..problem }, near, &orbit).ok()?;
    let found = nearby(&mut newton, &orbit, problem.settings, patience)?;
    finish(&mut newton, found, (problem, Some(near)), near.regularization).ok()
}

/// The orbit from the start of a neighbour's turn: a ball is sent round from there, so that the mesh is that of its own
/// contacts; none where that does not soon lead to it.
pub(crate) fn resent(problem: Problem<'_>, near: &OrbitStart) -> Option<SolvedOrbit> {
    let Problem { bearing, point, cage, settings } = problem;
    let orbit = near.at_speeds(point);
    let regularized = near.regularization.of(bearing);
    let mut newton = at(Problem { bearing: &regularized, ..problem }, near, &orbit).ok()?;
    newton.scales = start::scales((bearing, &cage.pocket), &point.ring, (near.carried, orbit.cage_speed));
    let cheap = FastPatch::new(SLOPES).ok()?;
    newton.slopes_by = Some(cheap.clone());
    let found = closed_near(&mut newton, &orbit, (cheap, settings))?;
    finish(&mut newton, found, (problem, Some(near)), near.regularization).ok()
}

/// The orbit near one that is not, on its mesh, on a finer one, or by a ball that is sent round.
pub(crate) fn nearby(
    newton: &mut Newton<'_>,
    orbit: &Orbit,
    settings: &OrbitSettings,
    patience: (&[f64], usize),
) -> Option<Found> {
    let goal = (settings.tolerance, PATIENCE);
    let met = newton.met(orbit.clone(), goal).or_else(|| newton.closed(orbit.clone(), settings.tolerance));
    let fitted = met.and_then(|found| fitted(newton, found, settings));
    fitted.or_else(|| damped(newton, orbit, settings, patience).ok())
}

/// Error of the worst interval over what is allowed, by the patches that the orbit was found with: with others, its
/// rates would not be the slopes of its polynomials, and that difference would count as an error.
pub(crate) fn worst(newton: &Newton<'_>, orbit: &Orbit, settings: &OrbitSettings) -> f64 {
    newton.errors(orbit, settings.mesh_error).into_iter().fold(0.0, f64::max)
}

/// True if the mesh of a neighbour errs by little more than is allowed, or no worse than it did there, which the answer
/// then says.
pub(crate) fn fits(newton: &mut Newton<'_>, orbit: &Orbit, settings: &OrbitSettings) -> bool {
    let pocket = newton.with_pockets(orbit, settings.mesh_error).into_iter().fold(0.0, f64::max);
    let Some(there) = newton.coarse else { return pocket <= DRIFTED };
    let motion = worst(newton, orbit, settings);
    newton.coarse = Some(Coarse { motion, pocket });
    motion <= f64::max(DRIFTED, NO_WORSE * there.motion) && pocket <= f64::max(DRIFTED, NO_WORSE * there.pocket)
}

/// An orbit on a neighbour's mesh, or on a finer one where that errs by more than is allowed.
pub(crate) fn fitted(newton: &mut Newton<'_>, found: Found, settings: &OrbitSettings) -> Option<Found> {
    let goal = (settings.tolerance, PATIENCE);
    if fits(newton, &found.0, settings) {
        return Some(found);
    }
    let found = newton.halved(found, settings.mesh_error, goal);
    if worst(newton, &found.0, settings) <= DRIFTED {
        Some(found)
    } else {
        newton.refined(found, settings.mesh_error, goal)
    }
}

/// The solver at a solution, or at another orbit near it.
pub(crate) fn at<'a>(problem: Problem<'a>, solved: &OrbitStart, orbit: &Orbit) -> Result<Newton<'a>, OrbitError> {
    let of = (solved.rule, orbit.cage_speed, solved.origin);
    let mut system = OrbitSystem { settling: solved.settling, ..system(problem, of)? };
    system.cage.pocket.stiffness *= solved.regularization.pocket_stiffness;
    let mut newton = Newton::new(system, solved.scales, problem.point.watch.clone());
    newton.coarse = solved.coarse;
    Ok(newton)
}

/// The solver at a solution, with the very damping and centring of the pockets that it was found with.
pub(crate) fn found<'a>(problem: Problem<'a>, solved: &OrbitStart) -> Result<Newton<'a>, OrbitError> {
    let mut newton = at(problem, solved, &solved.orbit)?;
    newton.system.cage.pocket.damping = solved.pocket_damping;
    newton.system.centring = solved.centring;
    Ok(newton)
}

/// The answer: the orbit by a rule that is good enough on it, where the one that was taken, for balls that roll or at a
/// neighbour, is not.
pub(crate) fn finish(
    newton: &mut Newton<'_>,
    found: Found,
    (problem, near): (Problem<'_>, Option<&OrbitStart>),
    regularization: Regularization,
) -> Result<SolvedOrbit, OrbitError> {
    let first = (found.0.clone(), newton.system.kernel.quadrature().rule(), newton.last.clone());
    let (found, balls, patch_error) = sharpened(newton, found, (problem, near))?;
    let solution = solution(newton, &found, (&balls, patch_error), (&regularization, problem.cage.pocket.damping));
    let rule = newton.system.kernel.quadrature().rule();
    let carried = balls.iter().map(|(_, _, e)| e.loads.contacts.inner.normal.load).sum::<f64>() / balls.len() as f64;
    let start = |(orbit, rule, last): (Orbit, PatchRule, Option<Jacobian>)| OrbitStart {
        events: Events::of(&newton.system, &newton.radau, &orbit),
        jacobian: last.filter(|last| last.is_of(&orbit)),
        orbit,
        rule,
        twin: None,
        origin: newton.system.origin,
        settling: newton.system.settling,
        pocket_damping: newton.system.cage.pocket.damping,
        centring: newton.system.centring,
        regularization,
        coarse: newton.coarse,
        scales: newton.scales,
        carried,
        speeds: Races { inner: problem.point.inner_speed, outer: problem.point.outer_speed },
    };
    let twin = (first.1 != rule).then(|| Box::new(start(first)));
    let start = OrbitStart { twin, ..start((found.0, rule, newton.last.clone())) };
    verify(problem, &start)?;
    Ok(SolvedOrbit { solution, statistics: newton.statistics, start: Some(start) })
}

/// By how much more than the tolerance an orbit may miss the balances of the bearing that it is said to be of: sums in
/// another order round otherwise.
const SAME: f64 = 10.0;

/// Meets the balances once more, by the problem's own bearing with what the answer says was changed of it: whatever
/// else a search left changed shows here.
fn verify(problem: Problem<'_>, start: &OrbitStart) -> Result<(), OrbitError> {
    let bearing = &start.regularization.of(&prepared(problem.bearing, problem.settings));
    let mut newton = found(Problem { bearing, ..problem }, start)?;
    let pocket = newton.system.cage.pocket;
    // Where nothing was regularized, what centres the balls must be next to nothing too.
    let worst = newton.residual(&start.orbit).worst;
    let tolerance = problem.settings.tolerance;
    if worst.relative <= SAME * tolerance
        && (start.regularization != Regularization::NONE || start.centring <= CENTRING * pocket.stiffness)
    {
        return Ok(());
    }
    Err(OrbitError::not_converged(&newton.system, &start.orbit, &worst, tolerance))
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
    (Problem { point, settings, .. }, near): (Problem<'_>, Option<&OrbitStart>),
) -> Result<(Found, Vec<Placed>, f64), OrbitError> {
    let bearing = newton.system.bearing;
    let placed = balls(newton, &found);
    let loads: Vec<BallLoads> = placed.iter().map(|(_, _, e)| e.loads).collect();
    let error = bearing.patch_error(newton.system.kernel.quadrature().rule(), loads.clone())?;
    let target = point.patch.filter(|patch| !patch.allows(Some(error)));
    let Some(PatchChoice::TargetError { relative }) = target else { return Ok((found, placed, error)) };
    let Some((rule, better)) = bearing.choose_rule(relative, loads, RuleUse::Solver)? else {
        return Ok((found, placed, error));
    };
    let kernel = FastPatch::new(rule)?;
    let goal = (settings.tolerance, PATIENCE);
    // By another rule the orbit is hardly another one, and neither are its slopes.
    let known = (FEW, newton.last.clone());
    let like_near = near.and_then(|near| near.sharpened(&found.0, (point, rule)));
    let sharp = newton.with_patches(kernel.clone(), |newton| {
        let by_near = like_near.and_then(|(sharp, last)| newton.by_full_steps(sharp, settings.tolerance, (FEW, last)));
        let by_known = by_near.or_else(|| newton.by_full_steps(found.0.clone(), settings.tolerance, known));
        by_known.or_else(|| newton.met(found.0.clone(), goal))
    });
    let Some(sharp) = sharp else {
        return Ok((found, placed, error));
    };
    newton.system.kernel = kernel;
    let placed = balls(newton, &sharp);
    Ok((sharp, placed, better))
}
