//! Coatings, their traction and wear, and the fluid around the balls.

use crate::units;
use serde::Deserialize;
use tribodyn_traction::{PatchChoice, PressureChoice, SlipUnit};

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
    /// Lubricant that the balls scrape off the cage; lives with transfer need it.
    #[serde(default)]
    pub transfer: Option<TransferSpec>,
}

/// The film that comes from the cage: self-lubrication by sacrificial contact.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransferSpec {
    /// Traction curve data of the cage's material between ball and race.
    pub curve: CurveSpec,
    /// Thickness at which the film covers all of a contact, m.
    #[serde(deserialize_with = "units::length")]
    pub cover: f64,
    /// Part of what is scraped or worn off that is lost, 0 to 1.
    pub loss: f64,
    /// How the film wears between ball and race.
    pub wear: ArchardSpec,
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
    /// Unit of the slip axis of the curve.
    pub slip_unit: SlipUnit,
    /// Order of the polynomials of the curve's parameters in pressure.
    pub order: usize,
    /// True if the parameters vary with pressure (cases 1 and 3), false if they are fixed (2 and 4).
    pub varying: bool,
    /// Pressure at which fixed parameters are taken, Pa.
    #[serde(deserialize_with = "units::pressure")]
    pub reference_pressure: f64,
    /// True if the Heathcote (differential) slip is kept (cases 1 and 2).
    pub differential_slip: bool,
    /// Which pressure enters varying parameters.
    pub pressure: PressureChoice,
    /// Quadrature over the contact ellipse.
    pub patch: PatchChoice,
}

/// How bare, uncoated steel slides: what a worn or pitted coating leaves.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BareSpec {
    /// Traction curve data.
    pub curve: CurveSpec,
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
    /// Drag coefficient C_d of a ball, or a factor upon that of a sphere.
    pub drag_coefficient: f64,
    /// True if C_d follows that of a smooth sphere over its Reynolds number, with its crisis, times `drag_coefficient`.
    #[serde(default)]
    pub drag_over_reynolds: bool,
    /// Speed of the fluid over that of the inner ring at the pitch circle.
    pub swirl: f64,
    /// Part of the ball's frontal area πD²/4 hidden behind the cage web.
    pub shaded_fraction: f64,
    /// True if churning moments act on the spinning balls.
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
