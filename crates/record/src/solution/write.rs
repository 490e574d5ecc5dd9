//! Writing a recording: checks first, then everything into a temporary file, which gets its name when it is whole.

use super::check::check;
use super::messages;
use crate::ball;
use crate::contacts::{self, Drawing, Moment, Scales};
use crate::frames::{self, Orientations};
use crate::layout::{Layout, LayoutKind};
use crate::output::{Channel, Entries, Output, SMALL, file_error, fnv1a};
use crate::scene::{self, Bodies};
use crate::timeline::{EPOCH_NS, Timeline, timestamp};
use crate::wire::foxglove::{Log, SceneUpdate, log};
use crate::{RecordError, RecordingSummary, TemporaryFile, read_summary};
use mcap::McapResult;
use std::io::{BufWriter, Seek, Write};
use std::path::Path;
use tribodyn_bearing::{BallResult, Bearing, Geometry, OperatingPoint, Races, SpeedHistory};
use tribodyn_quasistatic::Solution;
use tribodyn_quasistatic::{AzimuthRule, OverAzimuth};

/// Name of the attachment that holds the case file.
pub const CASE_ATTACHMENT: &str = "case.ron";
/// Name of the attachment that holds the layout.
pub const LAYOUT_ATTACHMENT: &str = "tribodyn.json";

/// Inputs of a recording of a quasi-static solution.
#[derive(Debug, Clone, Copy)]
pub struct SolutionRecording<'a> {
    /// The text of the case file, attached unchanged.
    pub case_text: &'a str,
    /// Name of the bearing, the title of the recording.
    pub name: &'a str,
    /// The bearing that was solved, mounted and at speed: it is the one that is drawn and described.
    pub bearing: &'a Bearing,
    /// The operating point that was solved.
    pub point: &'a OperatingPoint,
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
    let mut part = TemporaryFile::beside(path).map_err(|source| file_error("create", path, source))?;
    let mut buffer = recording.write(BufWriter::new(part.file())).map_err(|source| RecordError::Mcap {
        action: "write",
        path: path.to_owned(),
        source,
    })?;
    buffer.flush().map_err(|source| file_error("write", path, source))?;
    drop(buffer);
    part.publish(path).map_err(|source| file_error("write", path, source))?;
    read_summary(path)
}

/// Everything checked and ready to be written.
pub(crate) struct Recording<'a> {
    input: SolutionRecording<'a>,
    geometry: &'a Geometry,
    timeline: Timeline,
    over: OverAzimuth<'a>,
}

impl<'a> Recording<'a> {
    pub(crate) fn new(input: &SolutionRecording<'a>) -> Result<Self, RecordError> {
        let solution = input.solution;
        let geometry = &input.bearing.geometry;
        check(solution, geometry)?;
        Ok(Self { input: *input, geometry, timeline: Timeline::new(solution)?, over: OverAzimuth::new(solution) })
    }

    /// Writes all messages in order of time and hands the stream back.
    pub(crate) fn write<W: Write + Seek>(&self, stream: W) -> McapResult<W> {
        let mut out = Output::new(stream, self.input.generator, SMALL, &CHANNELS)?;
        out.describe(&self.metadata(), self.input.case_text, &self.layout())?;
        self.write_start(&mut out)?;
        let mut orientations = Orientations::new(self.geometry.ball_count);
        for sample in 0..=self.timeline.samples {
            self.write_sample(&mut out, sample, &orientations)?;
            orientations.advance(&self.over, &self.timeline, sample);
        }
        out.writer.finish()?;
        Ok(out.writer.into_inner())
    }

    /// The bodies and the warnings, at time 0.
    fn write_start<W: Write + Seek>(&self, out: &mut Output<W>) -> McapResult<()> {
        let bodies = Bodies {
            geometry: self.geometry,
            pocket_gap: self.input.point.cage.map(|cage| cage.pocket_gap),
            first_azimuth: self.over.start(0),
            scales: Scales::of(self.input.solution),
            ring_load_n: self.input.solution.ring_load_n,
            // Defects act in runs only, and a solution wears nothing.
            defects: &[],
            with_coating: false,
        };
        out.log(Topic::Geometry as usize, EPOCH_NS, &scene::geometry(&bodies, timestamp(EPOCH_NS)))?;
        for warning in &self.input.solution.warnings {
            let line = Log {
                timestamp: Some(timestamp(EPOCH_NS)),
                level: log::Level::Warning.into(),
                message: warning.clone(),
                name: "quasistatic".into(),
                ..Log::default()
            };
            out.log(Topic::Log as usize, EPOCH_NS, &line)?;
        }
        Ok(())
    }

    fn write_sample<W: Write + Seek>(
        &self,
        out: &mut Output<W>,
        sample: usize,
        orientations: &Orientations,
    ) -> McapResult<()> {
        let (solution, timeline) = (self.input.solution, &self.timeline);
        let turned = timeline.cage_angle(sample);
        let balls: Vec<BallResult> =
            (0..self.geometry.ball_count).map(|ball| self.over.at(self.over.start(ball) + turned)).collect();
        let time = timeline.log_time(sample);
        if sample.is_multiple_of(timeline.frame_stride) {
            out.log(
                Topic::Transforms as usize,
                time,
                &frames::transforms(solution, timeline, sample, &balls, orientations),
            )?;
            let drawing = Drawing { geometry: self.geometry, scales: Scales::of(solution), defects: &[] };
            let seconds = timeline.seconds(sample);
            let moment = Moment {
                log_time: time,
                ring_load_n: solution.ring_load_n,
                cage_angle_rad: turned,
                ring_angles_rad: [solution.inner_speed_rad_s, solution.outer_speed_rad_s].map(|speed| speed * seconds),
            };
            let mut update = SceneUpdate::default();
            contacts::update(&mut update, &drawing, &moment, &balls);
            out.log(Topic::Azimuth as usize, time, &ball::around(timestamp(time), seconds, &balls))?;
            out.log(Topic::Contacts as usize, time, &update)?;
        }
        out.log(Topic::State as usize, time, &messages::state(solution, timeline, sample, &balls))?;
        out.log(Topic::Balls as usize, time, &messages::balls(timeline, sample, &balls))
    }

    fn layout(&self) -> String {
        let OperatingPoint { inner_speed, outer_speed, .. } = *self.input.point;
        let speeds = Races { inner: inner_speed, outer: outer_speed }.map(SpeedHistory::Constant);
        Layout::new(LayoutKind::Solution, self.input.name, self.geometry, &speeds).json()
    }

    fn metadata(&self) -> Entries {
        let (solution, timeline) = (self.input.solution, &self.timeline);
        let geometry = self.geometry;
        vec![
            ("kind", "solution, one orbit of the cage".to_owned()),
            ("bearing", self.input.name.to_owned()),
            ("ball_count", geometry.ball_count.to_string()),
            ("ball_diameter_mm", (geometry.ball_diameter * 1e3).to_string()),
            ("pitch_diameter_mm", (geometry.pitch_diameter * 1e3).to_string()),
            ("inner_groove_coefficient", geometry.inner_coefficient.to_string()),
            ("outer_groove_coefficient", geometry.outer_coefficient.to_string()),
            ("free_contact_angle_deg", geometry.contact_angle().to_degrees().to_string()),
            ("model", solution.equations().to_owned()),
            ("converged", solution.converged.to_string()),
            ("residual", solution.residual.to_string()),
            ("iterations", solution.iterations.to_string()),
            ("tolerance", self.input.point.numerics.tolerance.to_string()),
            ("cage_speed_rpm", solution.cage_speed_rpm.to_string()),
            ("interpolation", AzimuthRule::of(solution).name().to_owned()),
            ("step_ns", timeline.step_ns.to_string()),
            ("samples_per_orbit", timeline.samples.to_string()),
            ("frame_stride", timeline.frame_stride.to_string()),
            ("patch_exaggeration", contacts::PATCH_EXAGGERATION.to_string()),
            ("generator", self.input.generator.to_owned()),
            ("case_fnv1a64", format!("{:016x}", fnv1a(self.input.case_text.as_bytes()))),
        ]
    }
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
    Azimuth,
}

/// The channels, in the order of [`Topic`].
const CHANNELS: [Channel; 7] = [
    Channel::foxglove("/bearing/geometry", "foxglove.SceneUpdate"),
    Channel::foxglove("/log", "foxglove.Log"),
    Channel::foxglove("/tf", "foxglove.FrameTransforms"),
    Channel::foxglove("/bearing/contacts", "foxglove.SceneUpdate"),
    Channel::own("/bearing/state", "tribodyn.v1.BearingState"),
    Channel::own("/bearing/balls", "tribodyn.v1.Balls"),
    Channel::own("/bearing/azimuth", "tribodyn.v1.AroundBearing"),
];
