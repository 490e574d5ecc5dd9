//! One random bearing tried: its equilibria by both models, and a short run.

use super::bearing::RandomBearing;
use crate::run::balance::{Judgement, judge};
use std::time::{Duration, Instant};
use tribodyn_bearing::Scheme;
use tribodyn_case::Case;
use tribodyn_dynamics::{DynamicsError, Ending, Event, EventKind, Observer, Run, RunError, Sample};
use tribodyn_quasistatic::{Model, QuasiStaticError, Solution, solve};

/// How a trial went.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// As it should.
    Good,
    /// Not to the end, or not well, and it says why.
    Explained(String),
    /// Wrong without a word, or without a reason.
    Failed(String),
}

/// A solution by one model.
#[derive(Debug, Clone, PartialEq)]
pub struct Solving {
    /// Which model.
    pub model: Model,
    /// How it went: explained where there is no solution and the error has a reason.
    pub verdict: Verdict,
    /// Wall time.
    pub wall: Duration,
}

/// A short run.
#[derive(Debug, Clone, PartialEq)]
pub struct Running {
    /// Name of the scheme.
    pub scheme: &'static str,
    /// How it went: explained where it was broken off with a reason, or warns that its work does not balance.
    pub verdict: Verdict,
    /// Work missing at the end over all work put in, %; none for a run that did not start or was broken off.
    pub imbalance_percent: Option<f64>,
    /// Wall time.
    pub wall: Duration,
}

/// Solves by both models.
pub fn solve_both(bearing: &RandomBearing) -> [Solving; 2] {
    [Model::JonesHarris, Model::Traction].map(|model| {
        let began = Instant::now();
        let verdict = match Case::from_ron(&bearing.text).map(|case| (case.bearing(), case.operating_point())) {
            Ok((Ok(made), point)) => of_solution(solve(&made, &point, model).map(|solved| solved.solution)),
            Ok((Err(error), _)) => Verdict::Failed(error.to_string()),
            Err(error) => Verdict::Failed(error.to_string()),
        };
        Solving { model, verdict, wall: began.elapsed() }
    })
}

fn of_solution(solved: Result<Solution, QuasiStaticError>) -> Verdict {
    match solved {
        Ok(solution) => match not_finite(&solution) {
            Some(what) => Verdict::Failed(format!("converged with {what} not finite")),
            None => Verdict::Good,
        },
        Err(error) => Verdict::Explained(error.to_string()),
    }
}

/// A number of a solution that is not finite: as JSON it is `null`.
fn not_finite(solution: &Solution) -> Option<String> {
    let value = serde_json::to_value(solution).ok()?;
    null_in(&value, "solution")
}

fn null_in(value: &serde_json::Value, name: &str) -> Option<String> {
    match value {
        // The one number that may be missing.
        serde_json::Value::Null if name.ends_with("patch_error_estimate") => None,
        serde_json::Value::Null => Some(name.to_owned()),
        serde_json::Value::Array(all) => all.iter().find_map(|value| null_in(value, name)),
        serde_json::Value::Object(all) => all.iter().find_map(|(name, value)| null_in(value, name)),
        _ => None,
    }
}

/// What a run hands out, as far as the trial looks at it.
#[derive(Default)]
struct Watcher {
    last: Option<Sample>,
    not_finite: Option<String>,
    warnings: Vec<String>,
    stop_at: Option<Instant>,
}

impl Observer for Watcher {
    type Error = std::convert::Infallible;

    fn sample(&mut self, sample: &Sample, _with_balls: bool) -> Result<std::ops::ControlFlow<()>, Self::Error> {
        let power = &sample.power;
        let numbers = [power.put_in(), power.lost(), power.energy_j, power.imbalance_j, sample.cage.speed_rad_s];
        if self.not_finite.is_none() && numbers.iter().any(|number| !number.is_finite()) {
            self.not_finite = Some(format!("a power or speed is not finite at {} s", sample.time_s));
        }
        self.last = Some(sample.clone());
        let late = self.stop_at.is_some_and(|stop| Instant::now() > stop);
        Ok(if late { std::ops::ControlFlow::Break(()) } else { std::ops::ControlFlow::Continue(()) })
    }

    fn event(&mut self, event: &Event) -> Result<(), Self::Error> {
        if let EventKind::Warning { message } = &event.kind {
            self.warnings.push(message.clone());
        }
        Ok(())
    }
}

/// Runs the case in memory, for at most `longest` of wall time.
pub fn run_short(bearing: &RandomBearing, longest: Duration) -> Running {
    let began = Instant::now();
    let ended =
        |scheme, verdict, imbalance_percent| Running { scheme, verdict, imbalance_percent, wall: began.elapsed() };
    let case = match Case::from_ron(&bearing.text) {
        Ok(case) => case,
        Err(error) => return ended("none", Verdict::Failed(error.to_string()), None),
    };
    let scheme = scheme_name(&case);
    let inputs = match case.run_inputs() {
        Ok(inputs) => inputs,
        Err(error) => return ended(scheme, Verdict::Failed(error.to_string()), None),
    };
    let mut run = match Run::new(inputs) {
        Ok(run) => run,
        Err(DynamicsError::Start(error)) => {
            return ended(scheme, Verdict::Explained(format!("no start: {error}")), None);
        }
        Err(error) => return ended(scheme, Verdict::Failed(error.to_string()), None),
    };
    let mut watcher = Watcher { stop_at: Some(began + longest), ..Watcher::default() };
    match run.advance(run.duration(), &mut watcher) {
        Ok(Ending::Complete) => {}
        Ok(Ending::Stopped) => return ended(scheme, Verdict::Explained("stopped by the clock".to_owned()), None),
        Err(RunError::Dynamics(error)) => return ended(scheme, Verdict::Explained(error.to_string()), None),
        Err(RunError::Observer(never)) => match never {},
    }
    if let Some(what) = watcher.not_finite {
        return ended(scheme, Verdict::Failed(what), None);
    }
    let Some(last) = watcher.last else { return ended(scheme, Verdict::Failed("no sample".to_owned()), None) };
    let percent = 100.0 * last.power.imbalance_j / last.power.throughput_j.max(f64::MIN_POSITIVE);
    let verdict = match judge(percent, &case) {
        Judgement::Balanced => Verdict::Good,
        Judgement::Off { reason, .. } => Verdict::Explained(reason),
    };
    ended(scheme, verdict, Some(percent))
}

fn scheme_name(case: &Case) -> &'static str {
    match case.transient.as_ref().map(|transient| transient.scheme) {
        Some(Scheme::RungeKutta4 { .. }) => "Runge–Kutta",
        Some(Scheme::DormandPrince { .. }) => "Dormand–Prince",
        Some(Scheme::Fast { .. }) => "fast",
        None => "none",
    }
}
