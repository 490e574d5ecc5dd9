//! The shape of a shaft's file: sections, bearings, loads, housings, in SI.

use crate::schema::{RingClassSpec, WithinSpec, seat_class};
use crate::units;
use crate::{MaterialSpec, MountingSpec};
use serde::Deserialize;
use tribodyn_bearing::fits::{RingClass, SeatClass, Within};

/// A shaft in its bearings. Axes are those of a case: x and y radial, z along the shaft from its first end.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShaftSystem {
    /// A title for reports.
    pub name: String,
    /// Speed of the shaft about +z, rad/s.
    #[serde(deserialize_with = "units::speed")]
    pub speed: f64,
    /// The shaft.
    pub shaft: ShaftSpec,
    /// Its bearings.
    pub bearings: Vec<ShaftBearingSpec>,
    /// Forces, moments, gears and belts.
    #[serde(default)]
    pub loads: Vec<LoadSpec>,
    /// Rigid bodies that the shaft carries.
    #[serde(default)]
    pub discs: Vec<DiscSpec>,
    /// Weight of shaft and discs; without it they weigh nothing.
    #[serde(default)]
    pub weight: Option<WeightSpec>,
    /// Temperatures of shaft and housing, which shift the seats along z.
    #[serde(default)]
    pub heat: Option<ShaftHeatSpec>,
    /// File with the stiffness of a housing over all seats.
    #[serde(default)]
    pub housing: Option<HousingFile>,
    /// Load cases with the shares of time in which they run; without it the loads act all the time.
    #[serde(default)]
    pub spectrum: Vec<DutySpec>,
}

/// Sections of a shaft one after the other.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShaftSpec {
    /// Material of all sections that have none of their own.
    pub material: MaterialSpec,
    /// Sections from z = 0.
    pub sections: Vec<SectionSpec>,
    /// Longest beam element, m; a twentieth of the shaft where left out.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub longest_element: Option<f64>,
}

/// A cylinder or a cone.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionSpec {
    /// Length, m.
    #[serde(deserialize_with = "units::length")]
    pub length: f64,
    /// Outer diameter at its start, m.
    #[serde(deserialize_with = "units::length")]
    pub outer: f64,
    /// Outer diameter at its end, m; that of the start where left out.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub outer_end: Option<f64>,
    /// Inner diameter at its start, m; a solid section where left out.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub inner: Option<f64>,
    /// Inner diameter at its end, m; that of the start where left out.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub inner_end: Option<f64>,
    /// Material, where it is not that of the shaft.
    #[serde(default)]
    pub material: Option<MaterialSpec>,
}

/// A bearing on the shaft.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShaftBearingSpec {
    /// Name for tables.
    pub name: String,
    /// Distance of its middle from the start of the shaft, m.
    #[serde(deserialize_with = "units::length")]
    pub at: f64,
    /// Which bearing it is.
    pub bearing: BearingChoice,
    /// Axial load that it carries: with an angular-contact bearing one direction.
    pub carries: Carries,
    /// Seat of its outer ring along z: fixed or sliding.
    pub outer_ring: OuterRing,
    /// Preload; without it an angular-contact bearing just touches and a deep-groove bearing stands in its middle.
    #[serde(default)]
    pub preload: Option<PreloadSpec>,
    /// Radial internal clearance in operation, m, instead of that of the bearing.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub clearance: Option<f64>,
    /// Fits and temperatures of the rings, instead of those of the bearing's case.
    #[serde(default)]
    pub mounting: Option<MountingSpec>,
    /// Fits of the rings by tolerance class, from which the mounting follows.
    #[serde(default)]
    pub fits: Option<FitsSpec>,
    /// Stiffness of the housing about the seat; a rigid one where left out.
    #[serde(default)]
    pub housing: Option<SeatStiffness>,
    /// Damping of bearing and seat along x and y, N s/m; none where left out.
    #[serde(default, deserialize_with = "units::optional_damping")]
    pub damping: Option<f64>,
}

/// Fits by tolerance class on a shaft whose sections are known.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FitsSpec {
    /// Class of the seat on the shaft, such as `k5`.
    #[serde(deserialize_with = "seat_class")]
    pub shaft: SeatClass,
    /// Class of the seat in the housing, such as `H7`.
    #[serde(deserialize_with = "seat_class")]
    pub housing: SeatClass,
    /// Outside diameter of the housing, m, taken as a ring.
    #[serde(deserialize_with = "units::length")]
    pub housing_outside: f64,
    /// Material of the housing; that of the shaft where left out.
    #[serde(default)]
    pub housing_material: Option<MaterialSpec>,
    /// Class of the bearing.
    #[serde(with = "RingClassSpec")]
    pub ring: RingClass,
    /// Which of the fits that these classes allow.
    #[serde(with = "WithinSpec")]
    pub within: Within,
    /// Roughness R_z of seat and ring together, m.
    #[serde(deserialize_with = "units::length")]
    pub roughness: f64,
    /// Coefficient of thermal expansion of rings and balls, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub expansion: f64,
}

/// Where the bearing comes from.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum BearingChoice {
    /// A designation of the built-in list, with the letter of its contact angle: `Listed("7210B")`.
    Listed(String),
    /// A case file, from the folder of the shaft's file.
    Case(String),
}

/// Axial load that a bearing takes from the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Carries {
    /// A shaft that is pushed along +z.
    PlusZ,
    /// A shaft that is pushed along −z.
    MinusZ,
    /// Both: a bearing given by its radial clearance.
    Both,
}

/// How an outer ring sits in its housing along z.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum OuterRing {
    /// Held.
    Fixed,
    /// It slides, pushed along +z by a spring's force, N; 0 for none.
    Slides(#[serde(deserialize_with = "units::force")] f64),
}

/// How a bearing is pressed along z when nothing else loads the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum PreloadSpec {
    /// Displacement of its inner ring into the load, m: half of what the rings of a pair lack.
    Offset(#[serde(deserialize_with = "units::length")] f64),
    /// Axial force that the offset gives at rest, N.
    Force(#[serde(deserialize_with = "units::force")] f64),
}

/// Stiffness of a seat in its own axes.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeatStiffness {
    /// Along x and y, N/m.
    #[serde(deserialize_with = "units::stiffness")]
    pub radial: f64,
    /// Along z, N/m.
    #[serde(deserialize_with = "units::stiffness")]
    pub axial: f64,
    /// About x and y, N m/rad.
    #[serde(deserialize_with = "units::tilt_stiffness")]
    pub tilt: f64,
    /// Mass that moves with the seat, kg; one that follows at once where left out.
    #[serde(default, deserialize_with = "units::optional_mass")]
    pub mass: Option<f64>,
}

/// A load on the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum LoadSpec {
    /// A force.
    Force {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// Along x, N.
        #[serde(deserialize_with = "units::force")]
        x: f64,
        /// Along y, N.
        #[serde(deserialize_with = "units::force")]
        y: f64,
        /// Along z, N.
        #[serde(deserialize_with = "units::force")]
        z: f64,
    },
    /// A bending moment.
    Moment {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// About x, N m.
        #[serde(deserialize_with = "units::torque")]
        x: f64,
        /// About y, N m.
        #[serde(deserialize_with = "units::torque")]
        y: f64,
    },
    /// A torque about +z, of a coupling or a motor.
    Torque {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// Torque on the shaft, N m.
        #[serde(deserialize_with = "units::torque")]
        torque: f64,
    },
    /// A belt or chain: the sum of its strands pulls in one direction.
    Belt {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// Sum of the forces of both strands, N.
        #[serde(deserialize_with = "units::force")]
        pull: f64,
        /// Direction of the pull from x towards y, rad.
        #[serde(deserialize_with = "units::angle")]
        direction: f64,
        /// Torque on the shaft about +z, N m.
        #[serde(deserialize_with = "units::torque")]
        torque: f64,
    },
    /// A spur or helical gear.
    Gear {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// Pitch diameter, m.
        #[serde(deserialize_with = "units::length")]
        pitch_diameter: f64,
        /// Torque on the shaft about +z, N m.
        #[serde(deserialize_with = "units::torque")]
        torque: f64,
        /// Normal pressure angle α_n, rad.
        #[serde(deserialize_with = "units::angle")]
        pressure_angle: f64,
        /// Helix angle β, rad; above 0 for a right-hand helix.
        #[serde(deserialize_with = "units::angle")]
        helix_angle: f64,
        /// Where the teeth meet, from x towards y, rad.
        #[serde(deserialize_with = "units::angle")]
        contact: f64,
    },
    /// A mass off the axis, which turns with the shaft.
    Unbalance {
        /// Distance from the start of the shaft, m.
        #[serde(deserialize_with = "units::length")]
        at: f64,
        /// Mass times eccentricity, kg m.
        #[serde(deserialize_with = "units::unbalance")]
        moment: f64,
        /// Phase, rad.
        #[serde(deserialize_with = "units::angle")]
        phase: f64,
    },
}

impl LoadSpec {
    /// Distance from the start of the shaft, m.
    pub fn at(&self) -> f64 {
        match *self {
            Self::Force { at, .. }
            | Self::Moment { at, .. }
            | Self::Torque { at, .. }
            | Self::Belt { at, .. }
            | Self::Gear { at, .. }
            | Self::Unbalance { at, .. } => at,
        }
    }
}

/// A rigid disc.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DiscSpec {
    /// Distance of its middle from the start of the shaft, m.
    #[serde(deserialize_with = "units::length")]
    pub at: f64,
    /// Mass, kg.
    #[serde(deserialize_with = "units::mass")]
    pub mass: f64,
    /// Moment of inertia about a diameter, kg m².
    #[serde(deserialize_with = "units::inertia")]
    pub transverse_inertia: f64,
    /// Moment of inertia about the axis, kg m².
    #[serde(deserialize_with = "units::inertia")]
    pub polar_inertia: f64,
}

/// Direction of the weight.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum WeightSpec {
    /// Across the shaft, at an angle from x towards y, rad.
    Across(#[serde(deserialize_with = "units::angle")] f64),
    /// Along +z.
    PlusZ,
    /// Along −z.
    MinusZ,
}

/// Mean temperatures of shaft and housing.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShaftHeatSpec {
    /// Coefficient of thermal expansion of the shaft, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub shaft_expansion: f64,
    /// Temperature of the shaft over that of the drawing, K.
    #[serde(deserialize_with = "units::temperature_difference")]
    pub shaft_temperature_rise: f64,
    /// Coefficient of thermal expansion of the housing, 1/K.
    #[serde(deserialize_with = "units::expansion")]
    pub housing_expansion: f64,
    /// Temperature of the housing over that of the drawing, K.
    #[serde(deserialize_with = "units::temperature_difference")]
    pub housing_temperature_rise: f64,
}

/// A file of numbers separated by commas: 5 or 6 rows and columns for each seat, in SI.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum HousingFile {
    /// Path from the folder of the shaft's file.
    Matrix(String),
}

/// A load case.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DutySpec {
    /// Share of the time, 0 to 1; all shares make 1.
    pub share: f64,
    /// Factor on all loads.
    pub load: f64,
    /// Speed of the shaft, rad/s; that of the system where left out.
    #[serde(default, deserialize_with = "units::optional_speed")]
    pub speed: Option<f64>,
}
