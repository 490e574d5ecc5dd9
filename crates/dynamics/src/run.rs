//! A run: stepping, samples, events, wear, and what can be saved and taken up again.

use crate::dp54::{DormandPrince, StepControl};
use crate::error::DynamicsError;
use crate::fast::Fast;
use crate::forces::System;
use crate::layout::{AXIAL, AZIMUTH, BALL, ORBIT, RADIUS, VELOCITY};
use crate::machine::{Kernel, Machine};
use crate::observer::{Event, EventKind, Observer};
use crate::rk4::Rk4;
use crate::sample::Sample;
use crate::start::{Started, start};
use crate::stiffness::Stiffness;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use tribodyn_bearing::Bearing;
use tribodyn_bearing::case::{Case, SchemeSpec};
use tribodyn_bearing::traction::{CoatingLaw, PatchRule, Quadrature, TractionLaw};
use tribodyn_bearing::wear::Raceway;
use tribodyn_quasistatic::Solution;

/// A transient run of a case.
pub struct Run<L = CoatingLaw> {
    machine: Machine<L>,
    scheme: Scheme,
    duration: f64,
    state_rate: f64,
    balls_every: u64,
    progress: Checkpoint,
    /// State and derivative at the end of a step.
    next: Vec<f64>,
    next_derivative: Vec<f64>,
    scale: Vec<f64>,
    stiffness: Stiffness,
    start: Vec<f64>,
    solution: Solution,
    warned: bool,
    statistics: Statistics,
}

/// Everything that changes during a run: save it, and [`Run::resume`] goes on from it to the same bytes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint {
    time: f64,
    /// Fixed steps made.
    steps: u64,
    /// Samples handed out.
    samples: u64,
    state: Vec<f64>,
    derivative: Vec<f64>,
    energy_at_start: f64,
    worn: [f64; 3],
    raceways: [Raceway; 2],
    loaded: Vec<[bool; 2]>,
    through: [bool; 2],
    control: StepControl,
    fast: Fast,
    /// Work put in, lost and put in by magnitude, J, up to the last sample of the fast scheme, and their rates there, W.
    work: [f64; 3],
    rates: [f64; 3],
}

/// What the scheme did.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Statistics {
    /// Steps kept.
    pub steps: u64,
    /// Steps rejected by the error control.
    pub rejected: u64,
    /// Steps cut where a ball met or left its pocket wall.
    pub cut_at_pocket: u64,
    /// Evaluations of all forces.
    pub evaluations: u64,
    /// Patches integrated by the fast scheme.
    pub patches_integrated: u64,
    /// Patches whose traction it used, most of them from the linear form.
    pub patches_used: u64,
}

enum Scheme {
    Rk4 { step: f64, method: Rk4 },
    Fast { step: f64 },
    DormandPrince { tolerance: f64, longest: f64, method: DormandPrince },
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// At its duration.
    Complete,
    /// The observer broke it off.
    Stopped,
}

/// Why a run broke off.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError<E> {
    /// The solver.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// The observer.
    #[error("{0}")]
    Observer(E),
}

/// Default rates where the case has no recording section: the rig's acquisition and a fifth of it, Hz.
const STATE_RATE: f64 = 25_600.0;
const BALL_RATE: f64 = 5_120.0;
/// Steps between looks at the stiffness and at balls that leave.
const LOOK_EVERY: u64 = 1000;
/// Steps between looks at the thinnest coating.
const WEAR_LOOK_EVERY: u64 = 64;
/// Distance from its place at which a ball counts as thrown out, in ball diameters.
const THROWN_OUT: f64 = 0.1;
/// First step of the adaptive scheme, s: the paper's.
const FIRST_STEP: f64 = 1e-6;
/// Shortest step of the adaptive scheme, s.
const SHORTEST_STEP: f64 = 1e-12;
/// Nearest to either end of a step that a pocket event is worth a cut, as a part of the step.
const CUT_MARGIN: f64 = 1e-6;

impl Run {
    /// A run of a case from its start.
    ///
    /// # Errors
    /// [`DynamicsError`] where the case lacks something or there is no quasi-static solution to start from.
    pub fn new(case: &Case) -> Result<Self, DynamicsError> {
        Self::with_bearing(case, Bearing::new(case)?)
    }
}

impl<L: TractionLaw> Run<L> {
    /// The same run with traction integrated node by node by the generic quadrature: the plain reference of the fast kernel.
    #[must_use]
    pub fn with_plain_kernel(mut self) -> Self {
        let rule = self.machine.kernel.rule();
        if let Ok(quadrature) = Quadrature::new(rule) {
            self.machine.kernel = Kernel::Plain(quadrature);
        }
        self.begin();
        self
    }

    /// A run with a bearing of one's own, with other traction laws for instance.
    ///
    /// # Errors
    /// As [`Run::new`].
    pub fn with_bearing(case: &Case, bearing: Bearing<L>) -> Result<Self, DynamicsError> {
        let Started { machine, state, solution } = start(case, bearing)?;
        let transient = case.transient.as_ref().ok_or(DynamicsError::Missing { path: "transient" })?;
        let (state_rate, ball_rate) = case.recording.map_or((STATE_RATE, BALL_RATE), |r| (r.state_rate, r.ball_rate));
        let scheme = match transient.scheme {
            SchemeSpec::RungeKutta4 { step } => Scheme::Rk4 { step, method: Rk4::default() },
            SchemeSpec::Fast { step } => Scheme::Fast { step: divides(step, state_rate) },
            SchemeSpec::DormandPrince { tolerance, longest } => {
                Scheme::DormandPrince { tolerance, longest, method: DormandPrince::default() }
            }
        };
        let progress = Checkpoint {
            time: 0.0,
            steps: 0,
            samples: 0,
            derivative: vec![0.0; state.len()],
            energy_at_start: machine.energy(0.0, &state),
            worn: [0.0; 3],
            raceways: machine.raceways.clone(),
            loaded: vec![[false; 2]; machine.layout.balls],
            through: [false; 2],
            control: StepControl::new(FIRST_STEP),
            fast: Fast::default(),
            work: [0.0; 3],
            rates: [0.0; 3],
            state: state.clone(),
        };
        let mut run = Self {
            scheme,
            duration: transient.duration,
            state_rate,
            balls_every: (state_rate / ball_rate).round().max(1.0) as u64,
            next: state.clone(),
            next_derivative: state.clone(),
            scale: scales(&machine, &state),
            stiffness: machine.stiffness(0.0, &state),
            start: state,
            solution,
            warned: false,
            statistics: Statistics::default(),
            progress,
            machine,
        };
        run.begin();
        Ok(run)
    }

    /// Derivative and contacts at the present state.
    fn begin(&mut self) {
        let p = &mut self.progress;
        self.machine.derivative(p.time, &p.state, &mut p.derivative);
        p.loaded = self.machine.watch.iter().map(|w| w.loaded).collect();
    }

    /// Goes on from a checkpoint of the same case.
    ///
    /// # Errors
    /// [`DynamicsError::Checkpoint`] for a checkpoint of another bearing.
    pub fn resume(&mut self, checkpoint: Checkpoint) -> Result<(), DynamicsError> {
        let (found, expected) = (checkpoint.state.len(), self.start.len());
        if found != expected || checkpoint.derivative.len() != expected {
            return Err(DynamicsError::Checkpoint { found, expected });
        }
        self.machine.raceways = checkpoint.raceways.clone();
        self.machine.thinnest = self.machine.raceways.each_ref().map(Raceway::thinnest);
        self.progress = checkpoint;
        Ok(())
    }

    /// What [`Self::resume`] needs.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint { raceways: self.machine.raceways.clone(), ..self.progress.clone() }
    }

    /// Simulated time, s.
    pub fn time(&self) -> f64 {
        self.progress.time
    }

    /// Duration of the run, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The quasi-static solution from which the run starts.
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The bound on explicit steps at the last look.
    pub fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    /// The patch rule of the run.
    pub fn patch_rule(&self) -> PatchRule {
        self.machine.kernel.rule()
    }

    /// What the scheme did so far.
    pub fn statistics(&self) -> Statistics {
        let [patches_integrated, patches_used] = self.progress.fast.patches();
        Statistics { patches_integrated, patches_used, ..self.statistics }
    }

    /// Everything at the present time.
    pub fn sample(&self) -> Sample {
        self.sample_at(self.progress.time, &self.progress.state)
    }

    fn sample_at(&self, t: f64, y: &[f64]) -> Sample {
        let p = &self.progress;
        let so_far = (p.energy_at_start, p.worn);
        let machine = &self.machine;
        match self.scheme {
            Scheme::Fast { .. } => {
                machine.sample((t, y), so_far, |index, patch| p.fast.traction(machine, index, patch))
            }
            _ => machine.sample((t, y), so_far, |_, patch| machine.kernel.traction(&machine.bearing, patch)),
        }
    }

    /// Runs to the end of the duration, or to `until` (s) where that is earlier.
    ///
    /// # Errors
    /// [`RunError`] of solver or observer; samples handed out before it are good.
    pub fn advance<O: Observer>(&mut self, until: f64, observer: &mut O) -> Result<Ending, RunError<O::Error>> {
        let end = until.min(self.duration);
        if self.progress.samples == 0 {
            let state = self.progress.state.clone();
            if self.hand_out(self.progress.time, &state, observer)?.is_break() {
                return Ok(Ending::Stopped);
            }
        }
        // A step that would leave a crumb of rounding before the end takes it along.
        while self.progress.time < end * (1.0 - 1e-14) {
            self.warn_if_stiff(observer)?;
            if self.one_step(end, observer)?.is_break() {
                return Ok(Ending::Stopped);
            }
        }
        Ok(Ending::Complete)
    }

    /// One step of the scheme, in pieces where a pocket is met.
    fn one_step<O: Observer>(&mut self, end: f64, observer: &mut O) -> Result<ControlFlow<()>, RunError<O::Error>> {
        let target = match &self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => (step * (self.progress.steps + 1) as f64).min(end),
            Scheme::DormandPrince { .. } => end,
        };
        loop {
            let t = self.progress.time;
            let h = self.try_step(target)?;
            let explicit = !matches!(self.scheme, Scheme::Fast { .. });
            let h = match self.pocket_event(h).filter(|_| explicit) {
                Some(cut) => {
                    self.statistics.cut_at_pocket += 1;
                    self.exact_step(cut * h)?;
                    cut * h
                }
                None => h,
            };
            let adaptive = matches!(self.scheme, Scheme::DormandPrince { .. });
            let reached = t + h >= target * (1.0 - 1e-15);
            let done = reached || adaptive;
            self.progress.steps += u64::from(done);
            let flow = self.accept(if reached { target } else { t + h }, observer)?;
            if flow.is_break() || done {
                return Ok(flow);
            }
        }
    }

    /// Steps towards `target`, to `self.next`; returns the length of the step.
    fn try_step<E>(&mut self, target: f64) -> Result<f64, RunError<E>> {
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
            self.statistics.rejected += 1;
            if self.progress.control.step < SHORTEST_STEP {
                let step_s = SHORTEST_STEP;
                return Err(DynamicsError::StepTooSmall { time_s: t, step_s, tolerance }.into());
            }
        }
    }

    /// A step of just this length; returns the error over the tolerance, 0 for the scheme that has none.
    fn exact_step<E>(&mut self, h: f64) -> Result<f64, RunError<E>> {
        let p = &self.progress;
        let start = (p.state.as_slice(), p.derivative.as_slice());
        let error = match &mut self.scheme {
            Scheme::Rk4 { method, .. } => {
                method.step(&mut self.machine, p.time, start, h, &mut self.next);
                self.machine.derivative(p.time + h, &self.next, &mut self.next_derivative);
                self.statistics.evaluations += 4;
                0.0
            }
            Scheme::Fast { .. } => {
                self.next.copy_from_slice(&p.state);
                let mut fast = std::mem::take(&mut self.progress.fast);
                let highest = self.stiffness.contact_frequency_hz;
                fast.step(&mut self.machine, self.progress.time, &mut self.next, h, highest);
                self.progress.fast = fast;
                self.statistics.evaluations += 1;
                0.0
            }
            Scheme::DormandPrince { method, tolerance, .. } => {
                let error = method.step(&mut self.machine, p.time, start, h, &self.scale, &mut self.next);
                self.next_derivative.copy_from_slice(method.last_derivative());
                self.statistics.evaluations += 6;
                return Ok(error / *tolerance);
            }
        };
        match self.next.iter().position(|v| !v.is_finite()) {
            None => Ok(error),
            Some(at) => Err(self.not_finite(at, h).into()),
        }
    }

    fn not_finite(&self, at: usize, step_s: f64) -> DynamicsError {
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
        DynamicsError::NotFinite {
            what,
            time_s: self.progress.time,
            step_s,
            limit_s: self.stiffness.runge_kutta_step_s,
        }
    }

    /// The part of the step after which the first ball meets or leaves its pocket wall.
    fn pocket_event(&self, h: f64) -> Option<f64> {
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

    /// Takes the step to time `t`: samples on the way, events, wear.
    fn accept<O: Observer>(&mut self, t: f64, observer: &mut O) -> Result<ControlFlow<()>, RunError<O::Error>> {
        self.statistics.steps += 1;
        let from = self.progress.time;
        self.pocket_events(t, observer)?;
        let flow = self.samples_within(from, t, observer)?;
        std::mem::swap(&mut self.progress.state, &mut self.next);
        std::mem::swap(&mut self.progress.derivative, &mut self.next_derivative);
        self.progress.time = t;
        self.deposit(t - from, observer)?;
        self.contact_events(observer)?;
        if self.statistics.steps % LOOK_EVERY == 0 {
            self.look()?;
        }
        Ok(flow)
    }

    fn samples_within<O: Observer>(
        &mut self,
        from: f64,
        to: f64,
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        loop {
            let at = self.progress.samples as f64 / self.state_rate;
            if at > to * (1.0 + 1e-14) {
                return Ok(ControlFlow::Continue(()));
            }
            let h = to - from;
            let s = (at - from) / h;
            // The fast scheme knows no derivatives; its steps end at the samples.
            let at_the_end = (s - 1.0).abs() < 1e-9 || matches!(self.scheme, Scheme::Fast { .. });
            let state: Vec<f64> = if at_the_end {
                self.next.clone()
            } else {
                let p = &self.progress;
                (0..self.next.len())
                    .map(|i| {
                        let slopes = [p.derivative[i] * h, self.next_derivative[i] * h];
                        hermite(s, [p.state[i], self.next[i]], slopes)
                    })
                    .collect()
            };
            if self.hand_out(at, &state, observer)?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }

    fn hand_out<O: Observer>(
        &mut self,
        t: f64,
        state: &[f64],
        observer: &mut O,
    ) -> Result<ControlFlow<()>, RunError<O::Error>> {
        let mut sample = self.sample_at(t, state);
        if matches!(self.scheme, Scheme::Fast { .. }) {
            self.add_work(&mut sample);
        }
        let with_balls = self.progress.samples % self.balls_every == 0;
        self.progress.samples += 1;
        observer.sample(&sample, with_balls).map_err(RunError::Observer)
    }

    /// The fast scheme has no powers of its own order within its steps: work is summed by the trapezium rule over samples.
    fn add_work(&mut self, sample: &mut Sample) {
        let p = &sample.power;
        let rates = [p.put_in(), p.lost(), p.shaft_w.abs() + p.load_w.abs()];
        if self.progress.samples > 0 {
            let half = 0.5 / self.state_rate;
            (0..3).for_each(|k| self.progress.work[k] += half * (rates[k] + self.progress.rates[k]));
        }
        self.progress.rates = rates;
        let [put_in, lost, throughput] = self.progress.work;
        sample.power.imbalance_j = put_in - lost - (sample.power.energy_j - self.progress.energy_at_start);
        sample.power.throughput_j = throughput;
    }

    fn pocket_events<O: Observer>(&self, t: f64, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let l = self.machine.layout;
        let pocket = &self.machine.cage.pocket;
        let lead = |y: &[f64], k: usize| self.machine.lead(k, &y[l.ball(k)..], y[l.cage()]);
        for ball in 0..l.balls {
            let (before, after) = (lead(&self.progress.state, ball), lead(&self.next, ball));
            if pocket.penetration(before) > 0.0 || pocket.penetration(after) <= 0.0 {
                continue;
            }
            let b = &self.next[l.ball(ball)..][..BALL];
            let kind = EventKind::Impact {
                ball,
                azimuth_deg: degrees(b[AZIMUTH]),
                closing_speed_m_s: (b[ORBIT] - self.next[l.cage() + 1]) * pocket.radius * after.signum(),
                ball_leads: after > 0.0,
            };
            observer.event(&Event { time_s: t, kind }).map_err(RunError::Observer)?;
        }
        Ok(())
    }

    /// Contacts lost and made since the last step.
    fn contact_events<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        for ball in 0..self.machine.layout.balls {
            for side in 0..2 {
                let now = self.machine.watch[ball].loaded[side];
                if now == self.progress.loaded[ball][side] {
                    continue;
                }
                self.progress.loaded[ball][side] = now;
                let azimuth_deg = degrees(self.progress.state[self.machine.layout.ball(ball) + AZIMUTH]);
                let inner = side == 0;
                let kind = if now {
                    EventKind::ContactMade { ball, inner, azimuth_deg }
                } else {
                    EventKind::ContactLost { ball, inner, azimuth_deg }
                };
                observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)?;
            }
        }
        Ok(())
    }

    /// Wear of a step of length `h` at the rates of its end.
    fn deposit<O: Observer>(&mut self, h: f64, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let l = self.machine.layout;
        for ball in 0..l.balls {
            let watch = self.machine.watch[ball];
            (0..3).for_each(|k| self.progress.worn[k] += watch.wear[k] * h);
            if self.machine.wear_acceleration == 0.0 {
                continue;
            }
            for side in 0..2 {
                let volume = watch.wear[side] * h * self.machine.wear_acceleration;
                let angle = self.progress.state[l.angles() + side];
                let azimuth = self.progress.state[l.ball(ball) + AZIMUTH] - angle;
                self.machine.raceways[side].remove(azimuth, volume, watch.semi_lateral[side]);
            }
        }
        if self.machine.wear_acceleration == 0.0 || self.statistics.steps % WEAR_LOOK_EVERY != 0 {
            return Ok(());
        }
        for side in 0..2 {
            self.machine.thinnest[side] = self.machine.raceways[side].thinnest();
            if self.progress.through[side] {
                continue;
            }
            if let Some(azimuth) = self.machine.raceways[side].worn_through() {
                self.progress.through[side] = true;
                let kind = EventKind::CoatingThrough { inner: side == 0, azimuth_deg: degrees(azimuth) };
                observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)?;
            }
        }
        Ok(())
    }

    /// Length of a whole step, s.
    fn step(&self) -> f64 {
        match self.scheme {
            Scheme::Rk4 { step, .. } | Scheme::Fast { step } => step,
            Scheme::DormandPrince { .. } => self.progress.control.step,
        }
    }

    /// Looks at stiffness and at balls that leave.
    fn look<E>(&mut self) -> Result<(), RunError<E>> {
        let step_s = self.step();
        let p = &self.progress;
        self.stiffness = self.machine.stiffness(p.time, &p.state);
        let l = self.machine.layout;
        let limit = THROWN_OUT * self.machine.bearing.geometry.ball_diameter;
        for ball in 0..l.balls {
            let off = |k: usize| p.state[l.ball(ball) + k] - self.start[l.ball(ball) + k];
            let distance = off(AXIAL).hypot(off(RADIUS));
            if distance > limit {
                return Err(DynamicsError::BallLost {
                    ball,
                    time_s: p.time,
                    distance_mm: distance * 1e3,
                    step_s,
                    limit_s: self.stiffness.runge_kutta_step_s,
                }
                .into());
            }
        }
        Ok(())
    }

    /// Says once that a fixed step is beyond the bound.
    fn warn_if_stiff<O: Observer>(&mut self, observer: &mut O) -> Result<(), RunError<O::Error>> {
        let Scheme::Rk4 { step, .. } = self.scheme else { return Ok(()) };
        let Stiffness { traction_rate_per_s, ball, contact_frequency_hz, runge_kutta_step_s } = self.stiffness;
        if self.warned || step <= runge_kutta_step_s {
            return Ok(());
        }
        self.warned = true;
        let message = format!(
            "the step of {step:.2e} s is beyond the stability of the Runge–Kutta method, {runge_kutta_step_s:.2e} s here (friction of ball {ball} decays at {traction_rate_per_s:.2e} per s, contacts vibrate at {contact_frequency_hz:.0} Hz): results may be wrong without a sign; shorten the step or use the fast scheme"
        );
        let kind = EventKind::Warning { message };
        observer.event(&Event { time_s: self.progress.time, kind }).map_err(RunError::Observer)
    }
}

/// Typical size of each unknown, what the error of the adaptive scheme is compared with.
fn scales<L: TractionLaw>(machine: &Machine<L>, state: &[f64]) -> Vec<f64> {
    let l = machine.layout;
    let speed = (0..l.balls).map(|k| state[l.ball(k) + ORBIT].abs()).fold(1.0, f64::max);
    let g = &machine.bearing.geometry;
    let spin = speed * g.pitch_diameter / g.ball_diameter;
    // Approaches are some 1e-5 m; a contact mode of 1e5 rad/s turns a hundredth of that into 1e-2 m/s.
    let (length, velocity) = (1e-5, 1e-2);
    let mut scale = vec![f64::INFINITY; l.len()];
    for k in 0..l.balls {
        let b = &mut scale[l.ball(k)..][..BALL];
        b.copy_from_slice(&[length, length, 1.0, velocity, velocity, speed, spin, spin, spin]);
        debug_assert_eq!(VELOCITY, 3);
    }
    scale[l.cage()..l.cage() + 2].copy_from_slice(&[1.0, speed]);
    scale[l.inner()..l.inner() + 6].copy_from_slice(&[length, length, length, velocity, velocity, velocity]);
    scale[l.outer()..l.outer() + 4].copy_from_slice(&[length, length, velocity, velocity]);
    scale[l.angles()..l.angles() + 2].fill(1.0);
    scale
}

/// Cubic through two values with their slopes over the interval, at `s` from 0 to 1.
fn hermite(s: f64, [a, b]: [f64; 2], [da, db]: [f64; 2]) -> f64 {
    let r = 1.0 - s;
    // Differences from a keep the digits of large values.
    a + (b - a) * s * s * (3.0 - 2.0 * s) + s * r * (da * r - db * s)
}

/// Where a function that is positive (or not) at 0 changes its sign in (0, 1).
fn bisect(f: impl Fn(f64) -> f64, positive_at_0: bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if (f(middle) > 0.0) == positive_at_0 { low = middle } else { high = middle }
    }
    high
}

/// The longest step of at most `step` that goes a whole number of times into the interval of the samples.
fn divides(step: f64, rate: f64) -> f64 {
    1.0 / (rate * (1.0 / (rate * step) - 1e-9).ceil().max(1.0))
}

fn degrees(azimuth: f64) -> f64 {
    azimuth.to_degrees().rem_euclid(360.0)
}
