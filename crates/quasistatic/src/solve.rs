//! From a cold start to the equilibrium. At rest all models have the one of [`crate::at_rest`]; else
//!
//! 1. Elastic phase: inertia frozen, forces from a convex potential; the Newton iteration with a descending energy
//!    finds the ring and the balls from the unloaded position, contacts lost or not.
//! 2. Jones–Harris from there.
//! 3. Traction from the Jones–Harris rolling state (the elastic one where raceway control has no solution): first the
//!    balls alone in pseudo-time with the ring held, so that each slows down under drag into the stable root connected
//!    to rolling, with a cheap patch rule and then with the wanted one; then ring and balls together by Newton.

use crate::at_rest::{AtRest, Moments, is_at_rest, thrown};
use crate::block::{AXIAL, BALL, BlockState, BlockSystem, Iterate, OMEGA, ORBIT, RADIAL, RING, SolverStatistics};
use crate::driver;
use crate::jones_harris::{self, JonesHarris, Kinematics, Typical, kinematics};
use crate::methods::{Downhill, NewtonOrNested, settle};
use crate::problem::{Place, QuasiStaticError, Reason};
use crate::rescue;
use crate::settle::{FROM_AFAR, FROM_NEAR};
use crate::stability::steadied;
use crate::start::WarmStart;
use crate::with_traction::{self, WithTraction};
use crate::{Model, Solution, needs, report};
use tribodyn_bearing::{BallLoads, BallSize, Bearing, OperatingPoint, RaceControl, Races, RingFreedom, Side};
use tribodyn_traction::{FastPatch, PatchChoice, PatchRule, RuleUse, TractionError};

/// The cheap rule that finds the neighbourhood of the equilibrium, and the state at which a target error's rule is
/// chosen.
pub(crate) const SCOUT: PatchRule = PatchRule::SplitStrip { across: 5, along: 3 };
/// The Jones–Harris state that traction starts from where the case does not say how that is read: a first guess only.
const GUESSED_CONTROL: RaceControl = RaceControl::Outer;
const GUESSED_AT_FREE_PITCH: bool = true;
/// How often the residual may rise where balls fall into skidding: each ball can do so about once.
const JUMPS: usize = 8;
/// Centrifugal force of a ball over a typical load below which the elastic phase may end before it has brought all
/// balls to their place.
const SLOW: f64 = 1e-4;
/// Rounds of asking which race controls before a ball on the border counts as decided.
const CONTROL_ROUNDS: usize = 4;
/// Residual at which the balls are settled enough for the wanted patch rule, which leaves about 5e-3 of them; a ball on
/// its slow way past a lost rolling state must not pass for a settled one.
const SCOUTED: f64 = 1e-4;
/// Residual at which the balls alone are settled enough to free the ring, which leaves about 1e-3 of them.
const SETTLED: f64 = 1e-6;

/// An equilibrium with what is needed to go on from it.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// The solution.
    pub solution: Solution,
    /// Steps kept and rejected, all phases together.
    pub statistics: SolverStatistics,
    /// Start for a neighbouring problem; none for Jones–Harris.
    pub warm_start: Option<WarmStart>,
}

/// Solves one of the two models from its own initial guess.
///
/// # Errors
/// [`QuasiStaticError::NotConverged`] names the ball, the equation and the residual, [`QuasiStaticError::Missing`] what
/// the model needs and is not there.
pub fn solve(bearing: &Bearing, point: &OperatingPoint, model: Model) -> Result<Solved, QuasiStaticError> {
    needs::check(bearing, point, model)?;
    let Rolling { system, elastic, solved } = rolling_state(bearing, point, model == Model::JonesHarris);
    match model {
        Model::JonesHarris => {
            let rolling = solved?;
            let solution = report::jones_harris(&system, &rolling, point);
            Ok(Solved { solution, statistics: rolling.statistics, warm_start: None })
        }
        Model::Traction => {
            if is_at_rest(point) {
                return at_rest(bearing, point, system.typical, solved?);
            }
            let mut traction = traction_system(bearing, point, system.typical, SCOUT)?;
            // Raceway control may have no solution where traction has one: then the elastic state is the guess.
            let rolling = solved.unwrap_or(elastic);
            let start = release_idle_balls(&system, rolling.state);
            let scouted = scout(&traction, &start);
            let estimate = choose_quadrature(&mut traction, &scouted, point)?;
            let settled = settle(&traction, &scouted, SETTLED, FROM_NEAR);
            finish(&traction, [settled, start], point, rolling.statistics, estimate)
        }
    }
}

/// The answer with traction for a bearing at rest, by the rule that the operating point asks for.
fn at_rest(
    bearing: &Bearing,
    point: &OperatingPoint,
    typical: Typical,
    solved: Iterate,
) -> Result<Solved, QuasiStaticError> {
    let mut traction = traction_system(bearing, point, typical, SCOUT)?;
    let estimate = choose_quadrature(&mut traction, &solved.state, point)?;
    answer(&traction, solved, point, estimate)
}

/// The elastic state, and the Jones–Harris one that starts from it.
pub(crate) struct Rolling<'a> {
    pub system: JonesHarris<'a>,
    pub elastic: Iterate,
    pub solved: Result<Iterate, QuasiStaticError>,
}

/// Phases 1 and 2; `wanted` where Jones–Harris is the goal and not a guess.
pub(crate) fn rolling_state<'a>(bearing: &'a Bearing, point: &OperatingPoint, wanted: bool) -> Rolling<'a> {
    let g = &bearing.geometry;
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    let typical = Typical::new(bearing, &point.ring, speeds);
    let control = bearing.modelling.race_control.unwrap_or(GUESSED_CONTROL);
    let inner_everywhere = control == RaceControl::Inner;
    let mut system = JonesHarris {
        bearing,
        ring: point.ring,
        speeds,
        inner_control: vec![inner_everywhere; g.ball_count],
        centrifugal_at_free_pitch: bearing.modelling.centrifugal_at_free_pitch.unwrap_or(GUESSED_AT_FREE_PITCH),
        bounded: wanted,
        frozen: None,
        typical,
    };
    if is_at_rest(point) {
        let (elastic, solved) = standing(bearing, point, (typical, wanted));
        return Rolling { system, elastic, solved };
    }
    let (k, ball) = rolling_free(&system, inner_everywhere);
    let start = BlockState { balls: vec![ball; g.ball_count], ring: [0.0; RING] };
    system.frozen = Some(k.centrifugal_force);
    let limit = point.numerics.max_iterations;
    // Far from the goal the elastic phase only has to find the basin.
    let elastic = driver::run(&system, Iterate::new(&system, start), Downhill { mu: 1.0 }, 1e-6, limit);
    system.frozen = None;
    let mut statistics = elastic.statistics;
    let mut state = elastic.state.clone();
    if wanted && k.centrifugal_force < SLOW * typical.force {
        throw_out_idle_balls(&system, &mut state, k.centrifugal_force);
    }
    // Solve, ask each ball which race controls, solve again; a few rounds settle it, or the last answer stands.
    for round in 0.. {
        let mut solved = newton(&system, state, point);
        let mut reached = 1.0;
        if wanted && solved.worst().residual > point.numerics.tolerance {
            (solved, reached) = rescue::jones_harris(&mut system, solved, (&elastic, k.centrifugal_force), point);
        }
        statistics = statistics + solved.statistics;
        let found = solved.worst().residual <= point.numerics.tolerance;
        let inner_control = match control {
            RaceControl::Inner if wanted && !found => held_by_inner_race(&system, &elastic.state),
            RaceControl::Criterion => controlling_races(&system, &solved.state),
            _ => system.inner_control.clone(),
        };
        if round == CONTROL_ROUNDS || inner_control == system.inner_control {
            solved.statistics = statistics;
            let reason = || rescue::why_no_raceway_control(&system, &solved, reached);
            let checked = check(&solved, Model::JonesHarris, &jones_harris::EQUATIONS, bearing, point, reason);
            let solved = checked.and_then(|()| if wanted { carried(&system, solved, point) } else { Ok(solved) });
            return Rolling { system, elastic, solved };
        }
        system.inner_control = inner_control;
        state = if control == RaceControl::Inner { elastic.state.clone() } else { solved.state };
    }
    unreachable!("the loop returns in its last round")
}

/// An unloaded ball that rolls at the free contact angle.
fn rolling_free(system: &JonesHarris<'_>, inner_control: bool) -> (Kinematics<f64>, [f64; BALL]) {
    let g = &system.bearing.geometry;
    let offset = g.groove_offset(Side::Outer);
    let [axial, radial] = [offset * g.sin_contact_angle(), offset * g.cos_contact_angle()];
    let unloaded = system.pose(0, [axial, radial, 0.0, 0.0, 0.0, 0.0], [0.0; RING]);
    let k = kinematics(system.bearing, (&unloaded, &BallSize::NOMINAL), system.speeds, inner_control, true);
    (k, [axial, radial, k.angular_velocity[0], k.angular_velocity[1], 0.0, k.orbital_speed])
}

/// The equilibrium of a bearing at rest, and whether it is met.
fn standing(
    bearing: &Bearing,
    point: &OperatingPoint,
    (typical, wanted): (Typical, bool),
) -> (Iterate, Result<Iterate, QuasiStaticError>) {
    let moments = if wanted { Moments::OfPotential } else { Moments::AboutRing };
    let solved = AtRest::of(bearing, point, (typical, moments)).solve_bearing(point);
    let reason = || rescue::why_not_at_rest(&solved);
    let checked = check(&solved, Model::JonesHarris, &jones_harris::EQUATIONS, bearing, point, reason);
    (solved.clone(), checked.map(|()| solved))
}

/// A stable equilibrium in which balls carry the load.
fn carried(system: &JonesHarris<'_>, solved: Iterate, point: &OperatingPoint) -> Result<Iterate, QuasiStaticError> {
    let solved = steadied(system, solved, &system.typical, point);
    let idle = |(index, &ball): (usize, &[f64; BALL])| {
        let inner = system.pose(index, ball, solved.state.ring).contacts.inner;
        system.typical.is_idle(system.bearing.contact_load(Side::Inner, &inner).0)
    };
    let loaded = |freedom: &RingFreedom| matches!(freedom, RingFreedom::Loaded(load) if *load != 0.0);
    if point.ring.iter().any(loaded) && solved.state.balls.iter().enumerate().all(idle) {
        return Err(QuasiStaticError::NoLoadedBall { model: Model::JonesHarris });
    }
    Ok(solved)
}

fn newton<S: BlockSystem>(system: &S, start: BlockState, point: &OperatingPoint) -> Iterate {
    let method = NewtonOrNested::new(0.1 * point.numerics.tolerance, JUMPS);
    driver::run(system, Iterate::new(system, start), method, point.numerics.tolerance, point.numerics.max_iterations)
}

/// Brings balls that the rings do not press to where the centrifugal force (N) throws them.
fn throw_out_idle_balls(system: &JonesHarris<'_>, state: &mut BlockState, centrifugal: f64) {
    for (index, ball) in state.balls.iter_mut().enumerate() {
        if let Some(place) = thrown(system.bearing, index, state.ring, centrifugal) {
            [ball[AXIAL], ball[RADIAL]] = place;
        }
    }
}

/// Balls that the inner race can hold where it cannot hold all: those that it touches in the elastic state. The others
/// are left to the outer race.
fn held_by_inner_race(system: &JonesHarris<'_>, elastic: &BlockState) -> Vec<bool> {
    let touches = |(index, &ball): (usize, &[f64; BALL])| {
        let pose = system.pose(index, ball, elastic.ring);
        !system.typical.is_idle(system.bearing.contact_load(Side::Inner, &pose.contacts.inner).0)
    };
    elastic.balls.iter().enumerate().map(touches).collect()
}

/// Harris's criterion: outer control where Q_o a_o E_o cos(α_i − α_o) > Q_i a_i E_i.
fn controlling_races(system: &JonesHarris<'_>, state: &BlockState) -> Vec<bool> {
    let resistance = |side, pose: &tribodyn_bearing::ContactPose| {
        let (load, ellipse) = system.bearing.contact_load(side, pose);
        load * ellipse.semi_lateral() * system.bearing.races[side].frozen::<f64>().second_integral
    };
    let inner = |(index, &ball): (usize, &[f64; BALL])| {
        let pose = system.pose(index, ball, state.ring);
        let turn = (pose.contacts.inner.sin * pose.contacts.outer.cos
            - pose.contacts.inner.cos * pose.contacts.outer.sin)
            .asin()
            .cos();
        resistance(Side::Outer, &pose.contacts.outer) * turn <= resistance(Side::Inner, &pose.contacts.inner)
    };
    state.balls.iter().enumerate().map(inner).collect()
}

/// Balls without inner contact have no drive: they start from where friction and fluid will leave them, with the
/// fluid, or with the outer ring in a dry bearing.
fn release_idle_balls(system: &JonesHarris<'_>, mut state: BlockState) -> BlockState {
    let Races { inner: inner_speed, outer: outer_speed } = system.speeds;
    let idle = system.bearing.fluid.as_ref().map_or(outer_speed, |f| f.swirl * inner_speed);
    for (index, ball) in state.balls.iter_mut().enumerate() {
        let pose = system.pose(index, *ball, state.ring);
        let (inner_load, _) = system.bearing.contact_load(Side::Inner, &pose.contacts.inner);
        if system.typical.is_idle(inner_load) && ball[ORBIT] != outer_speed {
            let share = (idle - outer_speed) / (ball[ORBIT] - outer_speed);
            (OMEGA..ORBIT).for_each(|k| ball[k] *= share);
            ball[ORBIT] = idle;
        }
    }
    state
}

pub(crate) fn traction_system<'a>(
    bearing: &'a Bearing,
    point: &OperatingPoint,
    typical: Typical,
    rule: PatchRule,
) -> Result<WithTraction<'a>, QuasiStaticError> {
    let kernel = FastPatch::new(rule)?;
    let speeds = Races { inner: point.inner_speed, outer: point.outer_speed };
    Ok(WithTraction { bearing, ring: point.ring, speeds, kernel, typical, watch: point.watch.clone() })
}

/// The neighbourhood of the equilibrium, with rigid patches.
fn scout(traction: &WithTraction<'_>, start: &BlockState) -> BlockState {
    if traction.bearing.elastic.is_none() {
        return settle(traction, start, SCOUTED, FROM_AFAR);
    }
    let WithTraction { bearing, ring, speeds, ref kernel, typical, ref watch } = *traction;
    let rigid = bearing.with_rigid_patches();
    let (kernel, watch) = (kernel.clone(), watch.clone());
    settle(&WithTraction { bearing: &rigid, ring, speeds, kernel, typical, watch }, start, SCOUTED, FROM_AFAR)
}

/// Error of the patch integrals at a state, over the load: of the rule, or of strips and cells of elastic patches.
pub(crate) fn patch_error(system: &WithTraction<'_>, state: &BlockState) -> Result<f64, TractionError> {
    system.bearing.patch_error(system.kernel.quadrature().rule(), loads(system, state))
}

/// Loads of all balls at a state.
fn loads(system: &WithTraction<'_>, state: &BlockState) -> Vec<BallLoads> {
    state.balls.iter().enumerate().map(|(index, &ball)| system.evaluate(index, ball, state.ring).1).collect()
}

/// Takes the rule of the problem, by its target error at the scouted state where it is not named. Gives the estimate.
/// Elastic patches have their own strips and cells and take no rule.
pub(crate) fn choose_quadrature(
    system: &mut WithTraction<'_>,
    state: &BlockState,
    point: &OperatingPoint,
) -> Result<Option<f64>, QuasiStaticError> {
    let Some(wanted) = point.patch.filter(|_| system.bearing.elastic.is_none()) else { return Ok(None) };
    let (rule, estimate) = match wanted {
        PatchChoice::Named(rule) => (rule, None),
        PatchChoice::TargetError { relative } => {
            let chosen = system.bearing.choose_rule(relative, loads(system, state), RuleUse::Solver)?;
            let Some((rule, error)) = chosen else { return Ok(None) };
            (rule, Some(error))
        }
    };
    system.kernel = FastPatch::new(rule)?;
    Ok(estimate)
}

/// Phase 3's second half: all unknowns together, and the report. Starts from the first of two states; where Newton's
/// method finds no way from there, from both in pseudo-time.
pub(crate) fn finish(
    system: &WithTraction<'_>,
    [settled, rolling]: [BlockState; 2],
    point: &OperatingPoint,
    before: SolverStatistics,
    estimate: Option<f64>,
) -> Result<Solved, QuasiStaticError> {
    let mut solved = newton(system, settled.clone(), point);
    solved.statistics = before + solved.statistics;
    if solved.worst().residual > point.numerics.tolerance {
        solved = rescue::with_traction(system, solved, [rolling, settled], point);
    }
    let reason = || rescue::why_no_steady_state(system, &solved);
    check(&solved, Model::Traction, &with_traction::EQUATIONS, system.bearing, point, reason)?;
    answer(system, steadied(system, solved, &system.typical, point), point, estimate)
}

/// The answer of the model with traction at its solution.
fn answer(
    system: &WithTraction<'_>,
    solved: Iterate,
    point: &OperatingPoint,
    estimate: Option<f64>,
) -> Result<Solved, QuasiStaticError> {
    let estimate = match estimate {
        Some(error) => error,
        None => patch_error(system, &solved.state)?,
    };
    let solution = report::with_traction(system, &solved, point, estimate);
    let rule = system.kernel.quadrature().rule();
    let warm_start = Some(WarmStart { state: solved.state, rule, speeds: system.speeds });
    Ok(Solved { solution, statistics: solved.statistics, warm_start })
}

const RING_EQUATIONS: [&str; RING] =
    ["force along x", "force along y", "axial force", "moment about x", "moment about y"];

fn check(
    solved: &Iterate,
    model: Model,
    equations: &[&'static str],
    bearing: &Bearing,
    point: &OperatingPoint,
    reason: impl FnOnce() -> Reason,
) -> Result<(), QuasiStaticError> {
    let worst = solved.worst();
    if worst.residual <= point.numerics.tolerance {
        return Ok(());
    }
    if point.watch.stops() {
        return Err(QuasiStaticError::Ended);
    }
    let (place, equation) = match worst.ball {
        Some(index) => {
            (Place::Ball { index, azimuth_deg: bearing.azimuth(index).to_degrees() }, equations[worst.equation])
        }
        None => (Place::Ring, RING_EQUATIONS[worst.equation]),
    };
    Err(QuasiStaticError::NotConverged {
        model,
        equation,
        place,
        residual: worst.residual,
        iterations: solved.statistics.accepted,
        tolerance: point.numerics.tolerance,
        reason: Box::new(reason()),
    })
}

#[cfg(test)]
#[path = "rescue_test.rs"]
mod rescue_test;
