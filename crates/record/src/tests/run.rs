//! Recorded runs: what the messages say, when they come, what is refused.

use super::sample::{CAGE, SHAFT, TONE_HZ, TONE_M_S2, feed, feed_from, impact, recording, run_bytes, sample};
use super::{BALLS, case, path};
use crate::wire::{foxglove, tribodyn};
use crate::{FileSink, Preamble, RecordError, Run, RunRecorder, Sink, StreamSink, read_run, read_summary, recover};
use prost::Message;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::io::{self, Cursor, Seek, SeekFrom, Write};
use std::path::Path;
use tribodyn_case::Case;
use tribodyn_dynamics::{Event, EventKind, Observer};

/// Log time, topic and data of all messages.
pub(super) fn messages(file: &[u8]) -> Vec<(u64, String, Vec<u8>)> {
    let message = |m: mcap::Message| (m.log_time, m.channel.topic.clone(), m.data.to_vec());
    mcap::MessageStream::new(file).unwrap().map(|m| message(m.unwrap())).collect()
}

fn of_topic<M: Message + Default>(file: &[u8], topic: &str) -> Vec<M> {
    messages(file).iter().filter(|m| m.1 == topic).map(|m| M::decode(m.2.as_slice()).unwrap()).collect()
}

/// Records to a file and reads it back.
fn recorded(test: &str, samples: usize, rate: f64, stride: usize) -> Run {
    let (case, path) = (case::case(BALLS), path(test));
    let mut recorder = RunRecorder::create(&path, &recording(&case)).unwrap();
    feed(&mut recorder, samples, rate, stride).unwrap();
    let summary = recorder.finish().unwrap();
    assert_eq!(summary, read_summary(&path).unwrap());
    let run = read_run(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    run
}

/// A case with the sections of a run says how its samples were filtered.
#[test]
fn identity_the_filter_of_a_run_stands_in_its_metadata() {
    let case = case::Made::of(&Case::from_ron(include_str!("../../../../fixtures/cases/paper-ag.ron")).unwrap());
    let path = path("run-filter");
    let mut recorder = RunRecorder::create(&path, &recording(&case)).unwrap();
    feed(&mut recorder, 10, 25_600.0, 5).unwrap();
    recorder.finish().unwrap();
    let run = read_run(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let simulation = &run.metadata["simulation"];
    let [rate, end, stop, delay, inside] =
        ["state_rate_hz", "filter_pass_band_hz", "filter_stop_band_hz", "filter_delay_s", "filter_internal_rate_hz"]
            .map(|key| simulation[key].parse::<f64>().unwrap());
    assert_eq!([end, stop, delay * rate], [0.39 * rate, 0.5 * rate, 26.0]);
    assert!(inside >= 2.0 * rate, "{inside}");
}

#[test]
fn identity_a_run_comes_back_as_it_was_recorded() {
    let run = recorded("run-back", 300, 10_000.0, 5);
    assert_eq!((run.states.len(), run.balls.len()), (300, 60));
    assert!(run.damage.is_none());
    assert_eq!(run.case_text.as_deref(), Some(case::TEXT));
    let simulation = &run.metadata["simulation"];
    assert_eq!((simulation["kind"].as_str(), simulation["seed"].as_str()), ("transient run", "none"));
    for (index, row) in run.states.iter().enumerate() {
        let exact = sample(index as f64 / 10_000.0);
        assert_eq!(row.time_s, exact.time_s);
        assert_eq!(row.inner_displacement_x_um, exact.inner.displacement_m[0] * 1e6);
        assert_eq!(row.outer_acceleration_x_m_s2, exact.outer.acceleration_m_s2[0]);
        assert!((row.cage_speed_rpm - exact.cage.speed_rad_s * 60.0 / TAU).abs() < 1e-9);
        assert!((row.imbalance_ppb - 2.0).abs() < 1e-12, "2e-6 J of 1000 J");
        let largest = exact.balls.iter().map(|b| b.contacts.inner.load_n).fold(0.0, f64::max);
        assert_eq!(row.load_inner_max_n, largest);
        assert_eq!(row.balls_in_contact as usize, BALLS);
    }
    assert_eq!(run.states.last().map(|row| row.impacts), Some(29));
    for (time, balls) in &run.balls {
        let exact = sample(*time);
        for (row, ball) in balls.iter().zip(&exact.balls) {
            assert_eq!(row.load_outer_n, ball.contacts.outer.load_n as f32);
            assert_eq!(row.pocket_force_n, ball.pocket.unwrap_or_default().force_n as f32);
            assert_eq!((row.damping_inner_n, row.bare_outer_percent), (12.5, 25.0));
            assert!((row.depth_inner_um - 1.5).abs() < 1e-6);
            let turn = (f64::from(row.azimuth_deg) - ball.azimuth_rad.to_degrees() + 180.0).rem_euclid(360.0) - 180.0;
            assert!(turn.abs() < 1e-4);
        }
    }
}

#[test]
fn identity_log_times_are_the_samples_and_never_fall() {
    let file = run_bytes(400, 25_600.0, 5);
    let messages = messages(&file);
    assert!(messages.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    let states = messages.iter().filter(|m| m.1 == "/bearing/state");
    for (index, (time, _, data)) in states.enumerate() {
        let state = tribodyn::TransientState::decode(data.as_slice()).unwrap();
        let stamp = state.timestamp.unwrap();
        assert_eq!(stamp.seconds as u64 * 1_000_000_000 + stamp.nanos as u64, *time);
        // Every other step ends on half a nanosecond, which rounding may put on either side.
        assert!(((time - crate::timeline::EPOCH_NS) as f64 - index as f64 * 39_062.5).abs() <= 0.5);
    }
    let mut counts = BTreeMap::new();
    messages.iter().for_each(|m| *counts.entry(m.1.as_str()).or_insert(0) += 1);
    assert_eq!((counts["/bearing/state"], counts["/bearing/balls"]), (400, 80));
    assert_eq!(counts["/bearing/geometry"], 1);
    // 3.6 turns of the shaft, balls at 22 times a turn: all of them for the frames, at most 20 a turn for the arrows.
    assert_eq!(counts["/tf"], 80);
    assert!((40..=73).contains(&counts["/bearing/contacts"]), "{}", counts["/bearing/contacts"]);
    assert_eq!(run_bytes(400, 25_600.0, 5), file, "same input, other bytes");
}

#[test]
fn limit_a_tone_stands_in_the_spectrum_with_its_frequency_and_amplitude() {
    let file = run_bytes(2300, 10_000.0, 50);
    let spectra: Vec<tribodyn::Spectrum> = of_topic(&file, "/bearing/spectrum");
    let times: Vec<f64> = spectra.iter().map(|s| s.time_s).collect();
    // With 256 samples, whenever they have doubled, and 0.1 s after the last time.
    assert_eq!(times, [0.03, 0.06, 0.11, 0.21, 0.2299]);
    let last = spectra.last().unwrap();
    assert_eq!(last.unit, "m/s²");
    let peak = last.amplitude.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
    assert!((f64::from(last.frequency_hz[peak.0]) - TONE_HZ).abs() < 1e-3);
    assert!((f64::from(*peak.1) - TONE_M_S2).abs() < 1e-3, "{}", peak.1);
    assert_eq!(of_topic::<tribodyn::Spectrum>(&file, "/bearing/spectrum/cage").len(), 5);
    // 5802 r/min of the cage and 14 000 of the shaft; the balls swing about the former.
    let [cage, balls] = [5802.0 / 60.0, BALLS as f64];
    assert!((last.ftf_hz / cage - 1.0).abs() < 1e-4 && (last.bpfo_hz / (balls * cage) - 1.0).abs() < 1e-4);
    assert!((last.bpfi_hz / (balls * (14_000.0 / 60.0 - cage)) - 1.0).abs() < 1e-4);
    let turning = (3900.0_f64.powi(2) + 900.0_f64.powi(2) + 15.0_f64.powi(2)).sqrt() / TAU;
    assert!((last.bsf_hz / turning - 1.0).abs() < 1e-9);
    for (marks, frequency) in [(&last.mark_bpfo, last.bpfo_hz), (&last.mark_ftf, last.ftf_hz)] {
        assert_eq!(marks.len(), last.amplitude.len());
        let at: Vec<usize> = (0..marks.len()).filter(|&line| marks[line] < 0.0).collect();
        assert_eq!(at.len(), 3, "a frequency and two multiples");
        for (line, multiple) in at.into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((f64::from(last.frequency_hz[line]) - multiple * frequency).abs() < 2.5, "half a line of 4.9 Hz");
            assert!((f64::from(marks[line]) + 0.12 * f64::from(*peak.1) / multiple).abs() < 1e-6);
        }
    }

    let orbits: Vec<tribodyn::Orbit> = of_topic(&file, "/bearing/orbit");
    let orbit = &orbits[10];
    // One turn of the shaft at 10 kHz, closed by the sample that ends it.
    let turn = 10_000.0 * TAU / SHAFT;
    assert!((orbit.x_um.len() as f64 - turn).abs() <= 2.0, "{} points", orbit.x_um.len());
    assert!(orbit.x_um.iter().zip(&orbit.y_um).all(|(x, y)| (x.hypot(*y) - 11.0).abs() < 1e-4));
    let wear: Vec<tribodyn::Wear> = of_topic(&file, "/bearing/wear");
    // At the start, each 0.01 s, and at the end.
    assert_eq!((wear.len(), wear[0].time_s, wear[23].time_s), (24, 0.0, 0.2299));
    assert!((wear[23].volume_inner_um3 - 6897.0).abs() < 1e-6);
    assert!((wear[20].volume_inner_um3 - 6000.0).abs() < 1e-6 && (wear[20].coating_outer_min_um - 9.0).abs() < 1e-9);
}

#[test]
fn identity_balls_in_the_picture_stand_where_the_numbers_say() {
    let file = run_bytes(60, 10_000.0, 2);
    let frames: Vec<foxglove::FrameTransforms> = of_topic(&file, "/tf");
    let contacts: Vec<foxglove::SceneUpdate> = of_topic(&file, "/bearing/contacts");
    assert!(contacts.iter().all(|c| c.entities.len() == BALLS + 2 && c.entities[0].arrows.len() == 2));
    let frame = &frames[frames.len() - 1];
    let time = frame.transforms[0].timestamp.unwrap().nanos as f64 * 1e-9;
    let exact = sample(time);
    let find = |name: &str| frame.transforms.iter().find(|f| f.child_frame_id == name).unwrap();
    let ball = find("orbit_03").translation.unwrap();
    let azimuth = exact.balls[3].azimuth_rad;
    assert!((ball.x - 0.083_79 * azimuth.cos()).abs() < 1e-7 && (ball.y - 0.083_79 * azimuth.sin()).abs() < 1e-7);
    let cage = find("cage").rotation.unwrap();
    let turned = 2.0 * cage.z.atan2(cage.w) - CAGE * time;
    assert!((turned - TAU * (turned / TAU).round()).abs() < 1e-6);
    // The angular velocity is constant: the ball has turned by |ω| t about it.
    let omega = exact.balls[3].angular_velocity_rad_s;
    let angle = omega.iter().map(|w| w * w).sum::<f64>().sqrt() * time;
    let turned = find("ball_03").rotation.unwrap();
    assert!((turned.w.abs() - (0.5 * angle).cos().abs()).abs() < 1e-6);
}

#[test]
fn limit_impacts_are_thinned_out_and_counted() {
    let case = case::case(BALLS);
    let sink = StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let mut recorder = RunRecorder::new(sink, &recording(&case)).unwrap();
    assert!(recorder.sample(&sample(0.0), true).unwrap().is_continue());
    for (time, speed) in [(0.0001, 0.02), (0.0004, 0.07), (0.0009, 0.05), (0.0021, 0.01)] {
        recorder.event(&impact(time, 6, speed)).unwrap();
    }
    let warn = |message: &str| EventKind::Warning { message: message.to_owned() };
    recorder.event(&Event { time_s: 0.0022, kind: warn("pressure below the tests") }).unwrap();
    assert!(recorder.sample(&sample(0.0025), true).unwrap().is_continue());
    let lost = EventKind::ContactLost { ball: 2, inner: true, azimuth_deg: 181.0 };
    recorder.event(&Event { time_s: 0.0026, kind: lost }).unwrap();
    let file = recorder.finish().unwrap().into_inner();
    let lines: Vec<foxglove::Log> = of_topic(&file, "/log");
    let texts: Vec<&str> = lines.iter().map(|line| line.message.as_str()).collect();
    assert_eq!(
        texts,
        [
            "t = 0.000400 s: ball 6 meets its pocket at 12.2°, 0.070 m/s, ball pushes cage (and 2 weaker within 1 ms)",
            "t = 0.002200 s: pressure below the tests",
            "t = 0.002100 s: ball 6 meets its pocket at 12.2°, 0.010 m/s, ball pushes cage",
            "t = 0.002600 s: ball 2 leaves the inner race at 181.0°",
        ]
    );
    let states: Vec<tribodyn::TransientState> = of_topic(&file, "/bearing/state");
    assert_eq!(states[1].impacts, 4);
}

#[test]
fn limit_what_cannot_be_recorded_is_refused_by_name() {
    let case = case::case(BALLS);
    let sink = || StreamSink::new(Cursor::new(Vec::new()), Path::new("memory"));
    let refused_where = |with_balls: bool, change: fn(&mut tribodyn_dynamics::Sample)| {
        let mut recorder = RunRecorder::new(sink(), &recording(&case)).unwrap();
        assert!(recorder.sample(&sample(0.001), true).unwrap().is_continue());
        let mut wrong = sample(0.002);
        change(&mut wrong);
        recorder.sample(&wrong, with_balls).unwrap_err().to_string()
    };
    let refused = |change: fn(&mut tribodyn_dynamics::Sample)| refused_where(true, change);
    let text = refused(|s| s.balls[4].angular_velocity_rad_s[1] = f64::NAN);
    assert!(text.contains("balls[4].angular_velocity_radial_rad_s") && text.contains("NaN"), "{text}");
    let text = refused(|s| s.power.drag_w = f64::INFINITY);
    assert!(text.starts_with("drag_w") && text.contains("inf"), "{text}");
    let text = refused(|s| s.wear.volume_cage_m3 = f64::NAN);
    assert!(text.starts_with("volume_cage_m3"), "{text}");
    let text = refused_where(false, |s| s.balls[2].orbital_speed_rad_s = f64::NAN);
    assert!(text.starts_with("orbital_speed_mean_rpm"), "{text}");
    let text = refused_where(false, |s| s.balls[2].angular_velocity_rad_s[0] = f64::INFINITY);
    assert!(text.starts_with("angular_velocity_rad_s of a ball"), "{text}");
    let text = refused(|s| s.time_s = 0.0005);
    assert!(text.contains("0.0005") && text.contains("0.001"), "{text}");
    let text = refused(|s| s.balls.truncate(12));
    assert!(text.contains("12") && text.contains("13"), "{text}");
    assert!(matches!(sink().flush(), Err(RecordError::NotBegun)));
}

#[test]
fn limit_a_run_that_ends_early_leaves_a_file_that_can_be_read() {
    let (case, path) = (case::case(BALLS), path("dropped"));
    let mut recorder = RunRecorder::create(&path, &recording(&case)).unwrap();
    feed(&mut recorder, 40, 10_000.0, 5).unwrap();
    let active = crate::output::active_path(&path);
    drop(recorder);
    assert!(!path.exists());
    assert_eq!(read_run(&active).unwrap().states.len(), 40);
    // Into the name that the run would have had.
    assert_eq!(recover(&active, &path).unwrap().damage.chunks_bad, 0);
    assert_eq!(read_run(&path).unwrap().states.len(), 40);
    std::fs::remove_file(&path).unwrap();
    std::fs::remove_file(&active).unwrap();
}

/// A run far shorter than the time between two messages of wear says what has worn off all the same.
#[test]
fn limit_a_short_run_ends_with_its_wear() {
    let wear: Vec<tribodyn::Wear> = of_topic(&run_bytes(41, 10_000.0, 5), "/bearing/wear");
    assert_eq!(wear.iter().map(|w| w.time_s).collect::<Vec<_>>(), [0.0, 0.004]);
    assert!((wear[1].volume_inner_um3 - 120.0).abs() < 1e-9, "{}", wear[1].volume_inner_um3);
    // The first sample is the last one: once is enough.
    assert_eq!(of_topic::<tribodyn::Wear>(&run_bytes(1, 10_000.0, 5), "/bearing/wear").len(), 1);
}

/// Topic, log time and bytes of messages.
type Messages = Vec<(usize, u64, Vec<u8>)>;

/// Keeps messages in memory.
#[derive(Default)]
struct Collected(Messages);

impl Sink for Collected {
    type Output = Messages;

    fn begin(&mut self, _: &Preamble) -> Result<(), RecordError> {
        Ok(())
    }

    fn message(&mut self, channel: usize, log_time: u64, data: &[u8]) -> Result<(), RecordError> {
        self.0.push((channel, log_time, data.to_vec()));
        Ok(())
    }

    fn flush(&mut self) -> Result<(), RecordError> {
        Ok(())
    }

    fn finish(self) -> Result<Messages, RecordError> {
        Ok(self.0)
    }
}

/// Orientations, spectra, paths, waiting lines of the log and the count of impacts go on in all their digits.
#[test]
fn identity_a_recorder_with_the_memory_of_another_sends_the_same_bytes() {
    let case = case::case(BALLS);
    let new = || RunRecorder::new(Collected::default(), &recording(&case)).unwrap();
    let mut whole = new();
    feed_from(&mut whole, 0..1500, 10_000.0, 3).unwrap();
    let whole = whole.finish().unwrap();
    // At a sample with balls and without, with lines that wait and with none.
    for stop in [1, 700, 1234] {
        let mut first = new();
        feed_from(&mut first, 0..stop, 10_000.0, 3).unwrap();
        let memory = serde_json::to_string(first.memory()).unwrap();
        let mut second = new();
        second.remember(serde_json::from_str(&memory).unwrap()).unwrap();
        feed_from(&mut second, stop..1500, 10_000.0, 3).unwrap();
        let after = second.finish().unwrap();
        let before = whole.len() - after.len();
        assert!(before > 0 && whole[before..] == after[..], "stopped after {stop} samples");
    }
    let other = case::case(BALLS - 1);
    let mut other = RunRecorder::new(Collected::default(), &recording(&other)).unwrap();
    let refused = other.remember(new().memory().clone());
    assert!(matches!(refused, Err(RecordError::BallCount { solution: 13, case: 12 })));
}

/// A disk that is full after some bytes.
#[derive(Debug)]
struct FullDisk(Cursor<Vec<u8>>, usize);

impl Write for FullDisk {
    fn write(&mut self, data: &[u8]) -> io::Result<usize> {
        if self.0.position() as usize + data.len() > self.1 {
            return Err(io::Error::from(io::ErrorKind::StorageFull));
        }
        self.0.write(data)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for FullDisk {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        self.0.seek(place)
    }
}

#[test]
fn limit_a_full_disk_is_an_error_with_the_name_of_the_file() {
    let case = case::case(BALLS);
    let whole = run_bytes(300, 5_000.0, 5).len();
    for capacity in [100, 30_000, whole / 2, whole - 2_000, whole - 1] {
        let sink = StreamSink::new(FullDisk(Cursor::default(), capacity), Path::new("run.mcap.active"));
        let recorded = RunRecorder::new(sink, &recording(&case)).and_then(|mut recorder| {
            feed(&mut recorder, 300, 5_000.0, 5)?;
            recorder.finish()
        });
        let text = recorded.unwrap_err().to_string();
        assert!(text.contains("run.mcap.active"), "{text}");
    }
    let missing = path("nowhere").join("run.mcap");
    let error = RunRecorder::<FileSink>::create(&missing, &recording(&case)).unwrap_err();
    assert!(matches!(error, RecordError::File { action: "create", .. }), "{error}");
}

/// A link where the temporary file belongs leads nowhere: what it points at stays as it is.
#[cfg(unix)]
#[test]
fn limit_the_temporary_recording_is_created_exclusively() {
    let (path, other) = (path("run-exclusive"), path("run-exclusive-other"));
    let active = Path::new(&format!("{}.active", path.display())).to_owned();
    std::fs::write(&other, "precious").unwrap();
    std::os::unix::fs::symlink(&other, &active).unwrap();
    let case = case::case(BALLS);
    let mut recorder = RunRecorder::create(&path, &recording(&case)).unwrap();
    assert!(!active.is_symlink());
    feed(&mut recorder, 10, 25_600.0, 5).unwrap();
    recorder.finish().unwrap();
    assert_eq!(std::fs::read_to_string(&other).unwrap(), "precious");
    assert!(!path.is_symlink() && read_run(&path).unwrap().states.len() == 10);
    [path, other].iter().for_each(|file| std::fs::remove_file(file).unwrap());
}
