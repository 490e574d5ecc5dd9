//! The numbers of a run without a recording.

use super::check;
use super::events::Pending;
use super::overview::Overview;
use super::{log_time, messages};
use crate::RecordError;
use crate::file::replay::{RunItem, log_row};
use std::ops::ControlFlow;
use tribodyn_dynamics::{BallDetail, Event, Observer, Sample, WearSample};

/// Hands out the rows that a reader of the recording would find, from samples and events: states, balls, the log, and
/// at the end what has worn off. Nothing is encoded, and what is for the eye only is not made. Films of the contacts
/// are left out: balls have them as in a dry bearing.
#[derive(Debug)]
pub struct RunRows<T> {
    balls: usize,
    /// Time of the last sample, s, and what had worn off by then.
    last: (f64, WearSample),
    pending: Pending,
    take: T,
}

impl<T: FnMut(RunItem)> RunRows<T> {
    /// For a bearing with so many balls; `take` gets the rows in the order of a recording.
    pub fn new(balls: usize, take: T) -> Self {
        Self { balls, last: (0.0, WearSample::default()), pending: Pending::default(), take }
    }

    /// Hands out the lines of the log that wait, and what has worn off.
    pub fn finish(mut self) {
        self.log_due(f64::INFINITY);
        let (time_s, wear) = self.last;
        (self.take)(RunItem::Wear(messages::wear(&wear, time_s, log_time(time_s))));
    }

    fn log_due(&mut self, time_s: f64) {
        let Self { pending, take, .. } = self;
        pending.due(time_s).for_each(|line| take(RunItem::Log(log_row(line))));
    }
}

impl<T: FnMut(RunItem)> Observer for RunRows<T> {
    type Error = RecordError;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        let overview = Overview::of(sample);
        let time = log_time(sample.time_s);
        let balls = with_balls.then(|| messages::balls(&sample.balls, sample.time_s, time).balls);
        if let Some(messages) = &balls {
            check::check_balls(messages, &sample.balls, self.balls)?;
        }
        let state = messages::state(&overview, time, self.pending.impacts());
        check::check(&overview, &state, self.balls, self.last.0)?;
        self.last = (sample.time_s, sample.wear);
        self.log_due(sample.time_s);
        (self.take)(RunItem::State(state));
        if let Some(balls) = balls {
            (self.take)(RunItem::Balls(sample.time_s, balls));
        }
        Ok(ControlFlow::Continue(()))
    }

    fn between(&self) -> BallDetail {
        Overview::DETAIL
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        if !event.time_s.is_finite() {
            return Err(RecordError::NotFinite { field: "time_s of an event".to_owned(), value: event.time_s });
        }
        self.log_due(event.time_s);
        if let Some(line) = self.pending.add(event) {
            (self.take)(RunItem::Log(log_row(line)));
        }
        Ok(())
    }
}
