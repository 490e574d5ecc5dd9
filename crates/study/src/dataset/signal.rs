//! A member run through: what its sensors see, and when balls pass its spall.

use super::members::{Choice, OF_NOISE, delay};
use super::sensor::Sensor;
use crate::error::with_causes;
use crate::run::{RunReport, Tally, start_run, unresolved};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use tribodyn::CaseFile;
use tribodyn_case::DatasetPlan;
use tribodyn_dynamics::{BallDetail, Event, EventKind, Observer, RunError, Sample};
use tribodyn_record::{RecordError, RunItem, RunRows};
use tribodyn_wear::Random;

/// A passage of a ball over the spall, in the time of the signal, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passage {
    pub ball: usize,
    /// True at the inner race.
    pub inner: bool,
    pub entered: f64,
    pub struck: f64,
    pub left: f64,
}

/// Signals of a member, and facts of its run.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Signals {
    /// Samples of each sensor, m/s².
    pub sensors: Vec<Vec<f32>>,
    pub passages: Vec<Passage>,
    /// Mean speed of the cage over the signal, rad/s.
    pub cage_speed: f64,
    /// Largest difference of a ball's orbital speed from that of the cage, over it.
    pub slip: f64,
    /// Fixed step of the run, s; none where steps follow from the error.
    pub step: Option<f64>,
    /// Error of the outer ring's acceleration, rms, m/s²; none where the run is too short to tell.
    pub acceleration_error: Option<f64>,
    /// Warnings of the run.
    pub warnings: Vec<String>,
}

/// Runs a member; none where `stop` was set before its end.
///
/// # Errors
/// Why it has no signals.
pub(super) fn signals(
    plan: &DatasetPlan,
    choice: &Choice,
    (member, file): (usize, &CaseFile),
    stop: &AtomicBool,
) -> Result<Option<Signals>, String> {
    let began = Instant::now();
    let (mut run, _) = start_run(file).map_err(|error| error.to_string())?;
    let sensor = |(k, spec)| {
        let stream = OF_NOISE + (member * plan.sensors.len() + k) as u64;
        Sensor::new(spec, plan.rate, Random::new(plan.seed, stream))
    };
    let mut tally = Tally::new(&file.case);
    let mut taken = Taken {
        stop,
        rows: RunRows::new(file.case.geometry.ball_count, |item| tally.take(item)),
        // Filters of run and sensors hand out what was a while ago; half a sample of play for rounding.
        from: plan.settle + delay(plan) - 0.5 / plan.rate,
        samples: (plan.rate * plan.duration).round() as usize,
        sensors: plan.sensors.iter().enumerate().map(sensor).collect(),
        signals: Signals { sensors: vec![Vec::new(); plan.sensors.len()], ..Signals::default() },
        settle: plan.settle,
        seen: 0.0,
    };
    match run.advance(f64::INFINITY, &mut taken) {
        Ok(_) => {}
        Err(RunError::Dynamics(error)) => return Err(error.to_string()),
        Err(RunError::Observer(error)) => return Err(with_causes(&error)),
    }
    if stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let Taken { mut signals, seen, samples, rows, .. } = taken;
    rows.finish();
    if signals.sensors.iter().any(|values| values.len() < samples) {
        return Err("the run ended before its signal was whole".to_owned());
    }
    let (end, spalled) = (plan.duration, choice.individual.length.is_some());
    signals.passages.retain(|passage| spalled && passage.left > 0.0 && passage.entered < end);
    signals.cage_speed /= seen;
    if let Some(report) = RunReport::of_unrecorded(&run, file, &tally, began) {
        signals.step = report.known.step_s;
        signals.acceleration_error = report.outcome.acceleration_error_m_s2;
        signals.warnings = warnings(&report);
    }
    Ok(Some(signals))
}

/// Warnings of a run, with one where its accelerations are not known well enough to be shown by `run`.
fn warnings(report: &RunReport) -> Vec<String> {
    let mut all: Vec<String> = report.warnings().cloned().collect();
    let of = |summary| unresolved(summary, &report.known, Some(&report.outcome));
    all.extend(report.summary.as_ref().and_then(of));
    all
}

struct Taken<'a, T> {
    stop: &'a AtomicBool,
    /// Rows of the run, from which its warnings follow.
    rows: RunRows<T>,
    /// Time before the first sample of the signal, s, and how many there are.
    from: f64,
    samples: usize,
    settle: f64,
    sensors: Vec<Sensor>,
    signals: Signals,
    /// Samples of speeds.
    seen: f64,
}

impl<T: FnMut(RunItem)> Observer for Taken<'_, T> {
    type Error = RecordError;

    fn between(&self) -> BallDetail {
        self.rows.between()
    }

    fn sample(&mut self, sample: &Sample, with_balls: bool) -> Result<ControlFlow<()>, RecordError> {
        let acceleration = sample.outer.acceleration_m_s2;
        let acceleration = [acceleration[0], acceleration[1]];
        let within = sample.time_s > self.from;
        for (sensor, signal) in self.sensors.iter_mut().zip(&mut self.signals.sensors) {
            let value = sensor.push(acceleration);
            if within && signal.len() < self.samples {
                signal.push(value as f32);
            }
        }
        if sample.time_s >= self.settle {
            self.seen += 1.0;
            self.signals.cage_speed += sample.cage.speed_rad_s;
            let cage = sample.cage.speed_rad_s;
            let off = |speed: f64| if cage == 0.0 { 0.0 } else { ((speed - cage) / cage).abs() };
            let most = sample.balls.iter().map(|ball| off(ball.orbital_speed_rad_s));
            self.signals.slip = most.fold(self.signals.slip, f64::max);
        }
        self.rows.sample(sample, with_balls)
    }

    fn event(&mut self, event: &Event) -> Result<(), RecordError> {
        if let EventKind::SpallPassed { ball, inner, entered_s, struck_s, left_s, .. } = event.kind {
            let [entered, struck, left] = [entered_s, struck_s, left_s].map(|time| time - self.settle);
            self.signals.passages.push(Passage { ball, inner, entered, struck, left });
        }
        self.rows.event(event)
    }

    fn stepped(&mut self, _: f64) -> ControlFlow<()> {
        if self.stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
