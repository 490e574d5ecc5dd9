//! The parts of a case file that only a transient run needs: supports, defects, the run itself and its recording.

use crate::units;
use serde::Deserialize;
use tribodyn_bearing::{Scheme, Side, Start};

/// Masses and supports of the rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SupportsSpec {
    /// Inner ring with what turns with it: three translations.
    pub inner: SupportSpec<3>,
    /// Outer ring with its housing: the two radial translations.
    pub outer: SupportSpec<2>,
    /// Inertia and support of an inner ring that is free to tilt; its tilts are held without it.
    #[serde(default)]
    pub tilt: Option<TiltSpec>,
    /// The same of the outer ring.
    #[serde(default)]
    pub outer_tilt: Option<TiltSpec>,
}

/// A ring that is free to tilt about its centre.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TiltSpec {
    /// Moments of inertia of the ring with what turns with it.
    pub inertia: RingInertia,
    /// Stiffness against tilts about X and Y, N m/rad.
    #[serde(deserialize_with = "units::tilt_stiffnesses")]
    pub stiffness: [f64; 2],
    /// Damping of tilts about X and Y, N m s/rad.
    #[serde(deserialize_with = "units::tilt_dampings")]
    pub damping: [f64; 2],
    /// Tilts about X and Y, at time 0, by which its seat stands askew; they turn with the ring, rad.
    #[serde(default, deserialize_with = "units::angles")]
    pub askew: [f64; 2],
}

/// Moments of inertia of a ring.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum RingInertia {
    /// As given, kg m².
    Given {
        /// About its axis.
        #[serde(deserialize_with = "units::inertia")]
        polar: f64,
        /// Across it, about the ring's centre.
        #[serde(deserialize_with = "units::inertia")]
        transverse: f64,
    },
    /// Those of a hollow cylinder with the mass of the ring.
    Cylinder {
        /// Inner diameter, m.
        #[serde(deserialize_with = "units::length")]
        bore: f64,
        /// Outer diameter, m.
        #[serde(deserialize_with = "units::length")]
        outside: f64,
        /// Width, m.
        #[serde(deserialize_with = "units::length")]
        width: f64,
    },
}

impl RingInertia {
    /// Moments of inertia about the axis and across it, kg m², of a ring with a mass, kg: m (a² + b²)/2 and half of it
    /// with m w²/12 of a cylinder with the radii a and b and the width w.
    pub fn of(self, mass: f64) -> [f64; 2] {
        match self {
            Self::Given { polar, transverse } => [polar, transverse],
            Self::Cylinder { bore, outside, width } => {
                let polar = mass * (bore * bore + outside * outside) / 8.0;
                [polar, 0.5 * polar + mass * width * width / 12.0]
            }
        }
    }
}

/// Mass of a ring and the springs and dampers between it and the frame, along x, y (and z). The springs are without
/// stretch at the quasi-static solution of the starting loads, except that those of the outer ring carry its load
/// there.
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

/// A spall of a raceway, with two edges along the path of the balls.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpallSpec {
    /// The raceway.
    pub race: Side,
    /// Its middle in the ring's own frame, rad.
    #[serde(deserialize_with = "units::angle")]
    pub azimuth: f64,
    /// Length between its edges along the path, m.
    #[serde(deserialize_with = "units::length")]
    pub length: f64,
    /// Width across the groove, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
    /// Depth of its bottom, m.
    #[serde(deserialize_with = "units::length")]
    pub depth: f64,
    /// Radius of its edges, m; sharp where left out.
    #[serde(default, deserialize_with = "units::length")]
    pub edge_radius: f64,
    /// Distance of its middle across the groove from the middle of the contact, m.
    #[serde(default, deserialize_with = "units::length")]
    pub across: f64,
}

/// A spall of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BallSpallSpec {
    /// Number of the ball.
    pub ball: usize,
    /// Angle along the rolling circle from the outer contact at time 0, in the direction of the orbit, rad.
    #[serde(deserialize_with = "units::angle")]
    pub angle: f64,
    /// Angle from the rolling circle of the outer contact, rad.
    #[serde(default, deserialize_with = "units::angle")]
    pub latitude: f64,
    /// Length between its edges along rolling, m.
    #[serde(deserialize_with = "units::length")]
    pub length: f64,
    /// Width across rolling, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
    /// Depth of its bottom, m.
    #[serde(deserialize_with = "units::length")]
    pub depth: f64,
    /// Radius of its edges, m; sharp where left out.
    #[serde(default, deserialize_with = "units::length")]
    pub edge_radius: f64,
}

/// The transient run.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransientSpec {
    /// Simulated time, s.
    #[serde(deserialize_with = "units::time")]
    pub duration: f64,
    /// The state from which the run starts.
    #[serde(with = "StartDef")]
    pub start: Start,
    /// Time stepping.
    #[serde(with = "SchemeDef")]
    pub scheme: Scheme,
    /// Damping of the ball–race contacts along their normals as a fraction of the critical one, ζ in c = 2ζ sqrt(m
    /// dQ/dδ).
    pub contact_damping: f64,
    /// Factor on all wear rates in what they do to coating and grooves, 0 for races that do not change during the run.
    pub wear_acceleration: f64,
}

/// [`Start`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "Start")]
enum StartDef {
    QuasiStatic,
    SteadyOrbit,
    Rest,
}

/// [`Scheme`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "Scheme", deny_unknown_fields)]
enum SchemeDef {
    RungeKutta4 {
        #[serde(deserialize_with = "units::time")]
        step: f64,
    },
    DormandPrince {
        tolerance: f64,
        #[serde(deserialize_with = "units::time")]
        longest: f64,
    },
    Fast {
        #[serde(deserialize_with = "units::time")]
        step: f64,
    },
    FastTo {
        accuracy: f64,
    },
}

/// Sampling rates of a run's recording.
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
