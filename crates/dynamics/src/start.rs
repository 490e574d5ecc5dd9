//! Where a run starts: the quasi-static solution at time 0, a motion that is given, or a standstill.

use crate::ball_surfaces::UNTURNED;
use crate::error::DynamicsError;
use crate::forces::evaluate;
use crate::layout::{AXIAL, AZIMUTH, BALL, OMEGA, ORBIT, RADIUS, VELOCITY};
use crate::machine::{Kernel, Machine};
use tribodyn_bearing::{AzimuthFrame, BallState, Motion, Races, RingOffset, RunInputs, Side, SpeedHistory, Start};
use tribodyn_quasistatic::{BallMotion, Model, Solution, solve};
use tribodyn_traction::{FastPatch, PatchChoice, PatchRule, Quadrature, RuleUse};
use tribodyn_wear::{Spall, SpallPath};

/// Load of the contact that bridges a spall where no ball carries any at the start, N: ellipses go with its cube root.
const LEAST_LOAD: f64 = 1.0;

/// A machine at its start.
pub(crate) struct Started {
    pub machine: Machine,
    pub state: Vec<f64>,
    pub solution: Solution,
}

/// A motion for a run to start from.
#[derive(Debug, Clone, PartialEq)]
pub struct StartMotion {
    /// Balls, cage and inner ring.
    pub motion: Motion,
    /// The patch rule that it was found with; a run that is given a target error may take another one.
    pub rule: PatchRule,
    /// The same in the form of a solution.
    pub solution: Solution,
}

/// Puts balls, cage and rings where a motion has them; the quasi-static problem of time 0 (of a standstill, where the
/// run starts from rest) is solved where none is given.
pub(crate) fn start(mut inputs: RunInputs, motion: Option<StartMotion>) -> Result<Started, DynamicsError> {
    inputs.bearing.ring_offset = RingOffset::Exact;
    let turns = inputs.speeds.inner.at(0.0) != inputs.speeds.outer.at(0.0) && inputs.options.start != Start::Rest;
    let patch = inputs.patch;
    let StartMotion { motion, rule, mut solution } = match motion {
        Some(motion) => motion,
        None => equilibrium(&inputs)?,
    };
    let (found, expected) = (motion.balls.len(), inputs.bearing.geometry.ball_count);
    if found != expected {
        return Err(DynamicsError::Balls { found, expected });
    }
    let spalls = std::mem::take(&mut inputs.spalls);
    let (ball_spalls, ball_waves) = (inputs.ball_spalls.clone(), inputs.ball_waves.clone());
    let mut machine = Machine::new(inputs, Quadrature::new(rule)?)?;
    machine.spalls = paths_over(&machine, spalls, &solution)?;
    let loads = Races::from_fn(|side| largest_load(&solution, side));
    machine.ball_surfaces.set(&machine.bearing, (&ball_spalls, &ball_waves), (&solution.balls, loads))?;
    let [x, y, z, tilt @ ..] = motion.ring;
    machine.tilt = tilt;
    let mut state = vec![0.0; machine.layout.len()];
    let l = machine.layout;
    let groove = machine.bearing.geometry.groove_centre_radius(Side::Outer);
    for (index, (azimuth, ball)) in motion.balls.iter().enumerate() {
        let b = &mut state[l.ball(index)..][..BALL];
        (b[AXIAL], b[RADIUS], b[AZIMUTH]) = (ball.position[0], ball.position[1] + groove, *azimuth);
        b[VELOCITY..ORBIT].copy_from_slice(&ball.velocity);
        b[ORBIT] = ball.orbital_speed;
        b[OMEGA..].copy_from_slice(&ball.angular_velocity);
    }
    state[l.cage() + 1] = motion.cage_speed;
    state[l.inner()..l.inner() + 3].copy_from_slice(&[x, y, z]);
    let turned = machine.bearing.deviations.turned;
    state[l.angles()..l.angles() + 2].copy_from_slice(&[turned.inner, turned.outer]);
    machine.start_free_cage(&mut state);
    machine.start_tilts(&mut state);
    state[l.orientations()].as_chunks_mut::<4>().0.iter_mut().for_each(|q| *q = UNTURNED);
    if turns && let Some((kernel, error)) = kernel_at(&machine, &state, patch) {
        machine.kernel = Kernel::Fast(kernel);
        solution.patch_error_estimate = Some(error);
    }
    set_springs(&mut machine, &state);
    Ok(Started { machine, state, solution })
}

/// Paths of the balls over spalls, for the contact of the most loaded ball. Spalls without depth are left out, so that
/// a race with such a one is whole to the last bit.
fn paths_over(
    machine: &Machine,
    spalls: Races<Vec<Spall>>,
    solution: &Solution,
) -> Result<Races<Vec<SpallPath>>, DynamicsError> {
    Races::try_from_fn(|side| {
        let track = machine.bearing.track(side, largest_load(solution, side));
        let paths = spalls[side].iter().map(|spall| spall.path(&track));
        let mut paths = paths.collect::<Result<Vec<_>, _>>()?;
        paths.retain(|path| !path.is_flat());
        Ok(paths)
    })
}

/// Load of the most loaded ball at the start for the contact over a spall, N.
fn largest_load(solution: &Solution, side: Side) -> f64 {
    solution.balls.iter().map(|ball| ball.contacts[side].load_n).fold(LEAST_LOAD, f64::max)
}

/// The equilibrium of time 0, in which each ball keeps its place.
fn equilibrium(inputs: &RunInputs) -> Result<StartMotion, DynamicsError> {
    let mut point = inputs.operating_point_at(0.0);
    match inputs.options.start {
        Start::QuasiStatic => {}
        Start::Rest => (point.inner_speed, point.outer_speed) = (0.0, 0.0),
        Start::SteadyOrbit => return Err(DynamicsError::NoMotion),
    }
    let solved = solve(&inputs.bearing, &point, Model::Traction)?;
    // A traction solution always comes with its unknowns.
    let Some(warm) = solved.warm_start else { unreachable!("a traction solution has unknowns") };
    let ball = |(index, ball): (usize, BallMotion)| {
        let (azimuth, [s_a, s_r, s_t]) = (inputs.bearing.azimuth(index), ball.angular_velocity);
        let state = BallState {
            frame: AzimuthFrame::at(azimuth),
            position: ball.position,
            velocity: [0.0; 2],
            orbital_speed: ball.orbital_speed,
            angular_velocity: [s_a + ball.orbital_speed, s_r, s_t],
            size: inputs.bearing.ball_size(index),
        };
        (azimuth, state)
    };
    let mut balls: Vec<(f64, BallState)> = warm.balls().enumerate().map(ball).collect();
    carry_along(&mut balls, &solved.solution);
    let count = balls.len() as f64;
    let cage_speed = balls.iter().fold(0.0, |mean, (_, ball)| mean + ball.orbital_speed / count);
    let motion = Motion { balls, cage_speed, ring: warm.ring() };
    let mut solution = solved.solution;
    let mut rule = warm.rule();
    if point.inner_speed == point.outer_speed
        && let Some((chosen, error)) = rule_at_speed(inputs)?
    {
        (rule, solution.patch_error_estimate) = (chosen, error);
    }
    Ok(StartMotion { motion, rule, solution })
}

/// In equilibrium a ball without load at one of the races stands still, as nothing drives it. In a bearing its cage
/// carries it along: it orbits and turns as the mean of the others.
fn carry_along(balls: &mut [(f64, BallState)], solution: &Solution) {
    let others = || balls.iter().zip(&solution.balls).filter(|(_, of)| of.is_loaded()).map(|((_, ball), _)| ball);
    let count = others().count() as f64;
    if count == 0.0 {
        return;
    }
    let mean = |of: &dyn Fn(&BallState) -> f64| others().map(of).sum::<f64>() / count;
    let orbital_speed = mean(&|ball| ball.orbital_speed);
    let angular_velocity = [0, 1, 2].map(|k| mean(&|ball| ball.angular_velocity[k]));
    for ((_, ball), _) in balls.iter_mut().zip(&solution.balls).filter(|(_, of)| !of.is_loaded()) {
        *ball = BallState { orbital_speed, angular_velocity, ..*ball };
    }
}

/// At a standstill nothing slips, and no slip tells which rule a target error needs: rule and error are those of the
/// fastest speed that the rings come to; none where they never turn against each other.
fn rule_at_speed(inputs: &RunInputs) -> Result<Option<(PatchRule, Option<f64>)>, DynamicsError> {
    let point = inputs.operating_point_at(fastest(&inputs.speeds));
    if point.inner_speed == point.outer_speed {
        return Ok(None);
    }
    let solved = solve(&inputs.bearing, &point, Model::Traction)?;
    Ok(solved.warm_start.map(|warm| (warm.rule(), solved.solution.patch_error_estimate)))
}

/// When the rings turn fastest against each other, s; the end of the tables where that is as fast.
fn fastest(speeds: &Races<SpeedHistory>) -> f64 {
    let apart = |time: f64| (speeds.inner.at(time) - speeds.outer.at(time)).abs();
    let rows = [&speeds.inner, &speeds.outer].into_iter().flat_map(|history| match history {
        SpeedHistory::Constant(_) => &[][..],
        SpeedHistory::Table(rows) => rows,
    });
    rows.map(|row| row.0).fold(f64::INFINITY, |best, time| if apart(time) > apart(best) { time } else { best })
}

/// The rule with the fewest points that keeps a target error where the run starts, and its error. That of the search
/// comes from where the search was: a 608 had 192 points for what 80 do. None where no rule keeps the target, none is
/// given, or patches are elastic.
fn kernel_at(machine: &Machine, state: &[f64], patch: PatchChoice) -> Option<(FastPatch, f64)> {
    let PatchChoice::TargetError { relative } = patch else { return None };
    let mut loads = Vec::with_capacity(machine.layout.balls);
    evaluate(machine, 0.0, state, |_, ball| loads.push(ball.loads()));
    let (rule, error) = machine.bearing.choose_rule(relative, loads, RuleUse::Run).ok()??;
    Some((FastPatch::new(rule).ok()?, error))
}

/// The inner ring's springs are without stretch at the start; the outer ring's carry its load there, and those of tilts
/// that are held their moments.
fn set_springs(machine: &mut Machine, state: &[f64]) {
    let l = machine.layout;
    (0..3).for_each(|i| machine.inner.reference[i] = state[l.inner() + i]);
    let (frame, sums, _) = evaluate(machine, 0.0, state, |_, _| ());
    for i in 0..2 {
        machine.outer.reference[i] = -sums.on_rings.outer[i] / machine.outer.stiffness[i];
    }
    for (side, ring) in frame.rings.iter() {
        let [x, y, _] = sums.moment[side];
        if let Some(tilting) = &mut machine.tilting[side] {
            tilting.set_springs(ring.tilt, [x, y]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A machine that is run up and down has its rule from the top, one that keeps its speed from the end.
    #[test]
    fn limit_the_fastest_speed_of_a_table_is_found() {
        let table = |rows: &[(f64, f64)]| SpeedHistory::Table(rows.to_vec());
        let outer = SpeedHistory::Constant(0.0);
        let up_and_down = table(&[(0.0, 0.0), (10.0, 1000.0), (20.0, 1466.0), (30.0, 0.0)]);
        assert_eq!(fastest(&Races { inner: up_and_down, outer: outer.clone() }), 20.0);
        let up = table(&[(0.0, 0.0), (10.0, 1466.0)]);
        assert_eq!(fastest(&Races { inner: up.clone(), outer }), f64::INFINITY);
        // Against an outer ring that is braked meanwhile.
        let braked = table(&[(0.0, -500.0), (12.0, 0.0)]);
        assert_eq!(fastest(&Races { inner: up, outer: braked }), 10.0);
    }
}
