//! Orientations of balls that are not round in the drift.

use super::Fast;
use super::lanes::{WIDTH, get};
use super::scratch::Scratch;
use crate::ball_surfaces::turned_on;
use crate::layout::{AZIMUTH, OMEGA};
use crate::machine::Machine;

impl Fast {
    /// Remembers the azimuths of the balls that are not round.
    pub(super) fn remember_azimuths(&mut self, machine: &Machine) {
        let Scratch { azimuths, balls, .. } = &mut self.scratch;
        azimuths.clear();
        azimuths.extend(machine.ball_surfaces.balls().iter().map(|ball| balls[ball / WIDTH][AZIMUTH].0[ball % WIDTH]));
    }

    /// Turns balls that are not round by their angular velocities over a time, s, against their azimuth frames, which
    /// have turned on from what is remembered.
    pub(super) fn turn_marked(&self, machine: &Machine, y: &mut [f64], h: f64) {
        let start = machine.layout.orientations().start;
        for (slot, (ball, before)) in machine.ball_surfaces.balls().iter().zip(&self.scratch.azimuths).enumerate() {
            let b = get(&self.scratch.balls[ball / WIDTH], ball % WIDTH);
            let by = [h * b[OMEGA] - (b[AZIMUTH] - before), h * b[OMEGA + 1], h * b[OMEGA + 2]];
            let at = start + 4 * slot;
            let turned = turned_on(std::array::from_fn(|k| y[at + k]), by);
            y[at..at + 4].copy_from_slice(&turned);
        }
    }
}
