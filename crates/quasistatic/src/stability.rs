//! Stability of the ring against a small push, and the stable equilibrium beside an unstable one.
//!
//! With its balls in balance the ring resists displacements by the stiffness K = −dF/dq. Friction makes K
//! unsymmetric, and gyroscopic moments may make it negative: in M q̈ = −K q an eigenvalue of M⁻¹ K with a negative real
//! part is a ring that runs away. The sign hangs little on M; tilts count here by the pitch radius. Source for the
//! criterion: H. Ziegler, Principles of Structural Stability, Blaisdell 1968, chapter 2 (static instability).

use crate::block::{BlockState, BlockSystem, Iterate, RING};
use crate::condensed::{StiffnessMatrix, condensed};
use crate::driver;
use crate::jones_harris::Typical;
use crate::methods::NewtonOrNested;
use crate::problem::QuasiStaticError;
use crate::relax::relax;
use crate::settle::FROM_AFAR;
use nalgebra::{DMatrix, SMatrix, linalg::Schur};
use tribodyn_bearing::{OperatingPoint, RingFreedom};

/// Least eigenvalue over the largest that is rounding of a ring which moves freely.
const NEUTRAL: f64 = -1e-6;
/// The same above which the slopes of the last step are enough to tell.
const CLEAR: f64 = 1e-3;
/// Pushes of the ring off an unstable equilibrium, over the approach of a typical contact.
const PUSHES: [f64; 4] = [0.1, -0.1, 1.0, -1.0];
/// Residual at which pseudo-time gives way to Newton's method.
const RELAXED: f64 = 1e-7;

/// Least real part of the eigenvalues of a stiffness in the free freedoms of the ring, over the largest magnitude:
/// negative where the ring runs away. Tilts count by a lever in m. Absent where nothing is free or nothing resists.
pub fn ring_stability(stiffness: &StiffnessMatrix, ring: &[RingFreedom; RING], lever: f64) -> Option<f64> {
    let free: Vec<usize> = (0..RING).filter(|k| matches!(ring[*k], RingFreedom::Loaded(_))).collect();
    let arm = |k: usize| if k < 3 { 1.0 } else { lever };
    let entry = |row: usize, column: usize| {
        let (row, column) = (free[row], free[column]);
        stiffness[row][column] / (arm(row) * arm(column))
    };
    let matrix = DMatrix::from_fn(free.len(), free.len(), entry);
    let size = matrix.amax();
    // The iteration for eigenvalues would not end on NaN.
    if free.is_empty() || size == 0.0 || !size.is_finite() || matrix.iter().any(|k| k.is_nan()) {
        return None;
    }
    let values = Schur::try_new(matrix / size, f64::EPSILON, 1000)?.complex_eigenvalues();
    let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
    let least = values.iter().fold(f64::INFINITY, |least: f64, value| least.min(value.re));
    (largest > 0.0).then(|| least / largest)
}

/// True if a stability as [`ring_stability`] has it is that of a ring which stays.
pub fn is_stable(stability: f64) -> bool {
    stability >= NEUTRAL
}

/// The equilibrium with a judgement of its stability: a stable one beside it where it is not stable itself and one is
/// found.
pub(crate) fn steadied<S: BlockSystem>(
    system: &S,
    mut solved: Iterate,
    typical: &Typical,
    point: &OperatingPoint,
) -> Iterate {
    let of = |stiffness: &StiffnessMatrix| ring_stability(stiffness, system.ring(), typical.radius);
    let at_hand = solved.stiffness.and_then(|stiffness| of(&stiffness.transpose().into()));
    if at_hand.is_some_and(|least| least > CLEAR) {
        solved.stable = Some(true);
        return solved;
    }
    let exact = |state: &BlockState| -> Result<_, QuasiStaticError> { condensed(system, state) };
    let Ok(stiffness) = exact(&solved.state) else { return solved };
    solved.statistics.jacobians += 1;
    solved.stable = of(&stiffness).map(is_stable);
    if solved.stable != Some(false) {
        return solved;
    }
    let (tolerance, limit) = (point.numerics.tolerance, point.numerics.max_iterations);
    for start in pushed(system, &solved.state, &stiffness, typical) {
        let relaxed = relax(system, start, RELAXED, FROM_AFAR, 2 * limit);
        let method = NewtonOrNested::new(0.1 * tolerance, 0);
        let mut other = driver::run(system, Iterate::new(system, relaxed), method, tolerance, limit);
        let stable = other.worst().residual <= tolerance
            && exact(&other.state).is_ok_and(|stiffness| of(&stiffness).is_some_and(is_stable));
        solved.statistics = solved.statistics + other.statistics;
        solved.statistics.rescues += 1;
        if stable {
            (other.statistics, other.stable) = (solved.statistics, Some(true));
            return other;
        }
    }
    solved
}

/// States off an unstable equilibrium, along the direction in which least resists.
fn pushed<'a, S: BlockSystem>(
    system: &'a S,
    state: &'a BlockState,
    stiffness: &StiffnessMatrix,
    typical: &Typical,
) -> impl Iterator<Item = BlockState> + 'a {
    let arm: [f64; RING] = std::array::from_fn(|k| if k < 3 { 1.0 } else { typical.radius });
    let free = |k: usize| matches!(system.ring()[k], RingFreedom::Loaded(_));
    let symmetric =
        SMatrix::<f64, RING, RING>::from_fn(|row, column| match (free(row) && free(column), row == column) {
            (true, _) => 0.5 * (stiffness[row][column] + stiffness[column][row]) / (arm[row] * arm[column]),
            // A held freedom resists more than all others.
            (false, true) => f64::MAX.sqrt(),
            (false, false) => 0.0,
        });
    let eigen = symmetric.symmetric_eigen();
    let direction = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
    let approach = 1.5 * typical.force / typical.stiffness;
    PUSHES.into_iter().map(move |push| {
        let mut start = state.clone();
        (0..RING).for_each(|k| start.ring[k] += push * approach * direction[k] / arm[k]);
        start
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use RingFreedom::{Held, Loaded};

    const FREE: [RingFreedom; RING] = [Loaded(0.0); RING];

    fn diagonal(values: [f64; RING]) -> StiffnessMatrix {
        std::array::from_fn(|row| std::array::from_fn(|column| if row == column { values[row] } else { 0.0 }))
    }

    #[test]
    fn limit_the_least_spring_decides() {
        let stiffness = diagonal([1e8, 1e8, -5e6, 1e8 * 0.01, 1e8 * 0.01]);
        let least = ring_stability(&stiffness, &FREE, 0.1).unwrap();
        assert!((least + 0.05).abs() < 1e-12 && !is_stable(least), "{least}");
        // Held there, the ring stays.
        let mut held = FREE;
        held[2] = Held(0.0);
        assert!((ring_stability(&stiffness, &held, 0.1).unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(ring_stability(&stiffness, &[Held(0.0); RING], 0.1), None);
        assert_eq!(ring_stability(&diagonal([0.0; RING]), &FREE, 0.1), None);
    }

    /// Cross-coupling against a damped spring: the eigenvalues of [[1, c], [−c, 1]] are 1 ± i c, of [[1, c], [c, 1]]
    /// 1 ± c.
    #[test]
    fn limit_coupling_of_opposite_signs_does_not_run_away() {
        let coupled = |a: f64, b: f64| {
            let mut stiffness = diagonal([1.0; RING]);
            (stiffness[0][1], stiffness[1][0]) = (a, b);
            ring_stability(&stiffness, &FREE, 1.0).unwrap()
        };
        assert!(is_stable(coupled(2.0, -2.0)) && !is_stable(coupled(2.0, 2.0)));
    }
}
