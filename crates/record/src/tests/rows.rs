//! The numbers of a run without a recording are those that a recording has.

use super::sample::{feed, impact, recording, sample};
use super::{BALLS, case, path};
use crate::{RecordError, RunItem, RunReader, RunRecorder, RunRows};
use tribodyn_dynamics::{Event, EventKind, Observer};

/// Samples, impacts, and a warning before the last samples.
fn observed(observer: &mut impl Observer<Error = RecordError>) {
    feed(observer, 2100, 10_000.0, 7).unwrap();
    let kind = EventKind::Warning { message: "a step is too long".into() };
    observer.event(&Event { time_s: 0.210_05, kind }).unwrap();
    observer.event(&impact(0.210_06, 3, 0.5)).unwrap();
    assert!(observer.sample(&sample(0.2101), true).unwrap().is_continue());
}

#[test]
fn identity_rows_without_a_recording_are_those_of_one() {
    let (case, path) = (case::case(BALLS), path("rows"));
    let mut recorder = RunRecorder::create(&path, &recording(&case)).unwrap();
    observed(&mut recorder);
    recorder.finish().unwrap();
    let read: Vec<RunItem> = RunReader::open(&path).unwrap().map(|item| item.unwrap()).collect();
    std::fs::remove_file(&path).unwrap();
    let mut handed = Vec::new();
    let mut rows = RunRows::new(BALLS, |row| handed.push(row));
    observed(&mut rows);
    rows.finish();
    // Wear stands in a recording every 0.1 s; its last row is the one at the end.
    let wear = |items: &[RunItem]| items.iter().rfind(|item| matches!(item, RunItem::Wear(_))).cloned();
    assert!(wear(&handed).is_some() && wear(&handed) == wear(&read));
    let gathered = |item: &&RunItem| matches!(item, RunItem::State(_) | RunItem::Balls(..) | RunItem::Log(_));
    let of = |items: &[RunItem]| items.iter().filter(gathered).cloned().collect::<Vec<_>>();
    let (handed, read) = (of(&handed), of(&read));
    assert_eq!(handed.len(), read.len());
    for (a, b) in handed.iter().zip(&read) {
        assert_eq!(a, b);
    }
    let lines = handed.iter().filter(|item| matches!(item, RunItem::Log(_))).count();
    assert!(lines > 100, "{lines}");
}

#[test]
fn limit_a_sample_that_no_recording_takes_is_refused() {
    let mut rows = RunRows::new(BALLS, |_| {});
    assert!(rows.sample(&sample(1.0), false).unwrap().is_continue());
    assert!(matches!(rows.sample(&sample(0.5), false), Err(RecordError::TimeGoesBack { .. })));
    let mut other = RunRows::new(BALLS + 1, |_| {});
    assert!(matches!(other.sample(&sample(0.0), false), Err(RecordError::BallCount { .. })));
}
