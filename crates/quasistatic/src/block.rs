//! Newton's method on a ring and its balls: small dense blocks per ball, eliminated onto the ring.
//!
//! Unknowns: six per ball (X1, X2, ω_a, ω_r, ω_t, ω_m) and five of the ring (x, y, z, tilt about X, tilt about Y), each
//! ring freedom loaded or held.
//! With J the exact Jacobian (dual numbers) and W positive weights, a step solves (J − μ W) Δ = −F, F being the forces
//! on each freedom: μ = 0 is Newton's method, μ > 0 steadies it where the potential is flat.

use nalgebra::{SMatrix, SVector};
use num_dual::DualSVec64;
use tribodyn_bearing::{RingFreedom, Scalar};

/// Degrees of freedom of the ring.
pub(crate) const RING: usize = 5;
/// Unknowns of a ball: X1, X2, the angular velocity ω relative to the orbiting frame (axial, radial, tangential), ω_m.
pub(crate) const BALL: usize = 6;
/// Where a ball's unknowns stand: X1, X2, the first of the three of Ï, ω_m.
pub(crate) const AXIAL: usize = 0;
pub(crate) const RADIAL: usize = 1;
pub(crate) const OMEGA: usize = 2;
pub(crate) const ORBIT: usize = 5;
const DERIVATIVES: usize = BALL + RING;

/// Forces on the unknowns of one ball, with what they are measured against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balance<D> {
    /// Force or moment on each unknown.
    pub residual: [D; BALL],
    /// Sum of the magnitudes of its terms.
    pub scale: [f64; BALL],
    /// Force and moment that the ring puts on this ball.
    pub ring: [D; RING],
    /// Magnitude of the force terms in each.
    pub ring_scale: [f64; RING],
}

/// A bearing's equilibrium in blocks. `
pub(crate) trait BlockSystem {
    fn ring(&self) -> &[RingFreedom; RING];
    /// The balances of one ball with first derivatives.
    fn ball<D: Scalar>(&self, index: usize, ball: [D; BALL], ring: [D; RING]) -> Balance<D>;
    /// The balances alone.
    fn ball_value(&self, index: usize, ball: [f64; BALL], ring: [f64; RING]) -> Balance<f64> {
        self.ball(index, ball, ring)
    }
    /// Weights W of the regularisation for ball and ring unknowns.
    fn weights(&self) -> ([f64; BALL], [f64; RING]);
    /// Inertia of the ball unknowns: what the forces on them accelerate; where zero the unknown follows at once.
    fn inertia(&self) -> [f64; BALL];
    /// Largest change of each unknown in one step.
    fn step_limits(&self) -> ([f64; BALL], [f64; RING]);
    /// A convex potential of which the forces are the negative gradient; zero where there is none.
    fn energy(&self, _state: &BlockState) -> f64 {
        0.0
    }
    /// False once the caller ends the search.
    fn goes_on(&self) -> bool {
        true
    }
}

/// Unknowns of all balls and of the ring.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct BlockState {
    pub balls: Vec<[f64; BALL]>,
    pub ring: [f64; RING],
}

/// The largest relative residual and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Worst {
    pub residual: f64,
    /// Ball index, or the ring.
    pub ball: Option<usize>,
    /// Which equation of the ball or the ring.
    pub equation: usize,
}

impl Worst {
    const NONE: Self = Self { residual: 0.0, ball: None, equation: 0 };

    fn take(&mut self, value: f64, scale: f64, ball: Option<usize>, equation: usize) {
        // A balance without any term is in balance; NaN must not hide.
        let relative = if value == 0.0 { 0.0 } else { value.abs() / scale };
        let residual = if relative.is_nan() { f64::INFINITY } else { relative };
        if residual > self.residual {
            *self = Self { residual, ball, equation };
        }
    }
}

/// Residuals without derivatives: what a trial step is judged by.
#[derive(Debug, Clone)]
pub(crate) struct Residuals {
    /// Forces on each ball, and the negative of what the ring puts on it.
    pub balls: Vec<(SVector<f64, BALL>, SVector<f64, RING>)>,
    /// Scales of the forces on each ball.
    pub ball_scales: Vec<[f64; BALL]>,
    /// Forces on the ring, and what they are measured against.
    pub ring: SVector<f64, RING>,
    pub ring_scale: [f64; RING],
    pub worst: Worst,
}

impl Residuals {
    pub fn new<S: BlockSystem>(system: &S, state: &BlockState) -> Self {
        let mut worst = Worst::NONE;
        let (mut ring, mut scale) = (external(system), SVector::<f64, RING>::zeros());
        let mut ball_scales = Vec::with_capacity(state.balls.len());
        let balls = state.balls.iter().enumerate().map(|(index, &ball)| {
            let balance = system.ball_value(index, ball, state.ring);
            for k in 0..BALL {
                worst.take(balance.residual[k], balance.scale[k], Some(index), k);
            }
            let on_ring = -SVector::from(balance.ring);
            ring += on_ring;
            scale += SVector::from(balance.ring_scale);
            ball_scales.push(balance.scale);
            (SVector::from(balance.residual), on_ring)
        });
        let balls = balls.collect();
        for (k, freedom) in system.ring().iter().enumerate() {
            if let RingFreedom::Loaded(load) = freedom {
                scale[k] += load.abs();
                worst.take(ring[k], scale[k], None, k);
            }
        }
        Self { balls, ball_scales, ring, ring_scale: scale.into(), worst }
    }
}

/// The linearised system at a state, with the balls' blocks ready for elimination.
#[derive(Debug, Clone)]
pub(crate) struct Linearised {
    pub balls: Vec<BallBlock>,
    pub ring_residual: SVector<f64, RING>,
}

/// Forces on a ball and slopes of these and of what it puts on the ring.
#[derive(Debug, Clone)]
pub(crate) struct BallBlock {
    pub residual: SVector<f64, BALL>,
    pub own: SMatrix<f64, BALL, BALL>,
    pub by_ring: SMatrix<f64, BALL, RING>,
    pub on_ring: SMatrix<f64, RING, BALL>,
    pub ring: SMatrix<f64, RING, RING>,
    /// One over the change of each unknown that shifts its own balance by the size of its terms.
    pub weight: (SVector<f64, BALL>, SVector<f64, RING>),
}

pub(crate) fn linearise<S: BlockSystem>(system: &S, state: &BlockState) -> Linearised {
    let seed = |value: f64, k: usize| {
        let mut direction = SVector::<f64, DERIVATIVES>::zeros();
        direction[k] = 1.0;
        DualSVec64::<DERIVATIVES>::new(value, num_dual::Derivative::some(direction))
    };
    let mut ring_residual = external(system);
    let ring: [DualSVec64<DERIVATIVES>; RING] = std::array::from_fn(|k| seed(state.ring[k], BALL + k));
    let balls = state.balls.iter().enumerate().map(|(index, ball)| {
        let unknowns: [DualSVec64<DERIVATIVES>; BALL] = std::array::from_fn(|k| seed(ball[k], k));
        let balance = system.ball(index, unknowns, ring);
        let slope = |value: &DualSVec64<DERIVATIVES>| {
            value.eps.unwrap_generic(nalgebra::Const::<DERIVATIVES>, nalgebra::Const::<1>).transpose()
        };
        let mut block = BallBlock {
            residual: SVector::from_fn(|k, _| balance.residual[k].re),
            own: SMatrix::zeros(),
            by_ring: SMatrix::zeros(),
            on_ring: SMatrix::zeros(),
            ring: SMatrix::zeros(),
            weight: (SVector::zeros(), SVector::zeros()),
        };
        for k in 0..BALL {
            let d = slope(&balance.residual[k]);
            block.own.set_row(k, &d.fixed_columns::<BALL>(0));
            block.by_ring.set_row(k, &d.fixed_columns::<RING>(BALL));
            block.weight.0[k] = block.own[(k, k)].abs() / balance.scale[k];
        }
        for k in 0..RING {
            let d = -slope(&balance.ring[k]);
            ring_residual[k] -= balance.ring[k].re;
            block.on_ring.set_row(k, &d.fixed_columns::<BALL>(0));
            block.ring.set_row(k, &d.fixed_columns::<RING>(BALL));
            block.weight.1[k] = block.ring[(k, k)].abs() / balance.ring_scale[k];
        }
        block
    });
    Linearised { balls: balls.collect(), ring_residual }
}

impl Linearised {
    /// Takes the residuals of another state and keeps the slopes.
    pub fn move_to(&mut self, residuals: &Residuals) {
        self.ring_residual = residuals.ring;
        for (block, &(residual, _)) in self.balls.iter_mut().zip(&residuals.balls) {
            block.residual = residual;
        }
    }
}

/// The external forces and moments on the ring.
fn external<S: BlockSystem>(system: &S) -> SVector<f64, RING> {
    let load = |freedom: &RingFreedom| if let RingFreedom::Loaded(load) = freedom { *load } else { 0.0 };
    SVector::from(system.ring().each_ref().map(load))
}

/// The change of all unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Step {
    pub balls: Vec<SVector<f64, BALL>>,
    pub ring: SVector<f64, RING>,
    /// Forces on the ring against its displacement with the balls eliminated, by rows; that of the step's slopes.
    pub stiffness: SMatrix<f64, RING, RING>,
}

/// A singular block: which ball (or the ring) has no unique step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Singular;

/// Shift taken off the diagonal of the Jacobian, for ball and ring unknowns.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shift {
    pub ball: [f64; BALL],
    pub ring: [f64; RING],
}

/// Solves (J − μ W) Δ = −F.
pub(crate) fn step<S: BlockSystem>(system: &S, linear: &Linearised, mu: f64) -> Result<Step, Singular> {
    let (ball_weight, ring_weight) = system.weights();
    // The tiny share keeps a ring without any stiffness (all loads zero) solvable; it vanishes against contacts.
    let shift = Shift { ball: ball_weight.map(|w| mu * w), ring: ring_weight.map(|w| (mu + 1e-13) * w) };
    step_with(system, linear, &shift)
}

/// Solves (J − shift) Δ = −F by eliminating the balls.
pub(crate) fn step_with<S: BlockSystem>(system: &S, linear: &Linearised, shift: &Shift) -> Result<Step, Singular> {
    let mut schur = SMatrix::<f64, RING, RING>::zeros();
    let mut right = -linear.ring_residual;
    let mut eliminated = Vec::with_capacity(linear.balls.len());
    for block in &linear.balls {
        let mut own = block.own;
        for k in 0..BALL {
            own[(k, k)] -= shift.ball[k];
        }
        let factors = own.lu();
        let by_ring = factors.solve(&block.by_ring).ok_or(Singular)?;
        let residual = factors.solve(&block.residual).ok_or(Singular)?;
        schur += block.ring - block.on_ring * by_ring;
        right += block.on_ring * residual;
        eliminated.push((by_ring, residual));
    }
    let stiffness = -schur;
    for (k, freedom) in system.ring().iter().enumerate() {
        match freedom {
            RingFreedom::Loaded(_) => schur[(k, k)] -= shift.ring[k],
            RingFreedom::Held(_) => {
                schur.set_row(k, &SMatrix::<f64, 1, RING>::zeros());
                schur.set_column(k, &SVector::<f64, RING>::zeros());
                schur[(k, k)] = 1.0;
                right[k] = 0.0;
            }
        }
    }
    let ring = schur.lu().solve(&right).ok_or(Singular)?;
    let balls = eliminated.iter().map(|(by_ring, residual)| -residual - by_ring * ring).collect::<Vec<_>>();
    let finite = ring.iter().all(|v| v.is_finite()) && balls.iter().flatten().all(|v: &f64| v.is_finite());
    if finite { Ok(Step { balls, ring, stiffness }) } else { Err(Singular) }
}

/// Adds a share of a step, shortened as a whole where any unknown would change by more than its limit.
pub(crate) fn apply<S: BlockSystem>(
    system: &S,
    state: &BlockState,
    Step { balls, ring, .. }: &Step,
    mut share: f64,
) -> BlockState {
    let (ball_limit, ring_limit) = system.step_limits();
    let mut limit = |change: f64, largest: f64| share = share.min(largest / change.abs().max(1e-300));
    for ball in balls {
        (0..BALL).for_each(|k| limit(ball[k], ball_limit[k]));
    }
    (0..RING).for_each(|k| limit(ring[k], ring_limit[k]));
    BlockState {
        balls: state
            .balls
            .iter()
            .zip(balls)
            .map(|(old, change)| std::array::from_fn(|k| old[k] + share * change[k]))
            .collect(),
        ring: std::array::from_fn(|k| state.ring[k] + share * ring[k]),
    }
}

/// Statistics of a solve: a wrong Jacobian converges too, only slower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SolverStatistics {
    /// Steps that were kept.
    pub accepted: usize,
    /// Steps that were tried again with more damping.
    pub rejected: usize,
    /// Jacobians of all balls and the ring together.
    pub jacobians: usize,
    /// Starts from other states where Newton's method found no way from the first one.
    pub rescues: usize,
}

impl std::ops::Add for SolverStatistics {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            accepted: self.accepted + other.accepted,
            rejected: self.rejected + other.rejected,
            jacobians: self.jacobians + other.jacobians,
            rescues: self.rescues + other.rescues,
        }
    }
}

/// A state on its way to equilibrium.
#[derive(Debug, Clone)]
pub(crate) struct Iterate {
    pub state: BlockState,
    pub residuals: Residuals,
    pub statistics: SolverStatistics,
    /// Stiffness of the ring by the slopes of the last step; none before the first one.
    pub stiffness: Option<SMatrix<f64, RING, RING>>,
    /// True if the equilibrium is stable; none where that was not judged.
    pub stable: Option<bool>,
}

impl Iterate {
    pub fn new<S: BlockSystem>(system: &S, mut state: BlockState) -> Self {
        for (value, freedom) in state.ring.iter_mut().zip(system.ring()) {
            if let RingFreedom::Held(held) = freedom {
                *value = *held;
            }
        }
        let residuals = Residuals::new(system, &state);
        Self { state, residuals, statistics: SolverStatistics::default(), stiffness: None, stable: None }
    }

    pub fn worst(&self) -> Worst {
        self.residuals.worst
    }

    /// Takes a step to a state with its residuals.
    pub fn keep(&mut self, state: BlockState, residuals: Residuals) {
        (self.state, self.residuals) = (state, residuals);
        self.statistics.accepted += 1;
    }
}
