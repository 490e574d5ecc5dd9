//! Error of the accelerations of a run by step, patch rule and linear traction together: two companions go on from its
//! present state for a short while, one as the run does and one with half the step and a finer patch. How far the
//! acceleration of the outer ring of one is from that of the other is the error of the coarser one.
//!
//! The error of a patch rule or of a linear traction is a force that comes and goes with the refreshes, and what it
//! does to a ring depends on mass, springs and dampers: no estimate over the load says it.

use super::{FIRST_STEP, Run, SHORTEST_STEP, Scheme};
use crate::fast::Fast;
use crate::forces::System;
use crate::machine::{Kernel, Machine};
use serde::{Deserialize, Serialize};
use tribodyn_numerics::{DormandPrince, Rk4, StepControl};
use tribodyn_traction::{FastPatch, PatchRule, Quadrature, TractionError};

/// Simulated time of a companion, s: some decays of a ring on its supports, a few per cent of a usual run.
const SPAN_S: f64 = 5e-3;
/// Most of it, over the time of the run so far.
const MOST_OF_RUN: f64 = 0.25;
/// Fewest samples that say something.
const FEWEST: usize = 8;
/// Steps of the finer companion in one of the run, and the tolerance and the linear error of the run over its.
const STEPS_IN_ONE: u32 = 2;
const FINER: f64 = 10.0;
/// Error over the acceleration itself, both as rms, up to which accelerations are supported: peaks then hold to about
/// twice of that.
pub const ACCELERATION_PART: f64 = 0.1;

/// Error of the accelerations of the outer ring across the axis, by step, patch rule and linear traction together.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct AccelerationError {
    /// Root mean square of the difference between the run's numerics and finer ones, and no less than what the
    /// tolerance of the solution at the start leaves, m/s².
    pub error_m_s2: f64,
    /// Root mean square of the finer acceleration about its mean over the same time, m/s².
    pub acceleration_m_s2: f64,
    /// Simulated time compared, s.
    pub span_s: f64,
}

/// Root mean squares of how far accelerations are from finer ones, and of those about their mean, m/s².
pub(super) fn apart_and_unsteady(own: &[[f64; 2]], finer: &[[f64; 2]]) -> [f64; 2] {
    let count = finer.len() as f64;
    let (mut error, mut squares) = (0.0, 0.0);
    for k in 0..2 {
        let mean = finer.iter().map(|a| a[k]).sum::<f64>() / count;
        error += own.iter().zip(finer).map(|(a, b)| (a[k] - b[k]).powi(2)).sum::<f64>();
        squares += finer.iter().map(|a| (a[k] - mean).powi(2)).sum::<f64>();
    }
    [error, squares].map(|sum| (sum / count).sqrt())
}

/// How a companion steps.
enum Method {
    RungeKutta4 { steps: u32 },
    Fast { steps: u32, linear_error: f64 },
    DormandPrince { tolerance: f64, longest: f64 },
}

impl Run {
    /// Error of the accelerations at the present state; none where the run is too short to tell, or a companion cannot
    /// go on. It takes the time of a few per cent of a usual run and changes nothing.
    pub fn acceleration_error(&self) -> Option<AccelerationError> {
        let least = FEWEST as f64 / self.state_rate;
        let span = SPAN_S.max(4.0 * least).min(MOST_OF_RUN * self.progress.time);
        let samples = (span * self.state_rate) as usize;
        if samples < FEWEST {
            return None;
        }
        let own = self.companion(self.machine.clone(), &self.method(false), samples)?;
        let mut machine = self.machine.clone();
        machine.kernel = finer(&machine.kernel).ok()?;
        let finer = self.companion(machine, &self.method(true), samples)?;
        let [error, acceleration_m_s2] = apart_and_unsteady(&own, &finer);
        let error_m_s2 = error.max(self.acceleration_of_residual());
        Some(AccelerationError { error_m_s2, acceleration_m_s2, span_s: samples as f64 / self.state_rate })
    }

    /// Acceleration that the forces left over in the solution at the start give the outer ring, m/s²: a vibration below
    /// it is rounding, which both companions have alike.
    fn acceleration_of_residual(&self) -> f64 {
        let load: f64 = self.sample().balls.iter().map(|ball| ball.contacts.outer.load_n).sum();
        self.tolerance * load / self.machine.outer.mass
    }

    fn method(&self, finer: bool) -> Method {
        let (more, over) = if finer { (STEPS_IN_ONE, FINER) } else { (1, 1.0) };
        let steps = |step: f64| more * (1.0 / (self.state_rate * step) - 1e-9).ceil().max(1.0) as u32;
        match &self.scheme {
            Scheme::Rk4 { step, .. } => Method::RungeKutta4 { steps: steps(*step) },
            Scheme::Fast { step } => {
                Method::Fast { steps: steps(*step), linear_error: self.progress.fast.linear_error() / over }
            }
            Scheme::DormandPrince { tolerance, longest, .. } => {
                Method::DormandPrince { tolerance: tolerance / over, longest: *longest }
            }
        }
    }

    /// Mean accelerations of the outer ring along x and y between so many samples from the present on, m/s².
    fn companion(&self, mut machine: Machine, method: &Method, samples: usize) -> Option<Vec<[f64; 2]>> {
        let (l, length) = (machine.layout, 1.0 / self.state_rate);
        let mut y = self.progress.state.clone();
        let mut march = March::new(method, &self.scale, &y);
        let velocities = |y: &[f64]| [y[l.outer() + 2], y[l.outer() + 3]];
        let mut found = Vec::with_capacity(samples);
        for sample in 0..samples {
            let (before, t) = (velocities(&y), self.progress.time + sample as f64 * length);
            march.over(&mut machine, (t, length), &mut y)?;
            let after = velocities(&y);
            found.push([0, 1].map(|k| (after[k] - before[k]) / length));
        }
        let whole = found.iter().flatten().all(|a| a.is_finite()) && self.thrown_out(&y).is_none();
        whole.then_some(found)
    }
}

/// A patch rule with half as many nodes again in each direction.
fn finer(kernel: &Kernel) -> Result<Kernel, TractionError> {
    let more = |count: usize| count + count.div_ceil(2);
    let rule = match kernel.rule() {
        PatchRule::PolarMidpoint { radial, circumferential } => {
            PatchRule::PolarMidpoint { radial: more(radial), circumferential: more(circumferential) }
        }
        PatchRule::GaussJacobi { radial, angles } => {
            PatchRule::GaussJacobi { radial: more(radial), angles: more(angles) }
        }
        PatchRule::SplitStrip { across, along } => PatchRule::SplitStrip { across: more(across), along: more(along) },
    };
    let quadrature = Quadrature::new(rule)?;
    Ok(match kernel {
        Kernel::Fast(_) => Kernel::Fast(FastPatch::of(quadrature)),
        Kernel::Plain(_) => Kernel::Plain(quadrature),
    })
}

/// A companion on its way.
enum March<'a> {
    RungeKutta4 { steps: u32, method: Rk4, derivative: Vec<f64>, next: Vec<f64> },
    Fast { steps: u32, fast: Box<Fast> },
    DormandPrince { tolerance: f64, longest: f64, pair: Box<Pair<'a>> },
}

/// The adaptive method with its memory.
struct Pair<'a> {
    method: DormandPrince,
    control: StepControl,
    scale: &'a [f64],
    derivative: Vec<f64>,
    next: Vec<f64>,
}

impl<'a> March<'a> {
    fn new(method: &Method, scale: &'a [f64], y: &[f64]) -> Self {
        let (derivative, next) = (y.to_vec(), y.to_vec());
        match *method {
            Method::RungeKutta4 { steps } => Self::RungeKutta4 { steps, method: Rk4::default(), derivative, next },
            Method::Fast { steps, linear_error } => {
                Self::Fast { steps, fast: Box::new(Fast::with_linear_error(linear_error)) }
            }
            Method::DormandPrince { tolerance, longest } => {
                let (method, control) = (DormandPrince::default(), StepControl::new(FIRST_STEP.min(longest)));
                Self::DormandPrince {
                    tolerance,
                    longest,
                    pair: Box::new(Pair { method, control, scale, derivative, next }),
                }
            }
        }
    }

    /// From `y` at `t` over a length, in place; none where no step is short enough.
    fn over(&mut self, machine: &mut Machine, (t, length): (f64, f64), y: &mut [f64]) -> Option<()> {
        match self {
            Self::RungeKutta4 { steps, method, derivative, next } => {
                let h = length / f64::from(*steps);
                for k in 0..*steps {
                    let t = t + f64::from(k) * h;
                    machine.derivative(t, y, derivative);
                    method.step(machine.rates(), t, (y, derivative), h, next);
                    y.copy_from_slice(next);
                }
            }
            Self::Fast { steps, fast } => {
                let h = length / f64::from(*steps);
                (0..*steps).for_each(|k| fast.step(machine, t + f64::from(k) * h, y, h));
            }
            Self::DormandPrince { tolerance, longest, pair } => {
                let Pair { method, control, scale, derivative, next } = &mut **pair;
                let (mut now, end) = (t, t + length);
                machine.derivative(now, y, derivative);
                while now < end {
                    let h = control.step.min(end - now);
                    let error = method.step(machine.rates(), now, (y, derivative), h, scale, next) / *tolerance;
                    if control.judge(error, h, *longest) {
                        now = if h < end - now { now + h } else { end };
                        y.copy_from_slice(next);
                        derivative.copy_from_slice(method.last_derivative());
                    } else if control.step < SHORTEST_STEP {
                        return None;
                    }
                }
            }
        }
        Some(())
    }
}
