//! Strips and cells from a target error.

use super::elasticity::TangentialElasticity;
use super::fast::fast_elastic_patch_traction;
use super::grid::{Fastsim, FastsimRule};
use crate::choose::Probe;
use crate::{PatchTraction, TractionError, TractionLaw};

/// Candidates of [`choose_fastsim_rule`], by the work that they cost: those of a search (strips 3 to 24, cells 3 to 96)
/// that err least for their time at slip scales from 1 to 100 per m/s. Sixteen strips, twice eight, march side by side,
/// so that five to eight cost the same (`examples/elastic_cost.rs` measures some).
const CANDIDATES: [FastsimRule; 13] = [
    rule(4, 3),
    rule(4, 4),
    rule(4, 5),
    rule(8, 5),
    rule(8, 6),
    rule(8, 8),
    rule(8, 10),
    rule(8, 12),
    rule(8, 16),
    rule(16, 16),
    rule(16, 24),
    rule(16, 32),
    rule(24, 64),
];

/// The rule that estimates are made against.
const REFERENCE: FastsimRule = rule(32, 256);

const fn rule(across: usize, cells: usize) -> FastsimRule {
    FastsimRule { across, cells }
}

/// A contact at which a rule is judged, with the elasticity under it.
#[derive(Debug, Clone, Copy)]
pub struct ElasticProbe<'a, L> {
    /// The contact.
    pub contact: Probe<'a, L>,
    /// Elastic constants of both bodies.
    pub elasticity: &'a TangentialElasticity,
}

impl<L: TractionLaw> ElasticProbe<'_, L> {
    fn traction(&self, grid: &Fastsim) -> PatchTraction {
        let Probe { patch, motion, rolling_speed, law } = &self.contact;
        fast_elastic_patch_traction(grid, patch, motion, *rolling_speed, law, self.elasticity)
    }
}

/// Largest error of a rule over the probes against 64 strips of 256 cells: of the force over the load and of the
/// moment over load times ball radius.
///
/// # Errors
/// Those of [`Fastsim::new`].
pub fn fastsim_rule_error<L: TractionLaw>(
    rule: FastsimRule,
    probes: &[ElasticProbe<'_, L>],
) -> Result<f64, TractionError> {
    let exact = references(probes)?;
    Ok(largest_error(&Fastsim::new(rule)?, probes, &exact))
}

/// The cheapest candidate whose error over the probes is at most `relative`, and that error.
///
/// # Errors
/// [`TractionError::TargetNotReached`] where the finest candidate misses the target.
pub fn choose_fastsim_rule<L: TractionLaw>(
    relative: f64,
    probes: &[ElasticProbe<'_, L>],
) -> Result<(FastsimRule, f64), TractionError> {
    let exact = references(probes)?;
    let mut finest = f64::INFINITY;
    for rule in CANDIDATES {
        let error = largest_error(&Fastsim::new(rule)?, probes, &exact);
        if error <= relative {
            return Ok((rule, error));
        }
        finest = finest.min(error);
    }
    Err(TractionError::TargetNotReached { target: relative, reached: finest })
}

fn references<L: TractionLaw>(probes: &[ElasticProbe<'_, L>]) -> Result<Vec<PatchTraction>, TractionError> {
    let reference = Fastsim::new(REFERENCE)?;
    Ok(probes.iter().map(|probe| probe.traction(&reference)).collect())
}

fn largest_error<L: TractionLaw>(grid: &Fastsim, probes: &[ElasticProbe<'_, L>], exact: &[PatchTraction]) -> f64 {
    probes
        .iter()
        .zip(exact)
        .fold(0.0, |worst, (probe, exact)| worst.max(probe.contact.relative_error(&probe.traction(grid), exact)))
}
