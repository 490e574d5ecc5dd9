//! Fits and temperatures of the rings: what makes a mounted and running bearing differ from the one of the drawing.

use super::MaterialSpec;
use crate::units;
use serde::Deserialize;
use serde::de::{Deserializer, Error};
use tribodyn_bearing::fits::{FitError, Interference, RingClass, SeatClass, Within, effective_interference};

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
    /// loose fit. Absent where `fit` gives it.
    #[serde(default, deserialize_with = "units::optional_length")]
    pub interference: Option<f64>,
    /// Tolerance classes of seat and ring, in place of an interference.
    #[serde(default)]
    pub fit: Option<FitSpec>,
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

/// A fit by tolerance classes: ISO 286 of the seat, ISO 492 of the ring.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FitSpec {
    /// Class of the seat, such as `k5` on a shaft or `H7` in a housing.
    #[serde(deserialize_with = "seat_class")]
    pub class: SeatClass,
    /// Class of the bearing.
    #[serde(with = "RingClassSpec")]
    pub ring: RingClass,
    /// Which of the fits that these classes allow.
    #[serde(with = "WithinSpec")]
    pub within: Within,
    /// Roughness R_z of seat and ring together, m, of which the fit loses a share.
    #[serde(deserialize_with = "units::length")]
    pub roughness: f64,
}

pub(crate) fn seat_class<'de, D: Deserializer<'de>>(deserializer: D) -> Result<SeatClass, D::Error> {
    let text = String::deserialize(deserializer)?;
    SeatClass::parse(&text).map_err(D::Error::custom)
}

#[derive(Deserialize)]
#[serde(remote = "RingClass")]
pub(crate) enum RingClassSpec {
    Normal,
    P6,
    P5,
    P4,
    P2,
}

#[derive(Deserialize)]
#[serde(remote = "Within")]
pub(crate) enum WithinSpec {
    Loosest,
    LikelyLoosest,
    Mean,
    LikelyTightest,
    Tightest,
}

impl FitSpec {
    /// Interference at a nominal diameter (m), before surfaces are smoothed.
    ///
    /// # Errors
    /// [`FitError::Diameter`] where a class ends before it.
    pub fn interference(&self, diameter: f64) -> Result<Interference, FitError> {
        Interference::of(self.class, self.ring, diameter)
    }
}

impl SeatSpec {
    /// Interference that works in a seat of a diameter (m): as given, or what a fit leaves.
    pub fn effective_interference(&self, diameter: f64) -> f64 {
        let by_class = self.fit.and_then(|fit| {
            let measured = fit.interference(diameter).ok()?.within(fit.within);
            Some(effective_interference(measured, fit.roughness))
        });
        // A checked case has one of both.
        by_class.or(self.interference).unwrap_or(0.0)
    }
}

impl MountingSpec {
    /// The same mounting with seats at another place within their classes.
    pub fn within(self, within: Within) -> Self {
        let moved = |ring: MountedRingSpec| MountedRingSpec {
            seat: ring.seat.map(|seat| SeatSpec { fit: seat.fit.map(|fit| FitSpec { within, ..fit }), ..seat }),
            ..ring
        };
        Self { inner: moved(self.inner), outer: moved(self.outer), ball: self.ball }
    }
}
