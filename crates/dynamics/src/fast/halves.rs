//! Kicks in halves: that at the end of a step belongs one half to this step and one to the next, so that the state
//! between two steps is that of the middle of a kick. And the state as samples have it.

use super::Fast;
use super::drift::drift_acceleration;
use super::implicit::OF_RINGS;
use super::lanes::{InUse, Lane, WIDTH, filled};
use super::scratch::Scratch;
use crate::equations::Equations;
use crate::layout::{BALL, Layout, VELOCITIES, VELOCITY};
use fearless_simd::dispatch;

impl Fast {
    /// Makes ready for steps of another length than the last ones, or for the first: finds the half kick that the next
    /// step begins with.
    pub(super) fn begin<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let Scratch { level, balls, pressed, .. } = &mut self.scratch;
        drift_acceleration(*level, equations, (t, y), balls, (&mut self.drift, pressed));
        for (mean, pressed) in self.scratch.mean.iter_mut().zip(&self.scratch.pressed) {
            *mean = *pressed.acceleration();
        }
        self.mean.copy_from_slice(&self.drift);
        self.longest = self.longest_pieces(equations.machine());
        self.find_second_half(equations, t, y, h);
        if self.steps == 0 && !equations.machine().is_even() {
            let machine = equations.machine();
            self.begin_smoothly((machine.layout, machine.is_damaged()), h);
            self.find_second_half(equations, t, y, h);
        }
    }

    /// The second half of a kick alone: velocities stay.
    fn find_second_half<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let (balls, bodies) = (self.scratch.balls.clone(), y.to_vec());
        self.find_kick(equations, t, y, h);
        self.scratch.balls = balls;
        y.copy_from_slice(&bodies);
    }

    /// The common accelerations as the kick that was found has them, the other way: the shock in which races that are
    /// not round meet the balls at the start of a run is the drift's alone: carried by the common part it would swing
    /// the balls. Along the orbit there is none where balls strike.
    fn begin_smoothly(&mut self, (l, strikes): (Layout, bool), h: f64) {
        let Scratch { common, given_back, half, .. } = &mut self.scratch;
        let parts = if strikes { 2 } else { 3 };
        for ((common, given), half) in common.iter_mut().zip(given_back).zip(half) {
            common[parts..].fill(Lane::ZERO);
            for ((common, given), half) in common[..parts].iter_mut().zip(given).zip(half) {
                for ((common, given), half) in common.0.iter_mut().zip(given.0).zip(half.0) {
                    *common = given - 2.0 * half / h;
                }
            }
        }
        for k in l.velocities_of_rings() {
            self.common[k] = self.given_back[k] - 2.0 * self.half[k] / h;
        }
    }

    /// The first half of the kick of a step `h`; the other is kept.
    pub(super) fn find_kick<E: Equations>(&mut self, equations: &mut E, t: f64, y: &mut [f64], h: f64) {
        let l = equations.machine().layout;
        for (balls, half) in self.scratch.balls.iter().zip(&mut self.scratch.half) {
            half.copy_from_slice(&balls[VELOCITY..]);
        }
        l.velocities_of_bodies().for_each(|k| self.half[k] = y[k]);
        self.kick(equations, t, y, h);
        let Scratch { level, balls, half, common, given_back, pressed, .. } = &mut self.scratch;
        let parts = common.iter().zip(given_back.iter()).zip(pressed);
        for ((balls, half), (parts, pressed)) in balls.iter_mut().zip(half).zip(parts) {
            dispatch!(*level, _simd => halve(balls, half, pressed.in_use));
            dispatch!(*level, _simd => share_common((balls, half), parts, (pressed.in_use, h)));
        }
        for k in l.velocities_of_bodies() {
            let before = self.half[k];
            self.half[k] = 0.5 * (y[k] - before);
            y[k] = before + self.half[k];
        }
        for k in l.velocities_of_rings() {
            let more = 0.5 * h * (self.common[k] - self.given_back[k]);
            self.half[k] += more;
            y[k] -= more;
        }
    }

    /// The second half of the last kick.
    pub(super) fn second_half(&mut self, l: Layout, y: &mut [f64]) {
        let Scratch { level, balls, half, .. } = &mut self.scratch;
        for (balls, half) in balls.iter_mut().zip(half) {
            dispatch!(*level, _simd => add(balls, half));
        }
        l.velocities_of_bodies().for_each(|k| y[k] += self.half[k]);
    }

    /// Remembers the velocities at the start of a piece of the drift, without angular velocities.
    pub(super) fn remember_velocities(&mut self, l: Layout, y: &[f64]) {
        for (balls, before) in self.scratch.balls.iter().zip(&mut self.scratch.before) {
            before.copy_from_slice(&balls[VELOCITY..VELOCITY + 3]);
        }
        l.velocities_of_bodies().for_each(|k| self.before[k] = y[k]);
    }

    /// From the velocities in the middle of a piece to those expected at its end, farther by as much as from its start
    /// to the middle: what forces that depend on them, dampers and the centrifugal one, are found with. The drift goes
    /// without the common accelerations, so that velocities are ahead by half a kick at its start and behind by as much
    /// at its end: that is taken out by the share of the step that is `over`. Dampers that feel it drive what they
    /// damp.
    pub(super) fn swap_ahead(&mut self, l: Layout, y: &mut [f64], over: f64) {
        let Scratch { level, balls, before, half, pressed, .. } = &mut self.scratch;
        let by_kick = 2.0 * over - 1.0;
        for (((balls, before), half), pressed) in balls.iter_mut().zip(before).zip(half).zip(pressed) {
            dispatch!(*level, _simd => ahead((balls, before), (half, by_kick), pressed.in_use));
        }
        for k in l.velocities_of_bodies() {
            (y[k], self.before[k]) = (2.0 * y[k] - self.before[k] + by_kick * self.half[k], y[k]);
        }
    }

    /// Back to those in the middle.
    pub(super) fn swap_back(&mut self, l: Layout, y: &mut [f64]) {
        for (balls, before) in self.scratch.balls.iter_mut().zip(&self.scratch.before) {
            balls[VELOCITY..VELOCITY + 3].copy_from_slice(before);
        }
        l.velocities_of_bodies().for_each(|k| y[k] = self.before[k]);
    }

    /// The state as samples have it, displacements corrected.
    ///
    /// In leapfrog with pieces h, what vibrates at ω has a displacement, where forces are found, that is too large for
    /// its velocity, by (ω h)²/8: one is too large and the other too small by half of it. The acceleration by
    /// drift and kick together is −ω² times what vibrates of the displacement, whatever ω is, and takes its half back.
    /// Such a symplectic corrector is that of J. Wisdom, M. Holman, J. Touma, Fields Institute Communications 10 (1996)
    /// 217.
    ///
    /// The velocities of the balls are the mean ones of the kick, for which friction is the mean one too.
    pub fn show(&self, l: Layout, y: &[f64], shown: &mut Vec<f64>) {
        shown.clear();
        shown.extend_from_slice(y);
        if !self.ready {
            return;
        }
        let [share, of_balls] = [self.piece, self.piece_of_balls].map(|piece| piece * piece / 16.0);
        let by_kick = 2.0 / self.step;
        // In lanes while steps are made, and in the memory before the first one of a run that is taken up.
        let Scratch { pressed, common, half, beyond, .. } = &self.scratch;
        for (block, (((pressed, common), half), beyond)) in pressed.iter().zip(common).zip(half).zip(beyond).enumerate()
        {
            let acceleration = pressed.acceleration();
            for k in 0..filled(l, block) {
                let ball = &mut shown[l.ball(WIDTH * block + k)..][..BALL];
                for i in 0..2 {
                    let vibrating = acceleration[i].0[k] - common[i].0[k] + by_kick * half[i].0[k];
                    ball[i] += of_balls * vibrating;
                }
                (0..VELOCITIES).for_each(|i| ball[VELOCITY + i] += beyond[i].0[k]);
            }
        }
        for at in (0..l.balls).map(|ball| l.ball(ball)).filter(|_| half.is_empty()) {
            (0..2).for_each(|i| shown[at + i] += of_balls * self.acceleration(at + VELOCITY + i, by_kick));
            (VELOCITY..BALL).for_each(|i| shown[at + i] += self.beyond[at + i]);
        }
        // Rings beside implicit balls lack less.
        let of_rings = if self.piece_of_balls == 0.0 { share * (1.0 - 4.0 * OF_RINGS) } else { share };
        let translations = l.translations().into_iter().map(|at| (at, of_rings));
        let tilts = l.velocities_of_tilts().map(|velocity| ([velocity - 2, velocity], share));
        for ([place, velocity], share) in translations.chain(tilts) {
            shown[place] += share * self.acceleration(velocity, by_kick);
        }
    }

    /// By the drift without its common part, and by the kick, from the memory.
    fn acceleration(&self, place: usize, by_kick: f64) -> f64 {
        self.drift[place] - self.common[place] + by_kick * self.half[place]
    }
}

/// Half way back to the velocities in `half`, which then has the way made.
#[inline(always)]
fn halve(balls: &mut [Lane; BALL], half: &mut [Lane; VELOCITIES], in_use: InUse) {
    for (now, half) in balls[VELOCITY..].iter_mut().zip(half) {
        for k in in_use.lanes() {
            let before = half.0[k];
            half.0[k] = 0.5 * (now.0[k] - before);
            now.0[k] = before + half.0[k];
        }
    }
}

/// Gives the second half of the kick the common part that the next drift goes without, and the first half that of the
/// last one: the momentum between the two is then that of the whole.
#[inline(always)]
fn share_common(
    (balls, half): (&mut [Lane; BALL], &mut [Lane; VELOCITIES]),
    (common, given): (&[Lane; 3], &[Lane; 3]),
    (in_use, h): (InUse, f64),
) {
    for i in 0..3 {
        for k in in_use.lanes() {
            let more = 0.5 * h * (common[i].0[k] - given[i].0[k]);
            half[i].0[k] += more;
            balls[VELOCITY + i].0[k] -= more;
        }
    }
}

/// Velocities as far ahead as those in `before` are behind, with a share of a half kick; in `before` then those of now.
#[inline(always)]
fn ahead(
    (balls, before): (&mut [Lane; BALL], &mut [Lane; 3]),
    (half, share): (&[Lane; VELOCITIES], f64),
    in_use: InUse,
) {
    for (i, before) in before.iter_mut().enumerate() {
        let now = &mut balls[VELOCITY + i];
        for k in in_use.lanes() {
            (now.0[k], before.0[k]) = (2.0 * now.0[k] - before.0[k] + share * half[i].0[k], now.0[k]);
        }
    }
}

/// Velocities with their changes.
#[inline(always)]
fn add(balls: &mut [Lane; BALL], changes: &[Lane; VELOCITIES]) {
    for (now, change) in balls[VELOCITY..].iter_mut().zip(changes) {
        now.0.iter_mut().zip(change.0).for_each(|(v, change)| *v += change);
    }
}
