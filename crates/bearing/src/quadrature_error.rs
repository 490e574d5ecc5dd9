//! Quadrature error of the patch rule of a bearing.

use crate::bearing::Bearing;
use crate::contact::BallLoads;
use crate::elastic::ElasticPatches;
use crate::races::Side;
use tribodyn_traction::{
    ElasticProbe, Law, PatchRule, Probe, RuleUse, TractionError, choose_rule, fastsim_rule_error, rule_error,
};

impl Bearing {
    /// The contacts where a rule is judged: those of the most, the middle and the least loaded ball. None without
    /// tribology.
    pub fn probes(&self, mut loads: Vec<BallLoads>) -> Vec<(Side, Probe<'_, Law>)> {
        let Some(tribology) = self.tribology.as_ref().filter(|_| !loads.is_empty()) else { return Vec::new() };
        loads.sort_by(|a, b| a.contacts.inner.normal.load.total_cmp(&b.contacts.inner.normal.load));
        let picked = [0, loads.len() / 2, loads.len() - 1];
        picked
            .iter()
            .flat_map(|&k| Side::BOTH.map(|side| (side, loads[k].contacts[side])))
            .filter(|(_, contact)| contact.normal.load > 0.0)
            .map(|(side, contact)| {
                let probe = Probe {
                    patch: self.patch(&self.races[side], &contact.ellipse),
                    motion: contact.motion,
                    rolling_speed: contact.rolling_speed,
                    law: tribology.patch_law(&tribology.laws[side]),
                };
                (side, probe)
            })
            .collect()
    }

    /// The rule with the fewest points that keeps a target error at these loads, and its error; none for elastic
    /// patches, which have their own strips and cells.
    ///
    /// # Errors
    /// A target that no rule keeps.
    pub fn choose_rule(
        &self,
        relative: f64,
        loads: Vec<BallLoads>,
        by: RuleUse,
    ) -> Result<Option<(PatchRule, f64)>, TractionError> {
        if self.elastic.is_some() {
            return Ok(None);
        }
        choose_rule(relative, &self.rigid_probes(loads), by).map(Some)
    }

    fn rigid_probes(&self, loads: Vec<BallLoads>) -> Vec<Probe<'_, Law>> {
        self.probes(loads).into_iter().map(|(_, probe)| probe).collect()
    }

    /// Estimated error of patch integrals over the load, against a finer rule: of `rule`, or of the strips and cells of
    /// elastic patches.
    ///
    /// # Errors
    /// A rule that cannot be laid out.
    pub fn patch_error(&self, rule: PatchRule, loads: Vec<BallLoads>) -> Result<f64, TractionError> {
        let Some(ElasticPatches { grid, pairs }) = &self.elastic else {
            return rule_error(rule, &self.rigid_probes(loads));
        };
        let probes = self.probes(loads);
        let elastic = |(side, contact): (Side, _)| ElasticProbe { contact, elasticity: &pairs[side] };
        fastsim_rule_error(grid.rule(), &probes.into_iter().map(elastic).collect::<Vec<_>>())
    }
}
