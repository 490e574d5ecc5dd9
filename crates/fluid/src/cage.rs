//! Churning of a cage: the moment by which the fluid round it brakes its rotation, by its faces and its cylinders.
//!
//! Faces are those of a disk that is wetted on both sides, by the law of [`Churning`](crate::Churning), less the disk
//! of the bore. Cylinders have the friction of one that turns in fluid at rest: Stokes's exact flow, C_D = 4/Re, and
//! behind it T. Theodorsen and A. Regier, NACA Report 793 (1944), 1/√C_D = −0.6 + 4.07 log₁₀(Re √C_D), with the
//! stress τ = ½ C_D ρ (ω r)² and Re = ρ ω r²/μ; the larger of both, which meet at Re = 80. They measured up to 1e7.
//! Rings near by, which would drag the cage or hold it back, are not in it: a land that guides the cage is.

use crate::Scalar;
use crate::churning::Transition;
use std::f64::consts::PI;

/// Reynolds number at which both laws of a cylinder meet.
const TURBULENT_REYNOLDS: f64 = 80.0;
/// Newton steps for the law of Theodorsen and Regier: they square an error that begins at a fifth.
const NEWTON_STEPS: usize = 7;
/// Speed below which a cage counts as at rest, rad/s, far below all that is physical.
const REST: f64 = 1e-9;

/// A cage in the fluid, a ring with pockets.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageChurning {
    /// Density of the fluid, or effective density of a mixture, kg/m³.
    pub density: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity: f64,
    /// Radius of the bore and of the outside, m.
    pub radii: [f64; 2],
    /// Width along the axis, m.
    pub width: f64,
    /// Area that the pockets take from each of both cylinders, m².
    pub pockets: f64,
}

/// Moments against a cage's rotation, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CageMoments<D = f64> {
    /// Of both faces.
    pub faces: D,
    /// Of the bore.
    pub bore: D,
    /// Of the outside.
    pub outside: D,
}

impl<D: Scalar> CageMoments<D> {
    /// All of them.
    pub fn sum(&self) -> D {
        self.faces + self.bore + self.outside
    }
}

impl CageChurning {
    /// Moments, N m, at the angular speed of the cage against the fluid, rad/s: of its sign, odd.
    pub fn moments<D: Scalar>(&self, omega: D) -> CageMoments<D> {
        let speed = if omega.re() < 0.0 { -omega } else { omega };
        if speed.re() < REST {
            return CageMoments { faces: D::zero(), bore: D::zero(), outside: D::zero() };
        }
        let [bore, outside] = self.radii;
        let square = omega * speed * (0.5 * self.density);
        let reynolds = |radius: f64| speed * (self.density * radius * radius / self.viscosity);
        let disk = |radius: f64| square * Transition::BLENDED.coefficient(reynolds(radius)) * radius.powi(5);
        let cylinder = |radius: f64| {
            let area = (2.0 * PI * radius * self.width - self.pockets).max(0.0);
            square * cylinder_coefficient(reynolds(radius)) * (radius.powi(3) * area)
        };
        CageMoments { faces: disk(outside) - disk(bore), bore: cylinder(bore), outside: cylinder(outside) }
    }
}

/// Drag coefficient of a cylinder that turns in fluid at rest, at a Reynolds number ρ ω r²/μ above 0.
pub fn cylinder_coefficient<D: Scalar>(reynolds: D) -> D {
    if reynolds.re() < TURBULENT_REYNOLDS {
        return reynolds.recip() * 4.0;
    }
    let slope = 4.07 / std::f64::consts::LN_10;
    let mut root = D::from(4.0 + 0.5 * slope * (reynolds.re() / TURBULENT_REYNOLDS).ln());
    for _ in 0..NEWTON_STEPS {
        let off = root + 0.6 - (reynolds / root).ln() * slope;
        root -= off / (root.recip() * slope + 1.0);
    }
    (root * root).recip()
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::first_derivative;

    /// The cage of a 7224 in liquid nitrogen with a tenth of vapour; pockets of 30.4 mm for 13 balls.
    const CAGE: CageChurning = CageChurning {
        density: 694.7,
        viscosity: 119.7e-6,
        radii: [0.074925, 0.09],
        width: 0.0377,
        pockets: 13.0 * 0.25 * PI * 0.0304 * 0.0304,
    };

    /// A slow cylinder in a viscous fluid has the torque 4π μ ω r² on each metre.
    #[test]
    fn limit_a_slow_cylinder_is_stokes_s() {
        let slow = CageChurning { pockets: 0.0, ..CAGE };
        let omega = 1e-4;
        let exact = 4.0 * PI * slow.viscosity * omega * slow.radii[1].powi(2) * slow.width;
        assert!((slow.moments(omega).outside / exact - 1.0).abs() < 1e-12);
    }

    /// Both laws of a cylinder meet, within the scatter of measurements there.
    #[test]
    fn limit_the_laws_of_a_cylinder_meet() {
        let [below, above] = [0.999, 1.001].map(|share| cylinder_coefficient(share * TURBULENT_REYNOLDS));
        assert!((above / below - 1.0).abs() < 0.03, "{below} and {above}");
    }

    /// The implicit law is met, and its slope is that of differences.
    #[test]
    fn identity_the_law_of_theodorsen_and_regier_is_met() {
        for reynolds in [100.0, 1e4, 3e7] {
            let c: f64 = cylinder_coefficient(reynolds);
            let right = -0.6 + 4.07 * (reynolds * c.sqrt()).log10();
            assert!((c.sqrt().recip() - right).abs() < 1e-9 * right, "{reynolds}");
            let (_, slope) = first_derivative(cylinder_coefficient, reynolds);
            let step = 1e-5 * reynolds;
            let difference =
                (cylinder_coefficient(reynolds + step) - cylinder_coefficient(reynolds - step)) / (2.0 * step);
            assert!((slope / difference - 1.0).abs() < 1e-6, "{slope} and {difference}");
        }
    }

    /// By hand at 5800 r/min: Re = 1.98e7 and 2.86e7, disks of 1.534 and 3.565 N m; C_D = 0.001808 and 0.001719, on 83
    /// and 119 cm².
    #[test]
    fn identity_the_cage_of_a_turbopump_by_hand() {
        let found = CAGE.moments(5800.0 * PI / 30.0);
        for (value, by_hand) in [(found.faces, 2.031), (found.outside, 1.908), (found.bore, 0.810)] {
            assert!((value / by_hand - 1.0).abs() < 1e-3, "{found:?}");
        }
        let back = CAGE.moments(-5800.0 * PI / 30.0);
        assert_eq!(back.sum(), -found.sum());
        assert_eq!(CAGE.moments(0.0).sum(), 0.0);
    }
}
