//! Answers of a solved cell to changes of what it was given.

use super::cell::{Cell, Direction};
use super::curve::{At, Coefficient};
use super::setup::Law;
use crate::elastic::grid::Node;
use crate::fast::lanes::{Lanes, fused};
use fearless_simd::prelude::*;

/// A solved cell.
#[derive(Clone, Copy)]
pub(super) struct Solved<'a, S: Simd> {
    pub(super) node: &'a Node,
    pub(super) at: &'a At<S>,
    pub(super) of: &'a Coefficient<Lanes<S>>,
    pub(super) direction: &'a Direction<S>,
    /// Traction of the cells before, as it goes into the trial slip.
    pub(super) carried: [Lanes<S>; 2],
    pub(super) x: Lanes<S>,
    /// X of the place whose slip the cell has.
    pub(super) mean: Lanes<S>,
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
    pub(super) fn new(cell: &Cell<S>, solved: &Solved<'_, S>, (yielding, keep): ([f64; 2], f64), law: &Law) -> Self {
        let Solved { node, at, of, direction, .. } = *solved;
        let Direction { a, inverse, grow, rise } = *direction;
        let zero = Lanes::splat(rise.token(), 0.0);
        let over_rise = Lanes::splat(rise.token(), 1.0) / rise;
        let [rising, _] = at.rising_and_lost(law);
        // κ falls by `rising` times the weakening: the same to the slip as if s_t grew by C times that along a.
        let lost = [0, 1].map(|k| a[k] * rising);
        let by_trial = [0, 1].map(|k| a[k] * inverse[k] * over_rise);
        let by_weakening = by_trial[0] * lost[0] * yielding[0] + by_trial[1] * lost[1] * yielding[1];
        let e = inverse.map(|inverse| of.value * inverse * node.sin);
        let m = [0, 1].map(|k| a[k] * (of.slope * node.sin - e[k] * grow[k]));
        let n = [0, 1].map(|k| lost[k] * (e[k] * yielding[k] - node.sin));
        let weakening = at.past.select(at.slope * ((keep - 1.0) * law.over_peak), zero);
        let response =
            Self { speed: (by_trial, by_weakening), traction: [e, m, n], slope: of.slope, rising, weakening };
        if cell.rest.any_true() { response.at_rest(cell, solved, yielding, law) } else { response }
    }

    /// The same with lanes at rest, where traction follows slip by the initial slope of the curve.
    #[inline(always)]
    fn at_rest(self, cell: &Cell<S>, solved: &Solved<'_, S>, yielding: [f64; 2], law: &Law) -> Self {
        let zero = Lanes::splat(self.slope.token(), 0.0);
        let moving = |x: Lanes<S>| cell.rest.select(zero, x);
        let initial = (-solved.of.weakening + 1.0) * law.initial_slope();
        let [e, m, n] = self.traction;
        let still = yielding.map(|c| initial * solved.node.sin / (initial * c + 1.0));
        Self {
            speed: (self.speed.0.map(moving), moving(self.speed.1)),
            traction: [[0, 1].map(|k| cell.rest.select(still[k], e[k])), m.map(moving), n.map(moving)],
            ..self
        }
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
        let of = |k: usize| fused(e[k], trial[k], fused(m[k], speed, n[k] * weakening));
        [of(0), of(1)]
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
