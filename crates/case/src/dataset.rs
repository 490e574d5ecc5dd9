//! The plan of a data set of vibration signals with labels: which bearings, faults, loads and speeds, and what the
//! sensors do.

use crate::units;
use crate::validate::{Verdict, positive, require};
use crate::{LengthSpec, SpectrumSpec};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// A data set: each fault in bearings of its own, each bearing under every load at every speed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DatasetPlan {
    /// A title.
    pub name: String,
    /// Case files, from the folder of the plan.
    pub cases: Vec<String>,
    /// Classes of the labels.
    pub faults: Vec<FaultClass>,
    /// Lengths of the spalls, m.
    pub lengths: Vec<LengthSpec>,
    /// Loads.
    pub loads: Vec<PlanLoad>,
    /// Speeds of the inner ring, rad/s.
    pub speeds: Vec<PlanSpeed>,
    /// Bearings of each case, class and length: each has waves, balls and a spall of its own.
    pub bearings: usize,
    /// Depth, width and edges of all spalls.
    pub spall: PlanSpall,
    /// Waviness of both races and grade of the balls; as the case has them where left out.
    #[serde(default)]
    pub deviations: Option<PlanDeviations>,
    /// Simulated time before a signal begins, s.
    #[serde(deserialize_with = "units::time")]
    pub settle: f64,
    /// Length of a signal, s.
    #[serde(deserialize_with = "units::time")]
    pub duration: f64,
    /// Samples of a signal, Hz.
    #[serde(deserialize_with = "units::frequency")]
    pub rate: f64,
    /// Sensors on the housing.
    pub sensors: Vec<SensorSpec>,
    /// Part of the bearings of each case, class and length whose members are for tests, 0 to 1.
    pub test_share: f64,
    /// Seed of everything that is drawn.
    pub seed: u64,
}

/// The fault of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum FaultClass {
    /// Nothing.
    Sound,
    /// A spall of the outer race.
    Outer,
    /// A spall of the inner race.
    Inner,
    /// A spall of a ball.
    Ball,
}

/// A load.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanLoad {
    /// Along x, N.
    #[serde(deserialize_with = "units::force")]
    pub radial: f64,
    /// Along z, N; as the case has it where left out.
    #[serde(default, deserialize_with = "units::optional_force")]
    pub axial: Option<f64>,
}

/// A speed, rad/s.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
pub struct PlanSpeed(#[serde(deserialize_with = "units::speed")] pub f64);

/// Depth, width and edges of all spalls of a data set.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanSpall {
    /// Depth, m.
    #[serde(deserialize_with = "units::length")]
    pub depth: f64,
    /// Width across the groove, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
    /// Radius of the edges, m.
    #[serde(deserialize_with = "units::length")]
    pub edge_radius: f64,
    /// Farthest from the direction of the radial load on an outer race, rad; on an inner race and along a ball it is
    /// anywhere.
    #[serde(deserialize_with = "units::angle")]
    pub zone: f64,
}

/// Form and size of all bearings of a data set; phases and sizes are those of each.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanDeviations {
    /// Waviness of the inner race; its seed is not used.
    pub inner: SpectrumSpec,
    /// Waviness of the outer race; its seed is not used.
    pub outer: SpectrumSpec,
    /// Grade of the balls.
    pub balls: u32,
}

/// An accelerometer and the way to it: of the acceleration a of the outer ring along its direction it has
/// `direct` a + Σ gain ω²/(s² + 2 ζ ω s + ω²) a, and noise.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SensorSpec {
    /// Name of its column.
    pub name: String,
    /// Direction from x towards y, rad.
    #[serde(deserialize_with = "units::angle")]
    pub direction: f64,
    /// Factor of the acceleration itself.
    pub direct: f64,
    /// Modes between outer ring and sensor.
    pub modes: Vec<SensorMode>,
    /// Root mean square of its white noise, m/s².
    pub noise: f64,
}

/// A mode between outer ring and sensor.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SensorMode {
    /// Natural frequency, Hz.
    #[serde(deserialize_with = "units::frequency")]
    pub frequency: f64,
    /// Damping, a fraction of the critical one.
    pub damping: f64,
    /// Gain at rest.
    pub gain: f64,
}

/// Most members of a data set.
const MEMBERS_MAX: usize = 1_000_000;
/// Most samples of a signal.
const SAMPLES_MAX: f64 = 1e7;

impl DatasetPlan {
    /// Number of bearings: the sound ones have no length.
    pub fn bearing_count(&self) -> usize {
        let spalled = self.faults.iter().filter(|fault| **fault != FaultClass::Sound).count();
        let kinds = spalled * self.lengths.len() + self.faults.len() - spalled;
        self.cases.len() * kinds * self.bearings
    }

    /// Bearings of each case, class and length whose members are for tests.
    pub fn bearings_for_tests(&self) -> usize {
        (self.test_share * self.bearings as f64).round() as usize
    }

    /// Number of members.
    pub fn members(&self) -> usize {
        self.bearing_count() * self.loads.len() * self.speeds.len()
    }
}

pub(super) fn validate(plan: &DatasetPlan) -> Verdict {
    let spalled = plan.faults.iter().any(|fault| *fault != FaultClass::Sound);
    let lists = [
        ("cases", plan.cases.len(), 1),
        ("faults", plan.faults.len(), 1),
        ("lengths", plan.lengths.len(), usize::from(spalled)),
        ("loads", plan.loads.len(), 1),
        ("speeds", plan.speeds.len(), 1),
        ("bearings", plan.bearings, 1),
        ("sensors", plan.sensors.len(), 1),
    ];
    for (path, count, least) in lists {
        require((least..=1000).contains(&count), path, format!("{count}; allowed are {least} to 1000"))?;
    }
    let members = plan.members();
    require(members <= MEMBERS_MAX, "bearings", format!("{members} members; allowed are {MEMBERS_MAX}"))?;
    let classes: BTreeSet<FaultClass> = plan.faults.iter().copied().collect();
    require(classes.len() == plan.faults.len(), "faults", "each class may be named once")?;
    for (i, length) in plan.lengths.iter().enumerate() {
        positive(&format!("lengths[{i}]"), length.0)?;
    }
    positive("duration", plan.duration)?;
    require(plan.settle >= 0.0, "settle", "must be at least 0 s")?;
    require(plan.rate > 0.0 && plan.rate <= 1e6, "rate", "must be greater than 0 Hz and at most 1 MHz")?;
    let samples = plan.rate * (plan.settle + plan.duration);
    require(samples <= SAMPLES_MAX, "duration", format!("{samples} samples; allowed are {SAMPLES_MAX:e}"))?;
    require((0.0..=1.0).contains(&plan.test_share), "test_share", "must lie between 0 and 1")?;
    let (all, tests) = (plan.bearings, plan.bearings_for_tests());
    let shared = plan.test_share > 0.0 && plan.test_share < 1.0;
    let message = format!(
        "leaves {tests} of the {all} bearings of a kind for tests, {} for training: allowed are 0, 1 and more bearings",
        all - tests
    );
    require(!shared || (tests > 0 && tests < all), "test_share", message)?;
    require((0.0..=PI).contains(&plan.spall.zone), "spall.zone", "must lie between 0 and 180 degrees")?;
    let mut names = BTreeSet::new();
    for (i, sensor) in plan.sensors.iter().enumerate() {
        self::sensor(&format!("sensors[{i}]"), sensor, plan.rate)?;
        require(names.insert(&sensor.name), &format!("sensors[{i}].name"), "two sensors have this name")?;
    }
    Ok(())
}

fn sensor(path: &str, spec: &SensorSpec, rate: f64) -> Verdict {
    let letters = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let named = spec.name.chars().all(letters) && spec.name.starts_with(|c: char| c.is_ascii_lowercase());
    require(named, &format!("{path}.name"), "must be of lower-case letters, digits and _, a letter first")?;
    require(spec.direct.is_finite(), &format!("{path}.direct"), "must be finite")?;
    require(spec.noise >= 0.0 && spec.noise.is_finite(), &format!("{path}.noise"), "must be at least 0 and finite")?;
    for (k, mode) in spec.modes.iter().enumerate() {
        let path = format!("{path}.modes[{k}]");
        let most = 0.45 * rate;
        let within = mode.frequency > 0.0 && mode.frequency <= most;
        require(within, &format!("{path}.frequency"), format!("must be above 0 and at most 0.45 of rate, {most} Hz"))?;
        let within = mode.damping > 0.0 && mode.damping <= 1.0;
        require(within, &format!("{path}.damping"), "must be above 0 and at most 1, critical damping")?;
        require(mode.gain.is_finite(), &format!("{path}.gain"), "must be finite")?;
    }
    Ok(())
}
