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

pub(crate) use events::START;
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
use tribodyn_bearing::{BallResult, RunInputs, Scheme};
use tribodyn_dynamics::{BallDetail, Event, FilterBands, Observer, Sample};

/// Inputs of a recording of a run.
#[derive(Debug, Clone, Copy)]
pub struct RunRecording<'a> {
    /// The text of the case file, attached unchanged.
    pub case_text: &'a str,
    /// Name of the bearing, the title of the recording.
    pub name: &'a str,
    /// Inputs of the run: the bearing of the picture and the metadata is the mounted one.
    pub inputs: &'a RunInputs,
    /// How it steps: [`tribodyn_dynamics::Run::scheme`], with the step that was chosen.
    pub scheme: Scheme,
    /// Other facts known before the first step, for the metadata.
    pub facts: &'a [(&'static str, String)],
    /// Warnings of the state that the run starts from, for the log.
    pub warnings: &'a [String],
    /// Program and version, such as `tribodyn 0.1.0`: the file says who wrote it.
    pub generator: &'a str,
}

impl<'a> RunRecording<'a> {
    /// Of a run that steps as its inputs say, with nothing else known.
    pub fn new(case_text: &'a str, name: &'a str, inputs: &'a RunInputs, generator: &'a str) -> Self {
        Self { case_text, name, inputs, scheme: inputs.options.scheme, facts: &[], warnings: &[], generator }
    }
}

/// Fields that are low-pass filtered before they are sampled, for the metadata.
const FILTERED: &str =
    "inner_acceleration_* and outer_acceleration_* of /bearing/state, /bearing/spectrum and the topics below it";
/// Fields that are not filtered.
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
    /// [`RecordError`] if the file cannot be created.
    pub fn create(path: &Path, input: &RunRecording) -> Result<Self, RecordError> {
        Self::new(FileSink::create(path)?, input)
    }
}

impl<S: Sink> RunRecorder<S> {
    /// Starts a recording into any sink.
    ///
    /// # Errors
    /// [`RecordError`] if the sink cannot begin.
    pub fn new(mut sink: S, input: &RunRecording) -> Result<Self, RecordError> {
        let RunInputs { bearing, speeds, .. } = input.inputs;
        sink.begin(&Preamble {
            channels: &CHANNELS,
            generator: input.generator,
            case_text: input.case_text,
            layout: &Layout::new(LayoutKind::Run, input.name, &bearing.geometry, speeds).json(),
            entries: &entries(input),
        })?;
        Ok(Self { sink, producer: Producer::new(input) })
    }

    /// Where the messages go.
    pub fn sink(&self) -> &S {
        &self.sink
    }

    /// Where the messages go, for those that were recorded before.
    pub fn sink_mut(&mut self) -> &mut S {
        &mut self.sink
    }

    /// State that a recorder needs to go on from here: with [`Self::remember`] another one sends the same bytes.
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

    /// Records a sample from what was kept of it, and its balls where they are to be recorded, into which it puts their
    /// films. The first sample of a run should have them: the picture is scaled by their loads.
    ///
    /// # Errors
    /// [`RecordError`] for a number that is not finite, another number of balls or a time before that of the last
    /// sample, and where the sink cannot take it.
    pub fn record(&mut self, overview: &Overview, balls: Option<&mut [BallResult]>) -> Result<(), RecordError> {
        self.producer.sample(&mut self.sink, overview, balls)
    }

    /// Adds what is known only at the end of a run, before [`Self::finish`]: a metadata record of its own, `outcome`.
    ///
    /// # Errors
    /// [`RecordError`] if it cannot be stored.
    pub fn conclude(&mut self, entries: &[(&'static str, String)]) -> Result<(), RecordError> {
        self.producer.end(&mut self.sink)?;
        self.sink.outcome(entries)
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
        let mut balls = with_balls.then(|| sample.balls.clone());
        self.record(&Overview::of(sample), balls.as_deref_mut()).map(ControlFlow::Continue)
    }

    fn between(&self) -> BallDetail {
        Overview::DETAIL
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        self.producer.event(&mut self.sink, event)
    }
}

fn entries(input: &RunRecording) -> Entries {
    let (geometry, options) = (&input.inputs.bearing.geometry, &input.inputs.options);
    let bands = FilterBands::new(input.scheme, options.state_rate);
    let mut entries = vec![
        ("kind", "transient run".to_owned()),
        ("bearing", input.name.to_owned()),
        ("ball_count", geometry.ball_count.to_string()),
        ("ball_diameter_mm", (geometry.ball_diameter * 1e3).to_string()),
        ("pitch_diameter_mm", (geometry.pitch_diameter * 1e3).to_string()),
        ("inner_groove_coefficient", geometry.inner_coefficient.to_string()),
        ("outer_groove_coefficient", geometry.outer_coefficient.to_string()),
        ("free_contact_angle_deg", geometry.contact_angle().to_degrees().to_string()),
        ("patch_exaggeration", contacts::PATCH_EXAGGERATION.to_string()),
        // The same case always gives the same run.
        ("seed", "none".to_owned()),
        ("generator", input.generator.to_owned()),
        ("case_fnv1a64", format!("{:016x}", fnv1a(input.case_text.as_bytes()))),
        ("duration_s", options.duration.to_string()),
        ("start", format!("{:?}", options.start)),
        ("scheme", format!("{:?}", input.scheme)),
        ("contact_damping", options.contact_damping.to_string()),
        ("wear_acceleration", options.wear_acceleration.to_string()),
        ("state_rate_hz", options.state_rate.to_string()),
        ("ball_rate_hz", options.ball_rate.to_string()),
        ("filtered", FILTERED.to_owned()),
        ("point_samples", POINT_SAMPLES.to_owned()),
        ("filter", "linear-phase FIR, Kaiser window, then decimation".to_owned()),
        ("filter_pass_band_hz", bands.pass_band_hz().to_string()),
        ("filter_stop_band_hz", bands.stop_band_hz().to_string()),
        ("filter_delay_s", bands.delay_s().to_string()),
        ("filter_internal_rate_hz", bands.internal_rate_hz().to_string()),
    ];
    entries.extend(input.facts.iter().cloned());
    entries
}
