//! Data that the standards' ratings need beside the geometry, and the edges of the grooves.

use crate::units;
use serde::Deserialize;
use tribodyn_rating::Cleanliness;

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
    /// Viscosity ratio κ of the lubricant, for the life modification factor; that of `lubricant` where left out.
    #[serde(default)]
    pub viscosity_ratio: Option<f64>,
    /// Contamination factor e_C, for the life modification factor.
    #[serde(default)]
    pub contamination: Option<f64>,
    /// How clean the lubricant is, where `contamination` is left out.
    #[serde(default)]
    pub cleanliness: Option<Cleanliness>,
    /// Bore d, m, for SKF's friction torque; estimated from pitch and balls where left out.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub bore: Option<f64>,
    /// Outside diameter, m, for the same.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub outside: Option<f64>,
    /// Series of a deep-groove bearing, such as 62, for the same; 62 where left out.
    #[serde(default)]
    pub series: Option<u16>,
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
