//! Traction of a contact as a linear function of motion and load, good for a while.

use crate::machine::Machine;
use nalgebra::Matrix5;
use serde::{Deserialize, Serialize};
use tribodyn_bearing::LoadedPatch;
use tribodyn_bearing::traction::{PatchDerivative, PatchTraction, RelativeMotion, TractionLaw};

/// Error of the linear traction that a refresh may find, over the load: a fifth of that of the paper's 10 × 40 midpoints at a steep
/// slip scale.
pub(crate) const LINEAR_ERROR: f64 = 1e-4;
/// Slip, m/s, as which a relative change of the load counts: traction is nearly in proportion to the load.
const LOAD_AS_SLIP: f64 = 1.0;
/// First distance that a linear traction may be used over, m/s.
const FIRST_REACH: f64 = 1e-2;
/// Shortest distance, m/s: an estimate of zero error at a lucky point must not end linearisation for good.
const SHORTEST_REACH: f64 = 1e-6;
/// Change of the bare part of the surface beyond which the patch is integrated anew: steel has four times the traction of
/// silver, so that this is 1e-4 of the load.
const BARE_CHANGE: f64 = 3e-4;
/// Growth of the distance from one refresh to the next.
const GROWTH: f64 = 2.0;

/// Both contacts of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct Contacts {
    /// Inner, outer.
    pub of: [LinearTraction; 2],
    /// Steps since the last refresh.
    pub age: usize,
}

/// Value and slopes at one point.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub(crate) struct LinearTraction {
    /// Motion: rolling, lateral, spin, about lateral, about rolling.
    motion: [f64; 5],
    load: f64,
    /// Forces and moments that do work on the motion.
    value: [f64; 5],
    wear: f64,
    by_motion: [[f64; 5]; 5],
    by_load: [f64; 5],
    wear_by_load: f64,
    /// Part of the coating that is gone.
    bare: f64,
    /// Lateral semi-axis, m.
    semi_lateral: f64,
    /// How far the slip may move from here, m/s; 0 where there is no linear form.
    reach: f64,
}

impl LinearTraction {
    /// Whether a motion, a load, N, and the bare part of the surface are near enough.
    pub fn holds(&self, motion: &RelativeMotion, load: f64, bare: f64, ball_radius: f64) -> bool {
        self.reach > 0.0
            && (bare - self.bare).abs() <= BARE_CHANGE
            && self.distance(motion, load, ball_radius) <= self.reach * self.reach
    }

    /// Square of how far slip and load have moved, m²/s².
    fn distance(&self, motion: &RelativeMotion, load: f64, r: f64) -> f64 {
        let d = self.change(motion);
        let (along, across) = (d[0] + r * d[3], d[1] - r * d[4]);
        let spin = d[2] * self.semi_lateral;
        let load = LOAD_AS_SLIP * (load / self.load - 1.0);
        along * along + across * across + spin * spin + load * load
    }

    fn change(&self, motion: &RelativeMotion) -> [f64; 5] {
        let now = components(motion);
        std::array::from_fn(|i| now[i] - self.motion[i])
    }

    /// The linear traction. Its power is what forces and moments take from the motion.
    pub fn traction(&self, motion: &RelativeMotion, load: f64) -> PatchTraction {
        let (change, more) = (self.change(motion), load - self.load);
        let mut f = self.value;
        for (i, f) in f.iter_mut().enumerate() {
            *f += self.by_load[i] * more + (0..5).map(|k| self.by_motion[i][k] * change[k]).sum::<f64>();
        }
        let mut traction = PatchTraction {
            force_rolling: f[0],
            force_lateral: f[1],
            moment_normal: f[2],
            moment_lateral: f[3],
            moment_rolling: f[4],
            power: 0.0,
            wear_integral: self.wear + self.wear_by_load * more,
        };
        traction.power = -traction.work_on(motion);
        traction
    }

    /// Lateral semi-axis where it was linearised, m.
    pub fn semi_lateral(&self) -> f64 {
        self.semi_lateral
    }

    /// The integral over the patch, from which the linear form starts anew; the distance that it may serve over follows
    /// from the error found now, which grows with its square.
    pub fn refresh<L: TractionLaw>(
        &mut self,
        machine: &Machine<L>,
        p: &LoadedPatch<'_, f64, L>,
        tolerance: f64,
    ) -> PatchTraction {
        let Some(d) = machine.kernel.derivative(&machine.bearing, p) else {
            self.reach = 0.0;
            return machine.kernel.traction(&machine.bearing, p);
        };
        let load = load_of(p);
        let reach = if self.reach > 0.0 { self.next_reach(p, &d, (load, tolerance)) } else { FIRST_REACH };
        let PatchDerivative { traction, by_motion, by_load, .. } = d;
        *self = Self {
            motion: components(&p.motion),
            load,
            value: outputs(&traction),
            wear: traction.wear_integral,
            by_motion,
            by_load: outputs(&by_load),
            wear_by_load: by_load.wear_integral,
            bare: p.bare,
            semi_lateral: p.patch.semi_lateral,
            reach,
        };
        traction
    }

    fn next_reach<L>(&self, p: &LoadedPatch<'_, f64, L>, d: &PatchDerivative, (load, tolerance): (f64, f64)) -> f64 {
        let linear = self.traction(&p.motion, load);
        let off = (linear.force_rolling - d.traction.force_rolling)
            .hypot(linear.force_lateral - d.traction.force_lateral)
            / load;
        let distance = self.distance(&p.motion, load, p.patch.ball_radius).sqrt();
        let wanted = 0.9 * distance * (tolerance / off.max(1e-14)).sqrt();
        wanted.clamp(self.reach / (2.0 * GROWTH), self.reach * GROWTH).max(SHORTEST_REACH)
    }

    /// Derivative of forces and moments by the motion.
    pub fn stiffness(&self) -> Matrix5<f64> {
        if self.reach > 0.0 { Matrix5::from(self.by_motion).transpose() } else { Matrix5::zeros() }
    }
}

/// Q = ⅔ π a b p.
pub(crate) fn load_of<L>(p: &LoadedPatch<'_, f64, L>) -> f64 {
    std::f64::consts::PI / 1.5 * p.patch.semi_lateral * p.patch.semi_rolling * p.patch.peak_pressure
}

fn components(m: &RelativeMotion) -> [f64; 5] {
    [m.rolling, m.lateral, m.spin, m.about_lateral, m.about_rolling]
}

fn outputs(t: &PatchTraction) -> [f64; 5] {
    [t.force_rolling, t.force_lateral, t.moment_normal, t.moment_lateral, t.moment_rolling]
}
