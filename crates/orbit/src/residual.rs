//! The collocated equations: balances at each point of the mesh, and those of cage and ring over the turn.

use crate::collocation::{Orbit, STAGES};
use crate::means::Means;
use crate::system::{BALL, Evaluation, OMEGA, ORBIT, OrbitSystem, RING, VELOCITY};
use tribodyn_bearing::{RingFreedom, Side};
use tribodyn_numerics::Radau;

/// An orbit with what its equations lack.
pub(crate) type Found = (Orbit, Residual);

/// Unknowns of an interval.
pub(crate) const STACK: usize = BALL * STAGES;
/// Cage speed and ring.
pub(crate) const BORDER: usize = 1 + RING;

/// Units in the last place of a value that the slope of an interval's polynomial is uncertain by: its coefficients add
/// up to a dozen.
const ROUNDING: f64 = 16.0;

/// Numbers of which some are infinite, which JSON does not have, by their bits.
mod bits {
    use super::BALL;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<S: Serializer>(values: &[f64; BALL], serializer: S) -> Result<S::Ok, S::Error> {
        values.map(f64::to_bits).serialize(serializer)
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<[f64; BALL], D::Error> {
        <[u64; BALL]>::deserialize(deserializer).map(|bits| bits.map(f64::from_bits))
    }
}

/// Typical magnitudes of the unknowns, by which rows and columns are divided.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(crate) struct Scales {
    pub ball: [f64; BALL],
    /// Cage speed and ring.
    pub border: [f64; BORDER],
    /// Torque on the cage and forces and moments on the ring that count as one.
    pub border_rows: [f64; BORDER],
    /// Force, N.
    pub force: f64,
    /// Largest change of a ball's unknowns in one step.
    #[serde(with = "bits")]
    pub limits: [f64; BALL],
    /// Errors of a ball's unknowns in an interval that count alike, over their scales.
    pub errors: [f64; BALL],
}

/// Residuals over their scales.
#[derive(Debug, Clone)]
pub(crate) struct Residual {
    pub intervals: Vec<[f64; STACK]>,
    pub border: [f64; BORDER],
    pub worst: Worst,
    /// Means over the turn of a single ball.
    pub means: Means,
}

/// The largest residual against the terms of its balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Worst {
    pub relative: f64,
    /// Interval, or none for cage and ring.
    pub interval: Option<usize>,
    /// Unknown of the ball, or 0 for the cage and 1 to 5 for the ring.
    pub equation: usize,
}

impl Worst {
    pub const NONE: Self = Self { relative: 0.0, interval: None, equation: 0 };

    pub fn take(&mut self, value: f64, scale: f64, interval: Option<usize>, equation: usize) {
        let relative = if value == 0.0 { 0.0 } else { (value / scale).abs() };
        let relative = if relative.is_nan() { f64::INFINITY } else { relative };
        if relative > self.relative {
            *self = Self { relative, interval, equation };
        }
    }
}

/// Slope of an interval's polynomial at point `i` over its width, per turn.
pub(crate) fn slope(radau: &Radau, orbit: &Orbit, j: usize, i: usize) -> [f64; BALL] {
    let (from, values) = (orbit.begin(j), &orbit.values[j]);
    std::array::from_fn(|k| (0..STAGES).map(|s| radau.slope[i][s] * (values[s][k] - from[k])).sum())
}

/// Magnitude of the terms of each balance of a ball, with rates in proportion to `time`.
pub(crate) fn magnitudes(system: &OrbitSystem<'_>, scales: &Scales, e: &Evaluation, time: f64) -> [f64; BALL] {
    let (m, j) = (system.bearing.ball_mass, system.bearing.ball_inertia);
    let force = e.force_scale(m).max(1e-3 * scales.force);
    let contacts = Side::BOTH.map(|side| e.loads.contacts[side].normal.load);
    // As in the quasi-static solver: slip in the last digit of a surface speed already moves traction by 1e-12 of the
    // load.
    let friction = (0.01 * (contacts[0] + contacts[1])).max(1e-3 * scales.force);
    let gyroscopic = j * e.state.orbital_speed.abs() * e.state.angular_velocity[1].hypot(e.state.angular_velocity[2]);
    let moments = Side::BOTH.map(|side| e.loads.contacts[side].moment.iter().map(|m| m.abs()).sum::<f64>());
    let turning = (moments[0] + moments[1] + gyroscopic).max(friction * system.bearing.geometry.ball_radius());
    let mut size = [0.0; BALL];
    size[..VELOCITY].copy_from_slice(&scales.ball[..VELOCITY]);
    (VELOCITY..ORBIT).for_each(|k| size[k] = time * force / m);
    let along = friction + e.friction.pocket.force.abs() + e.friction.drag.abs();
    size[ORBIT] = time * along / (m * e.loads.orbit_radius);
    (OMEGA..BALL).for_each(|k| size[k] = time * turning / j);
    size
}

/// Residuals of cage and ring over their scales.
pub(crate) fn border(system: &OrbitSystem<'_>, orbit: &Orbit, means: &Means, scales: &Scales) -> [f64; BORDER] {
    let balls = system.bearing.geometry.ball_count as f64;
    std::array::from_fn(|k| {
        if k == 0 {
            return match system.held {
                Some(speed) => (speed - orbit.cage_speed) / scales.border[0],
                None => cage_torque(system, orbit, means) / scales.border_rows[0],
            };
        }
        match system.ring[k - 1] {
            RingFreedom::Loaded(load) => (load - balls * means.ring[k - 1]) / scales.border_rows[k],
            RingFreedom::Held(held) => (held - orbit.ring[k - 1]) / scales.border[k],
        }
    })
}

/// Torque of balls, guidance and drag on the cage, N m.
pub(crate) fn cage_torque(system: &OrbitSystem<'_>, orbit: &Orbit, means: &Means) -> f64 {
    let balls = system.bearing.geometry.ball_count as f64;
    let fluid: f64 = system.cage.fluid_torques(orbit.cage_speed, system.speeds).iter().sum();
    balls * means.cage + fluid
}

/// Mean torque that the shaft needs at the inner ring, N m: that of the balls, and of a cage which the ring guides.
pub(crate) fn shaft_torque(system: &OrbitSystem<'_>, orbit: &Orbit, means: &Means) -> f64 {
    let balls = system.bearing.geometry.ball_count as f64;
    let guided = system.cage.guidance.is_some_and(|guidance| guidance.side == Side::Inner);
    let [guidance, _] = system.cage.fluid_torques(orbit.cage_speed, system.speeds);
    balls * means.torque + if guided { guidance } else { 0.0 }
}

/// All residuals.
pub(crate) fn residual(system: &OrbitSystem<'_>, radau: &Radau, orbit: &Orbit, scales: &Scales) -> Residual {
    let mut worst = Worst::NONE;
    let mut means = Means::default();
    let mut intervals = Vec::with_capacity(orbit.intervals());
    for j in 0..orbit.intervals() {
        let [begin, width] = orbit.interval(j);
        let mut stack = [0.0; STACK];
        for i in 0..STAGES {
            let azimuth = system.azimuth(begin + radau.points[i] * width);
            let e = system.value(azimuth, &orbit.values[j][i], orbit.cage_speed, orbit.ring);
            means.add(&e, width * radau.weights[i]);
            let time = system.time(width, orbit.cage_speed);
            let slope = slope(radau, orbit, j, i);
            let size = magnitudes(system, scales, &e, time);
            for k in 0..BALL {
                let r = slope[k] - time * e.rate[k];
                // The difference of two values has no more digits than they have.
                let rounding = ROUNDING * f64::EPSILON * orbit.values[j][i][k].abs();
                worst.take((r.abs() - rounding).max(0.0), size[k], Some(j), k);
                stack[i * BALL + k] = r / scales.ball[k];
            }
        }
        intervals.push(stack);
    }
    let border = border(system, orbit, &means, scales);
    border.iter().enumerate().for_each(|(k, &r)| worst.take(r, 1.0, None, k));
    Residual { intervals, border, worst, means }
}
