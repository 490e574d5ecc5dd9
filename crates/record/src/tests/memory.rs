//! A memory that comes out of a checkpoint: topics by their place, and what a recorder knew.

use super::sample::{feed, recording};
use super::{BALLS, case};
use crate::{Preamble, RecordError, RunRecorder, Sink, StreamSink};
use std::cell::RefCell;
use std::io::Cursor;
use std::path::Path;
use std::rc::Rc;

/// A checkpoint names topics by their place.
#[test]
fn limit_a_message_for_no_topic_is_refused() {
    let case = case::case(BALLS);
    let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let shared = Shared(Rc::new(RefCell::new(sink)));
    assert!(matches!(shared.clone().message(0, 0, b""), Err(RecordError::NotBegun)));
    let _recorder = RunRecorder::new(shared.clone(), &recording(&case)).unwrap();
    let refused = shared.clone().message(usize::MAX, 0, b"");
    assert!(matches!(refused, Err(RecordError::NoTopic { channel: usize::MAX, topics: 13 })), "{refused:?}");
}

/// The memory of a recorder comes from a checkpoint: lists that do not fit and times that cannot be are refused.
#[test]
fn limit_an_impossible_memory_is_refused() {
    let case = case::case(BALLS);
    let new = || {
        let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
        RunRecorder::new(sink, &recording(&case)).unwrap()
    };
    let mut recorder = new();
    feed(&mut recorder, 300, 1_000.0, 4).unwrap();
    let sound = serde_json::to_value(recorder.memory()).unwrap();
    let edits = [
        ("/last_time_s", serde_json::json!(-1.0)),
        ("/next_slow_s", serde_json::json!(-1e300)),
        ("/next_flush_s", serde_json::json!(1e300)),
        ("/last_log_time", serde_json::json!(u64::MAX)),
        ("/found/inner", serde_json::json!([])),
        ("/recent/values/0", serde_json::json!([])),
        ("/motion/last/1", serde_json::json!([])),
        ("/pending/impacts", serde_json::json!(u64::MAX)),
    ];
    for (place, value) in edits {
        let mut edited = sound.clone();
        *edited.pointer_mut(place).unwrap_or_else(|| panic!("{place}")) = value.clone();
        let refused = new().remember(serde_json::from_value(edited).unwrap());
        assert!(matches!(refused, Err(RecordError::Memory { .. })), "{place} = {value}: {refused:?}");
    }
    new().remember(serde_json::from_value(sound).unwrap()).unwrap();
}

/// A sink that somebody else may write to, as a run's session does when it copies what was recorded before.
#[derive(Clone)]
struct Shared(Rc<RefCell<StreamSink<Cursor<Vec<u8>>>>>);

impl Sink for Shared {
    type Output = ();

    fn begin(&mut self, preamble: &Preamble) -> Result<(), RecordError> {
        self.0.borrow_mut().begin(preamble)
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.0.borrow_mut().message(channel, log_time, data)
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        self.0.borrow_mut().flush()
    }

    fn finish(self) -> Result<(), RecordError> {
        Ok(())
    }
}
