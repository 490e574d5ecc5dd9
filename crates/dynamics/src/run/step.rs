//! One step of any scheme, cut where a ball meets or leaves its pocket wall.

use super::{CUT_MARGIN, Run, RunError, SHORTEST_STEP, Scheme, StepChoice};
use crate::error::DynamicsError;
use crate::forces::System;
use crate::layout::{BALL, ORBIT};
use crate::observer::Observer;
use fearless_simd::{Level, dispatch};
use std::ops::ControlFlow;
use tribodyn_numerics::{bisect, hermite};

/// Refuses a step that never comes to an end.
pub(super) fn refuse_no_end(scheme: tribodyn_bearing::Scheme) -> Result<(), DynamicsError> {
    use tribodyn_bearing::Scheme::{DormandPrince, Fast, FastTo, RungeKutta4};
    let step_s = match scheme {
        RungeKutta4 { step } | Fast { step } => step,
        DormandPrince { longest, .. } => longest,
        FastTo { accuracy } => accuracy,
    };
    if step_s.is_nan() || step_s < SHORTEST_STEP {
        return Err(DynamicsError::NoProgress { time_s: 0.0, step_s });
    }
    Ok(())
}

impl Run {
    /// The fixed step that is taken, s: that of the fast scheme divides the time between samples. None where steps
    /// follow from the error.
    pub fn step_s(&self) -> Option<f64> {
        match self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => Some(step),
            Scheme::DormandPrince { .. } => None,
        }
    }

    /// The scheme of the run; where an accuracy was asked for, with the step that was chosen.
    pub fn scheme(&self) -> tribodyn_bearing::Scheme {
        self.scheme.named()
    }

    /// How the step was chosen, where an accuracy was asked for.
    pub fn step_choice(&self) -> Option<StepChoice> {
        self.choice
    }

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
                method.step(self.machine.rates(), p.time, start, h, &mut self.next);
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
                let error = method.step(self.machine.rates(), p.time, start, h, &self.scale, &mut self.next);
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
        if self.machine.free_cage.is_some() {
            return self.free_pocket_event(h);
        }
        let p = &self.progress;
        let lead = |y: &[f64], k: usize| self.machine.lead(k, &y[l.ball(k)..], y[l.cage()]);
        let rate = |y: &[f64], k: usize| y[l.ball(k) + ORBIT] - y[l.cage() + 1];
        let whole = self.scheme.whole_step(h);
        let crossings = (0..l.balls).filter_map(|k| {
            let leads = [lead(&p.state, k), lead(&self.next, k)];
            let slopes = [rate(&p.state, k) * h, rate(&self.next, k) * h];
            crossing(|lead| pocket.penetration(lead), leads, slopes, whole / h)
        });
        crossings.min_by(f64::total_cmp)
    }

    /// The same in a cage that is free to move.
    fn free_pocket_event(&self, h: f64) -> Option<f64> {
        let (p, machine, whole) = (&self.progress, &self.machine, self.scheme.whole_step(h));
        let states = [&p.state, &self.next];
        let cages = states.map(|y| machine.cage_at(y));
        let crossings = (0..machine.layout.balls).filter_map(|k| {
            let ends: [_; 2] = std::array::from_fn(|end| {
                let (cage, pose) = &cages[end];
                machine.pocket_depth(k, machine.unknowns(k, states[end]), (*cage, pose.as_ref()))
            });
            crossing(|depth| depth, ends.map(|end| end[0]), ends.map(|end| end[1] * h), whole / h)
        });
        crossings.min_by(f64::total_cmp)
    }
}

impl Scheme {
    /// As a case has it.
    pub(super) fn named(&self) -> tribodyn_bearing::Scheme {
        match *self {
            Self::Rk4 { step, .. } => tribodyn_bearing::Scheme::RungeKutta4 { step },
            Self::Fast { step } => tribodyn_bearing::Scheme::Fast { step },
            Self::DormandPrince { tolerance, longest, .. } => {
                tribodyn_bearing::Scheme::DormandPrince { tolerance, longest }
            }
        }
    }

    /// The step of a scheme that has one of its own, else the one that was tried.
    fn whole_step(&self, tried: f64) -> f64 {
        match self {
            Self::Rk4 { step, .. } | Self::Fast { step } => *step,
            Self::DormandPrince { .. } => tried,
        }
    }
}

/// The part of a piece of a step after which a ball meets or leaves the wall; none where that is so near to an end that
/// the scheme's whole step, so many pieces long, does not see it. `depth` in the wall follows from the ball's lead, of
/// which there are two values with their changes over the piece at its rates. The last piece of a step can be so short
/// that a cut in it moves no digit of the lead, and another one would follow.
fn crossing(depth: impl Fn(f64) -> f64, leads: [f64; 2], slopes: [f64; 2], whole: f64) -> Option<f64> {
    let [before, after] = leads.map(|lead| depth(lead) > 0.0);
    if before == after {
        return None;
    }
    let at = bisect(|s| depth(hermite(s, leads, slopes)), before);
    let margin = CUT_MARGIN * whole.max(1.0);
    (at > margin && at < 1.0 - margin).then_some(at)
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

#[cfg(test)]
mod tests {
    use super::*;
    use tribodyn_bearing::{Pocket, PocketForce};

    fn pocket() -> Pocket {
        Pocket {
            radius: 0.0785,
            clearance: 4e-3,
            stiffness: 4e6,
            damping: 1.0,
            friction: 0.2,
            ball_radius: 0.015,
            force: PocketForce::FromWall,
            film: None,
        }
    }

    fn depth(lead: f64) -> f64 {
        pocket().penetration(lead)
    }

    #[test]
    fn identity_a_crossing_stands_where_the_lead_passes_the_wall() {
        let rate = 1e-4;
        for (leads, at) in [([3.975e-3, 4.075e-3], 0.25), ([-4.06e-3, -3.96e-3], 0.6)] {
            let found = crossing(depth, leads, [rate; 2], 1.0).unwrap();
            assert!((found - at).abs() < 1e-9, "{found}");
        }
        assert_eq!(crossing(depth, [3.9e-3, 3.95e-3], [5e-5; 2], 1.0), None);
    }

    /// A piece of 4.3 ns of a step of 10 µs, in which a ball leaves its wall by one unit in the last place: cuts of 8
    /// fs would not move it and go on for half a million pieces.
    #[test]
    fn limit_a_piece_too_short_to_be_cut_is_gone_through() {
        let (piece, whole, rate) = (4.3e-9, 1e-5, -0.124);
        let lead = 4e-3 + 1e-15;
        let (leads, slopes) = ([lead, lead + rate * piece], [rate * piece; 2]);
        let at = crossing(depth, leads, slopes, 1.0).unwrap();
        assert!(at > CUT_MARGIN && lead + at * rate * piece >= 4e-3 - 1e-18, "{at}");
        assert_eq!(crossing(depth, leads, slopes, whole / piece), None);
    }
}
