//! Hertz's line contact: two cylinders with parallel axes.
//!
//! ```text
//! b = sqrt(8 w R/(π E'))     p_max = 2 w/(π b)     τ_max = 0.3003 p_max at the depth 0.7862 b
//! ```
//! w is the load per length, N/m, R the reciprocal of the curvature sum, E' as of the point contact. In the middle
//! plane the stresses over p_max at the depth ζ b are σ_across = −((1 + 2ζ²)/√(1 + ζ²) − 2ζ), σ_depth = −1/√(1 + ζ²),
//! σ_along = ν (σ_across + σ_depth); half the difference of the first two is largest at ζ² = (√5 − 1)/2 (K. L.
//! Johnson, Contact Mechanics, 1985, chapter 4.2c, doi:10.1017/CBO9781139171731).

use crate::{ContactError, Subsurface};
use std::f64::consts::PI;

/// A line contact under one load, its ends left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    /// Half the width of the strip b, m.
    pub half_width: f64,
    /// Highest pressure, Pa.
    pub peak_pressure: f64,
}

impl LineContact {
    /// Cylinders whose curvatures (1/m) have this sum, of the effective modulus E' (Pa), under a load per length (N/m).
    ///
    /// # Errors
    /// [`ContactError::Curvature`] and [`ContactError::Modulus`] for sums and moduli that make no contact.
    pub fn new(curvature: f64, modulus: f64, load_per_length: f64) -> Result<Self, ContactError> {
        if !(curvature > 0.0 && curvature.is_finite()) {
            return Err(ContactError::Curvature { plane: "x", value: curvature });
        }
        if !(modulus > 0.0 && modulus.is_finite()) {
            return Err(ContactError::Modulus { value: modulus });
        }
        let load = load_per_length.max(0.0);
        let half_width = (8.0 * load / (PI * modulus * curvature)).sqrt();
        // 2 w/(π b), without dividing by a width of 0.
        let peak_pressure = (load * modulus * curvature / (2.0 * PI)).sqrt();
        Ok(Self { half_width, peak_pressure })
    }

    /// The largest shear stress across the strip, for a body of this Poisson's ratio; none without load.
    pub fn subsurface(&self, poisson: f64) -> Option<Subsurface> {
        if !(self.half_width > 0.0 && self.peak_pressure.is_finite()) {
            return None;
        }
        let depth = (0.5 * (5f64.sqrt() - 1.0)).sqrt();
        let root = (1.0 + depth * depth).sqrt();
        let (across, below) = (2.0 * depth - (1.0 + 2.0 * depth * depth) / root, -1.0 / root);
        let along = poisson * (across + below);
        let squares = (across - below).powi(2) + (below - along).powi(2) + (along - across).powi(2);
        Some(Subsurface {
            max_shear: 0.5 * (across - below) * self.peak_pressure,
            max_shear_depth: depth * self.half_width,
            von_mises: (0.5 * squares).sqrt() * self.peak_pressure,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::HertzContact;

    const MODULUS: f64 = 226.4e9;

    fn close(found: f64, expected: f64, relative: f64) {
        assert!((found / expected - 1.0).abs() < relative, "{found} instead of {expected}");
    }

    /// The pressure carries the load: its integral over the strip is π/2 p b.
    #[test]
    fn identity_pressure_and_width_carry_the_load() {
        for load in [1.0, 1e4, 2e6] {
            let line = LineContact::new(80.0, MODULUS, load).unwrap();
            close(0.5 * PI * line.peak_pressure * line.half_width, load, 1e-14);
        }
    }

    /// A very long ellipse is a line: in its middle the load per length is π/2 p b, and stresses below it agree.
    #[test]
    fn limit_a_long_ellipse_is_a_line() {
        let (across, along) = (80.0, 80.0 / 3e5);
        let ellipse = HertzContact::new(across, along, MODULUS).unwrap().ellipse(500.0);
        let line = LineContact::new(across, MODULUS, 0.5 * PI * ellipse.peak_pressure * ellipse.semi_minor).unwrap();
        close(line.half_width, ellipse.semi_minor, 1e-4);
        close(line.peak_pressure, ellipse.peak_pressure, 1e-4);
        let [below, expected] = [line.subsurface(0.3).unwrap(), ellipse.subsurface(0.3).unwrap()];
        // The ellipse's stresses come from a quadrature, which is 4e-4 off at this length.
        close(below.max_shear, expected.max_shear, 1e-3);
        close(below.max_shear_depth, expected.max_shear_depth, 1e-3);
        close(below.von_mises, expected.von_mises, 1e-3);
    }

    /// K. L. Johnson, Contact Mechanics, 1985, equation 4.49: 0.30 p_max at 0.78 b.
    #[test]
    fn paper_largest_shear_stress_below_a_line() {
        let below = LineContact { half_width: 1.0, peak_pressure: 1.0 }.subsurface(0.3).unwrap();
        assert!((below.max_shear - 0.30).abs() < 5e-3 && (below.max_shear_depth - 0.78).abs() < 1e-2, "{below:?}");
    }

    #[test]
    fn limit_what_is_no_line_contact_is_refused() {
        for (curvature, modulus) in [(0.0, MODULUS), (-1.0, MODULUS), (f64::NAN, MODULUS), (80.0, 0.0)] {
            assert!(LineContact::new(curvature, modulus, 1.0).is_err());
        }
        let line = LineContact::new(80.0, MODULUS, 0.0).unwrap();
        assert!(line.half_width == 0.0 && line.peak_pressure == 0.0 && line.subsurface(0.3).is_none());
    }
}
