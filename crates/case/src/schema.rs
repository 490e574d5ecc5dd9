//! The shape of a case file, field by field, in SI.
//!
//! Every dimensional value carries its unit in the text (`mm(30.16)`, `rpm(14000)`); the deserialisers of
//! [`super::units`] turn it into the SI number held here.

mod mounting;
mod rating;

pub use mounting::*;
pub use rating::*;

use super::transient::{BareSpec, DefectSpec, GuidanceSpec, RecordingSpec, SupportsSpec, TransientSpec};
use super::units;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use tribodyn_bearing::RaceControl;
use tribodyn_traction::{MomentArm, PatchRule, PressureChoice, SlipUnit};

/// One bearing, its materials, its operating point and the numerics: everything a run needs.
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
    pub coatings: Coatings,
    /// How slip, pressure and patch quadrature are treated.
    pub traction: TractionSpec,
    /// The fluid the balls move through; absent for a dry bearing without drag and churning.
    #[serde(default)]
    pub fluid: Option<FluidSpec>,
    /// The cage.
    pub cage: CageSpec,
    /// Archard constants of the three sliding pairs.
    pub wear: WearSpec,
    /// Fits and temperatures of the rings; without it the bearing runs as it is drawn.
    #[serde(default)]
    pub mounting: Option<MountingSpec>,
    /// Catalogue numbers for the rating life.
    #[serde(default)]
    pub rating: Option<RatingSpec>,
    /// What each degree of freedom of the inner ring carries, or where it is held.
    pub ring: RingSpec,
    /// Rotational speeds of the rings.
    pub speed: SpeedSpec,
    /// Masses and supports of the rings; a transient run needs them.
    #[serde(default)]
    pub supports: Option<SupportsSpec>,
    /// Local defects of the raceways.
    #[serde(default)]
    pub defects: Vec<DefectSpec>,
    /// The transient run, for `run`.
    #[serde(default)]
    pub transient: Option<TransientSpec>,
    /// What a run records.
    #[serde(default)]
    pub recording: Option<RecordingSpec>,
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
    /// Edge of the inner groove on the side on which the balls bear.
    #[serde(default)]
    pub inner_shoulder: Option<Shoulder>,
    /// Edge of the outer groove there.
    #[serde(default)]
    pub outer_shoulder: Option<Shoulder>,
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
    /// Diametral (radial internal) clearance P_d, m: cos α0 = 1 − P_d/(2A).
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

/// The lubricant on each race.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Coatings {
    /// On the inner race.
    pub inner: CoatingSpec,
    /// On the outer race.
    pub outer: CoatingSpec,
    /// Bare steel under them; needed where a coating is worn or has a defect.
    #[serde(default)]
    pub bare: Option<BareSpec>,
}

/// A coating: its traction data and its thickness.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CoatingSpec {
    /// Traction curve data.
    pub curve: CurveSpec,
    /// Thickness when new, m.
    #[serde(deserialize_with = "units::length")]
    pub thickness: f64,
    /// Part of the thickness that is worn off when a run starts, 0 to 1.
    #[serde(default)]
    pub worn: f64,
}

/// Where the traction curve's tested points come from.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum CurveSpec {
    /// A coating of the built-in library, by name (`"ag"`, `"ptfe"`, `"bare-440c"`).
    Library(String),
    /// Tested points given here.
    Tested(Vec<TestedPoint>),
}

/// Peak slip, peak and residual traction coefficient at one tested pressure.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TestedPoint {
    /// Contact pressure of the test, Pa.
    #[serde(deserialize_with = "units::pressure")]
    pub pressure: f64,
    /// Slip at the peak, in the coating's slip unit.
    pub peak_slip: f64,
    /// Traction coefficient at the peak.
    pub peak_coefficient: f64,
    /// Traction coefficient at infinite slip.
    pub residual_coefficient: f64,
}

/// How slip, pressure and patch quadrature are treated.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TractionSpec {
    /// What the slip axis of the curve means.
    pub slip_unit: SlipUnit,
    /// Order of the polynomials of the curve's parameters in pressure.
    pub order: usize,
    /// Whether the parameters vary with pressure (cases 1 and 3) or are fixed (2 and 4).
    pub varying: bool,
    /// Pressure at which fixed parameters are taken, Pa.
    #[serde(deserialize_with = "units::pressure")]
    pub reference_pressure: f64,
    /// Whether the Heathcote (differential) slip is kept (cases 1 and 2).
    pub differential_slip: bool,
    /// Which pressure enters varying parameters.
    pub pressure: PressureChoice,
    /// Arm of the traction moment.
    pub moment_arm: MomentArm,
    /// Quadrature over the contact ellipse.
    pub patch: PatchRule,
}

/// The fluid around the balls.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FluidSpec {
    /// Which fluid.
    pub medium: Medium,
    /// Volume fraction X of liquid; the rest is gas.
    pub liquid_fraction: f64,
    /// Density of the gas phase, kg/m³.
    #[serde(deserialize_with = "units::density")]
    pub gas_density: f64,
    /// Drag coefficient C_d of a ball.
    pub drag_coefficient: f64,
    /// Speed of the fluid over that of the inner ring at the pitch circle.
    pub swirl: f64,
    /// Part of the ball's frontal area πD²/4 hidden behind the cage web.
    pub shaded_fraction: f64,
    /// Whether churning moments act on the spinning balls.
    pub churning: bool,
}

/// A cryogen at a state, or a density and viscosity.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Medium {
    /// Liquid nitrogen.
    Nitrogen {
        /// Temperature, K.
        #[serde(deserialize_with = "units::temperature")]
        temperature: f64,
        /// Pressure, Pa.
        #[serde(deserialize_with = "units::pressure")]
        pressure: f64,
    },
    /// Liquid oxygen.
    Oxygen {
        /// Temperature, K.
        #[serde(deserialize_with = "units::temperature")]
        temperature: f64,
        /// Pressure, Pa.
        #[serde(deserialize_with = "units::pressure")]
        pressure: f64,
    },
    /// Liquid methane.
    Methane {
        /// Temperature, K.
        #[serde(deserialize_with = "units::temperature")]
        temperature: f64,
        /// Pressure, Pa.
        #[serde(deserialize_with = "units::pressure")]
        pressure: f64,
    },
    /// Any other fluid.
    Custom {
        /// Density, kg/m³.
        #[serde(deserialize_with = "units::density")]
        density: f64,
        /// Dynamic viscosity, Pa s.
        #[serde(deserialize_with = "units::viscosity")]
        viscosity: f64,
    },
}

/// The cage.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CageSpec {
    /// Circumferential gap between ball and pocket wall on either side when centred, m.
    #[serde(deserialize_with = "units::length")]
    pub pocket_gap: f64,
    /// Pocket contact stiffness, N/m.
    #[serde(deserialize_with = "units::stiffness")]
    pub pocket_stiffness: f64,
    /// Friction coefficient between ball and pocket.
    pub pocket_friction: f64,
    /// Drag torque on the cage (positive retards it), N m.
    #[serde(deserialize_with = "units::torque")]
    pub drag_torque: f64,
    /// Moment of inertia about the bearing's axis, kg m²; a transient run needs it.
    #[serde(default, deserialize_with = "units::optional_inertia")]
    pub inertia: Option<f64>,
    /// Damping of the pocket contact χ in F = K δ (1 + χ δ̇) (Hunt and Crossley), s/m.
    #[serde(default, deserialize_with = "units::slowness")]
    pub pocket_damping: f64,
    /// The land that guides the cage; absent for a cage that the balls alone guide.
    #[serde(default)]
    pub guidance: Option<GuidanceSpec>,
}

/// Archard constants.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WearSpec {
    /// Ball against inner race.
    pub inner: ArchardSpec,
    /// Ball against outer race.
    pub outer: ArchardSpec,
    /// Ball against cage pocket.
    pub cage: ArchardSpec,
}

/// Archard's wear coefficient and the hardness it is divided by.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ArchardSpec {
    /// Wear coefficient K_w, dimensionless.
    pub coefficient: f64,
    /// Hardness H of the worn body, Pa.
    #[serde(deserialize_with = "units::pressure")]
    pub hardness: f64,
}

/// The five degrees of freedom of the inner ring against the outer: axes X and Y radial, Z axial.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RingSpec {
    /// Radial, the direction of the load and of azimuth 0: a force, or a held displacement.
    pub x: Translation,
    /// Radial, at azimuth 90°.
    pub y: Translation,
    /// Axial.
    pub z: Translation,
    /// Tilt about X: a moment, or a held angle.
    pub tilt_x: Tilt,
    /// Tilt about Y.
    pub tilt_y: Tilt,
}

/// A translation of the ring: loaded or held.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Translation {
    /// External force on the inner ring, N.
    Force(#[serde(deserialize_with = "units::force")] f64),
    /// External force in time: rows (s, N), linear between them and constant beyond.
    ForceTable(#[serde(deserialize_with = "units::force_table")] Vec<(f64, f64)>),
    /// Held displacement, m.
    Held(#[serde(deserialize_with = "units::length")] f64),
}

/// A tilt of the ring: loaded or held.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Tilt {
    /// External moment on the inner ring, N m.
    Moment(#[serde(deserialize_with = "units::torque")] f64),
    /// External moment in time: rows (s, N m), linear between them and constant beyond.
    MomentTable(#[serde(deserialize_with = "units::torque_table")] Vec<(f64, f64)>),
    /// Held angle, rad.
    Held(#[serde(deserialize_with = "units::angle")] f64),
}

/// Rotational speeds of the rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpeedSpec {
    /// Inner ring, rad/s.
    pub inner: SpeedHistory,
    /// Outer ring, rad/s.
    pub outer: SpeedHistory,
}

/// A rotational speed, constant or in time.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum SpeedHistory {
    /// The same at all times, rad/s.
    Constant(#[serde(deserialize_with = "units::speed")] f64),
    /// Rows (s, rad/s), linear between them and constant beyond.
    Table(#[serde(deserialize_with = "units::speed_table")] Vec<(f64, f64)>),
}

/// Solver settings; defaults are numerics, not physics.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Numerics {
    /// Largest relative residual of any balance at which the solver stops.
    pub tolerance: f64,
    /// Newton steps before the solver gives up.
    pub max_iterations: usize,
    /// Whether contact constants follow the actual contact angle instead of the free one.
    pub contact_at_actual_angle: bool,
    /// Whether the Jones–Harris model takes the centrifugal force at the undeformed pitch radius.
    pub centrifugal_at_free_pitch: bool,
    /// Which race controls the ball in the Jones–Harris model.
    pub race_control: RaceControl,
    /// About which axis a displaced ring turns.
    pub ring_centre: RingCentre,
}

/// The axis about which a displaced ring turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RingCentre {
    /// Its own centre, displaced with it: what a shaft does.
    Displaced,
    /// The inertial axis: what equations without the displacement in the surface velocity do.
    Inertial,
}

impl Default for Numerics {
    fn default() -> Self {
        Self {
            // Each balance to ten digits: five more than any published figure has, five above rounding.
            tolerance: 1e-10,
            // A cold start takes 10 to 40 steps; more means that it will not converge.
            max_iterations: 200,
            contact_at_actual_angle: false,
            // The classical Jones–Harris equations take d_m/2; the orbit radius differs by less than 0.1 %.
            centrifugal_at_free_pitch: true,
            race_control: RaceControl::Outer,
            ring_centre: RingCentre::Displaced,
        }
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
    /// Found by identification, with its standard deviation in the unit of the file.
    Identified {
        /// Standard deviation, in the unit of the field.
        spread: f64,
        /// From which data.
        from: String,
    },
}
