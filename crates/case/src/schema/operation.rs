//! Operating conditions and the cage: ring loads, speeds, pockets and guidance.

use super::FreeCageSpec;
use crate::units;
use serde::Deserialize;
use tribodyn_bearing::{Side, SpeedHistory, Tilt, Translation};

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
    /// Its form, by which the fluid brakes it besides; absent where that has no part.
    #[serde(default)]
    pub churning: Option<CageChurningSpec>,
    /// Moment of inertia about the bearing's axis, kg m²; a transient run needs it.
    #[serde(default, deserialize_with = "units::optional_inertia")]
    pub inertia: Option<f64>,
    /// Damping of the pocket contact χ in F = K δ (1 + χ δ̇) (Hunt and Crossley), s/m.
    #[serde(default, deserialize_with = "units::slowness")]
    pub pocket_damping: f64,
    /// Oil in the pockets of a bearing with a lubricant; absent for dry pockets.
    #[serde(default)]
    pub pocket_film: Option<PocketFilmSpec>,
    /// The land that guides the cage; absent for a cage that the balls alone guide.
    #[serde(default)]
    pub guidance: Option<GuidanceSpec>,
    /// Mass, pockets and lands of a cage that is free to move in all directions; runs alone use it.
    #[serde(default)]
    pub free: Option<FreeCageSpec>,
}

/// Form of a cage that the fluid of the bearing brakes: a ring with pockets.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CageChurningSpec {
    /// Diameter of its bore, m.
    #[serde(deserialize_with = "units::length")]
    pub bore: f64,
    /// Outside diameter, m.
    #[serde(deserialize_with = "units::length")]
    pub outside: f64,
    /// Width along the axis, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
}

/// Oil between balls and pockets: it resists a ball that approaches the wall.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PocketFilmSpec {
    /// Share of the gap that is full.
    pub fill: f64,
    /// Height of the roughness of ball and pocket, m.
    #[serde(deserialize_with = "units::length")]
    pub roughness: f64,
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

/// The five degrees of freedom of the inner ring against the outer: axes X and Y radial, Z axial.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RingSpec {
    /// Radial, the direction of the load and of azimuth 0: a force, or a held displacement.
    #[serde(with = "TranslationDef")]
    pub x: Translation,
    /// Radial, at azimuth 90°.
    #[serde(with = "TranslationDef")]
    pub y: Translation,
    /// Axial.
    #[serde(with = "TranslationDef")]
    pub z: Translation,
    /// Tilt about X: a moment, or a held angle.
    #[serde(with = "TiltDef")]
    pub tilt_x: Tilt,
    /// Tilt about Y.
    #[serde(with = "TiltDef")]
    pub tilt_y: Tilt,
}

/// [`Translation`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "Translation", deny_unknown_fields)]
enum TranslationDef {
    Force(#[serde(deserialize_with = "units::force")] f64),
    ForceTable(#[serde(deserialize_with = "units::force_table")] Vec<(f64, f64)>),
    Held(#[serde(deserialize_with = "units::length")] f64),
}

/// [`Tilt`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "Tilt", deny_unknown_fields)]
enum TiltDef {
    Moment(#[serde(deserialize_with = "units::torque")] f64),
    MomentTable(#[serde(deserialize_with = "units::torque_table")] Vec<(f64, f64)>),
    Held(#[serde(deserialize_with = "units::angle")] f64),
}

/// Rotational speeds of the rings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SpeedSpec {
    /// Inner ring, rad/s.
    #[serde(with = "SpeedDef")]
    pub inner: SpeedHistory,
    /// Outer ring, rad/s.
    #[serde(with = "SpeedDef")]
    pub outer: SpeedHistory,
}

/// [`SpeedHistory`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "SpeedHistory", deny_unknown_fields)]
enum SpeedDef {
    Constant(#[serde(deserialize_with = "units::speed")] f64),
    Table(#[serde(deserialize_with = "units::speed_table")] Vec<(f64, f64)>),
}
