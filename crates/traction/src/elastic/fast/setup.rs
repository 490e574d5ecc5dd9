//! Values that all strips of a patch share, worked out once.

use crate::elastic::cell::MEMORY;
use crate::elastic::{CreepCoefficients, TangentialElasticity};
use crate::{Kragelskii, Patch, RelativeMotion, Scalar, SlipCurve};
use num_dual::Dual64;

/// A curve with its peak.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law<D = f64> {
    pub(super) curve: Kragelskii<D>,
    /// λ, slip over sliding speed, s/m.
    pub(super) scale: D,
    /// S_m and K_m; without a falling branch infinity and one.
    pub(super) peak_slip: D,
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
            peak_slip: to(self.peak_slip),
            peak: to(self.peak),
            over_peak: to(self.over_peak),
            steepness: to(self.steepness),
        }
    }
}

impl<D: Scalar> Law<D> {
    pub(super) fn new(curve: Kragelskii<D>, scale: D) -> Self {
        let (peak_slip, peak, steepness) = match curve.fall() {
            Some(fall) => (fall.slip, curve.coefficient(fall.slip), fall.steepness * scale),
            None => (D::from(f64::INFINITY), D::one(), D::zero()),
        };
        Self { curve, scale, peak_slip, peak, over_peak: peak.recip(), steepness }
    }

    /// Length of the memory of the weakening over θ, of which a cell that reaches k keeps memory/(memory + k).
    pub(super) fn memory(&self, yielding: [D; 2]) -> D {
        let softer = if yielding[0].re() > yielding[1].re() { yielding[0] } else { yielding[1] };
        softer * self.steepness * MEMORY
    }

    /// C κ along rolling, with κ at a slip of C.
    pub(super) fn taken_up(&self, [longitudinal, _]: [D; 2]) -> D {
        longitudinal * self.curve.coefficient(longitudinal * self.scale)
    }

    /// Initial slope of the coefficient over the sliding speed, s/m.
    pub(super) fn initial_slope(&self) -> D {
        self.curve.initial_slope() * self.scale
    }
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
    pub(super) fn new(law: Law<Dual64>, yielding: [Dual64; 2], slip: [[f64; 3]; 3]) -> Self {
        Self { taken_up: law.taken_up(yielding).eps, memory: law.memory(yielding).eps, law, yielding, slip }
    }
}
