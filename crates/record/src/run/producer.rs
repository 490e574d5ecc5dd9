//! From samples and events to messages, and what has to be remembered between them.

use super::check;
use super::events::{self, Pending};
use super::frames::Motion;
use super::history::{self, LastTurn, QUANTITIES, Recent};
use super::messages;
use super::overview::Overview;
use super::{RunRecording, Sink, Topic, log_time};
use crate::RecordError;
use crate::ball;
use crate::contacts::{self, Drawing, Moment, Scales};
use crate::raceway::{self, Defect, Found};
use crate::scene::{self, Bodies};
use crate::timeline::{EPOCH_NS, timestamp};
use crate::trail::{self, Trail};
use crate::wire::Flat;
use crate::wire::foxglove::{FrameTransforms, Log, SceneUpdate};
use crate::wire::tribodyn::Balls;
use prost::Message;
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{BallResult, Bearing};
use tribodyn_dynamics::{Event, Sample, WearSample};

/// Simulated time between wear, coating and path of the inner ring, s: one second of a viewer that plays at a hundredth
/// of the speed.
const SLOW_STEP_S: f64 = 0.01;
/// Simulated time between spectra, s, once all their samples are there: they are most of what comes slowly. Before
/// that there is one whenever twice the samples give half the distance between lines.
const SPECTRA_STEP_S: f64 = 0.1;
/// Simulated time after which a chunk is closed, s; a full one (1 MiB) is closed before. A killed run loses at most
/// this. A program of 20 s per simulated second then loses one second of its work; the clock itself cannot decide,
/// since the same case has to give the same bytes.
const FLUSH_STEP_S: f64 = 0.05;
/// Tolerance of these steps: times are sums of steps and may fall short of a multiple by rounding, s.
const ROUNDING_S: f64 = 1e-9;

/// A sample and its balls.
type SampleAndBalls<'a> = (&'a Sample, &'a [BallResult]);

/// Makes the messages.
#[derive(Debug)]
pub(super) struct Producer {
    bearing: Bearing,
    pocket_gap: f64,
    /// Warnings of the state that the run starts from, for the log.
    warnings: Vec<String>,
    defects: Vec<Defect>,
    memory: RecorderMemory,
    /// The last messages of their kind and the last encoded one, kept for their memory and their names.
    transforms: FrameTransforms,
    contacts: SceneUpdate,
    buffer: Vec<u8>,
    flat: Vec<u8>,
}

/// All of a recorder that changes during a run: how far the balls have turned, the samples behind spectra and orbits,
/// what waits for the log, and when what is due.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecorderMemory {
    motion: Motion,
    /// Scales of arrows and patches, once the first sample has set them.
    scales: Option<Scales>,
    pending: Pending,
    last_turn: LastTurn,
    #[serde(default)]
    trail: Trail,
    recent: Recent,
    found: Found,
    /// Time of the last sample, s, and what had worn off by then.
    last_time_s: f64,
    last_wear: WearSample,
    /// Log time of the last message, ns.
    last_log_time: u64,
    next_slow_s: f64,
    next_flush_s: f64,
    /// Time of the last spectra, s, and samples behind them.
    last_spectra_s: f64,
    spectra_samples: usize,
}

impl RecorderMemory {
    /// Before the first sample of a run with so many balls.
    fn new(balls: usize) -> Self {
        Self {
            motion: Motion::new(balls),
            scales: None,
            pending: Pending::default(),
            last_turn: LastTurn::default(),
            trail: Trail::default(),
            recent: Recent::default(),
            found: Found::default(),
            last_time_s: 0.0,
            last_wear: WearSample::default(),
            last_log_time: EPOCH_NS,
            // The first sample has what comes slowly too, so that no panel is empty at the start.
            next_slow_s: 0.0,
            next_flush_s: FLUSH_STEP_S,
            last_spectra_s: 0.0,
            spectra_samples: 0,
        }
    }
}

/// Longest simulated time that is believed, s: log times are whole ns in 64 bits.
const LONGEST_S: f64 = 1e9;
/// Most events that are believed.
const MOST_EVENTS: f64 = 1e15;

impl RecorderMemory {
    /// Refuses a memory that no recorder of so many balls has: it may come from a file.
    fn check(&self, balls: usize) -> Result<(), RecordError> {
        let found = self.motion.balls();
        if found != balls {
            return Err(RecordError::BallCount { solution: found, case: balls });
        }
        let within = |field, value: f64, least: f64, most: f64| {
            let allowed = || format!("{least} to {most}");
            (least..=most).contains(&value).then_some(()).ok_or_else(|| RecordError::Memory {
                field,
                value,
                allowed: allowed(),
            })
        };
        within("last_time_s", self.last_time_s, 0.0, LONGEST_S)?;
        let after =
            |field, due: f64, step: f64| within(field, due, self.last_time_s - step, self.last_time_s + 2.0 * step);
        after("next_slow_s", self.next_slow_s, SLOW_STEP_S)?;
        after("next_flush_s", self.next_flush_s, FLUSH_STEP_S)?;
        within("last_spectra_s", self.last_spectra_s, 0.0, self.last_time_s)?;
        within("spectra_samples", self.spectra_samples as f64, 0.0, history::SPECTRUM_SAMPLES as f64)?;
        let log_time_s = (self.last_log_time as f64 - EPOCH_NS as f64) * 1e-9;
        within("last_log_time since the epoch, s", log_time_s, -1e-6, self.last_time_s + 1.0)?;
        within("impacts", self.pending.impacts() as f64, 0.0, MOST_EVENTS)?;
        within("events that wait", self.pending.waiting() as f64, 0.0, MOST_EVENTS)?;
        let lists = [
            ("entries of motion.last", self.motion.last_balls().unwrap_or(balls), balls, balls),
            ("points of last_turn", self.last_turn.len(), 0, history::ORBIT_POINTS),
            ("points of trail", self.trail.len(), 0, trail::POINTS),
            ("entries of found", self.found.sectors(), raceway::SECTORS, raceway::SECTORS),
        ];
        let recent = self
            .recent
            .sizes()
            .map(|count| ("samples of recent", count, self.recent.times(), history::SPECTRUM_SAMPLES));
        for (field, count, least, most) in lists.into_iter().chain(recent) {
            within(field, count as f64, least as f64, most as f64)?;
        }
        let numbers =
            self.motion.values().chain(self.last_turn.values()).chain(self.trail.values()).chain(self.recent.values());
        match numbers.into_iter().find(|value| !value.is_finite()) {
            Some(value) => within("a remembered number", value, f64::MIN, f64::MAX),
            None => Ok(()),
        }
    }
}

impl Producer {
    pub(super) fn new(input: &RunRecording) -> Self {
        let bearing = input.inputs.bearing.clone();
        Self {
            memory: RecorderMemory::new(bearing.geometry.ball_count),
            bearing,
            pocket_gap: input.inputs.cage.pockets.pocket_gap,
            warnings: input.warnings.to_vec(),
            defects: raceway::defects(input.inputs),
            transforms: FrameTransforms::default(),
            contacts: SceneUpdate::default(),
            buffer: Vec::new(),
            flat: Vec::new(),
        }
    }

    pub(super) fn memory(&self) -> &RecorderMemory {
        &self.memory
    }

    pub(super) fn remember(&mut self, memory: RecorderMemory) -> Result<(), RecordError> {
        memory.check(self.bearing.geometry.ball_count)?;
        self.memory = memory;
        Ok(())
    }

    /// Encodes and hands out a message, not before the last one.
    fn send(&mut self, sink: &mut impl Sink, to: Topic, time: u64, message: &impl Message) -> Result<(), RecordError> {
        self.memory.last_log_time = self.memory.last_log_time.max(time);
        // Into a slice: a vector would look for room at every byte.
        let length = loop {
            let mut rest = &mut self.buffer[..];
            let room = rest.len();
            match message.encode(&mut rest) {
                Ok(()) => break room - rest.len(),
                Err(error) => self.buffer.resize(2 * error.required_capacity(), 0),
            }
        };
        sink.message(to as usize, self.memory.last_log_time, &self.buffer[..length])
    }

    /// The same for balls.
    fn send_balls(&mut self, sink: &mut impl Sink, time: u64, balls: &Balls) -> Result<(), RecordError> {
        self.memory.last_log_time = self.memory.last_log_time.max(time);
        self.flat.clear();
        balls.put(&mut self.flat);
        sink.message(Topic::Balls as usize, self.memory.last_log_time, &self.flat)
    }

    pub(super) fn sample(
        &mut self,
        sink: &mut impl Sink,
        overview: &Overview,
        mut balls: Option<&mut [BallResult]>,
    ) -> Result<(), RecordError> {
        let (sample, count) = (&overview.sample, self.bearing.geometry.ball_count);
        let time = log_time(sample.time_s);
        if let Some(balls) = &mut balls {
            self.bearing.put_films(balls);
        }
        let balls = balls.as_deref();
        let of_balls = balls.map(|balls| (balls, messages::balls(balls, sample.time_s, time)));
        if let Some((balls, message)) = &of_balls {
            check::check_balls(&message.balls, balls, count)?;
        }
        let state = messages::state(overview, time, self.memory.pending.impacts());
        check::check(overview, &state, count, self.memory.last_time_s)?;
        (self.memory.last_time_s, self.memory.last_wear) = (sample.time_s, sample.wear);
        let scales = match self.memory.scales {
            Some(scales) => scales,
            None => self.geometry(sink, (sample, balls.unwrap_or_default()), time)?,
        };
        self.log_due(sink, sample.time_s)?;
        self.memory.motion.advance(overview);
        self.memory.last_turn.push(sample);
        if balls.is_some() {
            self.memory.trail.push(&sample.cage);
        }
        self.memory.recent.push(overview);
        sink.state(&state);
        self.send(sink, Topic::State, time, &state)?;
        if let Some((balls, message)) = of_balls {
            self.memory.found.push(sample, balls);
            sink.balls(&message.balls);
            self.send_balls(sink, time, &message)?;
            self.scene(sink, (sample, balls), scales, time)?;
        }
        if sample.time_s + ROUNDING_S >= self.memory.next_slow_s {
            self.memory.next_slow_s = next(self.memory.next_slow_s, SLOW_STEP_S, sample.time_s);
            self.slow(sink, time)?;
        }
        if sample.time_s + ROUNDING_S >= self.memory.next_flush_s {
            self.memory.next_flush_s = next(self.memory.next_flush_s, FLUSH_STEP_S, sample.time_s);
            sink.flush()?;
        }
        Ok(())
    }

    /// The bodies, at the first sample.
    fn geometry(
        &mut self,
        sink: &mut impl Sink,
        (sample, balls): SampleAndBalls,
        time: u64,
    ) -> Result<Scales, RecordError> {
        let ring_load_n = sample.inner.ball_force_n.map(|x| -x);
        let scales = Scales::of_first(balls, ring_load_n);
        self.memory.scales = Some(scales);
        let first = balls.first().map_or(0.0, |b| b.azimuth_rad - b.pocket.unwrap_or_default().lead_rad);
        let bodies = Bodies {
            geometry: &self.bearing.geometry,
            pocket_gap: Some(self.pocket_gap),
            first_azimuth: first - sample.cage.angle_rad,
            scales,
            ring_load_n,
            defects: &self.defects,
            with_coating: true,
        };
        let update = scene::geometry(&bodies, timestamp(time));
        self.send(sink, Topic::Geometry, time, &update)?;
        for line in std::mem::take(&mut self.warnings).iter().map(|warning| events::at_start(warning, time)) {
            self.send(sink, Topic::Log, time, &line)?;
        }
        // The channels are declared in this chunk: a small one is seldom hit by damage, and all others need it.
        sink.flush()?;
        Ok(scales)
    }

    /// Frames and contacts where enough has turned since the last ones.
    fn scene(
        &mut self,
        sink: &mut impl Sink,
        (s, balls): SampleAndBalls,
        scales: Scales,
        time: u64,
    ) -> Result<(), RecordError> {
        if self.memory.motion.frames_due(s) {
            let mut transforms = std::mem::take(&mut self.transforms);
            self.memory.motion.transforms((s, balls), time, &mut transforms);
            self.send(sink, Topic::Transforms, time, &transforms)?;
            self.transforms = transforms;
        }
        if self.memory.motion.contacts_due(s) {
            let mut update = std::mem::take(&mut self.contacts);
            let drawing = Drawing { geometry: &self.bearing.geometry, scales, defects: &self.defects };
            let moment = Moment {
                log_time: time,
                ring_load_n: s.inner.ball_force_n.map(|x| -x),
                cage_angle_rad: s.cage.angle_rad,
                ring_angles_rad: [s.inner.angle_rad, s.outer.angle_rad],
            };
            contacts::update(&mut update, &drawing, &moment, balls);
            update.entities.extend(self.memory.trail.entity(self.bearing.geometry.ball_diameter, timestamp(time)));
            self.send(sink, Topic::Contacts, time, &update)?;
            self.send(sink, Topic::Azimuth, time, &ball::around(timestamp(time), s.time_s, balls))?;
            self.contacts = update;
        }
        Ok(())
    }

    fn wear(&mut self, sink: &mut impl Sink, time: u64) -> Result<(), RecordError> {
        let wear = messages::wear(&self.memory.last_wear, self.memory.last_time_s, time);
        self.send(sink, Topic::Wear, time, &wear)
    }

    /// Wear, coating and orbit of the last sample, and spectra where new ones say more.
    fn slow(&mut self, sink: &mut impl Sink, time: u64) -> Result<(), RecordError> {
        self.wear(sink, time)?;
        let coating = self.memory.found.message(&self.bearing.geometry, timestamp(time));
        self.send(sink, Topic::Coating, time, &coating)?;
        let orbit = self.memory.last_turn.message(self.memory.last_time_s, time);
        self.send(sink, Topic::Orbit, time, &orbit)?;
        let (finer, time_s) = (self.memory.recent.spectrum_samples(), self.memory.last_time_s);
        let due = time_s + ROUNDING_S >= self.memory.last_spectra_s + SPECTRA_STEP_S;
        if due || finer > self.memory.spectra_samples { self.spectra(sink, time) } else { Ok(()) }
    }

    /// Spectra up to the last sample.
    fn spectra(&mut self, sink: &mut impl Sink, time: u64) -> Result<(), RecordError> {
        self.memory.last_spectra_s = self.memory.last_time_s;
        self.memory.spectra_samples = self.memory.recent.spectrum_samples();
        let topics = [Topic::SpectrumOuter, Topic::SpectrumInner, Topic::SpectrumCage];
        for (quantity, topic) in topics.into_iter().enumerate().take(QUANTITIES.len()) {
            if let Some(spectrum) = self.memory.recent.spectrum(quantity, self.bearing.geometry.ball_count, time)? {
                self.send(sink, topic, time, &spectrum)?;
            }
        }
        Ok(())
    }

    pub(super) fn event(&mut self, sink: &mut impl Sink, event: &Event) -> Result<(), RecordError> {
        if !event.time_s.is_finite() {
            return Err(RecordError::NotFinite { field: "time_s of an event".to_owned(), value: event.time_s });
        }
        self.log_due(sink, event.time_s)?;
        if let Some(line) = self.memory.pending.add(event) {
            self.send(sink, Topic::Log, log_time(event.time_s), &line)?;
        }
        Ok(())
    }

    /// Lines whose windows are over.
    fn log_due(&mut self, sink: &mut impl Sink, time_s: f64) -> Result<(), RecordError> {
        let lines: Vec<Log> = self.memory.pending.due(time_s).collect();
        // Not before the message that was last; the line has the time of its event.
        lines.iter().try_for_each(|line| self.send(sink, Topic::Log, self.memory.last_log_time, line))
    }

    pub(super) fn end(&mut self, sink: &mut impl Sink) -> Result<(), RecordError> {
        self.log_due(sink, f64::INFINITY)?;
        if self.memory.scales.is_none() {
            return Ok(());
        }
        let (last_s, time) = (self.memory.last_time_s, self.memory.last_log_time);
        if last_s > self.memory.next_slow_s - SLOW_STEP_S + ROUNDING_S {
            self.memory.next_slow_s = last_s + SLOW_STEP_S;
            self.slow(sink, time)?;
        }
        if last_s > self.memory.last_spectra_s { self.spectra(sink, time) } else { Ok(()) }
    }
}

/// The multiple of a step after a time.
fn next(due: f64, step: f64, time: f64) -> f64 {
    due + step * (((time + ROUNDING_S - due) / step).floor() + 1.0)
}
