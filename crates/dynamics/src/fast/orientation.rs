//! Orientations of balls with spalls in the drift.

use super::Fast;
use super::lanes::{WIDTH, get};
use crate::ball_spalls::turned_on;
use crate::layout::{AZIMUTH, SPIN};
use crate::machine::Machine;
use tribodyn_bearing::SPALLED_BALLS;

impl Fast {
    /// Azimuths of the balls with spalls, rad.
    pub(super) fn azimuths_of_spalled(&self, machine: &Machine) -> [f64; SPALLED_BALLS] {
        let mut azimuths = [0.0; SPALLED_BALLS];
        for (to, ball) in azimuths.iter_mut().zip(machine.ball_spalls.balls()) {
            *to = self.scratch.balls[ball / WIDTH][AZIMUTH].0[ball % WIDTH];
        }
        azimuths
    }

    /// Turns balls with spalls by their spins over a time, s, against their azimuth frames, which have turned on from
    /// azimuths (rad).
    pub(super) fn turn_spalled(&self, machine: &Machine, y: &mut [f64], (before, h): ([f64; SPALLED_BALLS], f64)) {
        let start = machine.layout.orientations().start;
        for (slot, (ball, before)) in machine.ball_spalls.balls().iter().zip(before).enumerate() {
            let b = get(&self.scratch.balls[ball / WIDTH], ball % WIDTH);
            let by = [h * b[SPIN] - (b[AZIMUTH] - before), h * b[SPIN + 1], h * b[SPIN + 2]];
            let at = start + 4 * slot;
            let turned = turned_on(std::array::from_fn(|k| y[at + k]), by);
            y[at..at + 4].copy_from_slice(&turned);
        }
    }
}
