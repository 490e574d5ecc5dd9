//! Stiffness of the inner ring on its steady orbit: how the mean forces of the balls on it grow with its displacement
//! while balls and cage keep to their equations. Newton's Jacobian with all else eliminated.
//!
//! The matrix is that of a finer mesh than the orbit's, and is checked in two ways: against that of a mesh half as
//! fine, which tells what pockets and contacts that open and close between its points leave undecided, and against
//! orbits that are solved under slightly more and less load, which tells whether it is the slope of the balances at
//! all.

use crate::OrbitError;
use crate::chain::{Linear, Step};
use crate::collocation::Orbit;
use crate::newton::Newton;
use crate::residual::{BORDER, STACK};
use crate::system::RING;
use nalgebra::{SMatrix, SVector};
use serde::Serialize;
use tribodyn_bearing::RingFreedom;
use tribodyn_quasistatic::{StiffnessMatrix, is_wrong_stiffness};

/// Reason of an error.
pub(crate) const DOUBT: &str =
    "another mesh or a slightly different load gives another one, as where balls just touch their pockets";
/// Displacement of the slightly other loads over the scale of displacements, which is a tenth of the elastic approach.
const NUDGE: f64 = 0.02;
/// Parts of the ring's five freedoms in those loads: all have one, none that of another.
const DIRECTION: [f64; RING] = [1.0, -0.7, 0.5, 0.8, 0.6];
/// Steps with the slopes of the orbit that lead to its neighbour, and Jacobians where they do not.
const CHORDS: usize = 20;
const PATIENCE: usize = 8;
/// Times that all intervals are halved, the difference that ends it, and intervals after which that is too long.
const HALVINGS: usize = 2;
const ENOUGH: f64 = 5e-4;
const MOST: usize = 700;
/// The same where there would be no answer, as balls often touch their pockets: the difference still falls then.
const MORE_HALVINGS: usize = 3;
const MOST_OF_MORE: usize = 1500;

/// Stiffness of the inner ring on a steady orbit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct OrbitStiffness {
    /// Mean forces (N) and moments (N m) against displacements x, y, z (m) and tilts (rad), by row.
    pub stiffness: StiffnessMatrix,
    /// Largest estimated error of an element over √(K_ii K_jj).
    pub error_estimate: f64,
    /// Sentences on what makes it doubtful.
    pub warnings: Vec<String>,
}

type Compliance = SMatrix<f64, RING, RING>;

/// Stiffness at a converged orbit. The ring is given unit loads, one after the other, however it is held.
///
/// # Errors
/// [`OrbitError::Singular`] where a displacement of the ring meets no resistance, [`OrbitError::Uncertain`] where the
/// matrix does not pass its checks.
pub(crate) fn stiffness(
    newton: &mut Newton<'_>,
    orbit: &Orbit,
    tolerance: f64,
) -> Result<(StiffnessMatrix, f64), OrbitError> {
    let found = newton.residual(orbit);
    let balls = newton.system.bearing.geometry.ball_count as f64;
    let loads: [f64; RING] = found.means.ring.map(|force| balls * force);
    newton.system.ring = loads.map(RingFreedom::Loaded);
    let mut of_mesh = f64::INFINITY;
    let linear = newton.linearise_exactly(orbit)?;
    let mut at = Slope::new(newton, orbit.clone(), linear)?;
    for halving in 1..=MORE_HALVINGS {
        if newton.watch.stops() {
            return Err(OrbitError::Ended);
        }
        let finer = halved(newton, &at.orbit);
        let met = newton.met(finer.clone(), (tolerance, PATIENCE));
        let is_met = met.is_some();
        let finer = met.map_or(finer, |(orbit, _)| orbit);
        let linear = newton.linearise_exactly(&finer)?;
        let next = Slope::new(newton, finer, linear)?;
        of_mesh = apart(&next.stiffness, &at.stiffness);
        if !is_met {
            // The orbit between the points of its own mesh says as much of the error, but has no balance.
            break;
        }
        at = next;
        let intervals = at.orbit.intervals();
        let is_long = halving >= HALVINGS || intervals > MOST;
        if of_mesh < ENOUGH || is_long && !is_wrong_stiffness(of_mesh) || intervals > MOST_OF_MORE {
            break;
        }
    }
    let Some(of_slopes) = along(newton, &at, &loads, tolerance) else {
        return Err(OrbitError::Uncertain { error_estimate: None });
    };
    let error = of_slopes.max(of_mesh);
    if is_wrong_stiffness(error) {
        return Err(OrbitError::Uncertain { error_estimate: Some(error) });
    }
    Ok((at.stiffness.transpose().into(), error))
}

/// Stiffness at a converged orbit on its own mesh, unchecked.
///
/// # Errors
/// [`OrbitError::Singular`].
pub(crate) fn slopes(newton: &mut Newton<'_>, orbit: &Orbit) -> Result<StiffnessMatrix, OrbitError> {
    newton.system.ring = [RingFreedom::Loaded(0.0); RING];
    let linear = newton.linearise_exactly(orbit)?;
    Ok(Slope::new(newton, orbit.clone(), linear)?.stiffness.transpose().into())
}

/// An orbit with its slopes.
struct Slope {
    orbit: Orbit,
    linear: Linear,
    compliance: Compliance,
    stiffness: Compliance,
}

impl Slope {
    fn new(newton: &Newton<'_>, orbit: Orbit, linear: Linear) -> Result<Self, OrbitError> {
        let compliance = compliance(newton, &linear);
        let stiffness = compliance.try_inverse().filter(|k| k.iter().all(|v| v.is_finite()));
        Ok(Self { orbit, linear, compliance, stiffness: stiffness.ok_or(OrbitError::Singular)? })
    }
}

/// An orbit on a mesh of halved intervals.
fn halved(newton: &Newton<'_>, orbit: &Orbit) -> Orbit {
    let halves = orbit.ends.windows(2).flat_map(|pair| [0.5 * (pair[0] + pair[1]), pair[1]]);
    let ends = [0.0].into_iter().chain(halves).collect();
    Orbit::of(&newton.radau, ends, (orbit.cage_speed, orbit.ring), |turn| orbit.at(&newton.radau, turn))
}

/// Displacements by loads, N and N m.
fn compliance(newton: &Newton<'_>, linear: &Linear) -> Compliance {
    let (scales, unloaded) = (newton.scales, vec![[0.0; STACK]; linear.intervals()]);
    let mut compliance = Compliance::zeros();
    for load in 0..RING {
        let mut border = [0.0; BORDER];
        border[1 + load] = 1.0 / scales.border_rows[1 + load];
        let step = linear.step(&unloaded, &border);
        (0..RING).for_each(|k| compliance[(k, load)] = step.border[1 + k] * scales.border[1 + k]);
    }
    compliance
}

/// Largest difference of two matrices over √(K_ii K_jj).
fn apart(a: &Compliance, b: &Compliance) -> f64 {
    let size = |i: usize, j: usize| (a[(i, i)] * a[(j, j)]).abs().sqrt();
    let of = |n: usize| (a[(n / RING, n % RING)] - b[(n / RING, n % RING)]).abs() / size(n / RING, n % RING);
    (0..RING * RING).map(of).fold(0.0, f64::max)
}

/// By how much the ring's displacement between slightly smaller and larger loads is not what the slopes say, over its
/// size; none where those orbits are not found.
fn along(
    newton: &mut Newton<'_>,
    Slope { orbit, linear, compliance, .. }: &Slope,
    loads: &[f64; RING],
    tolerance: f64,
) -> Option<f64> {
    let scales = newton.scales;
    // Loads that would each move the ring as far, so that stiff and soft freedoms all have their part.
    let size = |k: usize| scales.border[1 + k] / compliance[(k, k)].abs();
    let mut change = SVector::<f64, RING>::from_fn(|k, _| DIRECTION[k] * size(k));
    let over_scales =
        |moved: &SVector<f64, RING>| SVector::<f64, RING>::from_fn(|k, _| moved[k] / scales.border[1 + k]).norm();
    let longest = over_scales(&(compliance * change));
    change *= NUDGE / longest;
    let mut under = |sign: f64| {
        newton.system.ring = std::array::from_fn(|k| RingFreedom::Loaded(loads[k] + sign * change[k]));
        let near = chords(newton, orbit, linear, tolerance);
        near.or_else(|| newton.met(orbit.clone(), (tolerance, PATIENCE)).map(|(near, _)| near))
    };
    let [more, less] = [under(1.0), under(-1.0)];
    newton.system.ring = loads.map(RingFreedom::Loaded);
    let (more, less) = (more?, less?);
    let moved = SVector::<f64, RING>::from_fn(|k, _| 0.5 * (more.ring[k] - less.ring[k]));
    Some(over_scales(&(moved - compliance * change)) / NUDGE)
}

/// The orbit under other loads, by the slopes of this one; none where they do not lead to it.
fn chords(newton: &mut Newton<'_>, orbit: &Orbit, linear: &Linear, tolerance: f64) -> Option<Orbit> {
    let mut near = orbit.clone();
    for _ in 0..CHORDS {
        let residual = newton.residual(&near);
        if residual.worst.relative <= tolerance {
            return Some(near);
        }
        let step: Step = linear.step(&residual.intervals, &residual.border);
        near = newton.apply(&near, &step, 1.0);
    }
    None
}
