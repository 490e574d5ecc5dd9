//! Why a motion went beyond all bounds: the step, where some motion allows only a shorter one, else the case.
//!
//! The state at the failure is far from any that is meant, and what is stiff there says nothing. Bounds are therefore
//! those of the last look, of balls, rings, cage and pockets; where they allow the step, the adaptive scheme goes the
//! way from there once more and looks for what has become stiff on it.

use super::{FIRST_STEP, Run, SHORTEST_STEP, Scheme, THROWN_OUT};
use crate::blame::{Blame, StepBound};
use crate::equations::Equations;
use crate::forces::{BodyForces, System, evaluate};
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, VELOCITY};
use crate::machine::Machine;
use crate::stiffness::{EULER_LIMIT, FAST_PERIOD, IMAGINARY_LIMIT, REAL_LIMIT, Stiffness};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tribodyn_numerics::{DormandPrince, StepControl};

/// Changes of a position (m, rad) and a speed (m/s, rad/s) for difference quotients: bounds need no digits.
const SHIFT: f64 = 1e-9;
const SPEED_CHANGE: f64 = 1e-5;

/// Longest step times the fastest decay, and times the highest angular frequency.
#[derive(Debug, Clone, Copy)]
struct Limits {
    decay: f64,
    angle: f64,
}

/// Evaluations of all forces that the way from the last look may take, looks at the stiffness on it, and its tolerance.
const MOST_EVALUATIONS: usize = 6000;
const LOOKS: f64 = 32.0;
const TOLERANCE: f64 = 1e-5;

/// The state of a run at a time, where it was looked at and found in good order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Looked {
    pub time: f64,
    pub state: Vec<f64>,
}

impl Run {
    /// The step or the case, whichever is to blame for what happened since the last look.
    pub(super) fn blame(&self) -> Blame {
        let step_s = self.step();
        let limits = match self.scheme {
            // Its steps follow from the error, whatever the stiffness.
            Scheme::DormandPrince { .. } => return Blame::Case { step_s },
            Scheme::Rk4 { .. } => Limits { decay: REAL_LIMIT, angle: IMAGINARY_LIMIT },
            Scheme::Fast { step } => {
                // Dampers, with the velocity expected at the end of a piece, are stable up to half of Euler's limit.
                let pieces = self.progress.fast.pieces(step) as f64;
                Limits { decay: 0.5 * EULER_LIMIT * pieces, angle: TAU * FAST_PERIOD }
            }
        };
        let beyond = |bound: &StepBound| bound.limit_s < step_s;
        let looked = &self.progress.looked;
        let of_bodies = || self.machine.body_bounds(looked.time, &looked.state, limits).into_iter().find(beyond);
        let known = self.machine.stiffness(looked.time, &looked.state);
        let found = Some(self.of_balls(known)).filter(beyond).or_else(of_bodies);
        let of_blows = || self.at_spalls().filter(beyond);
        match found.or_else(|| self.on_the_way(limits).filter(beyond)).or_else(of_blows) {
            Some(bound) => Blame::Step { step_s, bound: Box::new(bound) },
            None => Blame::Case { step_s },
        }
    }

    /// The bound by balls that strike, of the fast scheme: in longer steps friction may throw them to and fro.
    fn at_spalls(&self) -> Option<StepBound> {
        let limit_s = self.machine.longest_step_over_spalls(self.duration)?;
        let motion = "balls at the edges of a spall".to_owned();
        matches!(self.scheme, Scheme::Fast { .. }).then_some(StepBound { motion, limit_s })
    }

    /// The lowest bound that the adaptive scheme finds between the last look and the present time; its mean step where
    /// that is lower. None where it cannot go that way either, or loses a ball on it.
    fn on_the_way(&self, limits: Limits) -> Option<StepBound> {
        let Looked { time: from, state } = &self.progress.looked;
        let (mut t, mut y, end) = (*from, state.clone(), self.progress.time);
        let (mut machine, mut method) = (self.machine.clone(), DormandPrince::default());
        let mut control = StepControl::new(FIRST_STEP.min(self.step()));
        let (mut dy, mut next) = (vec![0.0; y.len()], y.clone());
        machine.derivative(t, &y, &mut dy);
        let least = |bounds: Vec<StepBound>| bounds.into_iter().min_by(|a, b| a.limit_s.total_cmp(&b.limit_s));
        let (mut lowest, mut look, mut steps) = (None::<StepBound>, t, 0);
        for _ in 0..MOST_EVALUATIONS / 6 {
            if t >= look {
                look += (end - from) / LOOKS;
                let here =
                    machine.body_bounds(t, &y, limits).into_iter().chain([self.of_balls(machine.stiffness(t, &y))]);
                lowest = least(here.chain(lowest).collect());
            }
            if t >= end {
                let taken = (end - from) / f64::from(steps.max(1));
                let motion = "what happens there, in the adaptive scheme".to_owned();
                return least(lowest.into_iter().chain([StepBound { motion, limit_s: taken }]).collect());
            }
            let h = control.step.min(end - t);
            let error = method.step(machine.rates(), t, (&y, &dy), h, &self.scale, &mut next) / TOLERANCE;
            if control.judge(error, h, f64::INFINITY) {
                (t, steps) = (if h < end - t { t + h } else { end }, steps + 1);
                std::mem::swap(&mut y, &mut next);
                dy.copy_from_slice(method.last_derivative());
            }
            if control.step < SHORTEST_STEP || self.thrown_out(&y).is_some() {
                return None;
            }
        }
        lowest
    }

    /// The first ball that is far from its place, and how far, m.
    pub(super) fn thrown_out(&self, y: &[f64]) -> Option<(usize, f64)> {
        let l = self.machine.layout;
        let limit = THROWN_OUT * self.machine.bearing.geometry.ball_diameter;
        let off = |ball: usize, k: usize| y[l.ball(ball) + k] - self.start[l.ball(ball) + k];
        let distances = (0..l.balls).map(|ball| (ball, off(ball, AXIAL).hypot(off(ball, RADIUS))));
        // What is not a number is not within the limit either.
        distances.into_iter().find(|(_, distance)| distance.is_nan() || *distance > limit)
    }

    /// The bound by the balls' friction or contact springs, whichever is the lower.
    fn of_balls(&self, s: Stiffness) -> StepBound {
        let (limit_s, springs) = match self.scheme {
            Scheme::Fast { .. } => (s.fast_step_s, self.machine.fast_period() / s.contact_frequency_hz),
            _ => (s.runge_kutta_step_s, IMAGINARY_LIMIT / (TAU * s.contact_frequency_hz)),
        };
        let motion = if limit_s >= springs {
            "the contact springs".to_owned()
        } else if limit_s >= self.machine.pocket_film_step() {
            "the oil in the pockets".to_owned()
        } else if limit_s >= self.machine.free_cage_step() {
            "the free cage among the balls".to_owned()
        } else {
            format!("friction of ball {}", s.ball)
        };
        StepBound { motion, limit_s }
    }
}

impl Machine {
    /// Bounds by rings, cage and pockets, each motion by itself.
    fn body_bounds(&self, t: f64, y: &[f64], limits: Limits) -> Vec<StepBound> {
        let l = self.layout;
        let names = ["x", "y", "z"];
        let mut bounds = Vec::new();
        let mut add = |motion: String, positions: [usize; 2], of: &dyn Fn(&BodyForces) -> f64| {
            let slope = |at: usize, change: f64| {
                let mut shifted = y.to_vec();
                let mut value = |by: f64| {
                    shifted[at] = y[at] + by;
                    of(&evaluate(self, t, &shifted, |_, _| {}).2)
                };
                (value(change) - value(-change)) / (2.0 * change)
            };
            bounds.push(bound(motion, slope(positions[0], SHIFT), slope(positions[1], SPEED_CHANGE), limits));
        };
        for k in (0..3).filter(|&k| self.inner.free[k]) {
            let at = l.inner() + k;
            add(format!("the inner ring along {}", names[k]), [at, at + 3], &|f| f.inner[k]);
        }
        for k in (0..2).filter(|&k| self.outer.free[k]) {
            let at = l.outer() + k;
            add(format!("the outer ring along {}", names[k]), [at, at + 2], &|f| f.outer[k]);
        }
        add("the cage".to_owned(), [l.cage(), l.cage() + 1], &|f| f.cage);
        bounds.extend((0..l.balls).map(|index| self.pocket_bound(index, t, y, limits)));
        bounds
    }

    /// The bound by the pocket of a ball, along its orbit.
    fn pocket_bound(&self, index: usize, t: f64, y: &[f64], limits: Limits) -> StepBound {
        let frame = self.frame(t, y);
        let b = self.unknowns(index, y);
        let slope = |at: usize, change: f64| {
            let mut unknowns = [0.0; BALL];
            unknowns.copy_from_slice(b);
            let mut value = |by: f64| {
                unknowns[at] = b[at] + by;
                let forces = self.ball(index, &unknowns, &frame, |patch, _| self.kernel.traction(&self.bearing, patch));
                forces.acceleration[ORBIT - VELOCITY]
            };
            (value(change) - value(-change)) / (2.0 * change)
        };
        bound(format!("ball {index} in its pocket"), slope(AZIMUTH, SHIFT), 0.0, limits)
    }
}

/// The bound of one motion from the slopes of its acceleration by position, 1/s², and by speed, 1/s.
fn bound(motion: String, by_position: f64, by_speed: f64, limits: Limits) -> StepBound {
    let of = |rate: f64, limit: f64| if rate > 0.0 { limit / rate } else { f64::INFINITY };
    let limit_s = of((-by_position).max(0.0).sqrt(), limits.angle).min(of(-by_speed, limits.decay));
    StepBound { motion, limit_s }
}
