//! How a shaft swings about its equilibrium: modes over speed (Campbell's diagram), critical speeds, unbalance.

use super::RPM_PER_RAD_S;
use super::build::{Running, failed};
use super::file::ShaftFile;
use crate::error::StudyError;
use serde::Serialize;
use tribodyn_shaft::{Equilibrium, FREEDOMS, LinearShaft, Mode, Whirl};

/// Modes and response at one speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpeedAnswer {
    /// Speed of the shaft, r/min.
    pub speed_rpm: f64,
    /// Modes up to the highest frequency asked for, by frequency.
    pub modes: Vec<Mode>,
    /// Largest amplitude of each bearing's node by the unbalances, m; empty without unbalance.
    pub amplitude_m: Vec<f64>,
    /// Largest amplitude of all nodes, m; absent without unbalance.
    pub amplitude_max_m: Option<f64>,
    /// Largest amplitude of each bearing's force by the unbalances, N.
    pub bearing_force_n: Vec<f64>,
}

/// A speed at which the shaft turns as fast as it swings.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Critical {
    /// Speed, r/min.
    pub speed_rpm: f64,
    /// Sense of whirl there.
    pub whirl: Whirl,
}

/// A shaft over speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WhirlAnswer {
    /// Answers by growing speed.
    pub speeds: Vec<SpeedAnswer>,
    /// Critical speeds between them.
    pub critical: Vec<Critical>,
    /// Warnings.
    pub warnings: Vec<String>,
}

/// Steps of the secant to a critical speed.
const SECANT: usize = 4;
/// Relative change of a critical speed below which it is found.
const FOUND: f64 = 1e-7;

/// A shaft at one speed, linear about its equilibrium.
struct At<'a> {
    running: Running<'a>,
    found: Equilibrium,
    linear: LinearShaft,
    damped: bool,
}

impl<'a> At<'a> {
    fn new(file: &'a ShaftFile, speed: f64) -> Result<Self, StudyError> {
        let running = Running::new(file, speed, 1.0)?;
        let found = running.equilibrium(None)?;
        let damping: Vec<[f64; 3]> = file
            .system
            .bearings
            .iter()
            .map(|bearing| bearing.damping.map_or([0.0; 3], |value| [value, value, 0.0]))
            .collect();
        let linear = running.system(false)?.linearised(&found, &damping).map_err(|source| failed(file, source))?;
        let damped = damping.iter().flatten().any(|value| *value > 0.0);
        Ok(Self { running, found, linear, damped })
    }

    fn modes(&self, file: &ShaftFile) -> Result<Vec<Mode>, StudyError> {
        self.linear.modes(self.running.speed).map_err(|source| failed(file, source))
    }

    /// Amplitudes of all nodes, and of the forces of the bearings.
    fn response(&self, file: &ShaftFile) -> Result<(Vec<f64>, Vec<f64>), StudyError> {
        let speed = self.running.speed;
        let mut force = vec![[0.0; 2]; FREEDOMS * self.running.positions().len()];
        for (node, moment, phase) in self.running.unbalances() {
            // x as cos(ωt + φ), y as sin(ωt + φ): a quarter of a turn behind.
            let (size, (sin, cos)) = (moment * speed * speed, phase.sin_cos());
            let turning = [[size * cos, size * sin], [size * sin, -size * cos]];
            for (k, parts) in turning.into_iter().enumerate() {
                (0..2).for_each(|part| force[FREEDOMS * node + k][part] += parts[part]);
            }
        }
        let moved = self.linear.response(speed, speed.abs(), &force).map_err(|source| failed(file, source))?;
        let at = |node: usize| (moved[FREEDOMS * node], moved[FREEDOMS * node + 1]);
        let nodes = (0..self.running.positions().len()).map(|node| semi_axis(at(node)));
        let bearings = file.system.bearings.iter().enumerate().map(|(index, spec)| {
            let node = FREEDOMS * self.running.node(spec.at);
            let k = &self.found.stiffnesses[index];
            let along = |row: usize| {
                let part = |part: usize| (0..FREEDOMS).map(|c| k[row][c] * moved[node + c][part]).sum::<f64>();
                [part(0), part(1)]
            };
            semi_axis((along(0), along(1)))
        });
        Ok((nodes.collect(), bearings.collect()))
    }
}

/// Larger half axis of the ellipse that two oscillations at a quarter of a turn make.
fn semi_axis(([a, b], [c, d]): ([f64; 2], [f64; 2])) -> f64 {
    // Forward and backward circles.
    let forward = 0.5 * (a - d).hypot(b + c);
    let backward = 0.5 * (a + d).hypot(b - c);
    forward + backward
}

/// Modes up to a frequency (Hz), response and critical speeds over speeds in r/min.
///
/// # Errors
/// As [`super::ShaftAnswer::at`], at any speed.
pub fn whirl(file: &ShaftFile, speeds_rpm: &[f64], up_to_hz: f64) -> Result<WhirlAnswer, StudyError> {
    if let Some(speed) = speeds_rpm.iter().find(|speed| !(speed.is_finite() && **speed >= 0.0)) {
        return Err(StudyError::argument("modes", speed, "allowed are speeds of 0 r/min or more"));
    }
    if up_to_hz.is_nan() || up_to_hz <= 0.0 {
        return Err(StudyError::argument("up-to", up_to_hz, "allowed is a frequency above 0 Hz"));
    }
    let mut sorted = speeds_rpm.to_vec();
    sorted.sort_by(f64::total_cmp);
    let (mut speeds, mut warnings, mut all) = (Vec::new(), Vec::new(), Vec::new());
    for rpm in sorted {
        let at = At::new(file, rpm / RPM_PER_RAD_S)?;
        let modes = at.modes(file)?;
        let (nodes, forces) =
            if at.running.unbalances().is_empty() { (Vec::new(), Vec::new()) } else { at.response(file)? };
        warn(file, &at, rpm, (&nodes, &forces), &mut warnings);
        let bearing_nodes = file.system.bearings.iter().map(|spec| at.running.node(spec.at));
        speeds.push(SpeedAnswer {
            speed_rpm: rpm,
            modes: modes.iter().filter(|mode| mode.frequency_hz <= up_to_hz).cloned().collect(),
            amplitude_m: bearing_nodes.filter_map(|node| nodes.get(node).copied()).collect(),
            amplitude_max_m: nodes.iter().copied().max_by(f64::total_cmp),
            bearing_force_n: forces,
        });
        all.push((rpm, modes));
    }
    let critical = critical(file, &all)?;
    Ok(WhirlAnswer { speeds, critical, warnings })
}

/// Adds a warning for each thing that makes the linear answer doubtful.
fn warn(file: &ShaftFile, at: &At<'_>, rpm: f64, (nodes, forces): (&[f64], &[f64]), warnings: &mut Vec<String>) {
    let mut once = |text: String| {
        if !warnings.contains(&text) {
            warnings.push(text);
        }
    };
    for direction in &at.found.loose {
        once(format!("nothing holds the shaft {direction}: modes about such an equilibrium mean nothing"));
    }
    if !nodes.is_empty() && !at.damped {
        once("no bearing has damping: amplitudes near a critical speed have no limit".to_owned());
    }
    for ((spec, force), reaction) in file.system.bearings.iter().zip(forces).zip(&at.found.reactions) {
        let still = reaction[0].hypot(reaction[1]);
        if *force > still {
            warnings.push(format!(
                "at {rpm:.0} r/min the unbalance puts {force:.0} N on bearing {}, more than the {still:.0} N of the \
                 equilibrium: a linear answer does not hold there",
                spec.name
            ));
        }
    }
}

/// Where a mode's frequency crosses that of rotation. Modes are counted by frequency: such curves are continuous.
fn critical(file: &ShaftFile, all: &[(f64, Vec<Mode>)]) -> Result<Vec<Critical>, StudyError> {
    let lateral =
        |modes: &[Mode]| -> Vec<Mode> { modes.iter().filter(|mode| mode.whirl != Whirl::Axial).cloned().collect() };
    let ahead = |modes: &[Mode], index: usize, rpm: f64| modes.get(index).map(|m| m.frequency_hz * 60.0 - rpm);
    let mut found = Vec::new();
    for pair in all.windows(2) {
        let [(low, first), (high, second)] = pair else { continue };
        let (first, second) = (lateral(first), lateral(second));
        for index in 0..first.len().min(second.len()) {
            let (Some(mut a), Some(mut b)) = (ahead(&first, index, *low), ahead(&second, index, *high)) else {
                continue;
            };
            if a * b > 0.0 || a == b {
                continue;
            }
            let (mut from, mut to) = (*low, *high);
            let mut whirl = first[index].whirl;
            for _ in 0..SECANT {
                let rpm = from - a * (to - from) / (b - a);
                let at = At::new(file, rpm / RPM_PER_RAD_S)?;
                let modes = lateral(&at.modes(file)?);
                let Some(left) = ahead(&modes, index, rpm) else { break };
                whirl = modes[index].whirl;
                if left * a > 0.0 {
                    (from, a) = (rpm, left)
                } else {
                    (to, b) = (rpm, left)
                }
                if left.abs() <= FOUND * rpm {
                    break;
                }
            }
            let speed_rpm = from - a * (to - from) / (b - a);
            found.push(Critical { speed_rpm, whirl });
        }
    }
    found.sort_by(|a, b| a.speed_rpm.total_cmp(&b.speed_rpm));
    Ok(found)
}
