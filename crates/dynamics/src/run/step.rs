//! One step of any scheme, cut where a ball meets or leaves its pocket wall.

use super::{CUT_MARGIN, Run, RunError, SHORTEST_STEP, Scheme};
use crate::error::DynamicsError;
use crate::forces::System;
use crate::layout::{BALL, ORBIT};
use crate::observer::Observer;
use fearless_simd::{Level, dispatch};
use std::ops::ControlFlow;

impl Run {
    /// One step of the scheme, in pieces where a pocket is met.
    pub(super) fn one_step<O: Observer>(
        &mut self,
        end: f64,
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        let target = match &self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => (step * (self.progress.steps + 1) as f64).min(end),
            Scheme::DormandPrince { .. } => end,
        };
        loop {
            let t = self.progress.time;
            let h = self.try_step(target)?;
            let explicit = !matches!(self.scheme, Scheme::Fast { .. });
            let h = match explicit.then(|| self.pocket_event(h)).flatten() {
                Some(cut) => {
                    self.progress.statistics.cut_at_pocket += 1;
                    self.exact_step(cut * h)?;
                    cut * h
                }
                None => h,
            };
            let adaptive = matches!(self.scheme, Scheme::DormandPrince { .. });
            let reached = t + h >= target * (1.0 - 1e-15);
            if !reached && t + h <= t {
                return Err(DynamicsError::NoProgress { time_s: t, step_s: h }.into());
            }
            let done = reached || adaptive;
            self.progress.steps += u64::from(done);
            let flow = self.accept(if reached { target } else { t + h }, observer)?;
            if flow.is_break() || done {
                return Ok(flow);
            }
        }
    }

    /// Steps towards `target`, to `self.next`; returns the length of the step.
    pub(super) fn try_step<E>(&mut self, target: f64) -> Result<f64, RunError<E>> {
        let t = self.progress.time;
        let Scheme::DormandPrince { tolerance, longest, .. } = self.scheme else {
            self.exact_step(target - t)?;
            return Ok(target - t);
        };
        loop {
            let h = self.progress.control.step.min(target - t);
            let error = self.exact_step(h)?;
            if self.progress.control.judge(error, h, longest) {
                return Ok(h);
            }
            self.progress.statistics.rejected += 1;
            if self.progress.control.step < SHORTEST_STEP {
                let step_s = SHORTEST_STEP;
                return Err(DynamicsError::StepTooSmall { time_s: t, step_s, tolerance }.into());
            }
        }
    }

    /// A step of just this length; returns the error over the tolerance, 0 for the scheme that has none.
    pub(super) fn exact_step<E>(&mut self, h: f64) -> Result<f64, RunError<E>> {
        let p = &self.progress;
        let start = (p.state.as_slice(), p.derivative.as_slice());
        let error = match &mut self.scheme {
            Scheme::Rk4 { method, .. } => {
                method.step(&mut self.machine, p.time, start, h, &mut self.next);
                self.machine.derivative(p.time + h, &self.next, &mut self.next_derivative);
                self.progress.statistics.evaluations += 4;
                0.0
            }
            Scheme::Fast { .. } => {
                self.next.copy_from_slice(&p.state);
                let time = p.time;
                self.progress.fast.step(&mut self.machine, time, &mut self.next, h);
                self.progress.statistics.evaluations += 1;
                0.0
            }
            Scheme::DormandPrince { method, tolerance, .. } => {
                let error = method.step(&mut self.machine, p.time, start, h, &self.scale, &mut self.next);
                self.next_derivative.copy_from_slice(method.last_derivative());
                self.progress.statistics.evaluations += 6;
                return Ok(error / *tolerance);
            }
        };
        if are_finite(self.filter.level(), &self.next) {
            return Ok(error);
        }
        match self.next.iter().position(|v| !v.is_finite()) {
            None => Ok(error),
            Some(at) => Err(self.not_finite(at).into()),
        }
    }

    pub(super) fn not_finite(&self, at: usize) -> DynamicsError {
        let l = self.machine.layout;
        let what = if at < l.cage() {
            format!("the motion of ball {}", at / BALL)
        } else if at < l.inner() {
            "the motion of the cage".to_owned()
        } else if at < l.angles() {
            "the motion of the rings".to_owned()
        } else {
            "the work done".to_owned()
        };
        DynamicsError::NotFinite { what, time_s: self.progress.time, blame: self.blame() }
    }

    /// The part of the step after which the first ball meets or leaves its pocket wall.
    pub(super) fn pocket_event(&self, h: f64) -> Option<f64> {
        let l = self.machine.layout;
        let pocket = &self.machine.cage.pocket;
        if pocket.stiffness == 0.0 {
            return None;
        }
        let p = &self.progress;
        let lead = |y: &[f64], k: usize| self.machine.lead(k, &y[l.ball(k)..], y[l.cage()]);
        let rate = |y: &[f64], k: usize| y[l.ball(k) + ORBIT] - y[l.cage() + 1];
        let mut first: Option<f64> = None;
        for k in 0..l.balls {
            let (a, b) = (lead(&p.state, k), lead(&self.next, k));
            let (before, after) = (pocket.penetration(a), pocket.penetration(b));
            if (before > 0.0) == (after > 0.0) {
                continue;
            }
            let slopes = [rate(&p.state, k) * h, rate(&self.next, k) * h];
            let gap = |s: f64| pocket.penetration(hermite(s, [a, b], slopes));
            let at = bisect(gap, before > 0.0);
            if at > CUT_MARGIN && at < 1.0 - CUT_MARGIN && first.is_none_or(|f| at < f) {
                first = Some(at);
            }
        }
        first
    }
}

/// Cubic through two values with their slopes over the interval, at `s` from 0 to 1.
pub(super) fn hermite(s: f64, [a, b]: [f64; 2], [da, db]: [f64; 2]) -> f64 {
    let r = 1.0 - s;
    // Differences from a keep the digits of large values.
    a + (b - a) * s * s * (3.0 - 2.0 * s) + s * r * (da * r - db * s)
}

/// Where a function that is positive (or not) at 0 changes its sign in (0, 1).
pub(super) fn bisect(f: impl Fn(f64) -> f64, positive_at_0: bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == positive_at_0 { low = middle } else { high = middle }
    }
    high
}

/// True if no number is infinite or not a number at all: only those are not zero times zero. Sums side by side take a
/// tenth of the time of a search.
fn are_finite(level: Level, values: &[f64]) -> bool {
    let (whole, rest) = values.as_chunks::<16>();
    let mut sums = [0.0; 16];
    dispatch!(level, _simd => whole.iter().for_each(|values| {
        for k in 0..16 {
            sums[k] += 0.0 * values[k];
        }
    }));
    sums.iter().sum::<f64>() + rest.iter().map(|value| 0.0 * value).sum::<f64>() == 0.0
}
