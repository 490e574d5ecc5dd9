//! Watches a run for its recorder, and remembers what the recorder needs to be taken up again.

use super::tape::SharedTape;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use tribodyn_dynamics::{Event, EventKind, Observer, Sample};
use tribodyn_record::{RecordError, RecordingSummary, RunRecorder};

/// Simulated time for which the recorder gathers events of a kind into one line of the log, s.
const LOG_WINDOW_S: f64 = 1e-3;

/// What of the past a recorder cannot find in the recording: a part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Past {
    /// Samples handed to the recorder.
    pub samples: u64,
    /// Impacts since the start.
    pub impacts: u64,
    /// Events whose lines of the log are not written yet: impacts, contacts lost, contacts made.
    pub unlogged: [Vec<Event>; 3],
}

impl Past {
    fn event(&mut self, event: &Event) {
        self.close_windows(event.time_s);
        let kind = match event.kind {
            EventKind::Impact { .. } => 0,
            EventKind::ContactLost { .. } => 1,
            EventKind::ContactMade { .. } => 2,
            EventKind::CoatingThrough { .. } | EventKind::Warning { .. } => return,
        };
        self.impacts += u64::from(kind == 0);
        self.unlogged[kind].push(event.clone());
    }

    fn close_windows(&mut self, time_s: f64) {
        for window in &mut self.unlogged {
            if window.first().is_some_and(|first| time_s >= first.time_s + LOG_WINDOW_S) {
                window.clear();
            }
        }
    }
}

/// The observer of a run.
pub struct Watcher {
    recorder: RunRecorder<SharedTape>,
    pub past: Past,
    pub warnings: Vec<String>,
}

impl Watcher {
    pub fn new(recorder: RunRecorder<SharedTape>) -> Self {
        Self { recorder, past: Past::default(), warnings: Vec::new() }
    }

    /// Shows the recorder an event that happened before the checkpoint, without counting it again.
    pub fn remind(&mut self, event: &Event) -> Result<(), RecordError> {
        self.recorder.event(event)
    }

    pub fn finish(self) -> Result<RecordingSummary, RecordError> {
        self.recorder.finish()
    }
}

impl Observer for Watcher {
    type Error = RecordError;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        self.past.close_windows(sample.time_s);
        self.past.samples += 1;
        self.recorder.sample(sample, with_balls)
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        self.past.event(event);
        if let EventKind::Warning { message } = &event.kind {
            self.warnings.push(message.clone());
        }
        self.recorder.event(event)
    }
}
