//! Messages in the order of the file.

use super::path;
use super::sample::run_bytes;
use crate::{RecordError, read_messages};
use std::ops::ControlFlow;

/// Topic, log time, data.
type Whole = (String, u64, Vec<u8>);

/// The first messages of a file, so many at most.
fn read(name: &str, file: &[u8], most: usize) -> Result<Vec<Whole>, RecordError> {
    let (path, mut found) = (path(name), Vec::new());
    std::fs::write(&path, file).unwrap();
    let read = read_messages(&path, |topic, log_time, data| {
        if found.len() == most {
            return Ok(ControlFlow::Break(()));
        }
        found.push((topic.to_owned(), log_time, data.to_vec()));
        Ok::<_, RecordError>(ControlFlow::Continue(()))
    });
    std::fs::remove_file(&path).unwrap();
    read.map(|()| found)
}

#[test]
fn identity_messages_are_those_of_the_file_up_to_the_first_damage() {
    let mut file = run_bytes(160, 1_000.0, 2);
    let message = |m: mcap::Message| (m.channel.topic.clone(), m.log_time, m.data.to_vec());
    let all: Vec<Whole> = mcap::MessageStream::new(&file).unwrap().map(|m| message(m.unwrap())).collect();
    assert!(read("messages", &file, usize::MAX).unwrap() == all);
    assert!(read("some-messages", &file, 20).unwrap() == all[..20]);
    let summary = mcap::Summary::read(&file).unwrap().unwrap();
    let chunks = &summary.chunk_indexes;
    let safe = chunks[..2].iter().map(|chunk| summary.stream_chunk(&file, chunk).unwrap().count()).sum::<usize>();
    assert!(0 < safe && safe < all.len(), "{safe} of {}", all.len());
    // Of a chunk that is damaged, the third, and behind it nothing is handed out.
    let (start, length) = (chunks[2].chunk_start_offset, chunks[2].chunk_length);
    file[(start + length / 2) as usize] ^= 0x10;
    assert!(read("damaged-messages", &file, usize::MAX).unwrap() == all[..safe]);
    assert!(read("cut-messages", &file[..start as usize], usize::MAX).unwrap() == all[..safe]);
    assert!(matches!(read("no-messages", b"x", 1), Err(RecordError::NotMcap { .. })));
}
