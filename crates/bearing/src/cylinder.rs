//! Hollow cylinders that turn, warm up and are pressed together: rings, shafts and housings.
//!
//! Plane stress, Lamé's solution for pressure and the rotating disc: with inner radius a and outer radius b
//!
//! ```text
//! pressure inside    u(r) = p a² r/[E (b² − a²)] · [(1 − ν) + (1 + ν) b²/r²]
//! pressure outside   u(r) = −p b² r/[E (b² − a²)] · [(1 − ν) + (1 + ν) a²/r²]
//! rotation           u(r) = ρ ω² r/(8 E) · [(3 + ν)(1 − ν)(a² + b²) + (3 + ν)(1 + ν) a² b²/r² − (1 − ν²) r²]
//! heat               u(r) = α_th ΔT r
//! ```
//!
//! A thin ring grows ρ ω² r³/E by rotation. Source: S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd ed.,
//! McGraw-Hill 1970, sections 28 and 32.

use tribodyn_contact::ElasticBody;

/// A solid body's elasticity, density and thermal expansion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solid {
    /// Young's modulus and Poisson's ratio.
    pub elastic: ElasticBody,
    /// Density, kg/m³.
    pub density: f64,
    /// Coefficient of thermal expansion α_th, 1/K.
    pub expansion: f64,
}

/// A hollow cylinder, or a solid one with inner radius 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Material.
    pub solid: Solid,
    /// Inner radius a, m; 0 for a solid shaft.
    pub inner_radius: f64,
    /// Outer radius b, m.
    pub outer_radius: f64,
    /// Rotational speed, rad/s.
    pub speed: f64,
    /// Temperature over that of the drawing, K.
    pub temperature_rise: f64,
}

impl Cylinder {
    /// The same cylinder at rest, at the temperature of the drawing.
    pub fn at_rest(self) -> Self {
        Self { speed: 0.0, temperature_rise: 0.0, ..self }
    }

    /// Growth of radius r by rotation and heat without pressure, m.
    pub fn free_growth(&self, radius: f64) -> f64 {
        let ElasticBody { young, poisson } = self.solid.elastic;
        let (a2, b2, r2) = (self.inner_radius.powi(2), self.outer_radius.powi(2), radius * radius);
        let across = if a2 == 0.0 { 0.0 } else { (1.0 + poisson) * a2 * b2 / r2 };
        let bracket = (3.0 + poisson) * ((1.0 - poisson) * (a2 + b2) + across) - (1.0 - poisson * poisson) * r2;
        let rotation = self.solid.density * self.speed * self.speed * radius / (8.0 * young) * bracket;
        rotation + self.solid.expansion * self.temperature_rise * radius
    }

    /// Growth of radius r under a pressure inside, m/Pa.
    pub fn growth_by_inner_pressure(&self, radius: f64) -> f64 {
        self.lame(self.inner_radius, self.outer_radius, radius)
    }

    /// Growth of radius r under a pressure outside, m/Pa: negative.
    pub fn growth_by_outer_pressure(&self, radius: f64) -> f64 {
        -self.lame(self.outer_radius, self.inner_radius, radius)
    }

    fn lame(&self, pressed: f64, free: f64, radius: f64) -> f64 {
        let ElasticBody { young, poisson } = self.solid.elastic;
        let wall = self.outer_radius.powi(2) - self.inner_radius.powi(2);
        let bracket = (1.0 - poisson) + (1.0 + poisson) * (free / radius).powi(2);
        pressed * pressed * radius / (young * wall) * bracket
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const STEEL: Solid =
        Solid { elastic: ElasticBody { young: 208e9, poisson: 0.3 }, density: 7800.0, expansion: 11.5e-6 };

    fn cylinder(inner_radius: f64, outer_radius: f64) -> Cylinder {
        Cylinder { solid: STEEL, inner_radius, outer_radius, speed: 0.0, temperature_rise: 0.0 }
    }

    /// A thin ring of 68 mm mean radius at 14000 r/min grows ρ ω² r³/E: 25 µm.
    #[test]
    fn limit_a_thin_ring_grows_by_the_square_of_its_speed() {
        let speed = 14000.0 * PI / 30.0;
        let ring = Cylinder { speed, ..cylinder(67.5e-3, 68.5e-3) };
        let expected = 7800.0 * speed * speed * 68e-3f64.powi(3) / 208e9;
        assert!((expected - 25.3e-6).abs() < 0.1e-6, "{expected}");
        let found = ring.free_growth(68e-3);
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} is not {expected}");
        // A wall as thick as a bearing's inner ring: 1 % from the formula of the mean radius.
        let thick = Cylinder { speed, ..cylinder(64e-3, 72e-3) };
        assert!((thick.free_growth(68e-3) / expected - 1.0).abs() < 0.01);
    }

    /// From the stresses: u = r (σ_θ − ν σ_r)/E, with the textbook's stresses of a rotating and of a pressed cylinder.
    #[test]
    fn identity_growth_follows_from_lames_and_the_rotating_discs_stresses() {
        let (a, b, nu, young) = (30e-3, 45e-3, 0.3, 208e9);
        let body = Cylinder { speed: 1500.0, ..cylinder(a, b) };
        for r in [a, 33e-3, 40e-3, b] {
            let load = 7800.0 * 1500.0f64.powi(2) * (3.0 + nu) / 8.0;
            let radial = load * (a * a + b * b - (a * b / r).powi(2) - r * r);
            let hoop = load * (a * a + b * b + (a * b / r).powi(2) - (1.0 + 3.0 * nu) / (3.0 + nu) * r * r);
            let expected = r / young * (hoop - nu * radial);
            assert!((body.free_growth(r) / expected - 1.0).abs() < 1e-12);
            let inside = a * a / (b * b - a * a);
            let expected = r / young * (inside * (1.0 + (b / r).powi(2)) - nu * inside * (1.0 - (b / r).powi(2)));
            assert!((body.growth_by_inner_pressure(r) / expected - 1.0).abs() < 1e-12);
            let outside = -b * b / (b * b - a * a);
            let expected = r / young * (outside * (1.0 + (a / r).powi(2)) - nu * outside * (1.0 - (a / r).powi(2)));
            assert!((body.growth_by_outer_pressure(r) / expected - 1.0).abs() < 1e-12);
        }
    }

    /// The same pressure inside and outside is hydrostatic in the plane: u = −p (1 − ν) r/E.
    #[test]
    fn limit_pressure_all_round_shrinks_every_radius_alike() {
        let body = cylinder(30e-3, 45e-3);
        for r in [30e-3, 37e-3, 45e-3] {
            let both = body.growth_by_inner_pressure(r) + body.growth_by_outer_pressure(r);
            assert!((both / (-(1.0 - 0.3) * r / 208e9) - 1.0).abs() < 1e-12);
        }
        let warm = Cylinder { temperature_rise: 100.0, ..body };
        assert!((warm.free_growth(40e-3) - 46e-6).abs() < 1e-18);
        assert_eq!(Cylinder { speed: 5.0, ..warm }.at_rest(), body);
    }
}
