//! Which member has which bearing, fault, load and speed, and its case.

use super::sensor::AHEAD;
use std::f64::consts::TAU;
use tribodyn::{AnswerError, CaseFile, Change, Limits};
use tribodyn_case::{DatasetPlan, FaultClass, SpectrumSpec};
use tribodyn_wear::Random;

/// A bearing of the data set.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Individual {
    /// Its number, from 0.
    pub number: usize,
    /// Its case, by the place in the plan.
    pub case: usize,
    pub fault: FaultClass,
    /// Length of the spall, m; absent in a sound bearing.
    pub length: Option<f64>,
    /// Azimuth of its middle, along the rolling circle of a ball, rad.
    pub azimuth: Option<f64>,
    /// How far it stands off the rolling circle of a ball, rad.
    latitude: f64,
    /// True if its members are for tests.
    pub test: bool,
    /// Seeds of waves and balls.
    seeds: [u64; 3],
}

/// A member: a bearing under a load at a speed.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Choice {
    pub individual: Individual,
    /// Radial and axial load, N.
    pub load: [Option<f64>; 2],
    /// Speed of the inner ring, rad/s.
    pub speed: f64,
    /// Turn of the inner ring at time 0, rad.
    turned: f64,
}

/// Streams of random numbers: one of bearings, one of members, one of noise, one of the split.
const OF_BEARINGS: u64 = 1 << 60;
const OF_MEMBERS: u64 = 2 << 60;
pub(super) const OF_NOISE: u64 = 3 << 60;
const OF_SPLIT: u64 = 4 << 60;

/// Farthest that the spall of a ball stands off its rolling circle, rad: the contacts of all classes meet their spalls.
const LATITUDE: f64 = 0.05;

/// All bearings of a plan, in order: case by case, class by class, length by length.
pub(super) fn individuals(plan: &DatasetPlan) -> Vec<Individual> {
    let mut all = Vec::with_capacity(plan.bearing_count());
    for case in 0..plan.cases.len() {
        for &fault in &plan.faults {
            let lengths: Vec<Option<f64>> = match fault {
                FaultClass::Sound => vec![None],
                _ => plan.lengths.iter().map(|length| Some(length.0)).collect(),
            };
            for length in lengths {
                let tests = for_tests(plan, all.len());
                for test in tests {
                    let number = all.len();
                    all.push(individual(plan, (number, case), (fault, length), test));
                }
            }
        }
    }
    all
}

/// Which bearings of a group that begins with a number are for tests: their share, drawn at random.
fn for_tests(plan: &DatasetPlan, first: usize) -> Vec<bool> {
    let mut random = Random::new(plan.seed, OF_SPLIT + first as u64);
    let mut tests = vec![false; plan.bearings];
    let mut left: Vec<usize> = (0..plan.bearings).collect();
    for _ in 0..plan.bearings_for_tests() {
        tests[left.swap_remove(random.whole(0, left.len() - 1))] = true;
    }
    tests
}

fn individual(
    plan: &DatasetPlan,
    (number, case): (usize, usize),
    (fault, length): (FaultClass, Option<f64>),
    test: bool,
) -> Individual {
    let mut random = Random::new(plan.seed, OF_BEARINGS + number as u64);
    let mut seed = || random.whole(0, 1 << 50) as u64;
    let seeds = [seed(), seed(), seed()];
    let azimuth = match fault {
        FaultClass::Sound => None,
        FaultClass::Outer => Some(random.between(-plan.spall.zone, plan.spall.zone)),
        FaultClass::Inner | FaultClass::Ball => Some(random.between(0.0, TAU)),
    };
    let latitude = if fault == FaultClass::Ball { random.between(-LATITUDE, LATITUDE) } else { 0.0 };
    Individual { number, case, fault, length, azimuth, latitude, test, seeds }
}

/// A member by its number: the members of a bearing stand together.
pub(super) fn choice(plan: &DatasetPlan, individuals: &[Individual], member: usize) -> Choice {
    let each = plan.loads.len() * plan.speeds.len();
    let (bearing, within) = (member / each, member % each);
    let load = plan.loads[within / plan.speeds.len()];
    Choice {
        individual: individuals[bearing].clone(),
        load: [Some(load.radial), load.axial],
        speed: plan.speeds[within % plan.speeds.len()].0,
        turned: Random::new(plan.seed, OF_MEMBERS + member as u64).between(0.0, TAU),
    }
}

impl Choice {
    /// The case of the member, from the text of its base.
    pub fn case(
        &self,
        plan: &DatasetPlan,
        (name, text): (&str, &str),
        limits: &Limits,
    ) -> Result<CaseFile, AnswerError> {
        let mut changes = vec![
            ("speed.inner", format!("Constant(rad_per_s({:e}))", self.speed)),
            ("transient.duration", format!("s({:e})", plan.settle + plan.duration + delay(plan))),
            ("recording", format!("(state_rate: Hz({:e}), ball_rate: Hz(1))", plan.rate)),
        ];
        for (path, load) in ["ring.x", "ring.z"].into_iter().zip(self.load) {
            changes.extend(load.map(|load| (path, format!("Force(N({load:e}))"))));
        }
        let Individual { fault, length, azimuth, latitude, seeds, .. } = &self.individual;
        if let Some(form) = &plan.deviations {
            let races = [("inner", form.inner, seeds[0]), ("outer", form.outer, seeds[1])];
            for (race, SpectrumSpec { first, last, amplitude, exponent, .. }, seed) in races {
                let spectrum = format!(
                    "(spectrum: (first: {first}, last: {last}, amplitude: m({amplitude:e}), exponent: {exponent:e}, \
                     seed: {seed}))"
                );
                changes.push((if race == "inner" { "deviations.inner" } else { "deviations.outer" }, spectrum));
            }
            changes.push(("deviations.balls", format!("Grade(grade: {}, seed: {})", form.balls, seeds[2])));
        }
        changes.push(("deviations.position.inner", format!("rad({:e})", self.turned)));
        if let (Some(length), Some(azimuth)) = (length, azimuth) {
            let (section, place) = match fault {
                FaultClass::Inner => ("spalls", format!("race: Inner, azimuth: rad({azimuth:e})")),
                FaultClass::Sound | FaultClass::Outer => ("spalls", format!("race: Outer, azimuth: rad({azimuth:e})")),
                FaultClass::Ball => {
                    ("ball_spalls", format!("ball: 0, angle: rad({azimuth:e}), latitude: rad({latitude:e})"))
                }
            };
            let spall = &plan.spall;
            let spalls = format!(
                "[({place}, length: m({length:e}), width: m({:e}), depth: m({:e}), edge_radius: m({:e}))]",
                spall.width, spall.depth, spall.edge_radius
            );
            changes.push((section, spalls));
        }
        let change = |(path, value): &(&str, String)| Change::new(format!("{path}={value} of the plan"), path, value);
        let changes: Vec<Change> = changes.iter().map(change).collect();
        CaseFile::from_text(name, text.to_owned(), &changes, limits)
    }
}

/// Time that the filters of a run's samples and of the sensors take, s.
pub(super) fn delay(plan: &DatasetPlan) -> f64 {
    (tribodyn_signal::Decimator::DELAY + AHEAD) as f64 / plan.rate
}
