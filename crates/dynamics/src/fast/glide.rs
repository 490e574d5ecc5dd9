//! Velocities by the accelerations of the drift, and positions by the velocities.

use super::drift::Pressed;
use super::lanes::{InUse, Lane, get, put};
use crate::layout::{AXIAL, AZIMUTH, BALL, Layout, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;

/// Velocities of the balls of a block by the drift's accelerations less the common part over `h`, and what that adds
/// to the mean accelerations of a step of which it is a `share`. Where balls `strike`, all that acts along the orbit is
/// the kick's.
#[inline(always)]
pub(super) fn push_balls(
    balls: &mut [Lane; BALL],
    (pressed, common): (&Pressed, &[Lane; 3]),
    mean: &mut [Lane; 3],
    (h, share, strike): (f64, f64, bool),
) {
    let (acceleration, along) = (pressed.acceleration(), if strike { 0.0 } else { h });
    for k in pressed.in_use.lanes() {
        for (i, h) in [h, h, along].into_iter().enumerate() {
            let a = acceleration[i].0[k];
            balls[VELOCITY + i].0[k] += h * (a - common[i].0[k]);
            mean[i].0[k] += share * a;
        }
    }
}

/// Velocities of rings and cage, and the same of their mean accelerations.
pub(super) fn push_bodies(
    l: Layout,
    y: &mut [f64],
    (a, common): (&[f64], &[f64]),
    mean: &mut [f64],
    (h, share): (f64, f64),
) {
    l.velocities_of_bodies().for_each(|k| mean[k] += share * a[k]);
    for k in l.velocities_of_cage().chain(l.velocities_of_tilts()) {
        y[k] += h * a[k];
    }
    for k in l.velocities_of_rings() {
        y[k] += h * (a[k] - common[k]);
    }
}

/// Positions of the balls of a block by their velocities: half a turn, the straight line, half a turn, the angular
/// momentum held, also that of the orbital speeds `before`.
#[inline(always)]
pub(super) fn glide_balls(balls: &mut [Lane; BALL], before: &mut [Lane; 3], in_use: InUse, h: f64) {
    for k in in_use.lanes() {
        let mut b = get(balls, k);
        let r = b[RADIUS];
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
        b[AXIAL] += h * b[VELOCITY];
        b[RADIUS] += h * b[VELOCITY + 1];
        let ratio = r / b[RADIUS];
        b[ORBIT] *= ratio * ratio;
        before[2].0[k] *= ratio * ratio;
        b[AZIMUTH] += 0.5 * h * b[ORBIT];
        put(balls, k, b);
    }
}

/// Positions of cage and rings by their velocities.
pub(super) fn glide_bodies(machine: &Machine, t: f64, y: &mut [f64], h: f64) {
    let l = machine.layout;
    machine.glide_free_cage(y, h);
    y[l.cage()] += h * y[l.cage() + 1];
    for [place, velocity] in l.translations() {
        y[place] += h * y[velocity];
    }
    machine.glide_tilts(y, h);
    // Prescribed speeds: the middle of the step is exact for speeds that change in proportion to time.
    for (side, speed) in machine.speeds.iter() {
        y[l.angles() + side as usize] += h * speed.at(t + 0.5 * h);
    }
}
