//! Writing a recording: checks first, then everything into `<path>.active`, which gets its name when it is whole.

use crate::check::check;
use crate::contacts::{self, Scales};
use crate::frames::{self, Spins};
use crate::scene::{self, Bodies};
use crate::timeline::{EPOCH_NS, Timeline, timestamp};
use crate::wire::foxglove::{Log, log};
use crate::wire::{FOXGLOVE_DESCRIPTORS, TRIBODYN_DESCRIPTORS};
use crate::{RecordError, RecordingSummary, mesh, messages, read_summary};
use mcap::records::{MessageHeader, Metadata};
use mcap::{Attachment, McapResult, WriteOptions, Writer};
use prost::Message;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use tribodyn_bearing::case::Case;
use tribodyn_bearing::{Geometry, Side};
use tribodyn_quasistatic::{AzimuthRule, OverAzimuth};
use tribodyn_quasistatic::{BallSolution, Solution};

/// The Foxglove layout that belongs to a recording, with the camera at a bearing of 215 mm outside diameter; every
/// recording carries it as an attachment, with the camera at its own bearing.
pub const LAYOUT: &str = include_str!("../layout/tribodyn.json");

/// The camera distance as it stands in [`LAYOUT`], m, and what it is over the outside diameter.
const CAMERA: &str = "\"distance\": 0.42";
const CAMERA_OVER_DIAMETER: f64 = 0.42 / 0.215;

/// Name of the attachment that holds the case file.
pub const CASE_ATTACHMENT: &str = "case.ron";
/// Name of the attachment that holds the layout.
pub const LAYOUT_ATTACHMENT: &str = "tribodyn.json";

/// What a recording of a quasi-static solution is made from.
#[derive(Debug, Clone, Copy)]
pub struct SolutionRecording<'a> {
    /// The text of the case file, attached unchanged.
    pub case_text: &'a str,
    /// The same case, parsed: geometry, title and pocket gap are used.
    pub case: &'a Case,
    /// The solution.
    pub solution: &'a Solution,
    /// Program and version, such as `tribodyn 0.1.0`: the file says who wrote it.
    pub generator: &'a str,
}

/// Writes one orbit of a quasi-static solution to an MCAP file and returns what the closed file holds.
///
/// An existing file at `path` is replaced, but only by a whole one; after an error nothing is left behind.
///
/// # Errors
/// [`RecordError`] if case and solution do not fit together, a number is not finite, the cage stands still, or the
/// file cannot be written in full.
pub fn write_solution(path: &Path, input: &SolutionRecording) -> Result<RecordingSummary, RecordError> {
    let recording = Recording::new(input)?;
    let active = active_path(path);
    let written = write_active(&active, &recording)
        .and_then(|()| fs::rename(&active, path).map_err(|source| file_error("move into place", &active, source)));
    if let Err(error) = written {
        // The file may not exist; the error that counts is the first.
        let _ = fs::remove_file(&active);
        return Err(error);
    }
    read_summary(path)
}

/// `<path>.active`: viewers know that such a file is not whole.
fn active_path(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".active");
    PathBuf::from(name)
}

fn file_error(action: &'static str, path: &Path, source: std::io::Error) -> RecordError {
    RecordError::File { action, path: path.to_owned(), source }
}

fn write_active(active: &Path, recording: &Recording) -> Result<(), RecordError> {
    let file = File::create(active).map_err(|source| file_error("create", active, source))?;
    let buffer = recording.write(BufWriter::new(file)).map_err(|source| RecordError::Mcap {
        action: "write",
        path: active.to_owned(),
        source,
    })?;
    let file = buffer.into_inner().map_err(|error| file_error("flush", active, error.into_error()))?;
    file.sync_all().map_err(|source| file_error("close", active, source))
}

/// Everything checked and ready to be written.
pub(crate) struct Recording<'a> {
    input: SolutionRecording<'a>,
    geometry: Geometry,
    timeline: Timeline,
    over: OverAzimuth<'a>,
}

impl<'a> Recording<'a> {
    pub(crate) fn new(input: &SolutionRecording<'a>) -> Result<Self, RecordError> {
        let solution = input.solution;
        let geometry = Geometry::new(&input.case.geometry)?;
        check(solution, &geometry)?;
        Ok(Self { input: *input, geometry, timeline: Timeline::new(solution)?, over: OverAzimuth::new(solution) })
    }

    /// Writes all messages in order of time and hands the stream back.
    pub(crate) fn write<W: Write + Seek>(&self, stream: W) -> McapResult<W> {
        let mut out = Output::new(stream, self.input.generator)?;
        out.writer.write_metadata(&self.metadata())?;
        let layout = layout(&self.geometry);
        for (name, media_type, text) in
            [(CASE_ATTACHMENT, "text/plain", self.input.case_text), (LAYOUT_ATTACHMENT, "application/json", &layout)]
        {
            out.writer.attach(&Attachment {
                log_time: EPOCH_NS,
                create_time: EPOCH_NS,
                name: name.into(),
                media_type: media_type.into(),
                data: Cow::Borrowed(text.as_bytes()),
            })?;
        }
        self.write_start(&mut out)?;
        let mut spins = Spins::new(self.geometry.ball_count);
        for sample in 0..=self.timeline.samples {
            self.write_sample(&mut out, sample, &spins)?;
            spins.advance(&self.over, &self.timeline, sample);
        }
        out.writer.finish()?;
        Ok(out.writer.into_inner())
    }

    /// The bodies and the warnings, at time 0.
    fn write_start<W: Write + Seek>(&self, out: &mut Output<W>) -> McapResult<()> {
        let bodies = Bodies {
            geometry: &self.geometry,
            pocket_gap: self.input.case.cage.pocket_gap,
            first_azimuth: self.over.start(0),
            name: &self.input.case.name,
            scales: Scales::of(self.input.solution),
        };
        out.log(Topic::Geometry, EPOCH_NS, &scene::geometry(&bodies, timestamp(EPOCH_NS)))?;
        for warning in &self.input.solution.warnings {
            let line = Log {
                timestamp: Some(timestamp(EPOCH_NS)),
                level: log::Level::Warning.into(),
                message: warning.clone(),
                name: "quasistatic".into(),
                ..Log::default()
            };
            out.log(Topic::Log, EPOCH_NS, &line)?;
        }
        Ok(())
    }

    fn write_sample<W: Write + Seek>(&self, out: &mut Output<W>, sample: usize, spins: &Spins) -> McapResult<()> {
        let (solution, timeline) = (self.input.solution, &self.timeline);
        let turned = timeline.cage_angle(sample);
        let at = |azimuth: f64| (azimuth, self.over.at(azimuth));
        let balls: Vec<(f64, BallSolution)> =
            (0..self.geometry.ball_count).map(|ball| at(self.over.start(ball) + turned)).collect();
        let time = timeline.log_time(sample);
        if sample.is_multiple_of(timeline.frame_stride) {
            let diameter = self.geometry.ball_diameter;
            out.log(Topic::Transforms, time, &frames::transforms(solution, timeline, sample, &balls, spins))?;
            out.log(Topic::Contacts, time, &contacts::update(diameter, Scales::of(solution), time, &balls))?;
        }
        out.log(Topic::State, time, &messages::state(solution, timeline, sample, &balls))?;
        out.log(Topic::Balls, time, &messages::balls(self.geometry.pitch_diameter, timeline, sample, &balls))
    }

    fn metadata(&self) -> Metadata {
        let (solution, timeline) = (self.input.solution, &self.timeline);
        let geometry = &self.geometry;
        let entries = [
            ("kind", "quasi-static, one orbit of the cage".to_owned()),
            ("bearing", self.input.case.name.clone()),
            ("ball_count", geometry.ball_count.to_string()),
            ("ball_diameter_mm", (geometry.ball_diameter * 1e3).to_string()),
            ("pitch_diameter_mm", (geometry.pitch_diameter * 1e3).to_string()),
            ("free_contact_angle_deg", geometry.contact_angle.to_degrees().to_string()),
            ("model", format!("{:?}", solution.model)),
            ("converged", solution.converged.to_string()),
            ("residual", solution.residual.to_string()),
            ("iterations", solution.iterations.to_string()),
            ("tolerance", self.input.case.numerics.tolerance.to_string()),
            ("cage_speed_rpm", solution.cage_speed_rpm.to_string()),
            ("interpolation", AzimuthRule::of(solution).name().to_owned()),
            ("step_ns", timeline.step_ns.to_string()),
            ("samples_per_orbit", timeline.samples.to_string()),
            ("frame_stride", timeline.frame_stride.to_string()),
            ("patch_exaggeration", contacts::PATCH_EXAGGERATION.to_string()),
            ("generator", self.input.generator.to_owned()),
            ("case_fnv1a64", format!("{:016x}", fnv1a(self.input.case_text.as_bytes()))),
        ];
        let metadata: BTreeMap<String, String> = entries.into_iter().map(|(k, v)| (k.to_owned(), v)).collect();
        Metadata { name: "simulation".into(), metadata }
    }
}

/// The layout with the camera where it sees the whole bearing.
fn layout(geometry: &Geometry) -> String {
    let distance = CAMERA_OVER_DIAMETER * 2.0 * mesh::back_radius(geometry, Side::Outer);
    LAYOUT.replace(CAMERA, &format!("\"distance\": {distance:.4}"))
}

/// FNV-1a, 64 bits (RFC 9923): tells one case from another, no protection against forgery.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The topics of a recording.
#[derive(Debug, Clone, Copy)]
enum Topic {
    Geometry,
    Log,
    Transforms,
    Contacts,
    State,
    Balls,
}

/// Topic name, schema name and descriptor set, in the order of [`Topic`].
const CHANNELS: [(&str, &str, &[u8]); 6] = [
    ("/bearing/geometry", "foxglove.SceneUpdate", FOXGLOVE_DESCRIPTORS),
    ("/log", "foxglove.Log", FOXGLOVE_DESCRIPTORS),
    ("/tf", "foxglove.FrameTransforms", FOXGLOVE_DESCRIPTORS),
    ("/bearing/contacts", "foxglove.SceneUpdate", FOXGLOVE_DESCRIPTORS),
    ("/bearing/state", "tribodyn.v1.BearingState", TRIBODYN_DESCRIPTORS),
    ("/bearing/balls", "tribodyn.v1.Balls", TRIBODYN_DESCRIPTORS),
];

/// An open MCAP file with its channels.
struct Output<W: Write + Seek> {
    writer: Writer<W>,
    channels: [(u16, u32); CHANNELS.len()],
}

impl<W: Write + Seek> Output<W> {
    fn new(stream: W, generator: &str) -> McapResult<Self> {
        let mut writer = WriteOptions::new()
            .library(generator)
            // Threads would change the bytes.
            .compression_threads(0)
            .create(stream)?;
        let mut channels = [(0, 0); CHANNELS.len()];
        for (slot, (topic, schema, descriptors)) in channels.iter_mut().zip(CHANNELS) {
            let schema = writer.add_schema(schema, "protobuf", descriptors)?;
            slot.0 = writer.add_channel(schema, topic, "protobuf", &BTreeMap::new())?;
        }
        Ok(Self { writer, channels })
    }

    fn log(&mut self, topic: Topic, time: u64, message: &impl Message) -> McapResult<()> {
        let (channel_id, sequence) = &mut self.channels[topic as usize];
        let header = MessageHeader { channel_id: *channel_id, sequence: *sequence, log_time: time, publish_time: time };
        *sequence += 1;
        self.writer.write_to_known_channel(&header, &message.encode_to_vec())
    }
}
