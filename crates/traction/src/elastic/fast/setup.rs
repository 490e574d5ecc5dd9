//! Values that all strips of a patch share, worked out once.

use crate::elastic::TangentialElasticity;
use crate::elastic::cell::MEMORY;
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
    /// S_m/λ, m/s.
    pub(super) peak_speed: f64,
    /// λ times the steepest fall, s/m.
    pub(super) steepness: D,
}

impl<D: Scalar> Law<D> {
    pub(super) fn new(curve: Kragelskii<D>, scale: D) -> Self {
        let (peak_slip, peak, steepness) = match curve.fall() {
            Some(fall) => (fall.slip, curve.coefficient(fall.slip), fall.steepness * scale),
            None => (D::from(f64::INFINITY), D::one(), D::zero()),
        };
        let peak_speed = peak_slip.re() / scale.re();
        Self { curve, scale, peak_slip, peak, over_peak: peak.recip(), peak_speed, steepness }
    }

    /// Share of the weakening that a cell keeps of the one before.
    pub(super) fn keep(&self, yielding: [D; 2]) -> D {
        let softer = if yielding[0].re() > yielding[1].re() { yielding[0] } else { yielding[1] };
        let memory = softer * self.steepness * MEMORY;
        memory / (memory + 1.0)
    }

    /// Initial slope of the coefficient over the sliding speed, s/m.
    pub(super) fn initial_slope(&self) -> D {
        self.curve.initial_slope() * self.scale
    }
}

/// |V| L p_max/b along rolling and across, m/s.
pub(super) fn yielding<D: Scalar>(
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    elasticity: &TangentialElasticity,
) -> [D; 2] {
    let flexibility = elasticity.flexibility(patch, motion, rolling_speed);
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
}
