//! Recording a transient run: an [`Observer`] that turns samples and events into messages for a [`Sink`].

mod check;
mod events;
mod frames;
mod history;
mod messages;
mod overview;
mod producer;
mod rows;
mod sink;
mod topics;

pub use overview::Overview;
pub use producer::RecorderMemory;
pub use rows::RunRows;
pub use sink::{FileSink, Preamble, Sink, StreamSink};
pub(crate) use topics::{CHANNELS, Topic};

use crate::layout::{Layout, LayoutKind};
use crate::output::{Entries, fnv1a};
use crate::timeline::EPOCH_NS;
use crate::{RecordError, contacts};
use producer::Producer;
use std::ops::ControlFlow;
use std::path::Path;
use tribodyn_bearing::{BallResult, Geometry};
use tribodyn_case::Case;
use tribodyn_dynamics::{BallDetail, Event, FilterBands, Observer, Sample};

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

/// What is low-pass filtered before it is sampled, for the metadata.
const FILTERED: &str =
    "inner_acceleration_* and outer_acceleration_* of /bearing/state, /bearing/spectrum and the topics below it";
/// What is not.
const POINT_SAMPLES: &str = "all other fields of /bearing/state, and /bearing/balls";

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
            layout: &Layout::of(LayoutKind::Run, input.case, &producer.geometry).json(),
            entries: &entries,
        })?;
        Ok(Self { sink, producer })
    }

    /// Where the messages go.
    pub fn sink(&self) -> &S {
        &self.sink
    }

    /// Where the messages go, for those that were recorded before.
    pub fn sink_mut(&mut self) -> &mut S {
        &mut self.sink
    }

    /// What a recorder must know to go on from here: with [`Self::remember`] another one sends the same bytes.
    pub fn memory(&self) -> &RecorderMemory {
        self.producer.memory()
    }

    /// Takes over what a recorder of the same case knew. The messages that it had sent are not sent again: they belong
    /// into the sink before the next sample.
    ///
    /// # Errors
    /// [`RecordError::BallCount`] for the memory of another bearing.
    pub fn remember(&mut self, memory: RecorderMemory) -> Result<(), RecordError> {
        self.producer.remember(memory)
    }

    /// Records a sample from what was kept of it, and its balls where they are to be recorded. The first sample of a
    /// run should have them: the picture is scaled by their loads.
    ///
    /// # Errors
    /// [`RecordError`] for a number that is not finite, another number of balls or a time before that of the last
    /// sample, and where the sink cannot take it.
    pub fn record(&mut self, overview: &Overview, balls: Option<&[BallResult]>) -> Result<(), RecordError> {
        self.producer.sample(&mut self.sink, overview, balls)
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
        let balls = with_balls.then_some(&sample.balls[..]);
        self.record(&Overview::of(sample), balls).map(ControlFlow::Continue)
    }

    fn between(&self) -> BallDetail {
        Overview::DETAIL
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
        ("free_contact_angle_deg", geometry.contact_angle().to_degrees().to_string()),
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
    if let Some(transient) = &case.transient {
        let bands = FilterBands::new(transient.scheme, case.rates().state_rate);
        entries.push(("filtered", FILTERED.to_owned()));
        entries.push(("point_samples", POINT_SAMPLES.to_owned()));
        entries.push(("filter", "linear-phase FIR, Kaiser window, then decimation".to_owned()));
        entries.push(("filter_pass_band_hz", bands.pass_band_hz().to_string()));
        entries.push(("filter_stop_band_hz", bands.stop_band_hz().to_string()));
        entries.push(("filter_delay_s", bands.delay_s().to_string()));
        entries.push(("filter_internal_rate_hz", bands.internal_rate_hz().to_string()));
    }
    entries
}
