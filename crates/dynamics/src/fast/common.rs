//! The common part of the accelerations, which the drift goes without and the kick gives back.
//!
//! Friction holds a ball where the drift pushes it along its races. If the kick alone knew of the friction and the
//! drift alone of the push, velocities in the middle of a step would be off by half a step of the push, however stiff
//! the friction is, and all motions by the first order of the step. Across the grooves, where balls are pushed most,
//! the common part is therefore the drift's whole acceleration.
//!
//! Against the races it is hardly anything, as it would feed what vibrates there: with a spring of angular frequency ω
//! and steps of H it follows by 1/(1 + 2 (ω H)²). With 1 for the 2 some vibrations without damping grow, with 4 those
//! with damping die out more slowly. It follows in half a millisecond at the soonest, and so does the part along the
//! orbit.
//!
//! Where balls strike, all that acts along the orbit in a drift is given back by the kick at its end, and the drift
//! goes without it. The race pushes a ball over an edge many times as hard as friction can: a drift with that push
//! would shift the ball to full slip on one side, where traction hardly changes with slip, and the kick would throw it
//! to the other. Carried on over half a millisecond, even a fortieth of it would. Balls then have the push half a step
//! late, but all of it: momentum holds.

use super::Fast;
use super::drift::Pressed;
use super::implicit::{Line, Weights, solve};
use super::lanes::{Lane, get, put};
use super::scratch::Scratch;
use crate::machine::Machine;
use fearless_simd::dispatch;
use tribodyn_bearing::Side;

/// The 2 above.
const OF_VIBRATION: f64 = 2.0;
/// Time in which it follows against the races at the soonest, s.
const TIME: f64 = 5e-4;
/// Time in which the common part of the rings follows their acceleration, s: they are heavy, friction hardly holds
/// them, and they vibrate at low frequencies.
const RING_TIME: f64 = 5e-3;

/// By how much the common part of a spring's acceleration follows it, at ω H.
#[cfg(test)]
pub(super) fn share(angle: f64) -> f64 {
    1.0 / (1.0 + OF_VIBRATION * angle * angle)
}

/// The common parts of the balls of a block, those given back, and the mean accelerations that they follow.
type Parts<'a> = (&'a mut [Lane; 3], &'a mut [Lane; 3], &'a [Lane; 3]);

/// Lets the common parts of the balls of a block follow, that along the orbit by a share `along`; given back is the
/// mean of before and after. Where balls `strike`, all that acts along the orbit is given back at once.
#[inline(always)]
fn follow_balls(
    (common, given, mean): Parts<'_>,
    pressed: &Pressed,
    (weights, least, along, strike): (Weights, f64, f64, bool),
) {
    for k in pressed.in_use.lanes() {
        let (mut now, drift) = (get(common, k), get(mean, k));
        now[2] = if strike { drift[2] } else { now[2] };
        let of_ball = (weights, pressed.relative_mass(k));
        let springs = [
            Line::of(&pressed.contact(Side::Inner, k), Side::Inner, of_ball),
            Line::of(&pressed.contact(Side::Outer, k), Side::Outer, of_ball).with_spring_of_at_least(least),
        ];
        let [axial, radial] = solve(springs, [drift[0] - now[0], drift[1] - now[1]]);
        let next = [now[0] + axial, now[1] + radial, now[2] + along * (drift[2] - now[2])];
        put(given, k, [0.5 * (now[0] + next[0]), 0.5 * (now[1] + next[1]), 0.5 * (now[2] + next[2])]);
        put(common, k, next);
    }
}

impl Fast {
    /// Lets the common parts follow the mean accelerations by the drift over a step, which the kicks themselves do not
    /// change: those at the end have what kicks set swinging in them, and would feed it.
    ///
    /// The kick gives back what the drifts on either side of it go without, half of each.
    pub(super) fn follow_drift(&mut self, machine: &Machine, h: f64) {
        let weights = Weights { of_spring: OF_VIBRATION * h * h / machine.bearing.ball_mass, of_damper: 0.0 };
        let least = TIME / h;
        let (along, strike) = (1.0 / (1.0 + least), machine.is_damaged());
        let Scratch { level, mean, common, given_back, pressed, .. } = &mut self.scratch;
        for (((common, given), mean), pressed) in common.iter_mut().zip(given_back).zip(mean).zip(pressed) {
            dispatch!(*level, _simd => follow_balls((common, given, mean), pressed, (weights, least, along, strike)));
        }
        let share = (h / RING_TIME).min(1.0);
        for k in machine.layout.velocities_of_bodies() {
            let before = self.common[k];
            self.common[k] += share * (self.mean[k] - before);
            self.given_back[k] = 0.5 * (before + self.common[k]);
        }
    }
}
