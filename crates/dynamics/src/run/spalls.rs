//! Balls that pass spalls: when they are over the first edge, against the second one, and over it.

use super::{Run, RunError, Scheme};
use crate::equations::Frame;
use crate::layout::{AZIMUTH, BALL};
use crate::machine::Machine;
use crate::observer::{Event, EventKind, Observer};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::{AzimuthFrame, Side};

/// Steps in which a ball is to cross half the length of its contact, so that the blow on the second edge is resolved.
const STEPS_OF_CONTACT: f64 = 4.0;

/// A ball over a spall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct OverSpall {
    ball: usize,
    side: Side,
    /// True for a spall of the ball.
    #[serde(default)]
    of_ball: bool,
    spall: usize,
    /// Time at which it was over the first edge, s.
    entered: f64,
    /// Time at which it was over the middle, s.
    struck: Option<f64>,
}

impl OverSpall {
    fn spalls_of(&self, machine: &Machine) -> usize {
        if self.of_ball { machine.ball_surfaces.spalls().len() } else { machine.spalls[self.side].len() }
    }

    /// True if the machine has such a ball and spall, and times are times.
    pub(super) fn is_of(&self, machine: &Machine) -> bool {
        let there = self.ball < machine.layout.balls && self.spall < self.spalls_of(machine);
        there && self.entered.is_finite() && self.struck.is_none_or(f64::is_finite)
    }
}

impl Run {
    /// Passages of balls over spalls in the step to `t`, in the order in which they end.
    pub(super) fn spall_events<O: Observer>(&mut self, t: f64, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let spalls = &self.machine.spalls;
        if spalls.inner.is_empty() && spalls.outer.is_empty() && self.machine.ball_surfaces.spalls().is_empty() {
            return Ok(());
        }
        let from = self.progress.time;
        let frames = [self.machine.frame(from, &self.progress.state), self.machine.frame(t, &self.next)];
        let (l, mut events) = (self.machine.layout, Vec::new());
        for ball in 0..l.balls {
            let unknowns = [&self.progress.state, &self.next].map(|y| &y[l.ball(ball)..][..BALL]);
            for side in Side::BOTH.into_iter().filter(|side| !spalls[*side].is_empty()) {
                let place = |k: usize| {
                    let b: &[f64] = unknowns[k];
                    Machine::on_ring(side, AzimuthFrame::at(b[AZIMUTH]), b, &frames[k])
                };
                let places = [place(0), place(1)];
                for (spall, path) in spalls[side].iter().enumerate() {
                    let away = places.map(|place| wrapped(place - path.azimuth()));
                    let passing = OverSpall { ball, side, of_ball: false, spall, entered: 0.0, struck: None };
                    let at = |share: f64| from + share * (t - from);
                    events.extend(pass(&mut self.progress.over_spalls, passing, (away, path.half_angle()), at));
                }
            }
        }
        self.spalls_of_balls_passed(&frames, (from, t), &mut events);
        events.sort_by(|a: &Event, b: &Event| a.time_s.total_cmp(&b.time_s));
        events.iter().try_for_each(|event| observer.event(event)).map_err(RunError::Observer)
    }

    /// The same of spalls of balls, where the contacts do not run beside them.
    fn spalls_of_balls_passed(&mut self, frames: &[Frame; 2], (from, to): (f64, f64), events: &mut Vec<Event>) {
        let surfaces = &self.machine.ball_surfaces;
        for (number, spall) in surfaces.spalls().iter().enumerate() {
            for (side, path) in spall.paths.iter().filter(|(_, path)| !path.is_flat()) {
                // How far the ring is out of its middle counts for forces, not for these times.
                let places = frames.each_ref().map(|frame| surfaces.place(spall, side, (&frame.orientations, 0.0)));
                if places.iter().any(|place| place.across.abs() > path.reach_across()) {
                    continue;
                }
                let passing =
                    OverSpall { ball: spall.ball, side, of_ball: true, spall: number, entered: 0.0, struck: None };
                let away = places.map(|place| place.angle);
                let at = |share: f64| from + share * (to - from);
                events.extend(pass(&mut self.progress.over_spalls, passing, (away, path.half_angle()), at));
            }
        }
    }

    /// Says at the start that steps are too long for the blow at the end of a spall.
    pub(super) fn warn_if_stepping_over_spalls<O: Observer>(
        &mut self,
        observer: &mut O,
    ) -> Result<(), RunError<O::Error>> {
        let Some(limit) = self.machine.longest_step_over_spalls(self.duration) else { return Ok(()) };
        // Trials of a chosen step went over the spalls.
        if self.choice.is_some_and(|choice| !choice.scatters) {
            return Ok(());
        }
        let step = match self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => step,
            Scheme::DormandPrince { longest, .. } => longest,
        };
        if step <= limit {
            return Ok(());
        }
        let message = format!(
            "a ball crosses half of its contact's length in {:.2e} s: steps of {step:.2e} s do not resolve how it \
             meets the edge of a spall; {limit:.1e} s do",
            STEPS_OF_CONTACT * limit
        );
        let kind = EventKind::Warning { message };
        observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)
    }
}

impl Machine {
    /// Longest step that resolves the edges of the spalls, s; none without spalls or where nothing turns.
    pub(super) fn longest_step_over_spalls(&self, duration: f64) -> Option<f64> {
        let apart = |time: f64| (self.speeds.inner.at(time) - self.speeds.outer.at(time)).abs();
        let speed = [0.0, duration].map(apart).into_iter().fold(0.0, f64::max);
        let limits = self.spalls.iter().flat_map(|(_, paths)| paths.iter()).map(|path| path.contact_angle());
        // Balls turn past a contact as fast as they roll.
        let of_balls = self.ball_surfaces.spalls().iter().flat_map(|spall| spall.paths.iter()).map(|(side, path)| {
            path.contact_angle() * self.bearing.geometry.ball_radius() / self.bearing.track_radius(side)
        });
        let contact = limits.chain(of_balls).fold(f64::INFINITY, f64::min);
        // Balls pass a race at about half the speed of the rings against each other.
        let time = contact / (0.5 * speed) / STEPS_OF_CONTACT;
        time.is_finite().then_some(time)
    }
}

/// Angle between −π and π, rad.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// Follows a ball that goes from one distance to another (rad) from the middle of a spall; `at` has the time of a share
/// of the step.
fn pass(
    over: &mut Vec<OverSpall>,
    passing: OverSpall,
    ([a, b], half): ([f64; 2], f64),
    at: impl Fn(f64) -> f64,
) -> Option<Event> {
    // On the far side of the ring the distance jumps by a turn.
    if a == b || (b - a).abs() > 0.5 * TAU {
        return None;
    }
    let when = |place: f64| at(((place - a) / (b - a)).clamp(0.0, 1.0));
    let key = |o: &OverSpall| (o.ball, o.side, o.of_ball, o.spall);
    let is_this = |o: &OverSpall| key(o) == key(&passing);
    let ahead = (b - a).signum();
    let crosses = |place: f64| (a - place) * ahead < 0.0 && (b - place) * ahead >= 0.0;
    if crosses(-half * ahead) {
        over.retain(|o| !is_this(o));
        over.push(OverSpall { entered: when(-half * ahead), ..passing });
    }
    let current = over.iter_mut().find(|o| is_this(o))?;
    if crosses(0.0) && current.struck.is_none() {
        current.struck = Some(when(0.0));
    }
    let OverSpall { ball, side, of_ball, spall, entered, struck } = *current;
    if !crosses(half * ahead) {
        return None;
    }
    over.retain(|o| !is_this(o));
    let left_s = when(half * ahead);
    let (inner, struck_s) = (side == Side::Inner, struck?);
    let kind = EventKind::SpallPassed { ball, inner, of_ball, spall, entered_s: entered, struck_s, left_s };
    Some(Event { time_s: left_s, kind })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steady passages in steps of any length, forwards and backwards, have the times of the edges.
    #[test]
    fn identity_a_passage_has_the_times_of_edges_and_middle() {
        for (speed, step) in [(2.0, 0.003), (-2.0, 0.003), (2.0, 0.07), (-0.5, 0.011)] {
            let place = |t: f64| wrapped(speed * (t - 1.0));
            let (mut over, mut found) = (Vec::new(), Vec::new());
            let passing =
                OverSpall { ball: 1, side: Side::Outer, of_ball: false, spall: 0, entered: 0.0, struck: None };
            for k in 0..(2.0 / step) as u32 {
                let (t, next) = (f64::from(k) * step, f64::from(k + 1) * step);
                let at = |share: f64| t + share * (next - t);
                found.extend(pass(&mut over, passing, ([place(t), place(next)], 0.05), at));
            }
            assert!(found.len() == 1 && over.is_empty(), "{found:?} {over:?}");
            let EventKind::SpallPassed { entered_s, struck_s, left_s, ball: 1, .. } = found[0].kind else { panic!() };
            let half = 0.05 / f64::abs(speed);
            for (time, expected) in [(entered_s, 1.0 - half), (struck_s, 1.0), (left_s, 1.0 + half)] {
                assert!((time - expected).abs() < 1e-12, "{time} {expected}");
            }
        }
    }

    /// A ball that turns back leaves no event; the next passage counts anew.
    #[test]
    fn limit_a_ball_that_turns_back_has_not_passed() {
        let mut over = Vec::new();
        let passing = OverSpall { ball: 0, side: Side::Inner, of_ball: false, spall: 2, entered: 0.0, struck: None };
        let mut go = |a: f64, b: f64| pass(&mut over, passing, ([a, b], 0.1), |share| share);
        assert!(go(-0.2, -0.05).is_none() && go(-0.05, -0.2).is_none());
        assert!(go(-0.2, 0.02).is_none() && go(0.02, 0.2).is_some());
    }
}
