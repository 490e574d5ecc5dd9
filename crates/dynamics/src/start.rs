//! Where a run starts: the quasi-static solution at time 0, or a standstill.

use crate::equations::Equations;
use crate::error::DynamicsError;
use crate::forces::Sums;
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, SPIN};
use crate::machine::Machine;
use tribodyn_bearing::{RingOffset, RunInputs, Side, Start};
use tribodyn_quasistatic::{BallMotion, Model, Solution, WarmStart, solve};
use tribodyn_traction::{PatchRule, Quadrature};

/// A machine at its start.
pub(crate) struct Started {
    pub machine: Machine,
    pub state: Vec<f64>,
    pub solution: Solution,
}

/// Solves the quasi-static problem of time 0 (of a standstill, where the run starts from rest), takes its patch rule
/// and puts balls, cage and rings there.
pub(crate) fn start(mut inputs: RunInputs) -> Result<Started, DynamicsError> {
    let mut point = inputs.operating_point_at(0.0);
    if inputs.options.start == Start::Rest {
        (point.inner_speed, point.outer_speed) = (0.0, 0.0);
    }
    inputs.bearing.ring_offset = RingOffset::Exact;
    let solved = solve(&inputs.bearing, &point, Model::Traction)?;
    // A traction solution always comes with its unknowns.
    let Some(warm) = solved.warm_start else { unreachable!("a traction solution has unknowns") };
    let quadrature = Quadrature::new(rule_of_the_run(&inputs, &warm)?)?;
    let mut machine = Machine::new(inputs, quadrature)?;
    let [x, y, z, tilt @ ..] = warm.ring();
    machine.tilt = tilt;
    let mut state = vec![0.0; machine.layout.len()];
    let l = machine.layout;
    let groove = machine.bearing.geometry.groove_centre_radius(Side::Outer);
    let mut mean = 0.0;
    for (index, ball) in warm.balls().enumerate() {
        let BallMotion { position: [x1, x2], spin: [s_a, s_r, s_t], orbital_speed: orbit } = ball;
        let b = &mut state[l.ball(index)..][..BALL];
        (b[AXIAL], b[RADIUS], b[AZIMUTH]) = (x1, x2 + groove, machine.bearing.azimuth(index));
        b[ORBIT] = orbit;
        b[SPIN..SPIN + 3].copy_from_slice(&[s_a + orbit, s_r, s_t]);
        mean += orbit / l.balls as f64;
    }
    state[l.cage() + 1] = mean;
    state[l.inner()..l.inner() + 3].copy_from_slice(&[x, y, z]);
    set_springs(&mut machine, &state);
    Ok(Started { machine, state, solution: solved.solution })
}

/// At a standstill no slip tells which rule a target error needs: it is taken from the solution at the end of the ramp.
fn rule_of_the_run(inputs: &RunInputs, at_start: &WarmStart) -> Result<PatchRule, DynamicsError> {
    if inputs.options.start != Start::Rest {
        return Ok(at_start.rule());
    }
    let solved = solve(&inputs.bearing, &inputs.operating_point_at(f64::INFINITY), Model::Traction)?;
    Ok(solved.warm_start.map_or(at_start.rule(), |warm| warm.rule()))
}

/// The inner ring's springs are without stretch at the start; the outer ring's carry its load there.
fn set_springs(machine: &mut Machine, state: &[f64]) {
    let l = machine.layout;
    (0..3).for_each(|i| machine.inner.reference[i] = state[l.inner() + i]);
    let frame = machine.frame(0.0, state);
    let mut sums = Sums::default();
    for index in 0..l.balls {
        let b = machine.unknowns(index, state);
        let forces = machine.ball(index, b, &frame, |patch| machine.kernel.traction(&machine.bearing, patch));
        machine.add_ball(&forces, [0.0; 2], &frame, &mut sums);
    }
    for i in 0..2 {
        machine.outer.reference[i] = -sums.on_rings.outer[i] / machine.outer.stiffness[i];
    }
}
