//! Files that were cut off or damaged.

use super::sample::run_bytes;
use crate::scan::{Record, Scanner};
use crate::{RECOVERY_METADATA, RecordError, Recovered, RunItem, RunReader, recover, recover_stream};
use std::io::Cursor;
use std::path::Path;

/// A message: channel, sequence, log time, data.
type Whole = (String, u32, u64, Vec<u8>);

fn messages(file: &[u8]) -> Vec<Whole> {
    let message = |m: mcap::Message| (m.channel.topic.clone(), m.sequence, m.log_time, m.data.to_vec());
    mcap::MessageStream::new(file).unwrap().map(|m| message(m.unwrap())).collect()
}

/// Ends of the chunks of a whole file and the messages up to there.
fn chunk_ends(file: &[u8]) -> Vec<(usize, usize)> {
    let summary = mcap::Summary::read(file).unwrap().unwrap();
    let mut count = 0;
    let end = |index: &mcap::records::ChunkIndex| {
        count += summary.stream_chunk(file, index).unwrap().count();
        ((index.chunk_start_offset + index.chunk_length) as usize, count)
    };
    summary.chunk_indexes.iter().map(end).collect()
}

fn recovered(bytes: &[u8]) -> Result<(Recovered, Vec<u8>), RecordError> {
    recover_stream(Cursor::new(bytes), Cursor::new(Vec::new())).map(|(done, out)| (done, out.into_inner()))
}

/// A generator of pseudo-random numbers (Lehmer, modulus 2³¹ − 1, factor 48271), the same in every run.
struct Lehmer(u64);

impl Lehmer {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0 * 48_271 % 0x7fff_ffff;
        self.0 as usize % bound
    }
}

/// A run of 0.16 s: a chunk with the bodies and four with samples.
fn small_run() -> Vec<u8> {
    run_bytes(160, 1_000.0, 2)
}

#[test]
fn limit_a_file_cut_anywhere_keeps_all_whole_chunks() {
    let file = small_run();
    assert!((50_000..1_000_000).contains(&file.len()), "{} bytes", file.len());
    let (all, ends) = (messages(&file), chunk_ends(&file));
    assert!(ends.len() >= 4 && ends.last().unwrap().1 == all.len());
    let mut random = Lehmer(1);
    let (mut refused, mut beyond) = (0, 0);
    for _ in 0..200 {
        let cut = random.below(file.len());
        let certain = ends.iter().rev().find(|(end, _)| *end <= cut).map_or(0, |(_, count)| *count);
        match recovered(&file[..cut]) {
            Ok((done, whole)) => {
                let saved = messages(&whole);
                assert!(saved.len() >= certain, "cut at {cut}: {} of {certain} certain messages", saved.len());
                assert_eq!(saved[..], all[..saved.len()], "cut at {cut}");
                assert_eq!(done.messages, saved.len() as u64);
                assert_eq!(
                    (done.damage.chunks_bad, done.messages_lost, done.damage.truncated),
                    (0, 0, true),
                    "cut at {cut}"
                );
                assert_eq!(done.last_time_ns, saved.last().unwrap().2);
                beyond += usize::from(saved.len() > certain);
            }
            Err(error) => {
                assert_eq!(certain, 0, "cut at {cut}: {error}");
                let clean = matches!(error, RecordError::NothingToRecover { .. } | RecordError::NotMcap { .. });
                assert!(clean, "cut at {cut}: {error}");
                refused += 1;
            }
        }
    }
    // Case, layout, descriptors and bodies come first and are half of so short a file.
    assert!(refused > 0 && refused < 140, "{refused} refused");
    assert!(beyond > 0, "no message of any chunk that was cut in two");
}

#[test]
fn limit_a_flipped_byte_costs_the_rest_of_its_own_chunk_at_most() {
    let file = small_run();
    let (all, ends) = (messages(&file), chunk_ends(&file));
    let counts: Vec<usize> = std::iter::once(0).chain(ends.iter().map(|(_, count)| *count)).collect();
    let mut random = Lehmer(2);
    let (mut bad, mut beginnings, mut odd) = (0, 0, 0);
    for _ in 0..200 {
        let place = 8 + random.below(file.len() - 8);
        let mut damaged = file.clone();
        damaged[place] ^= 1 + random.below(255) as u8;
        let (done, whole) = recovered(&damaged).unwrap_or_else(|error| panic!("{place}: {error}"));
        assert!(!done.damage.is_none(), "byte {place}: nothing is said");
        let saved = messages(&whole);
        bad += done.damage.chunks_bad;
        // Where the decoder went on behind the byte no message need be missing: those of its chunk are unchecked.
        if saved == all {
            continue;
        }
        assert_eq!(done.damage.chunks_bad, 1, "byte {place}: messages are missing or wrong");
        assert!(done.damage.bytes_lost > 0);
        // What is missing is the end of one chunk, in one piece.
        let missing = all.len() - saved.len();
        let fits = counts.windows(2).any(|pair| {
            pair[1].checked_sub(missing).is_some_and(|from| {
                // The decoder may go on for a little behind the byte: messages that it made of that are unchecked, too.
                let (checked, rest) = saved.split_at(pair[0]);
                let (unchecked, behind) = rest.split_at(from.saturating_sub(pair[0]));
                let right = unchecked.iter().zip(&all[pair[0]..]).take_while(|(one, two)| one == two).count();
                let fits = from >= pair[0]
                    && done.damage.messages_unchecked as usize == from - pair[0]
                    && checked == &all[..pair[0]]
                    && behind == &all[pair[1]..];
                odd += if fits { unchecked.len() - right } else { 0 };
                fits
            })
        });
        assert!(fits, "byte {place}: {} saved", saved.len());
        beginnings += u64::from(done.damage.messages_unchecked > 0);
    }
    assert!(bad > 100 && beginnings > 2, "{bad} damaged chunks, of {beginnings} the beginning was saved");
    assert!(odd < 10, "{odd} unchecked messages are not those of the run");
}

/// Names of topics, schemas, metadata and attachments with what belongs to them.
fn content(file: &[u8]) -> Vec<String> {
    let mut all: Vec<String> = messages(file).iter().map(|message| format!("{message:?}")).collect();
    let mut scanner = Scanner::new(Cursor::new(file.to_vec())).unwrap().unwrap();
    while let Some(piece) = scanner.next_piece().unwrap() {
        let described = piece.records().filter(|record| {
            !matches!(record, Record::Message { .. } | Record::Metadata { name: RECOVERY_METADATA, .. })
        });
        all.extend(described.map(|record| format!("{record:?}")));
    }
    all
}

/// The summary repeats the names of all topics behind the data: one flipped letter of them renames nothing and is told.
#[test]
fn limit_a_flipped_byte_of_the_summary_renames_nothing() {
    let file = small_run();
    let (sound, all) = (content(&recovered(&file).unwrap().1), messages(&file));
    let summary = mcap::Summary::read(&file).unwrap().unwrap();
    let data_end = summary.chunk_indexes.iter().map(|c| c.chunk_start_offset + c.chunk_length).max().unwrap() as usize;
    let names = file[data_end..].windows(14).position(|w| w == b"/bearing/balls").unwrap() + data_end;
    let last = file.len() - 8;
    // The letters of a name, then the whole of the index at the end, the place of the summary and its checksum
    // included.
    for place in
        (names..names + 14).step_by(3).chain((data_end..last).step_by(4999)).chain((last - 29..last).step_by(4))
    {
        let mut damaged = file.clone();
        damaged[place] ^= 0x0a;
        let (done, whole) = recovered(&damaged).unwrap();
        assert!(!done.damage.is_none(), "byte {place}: nothing is said");
        assert_eq!(content(&whole), sound, "byte {place}");
        let mut reader = RunReader::new(Cursor::new(&damaged), Path::new("damaged")).unwrap();
        let balls = (&mut reader).filter(|item| matches!(item, Ok(RunItem::Balls(..)))).count();
        assert_eq!(balls, all.iter().filter(|m| m.0 == "/bearing/balls").count(), "byte {place}");
        assert!(!reader.damage().is_none(), "byte {place}: the reader says nothing");
    }
}

/// Metadata have no checksum of their own; the one over all data shows that a number in them was changed.
#[test]
fn limit_altered_metadata_is_told() {
    let file = small_run();
    let place = file.windows(10).position(|w| w == b"ball_count").unwrap() + 14;
    let mut damaged = file.clone();
    damaged[place] ^= 1;
    let done = recovered(&damaged).unwrap().0;
    assert!(done.damage.checksum_bad && done.damage.chunks_bad == 0 && done.damage.bytes_lost == 0);
}

#[test]
fn limit_wrong_lengths_ask_for_no_memory() {
    let file = small_run();
    let (all, chunks) = (messages(&file), mcap::Summary::read(&file).unwrap().unwrap().chunk_indexes);
    let second = chunks[2].chunk_start_offset as usize;
    // Length of the record, uncompressed size, compressed size; head: opcode, length, times, size, checksum, "zstd".
    for place in [1, 1 + 8 + 16, 1 + 8 + 16 + 8 + 4 + 8] {
        for wrong in [u64::MAX, u64::MAX - 7, 1 << 40, 1 << 33, 0] {
            let mut damaged = file.clone();
            damaged[second + place..second + place + 8].copy_from_slice(&wrong.to_le_bytes());
            let (done, whole) = recovered(&damaged).unwrap();
            assert_eq!(done.damage.chunks_bad, 1, "{wrong} at {place}");
            assert!(!done.damage.truncated);
            let saved = messages(&whole).len();
            assert!(saved < all.len() && saved > all.len() / 2, "{wrong} at {place}: {saved} of {}", all.len());
        }
    }
    // A chunk that says it is four times as long as the file lets it be.
    let mut cut = file[..chunks[3].chunk_start_offset as usize + 300].to_vec();
    let place = chunks[3].chunk_start_offset as usize + 1;
    cut[place..place + 8].copy_from_slice(&(1_u64 << 45).to_le_bytes());
    let before = chunk_ends(&file)[2].1;
    assert_eq!(recovered(&cut).unwrap().0.messages, before as u64);
}

#[test]
fn limit_a_lost_table_of_channels_is_found_in_the_summary() {
    let file = small_run();
    let all = messages(&file);
    let first = mcap::Summary::read(&file).unwrap().unwrap().chunk_indexes[0].chunk_start_offset as usize;
    let mut damaged = file.clone();
    damaged[first + 200] ^= 0x55;
    let (done, whole) = recovered(&damaged).unwrap();
    assert_eq!((done.damage.chunks_bad, done.messages_lost), (1, 0));
    // The bodies are in the chunk that declares the channels, and nothing else is.
    assert_eq!(all[0].0, "/bearing/geometry");
    assert!(messages(&whole) == all[1..], "other messages are missing");
    // Without the summary nobody can say what the messages are.
    let error = recovered(&damaged[..file.len() - 20_000]).unwrap_err();
    assert!(matches!(error, RecordError::NothingToRecover { .. }), "{error}");
}

#[test]
fn limit_what_is_no_recording_is_refused() {
    for bytes in [&b""[..], b"\x89MCAP0\r", b"not a recording at all, by any means", &[0; 4096]] {
        assert!(matches!(recovered(bytes), Err(RecordError::NotMcap { .. })));
    }
    assert!(matches!(recovered(b"\x89MCAP0\r\n"), Err(RecordError::NothingToRecover { .. })));
    assert!(matches!(RunReader::new(Cursor::new(b"no"), Path::new("no")), Err(RecordError::NotMcap { .. })));
    let missing = super::path("recover-missing");
    assert!(matches!(recover(&missing, &missing), Err(RecordError::File { action: "open", .. })));
    assert!(!missing.with_file_name(format!(".{}.part", missing.file_name().unwrap().display())).exists());
}

#[test]
fn identity_a_sound_file_is_copied_and_says_so() {
    let file = small_run();
    let (done, whole) = recovered(&file).unwrap();
    assert_eq!(messages(&whole), messages(&file));
    assert!(done.damage.is_none() && done.messages_lost == 0);
    assert!((done.last_time_s() - 0.159).abs() < 1e-9);
    let records = |bytes: &[u8]| {
        let mut scanner = Scanner::new(Cursor::new(bytes.to_vec())).unwrap().unwrap();
        let (mut attachments, mut metadata) = (Vec::new(), Vec::new());
        while let Some(piece) = scanner.next_piece().unwrap() {
            for record in piece.records() {
                match record {
                    Record::Attachment { name, data, .. } => attachments.push((name.to_owned(), data.to_vec())),
                    Record::Metadata { name, entries } => metadata.push((name.to_owned(), entries)),
                    _ => {}
                }
            }
        }
        (attachments, metadata)
    };
    let ((attached, described), (again, mut says)) = (records(&file), records(&whole));
    assert_eq!(attached.len(), 2);
    assert_eq!(attached, again);
    let (name, report) = says.pop().unwrap();
    assert_eq!(says, described);
    assert_eq!((name.as_str(), report["chunks_bad"].as_str()), (RECOVERY_METADATA, "0"));
}

#[test]
fn limit_a_run_still_going_on_can_be_read() {
    let file = small_run();
    let cut = chunk_ends(&file)[2].0 + 2_000;
    let mut reader = RunReader::new(Cursor::new(&file[..cut]), Path::new("run.mcap.active")).unwrap();
    let items: Vec<RunItem> = (&mut reader).map(Result::unwrap).collect();
    assert!(reader.damage().truncated && reader.damage().chunks_bad == 0);
    let states = items.iter().filter(|item| matches!(item, RunItem::State(_))).count();
    assert!((100..160).contains(&states), "{states}");
    assert!(items.iter().any(|item| matches!(item, RunItem::Case(text) if text == super::case::TEXT)));
}

/// A recording of states at these times, with a cage speed, r/min.
fn states(name: &str, rows: &[(f64, f64)]) -> std::path::PathBuf {
    let mut writer = crate::output::writer(Cursor::new(Vec::new()), "tribodyn test", crate::output::SMALL).unwrap();
    let schema = writer.add_schema("tribodyn.v1.TransientState", "protobuf", &[]).unwrap();
    let channel = writer.add_channel(schema, "/bearing/state", "protobuf", &std::collections::BTreeMap::new()).unwrap();
    for &(time_s, cage_speed_rpm) in rows {
        let row = crate::StateRow { time_s, cage_speed_rpm, ..Default::default() };
        let header = mcap::records::MessageHeader { channel_id: channel, sequence: 0, log_time: 7, publish_time: 7 };
        writer.write_to_known_channel(&header, &prost::Message::encode_to_vec(&row)).unwrap();
    }
    writer.finish().unwrap();
    let path = super::path(name);
    std::fs::write(&path, writer.into_inner().into_inner()).unwrap();
    path
}

#[test]
fn limit_numbers_that_are_none_and_times_that_go_back_are_refused() {
    let read = |name, rows: &[(f64, f64)]| {
        let path = states(name, rows);
        let read = crate::read_recording(&path);
        std::fs::remove_file(path).unwrap();
        read
    };
    assert_eq!(read("ordered", &[(0.0, 1.0), (0.1, 2.0), (0.1, 3.0)]).unwrap().states.len(), 3);
    let error = read("back", &[(0.0, 1.0), (0.2, 2.0), (0.1, 3.0)]).unwrap_err();
    assert!(error.to_string().ends_with("go back: 0.1 s follows 0.2 s"), "{error}");
    let error = read("none", &[(0.0, 1.0), (0.1, f64::NAN)]).unwrap_err();
    assert!(error.to_string().starts_with("cage_speed_rpm of a message on /bearing/state is NaN"), "{error}");
}

#[test]
fn limit_a_recording_does_not_fill_the_memory() {
    let path = states("long", &[(0.0, 1.0); 4000]);
    let within = |most| crate::read_recording_within(&path, most).map(|run| run.states.len());
    assert_eq!(within(1 << 24).unwrap(), 4000);
    assert!(matches!(within(1 << 16), Err(RecordError::TooLong { most: 65_536, .. })));
    std::fs::remove_file(path).unwrap();
}
