//! The patch integral of a Kragelskii curve in double precision, eight nodes at a time.
//!
//! [`FastPatch`] sums the same nodes as [`patch_traction`] and agrees with it to 1e-12 of the largest component; where
//! the generic integral is the reference for any scalar and any law, this one is what solvers call in their loops.
//! Nothing is allocated per call. The vector width is chosen once per patch from what the processor offers; results
//! have the same bits at every width.
//!
//! # Derivative
//! With o(s) = κ(s)/s and s = λ |Δv| the traction of a node is f = −w λ o Δv, and Δv is linear in the motion, so
//! ```text
//! df = −w λ K dΔv,   K = o I + s o'(s) n nᵀ,   n = Δv/|Δv|
//! ```
//! [`PatchDerivative`] is made of sums of K over the nodes, in one pass with the integrals.

pub(crate) mod curve;
mod derivative;
pub(crate) mod elementary;
pub(crate) mod lanes;
mod linear;
pub(crate) mod nodes;
pub(crate) mod values;

pub use derivative::PatchDerivative;
pub use linear::linear_patch_traction;

use crate::{
    Kragelskii, MovingPatch, Patch, PatchLaw, PatchTraction, Quadrature, RelativeMotion, SlipField, SlipUnit,
    TractionError, TractionLaw, patch_traction,
};
use crate::{PatchRule, patch::LEAST_ROLLING};
use curve::{LaneCurve, Sliding};
use fearless_simd::{Level, dispatch};
use lanes::totals;
use nodes::Layout;
use values::Values;

/// Least |Δv|², m²/s²: at rest κ/s takes its limit, and 0/0 is avoided.
pub(crate) const SMALLEST_SQUARE: f64 = 1e-280;
/// A patch rule laid out for vector instructions.
#[derive(Debug, Clone)]
pub struct FastPatch {
    quadrature: Quadrature,
    layout: Layout,
    level: Level,
}

/// One contact and one curve in the coordinates of the unit disc.
struct Scaled<C> {
    slip: SlipField,
    curve: C,
}

impl FastPatch {
    /// Lays out a rule.
    ///
    /// # Errors
    /// Those of [`Quadrature::new`].
    pub fn new(rule: PatchRule) -> Result<Self, TractionError> {
        Ok(Self::of(Quadrature::new(rule)?))
    }

    /// Lays out the nodes of a quadrature.
    pub fn of(quadrature: Quadrature) -> Self {
        Self { layout: Layout::new(&quadrature), quadrature, level: Level::new() }
    }

    /// The vector instructions of this processor.
    pub(crate) fn level(&self) -> Level {
        self.level
    }

    /// Its nodes.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The same nodes for the generic integral.
    pub fn quadrature(&self) -> &Quadrature {
        &self.quadrature
    }

    /// [`patch_traction`] of a Kragelskii curve with C > 0, the same at every point of the patch.
    ///
    /// `rolling_speed` in m/s matters only for slip units that are fractions of it.
    pub fn traction(
        &self,
        patch: &Patch,
        motion: &RelativeMotion,
        rolling_speed: f64,
        curve: &Kragelskii,
        slip_unit: SlipUnit,
    ) -> PatchTraction {
        let scale = slip_unit.scale(rolling_speed);
        self.traction_of((patch, motion), scale, Sliding::new(curve, scale))
    }

    /// [`Self::traction`] of any curve, with slip over sliding speed in s/m.
    #[inline]
    pub(crate) fn traction_of<C: LaneCurve>(
        &self,
        (patch, motion): (&Patch, &RelativeMotion),
        scale: f64,
        curve: C,
    ) -> PatchTraction {
        if patch.peak_pressure <= 0.0 {
            return PatchTraction::zero();
        }
        let scaled = Scaled { slip: SlipField::new(patch, motion), curve };
        let sums = dispatch!(self.level, simd => {
            let mut values = Values::new(simd, &scaled);
            self.layout.walk(simd, &scaled.slip, &mut values);
            totals(&values.sums)
        });
        assemble(patch, scale, sums)
    }

    /// [`FastPatch::traction`] with its derivatives; `curve_slope` holds dA/dp, dB/dp and dC/dp, per Pa.
    pub fn derivative(
        &self,
        patch: &Patch,
        motion: &RelativeMotion,
        rolling_speed: f64,
        (curve, curve_slope): (&Kragelskii, &Kragelskii),
        slip_unit: SlipUnit,
    ) -> PatchDerivative {
        let scale = slip_unit.scale(rolling_speed);
        let sliding = Sliding::sloped(curve, curve_slope, scale, patch.peak_pressure);
        self.derivative_of((patch, motion), (scale, scale_slope(slip_unit, rolling_speed)), sliding)
    }

    /// [`Self::derivative`] of any curve, with slip over sliding speed in s/m and the derivative of its logarithm by
    /// the rolling speed.
    #[inline]
    pub(crate) fn derivative_of<C: LaneCurve>(
        &self,
        (patch, motion): (&Patch, &RelativeMotion),
        (scale, relative_scale_slope): (f64, f64),
        curve: C,
    ) -> PatchDerivative {
        if patch.peak_pressure <= 0.0 {
            return PatchDerivative::zero();
        }
        let scaled = Scaled { slip: SlipField::new(patch, motion), curve };
        let sums = dispatch!(self.level, simd => {
            let mut sums = derivative::Sums::new(simd, &scaled);
            self.layout.walk(simd, &scaled.slip, &mut sums);
            sums.totals()
        });
        derivative::assemble((patch, motion), scale, &sums, relative_scale_slope)
    }
}

/// d ln λ/dV, s/m.
pub(crate) fn scale_slope(slip_unit: SlipUnit, rolling_speed: f64) -> f64 {
    match slip_unit {
        SlipUnit::PercentOfRolling | SlipUnit::PerMilleOfRolling if rolling_speed.abs() > LEAST_ROLLING => {
            -rolling_speed.recip()
        }
        _ => 0.0,
    }
}

/// Flatness y²/(2R_c) of the contact over Y², m: of the slip field and of the moment's arm.
pub(crate) fn flatness(patch: &Patch) -> f64 {
    patch.semi_lateral * patch.semi_lateral * (0.5 / patch.surface_radius)
}

/// Forces and moments from the sums of [`Values`], whose forces have the sign of the slip.
pub(crate) fn assemble(patch: &Patch, scale: f64, sums: [f64; 8]) -> PatchTraction {
    let (a, b) = (patch.semi_lateral, patch.semi_rolling);
    let load = patch.peak_pressure * a * b;
    let [fx, fy, x_fy, y_fx, y2_fx, y2_fy, power, wear] = sums;
    let (r, bow) = (patch.ball_radius, flatness(patch));
    let factor = load * scale;
    PatchTraction {
        force_rolling: -factor * fx,
        force_lateral: -factor * fy,
        moment_lateral: -factor * (r * fx - bow * y2_fx),
        moment_normal: -factor * (b * x_fy - a * y_fx),
        moment_rolling: factor * (r * fy - bow * y2_fy),
        power: factor * power,
        wear_integral: load * wear,
    }
}

/// The patch integral by the fast rule where one curve holds for all of the patch and the law has it in lanes, else by
/// [`patch_traction`].
pub fn fast_patch_traction<L: TractionLaw>(
    fast: &FastPatch,
    patch: &Patch,
    motion: &RelativeMotion,
    rolling_speed: f64,
    law: &PatchLaw<'_, L>,
) -> PatchTraction {
    let contact = MovingPatch { patch: *patch, motion: *motion, rolling_speed };
    law.fast_traction(&contact, fast)
        .unwrap_or_else(|| patch_traction(patch, motion, rolling_speed, law, &fast.quadrature))
}
