//! The elastic patch for a Kragelskii curve in double precision, eight strips at a time.
//!
//! [`Fastsim::traction`] marches the strips of [`super::elastic_patch_traction`] and agrees with it to 1e-12 of the
//! largest component. Strips do not depend on each other, so lanes are strips; up to sixteen march side by side.
//! Nothing is allocated, and the bits are the same at every vector width.
//!
//! # Derivative
//! With D_k = σ + C_k κ and a_k = s_t,k/D_k the cell's equation is Σ a_k² = 1, so that for any change
//! ```text
//! δσ Σ a_k²(1 + C_k κ_σ)/D_k = Σ a_k (δs_t,k − a_k (κ δC_k + C_k δκ|σ))/D_k,    δt_k = sin θ (a_k δκ + κ δa_k)
//! ```
//! [`Fastsim::derivative`] carries six such changes through the march: of the strip's u, v_0 and X-slope, of the
//! lateral flexibility, of the load and of the rolling speed. All derivatives of the patch are made of these.

mod assemble;
mod cell;
mod curve;
mod march;
mod response;
mod setup;
mod start;

use super::Fastsim;
use super::across::Crowding;
use super::elasticity::TangentialElasticity;
use super::fastsim::elastic_patch_traction;
use crate::fast::lanes::{LANES, Lanes, totals};
use crate::fast::{PatchDerivative, assemble as assemble_values};
use crate::{
    Kragelskii, Patch, PatchLaw, PatchTraction, PressureChoice, RelativeMotion, Scalar, SlipField, SlipUnit,
    TractionLaw,
};
use fearless_simd::{dispatch, prelude::*};
use march::{March, Strips};
use num_dual::Dual64;
use setup::Setup;

impl Fastsim {
    /// [`elastic_patch_traction`] of a Kragelskii curve with C > 0, the same at every point of the patch.
    pub fn traction(
        &self,
        patch: &Patch,
        motion: &RelativeMotion,
        rolling_speed: f64,
        (curve, slip_unit): (&Kragelskii, SlipUnit),
        elasticity: &TangentialElasticity,
    ) -> PatchTraction {
        if patch.peak_pressure <= 0.0 {
            return PatchTraction::zero();
        }
        let given = (curve, slip_unit.scale(rolling_speed));
        let sums = dispatch!(self.level, simd => {
            let setup = Setup::new(simd, (patch, motion, rolling_speed), given, elasticity);
            let strips = Strips::new((self, SlipField::new(patch, motion)), rolling_speed, &setup, []);
            let mut sums = [Lanes::splat(simd, 0.0); 8];
            walk(simd, &strips, #[inline(always)] |lot: &March<_, 0>, share| {
                let (y, y2) = (lot.y, lot.y * lot.y);
                let [fx, fy, x_fy, power, wear] = lot.sums.map(|sum| sum * share);
                let terms = [fx, fy, x_fy, y * fx, y2 * fx, y2 * fy, power, wear];
                for (sum, term) in sums.iter_mut().zip(terms) {
                    *sum += term;
                }
            });
            totals(&sums)
        });
        assemble_values(patch, 1.0, sums)
    }

    /// [`Fastsim::traction`] with its derivatives; `curve_slope` holds dA/dp, dB/dp and dC/dp, per Pa.
    ///
    /// The derivatives are those of the integral, with the strips held fast: as good as the rule.
    pub fn derivative(
        &self,
        patch: &Patch,
        motion: &RelativeMotion,
        rolling_speed: f64,
        (curve, curve_slope, slip_unit): (&Kragelskii, &Kragelskii, SlipUnit),
        elasticity: &TangentialElasticity,
    ) -> PatchDerivative {
        if patch.peak_pressure <= 0.0 {
            return PatchDerivative::zero();
        }
        let given = (curve, slip_unit.scale(rolling_speed));
        dispatch!(self.level, simd => {
            let setup = &Setup::new(simd, (patch, motion, rolling_speed), given, elasticity);
            let inputs =
                assemble::Inputs { patch, motion, rolling_speed, curve, curve_slope, slip_unit, elasticity, setup };
            let slip = SlipField::new(patch, motion);
            let strips = Strips::new((self, slip), rolling_speed, setup, inputs.varied());
            let mut sums = assemble::Sums::new(simd, &inputs);
            walk(simd, &strips, #[inline(always)] |lot: &March<_, _>, share| sums.add(lot, share));
            sums.derivative()
        })
    }
}

/// Marches every strip of the patch and hands lots of eight with their shares of the patch to `take`.
#[inline(always)]
fn walk<S: Simd, const T: usize>(simd: S, strips: &Strips<'_, T>, mut take: impl FnMut(&March<S, T>, Lanes<S>)) {
    let crowding = Crowding::new(strips.slip.longitudinal, strips.taken_up);
    let (pairs, last) = strips.grid.lots.as_chunks();
    for places in pairs {
        march::<S, T, 2>(simd, (strips, &crowding), places, &mut take);
    }
    if let [places] = last {
        march(simd, (strips, &crowding), &[*places], &mut take);
    }
}

#[inline(always)]
fn march<S: Simd, const T: usize, const L: usize>(
    simd: S,
    (strips, crowding): (&Strips<'_, T>, &Crowding),
    places: &[[[f64; LANES]; 2]; L],
    take: &mut impl FnMut(&March<S, T>, Lanes<S>),
) {
    let mut lots = [March::nothing(simd); L];
    let mut shares = [Lanes::splat(simd, 0.0); L];
    for ((lot, share), &[t, weight]) in lots.iter_mut().zip(&mut shares).zip(places) {
        let [y, stretch] = crowding.places(Lanes::simd_from(simd, t));
        lot.y = y;
        *share = Lanes::simd_from(simd, weight) * stretch * ((-y + 1.0) * (y + 1.0)).max(0.0);
    }
    strips.march(&mut lots);
    for (lot, &share) in lots.iter().zip(&shares) {
        take(lot, share);
    }
}

/// The elastic patch by [`Fastsim::traction`] where the law has a Kragelskii curve at the peak pressure, else by
/// [`elastic_patch_traction`].
pub fn fast_elastic_patch_traction<L: TractionLaw>(
    grid: &Fastsim,
    patch: &Patch,
    motion: &RelativeMotion,
    rolling_speed: f64,
    law: &PatchLaw<'_, L>,
    elasticity: &TangentialElasticity,
) -> PatchTraction {
    let curve = match law.pressure {
        PressureChoice::Peak => law.law.kragelskii(patch.peak_pressure),
        PressureChoice::Local => None,
    };
    match curve {
        Some(curve) => grid.traction(patch, motion, rolling_speed, (&curve, law.slip_unit), elasticity),
        None => elastic_patch_traction(patch, motion, rolling_speed, law, elasticity, grid),
    }
}

/// Forces and moments of [`fast_elastic_patch_traction`] with first derivatives: [`Fastsim::derivative`] where the law
/// has a Kragelskii curve at the peak pressure, else [`elastic_patch_traction`] on `D`.
///
/// In the first case the ellipse is taken to grow in proportion to the cube root of the load, and power and wear
/// integral carry no derivatives, as in [`crate::linear_patch_traction`].
pub fn linear_elastic_patch_traction<D: Scalar, L: TractionLaw>(
    grid: &Fastsim,
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    law: &PatchLaw<'_, L>,
    elasticity: &TangentialElasticity,
) -> PatchTraction<D> {
    let pressure = patch.peak_pressure.re();
    let curves = match law.pressure {
        PressureChoice::Peak => law.law.kragelskii(pressure).zip(law.law.kragelskii_slope(pressure)),
        PressureChoice::Local => None,
    };
    let Some((curve, slope)) = curves else {
        return elastic_patch_traction(patch, motion, rolling_speed, law, elasticity, grid);
    };
    let curves = (&curve, &slope, law.slip_unit);
    let derivative = grid.derivative(&patch.re(), &motion.re(), rolling_speed.re(), curves, elasticity);
    let load = patch.peak_pressure * patch.semi_lateral * patch.semi_rolling * (2.0 / 3.0 * std::f64::consts::PI);
    derivative.first_order(motion, load, rolling_speed)
}

/// A number that varies with the input at hand.
fn varying(x: f64) -> Dual64 {
    Dual64::from(x).derivative()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FastsimRule;
    use fearless_simd::Level;

    #[test]
    fn identity_bits_do_not_depend_on_the_vector_width() {
        let patch = Patch {
            semi_lateral: 4e-3,
            semi_rolling: 0.5e-3,
            peak_pressure: 2.1e9,
            ball_radius: 0.01508,
            surface_radius: 0.0155,
        };
        let curve = Kragelskii { a: -0.124, b: 0.079, c: 0.698 };
        let slope = Kragelskii { a: 1e-11, b: -2e-11, c: -1e-10 };
        let steel = TangentialElasticity::new(80e9, 0.3).unwrap();
        let widest = Fastsim::new(FastsimRule { across: 7, cells: 11 }).unwrap();
        let narrow = Fastsim { level: Level::baseline(), ..widest.clone() };
        for i in 0..40 {
            let x = f64::from(i) - 20.0;
            let motion = RelativeMotion {
                rolling: 0.03 * x,
                lateral: 0.01,
                spin: 20.0 * x,
                about_lateral: 9.0,
                about_rolling: 4.0,
            };
            let unit = SlipUnit::Scaled { per_m_s: 22.0 };
            let of = |grid: &Fastsim| {
                let values = grid.traction(&patch, &motion, 60.0, (&curve, unit), &steel);
                (values, grid.derivative(&patch, &motion, 60.0, (&curve, &slope, unit), &steel))
            };
            assert_eq!(of(&widest), of(&narrow));
        }
    }
}
