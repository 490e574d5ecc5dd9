//! The search for an orbit: attempts from the cheapest to the most patient.
//!
//! Shares of the 304 orbits that each attempt delivered, and of the processor time of all, for 200 dry bearings of the
//! survey (seed 77410) and 118 of another family (77411) with films of oil in the place of coatings. Most were given
//! up after 15 s, 14 of them without an orbit, so that few bearings judge the last attempts:
//!
//! | attempt | orbits | time |
//! |---|---|---|
//! | nothing drives a ball | 1.0 % | 0.0 % |
//! | a ball sent round until it closes its turn (`marched`) | 80.6 % | 23.6 % |
//! | all of the turn at once | 5.3 % | 0.9 % |
//! | torques on a held cage balanced (`balance.rs`, oil) | 0.7 % | 2.5 % |
//! | from softer pockets and heavier balls, or a ball sent round from there (`patient`) | 4.3 % | 9.6 % |
//! | the same with more patience (`LONG`) | 1.3 % | 10.4 % |
//! | balls whose swinging is damped (`SETTLING`) | 3.0 % | 21.7 % |
//! | softer pockets (`SOFT`) | 2.6 % | 8.3 % |
//! | an inner ring that turns more slowly (`detours.rs`) | 1.0 % | 9.0 % |
//! | pockets that hardly hold a ball | 0.3 % | 0.0 % |
//!
//! Contacts that are damped more came later, for three of five bearings of another 500 (seed 88121) that had no orbit,
//! and torques on a held cage in dry bearings, after the patient attempts, for one of four (seed 91733). Where rings
//! turn against each other and the cage hardly moves, damping goes by the rings (seed 60923, two of four). Cages that
//! are released from slower rings, and rings tilted less, gave nothing in 304 and in 500 bearings and are not tried any
//! more. Last came more thrust, which is taken off again (`relief.rs`): it gave three of 22 bearings their orbit that
//! had none, two of them in a second instead of none in forty, and so it goes before all that is patient. Before that
//! goes a slightly other speed (`neighbours.rs`), for three of twelve bearings in oil that took longest. Before both go
//! heavier balls (`heavier.rs`), for slow bearings in oil.
//!
//! Those two balanced cages are found all at once, too, in a third of the time, so that this goes before. Of others,
//! such as a 7210 in oil under 0.5 kN thrust and 1.9 kN across it at 1000 r/min, or a 6206 in oil with dry pockets,
//! nothing else was seen to find the orbit. The finer mesh (`FINER`) gave 2 of the first 61 orbits. Damped balls and
//! softer pockets are not the case's: the answer says so.

use crate::OrbitError;
use crate::balance::balanced;
use crate::collocation::Orbit;
use crate::direct::{Reached, even};
use crate::homotopy::{Homotopy, Regularization};
use crate::newton::Newton;
use crate::residual::Found;
use crate::settings::OrbitSettings;
use crate::shooting::{CLOSE_BY, FAR, ROUNDS};
use crate::start::{self, Profile};
use tribodyn_bearing::{OperatingPoint, Side};
use tribodyn_quasistatic::{BallMotion, Model, RollingStart, solve};
use tribodyn_traction::FastPatch;

/// Error of an interval where the neighbourhood is found, over the scales.
const SCOUTED: f64 = 0.2;
/// By how much cage, ring and the closing of the turn may be off where the neighbourhood is found, and where Newton's
/// method on all unknowns takes over.
const FOUND: f64 = 3e-2;
const CLOSE: f64 = 3e-3;
/// Intervals of a first turn on which a ball is thrown about.
const THROWN_ABOUT: usize = 700;
/// Jacobians of an attempt on a mesh, and of one straight from an equilibrium.
pub(crate) const PATIENCE: usize = 14;
const DIRECT: usize = 12;
/// By how much intervals' errors are lowered where no orbit is found on a mesh.
const FINER: [f64; 2] = [1.0, 0.3];
/// Rates over the pace of the balls at which their swinging dies out besides, one after the other where no orbit is
/// found: a ball without its inner contact swings in its groove at about ten times the cage speed, and on the falling
/// part of a traction curve it swings on.
pub(crate) const SETTLING: [f64; 5] = [0.0, 3.0, 10.0, 30.0, 100.0];
/// Places of the homotopy at which an orbit is taken where none is found at its end.
const SOFT: [f64; 3] = [0.8, 0.65, 0.5];
/// Error of an interval, over what is allowed, at which a mesh is made for another orbit.
pub(crate) const OTHER: f64 = 4.0;
/// Intervals of all turns after which no attempt is begun any more: from near by, from Jones–Harris, from far, and with
/// damped balls.
pub(crate) const HASTE: usize = 5000;
const MARCH: usize = 10_000;
/// Turns like the first that such a search from Jones–Harris may take.
const TURNS: usize = 40;
const LONG: usize = 25_000;
/// Intervals of all turns from a neighbour, or turns like its own, after which a cold start is as cheap.
const NEAR: usize = 300;
const TURNS_NEAR: usize = 6;
pub(crate) const WORK: usize = 12_000;

/// The orbit, and by how much its bearing is not that of the case.
pub(crate) fn find<'a>(
    newton: &mut Newton<'a>,
    of: (&OperatingPoint, &RollingStart),
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    soon(newton, of, homotopy, settings).or_else(|_| late(newton, of, homotopy, settings))
}

/// The orbit where balls that roll soon lead to it.
///
/// # Errors
/// [`OrbitError::NotConverged`].
pub(crate) fn soon<'a>(
    newton: &mut Newton<'a>,
    (point, rolling): (&OperatingPoint, &RollingStart),
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    let real = homotopy.regularization(1.0);
    homotopy.set(&mut newton.system, 1.0);
    // What a ball comes to by itself goes before what equations alone lead to, which may be another orbit.
    let first = settled(newton, rolling, homotopy);
    if let Some(found) = followed(newton, &first, homotopy, settings) {
        return Ok((found, real));
    }
    newton.watch.stage("all of the turn at once", Some(start::cage_speed(rolling)));
    for from in starts(newton, point, rolling) {
        let met = newton.met(from, (settings.tolerance, DIRECT));
        if let Some(found) = met.and_then(|found| finished(newton, found, settings))
            && holds(newton, &found, settings)
        {
            return Ok((found, real));
        }
    }
    // In oil the cage is soon the last that is not found; elsewhere only where balls hardly reach their pockets.
    if is_in_oil(newton)
        && let Some(found) = of_held_cage(newton, &first, homotopy, settings)
    {
        return Ok((found, real));
    }
    Err(unmet(newton, &first, settings))
}

/// The orbit that a ball which rolls comes to by itself, and nothing else.
///
/// # Errors
/// [`OrbitError::NotConverged`].
pub(crate) fn alone<'a>(
    newton: &mut Newton<'a>,
    (_, rolling): (&OperatingPoint, &RollingStart),
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    homotopy.set(&mut newton.system, 1.0);
    let first = settled(newton, rolling, homotopy);
    let found = followed(newton, &first, homotopy, settings);
    found.map(|found| (found, homotopy.regularization(1.0))).ok_or_else(|| unmet(newton, &first, settings))
}

/// The orbit where they do not.
///
/// # Errors
/// [`OrbitError::NotConverged`].
pub(crate) fn late<'a>(
    newton: &mut Newton<'a>,
    (point, rolling): (&OperatingPoint, &RollingStart),
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    homotopy.set(&mut newton.system, 1.0);
    let first = settled(newton, rolling, homotopy);
    let starts = starts(newton, point, rolling);
    let found = patient(newton, (&first, starts), homotopy, settings);
    if found.is_ok() || is_in_oil(newton) {
        return found;
    }
    homotopy.set(&mut newton.system, 1.0);
    newton.system.settling = 0.0;
    let held = of_held_cage(newton, &first, homotopy, settings);
    held.map_or(found, |found| Ok((found, homotopy.regularization(1.0))))
}

/// All of a turn as Jones–Harris and the equilibrium with traction have it.
fn starts(newton: &Newton<'_>, point: &OperatingPoint, rolling: &RollingStart) -> Vec<Orbit> {
    let speed = start::cage_speed(rolling);
    let mut starts = vec![even(newton, &Profile::new(&rolling.balls, speed), (speed, rolling.ring))];
    let equilibrium = solve(newton.system.bearing, point, Model::Traction).ok().and_then(|solved| solved.warm_start);
    if let Some(start) = equilibrium {
        let balls: Vec<BallMotion> = start.balls().collect();
        let speed = start::mean_speed(&balls, &rolling.inner_loads);
        starts.push(even(newton, &Profile::new(&balls, speed), (speed, start.ring())));
    }
    starts
}

fn is_in_oil(newton: &Newton<'_>) -> bool {
    newton.system.bearing.film_law(Side::Inner).is_some()
}

/// The orbit by the torque on a cage that is held at a speed; none where the first turn was not a whole one.
fn of_held_cage<'a>(
    newton: &mut Newton<'a>,
    first: &Orbit,
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Option<Found> {
    if first.last_end() < 1.0 {
        return None;
    }
    newton.watch.stage("cages that are held at a speed", Some(first.cage_speed));
    let near = balanced(newton, first, (homotopy.scout(), settings))?;
    closed_or_met(newton, near, settings)
}

/// The orbit of balls that slide on a race, from where they would roll on slower ones, at a place of the homotopy.
///
/// # Errors
/// [`OrbitError::NotConverged`].
pub(crate) fn sliding<'a>(
    newton: &mut Newton<'a>,
    rolling: &RollingStart,
    (homotopy, share): (&Homotopy<'a>, f64),
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    let regularization = homotopy.regularization(share);
    homotopy.set_fine(&mut newton.system, share);
    let first = settled(newton, rolling, homotopy);
    if first.last_end() == 1.0
        && let Some(found) = marched(newton, &first, homotopy, (settings, HASTE))
    {
        return Ok((found, regularization));
    }
    damped(newton, &first, settings, (&SETTLING, WORK)).map(|found| (found, regularization))
}

/// The orbit by way of softer pockets and heavier balls, by damped balls, or where the homotopy ends.
fn patient<'a>(
    newton: &mut Newton<'a>,
    (first, starts): (&Orbit, Vec<Orbit>),
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Result<(Found, Regularization), OrbitError> {
    let real = homotopy.regularization(1.0);
    newton.watch.stage("softer pockets and heavier balls", Some(first.cage_speed));
    let mut furthest: Option<Reached> = None;
    for from in starts {
        let reached = newton.followed(from, homotopy, (settings.mesh_error, settings.tolerance));
        // However far the homotopy led, what follows is tried on the bearing itself.
        homotopy.set(&mut newton.system, 1.0);
        let Some(reached) = reached else { continue };
        if reached.share == 1.0 && reached.refined && holds(newton, &reached.found, settings) {
            return Ok((newton.halved(reached.found, settings.mesh_error, (settings.tolerance, DIRECT)), real));
        }
        if let Ok(found) = damped(newton, &reached.found.0, settings, (&SETTLING[..1], HASTE)) {
            return Ok((found, real));
        }
        if furthest.as_ref().is_none_or(|best| best.share < reached.share) {
            furthest = Some(reached);
        }
    }
    let last = furthest.as_ref().map_or(first, |reached| &reached.found.0);
    newton.watch.stage("balls whose swinging is damped", Some(last.cage_speed));
    let mut unmet = match damped(newton, last, settings, (&SETTLING[..1], LONG)) {
        Ok(found) => return Ok((found, real)),
        Err(unmet) => unmet,
    };
    for rate in SETTLING[1..].chunks(1) {
        match damped(newton, last, settings, (rate, WORK)) {
            Ok(found) => return Ok((found, real)),
            Err(other) => unmet = unmet.nearer(other),
        }
    }
    let near = furthest.as_ref().filter(|reached| reached.share >= SOFT[SOFT.len() - 1]);
    let near = near.map_or(first, |reached| &reached.found.0);
    for share in SOFT {
        homotopy.set_fine(&mut newton.system, share);
        if let Ok(found) = damped(newton, near, settings, (&SETTLING, WORK)) {
            return Ok((found, homotopy.regularization(share)));
        }
    }
    Err(unmet)
}

/// One turn in which a ball settles, by the cheap patches.
fn settled<'a>(newton: &mut Newton<'a>, rolling: &RollingStart, homotopy: &Homotopy<'a>) -> Orbit {
    let speed = start::cage_speed(rolling);
    let at_start = start::unknowns(&rolling.balls[start::hardest(rolling)], speed);
    newton.with_patches(homotopy.scout(), |newton| newton.march(&at_start, (speed, rolling.ring), SCOUTED))
}

fn unmet(newton: &mut Newton<'_>, first: &Orbit, settings: &OrbitSettings) -> OrbitError {
    let worst = newton.residual(first).worst;
    OrbitError::not_converged(&newton.system, first, &worst, settings.tolerance)
}

/// Sends a ball round from its first turn; none where it is thrown about in it, as it does not close its turns then.
fn followed<'a>(
    newton: &mut Newton<'a>,
    first: &Orbit,
    homotopy: &Homotopy<'a>,
    settings: &OrbitSettings,
) -> Option<Found> {
    let work = MARCH.min(TURNS * first.intervals());
    if first.intervals() < THROWN_ABOUT { marched(newton, first, homotopy, (settings, work)) } else { None }
}

/// Sends a ball round until it closes its turn; none where it does not within some work.
fn marched<'a>(
    newton: &mut Newton<'a>,
    first: &Orbit,
    homotopy: &Homotopy<'a>,
    (settings, work): (&OrbitSettings, usize),
) -> Option<Found> {
    let accuracy = (settings.mesh_error, CLOSE, ROUNDS);
    let twice = |newton: &mut Newton<'a>| {
        let near = newton.shoot(first.last(), (first.cage_speed, first.ring), (SCOUTED, FOUND, ROUNDS)).ok()?.orbit;
        newton.shoot(near.last(), (near.cage_speed, near.ring), accuracy).ok()
    };
    let turn = newton.with_patches(homotopy.scout(), |newton| newton.within(work, twice))?;
    let found = if turn.off > FAR { None } else { closed_or_met(newton, turn.orbit.clone(), settings) };
    found.or_else(|| damped(newton, &turn.orbit, settings, (&SETTLING[..1], work)).ok())
}

/// Sends a ball round from the start of a turn near by, with cheap patches, until it closes its own; none where it does
/// not soon.
pub(crate) fn closed_near(
    newton: &mut Newton<'_>,
    near: &Orbit,
    (cheap, settings): (FastPatch, &OrbitSettings),
) -> Option<Found> {
    let (start, border) = (*near.last(), (near.cage_speed, near.ring));
    let shoot = |newton: &mut Newton<'_>| newton.shoot(&start, border, (settings.mesh_error, CLOSE_BY, ROUNDS)).ok();
    let work = NEAR.max(TURNS_NEAR * near.intervals());
    let turn = newton.with_patches(cheap, |newton| newton.within(work, shoot))?;
    if turn.off > FAR { None } else { closed_or_met(newton, turn.orbit, settings) }
}

/// Newton's method on the mesh of a turn that nearly closes, or else the turn closed on it. Where that leads away from
/// the turn, to an orbit that the mesh is not made for, a ball sent round has to keep to it.
fn closed_or_met(newton: &mut Newton<'_>, orbit: Orbit, settings: &OrbitSettings) -> Option<Found> {
    let sound = |newton: &mut Newton<'_>, found: &Found| {
        let errors = newton.errors(&found.0, settings.mesh_error);
        errors.into_iter().fold(0.0, f64::max) <= OTHER || holds(newton, found, settings)
    };
    let goal = (settings.tolerance, PATIENCE);
    let met = newton.met(orbit.clone(), goal).filter(|found| sound(newton, found));
    let met = met.or_else(|| newton.closed(orbit, settings.tolerance).filter(|found| sound(newton, found)));
    met.map(|found| newton.halved(found, settings.mesh_error, goal))
}

/// True if a ball that is sent round once more keeps to an orbit. On the falling part of a traction curve there are
/// some that no ball keeps to, which equations alone do not tell from others.
pub(crate) fn holds(newton: &mut Newton<'_>, (orbit, _): &Found, settings: &OrbitSettings) -> bool {
    let border = (orbit.cage_speed, orbit.ring);
    newton.within(HASTE, |newton| newton.turn(orbit.last(), border, settings.mesh_error).off) <= FAR
}

/// An orbit on a coarse mesh made as fine as is asked for: by the errors of its intervals, or else by a ball that is
/// sent round.
fn finished(newton: &mut Newton<'_>, found: Found, settings: &OrbitSettings) -> Option<Found> {
    let goal = (settings.tolerance, DIRECT);
    let near = found.0.clone();
    if let Some(found) = newton.refined(found, settings.mesh_error, goal) {
        return Some(newton.halved(found, settings.mesh_error, goal));
    }
    let accuracy = (settings.mesh_error, CLOSE, ROUNDS);
    let border = (near.cage_speed, near.ring);
    let turn = newton.within(HASTE, |newton| newton.shoot(near.last(), border, accuracy)).ok()?;
    if turn.off > FAR { None } else { closed_or_met(newton, turn.orbit, settings) }
}

/// The orbit from its neighbourhood: turns on meshes of their own until they nearly close, then Newton's method on all
/// unknowns of the last mesh; finer, and with damped balls where that does not succeed.
///
/// # Errors
/// [`OrbitError::NotConverged`].
pub(crate) fn damped(
    newton: &mut Newton<'_>,
    near: &Orbit,
    settings: &OrbitSettings,
    (settlings, work): (&[f64], usize),
) -> Result<Found, OrbitError> {
    newton.within(work, |newton| damped_by(newton, near, settings, settlings))
}

fn damped_by(
    newton: &mut Newton<'_>,
    near: &Orbit,
    settings: &OrbitSettings,
    settlings: &[f64],
) -> Result<Found, OrbitError> {
    let mut near = near.clone();
    let mut least: Option<Found> = None;
    for (&settling, finer) in settlings.iter().flat_map(|settling| FINER.map(|finer| (settling, finer))) {
        if newton.is_spent() {
            break;
        }
        newton.system.settling = settling * newton.system.pace(near.cage_speed);
        let accuracy = (settings.mesh_error * finer, CLOSE, ROUNDS);
        let Ok(turn) = newton.shoot(near.last(), (near.cage_speed, near.ring), accuracy) else { continue };
        if turn.off.is_infinite() {
            continue;
        }
        near = turn.orbit.clone();
        if turn.off <= FAR
            && let Some(found) = closed_or_met(newton, turn.orbit.clone(), settings)
        {
            return Ok(found);
        }
        let found = (turn.orbit, turn.residual);
        if least.as_ref().is_none_or(|best| found.1.worst.relative < best.1.worst.relative) {
            least = Some(found);
        }
    }
    let (orbit, residual) = least.unwrap_or_else(|| (near.clone(), newton.residual(&near)));
    Err(OrbitError::not_converged(&newton.system, &orbit, &residual.worst, settings.tolerance))
}
