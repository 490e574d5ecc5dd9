//! Friction torque of whole bearings by formula.

mod palmgren;
mod skf;

pub use palmgren::{PalmgrenBearing, PalmgrenTorque};
pub use skf::{SkfBearing, SkfLoads, SkfSeries, SkfTorque};

/// How the lubricant gets to the bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Supply {
    /// Oil that the balls pass through.
    Bath,
    /// A jet of oil.
    Jet,
    /// Drops of oil in air.
    OilAir,
    /// Grease.
    Grease,
}

impl Supply {
    /// Film thickness over that of a flooded contact, where nothing better is known.
    pub fn starvation(self) -> f64 {
        if self == Self::Grease { crate::GREASE_STARVATION } else { 1.0 }
    }
}
