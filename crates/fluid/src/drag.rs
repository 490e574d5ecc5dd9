//! Drag of the fluid on a ball that orbits through it.

use crate::Scalar;
use std::f64::consts::PI;

/// Drag on a ball, F = ½ C_d ρ_e A v|v|.
///
/// The drag coefficient is an input: at the Reynolds numbers of a turbopump bearing (about 1e7) and between
/// neighbouring balls the tables for a single sphere do not apply.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallDrag {
    /// Effective density ρ_e, kg/m³; see [`effective_density`].
    pub density_effective: f64,
    /// Frontal area A, m²; see [`frontal_area`].
    pub frontal_area: f64,
    /// Drag coefficient C_d.
    pub drag_coefficient: f64,
}

impl BallDrag {
    /// Force, N, against a motion of the ball at `relative_speed`, m/s, through the fluid: positive for a positive
    /// speed, to be subtracted by the caller. Odd, with a continuous first derivative that vanishes at rest.
    #[inline(always)]
    pub fn force<D: Scalar>(&self, relative_speed: D) -> D {
        let factor = 0.5 * self.drag_coefficient * self.density_effective * self.frontal_area;
        let square = relative_speed * relative_speed * factor;
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

    const DRAG: BallDrag = BallDrag { density_effective: 770.0, frontal_area: 7.1e-4, drag_coefficient: 0.4 };

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
