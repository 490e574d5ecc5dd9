//! Film of oil between a ball and a wall that it approaches.
//!
//! Reynolds' equation for two rigid bodies with the gap h = h_0 + x²/2R_1 + y²/2R_2 that close in at a speed v,
//!
//! ```text
//! ∇·(h³ ∇p) = −12 η v,   p = 6 η v/((1/R_1 + 1/R_2) h²),   F = ∫ p dA = 12 π η v (R_1 R_2)^(3/2)/((R_1 + R_2) h_0)
//! ```
//!
//! With R_1 = R_2 = R it is 6 π η R² v/h_0, the limit of a sphere close to a plane of H. Brenner, Chem. Eng. Sci. 16
//! (1961) 242, doi:10.1016/0009-2509(61)80035-3. Bodies that part tear the film: it holds them with the pressure of the
//! surroundings at most, which is left out.
//!
//! The parabola stands for the surfaces as long as √(2 R h_0) is small beside the ball's radius. In the middle of a
//! pocket that is wide against its ball the force, small there, comes out too large by up to some two times.

use crate::Scalar;
use std::f64::consts::PI;

/// Speed of approach below which the force falls off faster than in proportion, m/s: without a bend at rest, where it
/// begins.
const REST: f64 = 1e-4;

/// A film between two bodies that approach each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SqueezeFilm {
    /// Force times thickness over speed of approach, N s.
    pub resistance: f64,
    /// Height of the surfaces' roughness, m: asperities that touch leave a film of this thickness.
    pub roughness: f64,
    /// Least thickness that the force is found with, m: a film that is thinner changes faster than a time step of that
    /// length resolves. Zero for the film as it is.
    pub thinnest: f64,
}

impl SqueezeFilm {
    /// Between surfaces with the radii of relative curvature R_1 and R_2, m, at a dynamic viscosity, Pa s, and a
    /// roughness, m.
    pub fn new(viscosity: f64, [r1, r2]: [f64; 2], roughness: f64) -> Self {
        Self { resistance: 12.0 * PI * viscosity * (r1 * r2).powf(1.5) / (r1 + r2), roughness, thinnest: 0.0 }
    }

    /// Force that keeps the bodies apart, N, at a gap (m, negative where asperities are pressed together) that closes
    /// at a speed, m/s: at least 0.
    pub fn force<D: Scalar>(&self, gap: D, closing: D) -> D {
        if closing.re() <= 0.0 {
            return D::zero();
        }
        let slow = closing.re() < REST;
        let speed = if slow { closing * closing * (-closing + 2.0 * REST) / (REST * REST) } else { closing };
        speed * self.resistance / self.thickness(gap)
    }

    /// Thickness of the film where bodies meet, m: the least that it is taken with.
    pub fn least_thickness(&self) -> f64 {
        self.roughness.max(self.thinnest)
    }

    /// Thickness of the film, m: gap and roughness, and the roughness alone where the gap is closed, with a continuous
    /// slope; at least the thinnest.
    pub fn thickness<D: Scalar>(&self, gap: D) -> D {
        let r = self.roughness;
        let open = if gap.re() >= r {
            gap
        } else if gap.re() <= -r {
            D::zero()
        } else {
            (gap + r) * (gap + r) * (0.25 / r)
        };
        let thickness = open + r;
        if thickness.re() < self.thinnest { D::from(self.thinnest) } else { thickness }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::first_derivative;

    const FILM: SqueezeFilm = SqueezeFilm { resistance: 8.58e-5, roughness: 1e-6, thinnest: 0.0 };

    #[test]
    fn limit_a_sphere_close_to_a_plane() {
        let (viscosity, radius, gap, speed) = (0.02, 4.4e-3, 1e-5, 0.01);
        let film = SqueezeFilm::new(viscosity, [radius; 2], 1e-12);
        let force = film.force(gap, speed);
        let brenner = 6.0 * PI * viscosity * radius * radius * speed / gap;
        assert!((force / brenner - 1.0).abs() < 1e-6, "{force} {brenner}");
    }

    #[test]
    fn identity_the_pressure_solves_reynolds_equation_and_adds_up_to_the_force() {
        let (viscosity, [r1, r2], h0, speed) = (0.02, [0.2, 4.4e-3], 1e-5, 0.01);
        let gap = |x: f64, y: f64| h0 + x * x / (2.0 * r1) + y * y / (2.0 * r2);
        let pressure = |x: f64, y: f64| 6.0 * viscosity * speed / ((1.0 / r1 + 1.0 / r2) * gap(x, y).powi(2));
        // Central differences of the flow through the sides of a cell.
        for (x, y) in [(0.0, 0.0), (1e-3, 2e-4), (-2e-3, 3e-4)] {
            let (dx, dy) = (1e-6, 1e-7);
            let flow = |x: f64, y: f64, [ex, ey]: [f64; 2]| {
                let slope = (pressure(x + ex, y + ey) - pressure(x - ex, y - ey)) / (2.0 * (ex + ey));
                gap(x, y).powi(3) * slope
            };
            let along = (flow(x + dx, y, [dx, 0.0]) - flow(x - dx, y, [dx, 0.0])) / (2.0 * dx);
            let across = (flow(x, y + dy, [0.0, dy]) - flow(x, y - dy, [0.0, dy])) / (2.0 * dy);
            let source = -12.0 * viscosity * speed;
            assert!(((along + across) / source - 1.0).abs() < 1e-4, "{along} {across} {source}");
        }
        // Rings of equal gap: x = √(2 R_1 h_0) s cos, y alike, dA = 2 √(R_1 R_2) h_0 s ds dθ, h = h_0 (1 + s²).
        let rings = 200_000;
        let sum: f64 = (0..rings)
            .map(|k| {
                // s = t/(1 − t) takes the plane into a unit interval.
                let t = (k as f64 + 0.5) / rings as f64;
                let (s, ds) = (t / (1.0 - t), (1.0 - t).powi(-2) / rings as f64);
                let x = (2.0 * r1 * h0).sqrt() * s;
                2.0 * (r1 * r2).sqrt() * h0 * s * ds * 2.0 * PI * pressure(x, 0.0)
            })
            .sum();
        let force = SqueezeFilm::new(viscosity, [r1, r2], 1e-15).force(h0, speed);
        assert!((sum / force - 1.0).abs() < 1e-6, "{sum} {force}");
    }

    #[test]
    fn limit_a_film_resists_approach_alone_and_is_never_thinner_than_the_roughness() {
        assert_eq!(FILM.force(1e-5, 0.0), 0.0);
        assert_eq!(FILM.force(1e-5, -0.1), 0.0);
        assert!((FILM.force(-1e-5, 0.1) - 0.1 * FILM.resistance / FILM.roughness).abs() < 1e-12);
        assert!((FILM.force(1e-4, 0.1) * 1.01e-4 / (0.1 * FILM.resistance) - 1.0).abs() < 1e-12);
        let thick = SqueezeFilm { thinnest: 4e-6, ..FILM };
        assert_eq!([FILM, thick].map(|film| film.least_thickness()), [1e-6, 4e-6]);
        assert!((thick.force(-1e-5, 0.1) * 4e-6 / (0.1 * FILM.resistance) - 1.0).abs() < 1e-12);
        assert_eq!(thick.force(1e-5, 0.1), FILM.force(1e-5, 0.1));
    }

    #[test]
    fn identity_slopes_are_those_of_differences_and_have_no_jump() {
        let change = 1e-11;
        for gap in [-2e-6, -1e-6, -3e-7, 0.0, 5e-7, 1e-6, 4e-6] {
            let (_, slope) = first_derivative(|gap| FILM.force(gap, num_dual::Dual64::from(0.02)), gap);
            let difference = (FILM.force(gap + change, 0.02) - FILM.force(gap - change, 0.02)) / (2.0 * change);
            assert!((slope - difference).abs() < 1e-3 * FILM.resistance * 0.02 / 1e-12, "{gap} {slope} {difference}");
        }
        for closing in [0.0, 3e-5, REST, 2e-4] {
            let (_, slope) = first_derivative(|closing| FILM.force(num_dual::Dual64::from(1e-5), closing), closing);
            let difference = (FILM.force(1e-5, closing + 1e-10) - FILM.force(1e-5, closing - 1e-10)) / 2e-10;
            assert!((slope - difference).abs() < 1e-4, "{closing} {slope} {difference}");
        }
    }
}
