//! Values that all strips of a patch share, worked out once.

use crate::elastic::cell::MEMORY;
use crate::elastic::{CreepCoefficients, TangentialElasticity};
use crate::fast::elementary::{exp, exp_m1};
use crate::fast::lanes::Lanes;
use crate::{Kragelskii, Patch, RelativeMotion, Scalar};
use fearless_simd::prelude::*;
use num_dual::Dual64;

/// exp(−1).
const INVERSE_E: f64 = 0.367_879_441_171_442_33;

/// A curve with its peak.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law<D = f64> {
    pub(super) curve: Kragelskii<D>,
    /// λ, slip over sliding speed, s/m.
    pub(super) scale: D,
    /// S_m/λ, m/s, and K_m; without a falling branch infinity and one.
    pub(super) knee: D,
    pub(super) peak: D,
    /// 1/K_m.
    pub(super) over_peak: D,
    /// λ times the steepest fall, s/m.
    pub(super) steepness: D,
}

impl<D: Copy> Law<D> {
    /// The same in other numbers.
    pub(super) fn map<E>(&self, to: impl Fn(D) -> E) -> Law<E> {
        let Kragelskii { a, b, c } = self.curve;
        Law {
            curve: Kragelskii { a: to(a), b: to(b), c: to(c) },
            scale: to(self.scale),
            knee: to(self.knee),
            peak: to(self.peak),
            over_peak: to(self.over_peak),
            steepness: to(self.steepness),
        }
    }
}

impl<D: Scalar> Law<D> {
    /// With exp(−C S_m) of the values, or any number where nothing falls.
    fn new(curve: Kragelskii<D>, scale: D, at_peak: f64) -> Self {
        let Some(slip) = peak_slip(&curve) else {
            let (knee, peak, steepness) = (D::from(f64::INFINITY), D::one(), D::zero());
            return Self { curve, scale, knee, peak, over_peak: D::one(), steepness };
        };
        // B exp(−C S_m), which is C (K_m − D), and e times the fall at the inflection, 1/C beyond the peak.
        let over_end = curve.b * exp_of(-curve.c * slip, at_peak);
        let peak = over_end / curve.c - curve.a;
        let (over_peak, steepness) = (peak.recip(), over_end * scale * INVERSE_E);
        Self { curve, scale, knee: slip / scale, peak, over_peak, steepness }
    }

    /// Length of the memory of the weakening over θ, of which a cell that reaches k keeps memory/(memory + k).
    pub(super) fn memory(&self, yielding: [D; 2]) -> D {
        let softer = if yielding[0].re() > yielding[1].re() { yielding[0] } else { yielding[1] };
        softer * self.steepness * MEMORY
    }

    /// Initial slope of the coefficient over the sliding speed, s/m.
    pub(super) fn initial_slope(&self) -> D {
        self.curve.initial_slope() * self.scale
    }
}

/// Slip at the peak; none where nothing falls.
fn peak_slip<D: Scalar>(curve: &Kragelskii<D>) -> Option<D> {
    (curve.b.re() > 0.0 && curve.c.re() > 0.0).then(|| curve.c.recip() - curve.a / curve.b)
}

/// exp(x) with its first derivatives, where that of the value is known.
fn exp_of<D: Scalar>(x: D, known: f64) -> D {
    (x - x.re()) * known + known
}

/// Values computed once for a patch, with the exponentials that its changes need again.
#[derive(Debug, Clone, Copy)]
pub(super) struct Setup {
    pub(super) law: Law,
    pub(super) yielding: [f64; 2],
    pub(super) coefficients: CreepCoefficients,
    /// exp(−C S_m).
    at_peak: f64,
    /// exp(−C s) − 1 at the slip that is taken up.
    at_taken_up: f64,
}

impl Setup {
    #[inline(always)]
    pub(super) fn new<S: Simd>(
        simd: S,
        (patch, motion, rolling_speed): (&Patch, &RelativeMotion, f64),
        (curve, scale): (&Kragelskii, f64),
        elasticity: &TangentialElasticity,
    ) -> Self {
        let [longitudinal, lateral, spin] =
            elasticity.coefficients().logarithms(patch.semi_rolling / patch.semi_lateral);
        let at_peak = peak_slip(curve).map_or(0.0, |slip| -curve.c * slip);
        let [longitudinal, lateral, spin, at_peak] = exp_of_four(simd, [longitudinal, lateral, spin, at_peak]);
        let coefficients = CreepCoefficients { longitudinal, lateral, spin };
        let law = Law::new(*curve, scale, at_peak);
        let yielding = yielding(patch, motion, rolling_speed, (elasticity, &coefficients));
        let at_taken_up = exp_m1(Lanes::splat(simd, -curve.c * (yielding[0] * scale)).max(-700.0))[0];
        Self { law, yielding, coefficients, at_peak, at_taken_up }
    }

    /// The law of a curve and a λ that differ from the patch's by their derivatives.
    pub(super) fn law<D: Scalar>(&self, curve: Kragelskii<D>, scale: D) -> Law<D> {
        Law::new(curve, scale, self.at_peak)
    }

    /// C κ along rolling, with κ at a slip of C, of a law and a yielding that differ so.
    pub(super) fn taken_up<D: Scalar>(&self, law: &Law<D>, [longitudinal, _]: [D; 2]) -> D {
        let Kragelskii { a, b, c } = law.curve;
        let slip = longitudinal * law.scale;
        let decay = exp_of(-c * slip, self.at_taken_up + 1.0);
        let less = (decay - decay.re()) + self.at_taken_up;
        longitudinal * (b * slip * decay + a * less)
    }
}

/// exp(x) of four numbers, of those below −700 as of that.
#[inline(always)]
fn exp_of_four<S: Simd>(simd: S, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    let all = exp(Lanes::simd_from(simd, [a, b, c, d, 0.0, 0.0, 0.0, 0.0]).max(-700.0));
    [all[0], all[1], all[2], all[3]]
}

/// |V| L p_max/b along rolling and across, m/s, by the coefficients of the patch's axis ratio.
pub(super) fn yielding<D: Scalar>(
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    (elasticity, coefficients): (&TangentialElasticity, &CreepCoefficients),
) -> [D; 2] {
    let CreepCoefficients { longitudinal, lateral, spin } = coefficients;
    let [longitudinal, lateral, spin] = [*longitudinal, *lateral, *spin].map(D::from);
    let coefficients = CreepCoefficients { longitudinal, lateral, spin };
    let flexibility = elasticity.flexibility_by(&coefficients, patch, motion, rolling_speed);
    let speed = if rolling_speed.re() < 0.0 { -rolling_speed } else { rolling_speed };
    let factor = speed * patch.peak_pressure / patch.semi_rolling;
    [flexibility.longitudinal * factor, flexibility.lateral * factor]
}

/// The parts of a patch that change with one input, in first-order dual numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Varied {
    pub(super) law: Law<Dual64>,
    pub(super) yielding: [Dual64; 2],
    /// Change of (u, v_0, X-slope of v) of a strip over (1, Y, Y²).
    pub(super) slip: [[f64; 3]; 3],
    /// Changes of the slip that is taken up and of the memory's length.
    pub(super) taken_up: f64,
    pub(super) memory: f64,
}

impl Varied {
    pub(super) fn new(setup: &Setup, (law, yielding): (Law<Dual64>, [Dual64; 2]), slip: [[f64; 3]; 3]) -> Self {
        let taken_up = setup.taken_up(&law, yielding).eps;
        Self { taken_up, memory: law.memory(yielding).eps, law, yielding, slip }
    }
}
