//! The shape of a case file, field by field, in SI.
//!
//! Every dimensional value carries its unit in the text (`mm(30.16)`, `rpm(14000)`); the deserialisers of
//! [`super::units`] turn it into the SI number held here.

mod cage;
mod deviations;
mod lubricant;
mod mounting;
mod operation;
mod rating;
mod transient;
mod tribology;

pub use cage::*;
pub use deviations::*;
pub use lubricant::*;
pub use mounting::*;
pub use operation::*;
pub use rating::*;
pub use transient::*;
pub use tribology::*;

use super::units;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use tribodyn_bearing::{Modelling, Shoulders, SolverSettings};

/// One bearing, its materials, its operating point and the numerics.
///
/// A section that is an `Option` may be left out where no model that is used needs it; [`Case::require`] has the table.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// A title for reports and recordings.
    pub name: String,
    /// Balls, grooves and fit.
    pub geometry: GeometrySpec,
    /// Elastic constants and densities.
    pub materials: Materials,
    /// The solid lubricant on each race.
    #[serde(default)]
    pub coatings: Option<Coatings>,
    /// How slip, pressure and patch quadrature are treated.
    #[serde(default)]
    pub traction: Option<TractionSpec>,
    /// Oil or grease, in the place of coatings.
    #[serde(default)]
    pub lubricant: Option<LubricantSpec>,
    /// The fluid the balls move through; absent for a dry bearing without drag and churning.
    #[serde(default)]
    pub fluid: Option<FluidSpec>,
    /// The cage.
    #[serde(default)]
    pub cage: Option<CageSpec>,
    /// Archard constants of the three sliding pairs.
    #[serde(default)]
    pub wear: Option<WearSpec>,
    /// Fits and temperatures of the rings; without it the bearing runs as it is drawn.
    #[serde(default)]
    pub mounting: Option<MountingSpec>,
    /// Catalogue numbers for the rating life.
    #[serde(default)]
    pub rating: Option<RatingSpec>,
    /// Load on each degree of freedom of the inner ring, or the position at which it is held.
    pub ring: RingSpec,
    /// Rotational speeds of the rings.
    pub speed: SpeedSpec,
    /// Masses and supports of the rings; a transient run needs them.
    #[serde(default)]
    pub supports: Option<SupportsSpec>,
    /// Waviness of the races and unequal balls; without them races are round and balls equal.
    #[serde(default)]
    pub deviations: Option<DeviationsSpec>,
    /// Local defects of the raceways.
    #[serde(default)]
    pub defects: Vec<DefectSpec>,
    /// Spalls of the raceways.
    #[serde(default)]
    pub spalls: Vec<SpallSpec>,
    /// Spalls of the balls.
    #[serde(default)]
    pub ball_spalls: Vec<BallSpallSpec>,
    /// The transient run, for `run`.
    #[serde(default)]
    pub transient: Option<TransientSpec>,
    /// Sampling rates of a run's recording.
    #[serde(default)]
    pub recording: Option<RecordingSpec>,
    /// Modelling choices.
    pub modelling: Modelling,
    /// Solver settings.
    #[serde(default)]
    pub numerics: Numerics,
    /// Where values come from: field path to source. A path not in the file is refused.
    #[serde(default)]
    pub sources: BTreeMap<String, Source>,
}

/// Balls, grooves and fit.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GeometrySpec {
    /// Number of balls.
    pub ball_count: usize,
    /// Ball diameter D, m.
    #[serde(deserialize_with = "units::length")]
    pub ball_diameter: f64,
    /// Pitch diameter d_m, m.
    #[serde(deserialize_with = "units::length")]
    pub pitch_diameter: f64,
    /// Inner groove.
    pub inner_groove: Groove,
    /// Outer groove.
    pub outer_groove: Groove,
    /// Contact angle or radial clearance, one gives the other.
    pub fit: Fit,
    /// Sides on which the grooves have shoulders; absent where that is not known.
    #[serde(default)]
    pub shoulders: Option<ShouldersSpec>,
    /// Edge of the inner groove on the side on which the balls bear.
    #[serde(default)]
    pub inner_shoulder: Option<Shoulder>,
    /// Edge of the outer groove there.
    #[serde(default)]
    pub outer_shoulder: Option<Shoulder>,
}

/// Sides on which the grooves have shoulders: both, or the one on which a positive axial load presses the balls.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShouldersSpec {
    /// Of the inner groove.
    pub inner: Shoulders,
    /// Of the outer groove.
    pub outer: Shoulders,
}

/// The transverse radius of a raceway groove.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Groove {
    /// Groove radius over ball diameter, f = r/D (osculation is 1/(2f)).
    Coefficient(f64),
    /// Groove radius, m.
    Radius(#[serde(deserialize_with = "units::length")] f64),
}

/// The free contact state of the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Fit {
    /// Free contact angle α0, rad.
    ContactAngle(#[serde(deserialize_with = "units::angle")] f64),
    /// Diametral (radial internal) clearance P_d, m: cos α0 = 1 − P_d/(2A). Below 0 the balls are pressed radially.
    RadialClearance(#[serde(deserialize_with = "units::length")] f64),
}

/// Materials of ball and rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Materials {
    /// Balls; the density matters here.
    pub ball: MaterialSpec,
    /// Inner ring.
    pub inner: MaterialSpec,
    /// Outer ring.
    pub outer: MaterialSpec,
}

/// Elastic constants and density of one body.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MaterialSpec {
    /// Young's modulus, Pa.
    #[serde(deserialize_with = "units::pressure")]
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density, kg/m³.
    #[serde(deserialize_with = "units::density")]
    pub density: f64,
}

/// Solver settings; defaults are numerics, not physics.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Numerics {
    /// Largest relative residual of any balance at which the solver stops.
    pub tolerance: f64,
    /// Newton steps before the solver gives up.
    pub max_iterations: usize,
}

impl Default for Numerics {
    fn default() -> Self {
        let SolverSettings { tolerance, max_iterations } = SolverSettings::default();
        Self { tolerance, max_iterations }
    }
}

/// Where a value comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Source {
    /// A published figure, with its reference.
    Published(String),
    /// A catalogue figure.
    Catalogue(String),
    /// A material handbook or data sheet.
    Reference(String),
    /// Chosen for this case, with the reason.
    Assumed(String),
    /// Chosen by a search because results then come nearest to what is published, with where the search is told: it
    /// says nothing of the true value, and those results are no evidence.
    Searched(String),
    /// Found by identification, with its standard deviation in the unit of the file.
    Identified {
        /// Standard deviation, in the unit of the field.
        spread: f64,
        /// From which data.
        from: String,
    },
}
