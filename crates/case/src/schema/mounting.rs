//! Fits and temperatures of the rings: what makes a mounted and running bearing differ from the one of the drawing.

use super::MaterialSpec;
use crate::units;
use serde::Deserialize;

/// Fits, temperatures and rotation of the rings; without it the bearing runs as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MountingSpec {
    /// Inner ring, on its shaft.
    pub inner: MountedRingSpec,
    /// Outer ring, in its housing.
    pub outer: MountedRingSpec,
    /// Balls.
    pub ball: HeatSpec,
}

/// Heat of a body.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeatSpec {
    /// Coefficient of thermal expansion, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub expansion: f64,
    /// Temperature over that of the drawing, K.
    #[serde(deserialize_with = "units::temperature_difference")]
    pub temperature_rise: f64,
}

/// A ring in its place; its elastic constants and density are those of `materials`.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MountedRingSpec {
    /// Bore of the inner ring, or outside diameter of the outer one, m.
    #[serde(deserialize_with = "units::length")]
    pub seat_diameter: f64,
    /// Coefficient of thermal expansion, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub expansion: f64,
    /// Temperature over that of the drawing, K.
    #[serde(deserialize_with = "units::temperature_difference")]
    pub temperature_rise: f64,
    /// Shaft or housing; absent for a ring that nothing holds.
    #[serde(default)]
    pub seat: Option<SeatSpec>,
}

/// A shaft in the inner ring's bore, or a housing around the outer ring.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeatSpec {
    /// Diameter of the shaft over that of the bore, or of the outer ring over that of the housing, m; below 0 for a
    /// loose fit.
    #[serde(deserialize_with = "units::length")]
    pub interference: f64,
    /// Bore of the shaft, 0 for a solid one, or outside diameter of the housing, m.
    #[serde(deserialize_with = "units::length")]
    pub far_diameter: f64,
    /// Elastic constants and density.
    pub material: MaterialSpec,
    /// Coefficient of thermal expansion, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub expansion: f64,
    /// Temperature over that of the drawing, K.
    #[serde(deserialize_with = "units::temperature_difference")]
    pub temperature_rise: f64,
}
