//! Quantities of solutions and of runs.

use crate::settled::{Settled, mean, median};
use serde::{Deserialize, Serialize};
use tribodyn_bearing::{BallResult, Side};
use tribodyn_quasistatic::{OverAzimuth, Solution};

/// The half of the azimuths about the radial load, −90° to 90°, or the other one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Zone {
    /// About the load.
    Heavy,
    /// Opposite.
    Light,
}

/// Quantities that can be measured. Azimuths in degrees; a ball's value there is interpolated over the solved balls.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Quantity {
    /// Mean orbital speed of the balls, r/min.
    CageSpeed,
    /// Frequency at which balls pass a point of the outer race, Hz.
    OuterPassingFrequency,
    /// Inner peak pressure, GPa.
    PeakPressureInner {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Outer peak pressure, GPa.
    PeakPressureOuter {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Inner contact load, N.
    LoadInner {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Outer contact load, N.
    LoadOuter {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Inner contact angle, degrees.
    ContactAngleInner {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Outer contact angle, degrees.
    ContactAngleOuter {
        /// Azimuth, degrees.
        azimuth: f64,
    },
    /// Mean over a zone of the traction along the rolling direction at the inner race, its sign left off, N.
    TractionInner {
        /// Zone.
        zone: Zone,
    },
    /// The same at the outer race, N.
    TractionOuter {
        /// Zone.
        zone: Zone,
    },
    /// Greatest less least traction along the rolling direction at the inner race over the balls, N.
    TractionRangeInner,
    /// The same at the outer race, N.
    TractionRangeOuter,
    /// Median over the balls of the slide-to-roll ratio at the inner race, its sign left off.
    SlideToRollInner,
    /// Mean slide-to-roll ratio at the inner race in the light zone less that in the heavy one, over the mean of the
    /// ratios without their signs: 2 where it is negative about the load and positive opposite, −2 the other way round.
    SlideToRollTurnInner,
    /// Axial displacement of the inner ring, µm.
    RingDisplacementAxial,
    /// Displacement of the inner ring along x, µm.
    RingDisplacementRadial,
    /// Torque of the shaft, N m.
    ShaftTorque,
    /// Of a run: mean orbital speed of the balls, r/min.
    OrbitalSpeed,
    /// Of a run: least orbital speed of a ball, r/min.
    OrbitalSpeedLeast,
    /// Of a run: greatest orbital speed of a ball, r/min.
    OrbitalSpeedGreatest,
    /// Of a run: greatest acceleration of the outer ring along x, about its mean, m/s².
    OuterAccelerationPeak,
    /// Of a run: amplitude of the outer ring's acceleration along x as that of a sine of its rms, m/s².
    OuterAccelerationAmplitude,
    /// Of a run: rms of the inner ring's acceleration in all directions, m/s².
    InnerAccelerationRms,
    /// Of a run: median azimuth of the first impact of a ball on its pocket from 180° on, degrees.
    FirstImpact,
    /// Of a run: share of the impacts between two azimuths, degrees.
    ImpactShare {
        /// First azimuth.
        from: f64,
        /// Last azimuth.
        to: f64,
    },
}

/// Traction along the rolling direction, N; NaN without friction.
fn traction(ball: &BallResult, side: Side) -> f64 {
    ball.contacts[side].friction_or_nan().traction_n[0]
}

/// Slide-to-roll ratio along the rolling direction at the inner race; NaN without friction.
fn sliding(ball: &BallResult) -> f64 {
    ball.contacts.inner.friction_or_nan().slide_to_roll[0]
}

fn zone_mean(solution: &Solution, zone: Zone, of: impl Fn(&BallResult) -> f64) -> f64 {
    let inside = solution.balls.iter().filter(|b| (b.azimuth_rad.cos() > 0.0) == (zone == Zone::Heavy));
    mean(inside.map(of))
}

/// Greatest less least value over the balls.
fn range(solution: &Solution, of: impl Fn(&BallResult) -> f64) -> f64 {
    let limits = |[low, high]: [f64; 2], v: f64| [low.min(v), high.max(v)];
    let [low, high] = solution.balls.iter().map(of).fold([f64::INFINITY, f64::NEG_INFINITY], limits);
    high - low
}

impl Quantity {
    /// True if it is one of a transient run.
    pub fn of_run(&self) -> bool {
        matches!(
            self,
            Self::OrbitalSpeed
                | Self::OrbitalSpeedLeast
                | Self::OrbitalSpeedGreatest
                | Self::OuterAccelerationPeak
                | Self::OuterAccelerationAmplitude
                | Self::InnerAccelerationRms
                | Self::FirstImpact
                | Self::ImpactShare { .. }
        )
    }

    /// Its value in a settled run, in its unit; NaN where it is none of a run.
    pub fn of_settled(&self, run: &Settled) -> f64 {
        match *self {
            Self::OrbitalSpeed => run.orbital_speed_rpm,
            Self::OrbitalSpeedLeast => run.orbital_limits_rpm[0],
            Self::OrbitalSpeedGreatest => run.orbital_limits_rpm[1],
            Self::OuterAccelerationPeak => run.outer_peak_m_s2,
            Self::OuterAccelerationAmplitude => run.outer_amplitude_m_s2,
            Self::InnerAccelerationRms => run.inner_rms_m_s2.iter().map(|v| v * v).sum::<f64>().sqrt(),
            Self::FirstImpact => run.first_impact_deg,
            Self::ImpactShare { from, to } => {
                let inside = run.impacts_deg.iter().filter(|a| (from..=to).contains(*a)).count();
                inside as f64 / run.impacts_deg.len() as f64
            }
            _ => f64::NAN,
        }
    }

    /// Its value in a solution, in its unit; NaN where it is one of a run.
    pub fn of(&self, solution: &Solution) -> f64 {
        let ball = |azimuth: f64| OverAzimuth::new(solution).at(azimuth.to_radians());
        match *self {
            Self::CageSpeed => solution.cage_speed_rpm,
            Self::OuterPassingFrequency => {
                let outer = solution.outer_speed_rad_s * 30.0 / std::f64::consts::PI;
                (solution.cage_speed_rpm - outer).abs() / 60.0 * solution.balls.len() as f64
            }
            Self::PeakPressureInner { azimuth } => ball(azimuth).contacts.inner.peak_pressure_pa * 1e-9,
            Self::PeakPressureOuter { azimuth } => ball(azimuth).contacts.outer.peak_pressure_pa * 1e-9,
            Self::LoadInner { azimuth } => ball(azimuth).contacts.inner.load_n,
            Self::LoadOuter { azimuth } => ball(azimuth).contacts.outer.load_n,
            Self::ContactAngleInner { azimuth } => ball(azimuth).contacts.inner.angle_rad.to_degrees(),
            Self::ContactAngleOuter { azimuth } => ball(azimuth).contacts.outer.angle_rad.to_degrees(),
            Self::TractionInner { zone } => zone_mean(solution, zone, |b| traction(b, Side::Inner).abs()),
            Self::TractionOuter { zone } => zone_mean(solution, zone, |b| traction(b, Side::Outer).abs()),
            Self::TractionRangeInner => range(solution, |b| traction(b, Side::Inner)),
            Self::TractionRangeOuter => range(solution, |b| traction(b, Side::Outer)),
            Self::SlideToRollInner => median(solution.balls.iter().map(|b| sliding(b).abs()).collect()),
            Self::SlideToRollTurnInner => {
                let [heavy, light] = [Zone::Heavy, Zone::Light].map(|zone| zone_mean(solution, zone, sliding));
                (light - heavy) / mean(solution.balls.iter().map(|b| sliding(b).abs()))
            }
            Self::RingDisplacementAxial => solution.ring_displacement_m[2] * 1e6,
            Self::RingDisplacementRadial => solution.ring_displacement_m[0] * 1e6,
            Self::ShaftTorque => solution.shaft_torque_nm.unwrap_or(f64::NAN),
            _ => f64::NAN,
        }
    }

    /// Its unit.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::CageSpeed => "r/min",
            Self::OuterPassingFrequency => "Hz",
            Self::PeakPressureInner { .. } | Self::PeakPressureOuter { .. } => "GPa",
            Self::LoadInner { .. } | Self::LoadOuter { .. } => "N",
            Self::ContactAngleInner { .. } | Self::ContactAngleOuter { .. } => "°",
            Self::TractionInner { .. }
            | Self::TractionOuter { .. }
            | Self::TractionRangeInner
            | Self::TractionRangeOuter => "N",
            Self::SlideToRollInner | Self::SlideToRollTurnInner => "–",
            Self::RingDisplacementAxial | Self::RingDisplacementRadial => "µm",
            Self::ShaftTorque => "N m",
            Self::OrbitalSpeed | Self::OrbitalSpeedLeast | Self::OrbitalSpeedGreatest => "r/min",
            Self::OuterAccelerationPeak | Self::OuterAccelerationAmplitude | Self::InnerAccelerationRms => "m/s²",
            Self::FirstImpact => "°",
            Self::ImpactShare { .. } => "–",
        }
    }
}
