//! Tangential elasticity of the patches of a bearing.

use crate::races::{Races, Side};
use tribodyn_contact::ElasticBody;
use tribodyn_traction::{Fastsim, FastsimRule, TangentialElasticity, TractionError};

/// Tangential elasticity of the patches of a bearing.
#[derive(Debug, Clone)]
pub struct ElasticPatches {
    /// Strips and cells of every patch.
    pub grid: Fastsim,
    /// Ball and ring at each race.
    pub pairs: Races<TangentialElasticity>,
}

impl ElasticPatches {
    /// Patches between balls and rings of these elastic constants.
    ///
    /// # Errors
    /// Those of [`Fastsim::new`] and [`TangentialElasticity::of_bodies`].
    pub fn new(rule: FastsimRule, ball: &ElasticBody, rings: &Races<ElasticBody>) -> Result<Self, TractionError> {
        let pair = |side: Side| TangentialElasticity::of_bodies([*ball, rings[side]]);
        Ok(Self { grid: Fastsim::new(rule)?, pairs: Races { inner: pair(Side::Inner)?, outer: pair(Side::Outer)? } })
    }
}
