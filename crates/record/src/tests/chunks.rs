//! The span of a recording as viewers see it: from the chunk indexes, not from the statistics.

use super::sample::{feed, feed_from, recording, run_bytes};
use super::{BALLS, bytes, case, solution};
use crate::{RecorderMemory, RunRecorder, StreamSink, recover_stream};
use std::io::Cursor;
use std::path::Path;

/// A whole file none of whose chunks is without messages, and whose chunks span what its statistics say.
#[track_caller]
fn opens_at_its_start(kind: &str, file: &[u8]) {
    let summary = mcap::Summary::read(file).unwrap().unwrap();
    let (chunks, statistics) = (&summary.chunk_indexes, summary.stats.as_ref().unwrap());
    assert_eq!(chunks.len(), statistics.chunk_count as usize, "{kind}");
    for (place, chunk) in chunks.iter().enumerate() {
        assert!(!chunk.message_index_offsets.is_empty(), "{kind}: chunk {place} of {} has no message", chunks.len());
    }
    let start = chunks.iter().map(|chunk| chunk.message_start_time).min().unwrap_or(0);
    let end = chunks.iter().map(|chunk| chunk.message_end_time).max().unwrap_or(0);
    assert_eq!((start, end), (statistics.message_start_time, statistics.message_end_time), "{kind}");
}

fn memory() -> StreamSink<Cursor<Vec<u8>>> {
    StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"))
}

fn recovered(file: &[u8]) -> Vec<u8> {
    recover_stream(Cursor::new(file), Cursor::new(Vec::new())).unwrap().1.into_inner()
}

#[test]
fn identity_solutions_and_runs_open_at_their_first_message() {
    opens_at_its_start("solution", &bytes(&solution(BALLS)));
    for samples in [1, 40, 1600] {
        opens_at_its_start("run", &run_bytes(samples, 10_000.0, 5));
    }
}

/// A program that is stopped before the first sample has nothing to show: no chunk at all.
#[test]
fn limit_a_run_without_samples_has_no_chunk() {
    let case = case::case(BALLS);
    let file = RunRecorder::new(memory(), &recording(&case)).unwrap().finish().unwrap().into_inner();
    let summary = mcap::Summary::read(&file).unwrap().unwrap();
    assert!(summary.chunk_indexes.is_empty());
    assert_eq!((summary.attachment_indexes.len(), summary.metadata_indexes.len()), (2, 1));
}

#[test]
fn identity_a_run_that_was_taken_up_again_opens_at_its_first_message() {
    let case = case::case(BALLS);
    let mut first = RunRecorder::new(memory(), &recording(&case)).unwrap();
    feed(&mut first, 700, 10_000.0, 3).unwrap();
    let known: RecorderMemory = first.memory().clone();
    let mut second = RunRecorder::new(memory(), &recording(&case)).unwrap();
    second.remember(known).unwrap();
    feed_from(&mut second, 700..1500, 10_000.0, 3).unwrap();
    opens_at_its_start("second part", &second.finish().unwrap().into_inner());
}

#[test]
fn identity_recovered_files_open_at_their_first_message() {
    for (kind, file) in [("run", run_bytes(160, 1_000.0, 8)), ("solution", bytes(&solution(BALLS)))] {
        opens_at_its_start(kind, &recovered(&file));
        let mut torn = 0;
        for fifth in 1..5 {
            let part = &file[..file.len() / 5 * fifth];
            // Too short a part has no message.
            if let Ok((_, saved)) = recover_stream(Cursor::new(part), Cursor::new(Vec::new())) {
                opens_at_its_start(kind, &saved.into_inner());
                torn += 1;
            }
        }
        assert!(torn > 0, "nothing was saved of any part of a {kind}");
    }
}

/// A writer holds the index of all chunks until the end, so that their number bounds the memory of a long run: one each
/// 0.05 s and each MiB, with no more entries than topics.
#[test]
fn limit_the_index_of_a_recording_grows_with_time_and_bytes_alone() {
    let (seconds, rate) = (4, 500);
    let file = run_bytes(seconds * rate, rate as f64, 5);
    let summary = mcap::Summary::read(&file).unwrap().unwrap();
    let chunks = &summary.chunk_indexes;
    let mebibytes = chunks.iter().map(|chunk| chunk.uncompressed_size).sum::<u64>() >> 20;
    // Besides, one with the bodies and one that the end closes.
    let most = 2 + 20 * seconds + mebibytes as usize;
    assert!((20 * seconds..=most).contains(&chunks.len()), "{} chunks, {most} allowed", chunks.len());
    assert!(chunks.iter().all(|chunk| chunk.message_index_offsets.len() <= summary.channels.len()));
    assert_eq!(summary.channels.len(), 13);
}

/// Recordings of before have a chunk with nothing but schemas and channels; recovery mends them.
#[test]
fn identity_recovery_mends_a_file_that_begins_with_an_empty_chunk() {
    let mut writer = crate::output::writer(Cursor::new(Vec::new()), "test", crate::output::SMALL).unwrap();
    let schema = writer.add_schema("s", "protobuf", &[]).unwrap();
    let channel = writer.add_channel(schema, "/s", "protobuf", &std::collections::BTreeMap::new()).unwrap();
    writer.flush().unwrap();
    let header = mcap::records::MessageHeader { channel_id: channel, sequence: 0, log_time: 7, publish_time: 7 };
    writer.write_to_known_channel(&header, b"one").unwrap();
    writer.finish().unwrap();
    let file = writer.into_inner().into_inner();
    let before = mcap::Summary::read(&file).unwrap().unwrap().chunk_indexes;
    assert!(before.len() == 2 && before[0].message_index_offsets.is_empty() && before[0].message_start_time == 0);
    opens_at_its_start("mended", &recovered(&file));
}

#[cfg(feature = "live")]
#[test]
fn identity_a_run_with_viewers_opens_at_its_first_message() {
    let case = case::case(BALLS);
    let (server, _) = crate::LiveServer::start("127.0.0.1:0").unwrap();
    let mut recorder = RunRecorder::new((memory(), Some(server)), &recording(&case)).unwrap();
    feed(&mut recorder, 200, 10_000.0, 3).unwrap();
    opens_at_its_start("live", &recorder.finish().unwrap().0.into_inner());
}
