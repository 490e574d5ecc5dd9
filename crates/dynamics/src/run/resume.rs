//! Going on from a checkpoint: it comes from a file, so every value of it is held against the case before it is used.

use super::{Checkpoint, Run, Scheme};
use crate::error::DynamicsError;
use crate::layout::{AXIAL, BALL, OMEGA, ORBIT, RADIUS, VELOCITY};

/// Highest speed of anything in a bearing, m/s: beyond that of sound in steel.
const FASTEST_M_S: f64 = 1e4;
/// Highest frequency of contact springs that is believed, Hz: steel balls of 0.1 mm are near 1e7.
const HIGHEST_HZ: f64 = 1e9;
/// Most steps, samples and patches that are believed: a thousand years of the shortest steps do not get there.
const MOST: u64 = 1 << 52;

impl Run {
    /// Goes on from a checkpoint of the same case.
    ///
    /// # Errors
    /// [`DynamicsError::Checkpoint`] for a checkpoint of another bearing, [`DynamicsError::CheckpointFilter`] for one
    /// of another state rate or step, [`DynamicsError::CheckpointValue`] for one with values that no run of the case
    /// can have.
    pub fn resume(&mut self, checkpoint: Checkpoint) -> Result<(), DynamicsError> {
        let (found, expected) = (checkpoint.state.len(), self.start.len());
        if [found, checkpoint.derivative.len(), checkpoint.looked.state.len()] != [expected; 3] {
            return Err(DynamicsError::Checkpoint { found, expected });
        }
        if !self.filter.remembers(&checkpoint.filter) {
            return Err(DynamicsError::CheckpointFilter { internal_rate_hz: self.filter.internal_rate_hz() });
        }
        self.check_sizes(&checkpoint)?;
        self.check_clocks(&checkpoint)?;
        self.check_motion(&checkpoint)?;
        self.check_memory(&checkpoint)?;
        self.machine.raceways = checkpoint.raceways.clone();
        self.machine.thinnest = checkpoint.thinnest;
        self.progress = checkpoint;
        Ok(())
    }

    /// Lists have an entry for each ball or unknown, or none where the scheme has not begun.
    fn check_sizes(&self, c: &Checkpoint) -> Result<(), DynamicsError> {
        let balls = self.machine.layout.balls;
        let [friction, contacts, drift, common, half, beyond] = c.fast.sizes();
        let unknowns = if c.fast.is_ready() { c.state.len() } else { 0 };
        let memory =
            if matches!(self.scheme, Scheme::Fast { .. }) && c.steps > 0 { balls } else { friction.min(balls) };
        let lists = [
            ("loaded", c.loaded.len(), balls),
            ("fast.friction", friction, memory),
            ("fast.contacts", contacts, memory),
            ("fast.drift", drift, unknowns),
            ("fast.common", common, unknowns),
            ("fast.half", half, unknowns),
            ("fast.beyond", beyond, unknowns),
        ];
        for (field, found, expected) in lists {
            if found != expected {
                return Err(refused(field, found as f64, format!("{expected} entries")));
            }
        }
        let [kept, most] = c.fast.table_size();
        if kept > most {
            return Err(refused("fast.table", kept as f64, format!("at most {most} entries")));
        }
        let over = c.over_spalls.iter().all(|over| over.is_of(&self.machine));
        if !over {
            return Err(refused("over_spalls", c.over_spalls.len() as f64, "balls and spalls of the case".to_owned()));
        }
        match c.stiffness.ball < balls {
            true => Ok(()),
            false => Err(refused("stiffness.ball", c.stiffness.ball as f64, format!("0 to {}", balls - 1))),
        }
    }

    /// Time, steps, samples and values of the filter belong together.
    fn check_clocks(&self, c: &Checkpoint) -> Result<(), DynamicsError> {
        let most = self.duration * (1.0 + 1e-12);
        if !(0.0..=most).contains(&c.time) {
            return Err(refused("time", c.time, format!("0 to {} s", self.duration)));
        }
        let near = |field, found: u64, expected: f64| {
            let allowed = || format!("about {expected:.0} after {} s", c.time);
            ((found as f64 - expected).abs() <= 1.5)
                .then_some(())
                .ok_or_else(|| refused(field, found as f64, allowed()))
        };
        // The start is a sample, handed out when the run first goes on.
        let first = if c.steps == 0 { c.samples as f64 } else { 1.0 };
        near("samples", c.samples, (c.time * self.state_rate).floor() + first)?;
        near("filter.passed", c.filter.passed(), (c.time * self.filter.internal_rate_hz()).floor() + 1.0)?;
        if let Scheme::Rk4 { step, .. } | Scheme::Fast { step } = self.scheme {
            // A step that an end cuts counts as one.
            let (least, most) = (c.time / step - 1.5, 1.01 * c.time / step + 1000.0);
            if !(least..=most).contains(&(c.steps as f64)) {
                return Err(refused("steps", c.steps as f64, format!("about {:.0} after {} s", c.time / step, c.time)));
            }
        }
        let counts = [
            ("steps", c.steps),
            ("statistics.steps", c.statistics.steps),
            ("statistics.rejected", c.statistics.rejected),
            ("statistics.cut_at_pocket", c.statistics.cut_at_pocket),
            ("statistics.force_evaluations", c.statistics.evaluations),
            ("fast.refreshed", c.fast.patches()[0]),
            ("fast.used", c.fast.patches()[1]),
        ];
        match counts.into_iter().find(|(_, count)| *count > MOST) {
            Some((field, count)) => Err(refused(field, count as f64, format!("at most {MOST}"))),
            None => Ok(()),
        }
    }

    /// Balls, cage and rings are where they can be, and no faster than sound.
    fn check_motion(&self, c: &Checkpoint) -> Result<(), DynamicsError> {
        if let Some(at) = c.state.iter().chain(&c.derivative).position(|v| !v.is_finite()) {
            let (field, all) = if at < c.state.len() { ("state", &c.state) } else { ("derivative", &c.derivative) };
            return Err(refused(field, all[at % c.state.len()], "finite numbers".to_owned()));
        }
        let (l, g) = (self.machine.layout, &self.machine.bearing.geometry);
        // As fast as that at a radius of the pitch circle or of a ball.
        let (orbit, turning) = (2.0 * FASTEST_M_S / g.pitch_diameter, 2.0 * FASTEST_M_S / g.ball_diameter);
        let within = |field, at: usize, from: f64, reach: f64| {
            let value = c.state[at];
            let allowed = || format!("{from} ± {reach}");
            ((value - from).abs() <= reach).then_some(()).ok_or_else(|| refused(field, value, allowed()))
        };
        for ball in 0..l.balls {
            let at = l.ball(ball);
            debug_assert_eq!(BALL, 9);
            within("axial position of a ball, m", at + AXIAL, self.start[at + AXIAL], g.ball_diameter)?;
            within("orbit radius of a ball, m", at + RADIUS, self.start[at + RADIUS], g.ball_diameter)?;
            within("axial velocity of a ball, m/s", at + VELOCITY, 0.0, FASTEST_M_S)?;
            within("radial velocity of a ball, m/s", at + VELOCITY + 1, 0.0, FASTEST_M_S)?;
            within("orbital speed of a ball, rad/s", at + ORBIT, 0.0, orbit)?;
            (0..3).try_for_each(|k| within("angular velocity of a ball, rad/s", at + OMEGA + k, 0.0, turning))?;
        }
        within("speed of the cage, rad/s", l.cage() + 1, 0.0, orbit)?;
        for (at, coordinates) in [(l.inner(), 3), (l.outer(), 2)] {
            (0..coordinates).try_for_each(|k| within("position of a ring, m", at + k, 0.0, g.pitch_diameter))?;
            let speed = |k| within("velocity of a ring, m/s", at + coordinates + k, 0.0, FASTEST_M_S);
            (0..coordinates).try_for_each(speed)?;
        }
        Ok(())
    }

    /// The memory of the schemes is finite, and the wear is not below zero.
    fn check_memory(&self, c: &Checkpoint) -> Result<(), DynamicsError> {
        let rate = c.stiffness.contact_frequency_hz;
        if !(0.0..=HIGHEST_HZ).contains(&rate) {
            return Err(refused("stiffness.contact_frequency_hz", rate, format!("0 to {HIGHEST_HZ:e} Hz")));
        }
        if !(c.control.step > 0.0 && c.control.step.is_finite()) {
            return Err(refused("control.step", c.control.step, "above 0 s".to_owned()));
        }
        let worn = c.worn.iter().chain([&c.thinnest.inner, &c.thinnest.outer]).find(|v| !(**v >= 0.0 && v.is_finite()));
        if let Some(&value) = worn {
            return Err(refused("worn", value, "at least 0".to_owned()));
        }
        let numbers = [c.energy_at_start].into_iter().chain(c.work).chain(c.rates).chain(c.filter.values());
        match numbers.chain(c.fast.values()).find(|v| !v.is_finite()) {
            Some(value) => Err(refused("memory of the scheme", value, "finite numbers".to_owned())),
            None => Ok(()),
        }
    }
}

fn refused(field: &'static str, value: f64, allowed: String) -> DynamicsError {
    DynamicsError::CheckpointValue { field, value, allowed }
}
