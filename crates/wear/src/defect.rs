//! A local defect of a raceway: a pit, or a patch where the coating is gone.

use crate::WearError;
use serde::{Deserialize, Serialize};
use std::f64::consts::{PI, TAU};

/// A defect over a sector of the raceway, in the ring's own frame.
///
/// With the distance θ from the middle and the full width w, its depth is a raised cosine, ½ D (1 + cos(2πθ/w)): D in
/// the middle, 0 with slope 0 at the edges, so that a ball rolls in and out without a blow that the profile does not
/// have. The share of the coating that is gone is full over the middle half of the sector and falls to 0 over the outer
/// quarters, by a raised cosine too: a patch without coating is flat, its edges are as sharp as a contact ellipse lets
/// them appear.
///
/// The depth is what the middle of the ball sinks by. A ball of radius r bridges a pit that is narrow against its
/// depth: it touches the bottom of a pit of the length s only where that is no deeper than about s²/(8r).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Defect {
    /// Middle of the sector, rad.
    pub azimuth: f64,
    /// Full width w of the sector, rad, above 0 and below 2π.
    pub width: f64,
    /// Depth D in the middle, m.
    pub depth: f64,
    /// Part of the coating that is gone, 0 to 1.
    pub bare: f64,
}

impl Defect {
    /// Checks the values.
    pub(crate) fn check(&self) -> Result<(), WearError> {
        let refuse = |name, value, allowed| Err(WearError::Defect { name, value, allowed });
        if !self.azimuth.is_finite() {
            return refuse("azimuth", self.azimuth, "a finite angle in rad");
        }
        if !(self.width > 0.0 && self.width < TAU) {
            return refuse("width", self.width, "above 0 and below 2π rad");
        }
        if !(self.depth >= 0.0 && self.depth.is_finite()) {
            return refuse("depth", self.depth, "finite and at least 0 m");
        }
        if !(0.0..=1.0).contains(&self.bare) {
            return refuse("bare", self.bare, "0 to 1");
        }
        Ok(())
    }

    /// Depth, m, its derivative by the azimuth, m/rad, and the part of the coating that is gone.
    #[inline]
    pub(crate) fn at(&self, azimuth: f64) -> (f64, f64, f64) {
        // −π to π, whatever the number of turns between the two; half the time of a remainder.
        let distance = azimuth - self.azimuth;
        let distance = distance - TAU * (distance * (1.0 / TAU) + 0.5).floor();
        let share = distance.abs() / self.width;
        if share >= 0.5 {
            return (0.0, 0.0, 0.0);
        }
        let (sin, cos) = (TAU * distance / self.width).sin_cos();
        let depth = 0.5 * self.depth * (1.0 + cos);
        let slope = -self.depth * sin * PI / self.width;
        // 0 at a quarter of the width from the middle, 1 at the edge.
        let edge = (4.0 * share - 1.0).max(0.0);
        (depth, slope, self.bare * 0.5 * (1.0 + (PI * edge).cos()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIT: Defect = Defect { azimuth: 6.2, width: 0.3, depth: 2e-5, bare: 0.8 };

    #[test]
    fn limit_middle_edges_and_outside() {
        assert_eq!(PIT.at(6.2), (2e-5, -0.0, 0.8));
        for outside in [6.2 - 0.1501, 6.2 + 0.1501, 3.0, -3.0, 0.0669 + TAU] {
            assert_eq!(PIT.at(outside), (0.0, 0.0, 0.0), "{outside}");
        }
        // The sector reaches over 2π, and turns do not matter.
        let (depth, slope, bare) = PIT.at(0.05);
        assert!(depth > 0.0 && slope < 0.0 && bare > 0.0);
        let turned = PIT.at(0.05 - 7.0 * TAU);
        assert!((turned.0 - depth).abs() < 1e-17 && (turned.1 - slope).abs() < 1e-15);
        // The coating is gone as far as a quarter of the width from the middle, and half gone between there and the
        // edge.
        assert_eq!(PIT.at(6.2 + 0.0749).2, 0.8);
        assert!((PIT.at(6.2 - 0.1125).2 - 0.4).abs() < 1e-12);
    }

    /// The mean of a raised cosine is half its height.
    #[test]
    fn identity_slope_is_the_derivative_and_the_area_half_the_rectangle() {
        let (n, step) = (3000, 1e-6);
        let mut area = 0.0;
        for i in 0..n {
            let azimuth = 6.2 + PIT.width * ((f64::from(i) + 0.5) / f64::from(n) - 0.5) * 1.2;
            let difference = (PIT.at(azimuth + step).0 - PIT.at(azimuth - step).0) / (2.0 * step);
            assert!((difference - PIT.at(azimuth).1).abs() < 2e-9, "{azimuth}");
            area += PIT.at(azimuth).0 * 1.2 * PIT.width / f64::from(n);
        }
        assert!((area / (0.5 * PIT.depth * PIT.width) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn limit_values_that_no_defect_has_are_refused() {
        let rows = [
            (Defect { azimuth: f64::NAN, ..PIT }, "azimuth"),
            (Defect { width: 0.0, ..PIT }, "width"),
            (Defect { width: TAU, ..PIT }, "width"),
            (Defect { depth: -1e-9, ..PIT }, "depth"),
            (Defect { depth: f64::INFINITY, ..PIT }, "depth"),
            (Defect { bare: 1.1, ..PIT }, "bare"),
        ];
        assert_eq!(PIT.check(), Ok(()));
        for (defect, field) in rows {
            assert!(matches!(defect.check(), Err(WearError::Defect { name, .. }) if name == field), "{defect:?}");
        }
    }
}
