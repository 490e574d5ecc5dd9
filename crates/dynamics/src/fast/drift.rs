//! The drift: motion under contact springs, supports, loads and the centrifugal force.

use super::Stand;
use crate::forces::Sums;
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use tribodyn_bearing::traction::TractionLaw;

/// Accelerations of balls, rings and cage by contact forces, supports, loads and the centrifugal force; of
/// the orbital speed, the rate of the angular momentum over m r². The centrifugal force is here and not in the glide so
/// that dampers see the velocity of the middle of a step and not half a step of it.
pub(super) fn drift_acceleration<L: TractionLaw>(
    machine: &Machine<L>,
    t: f64,
    y: &[f64],
    a: &mut [f64],
    stands: &mut Vec<Stand>,
) {
    let l = machine.layout;
    stands.clear();
    let frame = machine.frame(t, y);
    let m = machine.bearing.ball_mass;
    let mut sums = Sums::default();
    for index in 0..l.balls {
        let b = &y[l.ball(index)..][..BALL];
        let (state, surfaces) = machine.ball_state(b, &frame);
        let normal =
            machine.bearing.normal_loads(&state, [&frame.rings[0], &frame.rings[1]], [&surfaces[0], &surfaces[1]]);
        stands.push(Stand { azimuth: state.azimuth, position: state.position, normal, surfaces });
        let ([n_a, n_r], [o_a, o_r]) =
            ([normal.inner.pose.sin, normal.inner.pose.cos], [normal.outer.pose.sin, normal.outer.pose.cos]);
        let (i, o) = (normal.inner.force, normal.outer.force);
        let at = l.ball(index);
        let r = normal.orbit_radius;
        a[at + VELOCITY] = (i * n_a - o * o_a) / m;
        a[at + VELOCITY + 1] = (i * n_r - o * o_r) / m + r * b[ORBIT] * b[ORBIT];
        a[at + ORBIT] = normal.eccentricity / (m * r);
        let on_inner = inertial(state.azimuth, [i * n_a, i * n_r, 0.0]);
        let on_outer = inertial(state.azimuth, [-o * o_a, -o * o_r, 0.0]);
        for k in 0..3 {
            sums.on_rings[0][k] -= on_inner[k];
            sums.on_rings[1][k] -= on_outer[k];
        }
    }
    let bodies = machine.bodies(t, &frame, &sums);
    a[l.cage() + 1] = bodies.cage;
    a[l.inner() + 3..l.inner() + 6].copy_from_slice(&bodies.inner);
    a[l.outer() + 2..l.outer() + 4].copy_from_slice(&bodies.outer);
}

/// Velocities by the drift's accelerations.
pub(super) fn push<L>(machine: &Machine<L>, y: &mut [f64], (a, common): (&[f64], &[f64]), h: f64) {
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
pub(super) fn glide<L>(machine: &Machine<L>, t: f64, y: &mut [f64], h: f64) {
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
    for (k, speed) in machine.speeds.iter().enumerate() {
        y[l.angles() + k] += h * speed.at(t + 0.5 * h);
    }
}

/// [a, r, t] at an azimuth as (x, y, z).
pub(super) fn inertial([sin, cos]: [f64; 2], [a, r, t]: [f64; 3]) -> [f64; 3] {
    [r * cos - t * sin, r * sin + t * cos, a]
}
