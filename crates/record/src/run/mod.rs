//! Recording a transient run: an [`Observer`] that turns samples and events into messages for a [`Sink`].

mod check;
mod events;
mod frames;
mod history;
mod messages;
mod sink;
mod topics;

pub use sink::{FileSink, Preamble, Sink, StreamSink};
pub(crate) use topics::{CHANNELS, Topic};

use crate::contacts::{self, Scales};
use crate::output::{Entries, fnv1a};
use crate::scene::{self, Bodies};
use crate::timeline::{EPOCH_NS, timestamp};
use crate::wire::foxglove::Log;
use crate::{RecordError, write};
use events::Pending;
use frames::Motion;
use history::{LastTurn, QUANTITIES, Recent};
use messages::BallConstants;
use prost::Message;
use std::ops::ControlFlow;
use std::path::Path;
use tribodyn_bearing::Geometry;
use tribodyn_bearing::case::Case;
use tribodyn_dynamics::{Event, Observer, Sample};

/// The Foxglove layout for runs, with the camera at a bearing of 215 mm outside diameter; every recording carries it,
/// with the camera at its own bearing.
pub const RUN_LAYOUT: &str = include_str!("../../layout/run.json");

/// Simulated time between wear, orbit and spectra, s.
const SLOW_STEP_S: f64 = 0.1;
/// Simulated time after which a chunk is closed, s; a full one (1 MiB) is closed before. A killed run loses at most
/// this. A program of 20 s per simulated second then loses one second of its work; the clock itself cannot decide,
/// since the same case has to give the same bytes.
const FLUSH_STEP_S: f64 = 0.05;
/// Tolerance of these steps: times are sums of steps and may fall short of a multiple by rounding, s.
const ROUNDING_S: f64 = 1e-9;

/// What a recording of a run is made from.
#[derive(Debug, Clone, Copy)]
pub struct RunRecording<'a> {
    /// The text of the case file, attached unchanged.
    pub case_text: &'a str,
    /// The same case, parsed.
    pub case: &'a Case,
    /// Program and version, such as `tribodyn 0.1.0`: the file says who wrote it.
    pub generator: &'a str,
}

/// Simulated time as log time, ns.
pub(crate) fn log_time(time_s: f64) -> u64 {
    // Saturates below 0, which the check of a sample has refused.
    EPOCH_NS + (time_s * 1e9).round() as u64
}

/// Records a run.
#[derive(Debug)]
pub struct RunRecorder<S> {
    sink: S,
    producer: Producer,
}

impl RunRecorder<FileSink> {
    /// Starts a recording in `<path>.active`, which [`RunRecorder::finish`] renames. Dropped before that, for instance
    /// because the run failed, the file keeps what was recorded and [`crate::recover()`] makes a whole one of it.
    ///
    /// # Errors
    /// [`RecordError`] if the file cannot be created or the case makes no bearing.
    pub fn create(path: &Path, input: &RunRecording) -> Result<Self, RecordError> {
        // A case that is refused leaves no file.
        let producer = Producer::new(input)?;
        Self::begin(FileSink::create(path)?, producer, input)
    }
}

impl<S: Sink> RunRecorder<S> {
    /// Starts a recording into any sink.
    ///
    /// # Errors
    /// [`RecordError`] if the sink cannot begin or the case makes no bearing.
    pub fn new(sink: S, input: &RunRecording) -> Result<Self, RecordError> {
        Self::begin(sink, Producer::new(input)?, input)
    }

    fn begin(mut sink: S, producer: Producer, input: &RunRecording) -> Result<Self, RecordError> {
        let entries = entries(input, &producer.geometry);
        sink.begin(&Preamble {
            channels: &CHANNELS,
            generator: input.generator,
            case_text: input.case_text,
            layout: &write::layout(RUN_LAYOUT, &producer.geometry),
            entries: &entries,
        })?;
        Ok(Self { sink, producer })
    }

    /// Writes what is pending and ends the recording. A run that was broken off early is as whole a recording.
    ///
    /// # Errors
    /// [`RecordError`] if not everything can be stored.
    pub fn finish(mut self) -> Result<S::Output, RecordError> {
        self.producer.end(&mut self.sink)?;
        self.sink.finish()
    }
}

impl<S: Sink> Observer for RunRecorder<S> {
    type Error = RecordError;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        self.producer.sample(&mut self.sink, sample, with_balls)?;
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        self.producer.event(&mut self.sink, event)
    }
}

fn entries(input: &RunRecording, geometry: &Geometry) -> Entries {
    let case = input.case;
    let mut entries = vec![
        ("kind", "transient run".to_owned()),
        ("bearing", case.name.clone()),
        ("ball_count", geometry.ball_count.to_string()),
        ("ball_diameter_mm", (geometry.ball_diameter * 1e3).to_string()),
        ("pitch_diameter_mm", (geometry.pitch_diameter * 1e3).to_string()),
        ("free_contact_angle_deg", geometry.contact_angle.to_degrees().to_string()),
        ("patch_exaggeration", contacts::PATCH_EXAGGERATION.to_string()),
        // The same case always gives the same run.
        ("seed", "none".to_owned()),
        ("generator", input.generator.to_owned()),
        ("case_fnv1a64", format!("{:016x}", fnv1a(input.case_text.as_bytes()))),
    ];
    if let Some(transient) = &case.transient {
        entries.push(("duration_s", transient.duration.to_string()));
        entries.push(("start", format!("{:?}", transient.start)));
        entries.push(("scheme", format!("{:?}", transient.scheme)));
        entries.push(("contact_damping", transient.contact_damping.to_string()));
        entries.push(("wear_acceleration", transient.wear_acceleration.to_string()));
    }
    if let Some(recording) = &case.recording {
        entries.push(("state_rate_hz", recording.state_rate.to_string()));
        entries.push(("ball_rate_hz", recording.ball_rate.to_string()));
    }
    entries
}

/// Makes the messages.
#[derive(Debug)]
struct Producer {
    geometry: Geometry,
    pocket_gap: f64,
    name: String,
    constants: BallConstants,
    motion: Motion,
    /// Scales of arrows and patches, once the first sample has set them.
    scales: Option<Scales>,
    pending: Pending,
    last_turn: LastTurn,
    recent: Recent,
    /// Time of the last sample, s.
    last_time_s: f64,
    /// Log time of the last message, ns.
    last_log_time: u64,
    next_slow_s: f64,
    next_flush_s: f64,
    /// The encoded message, kept for its memory.
    buffer: Vec<u8>,
}

impl Producer {
    fn new(input: &RunRecording) -> Result<Self, RecordError> {
        let geometry = Geometry::new(&input.case.geometry)?;
        Ok(Self {
            geometry,
            pocket_gap: input.case.cage.pocket_gap,
            name: input.case.name.clone(),
            constants: BallConstants::new(&geometry, input.case.materials.ball.density),
            motion: Motion::new(geometry.ball_count),
            scales: None,
            pending: Pending::default(),
            last_turn: LastTurn::default(),
            recent: Recent::default(),
            last_time_s: 0.0,
            last_log_time: EPOCH_NS,
            next_slow_s: SLOW_STEP_S,
            next_flush_s: FLUSH_STEP_S,
            buffer: Vec::new(),
        })
    }

    /// Encodes and hands out a message, not before the last one.
    fn send(&mut self, sink: &mut impl Sink, to: Topic, time: u64, message: &impl Message) -> Result<(), RecordError> {
        self.last_log_time = self.last_log_time.max(time);
        self.buffer.clear();
        // A growing vector has room for every message.
        if message.encode(&mut self.buffer).is_err() {
            self.buffer = message.encode_to_vec();
        }
        sink.message(to as usize, self.last_log_time, &self.buffer)
    }

    fn sample(&mut self, sink: &mut impl Sink, sample: &Sample, with_balls: bool) -> Result<(), RecordError> {
        check::check(sample, self.geometry.ball_count, self.last_time_s)?;
        self.last_time_s = sample.time_s;
        let time = log_time(sample.time_s);
        let scales = match self.scales {
            Some(scales) => scales,
            None => self.geometry(sink, sample, time)?,
        };
        self.log_due(sink, sample.time_s)?;
        self.motion.advance(sample);
        self.last_turn.push(sample);
        self.recent.push(sample);
        let state = messages::state(sample, time, self.pending.impacts());
        self.send(sink, Topic::State, time, &state)?;
        if with_balls {
            let balls = messages::balls(&self.constants, sample, time);
            self.send(sink, Topic::Balls, time, &balls)?;
            self.scene(sink, sample, scales, time)?;
        }
        if sample.time_s + ROUNDING_S >= self.next_slow_s {
            self.next_slow_s = next(self.next_slow_s, SLOW_STEP_S, sample.time_s);
            self.slow(sink, Some(sample), time)?;
        }
        if sample.time_s + ROUNDING_S >= self.next_flush_s {
            self.next_flush_s = next(self.next_flush_s, FLUSH_STEP_S, sample.time_s);
            sink.flush()?;
        }
        Ok(())
    }

    /// The bodies, at the first sample.
    fn geometry(&mut self, sink: &mut impl Sink, sample: &Sample, time: u64) -> Result<Scales, RecordError> {
        let scales = Scales::of_first(&sample.balls);
        self.scales = Some(scales);
        let first = sample.balls.first().map_or(0.0, |b| b.azimuth_rad - b.pocket_lead_rad);
        let bodies = Bodies {
            geometry: &self.geometry,
            pocket_gap: self.pocket_gap,
            first_azimuth: first - sample.cage.angle_rad,
            name: &self.name,
            scales,
        };
        let update = scene::geometry(&bodies, timestamp(time));
        self.send(sink, Topic::Geometry, time, &update)?;
        // Wear from nothing on, so that the panel shows something from the start.
        let wear = messages::wear(sample, time);
        self.send(sink, Topic::Wear, time, &wear)?;
        Ok(scales)
    }

    /// Frames and contacts where enough has turned since the last ones.
    fn scene(&mut self, sink: &mut impl Sink, s: &Sample, scales: Scales, time: u64) -> Result<(), RecordError> {
        if self.motion.frames_due(s) {
            let transforms = self.motion.transforms(s, time);
            self.send(sink, Topic::Transforms, time, &transforms)?;
        }
        if self.motion.contacts_due(s) {
            let arrows = s.balls.iter().map(contacts::of_sample);
            let update = contacts::update(self.geometry.ball_diameter, scales, time, arrows);
            self.send(sink, Topic::Contacts, time, &update)?;
        }
        Ok(())
    }

    /// Orbit and spectra, and wear where there is a sample.
    fn slow(&mut self, sink: &mut impl Sink, sample: Option<&Sample>, time: u64) -> Result<(), RecordError> {
        if let Some(sample) = sample {
            let wear = messages::wear(sample, time);
            self.send(sink, Topic::Wear, time, &wear)?;
        }
        let orbit = self.last_turn.message(self.last_time_s, time);
        self.send(sink, Topic::Orbit, time, &orbit)?;
        let topics = [Topic::SpectrumOuter, Topic::SpectrumInner, Topic::SpectrumCage];
        for (quantity, topic) in topics.into_iter().enumerate().take(QUANTITIES.len()) {
            if let Some(spectrum) = self.recent.spectrum(quantity, time)? {
                self.send(sink, topic, time, &spectrum)?;
            }
        }
        Ok(())
    }

    fn event(&mut self, sink: &mut impl Sink, event: &Event) -> Result<(), RecordError> {
        if !event.time_s.is_finite() {
            return Err(RecordError::NotFinite { field: "time_s of an event".to_owned(), value: event.time_s });
        }
        self.log_due(sink, event.time_s)?;
        if let Some(line) = self.pending.add(event) {
            self.send(sink, Topic::Log, log_time(event.time_s), &line)?;
        }
        Ok(())
    }

    /// Lines whose windows are over.
    fn log_due(&mut self, sink: &mut impl Sink, time_s: f64) -> Result<(), RecordError> {
        let lines: Vec<Log> = self.pending.due(time_s).collect();
        // Not before the message that was last; the line has the time of its event.
        lines.iter().try_for_each(|line| self.send(sink, Topic::Log, self.last_log_time, line))
    }

    fn end(&mut self, sink: &mut impl Sink) -> Result<(), RecordError> {
        self.log_due(sink, f64::INFINITY)?;
        if self.scales.is_none() {
            return Ok(());
        }
        let between = self.last_time_s > self.next_slow_s - SLOW_STEP_S + ROUNDING_S;
        if between { self.slow(sink, None, self.last_log_time) } else { Ok(()) }
    }
}

/// The multiple of a step after a time.
fn next(due: f64, step: f64, time: f64) -> f64 {
    due + step * (((time + ROUNDING_S - due) / step).floor() + 1.0)
}
