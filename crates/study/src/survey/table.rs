//! Results of a survey, by regime.

use super::trial::{Solving, Verdict};
use super::{RandomBearing, Trial};
use std::collections::BTreeMap;
use std::time::Duration;
use tribodyn::answers::Equations;

/// A band of nominal pressure and of pitch diameter times speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Regime {
    /// Index into [`Regime::PRESSURES`].
    pub pressure: usize,
    /// Index into [`Regime::PITCH_SPEEDS`].
    pub pitch_speed: usize,
}

impl Regime {
    /// Names of the bands of nominal pressure.
    pub const PRESSURES: [&str; 3] = ["below 0.5 GPa", "0.5 to 1.5 GPa", "1.5 to 4 GPa"];
    /// Names of the bands of pitch diameter times speed.
    pub const PITCH_SPEEDS: [&str; 3] = ["below 1e5 mm/min", "1e5 to 1e6 mm/min", "1e6 to 3e6 mm/min"];

    /// The regime of a bearing.
    pub fn of(bearing: &RandomBearing) -> Self {
        let band = |value: f64, limits: [f64; 2]| limits.iter().filter(|&&limit| value >= limit).count();
        Self {
            pressure: band(bearing.nominal_pressure_gpa, [0.5, 1.5]),
            pitch_speed: band(bearing.pitch_speed_mm_min, [1e5, 1e6]),
        }
    }

    /// True at the pressures that bearings are made for.
    pub fn working(self) -> bool {
        self.pressure > 0
    }
}

/// Verdicts, counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Counts {
    /// As it should be.
    pub good: usize,
    /// Of these, solutions that Newton's method did not find from its first start.
    pub rescued: usize,
    /// With a reason.
    pub explained: usize,
    /// Without one, or wrong.
    pub failed: usize,
}

impl Counts {
    /// All of them.
    pub fn all(self) -> usize {
        self.good + self.explained + self.failed
    }

    fn add(&mut self, verdict: &Verdict) {
        match verdict {
            Verdict::Good => self.good += 1,
            Verdict::Explained(_) => self.explained += 1,
            Verdict::Failed(_) => self.failed += 1,
        }
    }
}

/// Solutions by one model.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ModelCounts {
    /// Verdicts.
    pub counts: Counts,
    /// Wall times, shortest first.
    walls: Vec<Duration>,
}

impl ModelCounts {
    /// Wall time that half of the solutions take at most.
    pub fn median(&self) -> Duration {
        self.walls.get(self.walls.len() / 2).copied().unwrap_or_default()
    }

    /// Longest wall time.
    pub fn slowest(&self) -> Duration {
        self.walls.last().copied().unwrap_or_default()
    }

    fn add(&mut self, solving: &Solving) {
        self.counts.add(&solving.verdict);
        self.counts.rescued += usize::from(solving.rescued && solving.verdict == Verdict::Good);
        self.walls.insert(self.walls.partition_point(|wall| *wall <= solving.wall), solving.wall);
    }
}

/// Runs of one scheme.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SchemeCounts {
    /// Verdicts.
    pub counts: Counts,
    /// Runs that miss more than 1 % of their work.
    pub above_one_percent: usize,
    /// Largest imbalance of a run whose verdict is good, %.
    pub worst_good_percent: f64,
    /// Most linear and angular momentum missing in a run whose work balances, %.
    pub worst_momentum_percent: [f64; 2],
    /// Runs that the clock stopped, judged as far as they came.
    pub stopped: usize,
    /// Longest wall time, s.
    pub longest_s: f64,
}

/// A survey in numbers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// Solutions by regime and model.
    pub solutions: BTreeMap<(Regime, Equations), ModelCounts>,
    /// Runs by scheme.
    pub runs: BTreeMap<&'static str, SchemeCounts>,
}

impl Tally {
    /// Counts trials.
    pub fn of(trials: &[Trial]) -> Self {
        let mut tally = Self::default();
        for trial in trials {
            let regime = Regime::of(&trial.bearing);
            for solving in &trial.solvings {
                tally.solutions.entry((regime, solving.model)).or_default().add(solving);
            }
            let Some(running) = &trial.running else { continue };
            let scheme = tally.runs.entry(running.scheme).or_default();
            scheme.counts.add(&running.verdict);
            scheme.longest_s = scheme.longest_s.max(running.wall.as_secs_f64());
            scheme.stopped += usize::from(running.stopped);
            let off = running.imbalance_percent.map_or(0.0, f64::abs);
            scheme.above_one_percent += usize::from(off > 1.0);
            if running.verdict == Verdict::Good {
                scheme.worst_good_percent = scheme.worst_good_percent.max(off);
                for (worst, missing) in scheme.worst_momentum_percent.iter_mut().zip(running.momentum_percent) {
                    *worst = worst.max(missing.unwrap_or(0.0));
                }
            }
        }
        tally
    }

    /// Solutions by one model at the pressures that bearings are made for.
    pub fn working(&self, model: Equations) -> Counts {
        let mut sum = Counts::default();
        let of_model = self.solutions.iter().filter(|((regime, of), _)| regime.working() && *of == model);
        for (_, ModelCounts { counts, .. }) in of_model {
            sum.good += counts.good;
            sum.rescued += counts.rescued;
            sum.explained += counts.explained;
            sum.failed += counts.failed;
        }
        sum
    }
}
