//! Stiffness of the ring with the balls eliminated: the Schur complement of Newton's Jacobian.

use crate::block::{BlockState, BlockSystem, RING, linearise};
use crate::problem::QuasiStaticError;
use nalgebra::SMatrix;

/// Forces (N) and moments (N m) about X and Y against displacements x, y, z (m) and tilts about X and Y (rad), by row.
pub type StiffnessMatrix = [[f64; RING]; RING];

/// Displacements and tilts by unit forces and moments; none where one of them meets no resistance.
pub fn compliance(stiffness: &StiffnessMatrix) -> Option<StiffnessMatrix> {
    let inverse = SMatrix::<f64, RING, RING>::from(*stiffness).try_inverse()?;
    inverse.iter().all(|c| c.is_finite()).then(|| inverse.into())
}

/// −dF/dq with the balls eliminated.
pub(crate) fn condensed<S: BlockSystem>(system: &S, state: &BlockState) -> Result<StiffnessMatrix, QuasiStaticError> {
    let mut sum = SMatrix::<f64, RING, RING>::zeros();
    for (ball, block) in linearise(system, state).balls.iter().enumerate() {
        let by_ring = block.own.lu().solve(&block.by_ring).ok_or(QuasiStaticError::Singular { ball })?;
        sum -= block.ring - block.on_ring * by_ring;
    }
    Ok(sum.transpose().into())
}
