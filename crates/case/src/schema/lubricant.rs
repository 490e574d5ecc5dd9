//! Oil or grease in the contacts.

use crate::units;
use serde::Deserialize;
use tribodyn_lubricant::{BaseStock, Supply};
use tribodyn_traction::PatchChoice;

/// The lubricant of a bearing; it takes the place of coatings and of their traction.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LubricantSpec {
    /// The oil, or the base oil of a grease.
    pub oil: OilSpec,
    /// Temperature of oil and surfaces outside the contacts, K.
    #[serde(deserialize_with = "units::temperature")]
    pub temperature: f64,
    /// How it gets to the balls.
    pub supply: Supply,
    /// Film thickness over that of flooded contacts; 1 where left out, 0.7 for grease.
    #[serde(default)]
    pub starvation: Option<f64>,
    /// Roughness of the surfaces.
    pub roughness: RoughnessSpec,
    /// How the film is sheared.
    pub shear: ShearSpec,
    /// Friction coefficient of asperities that touch.
    pub boundary_friction: f64,
    /// Share of the elastic work that balls and rings lose when they are rolled over; that of steel where left out.
    #[serde(default)]
    pub hysteresis: Option<f64>,
    /// Quadrature over the contact ellipse.
    pub patch: PatchChoice,
}

/// Root-mean-square roughness R_q, m.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoughnessSpec {
    /// Of the balls.
    #[serde(deserialize_with = "units::length")]
    pub ball: f64,
    /// Of the inner race.
    #[serde(deserialize_with = "units::length")]
    pub inner: f64,
    /// Of the outer race.
    #[serde(deserialize_with = "units::length")]
    pub outer: f64,
}

/// Shear of a film beyond Newton's law.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum ShearSpec {
    /// Up to the limiting stress by an exponential (Bair and Winer).
    LimitingShear,
    /// Eyring's stress, Pa, capped at the limiting one.
    Eyring(#[serde(deserialize_with = "units::pressure")] f64),
}

/// An oil.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum OilSpec {
    /// An oil of the library, by stock and grade (`"mineral-vg68"`).
    Library(String),
    /// A grade of ISO 3448.
    Grade {
        /// Base stock.
        stock: BaseStock,
        /// Viscosity grade, mm²/s at 40 °C.
        vg: f64,
        /// Viscosity index; the usual one of the stock where left out.
        #[serde(default)]
        viscosity_index: Option<f64>,
    },
    /// Two viscosities of a data sheet.
    Viscosities {
        /// Base stock.
        stock: BaseStock,
        /// Kinematic viscosity at 40 °C, m²/s.
        #[serde(deserialize_with = "units::kinematic_viscosity")]
        at_40: f64,
        /// Kinematic viscosity at 100 °C, m²/s.
        #[serde(deserialize_with = "units::kinematic_viscosity")]
        at_100: f64,
        /// Density at 15 °C, kg/m³; the usual one of the stock where left out.
        #[serde(default, deserialize_with = "units::optional_density")]
        density_15: Option<f64>,
        /// Pressure–viscosity coefficient; that of the stock where left out.
        #[serde(default)]
        pressure: Option<PressureSpec>,
        /// Limiting shear stress over pressure at 40 °C; the usual one of the stock where left out.
        #[serde(default)]
        limiting_shear: Option<f64>,
    },
}

/// Pressure–viscosity coefficient α at 40 °C.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum PressureSpec {
    /// As measured, 1/Pa.
    At40(#[serde(deserialize_with = "units::pressure_coefficient")] f64),
    /// By the correlation of So and Klaus.
    SoKlaus,
}
