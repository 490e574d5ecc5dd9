//! Drag of the fluid on a ball that orbits through it.

use crate::Scalar;
use std::f64::consts::PI;

/// Reynolds number below which Stokes's law stands for the curve, whose other terms are then below 1e-9 of it.
const LEAST_REYNOLDS: f64 = 1e-6;

/// Drag on a ball, F = ½ C_d ρ_e A v|v|.
///
/// The drag coefficient is an input: at the Reynolds numbers of a turbopump bearing (about 1e7) and between
/// neighbouring balls the tables for a single sphere do not apply. On request it follows the curve of a single sphere
/// over the Reynolds number all the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallDrag {
    /// Effective density ρ_e, kg/m³; see [`effective_density`].
    pub density_effective: f64,
    /// Frontal area A, m²; see [`frontal_area`].
    pub frontal_area: f64,
    /// Drag coefficient C_d, or where there is a curve a factor upon it.
    pub drag_coefficient: f64,
    /// Reynolds number of the ball over its speed, ρ D/μ, s/m, where C_d follows [`sphere_drag_coefficient`]; absent
    /// where it is constant.
    pub reynolds_per_speed: Option<f64>,
}

/// Drag coefficient of a smooth sphere at a Reynolds number above 0, with the crisis at 2e5 to 4e5 where the boundary
/// layer becomes turbulent: F. A. Morrison, Data Correlation for Drag Coefficient for Sphere, Michigan Technological
/// University 2016, after data in Schlichting. For Re up to 1e6; beyond it rises to 0.23 at 1e7, where E. Achenbach, J.
/// Fluid Mech. 54 (1972) 565, doi:10.1017/S0022112072000874, measured about 0.2 at 5e6. Its slope is finite everywhere.
#[inline(always)]
pub fn sphere_drag_coefficient<D: Scalar>(reynolds: D) -> D {
    let creeping = reynolds.recip() * 24.0;
    let x = reynolds * (1.0 / 5.0);
    let wake = x * 2.6 / (x.powf(1.52) + 1.0);
    // x^-7.94/(1 + x^-8) with positive powers, which do not overflow where the sphere is slow.
    let x = reynolds * (1.0 / 2.63e5);
    let crisis = x.powf(0.06) * 0.411 / (x.powi(8) + 1.0);
    let x = reynolds * 1e-6;
    creeping + wake + crisis + x * 0.25 / (x + 1.0)
}

impl BallDrag {
    /// Force, N, against a motion of the ball at `relative_speed`, m/s, through the fluid: positive for a positive
    /// speed, to be subtracted by the caller. Odd, with a continuous first derivative that vanishes at rest.
    #[inline(always)]
    pub fn force<D: Scalar>(&self, relative_speed: D) -> D {
        let factor = 0.5 * self.drag_coefficient * self.density_effective * self.frontal_area;
        let mut square = relative_speed * relative_speed * factor;
        if let Some(per_speed) = self.reynolds_per_speed {
            let reynolds = relative_speed.abs() * per_speed;
            // At rest Stokes's law, C_d Re = 24, without its 0/0.
            square = if reynolds.re() > LEAST_REYNOLDS {
                square * sphere_drag_coefficient(reynolds)
            } else {
                relative_speed.abs() * (factor * 24.0 / per_speed)
            };
        }
        if relative_speed.re() < 0.0 { -square } else { square }
    }
}

/// Effective density ρ_e = X ρ_liquid + (1−X) ρ_gas, kg/m³, of a mixture with the volume fraction X of liquid between 0
/// and 1.
pub fn effective_density(liquid_fraction: f64, liquid_density: f64, gas_density: f64) -> f64 {
    liquid_fraction * liquid_density + (1.0 - liquid_fraction) * gas_density
}

/// Frontal area A = (πD²/4)(1 − shaded), m², of a ball of the diameter D in m, of which the cage web covers the
/// fraction `shaded` between 0 and 1.
pub fn frontal_area(ball_diameter: f64, shaded: f64) -> f64 {
    0.25 * PI * ball_diameter * ball_diameter * (1.0 - shaded)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::{first_derivative, second_derivative};
    use proptest::prelude::*;

    const DRAG: BallDrag =
        BallDrag { density_effective: 770.0, frontal_area: 7.1e-4, drag_coefficient: 0.4, reynolds_per_speed: None };

    proptest! {
        #[test]
        fn identity_drag_is_odd(v in 0.0..300.0f64) {
            prop_assert_eq!(DRAG.force(-v), -DRAG.force(v));
        }

        #[test]
        fn identity_drag_derivative_matches_differences(v in -300.0..300.0f64) {
            let (_, slope) = first_derivative(|v| DRAG.force(v), v);
            let step = 1e-3;
            let difference = (DRAG.force(v + step) - DRAG.force(v - step)) / (2.0 * step);
            // The difference is exact but for rounding where v keeps its sign, and half a step off where it does not.
            prop_assert!((slope - difference).abs() < 1e-6 * slope.abs() + 3e-4);
        }
    }

    #[test]
    fn limit_drag_at_rest_is_zero_with_zero_slope() {
        for v in [0.0, -0.0] {
            assert_eq!(first_derivative(|v| DRAG.force(v), v), (0.0, 0.0));
            let (_, _, curvature): (f64, f64, f64) = second_derivative(|v| DRAG.force(v), v);
            assert!(curvature.is_finite());
        }
    }

    /// Stokes's law, Newton's plateau, the crisis and what Achenbach (1972) measured behind it.
    #[test]
    fn limit_the_curve_of_a_sphere_has_its_crisis() {
        assert!((sphere_drag_coefficient(1e-3_f64) * 1e-3 / 24.0 - 1.0).abs() < 1e-4);
        for reynolds in [2e3, 1e4, 1e5] {
            let found = sphere_drag_coefficient(reynolds);
            assert!((0.38..0.52).contains(&found), "{reynolds}: {found}");
        }
        let crisis = sphere_drag_coefficient(4.5e5_f64);
        assert!(crisis < 0.13, "{crisis}");
        let behind = sphere_drag_coefficient(5e6_f64);
        assert!((behind - 0.2).abs() < 0.03, "{behind}");
        // Written with the printed exponents.
        for reynolds in [30.0_f64, 2e5, 3e5, 8e5] {
            let x = reynolds / 2.63e5;
            let printed = 24.0 / reynolds
                + 2.6 * (reynolds / 5.0) / (1.0 + (reynolds / 5.0).powf(1.52))
                + 0.411 * x.powf(-7.94) / (1.0 + x.powf(-8.0))
                + 0.25 * (reynolds * 1e-6) / (1.0 + reynolds * 1e-6);
            assert!((sphere_drag_coefficient(reynolds) / printed - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn identity_drag_by_the_curve_is_odd_steady_and_has_its_derivative() {
        let drag = BallDrag { drag_coefficient: 1.0, reynolds_per_speed: Some(0.03 * 770.0 / 1.2e-4), ..DRAG };
        for v in [1e-9_f64, 1e-3, 0.3, 1.4, 30.0, 120.0] {
            assert_eq!(drag.force(-v), -drag.force(v));
            let step = 1e-5 * v;
            let (_, slope): (f64, f64) = first_derivative(|v| drag.force(v), v);
            let difference = (drag.force(v + step) - drag.force(v - step)) / (2.0 * step);
            assert!((slope / difference - 1.0).abs() < 1e-6, "{v}: {slope:e} {difference:e}");
        }
        assert_eq!(drag.force(0.0), 0.0);
    }

    #[test]
    fn limit_area_and_density_at_the_ends_of_their_ranges() {
        assert_eq!(effective_density(1.0, 770.0, 10.0), 770.0);
        assert_eq!(effective_density(0.0, 770.0, 10.0), 10.0);
        assert_eq!(frontal_area(2.0, 0.0), PI);
        assert_eq!(frontal_area(2.0, 1.0), 0.0);
    }

    #[test]
    fn identity_drag_power_is_dissipated() {
        for v in [-120.0, -1e-3, 1e-3, 120.0] {
            assert!(DRAG.force(v) * v > 0.0);
        }
    }
}
