//! Fits of bearing seats by tolerance classes: from `k5` or `H7` to an interference and its range.
//!
//! Seats have the classes of ISO 286, the bores and outside diameters of rings those of ISO 492, from 0 down. The
//! interference is the difference of both diameters. Where they scatter normally, each within its tolerance T at six
//! standard deviations, that of the pair lies within ½ √(T_seat² + T_ring²) of the mean: the likely range, which SKF's
//! tables of probable fits agree with to 1 µm. Surfaces that are pressed together are smoothed: 0.4 R_z of both of them
//! is lost (DIN 7190-1:2017).

mod class;
mod grades;
mod ring;

use crate::Side;
pub use class::SeatClass;
pub use ring::RingClass;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// No class, or none that bearing seats have.
    #[error(
        "`{text}` is no tolerance class of a bearing seat: allowed for shafts are f, g, h, js with grades 4 to 10, j 5 to 7, k, m, n, p, r 4 to 8, such as k5; for housings F, G, H, JS 4 to 10, J 6 to 8, K, M, N, P, R 4 to 8, such as H7"
    )]
    Class {
        /// The text that was given.
        text: String,
    },
    /// A class of the other seat.
    #[error("{}", match .side {
        Side::Inner => "an inner ring sits on a shaft, whose classes have small letters, such as k5",
        Side::Outer => "an outer ring sits in a housing, whose classes have capitals, such as H7",
    })]
    Seat {
        /// The ring.
        side: Side,
    },
    /// A diameter that the tables do not have.
    #[error("class {class} has no tolerance at a diameter of {diameter_mm} mm: allowed is up to {largest_mm} mm")]
    Diameter {
        /// The class.
        class: String,
        /// The diameter, mm.
        diameter_mm: f64,
        /// Largest diameter of the table, mm.
        largest_mm: f64,
    },
}

/// Limits of a diameter against its nominal size, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviations {
    /// Lower limit deviation.
    pub low: f64,
    /// Upper limit deviation.
    pub high: f64,
}

impl Deviations {
    fn width(&self) -> f64 {
        self.high - self.low
    }

    fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// Which of the seats of a class a bearing sits on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Within {
    /// The loosest fit that the tolerances allow.
    Loosest,
    /// The loose end of the likely range.
    LikelyLoosest,
    /// The middle of both tolerances.
    Mean,
    /// The tight end of the likely range.
    LikelyTightest,
    /// The tightest fit that the tolerances allow.
    Tightest,
}

/// Interference of a fit, m: above 0 where shaft or ring is larger than its seat, below 0 where there is play.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interference {
    /// Smallest.
    pub loosest: f64,
    /// Range of 99.7 % of all pairs.
    pub likely: [f64; 2],
    /// Of the middle of both tolerances.
    pub mean: f64,
    /// Largest.
    pub tightest: f64,
}

impl Interference {
    /// Of a seat with a ring of a nominal diameter, m.
    ///
    /// # Errors
    /// [`FitError::Diameter`] where a class ends before it.
    pub fn of(seat: SeatClass, ring: RingClass, diameter: f64) -> Result<Self, FitError> {
        let (on_seat, on_ring) = (seat.deviations(diameter)?, ring.deviations(seat.side(), diameter)?);
        // Shaft less bore, or outer ring less housing.
        let (inside, outside) = match seat.side() {
            crate::Side::Inner => (on_seat, on_ring),
            crate::Side::Outer => (on_ring, on_seat),
        };
        let mean = inside.middle() - outside.middle();
        let half = 0.5 * inside.width().hypot(outside.width());
        Ok(Self {
            loosest: inside.low - outside.high,
            likely: [mean - half, mean + half],
            mean,
            tightest: inside.high - outside.low,
        })
    }

    /// One of its values.
    pub fn within(&self, within: Within) -> f64 {
        match within {
            Within::Loosest => self.loosest,
            Within::LikelyLoosest => self.likely[0],
            Within::Mean => self.mean,
            Within::LikelyTightest => self.likely[1],
            Within::Tightest => self.tightest,
        }
    }
}

/// Share of the roughness R_z of both surfaces that an interference loses when they are smoothed (DIN 7190-1:2017, as
/// the manual of MESYS has it; before 2017 the standard had 0.8).
const SMOOTHED: f64 = 0.4;

/// Interference (m) that is left of a measured one between surfaces of a roughness R_z, summed over both, m.
pub fn effective_interference(measured: f64, roughness: f64) -> f64 {
    if measured > 0.0 { (measured - SMOOTHED * roughness).max(0.0) } else { measured }
}

#[cfg(test)]
mod tests;
