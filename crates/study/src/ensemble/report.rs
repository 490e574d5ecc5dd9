//! Results of an ensemble, for people and programs.

use super::draw::Sampling;
use super::member::Member;
use super::quantiles::{Quantiles, quantiles, values};
use super::{Ensemble, Outcome};
use serde::Serialize;

/// A varied place of the case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Varied {
    /// Name of its column, with the unit.
    pub column: String,
    /// Place in the case.
    pub path: String,
    /// Its spread, as it was given.
    pub spread: String,
}

/// A member without figures.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FailedMember {
    /// Its number, from 0.
    pub member: usize,
    /// Why it has none.
    pub error: String,
}

/// Costs of the members.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cost {
    /// Threads that shared the members.
    pub threads: usize,
    /// Wall time of the ensemble, s, without members of an earlier run.
    pub wall_s: f64,
    /// Wall time of one member on its thread, s: the mean over those with figures.
    pub wall_per_member_s: Option<f64>,
    /// Processor time of one member, s: the mean over those with figures; none where the system does not tell it.
    pub processor_per_member_s: Option<f64>,
    /// Simulated time of all members, s.
    pub simulated_s: f64,
    /// Simulated time of the members over the wall time of the ensemble, without those of an earlier run.
    pub simulated_per_wall: f64,
    /// Simulated time of all members over their processor time.
    pub simulated_per_processor: Option<f64>,
}

/// The answer of an ensemble.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EnsembleReport {
    /// Name of the case file.
    pub case: String,
    /// Name of the bearing.
    pub bearing: String,
    /// Members that were asked for.
    pub members: usize,
    /// Members that are finished; fewer where the ensemble was stopped.
    pub finished: usize,
    /// Finished members that an earlier run had finished.
    pub resumed: usize,
    /// Finished members without figures.
    pub failed: usize,
    /// Seed of the draws.
    pub seed: u64,
    /// How the members lie in the space of the spreads.
    pub sampling: Sampling,
    /// Varied places.
    pub varied: Vec<Varied>,
    /// Quantiles of the figures over the members.
    pub quantiles: Vec<Quantiles>,
    /// Members without figures.
    pub failures: Vec<FailedMember>,
    /// Costs of the members.
    pub cost: Cost,
}

impl Ensemble {
    /// The answer of the finished members.
    pub fn report(&self, outcome: &Outcome) -> EnsembleReport {
        let members = &outcome.members;
        let failure = |member: &Member| {
            let error = member.figures.as_ref().err()?.clone();
            Some(FailedMember { member: member.number, error })
        };
        let failures: Vec<FailedMember> = members.iter().filter_map(failure).collect();
        let varied = self.spreads.iter().zip(&self.axes).map(|(spread, axis)| Varied {
            column: axis.column.name.clone(),
            path: spread.path.clone(),
            spread: spread.text.clone(),
        });
        EnsembleReport {
            case: self.base.name.clone(),
            bearing: self.base.case.name.clone(),
            members: self.options.members,
            finished: members.len(),
            resumed: members.iter().filter(|member| member.resumed).count(),
            failed: failures.len(),
            seed: self.options.seed,
            sampling: self.options.sampling,
            varied: varied.collect(),
            quantiles: quantiles(&self.figures, members),
            failures,
            cost: Cost::of(outcome),
        }
    }

    /// Values of a figure, by the name of its column, of all members that have it.
    pub fn values(&self, quantity: &str, members: &[Member]) -> Vec<f64> {
        let place = self.figures.iter().position(|column| column.name == quantity);
        place.map_or_else(Vec::new, |place| values(members, place))
    }
}

impl Cost {
    fn of(outcome: &Outcome) -> Self {
        let Outcome { members, threads, wall_s, .. } = outcome;
        let complete = || members.iter().filter(|member| member.figures.is_ok());
        let mean = |sum: f64| (complete().count() > 0).then(|| sum / complete().count() as f64);
        let processor_s: Option<f64> = complete().map(|member| member.processor_s).sum();
        let here = || complete().filter(|member| !member.resumed);
        let simulated_s = complete().map(|member| member.simulated_s).sum::<f64>();
        Self {
            threads: *threads,
            wall_s: *wall_s,
            wall_per_member_s: mean(complete().map(|member| member.wall_s).sum()),
            processor_per_member_s: processor_s.and_then(mean),
            simulated_s,
            simulated_per_wall: here().map(|member| member.simulated_s).sum::<f64>() / wall_s,
            simulated_per_processor: processor_s.filter(|s| *s > 0.0).map(|s| simulated_s / s),
        }
    }
}
