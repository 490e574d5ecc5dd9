//! Further methods where Newton's method finds no solution, and the reason given where nothing helps.
//!
//! With traction: pseudo-time for ring and balls together, from rolling and from skidding. Jones–Harris: from a slower
//! bearing up. Nothing here runs while the usual way succeeds, so that its solutions keep their digits.

use crate::block::{BlockState, Iterate, OMEGA, ORBIT, SolverStatistics};
use crate::driver;
use crate::jones_harris::{JonesHarris, kinematics};
use crate::methods::{Downhill, NewtonOrNested};
use crate::problem::Reason;
use crate::relax::relax;
use crate::report::SKIDDING;
use crate::settle::FROM_AFAR;
use crate::with_traction::WithTraction;
use tribodyn_bearing::{OperatingPoint, Races, Side};

/// Residual at which pseudo-time gives way to Newton's method.
const RELAXED: f64 = 1e-7;
/// Steps of pseudo-time over the iterations that the case allows: a fall from rolling to rest takes some hundred.
const STEPS_OF_PSEUDO_TIME: usize = 2;
/// Shares of the rolling speed at which skidding balls start.
const SKIDDING_STARTS: [f64; 2] = [0.3, 0.05];
/// Relative residual of the balances below which only rounding is left: slip in the last digit of a surface speed.
const ROUNDING: f64 = 1e-9;
/// The same where pseudo-time and Newton's method have both come to rest.
const ROUNDING_AT_REST: f64 = 1e-7;
/// First and least share of the speed by which Jones–Harris goes up.
const SPEED_STRIDES: [f64; 2] = [0.25, 0.01];
/// Residual of the elastic state: Newton's method goes on from there.
const ELASTIC: f64 = 1e-6;
const RPM_PER_RAD_S: f64 = 30.0 / std::f64::consts::PI;

/// Tries again from several states; gives what came nearest to balance.
pub(crate) fn with_traction(
    system: &WithTraction<'_>,
    mut nearest: Iterate,
    [rolling, settled]: [BlockState; 2],
    point: &OperatingPoint,
) -> Iterate {
    let (tolerance, limit) = (point.numerics.tolerance, point.numerics.max_iterations);
    let slow = SKIDDING_STARTS.map(|share| slowed(system, &rolling, share));
    let starts = [settled, rolling].into_iter().chain(slow);
    for start in starts {
        if nearest.worst().residual <= tolerance.max(ROUNDING) {
            break;
        }
        let relaxed = relax(system, start, RELAXED, FROM_AFAR, STEPS_OF_PSEUDO_TIME * limit);
        let method = NewtonOrNested::new(0.1 * tolerance, 0);
        let mut solved = driver::run(system, Iterate::new(system, relaxed), method, tolerance, limit);
        solved.statistics.rescues += 1;
        solved.statistics = nearest.statistics + solved.statistics;
        if solved.worst().residual < nearest.worst().residual {
            nearest = solved;
        } else {
            nearest.statistics = solved.statistics;
        }
    }
    nearest
}

/// A state whose balls turn and orbit at a share of their speed, seen from the outer ring.
fn slowed(system: &WithTraction<'_>, state: &BlockState, share: f64) -> BlockState {
    let outer = system.speeds.outer;
    let mut slow = state.clone();
    for ball in &mut slow.balls {
        (OMEGA..ORBIT).for_each(|k| ball[k] *= share);
        ball[ORBIT] = outer + (ball[ORBIT] - outer) * share;
    }
    slow
}

/// Why the nearest state with traction is no equilibrium.
pub(crate) fn why_no_steady_state(system: &WithTraction<'_>, nearest: &Iterate) -> Reason {
    let residual = nearest.worst().residual;
    if residual <= ROUNDING_AT_REST {
        return rounding(residual);
    }
    let radius = system.bearing.geometry.ball_radius();
    let (mut skidding, mut idle, mut speed, mut rolling) = (0, 0, 0.0, 0.0);
    for (index, &ball) in nearest.state.balls.iter().enumerate() {
        let (state, loads, _) = system.evaluate(index, ball, nearest.state.ring);
        let inner = &loads.contacts.inner;
        let off = system.typical.is_idle(inner.normal.load);
        idle += usize::from(off);
        skidding += usize::from(!off && inner.slide_to_roll(radius)[0].abs() > SKIDDING);
        speed += ball[ORBIT];
        rolling += kinematics(system.bearing, (&loads.pose(), &state.size), system.speeds, false, true).orbital_speed;
    }
    let balls = nearest.state.balls.len();
    if skidding + idle == 0 {
        return Reason::Unknown;
    }
    let mean_rpm = |sum: f64| sum / balls as f64 * RPM_PER_RAD_S;
    Reason::Skidding { skidding, idle, balls, cage_speed_rpm: mean_rpm(speed), rolling_rpm: mean_rpm(rolling) }
}

/// With room for the next digit to be unlucky.
fn rounding(residual: f64) -> Reason {
    Reason::Rounding { attainable: 10f64.powf((3.0 * residual).log10().ceil()) }
}

/// Why the nearest state at rest is no equilibrium.
pub(crate) fn why_not_at_rest(nearest: &Iterate) -> Reason {
    let residual = nearest.worst().residual;
    if residual <= ROUNDING_AT_REST { rounding(residual) } else { Reason::Unknown }
}

/// Goes from slow to fast; gives what came nearest and the share of the speed that was reached. `elastic` is the state
/// without gyroscopic moments, under the centrifugal force (N) of the full speed.
pub(crate) fn jones_harris(
    system: &mut JonesHarris<'_>,
    failed: Iterate,
    (elastic, centrifugal): (&Iterate, f64),
    point: &OperatingPoint,
) -> (Iterate, f64) {
    let speeds = system.speeds;
    let (mut state, mut reached, mut stride) = (elastic.state.clone(), 0.0, SPEED_STRIDES[0]);
    let mut statistics = failed.statistics;
    statistics.rescues += 1;
    while stride >= SPEED_STRIDES[1] {
        let share = f64::min(reached + stride, 1.0);
        system.speeds = speeds.map(|speed| share * speed);
        let mut solved = at_speed(system, state.clone(), (share, reached), centrifugal, point);
        statistics = statistics + solved.statistics;
        solved.statistics = statistics;
        if solved.worst().residual > point.numerics.tolerance {
            stride *= 0.5;
        } else if share >= 1.0 {
            system.speeds = speeds;
            return (solved, 1.0);
        } else {
            (state, reached, stride) = (solved.state, share, 1.5 * stride);
        }
    }
    system.speeds = speeds;
    (Iterate { statistics, ..failed }, reached)
}

/// The equilibrium at a share of the speed: from that at a lower share, and from the elastic state under the
/// centrifugal force of this one. Under that of the full speed the balls of a light bearing stand where no slow one has
/// them.
fn at_speed(
    system: &mut JonesHarris<'_>,
    state: BlockState,
    (share, reached): (f64, f64),
    centrifugal: f64,
    point: &OperatingPoint,
) -> Iterate {
    let (tolerance, limit) = (point.numerics.tolerance, point.numerics.max_iterations);
    let newton = |system: &JonesHarris<'_>, state: BlockState| {
        driver::run(system, Iterate::new(system, state), NewtonOrNested::newton_alone(), tolerance, limit)
    };
    let mut before = SolverStatistics::default();
    if reached > 0.0 {
        let solved = newton(system, state.clone());
        if solved.worst().residual <= tolerance {
            return solved;
        }
        before = solved.statistics;
    }
    system.frozen = Some(centrifugal * share * share);
    let elastic = driver::run(system, Iterate::new(system, state), Downhill { mu: 1.0 }, ELASTIC, limit);
    system.frozen = None;
    let mut solved = newton(system, elastic.state);
    solved.statistics = before + elastic.statistics + solved.statistics;
    solved
}

/// Why raceway control has no equilibrium.
pub(crate) fn why_no_raceway_control(system: &JonesHarris<'_>, nearest: &Iterate, speed_share: f64) -> Reason {
    let residual = nearest.worst().residual;
    if residual <= ROUNDING_AT_REST {
        return rounding(residual);
    }
    let mut friction = 0.0f64;
    for (index, &ball) in nearest.state.balls.iter().enumerate() {
        let pose = system.pose(index, ball, nearest.state.ring);
        let inner = system.inner_control[index];
        let side = if inner { Side::Inner } else { Side::Outer };
        let Races { inner: at_inner, outer: at_outer } = &pose.contacts;
        let (load, _) = system.bearing.contact_load(side, if inner { at_inner } else { at_outer });
        let size = system.bearing.ball_size(index);
        let moment = kinematics(system.bearing, (&pose, &size), system.speeds, inner, true).gyroscopic_moment;
        let needed = (2.0 * moment / system.bearing.geometry.ball_diameter).abs() / load;
        friction = friction.max(if needed.is_nan() { f64::INFINITY } else { needed });
    }
    Reason::RacewayControl { friction, speed_share }
}
