//! Tolerances of bores and outside diameters of radial bearings (ISO 492): from 0 down, µm.
//!
//! Sources: SKF (Normal and P5), Consolidated Bearings and GLD (P6), Lily (Normal to P4, bores), groove-ballbearing.com
//! (P4, outside), Loyal (P2), all after ISO 492.

use super::grades::range;
use super::{Deviations, FitError};
use crate::Side;

/// Tolerance class of a bearing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RingClass {
    /// Class 0 or Normal (ABEC 1).
    Normal,
    /// Class 6 (ABEC 3).
    P6,
    /// Class 5 (ABEC 5).
    P5,
    /// Class 4 (ABEC 7).
    P4,
    /// Class 2 (ABEC 9).
    P2,
}

const BORES: [f64; 12] = [2.5, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0];
const OUTSIDES: [f64; 11] = [18.0, 30.0, 50.0, 80.0, 120.0, 150.0, 180.0, 250.0, 315.0, 400.0, 500.0];

impl RingClass {
    /// All classes.
    pub const ALL: [Self; 5] = [Self::Normal, Self::P6, Self::P5, Self::P4, Self::P2];

    /// Name in designations.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal => "Normal",
            Self::P6 => "P6",
            Self::P5 => "P5",
            Self::P4 => "P4",
            Self::P2 => "P2",
        }
    }

    /// Low deviations by range of diameter, and the ends of these ranges.
    fn table(self, side: Side) -> (&'static [f64], &'static [f64]) {
        let low: &[f64] = match (side, self) {
            (Side::Inner, Self::Normal) => &[8.0, 8.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0],
            (Side::Inner, Self::P6) => &[7.0, 7.0, 7.0, 8.0, 10.0, 12.0, 15.0, 18.0, 22.0],
            (Side::Inner, Self::P5) => &[5.0, 5.0, 5.0, 6.0, 8.0, 9.0, 10.0, 13.0, 15.0, 18.0, 23.0, 28.0],
            (Side::Inner, Self::P4) => &[4.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0],
            (Side::Inner, Self::P2) => &[2.5, 2.5, 2.5, 2.5, 2.5, 4.0, 5.0, 7.0],
            (Side::Outer, Self::Normal) => &[8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 25.0, 30.0, 35.0, 40.0, 45.0],
            (Side::Outer, Self::P6) => &[7.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 25.0, 28.0, 33.0],
            (Side::Outer, Self::P5) => &[5.0, 6.0, 7.0, 9.0, 10.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0],
            (Side::Outer, Self::P4) => &[4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 13.0, 15.0],
            (Side::Outer, Self::P2) => &[2.5, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 8.0],
        };
        let ends: &[f64] = if side == Side::Inner { &BORES } else { &OUTSIDES };
        (low, &ends[..low.len()])
    }

    /// Limit deviations of the bore of an inner ring, or of the outside diameter of an outer one, m.
    ///
    /// # Errors
    /// [`FitError::Diameter`] where the class ends before this diameter.
    pub fn deviations(self, side: Side, diameter: f64) -> Result<Deviations, FitError> {
        let (low, ends) = self.table(side);
        let at = range(ends, diameter * 1e3).ok_or_else(|| FitError::Diameter {
            class: self.name().to_owned(),
            diameter_mm: diameter * 1e3,
            largest_mm: ends[ends.len() - 1],
        })?;
        Ok(Deviations { low: -low[at] * 1e-6, high: 0.0 })
    }
}
