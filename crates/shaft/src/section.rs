//! Cross-sections of a shaft: hollow circles, whose diameters may change along a part.

use serde::Serialize;
use std::f64::consts::PI;

/// Elastic constants and density of a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E, Pa.
    pub young: f64,
    /// Shear modulus G, Pa.
    pub shear: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
}

impl Material {
    /// From Young's modulus (Pa), Poisson's ratio and density (kg/m³).
    pub fn new(young: f64, poisson: f64, density: f64) -> Self {
        Self { young, shear: young / (2.0 * (1.0 + poisson)), density }
    }

    /// Poisson's ratio ν = E/2G − 1.
    pub fn poisson(&self) -> f64 {
        0.5 * self.young / self.shear - 1.0
    }
}

/// A hollow circle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Section {
    /// Outer diameter, m.
    pub outer: f64,
    /// Inner diameter, m; 0 for a solid shaft.
    pub inner: f64,
}

impl Section {
    /// A solid circle of a diameter in m.
    pub fn solid(outer: f64) -> Self {
        Self { outer, inner: 0.0 }
    }

    /// Area, m².
    pub fn area(&self) -> f64 {
        0.25 * PI * (self.outer.powi(2) - self.inner.powi(2))
    }

    /// Second moment of area about a diameter, m⁴.
    pub fn second_moment(&self) -> f64 {
        PI / 64.0 * (self.outer.powi(4) - self.inner.powi(4))
    }

    /// Cowper's shear coefficient κ for a Poisson's ratio: G. R. Cowper, J. Appl. Mech. 33 (1966) 335,
    /// doi:10.1115/1.3625046.
    pub fn shear_coefficient(&self, poisson: f64) -> f64 {
        let ratio = (self.inner / self.outer).powi(2);
        let square = (1.0 + ratio).powi(2);
        6.0 * (1.0 + poisson) * square / ((7.0 + 6.0 * poisson) * square + (20.0 + 12.0 * poisson) * ratio)
    }

    /// The section at a share of the way to another one, diameters changing linearly.
    pub fn towards(&self, other: &Self, share: f64) -> Self {
        let mix = |a: f64, b: f64| a + share * (b - a);
        Self { outer: mix(self.outer, other.outer), inner: mix(self.inner, other.inner) }
    }
}

#[cfg(test)]
mod tests {
    use super::Section;

    /// Solid: 6(1 + ν)/(7 + 6ν); a thin tube: 2(1 + ν)/(4 + 3ν), both of Cowper's paper.
    #[test]
    fn limit_shear_coefficient_of_solid_and_thin_circles() {
        let nu = 0.3;
        let solid = Section::solid(0.05).shear_coefficient(nu);
        assert!((solid - 6.0 * 1.3 / 8.8).abs() < 1e-15);
        let thin = Section { outer: 0.05, inner: 0.05 - 1e-9 }.shear_coefficient(nu);
        assert!((thin - 2.6 / 4.9).abs() < 1e-7, "{thin}");
    }
}
