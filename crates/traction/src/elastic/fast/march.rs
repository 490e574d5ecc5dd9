//! The march of eight strips from leading to trailing edge, with their first derivatives.

use super::LOTS;
use super::cell::{Cell, Direction};
use super::curve::At;
use super::response::{Response, Solved};
use super::setup::{Law, Setup, Varied};
use super::start::Start;
use crate::SlipField;
use crate::elastic::Fastsim;
use crate::elastic::grid::Node;
use crate::fast::lanes::{Lanes, fused};
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
    start: Start,
    pub(super) yielding: [f64; 2],
    /// C κ along rolling, with κ at a slip of C, and the length of the memory over θ.
    pub(super) taken_up: f64,
    memory: f64,
    pub(super) varied: [Varied; T],
}

/// The first changes are of the slip alone.
const OF_SLIP: usize = 3;
/// The first changes come by the motion, over which power and wear have no derivatives, and leave the curve as it is.
const OF_MOTION: usize = 4;

/// The patch's numbers at one node, where C is divided by the node's reach.
struct AtNode<const T: usize> {
    yielding: [f64; 2],
    keep: f64,
    /// C over the sine.
    pull: [f64; 2],
    /// Changes of C and of the share that is kept.
    by_input: [([f64; 2], f64); T],
}

/// Eight strips on their way.
#[derive(Clone, Copy)]
pub(super) struct March<S: Simd, const T: usize> {
    pub(super) y: Lanes<S>,
    pub(super) chord: Lanes<S>,
    along: Lanes<S>,
    across: Lanes<S>,
    /// Share of the mean slip over a difference in the slip of a cell.
    sticking: Lanes<S>,
    cell: Cell<S>,
    /// Traction over pressure in the direction of slip, at the last three nodes.
    traction: [[Lanes<S>; 2]; 3],
    weakening: [Lanes<S>; 3],
    pub(super) sums: StripSums<S>,
    pub(super) tangents: [Tangent<S>; T],
}

/// Derivatives of a march over one input.
#[derive(Clone, Copy)]
pub(super) struct Tangent<S: Simd> {
    /// Of u, v_0 and the X-slope of v.
    slip: [Lanes<S>; 3],
    /// Of v by where a cell takes its slip, over what the node says.
    mean: Lanes<S>,
    traction: [[Lanes<S>; 2]; 3],
    weakening: [Lanes<S>; 3],
    pub(super) sums: StripSums<S>,
}

impl<S: Simd, const T: usize> March<S, T> {
    #[inline(always)]
    pub(super) fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let (traction, weakening, sums) = ([[z; 2]; 3], [z; 3], [z; 5]);
        let tangents = [Tangent { slip: [z; 3], mean: z, traction, weakening, sums }; T];
        let cell = Cell::nothing(simd);
        Self { y: z, chord: z, along: z, across: z, sticking: z, cell, traction, weakening, sums, tangents }
    }
}

impl<'a, const T: usize> Strips<'a, T> {
    pub(super) fn new(
        (grid, slip): (&'a Fastsim, SlipField),
        rolling_speed: f64,
        setup: &Setup,
        varied: [Varied; T],
    ) -> Self {
        let direction = if rolling_speed < 0.0 { -1.0 } else { 1.0 };
        let Setup { law, yielding, .. } = *setup;
        let (taken_up, memory) = (setup.taken_up(&law, yielding), law.memory(yielding));
        Self { grid, slip, direction, start: Start::new(&law), law, yielding, taken_up, memory, varied }
    }

    /// Marches up to [`LOTS`] lots of eight strips side by side, each at its own place across the groove.
    #[inline(always)]
    pub(super) fn march<S: Simd>(&self, lots: &mut [March<S, T>]) {
        for lot in lots.iter_mut() {
            self.enter(lot);
        }
        for node in &self.grid.nodes {
            let here = self.at_node(node);
            let given = (here.yielding, here.keep);
            for lot in lots.iter_mut() {
                self.open(node, &here, lot);
            }
            let starts = self.starts(&here, lots);
            for (lot, start) in lots.iter_mut().zip(starts) {
                lot.cell.improve(&self.law, given, start);
            }
            for lot in lots.iter_mut().filter(|lot| !lot.cell.is_done()) {
                lot.cell.search(&self.law, given);
            }
            for lot in lots.iter_mut() {
                self.close(node, &here, lot);
            }
        }
    }

    /// Speeds from which the roots of one or two lots are searched.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "only the start is in single precision")]
    fn starts<S: Simd>(&self, here: &AtNode<T>, lots: &[March<S, T>]) -> [Lanes<S>; LOTS] {
        let (first, last) = (&lots[0].cell, &lots[lots.len() - 1].cell);
        let trial = [first.trial[0].narrow(last.trial[0]), first.trial[1].narrow(last.trial[1])];
        let [x, y] = here.yielding;
        let given = ([x as f32, y as f32], here.keep as f32);
        self.start.speed(trial, first.last.narrow(last.last), given).widen().into()
    }

    #[inline(always)]
    fn at_node(&self, node: &Node) -> AtNode<T> {
        let yielding = self.yielding.map(|c| c * node.over_reach);
        let over = (self.memory + node.memory_reach).recip();
        let mut by_input = [([0.0; 2], 0.0); T];
        for (by, varied) in by_input.iter_mut().zip(&self.varied) {
            let [x, y] = varied.yielding;
            let keep = varied.memory * node.memory_reach * over * over;
            *by = ([x.eps * node.over_reach, y.eps * node.over_reach], keep);
        }
        AtNode { yielding, keep: self.memory * over, pull: yielding.map(|c| c * node.over_sine), by_input }
    }

    /// The slip of the strip, and the weakening that belongs to the rigid slip at its leading edge.
    #[inline(always)]
    fn enter<S: Simd>(&self, lot: &mut March<S, T>) {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (self.slip.longitudinal, self.slip.lateral);
        let (y, zero) = (lot.y, Lanes::splat(lot.y.token(), 0.0));
        let y2 = y * y;
        lot.chord = ((-y + 1.0) * (y + 1.0)).max(0.0).sqrt();
        lot.along = fused(-y, fused(y, alpha, beta), gamma);
        lot.across = fused(y2, epsilon, delta);
        let edge = lot.chord * -self.direction;
        let v = lot.across + edge * sigma;
        let speed = (lot.along * lot.along + v * v).max(1e-200).sqrt();
        let over = Lanes::splat(y.token(), 1.0) / (speed * 0.5 + (self.taken_up + f64::MIN_POSITIVE));
        lot.sticking = over * self.taken_up;
        let at = At::new(&self.law, speed);
        lot.weakening = [at.rising_and_lost(&self.law)[1]; 3];
        lot.traction = [[zero; 2]; 3];
        lot.sums = [zero; 5];
        for (tangent, varied) in lot.tangents.iter_mut().zip(&self.varied) {
            for (slip, [one, linear, square]) in tangent.slip.iter_mut().zip(&varied.slip) {
                *slip = y * *linear + y2 * *square + *one;
            }
            (tangent.traction, tangent.sums) = ([[zero; 2]; 3], [zero; 5]);
            let [du, dv, turn] = tangent.slip;
            let change = (lot.along * du + v * (dv + edge * turn)) / speed;
            let [_, lost] = law_change(&self.law, &varied.law, &at, speed);
            let by_speed = at.past.select(at.slope * -self.law.over_peak, zero);
            tangent.weakening = [lost + by_speed * change; 3];
            let sticking = (speed * varied.taken_up - change * self.taken_up) * over * over * 0.5;
            tangent.mean = sticking * edge * self.slip.lateral[1];
        }
    }

    /// X of the slip that a cell has.
    #[inline(always)]
    fn place_of_slip<S: Simd>(&self, node: &Node, lot: &March<S, T>) -> Lanes<S> {
        lot.chord * (fused(lot.sticking, node.mean, node.cos) * -self.direction)
    }

    #[inline(always)]
    fn open<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &mut March<S, T>) {
        let mean = self.place_of_slip(node, lot);
        let across = fused(mean, self.slip.lateral[1], lot.across);
        let carried = carried(node, &lot.traction);
        let trial = [fused(carried[0], here.pull[0], lot.along), fused(carried[1], here.pull[1], across)];
        let last = remembered(node, &lot.weakening).min(1.0);
        lot.cell.open(trial, last);
    }

    #[inline(always)]
    fn close<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &mut March<S, T>) {
        let (at, of) = lot.cell.close(&self.law, here.keep);
        let mut direction = lot.cell.direction(&of, here.yielding);
        if lot.cell.rest.any_true() {
            let zero = Lanes::splat(lot.y.token(), 0.0);
            direction.a = direction.a.map(|a| lot.cell.rest.select(zero, a));
        }
        let [along, across] = direction.a;
        let traction = [along * of.value * node.sin, across * of.value * node.sin];
        let x = lot.chord * (-self.direction * node.cos);
        let power = of.value * lot.cell.speed;
        add_forces(&mut lot.sums, x, traction, node.weight);
        add_power(&mut lot.sums, [power, lot.cell.speed], node.weight * node.sin);
        if T > 0 {
            let carried = carried(node, &lot.traction);
            let mean = self.place_of_slip(node, lot);
            let solved = Solved { node, at: &at, of: &of, direction: &direction, carried, x, mean };
            let response = Response::new(&lot.cell, &solved, (here.yielding, here.keep), &self.law);
            for k in 0..T {
                self.tangent(here, k, lot, &solved, &response);
            }
        }
        pass_on(&mut lot.traction, traction);
        pass_on(&mut lot.weakening, of.weakening);
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
        let Solved { node, at, of, direction: Direction { a, .. }, x, mean, .. } = *solved;
        let [du, dv, turn] = tangent.slip;
        let change = carried(node, &tangent.traction);
        let turned = fused(mean, turn, fused(tangent.mean, node.mean, dv));
        let mut trial = [fused(change[0], here.pull[0], du), fused(change[1], here.pull[1], turned)];
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
                let yielded = solved.carried[i] * node.over_sine - a[i] * of.value;
                *trial += yielded * by_yielding[i] - a[i] * kappa * here.yielding[i];
            }
        }
        let speed = response.speed(trial, weakening);
        let mut traction = response.traction(trial, weakening, speed);
        if k >= OF_MOTION {
            traction = [0, 1].map(|i| traction[i] + a[i] * kappa * node.sin);
            let power = (kappa + response.coefficient(weakening, speed)) * cell.speed + of.value * speed;
            add_power(&mut tangent.sums, [power, speed], node.weight * node.sin);
        }
        add_forces(&mut tangent.sums, x, traction, node.weight);
        pass_on(&mut tangent.weakening, response.weakening(weakening, speed));
        pass_on(&mut tangent.traction, traction);
    }
}

/// Part of a difference that comes from the cells before.
#[inline(always)]
fn carried<S: Simd>(node: &Node, [last, before, first]: &[[Lanes<S>; 2]; 3]) -> [Lanes<S>; 2] {
    [remembered(node, &[last[0], before[0], first[0]]), remembered(node, &[last[1], before[1], first[1]])]
}

#[inline(always)]
fn remembered<S: Simd>(node: &Node, [last, before, first]: &[Lanes<S>; 3]) -> Lanes<S> {
    let [a, b, c] = node.previous;
    fused(*last, a, fused(*before, b, *first * c))
}

#[inline(always)]
fn pass_on<T: Copy>(history: &mut [T; 3], last: T) {
    *history = [last, history[0], history[1]];
}

#[inline(always)]
fn add_forces<S: Simd>(sums: &mut StripSums<S>, x: Lanes<S>, [fx, fy]: [Lanes<S>; 2], weight: f64) {
    let fy = fy * weight;
    sums[0] = fused(fx, weight, sums[0]);
    sums[1] += fy;
    sums[2] = fused(x, fy, sums[2]);
}

#[inline(always)]
fn add_power<S: Simd>(sums: &mut StripSums<S>, terms: [Lanes<S>; 2], weight: f64) {
    for (sum, term) in sums[3..].iter_mut().zip(terms) {
        *sum = fused(term, weight, *sum);
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
