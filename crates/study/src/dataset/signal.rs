//! A member run through: what its sensors see, and when balls pass its spall.

use super::members::{Choice, OF_NOISE, delay};
use super::sensor::Sensor;
use crate::run::start_run;
use std::convert::Infallible;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use tribodyn::CaseFile;
use tribodyn_case::DatasetPlan;
use tribodyn_dynamics::{BallDetail, Event, EventKind, Observer, RunError, Sample};
use tribodyn_wear::Random;

/// A passage of a ball over the spall, in the time of the signal, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passage {
    pub ball: usize,
    pub entered: f64,
    pub struck: f64,
    pub left: f64,
}

/// What a member gives.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Signals {
    /// Samples of each sensor, m/s².
    pub sensors: Vec<Vec<f32>>,
    pub passages: Vec<Passage>,
    /// Mean speed of the cage over the signal, rad/s.
    pub cage_speed: f64,
    /// Largest difference of a ball's orbital speed from that of the cage, over it.
    pub slip: f64,
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
    let (mut run, _) = start_run(file).map_err(|error| error.to_string())?;
    let sensor = |(k, spec)| {
        let stream = OF_NOISE + (member * plan.sensors.len() + k) as u64;
        Sensor::new(spec, plan.rate, Random::new(plan.seed, stream))
    };
    let mut taken = Taken {
        stop,
        // The filter of a run hands out what was a while ago.
        from: plan.settle + delay(plan),
        samples: (plan.rate * plan.duration).round() as usize,
        delay: delay(plan),
        sensors: plan.sensors.iter().enumerate().map(sensor).collect(),
        signals: Signals { sensors: vec![Vec::new(); plan.sensors.len()], ..Signals::default() },
        settle: plan.settle,
        seen: 0.0,
    };
    match run.advance(f64::INFINITY, &mut taken) {
        Ok(_) => {}
        Err(RunError::Dynamics(error)) => return Err(error.to_string()),
        Err(RunError::Observer(never)) => match never {},
    }
    if stop.load(Ordering::Relaxed) {
        return Ok(None);
    }
    let (mut signals, seen) = (taken.signals, taken.seen);
    if signals.sensors.iter().any(|samples| samples.len() < taken.samples) {
        return Err("the run ended before its signal was whole".to_owned());
    }
    let (end, spalled) = (plan.duration, choice.individual.length.is_some());
    signals.passages.retain(|passage| spalled && passage.left > 0.0 && passage.entered < end);
    signals.cage_speed /= seen;
    Ok(Some(signals))
}

struct Taken<'a> {
    stop: &'a AtomicBool,
    /// Time of the first sample of the signal, s, and how many there are.
    from: f64,
    samples: usize,
    delay: f64,
    settle: f64,
    sensors: Vec<Sensor>,
    signals: Signals,
    /// Samples of speeds.
    seen: f64,
}

impl Observer for Taken<'_> {
    type Error = Infallible;

    fn between(&self) -> BallDetail {
        BallDetail::Loads
    }

    fn sample(&mut self, sample: &Sample, _: bool) -> Result<ControlFlow<()>, Infallible> {
        let acceleration = sample.outer.acceleration_m_s2;
        let acceleration = [acceleration[0], acceleration[1]];
        // Half a sample of play for rounding.
        let within = sample.time_s > self.from - 0.5 * self.delay / tribodyn_signal::Decimator::DELAY as f64;
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
        Ok(ControlFlow::Continue(()))
    }

    fn event(&mut self, event: &Event) -> Result<(), Infallible> {
        if let EventKind::SpallPassed { ball, entered_s, struck_s, left_s, .. } = event.kind {
            let [entered, struck, left] = [entered_s, struck_s, left_s].map(|time| time - self.settle);
            self.signals.passages.push(Passage { ball, entered, struck, left });
        }
        Ok(())
    }

    fn stepped(&mut self, _: f64) -> ControlFlow<()> {
        if self.stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
