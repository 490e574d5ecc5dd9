//! Drag of the fluid film between a cage and the land that guides it.
//!
//! Laminar plane Couette flow, τ = μ U/c, and turbulent flow by Hirs' bulk-flow law, G. G. Hirs, J. Lubr. Technol. 95
//! (1973) 137, doi:10.1115/1.3451752: τ = ½ ρ u² n (ρ u c/μ)^m with the mean velocity u = U/2 of a drag flow and n =
//! 0.055, m = −0.25 for smooth walls without a pressure gradient. The larger of the two is taken, as in bulk-flow codes
//! for seals and bearings: torque and speed stay related one to one. The two meet at U c/ν = 607. Against Robertson's
//! logarithmic law the power law is within 6 % from U c/ν = 1e4 to 1e5 and falls behind above, by 8 % at 3e5.
//!
//! Plane Couette flow stays laminar up to U c/ν of about 1300 to 2000, so that between 607 and there a film without
//! vortices would have up to 2.4 times less drag than this. A land gap has them: behind a rotating inner cylinder
//! Taylor vortices begin at U c/ν = 41.2 √(R/c), 670 for a gap of 0.3 mm at a radius of 80 mm.

use crate::Scalar;
use std::f64::consts::PI;

// Hirs 1973: coefficient and exponent of the wall shear stress of drag flow between smooth walls.
const HIRS_COEFFICIENT: f64 = 0.055;
const HIRS_EXPONENT: f64 = -0.25;
/// (2^(3+m)/n)^(1/(1+m)), which a program may not take the powers of at compile time.
const CROSSOVER: f64 = 607.145_897_432_212_7;

/// The thin cylindrical film between a land and the cage that it guides, concentric and full of one fluid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AnnulusDrag {
    /// Density ρ of the fluid, or effective density of a mixture, kg/m³.
    pub density: f64,
    /// Dynamic viscosity μ, Pa s.
    pub viscosity: f64,
    /// Radius R of the land, m.
    pub radius: f64,
    /// Width L of the land along the axis, m; of two lands together.
    pub width: f64,
    /// Radial gap c, m.
    pub gap: f64,
}

impl AnnulusDrag {
    /// Reynolds number ρ U c/μ at the relative surface speed U of either sign, m/s.
    pub fn reynolds<D: Scalar>(&self, surface_speed: D) -> D {
        magnitude(surface_speed) * (self.density * self.gap / self.viscosity)
    }

    /// Reynolds number at which the turbulent law begins to exceed the laminar one, (2^(3+m)/n)^(1/(1+m)) = 607.
    pub const fn crossover_reynolds() -> f64 {
        CROSSOVER
    }

    /// Shear stress τ on the walls, Pa, at the relative surface speed U, m/s: of its sign, odd, and continuous; its
    /// derivative jumps by 75 % at [`Self::crossover_reynolds`].
    pub fn shear<D: Scalar>(&self, surface_speed: D) -> D {
        let laminar = surface_speed * (self.viscosity / self.gap);
        // Decided by the number and not by the two stresses, so that the power is never taken at rest.
        if self.reynolds(surface_speed).re() <= Self::crossover_reynolds() {
            return laminar;
        }
        let mean = magnitude(surface_speed) * 0.5;
        let friction = (mean * (self.density * self.gap / self.viscosity)).powf(HIRS_EXPONENT) * HIRS_COEFFICIENT;
        surface_speed * mean * friction * (0.25 * self.density)
    }

    /// Slope of [`Self::torque_on_cage`] by the cage's speed, N m s: below 0.
    pub fn slope_by_cage_speed(&self, land_speed: f64, cage_speed: f64) -> f64 {
        let u = (land_speed - cage_speed) * self.radius;
        // τ ∝ u where it is laminar, and u^(2+m) where it is not.
        let slope = if self.reynolds(u) <= Self::crossover_reynolds() {
            self.viscosity / self.gap
        } else {
            (2.0 + HIRS_EXPONENT) * self.shear(u) / u
        };
        -slope * self.radius * 2.0 * PI * self.radius * self.radius * self.width
    }

    /// Torque on the cage, N m, about the axis, τ · 2πR² L, at the angular speeds of land and cage, rad/s: it drives
    /// the cage where the land is faster and brakes it where the land is slower. The land takes the opposite torque.
    pub fn torque_on_cage<D: Scalar>(&self, land_speed: D, cage_speed: D) -> D {
        let area_times_arm = 2.0 * PI * self.radius * self.radius * self.width;
        self.shear((land_speed - cage_speed) * self.radius) * area_times_arm
    }
}

fn magnitude<D: Scalar>(value: D) -> D {
    if value.re() < 0.0 { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::first_derivative;
    use proptest::prelude::*;

    /// Liquid nitrogen at 87.5 K and 4 MPa under the land of a bearing of 150 mm pitch diameter.
    const LAND: AnnulusDrag =
        AnnulusDrag { density: 770.5, viscosity: 119.7e-6, radius: 0.085, width: 0.012, gap: 0.3e-3 };

    fn speed_at(reynolds: f64) -> f64 {
        reynolds / LAND.reynolds(1.0)
    }

    proptest! {
        #[test]
        fn identity_shear_is_odd_and_torque_has_its_sign(land in -2000.0..2000.0f64, cage in -2000.0..2000.0f64) {
            let torque = LAND.torque_on_cage(land, cage);
            prop_assert_eq!(LAND.torque_on_cage(cage, land), -torque);
            // What the film takes from the land and does not give to the cage is heat.
            prop_assert!(torque * (land - cage) >= 0.0);
        }

        #[test]
        fn identity_derivative_matches_differences(u in -150.0..150.0f64) {
            let step = 1e-5;
            // Across the kink a difference is no derivative.
            prop_assume!((u.abs() - speed_at(AnnulusDrag::crossover_reynolds())).abs() > 2.0 * step);
            let (_, slope) = first_derivative(|u| LAND.shear(u), u);
            let difference = (LAND.shear(u + step) - LAND.shear(u - step)) / (2.0 * step);
            prop_assert!((slope / difference - 1.0).abs() < 1e-6, "{} {}", slope, difference);
        }
    }

    /// Both sides of the crossover, by dual numbers.
    #[test]
    fn identity_slope_by_the_speed_of_the_cage() {
        for (land, cage) in [(0.0, 12.0), (4.0, 3.0), (0.0, 600.0), (-900.0, 500.0), (100.0, 100.0)] {
            let (_, exact) = first_derivative(|speed| LAND.torque_on_cage(num_dual::Dual64::from(land), speed), cage);
            let slope = LAND.slope_by_cage_speed(land, cage);
            assert!((slope / exact - 1.0).abs() < 1e-13, "{land} {cage}: {slope} {exact}");
        }
    }

    #[test]
    fn identity_the_crossover_is_that_of_the_exponents() {
        let found = (2f64.powf(3.0 + HIRS_EXPONENT) / HIRS_COEFFICIENT).powf(1.0 / (1.0 + HIRS_EXPONENT));
        assert!((AnnulusDrag::crossover_reynolds() / found - 1.0).abs() < 1e-15, "{found}");
    }

    #[test]
    fn limit_slow_film_is_laminar_couette_flow() {
        for u in [-0.2f64, 0.0, 1e-9, 0.2] {
            let (shear, slope): (f64, f64) = first_derivative(|u| LAND.shear(u), u);
            assert!((shear - 119.7e-6 * u / 0.3e-3).abs() <= 1e-15 * shear.abs());
            assert_eq!(slope, 119.7e-6 / 0.3e-3);
        }
        // Petroff's torque 2π μ R³ L ω/c.
        let petroff = 2.0 * PI * 119.7e-6 * 0.085f64.powi(3) * 0.012 * 2.0 / 0.3e-3;
        assert!((LAND.torque_on_cage(3.0, 1.0) / petroff - 1.0).abs() < 1e-14);
        assert_eq!(LAND.torque_on_cage(700.0, 700.0), 0.0);
    }

    #[test]
    fn limit_the_two_laws_meet_where_the_larger_changes() {
        let crossover = AnnulusDrag::crossover_reynolds();
        assert!((crossover - 607.0).abs() < 0.5, "{crossover}");
        let (below, above) =
            (LAND.shear(speed_at(crossover * (1.0 - 1e-12))), LAND.shear(speed_at(crossover * (1.0 + 1e-12))));
        assert!((above / below - 1.0).abs() < 1e-11);
        for factor in [1.001, 2.0, 100.0] {
            let u = speed_at(crossover * factor);
            let laminar = LAND.viscosity * u / LAND.gap;
            assert!(LAND.shear(u) > laminar && (LAND.shear(u) / laminar / factor.powf(0.75) - 1.0).abs() < 1e-9);
        }
    }

    /// Robertson's friction law of turbulent plane Couette flow, sqrt(c_f/2) = 0.19/log10(Re) with half the wall speed
    /// and half the gap in both (Proc. 6th Midwest. Conf. Fluid Mech. 1959, 169), fitted to other measurements than
    /// Hirs' law.
    #[test]
    fn paper_turbulent_shear_agrees_with_robertsons_couette_law() {
        let ratio = |reynolds: f64| {
            let u = speed_at(reynolds);
            let root = 0.19 / (reynolds / 4.0).log10();
            LAND.shear(u) / (LAND.density * (0.5 * u).powi(2) * root * root)
        };
        for reynolds in [1e4, 3e4, 1e5] {
            assert!((ratio(reynolds) - 1.0).abs() < 0.06, "{reynolds}: {}", ratio(reynolds));
        }
        assert!((0.91..0.93).contains(&ratio(3e5)), "{}", ratio(3e5));
    }

    /// Direct simulation of plane Couette flow: Re_τ = 82.2 at half wall speed and half gap of Re = 1300 (Bech,
    /// Tillmark, Alfredsson, Andersson, J. Fluid Mech. 286 (1995) 291), that is c_f = 2 (82.2/1300)².
    #[test]
    fn paper_turbulent_shear_agrees_with_a_direct_simulation_of_couette_flow() {
        let u = speed_at(4.0 * 1300.0);
        let coefficient = LAND.shear(u) / (0.5 * LAND.density * (0.5 * u).powi(2));
        assert!((coefficient / (2.0 * (82.2f64 / 1300.0).powi(2)) - 1.0).abs() < 0.06, "{coefficient}");
    }
}
