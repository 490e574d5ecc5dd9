//! The drift: motion under contact springs, supports, loads and the centrifugal force.

use super::Stand;
use crate::equations::Equations;
use crate::forces::Sums;
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use tribodyn_bearing::Side;

/// Accelerations of balls, rings and cage by the spring part, supports and loads; of the orbital speed, the rate of the
/// angular momentum over m r². The centrifugal force is here and not in the glide so that dampers see the velocity of
/// the middle of a step and not half a step of it.
pub(super) fn drift_acceleration<E: Equations>(
    equations: &E,
    t: f64,
    y: &[f64],
    a: &mut [f64],
    stands: &mut Vec<Stand>,
) {
    let machine = equations.machine();
    let l = machine.layout;
    stands.clear();
    let frame = machine.frame(t, y);
    let mut sums = Sums::default();
    for index in 0..l.balls {
        let b = machine.unknowns(index, y);
        let (axes, position, surfaces) = machine.place(b, &frame);
        let state = equations.state_at(axes, position, b);
        let springs = equations.springs(&state, &surfaces, &frame);
        let at = l.ball(index) + VELOCITY;
        a[at..at + 3].copy_from_slice(&equations.spring_acceleration(&springs, state.orbital_speed));
        for side in Side::BOTH {
            let on_ring = springs.normal.contacts[side].on_ring(side, machine.bearing.ring_offset);
            Machine::react(&mut sums, side, axes, on_ring.map(|f| -f));
        }
        stands.push(Stand { axes, position, normal: springs.normal, surfaces });
    }
    let bodies = machine.bodies(t, &frame, &sums);
    a[l.cage() + 1] = bodies.cage;
    a[l.inner() + 3..l.inner() + 6].copy_from_slice(&bodies.inner);
    a[l.outer() + 2..l.outer() + 4].copy_from_slice(&bodies.outer);
}

/// Velocities by the drift's accelerations.
pub(super) fn push(machine: &Machine, y: &mut [f64], (a, common): (&[f64], &[f64]), h: f64) {
    let l = machine.layout;
    let count = BALL * l.balls;
    let parts = a[..count].as_chunks::<BALL>().0.iter().zip(common[..count].as_chunks::<BALL>().0);
    for (y, (a, common)) in y[..count].as_chunks_mut::<BALL>().0.iter_mut().zip(parts) {
        for k in VELOCITY..=ORBIT {
            y[k] += h * (a[k] - common[k]);
        }
    }
    y[l.cage() + 1] += h * a[l.cage() + 1];
    for k in (l.inner() + 3..l.inner() + 6).chain(l.outer() + 2..l.outer() + 4) {
        y[k] += h * (a[k] - common[k]);
    }
}

/// Positions by the velocities: half a turn, the straight line, half a turn, the angular momentum held.
pub(super) fn glide(machine: &Machine, t: f64, y: &mut [f64], h: f64) {
    let l = machine.layout;
    for index in 0..l.balls {
        let b = &mut y[l.ball(index)..][..BALL];
        let r = b[RADIUS];
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
        b[AXIAL] += h * b[VELOCITY];
        b[RADIUS] += h * b[VELOCITY + 1];
        b[ORBIT] *= (r / b[RADIUS]).powi(2);
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
    }
    y[l.cage()] += h * y[l.cage() + 1];
    for k in l.inner()..l.inner() + 3 {
        y[k] += h * y[k + 3];
    }
    for k in l.outer()..l.outer() + 2 {
        y[k] += h * y[k + 2];
    }
    // Prescribed speeds: the middle of the step is exact for speeds that change in proportion to time.
    for (side, speed) in machine.speeds.iter() {
        y[l.angles() + side as usize] += h * speed.at(t + 0.5 * h);
    }
}
