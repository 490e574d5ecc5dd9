//! Ring growth: what fits, rotation and heat make of a bearing's clearance, groove radii and contact angle.
//!
//! Each ring is a plain cylinder between its seat and the bottom of its groove, on a shaft or in a housing that is one
//! too. Where the interference left by rotation and heat is positive, a pressure in the seat makes both grow together;
//! where it is not, the ring is loose and grows freely. Grooves move with the bottom of the race, and their radii and
//! the balls grow by heat. Widths, shoulders and the bending of rings are not in it.

use crate::BearingError;
use crate::cylinder::Cylinder;
use crate::geometry::{Dimensions, Fit, Geometry};
use crate::races::{Races, Side};

/// Seat of a ring on a shaft or in a housing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seat {
    /// Diameter of the shaft over that of the bore, or of the outer ring over that of the housing, m, at rest and at
    /// the temperature of the drawing; negative for a loose fit.
    pub interference: f64,
    /// The shaft or the housing.
    pub partner: Cylinder,
}

/// A ring in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MountedRing {
    /// The ring, from its bore to the bottom of its groove, or from there to its outside diameter.
    pub ring: Cylinder,
    /// Its seat; absent for a ring that nothing holds.
    pub seat: Option<Seat>,
}

/// All that changes a bearing between the drawing and operation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Both rings.
    pub rings: Races<MountedRing>,
    /// Thermal strain of the balls, α_th ΔT.
    pub ball_strain: f64,
}

/// A bearing as it is after growth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrownBearing {
    /// Its geometry.
    pub geometry: Geometry,
    /// Growth of the radius of each groove's bottom, m.
    pub raceway_growth: Races<f64>,
    /// Pressure in each seat, Pa: 0 where the ring is loose, absent without a seat.
    pub seat_pressure: Races<Option<f64>>,
}

impl Seat {
    fn at_rest(self) -> Self {
        Self { partner: self.partner.at_rest(), ..self }
    }
}

impl MountedRing {
    /// Growth of the radius of the groove's bottom, m, and the pressure in the seat, Pa.
    fn growth(&self, side: Side) -> (f64, Option<f64>) {
        let ring = &self.ring;
        let (seat_radius, raceway) = match side {
            Side::Inner => (ring.inner_radius, ring.outer_radius),
            Side::Outer => (ring.outer_radius, ring.inner_radius),
        };
        let free = ring.free_growth(raceway);
        let Some(Seat { interference, partner }) = &self.seat else { return (free, None) };
        let apart = partner.free_growth(seat_radius) - ring.free_growth(seat_radius);
        let (overlap, give, per_pascal) = match side {
            Side::Inner => (
                0.5 * interference + apart,
                ring.growth_by_inner_pressure(seat_radius) - partner.growth_by_outer_pressure(seat_radius),
                ring.growth_by_inner_pressure(raceway),
            ),
            Side::Outer => (
                0.5 * interference - apart,
                partner.growth_by_inner_pressure(seat_radius) - ring.growth_by_outer_pressure(seat_radius),
                ring.growth_by_outer_pressure(raceway),
            ),
        };
        let pressure = (overlap / give).max(0.0);
        (free + pressure * per_pascal, Some(pressure))
    }
}

impl Growth {
    /// The same bearing mounted, before it turns and warms up.
    pub fn mounted(&self) -> Self {
        let still = |m: MountedRing| MountedRing { ring: m.ring.at_rest(), seat: m.seat.map(Seat::at_rest) };
        Self { rings: self.rings.map(still), ball_strain: 0.0 }
    }

    /// The bearing that grows out of the one of the drawing.
    ///
    /// # Errors
    /// [`BearingError::Clearance`] where growth leaves no contact angle, or presses the balls by more than a tenth of
    /// the distance of the groove centres.
    pub fn apply(&self, drawn: &Geometry) -> Result<GrownBearing, BearingError> {
        let both = Races::from_fn(|side| self.rings[side].growth(side));
        let (raceway_growth, seat_pressure) = (both.map(|(growth, _)| growth), both.map(|(_, pressure)| pressure));
        let ball_diameter = drawn.ball_diameter * (1.0 + self.ball_strain);
        let groove = Races::from_fn(|side| {
            let ring = &self.rings[side].ring;
            let strain = ring.solid.expansion * ring.temperature_rise;
            drawn.coefficient(side) * drawn.ball_diameter * (1.0 + strain)
        });
        // Circles of the groove centres: the bottom of the race and a groove radius from it.
        let centre = Races::from_fn(|side| {
            let bottom = drawn.groove_bottom_radius(side) + raceway_growth[side];
            match side {
                Side::Inner => bottom + groove[side],
                Side::Outer => bottom - groove[side],
            }
        });
        let distance = groove.inner + groove.outer - ball_diameter;
        let clearance = 2.0 * (distance - (centre.inner - centre.outer));
        let [inner_coefficient, outer_coefficient] = Side::BOTH.map(|side| groove[side] / ball_diameter);
        let cosine = ((centre.inner - centre.outer) / distance).min(1.0);
        // The balls touch the outer race at the free contact angle.
        let orbit = centre.outer + (groove.outer - 0.5 * ball_diameter) * cosine;
        let grown = Geometry::new(Dimensions {
            ball_count: drawn.ball_count,
            ball_diameter,
            pitch_diameter: 2.0 * orbit,
            inner_coefficient,
            outer_coefficient,
            fit: Fit::RadialClearance(clearance),
        })?;
        let geometry = grown.with_shoulders(drawn.shoulders);
        Ok(GrownBearing { geometry, raceway_growth, seat_pressure })
    }
}

#[cfg(test)]
#[path = "growth_test.rs"]
mod tests;
