//! Observers of a run: the solver hands them samples and events, and they tell it to go on or to stop.

use crate::sample::Sample;
use serde::{Deserialize, Serialize};
use std::convert::Infallible;
use std::ops::ControlFlow;

/// Observer of a run. Its error ends the run.
pub trait Observer {
    /// Error of the observer, for instance a full disk.
    type Error;

    /// A sample. `with_balls` tells whether it is one of those at the ball rate; between them its balls have as much as
    /// [`Self::between`] asks for.
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

    /// How much the balls of samples between those at the ball rate have.
    fn between(&self) -> BallDetail {
        BallDetail::All
    }

    /// A step was made, to a time in s. Break ends the run there, without an error; taken up again it makes the
    /// samples of a run that went on.
    fn stepped(&mut self, time_s: f64) -> ControlFlow<()> {
        let _ = time_s;
        ControlFlow::Continue(())
    }
}

/// How much a sample has of its balls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BallDetail {
    /// Everything.
    All,
    /// At least where they are, how they turn, their loads, pressures and pocket forces. The fast scheme leaves out
    /// friction, fluid and accelerations then, and takes less time for a sample.
    Loads,
}

/// The observer that keeps nothing, for a run of which only the final state is wanted.
impl Observer for () {
    type Error = Infallible;

    fn between(&self) -> BallDetail {
        BallDetail::Loads
    }

    fn sample(&mut self, _: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, _: &Event) -> Result<(), Infallible> {
        Ok(())
    }
}

/// An event at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Simulated time, s.
    pub time_s: f64,
    /// Kind, with its data.
    pub kind: EventKind,
}

/// Kinds of events. Balls are counted from 0.
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
        /// True if the ball pushes the cage ahead (otherwise the cage pushes the ball).
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
    /// A ball has passed a spall of a race, or a race one of the ball.
    SpallPassed {
        /// The ball.
        ball: usize,
        /// On the inner race, otherwise on the outer.
        inner: bool,
        /// True for a spall of the ball.
        of_ball: bool,
        /// The spall, counted from 0 on each race, and in the list of those of balls.
        spall: usize,
        /// Time at which the contact's middle was over the first edge, s.
        entered_s: f64,
        /// Time at which it was over the middle and met the second edge, s.
        struck_s: f64,
        /// Time at which it was over the second edge, s.
        left_s: f64,
    },
    /// The solver must be doubted: a message for people.
    Warning {
        /// The warning and its reason.
        message: String,
    },
}
