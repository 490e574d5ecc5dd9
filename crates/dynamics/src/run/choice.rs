//! The step of the fast scheme by the accuracy that is asked for: short runs after the start with one step and with
//! half of it, and how far they come apart.
//!
//! The scheme is of second order, so that the error is four thirds of that distance, and a step that is shorter by the
//! root of error over accuracy does. Where impacts scatter the motion, a shorter step brings no less: half and a
//! quarter of the longest are then tried, too, and the longest step is taken that keeps the accuracy, or errs by at
//! most twice the least of those tried.
//!
//! Trials integrate traction more often than the run: what the linear traction errs in the torque of so short a time is
//! the same for all steps, and where balls roll in oil more than all else that a step errs.
//!
//! Where balls strike, the torque swings by many times its mean, and samples of it tell of chance: by 1 % and more
//! where the power of a long run is the same to four digits. There what the races lose by friction counts, over all
//! steps, with weights that fall to nothing towards both ends, as trials may begin and end with a ball over a spall.

use super::companion::apart_and_unsteady;
use super::filter::steps_of_sample;
use crate::fast::{Fast, Room};
use crate::machine::Machine;
use crate::observer::BallDetail;
use crate::stiffness::or_infinite;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_bearing::Side;

/// Simulated time of a trial, s: some periods of a ring on its balls.
const SPAN_S: f64 = 2e-3;
/// Longest one over a damaged place, s.
const LONGEST_SPAN_S: f64 = 2e-2;
/// Most of it, over the duration of the run, and fewest samples.
const MOST_OF_RUN: f64 = 0.05;
const FEWEST: usize = 8;
/// Longest step that is tried, over the one that is stable at the start: loads change.
const MARGIN: f64 = 0.9;
/// The longest that is tried at all, s: beyond it loads that strike leave balls sliding. In 26 µs the power of a 6206
/// whose load triples within half a millisecond is right to 0.1 %, in 39 µs 3 to 9 % too small.
const LONGEST_S: f64 = 2.61e-5;
/// Shortest step that is tried, in that longest one: beyond it another scheme does better.
const MOST_DIVISIONS: f64 = 64.0;
/// Steps in the longest one that are tried, too, where a shorter one does not lessen the error, and the error of a step
/// over the least one that counts as no more.
const SCATTERED: [f64; 2] = [2.0, 4.0];
const NO_MORE: f64 = 2.0;
/// Steps in the longest one over the start of a bearing that is round, and of one that is not.
const PAST_THE_START: [f64; 2] = [4.0, 32.0];
/// Error of the linear traction in trials over that of the run. With a tenth, what it errs in the torque of 2 ms
/// outweighs in oil what the step errs.
const LINEAR_ERROR_OF_RUN: f64 = 0.01;
/// The same where balls strike: trials have to meet blows as the run does, and the power of friction hardly shows it.
const LINEAR_ERROR_OF_BLOWS: f64 = 0.1;
/// Halvings of a step in which the motion from the start goes beyond all numbers.
const MOST_HALVINGS: usize = 6;
/// Fewest steps between samples: fewer save little more, and what samples tell of accelerations suffers.
const LEAST_STEPS: f64 = 2.0;
/// Pairs of trials.
const ROUNDS: usize = 4;
/// Error of the cage's speed that counts as one of the loads: a mean over many contacts is better than each.
const SPEED: f64 = 0.1;
/// Error of the ring's acceleration, over its own rms, that counts as one of the loads: it is what large forces leave.
const ACCELERATION: f64 = 20.0;
/// Error of a step over its distance from half of it.
const OF_SECOND_ORDER: f64 = 4.0 / 3.0;

/// How a step was chosen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StepChoice {
    /// Accuracy asked for.
    pub accuracy: f64,
    /// Errors found with the step, or with a longer one in which a ball was lost over a spall at the start.
    pub errors: StepErrors,
    /// The step, s.
    pub step_s: f64,
    /// True where a shorter step does not lessen the error: the motion scatters.
    pub scatters: bool,
}

/// Errors of a step, by what half of it changes over some milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StepErrors {
    /// Of the normal loads, rms over balls and time, over their mean.
    #[serde(deserialize_with = "or_infinite")]
    pub loads: f64,
    /// Of the mean torque on the inner ring, over itself; where balls strike, of the power that friction takes.
    #[serde(deserialize_with = "or_infinite")]
    pub torque: f64,
    /// Of the mean cage speed, over itself.
    #[serde(deserialize_with = "or_infinite")]
    pub cage_speed: f64,
    /// Of the outer ring's acceleration sample by sample, rms, over that of its unsteady part.
    #[serde(deserialize_with = "or_infinite")]
    pub acceleration: f64,
    /// The same times the ring's mass over the loads of all balls: where a ring hardly shakes, this counts.
    #[serde(deserialize_with = "or_infinite")]
    pub ring_force: f64,
}

impl StepErrors {
    const UNKNOWN: Self = {
        let all = f64::INFINITY;
        Self { loads: all, torque: all, cage_speed: all, acceleration: all, ring_force: all }
    };

    /// The error that counts against an accuracy: the largest of loads, torque, ten times the cage speed, and a
    /// twentieth of the acceleration, or the ring's force where that is less.
    pub fn worst(&self) -> f64 {
        let shaking = self.acceleration / ACCELERATION;
        // A ring at rest has no unsteady part, and 0/0 is not less.
        let of_ring = if shaking < self.ring_force { shaking } else { self.ring_force };
        let all = [self.loads, self.torque, self.cage_speed / SPEED, of_ring];
        all.into_iter().fold(0.0, |most, error| if error > most || error.is_nan() { error } else { most })
    }
}

/// The longest step that keeps the accuracy, or whose error is no more than that of others.
fn longest_of(tried: [StepChoice; 5]) -> StepChoice {
    let least = tried.iter().map(|choice| choice.errors.worst()).fold(f64::INFINITY, f64::min);
    let allowed = f64::max(tried[0].accuracy, NO_MORE * least);
    let no_more = tried.into_iter().filter(|choice| choice.errors.worst() <= allowed);
    let longest = no_more.max_by(|a, b| a.step_s.total_cmp(&b.step_s)).unwrap_or(tried[4]);
    StepChoice { scatters: longest.errors.worst() > longest.accuracy, ..longest }
}

/// A short run as it is compared.
struct Trial {
    /// Mean accelerations of the outer ring between samples, m/s².
    accelerations: Vec<[f64; 2]>,
    /// Normal loads at the samples, N.
    loads: Vec<f64>,
    /// Mean torque on the inner ring, N m, or where balls strike, mean power of friction, W; and mean speed of the
    /// cage, rad/s.
    torque: f64,
    cage_speed: f64,
}

/// Trials that were made, by their steps a sample; none where the motion went beyond all numbers.
type Made = Vec<(f64, Option<Trial>)>;

/// Where trials start, and how they are sampled.
pub(super) struct Trials<'a> {
    pub machine: &'a Machine,
    /// Time, s.
    pub start: f64,
    pub state: &'a [f64],
    pub linear_error: f64,
    /// Samples, Hz.
    pub rate: f64,
    /// Of the run, s.
    pub duration: f64,
}

impl Trials<'_> {
    /// The longest step with the accuracy asked for.
    pub fn choose(&self, accuracy: f64) -> StepChoice {
        let choice = match self.past_the_start() {
            Some((start, state)) => Trials { start, state: &state, ..*self }.longest_that_keeps(accuracy),
            None => self.longest_that_keeps(accuracy),
        };
        if self.machine.is_damaged() { self.that_bears_the_start(choice) } else { choice }
    }

    /// The step of a choice, or half of it and so on, until the motion from the very start stays finite as the run has
    /// it: over more blows than trials have, and by a ball that may stand over a spall at the start.
    fn that_bears_the_start(&self, mut choice: StepChoice) -> StepChoice {
        let samples = ((LONGEST_SPAN_S.min(self.duration) * self.rate) as usize).max(FEWEST);
        for _ in 0..MOST_HALVINGS {
            let steps = steps_of_sample(choice.step_s, self.rate);
            if self.march((samples, steps), self.linear_error, |_, _, _, _| ()).is_some() {
                break;
            }
            choice.step_s *= 0.5;
        }
        choice
    }

    /// A motion starts as that of a round bearing, with balls that fit their orbit to a tolerance. The shock in which
    /// balls and races that are not round meet, and what little others have to settle, would ask for steps that nothing
    /// after it needs: the state in which it has died away, and its time, s.
    fn past_the_start(&self) -> Option<(f64, Vec<f64>)> {
        let [round, other] = PAST_THE_START;
        let divisions = if self.machine.is_even() { round } else { other };
        let steps = steps_of_sample(self.longest() / divisions, self.rate);
        let state = self.march((self.samples(), steps), self.finer(), |_, _, _, _| ())?;
        Some((self.start + self.samples() as f64 / self.rate, state))
    }

    fn longest_that_keeps(&self, accuracy: f64) -> StepChoice {
        let least = steps_of_sample(self.longest(), self.rate).max(LEAST_STEPS);
        let mut made = Made::new();
        let mut choice = |steps: f64| {
            let (errors, step_s) = (self.errors(steps, &mut made), 1.0 / (self.rate * steps));
            StepChoice { accuracy, errors, step_s, scatters: false }
        };
        let (first, most) = (choice(least), MOST_DIVISIONS * least);
        let (mut best, mut steps) = (first, least);
        for _ in 1..ROUNDS {
            let error = best.errors.worst();
            if error <= accuracy || steps >= most {
                break;
            }
            let before = steps;
            // Half of a step in which the motion goes beyond all numbers.
            let shorter = if error.is_finite() { (error / accuracy).sqrt() } else { 2.0 };
            steps = (steps * shorter).ceil().clamp(before + 1.0, most);
            let next = choice(steps);
            if next.errors.worst() > error * before / steps {
                let [half, quarter] = SCATTERED.map(|parts| choice(parts * least));
                return longest_of([first, best, next, half, quarter]);
            }
            best = next;
        }
        best
    }

    /// Longest step that is tried, s: samples see what the contacts vibrate, where that does not die out at once. Oil
    /// in the pockets does not bound it: see [`Machine::thicken_pocket_film`].
    fn longest(&self) -> f64 {
        let mut dry = self.machine.clone();
        dry.cage.pocket.film = None;
        let stiffness = dry.stiffness(self.start, self.state);
        let resolved = if dry.is_well_damped() { f64::INFINITY } else { 0.5 / stiffness.contact_frequency_hz };
        (MARGIN * stiffness.fast_step_s.min(resolved)).min(LONGEST_S)
    }

    /// Errors of so many steps a sample, by what twice as many change.
    fn errors(&self, steps: f64, made: &mut Made) -> StepErrors {
        let mut place = |steps| {
            made.iter().position(|(of, _)| *of == steps).unwrap_or_else(|| {
                made.push((steps, self.trial(steps)));
                made.len() - 1
            })
        };
        let [coarse, fine] = [place(steps), place(2.0 * steps)].map(|at| made[at].1.as_ref());
        coarse.zip(fine).map_or(StepErrors::UNKNOWN, |(coarse, fine)| self.apart(coarse, fine))
    }

    /// Errors of a trial by one with half its step.
    fn apart(&self, coarse: &Trial, fine: &Trial) -> StepErrors {
        let relative = |a: f64, b: f64| if a == b { 0.0 } else { OF_SECOND_ORDER * (a / b - 1.0).abs() };
        let [apart, unsteady] = apart_and_unsteady(&coarse.accelerations, &fine.accelerations);
        let (count, of_ring) = (fine.loads.len() as f64, OF_SECOND_ORDER * apart);
        let squares = coarse.loads.iter().zip(&fine.loads).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let load = fine.loads.iter().sum::<f64>() / count;
        StepErrors {
            loads: OF_SECOND_ORDER * (squares / count).sqrt() / load,
            torque: relative(coarse.torque, fine.torque),
            cage_speed: relative(coarse.cage_speed, fine.cage_speed),
            acceleration: of_ring / unsteady,
            ring_force: of_ring * self.machine.outer.mass / (load * self.machine.layout.balls as f64),
        }
    }

    /// Error of the linear traction in trials.
    fn finer(&self) -> f64 {
        let of_run = if self.machine.is_damaged() { LINEAR_ERROR_OF_BLOWS } else { LINEAR_ERROR_OF_RUN };
        of_run * self.linear_error
    }

    /// Samples of a trial: over a place that is damaged a ball has to pass.
    fn samples(&self) -> usize {
        let usual = SPAN_S.min(MOST_OF_RUN * self.duration);
        let span = if self.machine.is_damaged() { usual.max(self.pass()) } else { usual };
        ((span * self.rate) as usize).max(FEWEST)
    }

    /// Time in which the balls move on by one on either ring, s.
    fn pass(&self) -> f64 {
        let (l, speeds) = (self.machine.layout, &self.machine.speeds);
        let cage = self.state[l.cage() + 1];
        let slower = speeds.each_ref().map(|speed| (cage - speed.at(self.start)).abs());
        (TAU / (l.balls as f64 * slower.inner.min(slower.outer))).min(LONGEST_SPAN_S)
    }

    /// From the start with so many steps a sample; none where the motion goes beyond all numbers.
    fn trial(&self, steps: f64) -> Option<Trial> {
        let (l, length, samples) = (self.machine.layout, 1.0 / self.rate, self.samples());
        let velocities = |y: &[f64]| [y[l.outer() + 2], y[l.outer() + 3]];
        let (mut accelerations, mut loads, mut torque) = (Vec::new(), Vec::new(), 0.0);
        let (mut room, mut shown, mut before) = (Room::default(), Vec::new(), velocities(self.state));
        let strikes = self.machine.is_damaged();
        let state = self.march((samples, steps), self.finer(), |fast, machine, (t, y), [sample, step]| {
            let is_sample = step == steps as usize;
            if !strikes && !is_sample {
                return;
            }
            fast.show(l, y, &mut shown);
            let (sums, balls) = fast.sample(machine, (t, &shown), (BallDetail::Loads, &mut room));
            let made = (sample as f64 + step as f64 / steps) / samples as f64;
            let friction = sums.powers.friction;
            torque += if strikes {
                (1.0 - (TAU * made).cos()) / steps * (friction.inner + friction.outer)
            } else {
                sums.torque.inner
            } / samples as f64;
            if is_sample {
                let now = velocities(y);
                accelerations.push([0, 1].map(|k| (now[k] - before[k]) / length));
                before = now;
                loads.extend(balls.iter().flat_map(|ball| Side::BOTH.map(|side| ball.contacts[side].load_n)));
            }
            room.balls = balls;
        })?;
        let cage_speed = (state[l.cage()] - self.state[l.cage()]) / (samples as f64 * length);
        Some(Trial { accelerations, loads, torque, cage_speed })
    }

    /// The state after as many samples with so many steps each; none where it is no number. After every step `look`
    /// has the scheme, the machine, time and state, and which sample and which step of it that is.
    fn march(
        &self,
        (samples, steps): (usize, f64),
        linear_error: f64,
        mut look: impl FnMut(&Fast, &Machine, (f64, &[f64]), [usize; 2]),
    ) -> Option<Vec<f64>> {
        let (mut machine, mut y) = (self.machine.clone(), self.state.to_vec());
        let (length, mut fast) = (1.0 / self.rate, Fast::with_linear_error(linear_error));
        let h = length / steps;
        machine.thicken_pocket_film(h);
        for sample in 0..samples {
            for step in 1..=steps as usize {
                let t = self.start + sample as f64 * length + step as f64 * h;
                fast.step(&mut machine, t - h, &mut y, h);
                look(&fast, &machine, (t, &y), [sample, step]);
            }
        }
        y.iter().all(|value| value.is_finite()).then_some(y)
    }
}
