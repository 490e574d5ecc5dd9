//! A cage that is free to move in all directions.

use crate::units;
use serde::Deserialize;
use tribodyn_bearing::{FilmExtent, PocketShape, Side};

/// A cage that whirls and tilts in a run; without it the cage turns about the bearing's axis only.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FreeCageSpec {
    /// Mass, kg.
    #[serde(deserialize_with = "units::mass")]
    pub mass: f64,
    /// Moment of inertia across the axis, kg m².
    #[serde(deserialize_with = "units::inertia")]
    pub transverse_inertia: f64,
    /// Distance of the centre of mass from the centre, towards the first pocket, m.
    #[serde(default, deserialize_with = "units::length")]
    pub unbalance: f64,
    /// Acceleration by gravity (x, y, z), m/s²: of the cage alone.
    #[serde(default, deserialize_with = "units::accelerations")]
    pub gravity: [f64; 3],
    /// Displacement of the centre (x, y) at the start, m.
    #[serde(default, deserialize_with = "units::lengths")]
    pub displacement: [f64; 2],
    /// Form of the pockets.
    #[serde(with = "PocketShapeDef")]
    pub pockets: PocketShape,
    /// The lands that guide it; none where the balls alone do.
    #[serde(default)]
    pub lands: Vec<CageLandSpec>,
}

/// [`PocketShape`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "PocketShape", deny_unknown_fields)]
enum PocketShapeDef {
    Cylinder,
    Sphere,
    RaceTrack {
        #[serde(deserialize_with = "units::length")]
        axial_gap: f64,
    },
}

/// A land of a ring for a free cage.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CageLandSpec {
    /// The ring whose land it is.
    pub land: Side,
    /// Plane of its middle from the plane of the pockets, m.
    #[serde(default, deserialize_with = "units::length")]
    pub axial: f64,
    /// Radius of the land, m.
    #[serde(deserialize_with = "units::length")]
    pub radius: f64,
    /// Width between its edges, m.
    #[serde(deserialize_with = "units::length")]
    pub width: f64,
    /// Radial gap about the centred cage, m.
    #[serde(deserialize_with = "units::length")]
    pub gap: f64,
    /// Stiffness of an edge against the cage, N/m.
    #[serde(deserialize_with = "units::stiffness")]
    pub stiffness: f64,
    /// Damping χ of the edges (Hunt and Crossley), s/m.
    #[serde(default, deserialize_with = "units::slowness")]
    pub damping: f64,
    /// Friction coefficient of the edges.
    pub friction: f64,
    /// The fluid in the gap; a dry land has none.
    #[serde(default)]
    pub film: Option<LandFilmSpec>,
}

/// The fluid between land and cage.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LandFilmSpec {
    /// Dynamic viscosity, Pa s.
    #[serde(deserialize_with = "units::viscosity")]
    pub viscosity: f64,
    /// Density, kg/m³.
    #[serde(deserialize_with = "units::density")]
    pub density: f64,
    /// Share of the gap that is full.
    pub fill: f64,
    /// How far round it reaches.
    #[serde(with = "FilmExtentDef")]
    pub extent: FilmExtent,
    /// Height of the surfaces' roughness, m.
    #[serde(deserialize_with = "units::length")]
    pub roughness: f64,
}

/// [`FilmExtent`] as a file has it.
#[derive(Deserialize)]
#[serde(remote = "FilmExtent", deny_unknown_fields)]
enum FilmExtentDef {
    Half,
    Full,
}
