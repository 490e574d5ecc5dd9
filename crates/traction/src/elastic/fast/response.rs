//! Answers of a solved cell to changes of what it was given.

use super::cell::{Around, Cell, Root};
use super::setup::Law;
use crate::elastic::grid::Node;
use crate::fast::lanes::{Lanes, fused};
use fearless_simd::prelude::*;

/// A solved cell.
#[derive(Clone, Copy)]
pub(super) struct Solved<'a, S: Simd> {
    pub(super) node: &'a Node,
    pub(super) cell: &'a Cell<S>,
    pub(super) root: &'a Root<S>,
    pub(super) around: &'a Around<S>,
    /// Traction of the cells before, as it goes into the trial slip.
    pub(super) carried: [Lanes<S>; 2],
}

/// Changes of a cell with its trial slip s_t and its weakening w at the same slip, all else held:
/// ```text
/// δσ = Σ g_k δs_t,k + h δw,   sin θ δt_k = e_k δs_t,k + m_k δσ + n_k δw
/// ```
pub(super) struct Response<S: Simd> {
    /// g, h.
    speed: ([Lanes<S>; 2], Lanes<S>),
    /// e, m, n.
    traction: [[Lanes<S>; 2]; 3],
    /// dκ/dσ, and κ over 1 − w.
    slope: Lanes<S>,
    rising: Lanes<S>,
    /// Of the weakening that is handed on by σ.
    weakening: Lanes<S>,
}

impl<S: Simd> Response<S> {
    #[inline(always)]
    pub(super) fn new(solved: &Solved<'_, S>, (yielding, keep): ([f64; 2], f64), law: &Law) -> Self {
        let Solved { node, root: Root { of, direction: a, .. }, around, .. } = *solved;
        let Around { at, inverse, grow, rise } = *around;
        let zero = Lanes::splat(rise.token(), 0.0);
        let over_rise = Lanes::splat(rise.token(), 1.0) / rise;
        let [rising, _] = at.rising_and_lost(law);
        // Both directions one by one: closures of a map would not be drawn into the vector code.
        // κ falls by `rising` times the weakening: the same to the slip as if s_t grew by C times that along a.
        let lost = [a[0] * rising, a[1] * rising];
        let by_trial = [a[0] * inverse[0] * over_rise, a[1] * inverse[1] * over_rise];
        let by_weakening = by_trial[0] * lost[0] * yielding[0] + by_trial[1] * lost[1] * yielding[1];
        let size = of.value * node.sin;
        let e = [size * inverse[0], size * inverse[1]];
        let steep = of.slope * node.sin;
        let m = [a[0] * (steep - e[0] * grow[0]), a[1] * (steep - e[1] * grow[1])];
        let n = [lost[0] * (e[0] * yielding[0] - node.sin), lost[1] * (e[1] * yielding[1] - node.sin)];
        let weakening = at.past.select(at.slope * ((keep - 1.0) * law.over_peak), zero);
        let response =
            Self { speed: (by_trial, by_weakening), traction: [e, m, n], slope: of.slope, rising, weakening };
        if solved.cell.rest.any_true() { response.at_rest(solved, yielding, law) } else { response }
    }

    /// The same with lanes at rest, where traction follows slip by the initial slope of the curve.
    #[inline(always)]
    fn at_rest(self, solved: &Solved<'_, S>, yielding: [f64; 2], law: &Law) -> Self {
        let (zero, rest) = (Lanes::splat(self.slope.token(), 0.0), solved.cell.rest);
        let initial = (-solved.root.weakening + 1.0) * law.initial_slope();
        let Self { mut speed, mut traction, .. } = self;
        speed.1 = rest.select(zero, speed.1);
        for k in 0..2 {
            let still = initial * solved.node.sin / (initial * yielding[k] + 1.0);
            speed.0[k] = rest.select(zero, speed.0[k]);
            traction[0][k] = rest.select(still, traction[0][k]);
            traction[1][k] = rest.select(zero, traction[1][k]);
            traction[2][k] = rest.select(zero, traction[2][k]);
        }
        Self { speed, traction, ..self }
    }

    /// δσ.
    #[inline(always)]
    pub(super) fn speed(&self, trial: [Lanes<S>; 2], weakening: Lanes<S>) -> Lanes<S> {
        let (by_trial, by_weakening) = self.speed;
        fused(by_trial[0], trial[0], fused(by_trial[1], trial[1], by_weakening * weakening))
    }

    /// sin θ δt.
    #[inline(always)]
    pub(super) fn traction(&self, trial: [Lanes<S>; 2], weakening: Lanes<S>, speed: Lanes<S>) -> [Lanes<S>; 2] {
        let [e, m, n] = self.traction;
        [
            fused(e[0], trial[0], fused(m[0], speed, n[0] * weakening)),
            fused(e[1], trial[1], fused(m[1], speed, n[1] * weakening)),
        ]
    }

    /// δκ.
    #[inline(always)]
    pub(super) fn coefficient(&self, weakening: Lanes<S>, speed: Lanes<S>) -> Lanes<S> {
        fused(self.slope, speed, -(self.rising * weakening))
    }

    /// Change of the weakening that is handed on.
    #[inline(always)]
    pub(super) fn weakening(&self, weakening: Lanes<S>, speed: Lanes<S>) -> Lanes<S> {
        fused(self.weakening, speed, weakening)
    }
}
