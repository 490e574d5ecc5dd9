//! The parts of a case file that only a transient run needs: supports, defects, the run itself and its recording.

use super::CurveSpec;
use super::units;
use serde::{Deserialize, Serialize};
use tribodyn_bearing::Side;

/// Masses and supports of the rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SupportsSpec {
    /// Inner ring with what turns with it: three translations.
    pub inner: SupportSpec<3>,
    /// Outer ring with its housing: the two radial translations.
    pub outer: SupportSpec<2>,
}

/// Mass of a ring and the springs and dampers between it and the frame, along x, y (and z). The springs are without
/// stretch at the quasi-static solution of the starting loads, except that those of the outer ring carry its load there.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SupportSpec<const N: usize> {
    /// Mass, kg.
    #[serde(deserialize_with = "units::mass")]
    pub mass: f64,
    /// Stiffness, N/m.
    #[serde(deserialize_with = "units::stiffnesses")]
    pub stiffness: [f64; N],
    /// Damping constant, N s/m.
    #[serde(deserialize_with = "units::dampings")]
    pub damping: [f64; N],
}

/// A land that guides the cage: the fluid in its gap turns the cage with the ring or holds it back.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GuidanceSpec {
    /// The ring whose land it is.
    pub land: Side,
    /// Radius of the land, m.
    #[serde(deserialize_with = "units::length")]
    pub radius: f64,
    /// Width of the land, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
    /// Radial gap between land and cage, m.
    #[serde(deserialize_with = "units::length")]
    pub gap: f64,
}

/// A local defect of a raceway: a pit over an azimuth sector of the ring, where the coating may be gone.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DefectSpec {
    /// The raceway.
    pub race: Side,
    /// Middle of the sector in the ring's own frame, which stands as the inertial one at time 0, rad.
    #[serde(deserialize_with = "units::angle")]
    pub azimuth: f64,
    /// Full width of the sector, rad.
    #[serde(deserialize_with = "units::angle")]
    pub width: f64,
    /// Depth in the middle, m.
    #[serde(deserialize_with = "units::length")]
    pub depth: f64,
    /// Part of the coating that is gone there, 0 to 1.
    pub bare: f64,
}

/// How bare, uncoated steel slides: what a worn or pitted coating leaves.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BareSpec {
    /// Traction curve data.
    pub curve: CurveSpec,
}

/// The transient run.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransientSpec {
    /// Simulated time, s.
    #[serde(deserialize_with = "units::time")]
    pub duration: f64,
    /// Where the run starts.
    pub start: StartSpec,
    /// Time stepping.
    pub scheme: SchemeSpec,
    /// Damping of the ball–race contacts along their normals as a fraction of the critical one, ζ in c = 2ζ sqrt(m dQ/dδ).
    pub contact_damping: f64,
    /// Factor on all wear rates in what they do to coating and grooves, 0 for races that do not change during the run.
    pub wear_acceleration: f64,
}

/// Where a transient run starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum StartSpec {
    /// From the quasi-static solution at the loads and speeds of time 0.
    QuasiStatic,
    /// From a standstill: rings, cage and balls at rest under the loads of time 0.
    Rest,
}

/// Time stepping.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum SchemeSpec {
    /// The classical Runge–Kutta method of fourth order, the paper's at 1e-5 s.
    RungeKutta4 {
        /// Step, s.
        #[serde(deserialize_with = "units::time")]
        step: f64,
    },
    /// The embedded pair 5(4) of Dormand and Prince.
    DormandPrince {
        /// Largest error of a step relative to the typical size of each unknown.
        tolerance: f64,
        /// Longest step, s.
        #[serde(deserialize_with = "units::time")]
        longest: f64,
    },
    /// The fast fixed-step scheme: contact springs explicit, the friction of spin and orbit linearly implicit.
    Fast {
        /// Step, s.
        #[serde(deserialize_with = "units::time")]
        step: f64,
    },
}

/// What a run writes and how often.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecordingSpec {
    /// Samples of rings, cage and powers, Hz; the test rig took 25.6 kHz.
    #[serde(deserialize_with = "units::frequency")]
    pub state_rate: f64,
    /// Samples of every ball, Hz.
    #[serde(deserialize_with = "units::frequency")]
    pub ball_rate: f64,
}
