//! What the standards' ratings need beside the geometry, and the edges of the grooves.

use crate::units;
use serde::Deserialize;

/// Catalogue numbers for `tribodyn rating`; what is left out is computed or taken as usual.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RatingSpec {
    /// Nominal contact angle, rad: the free one where left out, and 0 where `geometry.fit` is a clearance.
    #[serde(default, deserialize_with = "units::optional_angle")]
    pub contact_angle: Option<f64>,
    /// Basic dynamic load rating C_r, N; computed by ISO 281 where left out.
    #[serde(default, deserialize_with = "units::optional_force")]
    pub dynamic: Option<f64>,
    /// Basic static load rating C_0r, N; computed by ISO 76 where left out.
    #[serde(default, deserialize_with = "units::optional_force")]
    pub static_load: Option<f64>,
    /// Fatigue load limit C_u, N; from C_0r by ISO 281 where left out.
    #[serde(default, deserialize_with = "units::optional_force")]
    pub fatigue_limit: Option<f64>,
    /// Viscosity ratio κ of the lubricant, for the life modification factor.
    #[serde(default)]
    pub viscosity_ratio: Option<f64>,
    /// Contamination factor e_C, for the life modification factor.
    #[serde(default)]
    pub contamination: Option<f64>,
    /// Share of bearings that reach the life, percent; 90 where left out.
    #[serde(default)]
    pub reliability: Option<f64>,
}

/// Where a groove ends on the side on which the balls bear.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Shoulder {
    /// Height over the bottom of the groove, m.
    Height(#[serde(deserialize_with = "units::length")] f64),
    /// Diameter of the shoulder, m.
    Diameter(#[serde(deserialize_with = "units::length")] f64),
}
