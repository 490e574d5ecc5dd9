//! Who watches a run: the solver hands out samples and events, and asks whether to go on.

use crate::sample::Sample;
use serde::{Deserialize, Serialize};
use std::convert::Infallible;
use std::ops::ControlFlow;

/// Watches a run. Its error ends the run.
pub trait Observer {
    /// What can go wrong with watching, for instance a full disk.
    type Error;

    /// A sample. `with_balls` tells whether it is one of those at the ball rate; its balls are filled in always.
    ///
    /// Break ends the run early, without an error.
    ///
    /// # Errors
    /// Whatever the observer cannot do.
    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, Self::Error>;

    /// Something happened.
    ///
    /// # Errors
    /// Whatever the observer cannot do.
    fn event(&mut self, event: &Event) -> Result<(), Self::Error>;
}

/// Looks at nothing: for who wants the state at the end.
impl Observer for () {
    type Error = Infallible;

    fn sample(&mut self, _: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

/// Something that happens at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Simulated time, s.
    pub time_s: f64,
    /// What.
    pub kind: EventKind,
}

/// What can happen. Balls are counted from 0.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EventKind {
    /// A ball has met its pocket.
    Impact {
        /// The ball.
        ball: usize,
        /// Its azimuth, degrees.
        azimuth_deg: f64,
        /// Closing speed, m/s.
        closing_speed_m_s: f64,
        /// Whether the ball pushes the cage ahead (otherwise the cage pushes the ball).
        ball_leads: bool,
    },
    /// A contact has lost its load.
    ContactLost {
        /// The ball.
        ball: usize,
        /// At the inner race, otherwise at the outer.
        inner: bool,
        /// Azimuth of the ball, degrees.
        azimuth_deg: f64,
    },
    /// A contact carries load again.
    ContactMade {
        /// The ball.
        ball: usize,
        /// At the inner race, otherwise at the outer.
        inner: bool,
        /// Azimuth of the ball, degrees.
        azimuth_deg: f64,
    },
    /// The coating has worn through somewhere for the first time.
    CoatingThrough {
        /// On the inner race, otherwise on the outer.
        inner: bool,
        /// Azimuth in the ring's frame, degrees.
        azimuth_deg: f64,
    },
    /// The solver must be doubted: a message for people.
    Warning {
        /// What and why.
        message: String,
    },
}
