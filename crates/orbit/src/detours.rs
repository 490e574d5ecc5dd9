//! Detours to an orbit that is not found at once: over slower rings, over cages that are held at a speed, and over
//! rings that are tilted less.

use crate::attempt::{Problem, at, begun, nearby, rolled, warm};
use crate::residual::cage_torque;
use crate::search::{HASTE, SETTLING, sliding};
use crate::solved::{OrbitStart, SolvedOrbit};
use crate::start;
use crate::system::{OMEGA, ORBIT, VELOCITY};
use crate::{OrbitError, OrbitReason};
use tribodyn_bearing::{Bearing, OperatingPoint, RaceControl, RingFreedom};

/// Shares of the inner ring's speed at which balls that slide on it might roll.
const SLIDING: [f64; 7] = [0.7, 0.5, 0.35, 0.25, 0.15, 0.08, 0.03];

/// The same for cages that are held, those first that centrifugal force presses least; shares of both rings' speeds.
const HELD: [f64; 7] = [0.03, 0.1, 0.25, 0.5, 0.01, 0.75, 1.0];
const SLOW: [f64; 3] = [0.03, 0.1, 0.3];
/// Starts from which a held cage is followed.
const STARTS: usize = 3;
/// Places at which balls are sent round where all else fails.
const SOFTEST: [f64; 2] = [0.25, 0.0];
/// First factor of the cage's speed, seen from where it starts, by how much its part above one grows and shrinks, and
/// the least one.
const FACTOR: f64 = 1.3;
const GROWS: f64 = 1.5;
const SHRINKS: f64 = 0.4;
const LEAST: f64 = 3e-3;
/// Parts of a bracket that are left at its ends, part of the way to a speed within it that is gone at least, and its
/// width over the speed at which it is closed.
const MARGIN: f64 = 0.05;
const NEAREST: f64 = 0.03;
const CLOSED: f64 = 1e-6;

/// First step on the way from a ring without tilt.
const LED: f64 = 0.25;
/// Steps that are tried on a way.
const ATTEMPTS: usize = 40;

/// An orbit where a search from the balls that would roll ended with an error.
pub(crate) fn detour(problem: Problem<'_>, error: &OrbitError) -> Option<SolvedOrbit> {
    // Control by the inner race may have no balls on it that outer control leaves there.
    let watch = &problem.point.watch;
    let mut guessed = problem.bearing.clone();
    guessed.modelling.race_control = Some(RaceControl::Outer);
    watch.stage("an inner ring that turns more slowly", None);
    let slid = if skids(error) { slid(problem, &guessed) } else { None };
    let cages = || {
        watch.stage("cages that are held at a speed", None);
        held(problem, &guessed)
    };
    let tilts = || {
        watch.stage("a ring that is tilted less", None);
        led(problem, &guessed)
    };
    let pockets = || {
        watch.stage("pockets that hardly hold a ball", None);
        softest(problem)
    };
    slid.or_else(cages).or_else(tilts).or_else(pockets)
}

/// The orbit in pockets so soft that they hardly do more than take idle balls along, where there is none in stiffer
/// ones.
fn softest(problem: Problem<'_>) -> Option<SolvedOrbit> {
    let Problem { bearing, point, settings, .. } = problem;
    let at = |share: &f64| {
        begun(problem, (bearing, point), |newton, rolling, way| sliding(newton, rolling, (way, *share), settings)).ok()
    };
    SOFTEST.iter().find_map(at)
}

fn skids(error: &OrbitError) -> bool {
    matches!(error, OrbitError::NotConverged { reason: OrbitReason::GrossSkidding { .. }, .. })
}

/// The orbit of balls that slide on the inner race, from those that would roll if it turned more slowly: the slower,
/// the less centrifugal force takes them off it.
fn slid(problem: Problem<'_>, guessed: &Bearing) -> Option<SolvedOrbit> {
    let Problem { bearing, point, settings, .. } = problem;
    let slower = |share: &f64| {
        let slower = slower(point, *share);
        begun(problem, (guessed, &slower), |newton, rolling, way| sliding(newton, rolling, (way, 1.0), settings)).ok()
    };
    // What is guessed where a case states no control is that of the outer race: tried before.
    let tried = matches!(bearing.modelling.race_control, None | Some(RaceControl::Outer));
    let rolling = if tried { None } else { rolled(problem, guessed).ok() };
    rolling.or_else(|| SLIDING.iter().find_map(slower))
}

/// Rings of which the inner one turns at a share of its speed, seen from the outer one.
fn slower(point: &OperatingPoint, share: f64) -> OperatingPoint {
    OperatingPoint { inner_speed: point.outer_speed + share * (point.inner_speed - point.outer_speed), ..point.clone() }
}

/// An orbit whose cage is held, and what the balls and the fluid turn it by, N m.
struct HeldCage {
    start: OrbitStart,
    torque: f64,
}

impl HeldCage {
    fn speed(&self) -> f64 {
        self.start.orbit.cage_speed
    }
}

/// The orbit by way of cages that are held: from one whose balls slide, its speed goes to where it would go by itself,
/// until the torque on it changes its sign.
fn held(problem: Problem<'_>, guessed: &Bearing) -> Option<SolvedOrbit> {
    let Problem { point, settings, .. } = problem;
    let of_inner = HELD.iter().map(|share| (slower(point, *share), point.outer_speed));
    let both = |share: &f64| {
        let speeds = (share * point.inner_speed, share * point.outer_speed);
        (OperatingPoint { inner_speed: speeds.0, outer_speed: speeds.1, ..point.clone() }, 0.0)
    };
    let of_both = SLOW.iter().filter(|_| point.outer_speed != 0.0).map(both);
    let first = |(slower, seen_from): (OperatingPoint, f64)| {
        let solved = begun(problem, (guessed, &slower), |newton, rolling, way| {
            newton.system.held = Some(start::cage_speed(rolling));
            sliding(newton, rolling, (way, 1.0), settings)
        });
        let start = solved.ok()?.start?;
        let bearing = &start.eased.of(problem.bearing);
        let mut newton = at(Problem { bearing, ..problem }, &start, &start.orbit).ok()?;
        let means = newton.residual(&start.orbit).means;
        let torque = cage_torque(&newton.system, &start.orbit, &means);
        Some((HeldCage { start, torque }, seen_from))
    };
    of_inner.chain(of_both).filter_map(first).take(STARTS).find_map(|(first, from)| released(problem, first, from))
}

/// The orbit whose cage is free, from one whose cage is held, its speed seen from another one.
fn released(problem: Problem<'_>, first: HeldCage, from: f64) -> Option<SolvedOrbit> {
    // The last on this side of balance, and the last beyond it.
    let (mut near, mut beyond): (HeldCage, Option<HeldCage>) = (first, None);
    let (mut factor, mut part) = (FACTOR, 1.0);
    for _ in 0..ATTEMPTS {
        if problem.point.watch.stops() {
            return None;
        }
        let (next, starts) = match &beyond {
            None => (onward(&near, from, factor), vec![&near]),
            Some(beyond) => between([&near, beyond], part),
        };
        let found = starts.iter().find_map(|start| kept(problem, &start.start, Some(next)));
        let Some(found) = found else {
            (factor, part) = (1.0 + (factor - 1.0) * SHRINKS, part * SHRINKS);
            if beyond.is_none() && factor < 1.0 + LEAST || part < NEAREST && beyond.is_some() {
                return None;
            }
            continue;
        };
        (factor, part) = (1.0 + (factor - 1.0) * GROWS, f64::min(1.0, part * GROWS));
        let across = found.torque * near.torque < 0.0;
        if across || beyond.is_some() {
            // The answer where few turns lead to a free cage.
            let free = kept(problem, &found.start, None).and_then(|free| warm(problem, &free.start));
            if free.is_some() {
                return free;
            }
        } else {
            part = 1.0;
        }
        if across {
            beyond = Some(found)
        } else {
            near = found
        }
        let closed = |beyond: &HeldCage| (beyond.speed() - near.speed()).abs() < CLOSED * near.speed().abs();
        if beyond.as_ref().is_some_and(closed) {
            return None;
        }
    }
    None
}

/// The next speed of a cage in the direction of the torque on it, never past half-way to rest.
fn onward(near: &HeldCage, from: f64, factor: f64) -> f64 {
    let (speed, slip) = (near.speed(), near.speed() - from);
    let next = from + slip * if near.torque * slip > 0.0 { factor } else { 1.0 / factor };
    if next * speed < 0.5 * speed * speed { speed * (1.0 - 0.5 * (factor - 1.0).min(1.0)) } else { next }
}

/// A speed between two at which the torque has different signs, part of the way from the nearer one, and both by their
/// distance from it.
fn between([near, beyond]: [&HeldCage; 2], part: f64) -> (f64, Vec<&HeldCage>) {
    let share = (near.torque / (near.torque - beyond.torque)).clamp(MARGIN, 1.0 - MARGIN);
    let (starts, share) = if share < 0.5 { ([near, beyond], share) } else { ([beyond, near], 1.0 - share) };
    (starts[0].speed() + part * share * (starts[1].speed() - starts[0].speed()), starts.to_vec())
}

/// The orbit near one that is not, its cage held at a speed or free.
fn kept(problem: Problem<'_>, near: &OrbitStart, speed: Option<f64>) -> Option<HeldCage> {
    let mut orbit = near.orbit.clone();
    if let Some(speed) = speed {
        let from = problem.point.outer_speed;
        let (all, share) = (speed / orbit.cage_speed, (speed - from) / (orbit.cage_speed - from));
        for y in orbit.values.iter_mut().flatten() {
            y[VELOCITY..ORBIT].iter_mut().for_each(|v| *v *= all);
            y[ORBIT] = from + share * (y[ORBIT] - from);
            y[OMEGA..].iter_mut().for_each(|w| *w *= share);
        }
        orbit.cage_speed = speed;
    }
    let bearing = &near.eased.of(problem.bearing);
    let mut newton = at(Problem { bearing, ..problem }, near, &orbit).ok()?;
    newton.system.held = speed;
    let (orbit, residual) = nearby(&mut newton, &orbit, problem.settings, (&SETTLING[..1], HASTE))?;
    let torque = cage_torque(&newton.system, &orbit, &residual.means);
    let start = OrbitStart { orbit, jacobian: None, settling: newton.system.settling, ..near.clone() };
    Some(HeldCage { start, torque })
}

/// The orbit by way of rings that are tilted less, each from the orbit of the one before.
fn led(problem: Problem<'_>, guessed: &Bearing) -> Option<SolvedOrbit> {
    let point = problem.point;
    let first = less_tilted(point, 0.0);
    if first == *point {
        return None;
    }
    let mut reached = rolled(Problem { point: &first, ..problem }, guessed).ok()?;
    let (mut share, mut step) = (0.0, LED);
    for _ in 0..ATTEMPTS {
        let next = f64::min(share + step, 1.0);
        match warm(Problem { point: &less_tilted(point, next), ..problem }, reached.start.as_ref()?) {
            Some(solved) if next == 1.0 => return Some(solved),
            Some(solved) => (reached, share, step) = (solved, next, step * GROWS),
            None => step *= SHRINKS,
        }
    }
    None
}

/// The problem with a share of the ring's tilts, or of the moments that tilt it.
fn less_tilted(point: &OperatingPoint, share: f64) -> OperatingPoint {
    let mut easier = point.clone();
    for freedom in &mut easier.ring[3..] {
        *freedom = match *freedom {
            RingFreedom::Held(tilt) => RingFreedom::Held(tilt * share),
            RingFreedom::Loaded(_) if share == 0.0 => RingFreedom::Held(0.0),
            RingFreedom::Loaded(moment) => RingFreedom::Loaded(moment * share),
        };
    }
    easier
}
