//! The file as a file: counts, order, bytes, errors.

use super::{BALLS, Payload, bytes, case, decode, input, path, solution};
use crate::wire::FOXGLOVE_DESCRIPTORS;
use crate::write::Recording;
use crate::{CASE_ATTACHMENT, LAYOUT_ATTACHMENT, Layout, LayoutKind, RecordError, read_summary, write_solution};
use prost::Message;
use prost_types::field_descriptor_proto::{Label, Type};
use prost_types::{DescriptorProto, FileDescriptorSet};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Cursor, Seek, SeekFrom, Write};

#[test]
fn identity_summary_agrees_with_what_a_reader_finds() {
    let (case, solution, path) = (case::case(BALLS), solution(BALLS), path("summary"));
    let summary = write_solution(&path, &input(&case, &solution)).unwrap();
    assert_eq!(summary, read_summary(&path).unwrap());
    let file = std::fs::read(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(summary.file_bytes, file.len() as u64);
    assert!(file.len() < 1_000_000, "{} bytes", file.len());

    let messages = decode(&file);
    assert_eq!(summary.messages, messages.len() as u64);
    assert!(messages.windows(2).all(|pair| pair[0].0 <= pair[1].0), "log times go back");
    let mut counts = BTreeMap::new();
    for (_, topic, _) in &messages {
        *counts.entry(topic.as_str()).or_insert(0_u64) += 1;
    }
    for topic in &summary.topics {
        assert_eq!(counts.get(topic.topic.as_str()), Some(&topic.messages), "{}", topic.topic);
    }
    assert_eq!(counts["/bearing/geometry"], 1);
    assert_eq!(counts["/log"], 2);
    assert_eq!(counts["/bearing/state"], 28 * 13 + 1);
    assert_eq!(counts["/bearing/balls"], counts["/bearing/state"]);
    assert_eq!(counts["/tf"], counts["/bearing/contacts"]);
    assert_eq!(counts["/tf"], counts["/bearing/azimuth"]);
    let turns = 14_000.0 / 5802.0;
    assert!((counts["/tf"] as f64 / turns - 70.0).abs() < 15.0, "{} frames", counts["/tf"]);
    assert!((summary.duration_s() - 60.0 / 5802.0).abs() < 1e-6);

    let lines = messages.iter().filter_map(|(_, _, p)| if let Payload::Log(line) = p { Some(line) } else { None });
    assert!(lines.clone().all(|line| line.level() == crate::wire::foxglove::log::Level::Warning));
    assert!(lines.map(|line| &line.message).eq(&solution.warnings));
}

#[test]
fn identity_metadata_and_attachments_come_back() {
    let (mut case, solution, path) = (case::case(BALLS), solution(BALLS), path("attachments"));
    // A tenth of the bearing that the layout is made for.
    let geometry = &mut case.inputs.bearing.geometry;
    geometry.ball_diameter *= 0.1;
    geometry.pitch_diameter *= 0.1;
    let summary = write_solution(&path, &input(&case, &solution)).unwrap();
    let file = std::fs::read(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let simulation = &summary.metadata["simulation"];
    assert_eq!(simulation["interpolation"], "trigonometric");
    assert_eq!(simulation["bearing"], case.name);
    let texts: Vec<(String, Vec<u8>)> = mcap::Summary::read(&file)
        .unwrap()
        .unwrap()
        .attachment_indexes
        .iter()
        .map(|index| mcap::read::attachment(&file, index).unwrap())
        .map(|attachment| (attachment.name.clone(), attachment.data.into_owned()))
        .collect();
    assert_eq!(texts.len(), 2);
    assert_eq!(texts[0], (CASE_ATTACHMENT.to_owned(), case::TEXT.as_bytes().to_vec()));
    assert_eq!(texts[1].0, LAYOUT_ATTACHMENT);
    // The attached layout is that of the case, whose camera stands at the bearing's distance.
    let text = String::from_utf8(texts[1].1.clone()).unwrap();
    assert_eq!(
        text,
        Layout::new(LayoutKind::Solution, &case.name, &case.inputs.bearing.geometry, &case.inputs.speeds).json()
    );
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    let camera = json["configById"]["3D!bearing"]["cameraState"]["distance"].as_f64().unwrap();
    assert!((camera - 2.3 * 0.0215).abs() < 3e-4, "{camera} m");
}

#[test]
fn identity_no_number_in_the_file_is_infinite_or_not_a_number() {
    // Debug output names every field of every message.
    for count in [1, 2, 3, BALLS] {
        for (time, topic, payload) in decode(&bytes(&solution(count))) {
            let text = format!("{payload:?}");
            assert!(!text.contains("NaN") && !text.contains(": inf") && !text.contains("-inf"), "{topic} {time}");
        }
    }
}

#[test]
fn identity_same_input_gives_the_same_bytes() {
    assert_eq!(bytes(&solution(BALLS)), bytes(&solution(BALLS)));
    let mut other = solution(BALLS);
    other.balls[3].contacts.inner.load_n += 1.0;
    assert_ne!(bytes(&solution(BALLS)), bytes(&other));
}

#[test]
fn limit_a_path_that_cannot_be_written_is_an_error_and_leaves_nothing() {
    let (case, solution) = (case::case(BALLS), solution(BALLS));
    let missing = path("missing").join("run.mcap");
    let error = write_solution(&missing, &input(&case, &solution)).unwrap_err();
    assert!(matches!(error, RecordError::File { action: "create", .. }), "{error}");

    // A directory stands where the file should go: everything is written, the rename fails.
    let taken = path("directory");
    std::fs::create_dir_all(taken.join("something")).unwrap();
    let error = write_solution(&taken, &input(&case, &solution)).unwrap_err();
    assert!(matches!(error, RecordError::File { action: "write", .. }), "{error}");
    let part = taken.with_file_name(format!(".{}.part", taken.file_name().unwrap().display()));
    assert!(!part.exists());
    std::fs::remove_dir_all(&taken).unwrap();
}

/// A disk that takes so many bytes and no more.
struct FullDisk {
    disk: Cursor<Vec<u8>>,
    capacity: usize,
}

impl Write for FullDisk {
    fn write(&mut self, data: &[u8]) -> io::Result<usize> {
        if self.disk.position() as usize + data.len() > self.capacity {
            return Err(io::Error::from(io::ErrorKind::StorageFull));
        }
        self.disk.write(data)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for FullDisk {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        self.disk.seek(place)
    }
}

#[test]
fn limit_a_full_disk_is_an_error_wherever_it_fills_up() {
    let (case, solution) = (case::case(BALLS), solution(BALLS));
    let input = input(&case, &solution);
    let recording = Recording::new(&input).unwrap();
    let whole = bytes(&solution).len();
    let write = |capacity| recording.write(FullDisk { disk: Cursor::default(), capacity });
    for capacity in [0, 100, 5_000, whole / 2, whole - 3_000, whole - 1] {
        assert!(write(capacity).is_err(), "{capacity} of {whole} bytes");
    }
    assert_eq!(write(whole).unwrap().disk.into_inner().len(), whole);
}

#[test]
fn limit_a_torn_or_foreign_file_is_refused() {
    let (case, solution, path) = (case::case(BALLS), solution(BALLS), path("torn"));
    write_solution(&path, &input(&case, &solution)).unwrap();
    let whole = std::fs::read(&path).unwrap();
    for kept in [0, 8, 1_000, whole.len() / 2, whole.len() - 1] {
        std::fs::write(&path, &whole[..kept]).unwrap();
        assert!(read_summary(&path).is_err(), "{kept} of {} bytes", whole.len());
    }
    std::fs::write(&path, "not a recording").unwrap();
    assert!(read_summary(&path).is_err());
    std::fs::remove_file(&path).unwrap();
    assert!(matches!(read_summary(&path), Err(RecordError::File { .. })));
}

#[test]
fn limit_solutions_that_cannot_be_recorded_are_refused_by_name() {
    let case = case::case(BALLS);
    let refused = |change: fn(&mut tribodyn_quasistatic::Solution)| {
        let mut solution = solution(BALLS);
        change(&mut solution);
        let path = path("refused");
        let error = write_solution(&path, &input(&case, &solution)).unwrap_err();
        assert!(!path.exists());
        error.to_string()
    };
    let text = refused(|s| s.balls[4].fluid.as_mut().unwrap().drag_n = f64::NAN);
    assert!(text.contains("balls[4].drag_n"), "{text}");
    let text = refused(|s| s.ring_tilt_rad[1] = f64::INFINITY);
    assert!(text.contains("ring_tilt_y_rad"), "{text}");
    let text = refused(|s| s.balls[7].azimuth_rad += 0.5_f64.to_radians());
    assert!(text.contains("ball 7"), "{text}");
    let text = refused(|s| s.cage_speed_rpm = 0.0);
    assert!(text.contains("0 r/min"), "{text}");
    let text = refused(|s| s.balls.truncate(12));
    assert!(text.contains("12") && text.contains("13"), "{text}");
}

/// Rows (message, number, name, type, cardinality) of a message and what is nested in it.
fn rows(prefix: &str, message: &DescriptorProto, out: &mut BTreeSet<String>) {
    let name = format!("{prefix}.{}", message.name());
    for field in &message.field {
        let plain = Type::try_from(field.r#type.unwrap()).unwrap().as_str_name();
        let kind = match field.type_name() {
            "" => plain.trim_start_matches("TYPE_").to_lowercase(),
            reference => reference.trim_start_matches('.').to_owned(),
        };
        let cardinality = if field.label() == Label::Repeated { "repeated" } else { "single" };
        out.insert(format!("{name} {} {} {kind} {cardinality}", field.number(), field.name()));
    }
    for list in &message.enum_type {
        for value in &list.value {
            out.insert(format!("{name}.{} {} {} value single", list.name(), value.number(), value.name()));
        }
    }
}

#[test]
fn code_foxglove_sdk_has_the_same_messages_field_by_field() {
    let set = FileDescriptorSet::decode(FOXGLOVE_DESCRIPTORS).unwrap();
    let mut ours = BTreeSet::new();
    for file in set.file.iter().filter(|file| file.package() == "foxglove") {
        file.message_type.iter().for_each(|message| rows("foxglove", message, &mut ours));
    }
    let published = include_str!("../../proto/foxglove-0.30.3.txt");
    let theirs: BTreeSet<String> = published.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect();
    assert_eq!(ours, theirs);
}
