//! Values kept of a run.

use crate::mean::mean;
use std::ops::ControlFlow;
use tribodyn_bearing::BallResult;
use tribodyn_case::Case;
use tribodyn_dynamics::{Event, EventKind, Observer, Sample};
use tribodyn_record::{FileSink, RecordError, RunRecorder};

/// Values kept of every sample, SI.
#[derive(Debug, Clone, Copy)]
pub struct StateSample {
    pub time_s: f64,
    pub inner_acceleration: [f64; 3],
    pub outer_acceleration: [f64; 3],
    pub cage_speed: f64,
    /// Mean orbital speed of the balls, rad/s.
    pub mean_orbit: f64,
    /// Orbital speed of ball 0, rad/s.
    pub orbit: f64,
    /// Largest pocket force of any ball, N.
    pub pocket_peak: f64,
}

/// A ball that met its pocket.
#[derive(Debug, Clone, Copy)]
pub struct Impact {
    pub time_s: f64,
    pub ball: usize,
    pub azimuth_deg: f64,
}

/// Samples and events of a run.
#[derive(Debug)]
pub struct Trace {
    /// Samples of `states`, Hz.
    pub rate_hz: f64,
    pub states: Vec<StateSample>,
    /// Time and all balls, at the ball rate.
    pub balls: Vec<(f64, Vec<BallResult>)>,
    pub impacts: Vec<Impact>,
    pub warnings: Vec<String>,
    /// Imbalance of work over the work put in, at the end.
    pub imbalance: f64,
}

impl Trace {
    pub fn new(case: &Case) -> Self {
        Self {
            rate_hz: case.rates().state_rate,
            states: Vec::new(),
            balls: Vec::new(),
            impacts: Vec::new(),
            warnings: Vec::new(),
            imbalance: f64::NAN,
        }
    }

    fn take(&mut self, sample: &Sample, with_balls: bool) {
        let first = sample.balls.first().copied().unwrap_or_default();
        self.states.push(StateSample {
            time_s: sample.time_s,
            inner_acceleration: sample.inner.acceleration_m_s2,
            outer_acceleration: sample.outer.acceleration_m_s2,
            cage_speed: sample.cage.speed_rad_s,
            mean_orbit: mean(sample.balls.iter().map(|b| b.orbital_speed_rad_s)),
            orbit: first.orbital_speed_rad_s,
            pocket_peak: sample.balls.iter().fold(0.0, |most, b| b.pocket.unwrap_or_default().force_n.abs().max(most)),
        });
        if with_balls {
            self.balls.push((sample.time_s, sample.balls.clone()));
        }
        self.imbalance = sample.power.imbalance_j / sample.power.throughput_j;
    }

    fn note(&mut self, event: &Event) {
        match &event.kind {
            EventKind::Impact { ball, azimuth_deg, .. } => {
                self.impacts.push(Impact { time_s: event.time_s, ball: *ball, azimuth_deg: *azimuth_deg });
            }
            EventKind::Warning { message } => self.warnings.push(message.clone()),
            EventKind::ContactLost { .. } | EventKind::ContactMade { .. } | EventKind::CoatingThrough { .. } => {}
            EventKind::SpallPassed { .. } => {}
        }
    }
}

/// Fills a trace and a recording.
pub struct Observing {
    pub trace: Trace,
    pub recorder: Option<RunRecorder<FileSink>>,
}

impl Observer for Observing {
    type Error = RecordError;

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        self.trace.take(sample, with_balls);
        match &mut self.recorder {
            Some(recorder) => recorder.sample(sample, with_balls),
            None => Ok(ControlFlow::Continue(())),
        }
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        self.trace.note(event);
        self.recorder.as_mut().map_or(Ok(()), |recorder| recorder.event(event))
    }
}
