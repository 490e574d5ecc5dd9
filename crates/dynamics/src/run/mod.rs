//! A run: stepping, samples, events, wear, and what can be saved and taken up again.

mod after;
mod blame;
mod choice;
mod companion;
mod filter;
mod resume;
mod scales;
mod spalls;
mod step;

pub use choice::{StepChoice, StepErrors};
pub use companion::{ACCELERATION_PART, AccelerationError};
pub use filter::FilterBands;

use crate::error::DynamicsError;
use crate::fast::{Fast, Room};
use crate::forces::System;
use crate::machine::{Kernel, Machine};
use crate::observer::{BallDetail, Observer};
use crate::sample::Sample;
use crate::start::{StartMotion, Started, start};
use crate::stiffness::Stiffness;
use crate::traction_errors::errors;
use blame::Looked;
use choice::Trials;
use filter::{Filter, FilterMemory, steps_of_sample};
use scales::scales;
use serde::{Deserialize, Serialize};
use spalls::OverSpall;
use tribodyn_bearing::{Races, RunInputs, RunOptions};
use tribodyn_numerics::{DormandPrince, Rk4, StepControl};
use tribodyn_quasistatic::Solution;
use tribodyn_traction::{PatchRule, Quadrature};
use tribodyn_wear::Raceway;

/// A transient run.
pub struct Run {
    machine: Machine,
    scheme: Scheme,
    /// How the step was chosen, where an accuracy was asked for.
    choice: Option<StepChoice>,
    duration: f64,
    state_rate: f64,
    balls_every: u64,
    /// Relative tolerance of the solution at the start.
    tolerance: f64,
    filter: Filter,
    progress: Checkpoint,
    /// State and derivative at the end of a step.
    next: Vec<f64>,
    next_derivative: Vec<f64>,
    scale: Vec<f64>,
    start: Vec<f64>,
    solution: Solution,
    /// Room in which samples are put together.
    room: Room,
    /// The state of the last sample.
    shown: Vec<f64>,
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
    /// Elastic energy that wear has taken out of the contacts, J.
    wear_work: f64,
    raceways: Races<Raceway>,
    loaded: Vec<Races<bool>>,
    /// Balls that are over a spall.
    over_spalls: Vec<OverSpall>,
    through: Races<bool>,
    control: StepControl,
    fast: Fast,
    /// Work put in, lost and put in by magnitude, J, up to the last sample of the fast scheme, and their rates there,
    /// W.
    work: [f64; 3],
    rates: [f64; 3],
    filter: FilterMemory,
    /// Looks at stiffness and coating come by the number of steps, and what they saw last goes into steps and samples.
    statistics: Statistics,
    stiffness: Stiffness,
    thinnest: Races<f64>,
    /// The shortest of the longest stable steps that were found below the run's own, s.
    beyond: Option<f64>,
    looked: Looked,
}

/// Counts of the scheme's steps, force evaluations and patches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Statistics {
    /// Steps kept.
    pub steps: u64,
    /// Steps rejected by the error control.
    pub rejected: u64,
    /// Steps cut where a ball met or left its pocket wall.
    pub cut_at_pocket: u64,
    /// Evaluations of all forces.
    #[serde(rename = "force_evaluations")]
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

impl Scheme {
    /// A scheme with its step, which `choose` finds by an accuracy where one is asked for.
    fn new(
        scheme: tribodyn_bearing::Scheme,
        state_rate: f64,
        choose: impl FnOnce(f64) -> StepChoice,
    ) -> (Self, Option<StepChoice>) {
        let fast = |step| Self::Fast { step: 1.0 / (state_rate * steps_of_sample(step, state_rate)) };
        match scheme {
            tribodyn_bearing::Scheme::RungeKutta4 { step } => (Self::Rk4 { step, method: Rk4::default() }, None),
            tribodyn_bearing::Scheme::Fast { step } => (fast(step), None),
            tribodyn_bearing::Scheme::FastTo { accuracy } => {
                let choice = choose(accuracy);
                (fast(choice.step_s), Some(choice))
            }
            tribodyn_bearing::Scheme::DormandPrince { tolerance, longest } => {
                (Self::DormandPrince { tolerance, longest, method: DormandPrince::default() }, None)
            }
        }
    }
}

/// How a run ended.
#[must_use = "a run that was stopped or whose step is unstable ends without an error"]
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending {
    /// At its duration.
    Complete,
    /// At its duration, but its fixed step was beyond the stability of the scheme on the way: numbers may be wrong
    /// without another sign.
    BeyondStability {
        /// The step, s.
        step_s: f64,
        /// The shortest of the longest stable steps that were found, s.
        limit_s: f64,
    },
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

/// Steps between checks of balls that leave and, but for the fast scheme, of the stiffness.
const CHECK_EVERY: u64 = 1000;
/// The same for the fast scheme, which integrates all patches for a check; friction does not bound its step.
const FAST_CHECK_EVERY: u64 = 8 * CHECK_EVERY;
/// Steps between checks of the thinnest coating.
const WEAR_CHECK_EVERY: u64 = 64;
/// Distance from its place at which a ball counts as thrown out, in ball diameters.
const THROWN_OUT: f64 = 0.1;
/// Error of the patch rule over the load above which accelerations and pocket forces are not to be trusted: they
/// scatter by a quarter until it is about 1e-5, and the cage speed does not change with it.
pub const ACCELERATION_ERROR: f64 = 1e-4;
/// First step of the adaptive scheme, s: the paper's.
const FIRST_STEP: f64 = 1e-6;
/// Shortest step of any scheme, s; the adaptive one gives up there.
const SHORTEST_STEP: f64 = 1e-12;
/// Nearest to either end of a step that a pocket event is worth a cut, as a part of the step.
const CUT_MARGIN: f64 = 1e-6;

impl Run {
    /// The same run with traction integrated node by node by the generic quadrature: the plain reference of the fast
    /// kernel.
    ///
    /// # Errors
    /// [`DynamicsError`] for a rule that no quadrature can be made of.
    pub fn with_plain_kernel(mut self) -> Result<Self, DynamicsError> {
        self.machine.kernel = Kernel::Plain(Quadrature::new(self.machine.kernel.rule())?);
        self.begin();
        Ok(self)
    }

    /// A run from its start: an equilibrium, or a standstill.
    ///
    /// # Errors
    /// [`DynamicsError`] where nothing holds the outer ring, there is no quasi-static solution to start from, or the
    /// step is too short to come to an end or too long for friction that the scheme takes explicitly.
    pub fn new(inputs: RunInputs) -> Result<Self, DynamicsError> {
        Self::from_start(inputs, None)
    }

    /// A run from a motion.
    ///
    /// # Errors
    /// As [`Run::new`]; [`DynamicsError::Balls`].
    pub fn moving(inputs: RunInputs, motion: StartMotion) -> Result<Self, DynamicsError> {
        Self::from_start(inputs, Some(motion))
    }

    fn from_start(inputs: RunInputs, motion: Option<StartMotion>) -> Result<Self, DynamicsError> {
        let RunOptions { duration, scheme, state_rate, ball_rate, .. } = inputs.options;
        step::refuse_no_end(scheme)?;
        let (patch, linear_error) = errors(scheme, inputs.patch);
        let tolerance = inputs.numerics.tolerance;
        let Started { mut machine, state, solution } = start(RunInputs { patch, ..inputs }, motion)?;
        let trials = Trials { machine: &machine, start: 0.0, state: &state, linear_error, rate: state_rate, duration };
        let (scheme, choice) = Scheme::new(scheme, state_rate, |accuracy| trials.choose(accuracy));
        if let Scheme::Fast { step } = scheme {
            machine.thicken_pocket_film(step);
        }
        let filter = Filter::new(FilterBands::new(scheme.named(), state_rate))?;
        let stiffness = machine.stiffness(0.0, &state);
        let progress = Checkpoint {
            time: 0.0,
            steps: 0,
            samples: 0,
            derivative: vec![0.0; state.len()],
            energy_at_start: machine.energy(0.0, &state),
            worn: [0.0; 3],
            wear_work: 0.0,
            raceways: machine.raceways.clone(),
            loaded: vec![Races::default(); machine.layout.balls],
            over_spalls: Vec::new(),
            through: Races::default(),
            control: StepControl::new(FIRST_STEP),
            fast: Fast::with_linear_error(linear_error),
            work: [0.0; 3],
            rates: [0.0; 3],
            filter: filter.at_start(machine.layout, &state),
            statistics: Statistics::default(),
            stiffness,
            thinnest: machine.thinnest,
            beyond: None,
            looked: Looked { time: 0.0, state: state.clone() },
            state: state.clone(),
        };
        let mut run = Self {
            scheme,
            choice,
            duration,
            state_rate,
            tolerance,
            balls_every: (state_rate / ball_rate).round().max(1.0) as u64,
            filter,
            next: state.clone(),
            next_derivative: state.clone(),
            scale: scales(&machine, &state),
            start: state,
            solution,
            room: Room::default(),
            shown: Vec::new(),
            progress,
            machine,
        };
        run.begin();
        run.refuse_unstable_friction()?;
        Ok(run)
    }

    /// Derivative and contacts at the present state.
    fn begin(&mut self) {
        let p = &mut self.progress;
        self.machine.derivative(p.time, &p.state, &mut p.derivative);
        p.loaded = self.machine.watch.iter().map(|w| w.loaded).collect();
    }

    /// The state that [`Self::resume`] goes on from.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint { raceways: self.machine.raceways.clone(), thinnest: self.machine.thinnest, ..self.progress.clone() }
    }

    /// Simulated time, s.
    pub fn time(&self) -> f64 {
        self.progress.time
    }

    /// Duration of the run, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// The solution from which the run starts.
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    /// The bound on explicit steps at the last look.
    pub fn stiffness(&self) -> Stiffness {
        self.progress.stiffness
    }

    /// Longest step of the run's scheme by that bound, s.
    fn longest_step(&self) -> f64 {
        match self.scheme {
            Scheme::Fast { .. } => self.progress.stiffness.fast_step_s,
            _ => self.progress.stiffness.runge_kutta_step_s,
        }
    }

    /// The patch rule of the run.
    pub fn patch_rule(&self) -> PatchRule {
        self.machine.kernel.rule()
    }

    /// Counts of the scheme since the start, those before a checkpoint included.
    pub fn statistics(&self) -> Statistics {
        let [patches_integrated, patches_used] = self.progress.fast.patches();
        Statistics { patches_integrated, patches_used, ..self.progress.statistics }
    }

    /// Everything at the present time.
    pub fn sample(&self) -> Sample {
        let (p, l, mut room) = (&self.progress, self.machine.layout, Room::default());
        match self.scheme {
            Scheme::Fast { .. } => {
                let mut shown = Vec::new();
                p.fast.show(l, &p.state, &mut shown);
                self.sample_at(p.time, &shown, (BallDetail::All, &mut room))
            }
            _ => self.sample_at(p.time, &p.state, (BallDetail::All, &mut room)),
        }
    }

    fn sample_at(&self, t: f64, y: &[f64], (detail, room): (BallDetail, &mut Room)) -> Sample {
        let p = &self.progress;
        let so_far = (p.energy_at_start, p.worn);
        let machine = &self.machine;
        let balls = match self.scheme {
            Scheme::Fast { .. } if p.fast.has_forms() => p.fast.sample(machine, (t, y), (detail, room)),
            _ => machine.balls(t, y),
        };
        let mut sample = machine.sample((t, y), so_far, balls);
        [sample.inner.acceleration_m_s2, sample.outer.acceleration_m_s2] = p.filter.accelerations();
        sample.power.wear_work_j = p.wear_work;
        sample.power.imbalance_j -= p.wear_work;
        sample.cage.speed_filtered_rad_s = p.filter.cage_speed();
        sample
    }

    /// Runs to the end of the duration, or to `until` (s) where that is earlier.
    ///
    /// # Errors
    /// [`RunError`] of solver or observer; samples handed out before it are good.
    pub fn advance<O: Observer>(&mut self, until: f64, observer: &mut O) -> Result<Ending, RunError<O::Error>> {
        let ending = self.step_until(until, observer);
        self.progress.fast.settle(self.machine.layout);
        ending
    }

    fn step_until<O: Observer>(&mut self, until: f64, observer: &mut O) -> Result<Ending, RunError<O::Error>> {
        let end = until.min(self.duration);
        if self.progress.samples == 0 {
            self.warn_if_coarse(observer)?;
            self.warn_if_undersampled(observer)?;
            self.warn_if_stepping_over_spalls(observer)?;
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
        Ok(match (self.progress.beyond, self.step_s()) {
            (Some(limit_s), Some(step_s)) => Ending::BeyondStability { step_s, limit_s },
            _ => Ending::Complete,
        })
    }
}
