//! The march of eight strips from leading to trailing edge, with their first derivatives.

use super::cell::{At, Cell, Direction};
use super::response::{Response, Solved};
use super::setup::{Law, Varied};
use crate::SlipField;
use crate::elastic::Fastsim;
use crate::elastic::grid::Node;
use crate::fast::lanes::Lanes;
use fearless_simd::prelude::*;

/// Forces in the direction of the slip along x and y, X times the second, power and wear integral of a strip of half
/// length one and peak pressure one.
pub(super) type StripSums<S> = [Lanes<S>; 5];

/// All that a march needs to know of the patch, with its change by `T` inputs.
pub(super) struct Strips<'a, const T: usize> {
    pub(super) grid: &'a Fastsim,
    pub(super) slip: SlipField,
    /// 1 where surfaces move along x, −1 against it.
    pub(super) direction: f64,
    pub(super) law: Law,
    pub(super) yielding: [f64; 2],
    pub(super) varied: [Varied; T],
}

/// Steps of a cell's iteration that are made without asking.
const USUAL: usize = 2;

/// The first changes are of the slip alone.
const OF_SLIP: usize = 3;
/// The first changes come by the motion, over which power and wear have no derivatives, and leave the curve as it is.
const OF_MOTION: usize = 4;

/// The patch's numbers at one node, where C is divided by the node's reach.
struct AtNode<const T: usize> {
    yielding: [f64; 2],
    keep: f64,
    /// Changes of both.
    by_input: [([f64; 2], f64); T],
}

/// Eight strips on their way.
#[derive(Clone, Copy)]
pub(super) struct March<S: Simd, const T: usize> {
    pub(super) y: Lanes<S>,
    pub(super) chord: Lanes<S>,
    along: Lanes<S>,
    across: Lanes<S>,
    cell: Cell<S>,
    /// Traction over pressure in the direction of slip, at the last two nodes.
    traction: [[Lanes<S>; 2]; 2],
    weakening: [Lanes<S>; 2],
    pub(super) sums: StripSums<S>,
    pub(super) tangents: [Tangent<S>; T],
}

/// Derivatives of a march over one input.
#[derive(Clone, Copy)]
pub(super) struct Tangent<S: Simd> {
    /// Of u, v_0 and the X-slope of v.
    slip: [Lanes<S>; 3],
    traction: [[Lanes<S>; 2]; 2],
    weakening: [Lanes<S>; 2],
    pub(super) sums: StripSums<S>,
}

impl<S: Simd, const T: usize> March<S, T> {
    #[inline(always)]
    pub(super) fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let (pair, sums) = ([[z; 2]; 2], [z; 5]);
        let tangents = [Tangent { slip: [z; 3], traction: pair, weakening: [z; 2], sums }; T];
        let cell = Cell::nothing(simd);
        Self { y: z, chord: z, along: z, across: z, cell, traction: pair, weakening: [z; 2], sums, tangents }
    }
}

impl<const T: usize> Strips<'_, T> {
    /// Marches `lots` of eight strips side by side, each at its own place across the groove.
    #[inline(always)]
    pub(super) fn march<S: Simd>(&self, lots: &mut [March<S, T>]) {
        for lot in lots.iter_mut() {
            self.enter(lot);
        }
        let mut reach = f64::NAN;
        let mut here = self.at_node(1.0);
        for node in &self.grid.nodes {
            if node.reach.to_bits() != reach.to_bits() {
                reach = node.reach;
                here = self.at_node(reach);
            }
            for lot in lots.iter_mut() {
                self.open(node, &here, lot);
            }
            // One step is hardly ever enough.
            for _ in 0..USUAL {
                for lot in lots.iter_mut() {
                    lot.cell.improve(&self.law, here.yielding, here.keep);
                }
            }
            for _ in 0..200 {
                let mut left = false;
                for lot in lots.iter_mut().filter(|lot| !lot.cell.is_done()) {
                    lot.cell.improve(&self.law, here.yielding, here.keep);
                    left = true;
                }
                if !left {
                    break;
                }
            }
            for lot in lots.iter_mut() {
                self.close(node, &here, lot);
            }
        }
    }

    #[inline(always)]
    fn at_node(&self, reach: f64) -> AtNode<T> {
        let yielding = self.yielding.map(|c| c / reach);
        let by_input = self.varied.each_ref().map(|varied| {
            let yielding = varied.yielding.map(|c| c / reach);
            (yielding.map(|c| c.eps), varied.law.keep(yielding).eps)
        });
        AtNode { yielding, keep: self.law.keep(yielding), by_input }
    }

    /// The slip of the strip, and the weakening that belongs to the rigid slip at its leading edge.
    #[inline(always)]
    fn enter<S: Simd>(&self, lot: &mut March<S, T>) {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (self.slip.longitudinal, self.slip.lateral);
        let (y, zero) = (lot.y, Lanes::splat(lot.y.token(), 0.0));
        let y2 = y * y;
        lot.chord = ((-y + 1.0) * (y + 1.0)).max(0.0).sqrt();
        lot.along = -(y * beta + y2 * alpha) + gamma;
        lot.across = y2 * epsilon + delta;
        let edge = lot.chord * -self.direction;
        let v = lot.across + edge * sigma;
        let speed = (lot.along * lot.along + v * v).max(1e-200).sqrt();
        let at = At::new(&self.law, speed);
        lot.weakening = [at.rising_and_lost(&self.law)[1]; 2];
        lot.traction = [[zero; 2]; 2];
        lot.sums = [zero; 5];
        lot.cell.enter();
        for (tangent, varied) in lot.tangents.iter_mut().zip(&self.varied) {
            for (slip, [one, linear, square]) in tangent.slip.iter_mut().zip(&varied.slip) {
                *slip = y * *linear + y2 * *square + *one;
            }
            (tangent.traction, tangent.sums) = ([[zero; 2]; 2], [zero; 5]);
            let [du, dv, turn] = tangent.slip;
            let change = (lot.along * du + v * (dv + edge * turn)) / speed;
            let [_, lost] = law_change(&self.law, &varied.law, &at, speed);
            let by_speed = at.past.select(at.slope * -self.law.over_peak, zero);
            tangent.weakening = [lost + by_speed * change; 2];
        }
    }

    #[inline(always)]
    fn open<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &mut March<S, T>) {
        let x = lot.chord * (-self.direction * node.cos);
        let rigid = [lot.along, lot.across + x * self.slip.lateral[1]];
        let carried = carried(node, &lot.traction);
        let over_sine = node.sin.recip();
        let trial = [0, 1].map(|k| rigid[k] + carried[k] * (here.yielding[k] * over_sine));
        lot.cell.open(&self.law, here.yielding, trial, remembered(node, &lot.weakening).min(1.0));
    }

    #[inline(always)]
    fn close<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &mut March<S, T>) {
        let (at, of) = lot.cell.close(&self.law, here.keep);
        let mut direction = lot.cell.direction(&of, here.yielding);
        if lot.cell.rest.any_true() {
            let zero = Lanes::splat(lot.y.token(), 0.0);
            direction.a = direction.a.map(|a| lot.cell.rest.select(zero, a));
        }
        let traction = direction.a.map(|a| a * of.value * node.sin);
        let x = lot.chord * (-self.direction * node.cos);
        let weight = self.grid.spacing * node.sin;
        let power = of.value * lot.cell.speed;
        add_forces(&mut lot.sums, x, traction, weight);
        add_power(&mut lot.sums, [power, lot.cell.speed], weight * node.sin);
        if T > 0 {
            let carried = carried(node, &lot.traction);
            let solved = Solved { node, at: &at, of: &of, direction: &direction, carried, x, weight };
            let response = Response::new(&lot.cell, &solved, (here.yielding, here.keep), &self.law);
            for k in 0..T {
                self.tangent(here, k, lot, &solved, &response);
            }
        }
        lot.traction = [traction, lot.traction[0]];
        lot.weakening = [of.weakening, lot.weakening[0]];
    }

    /// Derivatives of a solved cell over input `k`.
    #[inline(always)]
    fn tangent<S: Simd>(
        &self,
        here: &AtNode<T>,
        k: usize,
        lot: &mut March<S, T>,
        solved: &Solved<'_, S>,
        response: &Response<S>,
    ) {
        let (cell, tangent) = (&lot.cell, &mut lot.tangents[k]);
        let Solved { node, at, of, direction: Direction { a, .. }, x, weight, .. } = *solved;
        let [du, dv, turn] = tangent.slip;
        let change = carried(node, &tangent.traction);
        let over_sine = node.sin.recip();
        let mut trial = [du, dv + x * turn];
        for (i, trial) in trial.iter_mut().enumerate() {
            *trial += change[i] * (here.yielding[i] * over_sine);
        }
        let mut weakening = remembered(node, &tangent.weakening) * here.keep;
        // Of κ at the same slip and weakening.
        let mut kappa = Lanes::splat(x.token(), 0.0);
        if k >= OF_SLIP {
            let (by_yielding, by_keep) = here.by_input[k];
            let [_, lost] = at.rising_and_lost(&self.law);
            let [by_rising, by_lost] = law_change(&self.law, &self.varied[k].law, at, cell.speed);
            weakening += (cell.last - lost) * by_keep + by_lost * (1.0 - here.keep);
            kappa = by_rising * (-of.weakening + 1.0);
            for (i, trial) in trial.iter_mut().enumerate() {
                let yielded = solved.carried[i] * over_sine - a[i] * of.value;
                *trial += yielded * by_yielding[i] - a[i] * kappa * here.yielding[i];
            }
        }
        let speed = response.speed(trial, weakening);
        let mut traction = response.traction(trial, weakening, speed);
        if k >= OF_MOTION {
            traction = [0, 1].map(|i| traction[i] + a[i] * kappa * node.sin);
            let power = (kappa + response.coefficient(weakening, speed)) * cell.speed + of.value * speed;
            add_power(&mut tangent.sums, [power, speed], weight * node.sin);
        }
        add_forces(&mut tangent.sums, x, traction, weight);
        tangent.weakening = [response.weakening(weakening, speed), tangent.weakening[0]];
        tangent.traction = [traction, tangent.traction[0]];
    }
}

#[inline(always)]
fn carried<S: Simd>(node: &Node, traction: &[[Lanes<S>; 2]; 2]) -> [Lanes<S>; 2] {
    let [last, before] = traction;
    [0, 1].map(|k| last[k] * node.previous[0] - before[k] * node.previous[1])
}

#[inline(always)]
fn remembered<S: Simd>(node: &Node, weakening: &[Lanes<S>; 2]) -> Lanes<S> {
    weakening[0] * node.remembered[0] - weakening[1] * node.remembered[1]
}

#[inline(always)]
fn add_forces<S: Simd>(sums: &mut StripSums<S>, x: Lanes<S>, [fx, fy]: [Lanes<S>; 2], weight: f64) {
    let fy = fy * weight;
    for (sum, term) in sums.iter_mut().zip([fx * weight, fy, x * fy]) {
        *sum += term;
    }
}

#[inline(always)]
fn add_power<S: Simd>(sums: &mut StripSums<S>, terms: [Lanes<S>; 2], weight: f64) {
    for (sum, term) in sums[3..].iter_mut().zip(terms) {
        *sum += term * weight;
    }
}

/// Change of κ_r and of the lost share d at a given speed by the changes of the curve and of λ.
#[inline(always)]
fn law_change<S: Simd>(law: &Law, varied: &Law<num_dual::Dual64>, at: &At<S>, speed: Lanes<S>) -> [Lanes<S>; 2] {
    let zero = Lanes::splat(speed.token(), 0.0);
    let (by, peak) = (&varied.curve, varied.peak.eps);
    if by.a.eps == 0.0 && by.b.eps == 0.0 && by.c.eps == 0.0 && varied.scale.eps == 0.0 {
        return [zero, zero];
    }
    let inner = at.slip * law.curve.b + law.curve.a;
    let by_curve = at.e * by.a.eps + at.slip * at.decay * (inner * -by.c.eps + by.b.eps);
    let plain = by_curve + speed * at.slope * (varied.scale.eps / law.scale);
    let lost = plain * -law.over_peak + at.plain * (peak * law.over_peak * law.over_peak);
    [at.past.select(Lanes::splat(speed.token(), peak), plain), at.past.select(lost, zero)]
}
