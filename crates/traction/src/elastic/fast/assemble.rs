//! Derivatives of the patch from those of its strips.

use super::march::March;
use super::setup::{Setup, Varied, yielding};
use super::varying;
use crate::elastic::TangentialElasticity;
use crate::fast::lanes::{Lanes, totals};
use crate::fast::{PatchDerivative, flatness};
use crate::{Kragelskii, Patch, PatchTraction, RelativeMotion, SlipUnit};
use fearless_simd::prelude::*;
use num_dual::Dual64;
use std::f64::consts::PI;

/// The changes that a march carries: u, v_0, X-slope of v, lateral flexibility, load, rolling speed.
pub(super) const CHANGES: usize = 6;
const ALONG: usize = 0;
const ACROSS: usize = 1;
const TURN: usize = 2;
const LATERAL: usize = 3;
const LOAD: usize = 4;
const ROLLING: usize = 5;

/// Quantities of which the derivative is taken.
#[derive(Clone, Copy)]
pub(super) struct Inputs<'a> {
    pub(super) patch: &'a Patch,
    pub(super) motion: &'a RelativeMotion,
    pub(super) rolling_speed: f64,
    pub(super) curve: &'a Kragelskii,
    pub(super) curve_slope: &'a Kragelskii,
    pub(super) slip_unit: SlipUnit,
    pub(super) elasticity: &'a TangentialElasticity,
    pub(super) setup: &'a Setup,
}

impl Inputs<'_> {
    fn motion(&self) -> RelativeMotion<Dual64> {
        let m = self.motion;
        RelativeMotion {
            rolling: m.rolling.into(),
            lateral: m.lateral.into(),
            spin: m.spin.into(),
            about_lateral: m.about_lateral.into(),
            about_rolling: m.about_rolling.into(),
        }
    }

    /// The patch while x, y and p grow in proportion to τ, with τ = 1 and dτ = 1.
    fn patch(&self, tau: Dual64) -> Patch<Dual64> {
        let p = self.patch;
        Patch {
            semi_lateral: tau * p.semi_lateral,
            semi_rolling: tau * p.semi_rolling,
            peak_pressure: tau * p.peak_pressure,
            ball_radius: p.ball_radius,
            surface_radius: p.surface_radius,
        }
    }

    fn yielding(&self, tau: Dual64, motion: &RelativeMotion<Dual64>, rolling: Dual64) -> [Dual64; 2] {
        // The axis ratio stays as the load grows.
        yielding(&self.patch(tau), motion, rolling, (self.elasticity, &self.setup.coefficients))
    }

    /// The six changes.
    pub(super) fn varied(&self) -> [Varied; CHANGES] {
        let (one, motion, v) = (Dual64::from(1.0), self.motion(), Dual64::from(self.rolling_speed));
        let curve = |k: fn(&Kragelskii) -> f64, p: f64| Dual64::new(k(self.curve), k(self.curve_slope) * p);
        let curve = |p: f64| Kragelskii { a: curve(|k| k.a, p), b: curve(|k| k.b, p), c: curve(|k| k.c, p) };
        let fixed = self.setup.law(curve(0.0), self.slip_unit.scale(v));
        let still = self.yielding(one, &motion, v);
        let along = |k: usize| {
            let mut slip = [[0.0; 3]; 3];
            slip[k][0] = 1.0;
            slip
        };
        let mut varied = [Varied::new(self.setup, (fixed, still), [[0.0; 3]; 3]); CHANGES];
        for (k, change) in [ALONG, ACROSS, TURN].into_iter().enumerate() {
            varied[change].slip = along(k);
        }
        // The lateral flexibility has no part in the slip that is taken up.
        let softer = [still[0], varying(still[1].re)];
        varied[LATERAL] = Varied { yielding: softer, memory: fixed.memory(softer).eps, ..varied[LATERAL] };
        let slip = crate::SlipField::new(self.patch, self.motion);
        let ([_, beta, alpha], [_, sigma, epsilon]) = (slip.longitudinal, slip.lateral);
        let law = self.setup.law(curve(self.patch.peak_pressure), self.slip_unit.scale(v));
        varied[LOAD] = Varied::new(
            self.setup,
            (law, self.yielding(varying(1.0), &motion, v)),
            [[0.0, -beta, -2.0 * alpha], [0.0, 0.0, 2.0 * epsilon], [sigma, 0.0, 0.0]],
        );
        let rolling = varying(self.rolling_speed);
        let law = self.setup.law(curve(0.0), self.slip_unit.scale(rolling));
        varied[ROLLING] = Varied::new(self.setup, (law, self.yielding(one, &motion, rolling)), [[0.0; 3]; 3]);
        varied
    }

    /// d C_y by lateral velocity and by spin.
    fn lateral_yielding(&self) -> [f64; 2] {
        let (one, v) = (Dual64::from(1.0), Dual64::from(self.rolling_speed));
        let (mut slide, mut spin) = (self.motion(), self.motion());
        slide.lateral.eps = 1.0;
        spin.spin.eps = 1.0;
        [slide, spin].map(|motion| self.yielding(one, &motion, v)[1].eps)
    }
}

/// Sums over the strips, in the direction of the slip and without the factor p a b.
pub(super) struct Sums<'a, S: Simd> {
    inputs: &'a Inputs<'a>,
    lateral_yielding: [f64; 2],
    values: [Lanes<S>; 7],
    by_motion: [[Lanes<S>; 5]; 5],
    by_load: [Lanes<S>; 7],
    by_rolling: [Lanes<S>; 7],
}

impl<'a, S: Simd> Sums<'a, S> {
    #[inline(always)]
    pub(super) fn new(simd: S, inputs: &'a Inputs<'a>) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let lateral_yielding = inputs.lateral_yielding();
        let (by_motion, seven) = ([[zero; 5]; 5], [zero; 7]);
        Self { inputs, lateral_yielding, values: seven, by_motion, by_load: seven, by_rolling: seven }
    }

    /// Forces, moments (in the order of [`PatchDerivative::by_motion`]), power and wear of the sums of strips.
    #[inline(always)]
    fn outputs(&self, y: Lanes<S>, arm: Lanes<S>, sums: &[Lanes<S>; 5], share: Lanes<S>) -> [Lanes<S>; 7] {
        let p = self.inputs.patch;
        let [fx, fy, x_fy, power, wear] = *sums;
        let (fx, fy, x_fy) = (fx * share, fy * share, x_fy * share);
        let (power, wear) = (power * share, wear * share);
        let about = y * fx * p.semi_lateral - x_fy * p.semi_rolling;
        [-fx, -fy, about, -(arm * fx), arm * fy, power, wear]
    }

    /// Adds eight strips by their shares of the patch.
    #[inline(always)]
    pub(super) fn add(&mut self, lot: &March<S, CHANGES>, share: Lanes<S>) {
        let (p, y) = (self.inputs.patch, lot.y);
        let sag = y * y * flatness(p);
        let height = -sag + p.ball_radius;
        let values = self.outputs(y, height, &lot.sums, share);
        // A loop, where the compiler would not draw the closure of a map into the vector code.
        let mut changes = [values; CHANGES];
        for (change, tangent) in changes.iter_mut().zip(&lot.tangents) {
            *change = self.outputs(y, height, &tangent.sums, share);
        }
        let [by_lateral, by_spin] = self.lateral_yielding;
        for (i, row) in self.by_motion.iter_mut().enumerate() {
            let of = |change: usize| changes[change][i];
            let by_motion = [
                of(ALONG),
                of(ACROSS) + of(LATERAL) * by_lateral,
                of(TURN) * p.semi_rolling - y * of(ALONG) * p.semi_lateral + of(LATERAL) * by_spin,
                height * of(ALONG),
                -(height * of(ACROSS)) - of(LATERAL) * (p.ball_radius * by_lateral),
            ];
            for (sum, term) in row.iter_mut().zip(by_motion) {
                *sum += term;
            }
        }
        for i in 0..7 {
            self.values[i] += values[i];
            self.by_load[i] += changes[LOAD][i] + values[i] * 3.0;
            self.by_rolling[i] += changes[ROLLING][i];
        }
        // What the patch does beside its strips while it grows: arm in the plane, sag of the other.
        let [fx, fy, about, ..] = values;
        self.by_load[2] += about;
        self.by_load[3] -= fx * sag * 2.0;
        self.by_load[4] += fy * sag * 2.0;
    }

    #[inline(always)]
    pub(super) fn derivative(&self) -> PatchDerivative {
        let p = self.inputs.patch;
        let volume = p.peak_pressure * p.semi_lateral * p.semi_rolling;
        let load = 2.0 / 3.0 * PI * volume;
        let mut by_motion = [[0.0; 5]; 5];
        for (totals, sums) in by_motion.iter_mut().zip(&self.by_motion) {
            *totals = all(sums, volume);
        }
        PatchDerivative {
            traction: named(all(&self.values, volume)),
            by_motion,
            by_load: named(all(&self.by_load, volume / (3.0 * load))),
            by_rolling_speed: named(all(&self.by_rolling, volume)),
        }
    }
}

/// Sums over all lanes times a factor.
#[inline(always)]
fn all<S: Simd, const N: usize>(sums: &[Lanes<S>; N], factor: f64) -> [f64; N] {
    totals(sums).map(|total| total * factor)
}

fn named([rolling, lateral, normal, about_lateral, about_rolling, power, wear]: [f64; 7]) -> PatchTraction {
    PatchTraction {
        force_rolling: rolling,
        force_lateral: lateral,
        moment_lateral: about_lateral,
        moment_normal: normal,
        moment_rolling: about_rolling,
        power,
        wear_integral: wear,
    }
}
