//! The patch integral to first order in numbers that carry derivatives, with no node evaluated on such numbers.

use super::{FastPatch, PatchDerivative};
use crate::{MovingPatch, Patch, PatchLaw, PatchTraction, RelativeMotion, Scalar, TractionLaw, patch_traction};
use std::f64::consts::PI;

impl PatchDerivative {
    /// Forces and moments to first order about the state of the derivative, by the chain rule over motion, contact load
    /// in N and rolling speed in m/s. Power and wear integral are constants here: they stand in no balance of forces.
    pub fn first_order<D: Scalar>(&self, motion: &RelativeMotion<D>, load: D, rolling_speed: D) -> PatchTraction<D> {
        let change = |value: D| value - value.re();
        let motion =
            [motion.rolling, motion.lateral, motion.spin, motion.about_lateral, motion.about_rolling].map(change);
        let (load, rolling) = (change(load), change(rolling_speed));
        let sum = |value: f64, row: &[f64; 5], by_load: f64, by_rolling: f64| {
            let by_motion = row.iter().zip(motion).fold(load * by_load, |sum, (&slope, change)| sum + change * slope);
            // Most units of slip do not depend on the rolling speed.
            let all = if by_rolling == 0.0 { by_motion } else { by_motion + rolling * by_rolling };
            all + value
        };
        let (t, q, v) = (&self.traction, &self.by_load, &self.by_rolling_speed);
        let [along, across, normal, lateral, about_rolling] = &self.by_motion;
        PatchTraction {
            force_rolling: sum(t.force_rolling, along, q.force_rolling, v.force_rolling),
            force_lateral: sum(t.force_lateral, across, q.force_lateral, v.force_lateral),
            moment_normal: sum(t.moment_normal, normal, q.moment_normal, v.moment_normal),
            moment_lateral: sum(t.moment_lateral, lateral, q.moment_lateral, v.moment_lateral),
            moment_rolling: sum(t.moment_rolling, about_rolling, q.moment_rolling, v.moment_rolling),
            power: D::from(t.power),
            wear_integral: D::from(t.wear_integral),
        }
    }
}

/// Forces and moments of [`crate::fast_patch_traction`] with first derivatives of the integral: in closed form where
/// one curve holds for all of the patch and the law has it in lanes, else by [`patch_traction`] on `D`.
///
/// In the first case the derivatives are as good as the rule is for the integral's derivative, the ellipse is taken to
/// grow in proportion to the cube root of the load, and power and wear integral carry no derivatives.
pub fn linear_patch_traction<D: Scalar, L: TractionLaw>(
    fast: &FastPatch,
    patch: &Patch<D>,
    motion: &RelativeMotion<D>,
    rolling_speed: D,
    law: &PatchLaw<'_, L>,
) -> PatchTraction<D> {
    let load = patch.peak_pressure * patch.semi_lateral * patch.semi_rolling * (2.0 / 3.0 * PI);
    let contact = MovingPatch { patch: patch.re(), motion: motion.re(), rolling_speed: rolling_speed.re() };
    match law.fast_derivative(&contact, fast) {
        Some(derivative) => derivative.first_order(motion, load, rolling_speed),
        None => patch_traction(patch, motion, rolling_speed, law, &fast.quadrature),
    }
}
