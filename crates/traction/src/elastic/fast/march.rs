//! The march of eight strips from leading to trailing edge, with their first derivatives.

use super::cell::{Cell, Near};
use super::curve::At;
use super::response::{Response, Solved};
use super::setup::{Law, Setup, Varied};
use super::start::Start;
use crate::SlipField;
use crate::elastic::Fastsim;
use crate::elastic::grid::Node;
use crate::fast::lanes::{Lanes, Singles, fused};
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
///
/// Aligned as vectors are: with one such number on the stack the compiler aligns all vectors that it leaves there.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct AtNode<const T: usize> {
    yielding: [f64; 2],
    keep: f64,
    /// C over the sine.
    pull: [f64; 2],
    /// C and the share that is kept, for the start.
    single: ([f32; 2], f32),
    /// Changes of C and of the share that is kept.
    by_input: [([f64; 2], f64); T],
}

/// Nodes whose numbers are worked out at once.
const BLOCK: usize = 4;

/// Trial slip and last weakening of a cell.
struct Open<S: Simd> {
    trial: [Lanes<S>; 2],
    last: Lanes<S>,
}

impl<const T: usize> AtNode<T> {
    const NOTHING: Self =
        Self { yielding: [0.0; 2], keep: 0.0, pull: [0.0; 2], single: ([0.0; 2], 0.0), by_input: [([0.0; 2], 0.0); T] };
}

/// Eight strips on their way.
#[derive(Clone, Copy)]
pub(super) struct March<S: Simd, const T: usize> {
    pub(super) y: Lanes<S>,
    pub(super) chord: Lanes<S>,
    along: Lanes<S>,
    /// Slip across: by itself, over a node's cos θ, and over its mean.
    across: [Lanes<S>; 3],
    /// Traction over pressure in the direction of slip, and weakening: parts of the next three differences.
    traction: [Coming<S>; 2],
    weakening: Coming<S>,
    pub(super) sums: StripSums<S>,
    pub(super) tangents: [Tangent<S>; T],
}

/// Parts of the next three differences that are known.
type Coming<S> = [Lanes<S>; 3];

/// Derivatives of a march over one input.
#[derive(Clone, Copy)]
pub(super) struct Tangent<S: Simd> {
    /// Of u, and of v as it is and over cos θ.
    slip: [Lanes<S>; 3],
    /// Of v over the mean.
    mean: Lanes<S>,
    traction: [Coming<S>; 2],
    weakening: Coming<S>,
    pub(super) sums: StripSums<S>,
}

impl<S: Simd, const T: usize> March<S, T> {
    #[inline(always)]
    pub(super) fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let (traction, weakening, sums) = ([[z; 3]; 2], [z; 3], [z; 5]);
        let tangents = [Tangent { slip: [z; 3], mean: z, traction, weakening, sums }; T];
        Self { y: z, chord: z, along: z, across: [z; 3], traction, weakening, sums, tangents }
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

    /// Marches lots of eight strips side by side, each at its own place across the groove.
    #[inline(always)]
    pub(super) fn march<S: Simd, const L: usize>(&self, lots: &mut [March<S, T>; L]) {
        for lot in lots.iter_mut() {
            self.enter(lot);
        }
        let mut numbers = [AtNode::NOTHING; BLOCK];
        for nodes in self.grid.nodes.chunks(BLOCK) {
            for (here, node) in numbers.iter_mut().zip(nodes) {
                *here = self.at_node(node);
            }
            for (here, node) in numbers.iter().zip(nodes) {
                self.step(node, here, lots);
            }
        }
        for lot in lots.iter_mut() {
            let edge = lot.chord * -self.direction;
            lot.sums[2] *= edge;
            for tangent in &mut lot.tangents {
                tangent.sums[2] *= edge;
            }
        }
    }

    /// One cell of every strip.
    #[inline(always)]
    fn step<S: Simd, const L: usize>(&self, node: &Node, here: &AtNode<T>, lots: &mut [March<S, T>; L]) {
        // Not a loop, which the compiler would not unroll.
        let first = self.open(node, here, &lots[0]);
        if L == 1 {
            let start = self.start(here, &first);
            self.finish(node, here, (&first, start), &mut lots[0]);
            return;
        }
        let last = self.open(node, here, &lots[L - 1]);
        let [start, other] = self.starts(here, &first, &last);
        if T == 0 {
            let given = (here.yielding, here.keep);
            let (first, last) = (Cell::new(first.trial, first.last), Cell::new(last.trial, last.last));
            // Both steps before either search, so that their chains run side by side.
            let (near, other) = (first.near(&self.law, given, start), last.near(&self.law, given, other));
            let near = first.last_step(&self.law, given, near);
            let other = last.last_step(&self.law, given, other);
            self.close(node, here, (&first, &near), &mut lots[0]);
            self.close(node, here, (&last, &other), &mut lots[L - 1]);
        } else {
            // With derivatives twice the code would not fit into the processor's cache.
            for (lot, begun) in lots.iter_mut().zip([(&first, start), (&last, other)]) {
                self.finish(node, here, begun, lot);
            }
        }
    }

    /// A speed from which the root is searched.
    #[inline(always)]
    fn start<S: Simd>(&self, here: &AtNode<T>, open: &Open<S>) -> Lanes<S> {
        let single = |v: Lanes<S>| -> Singles<S> {
            let (low, high) = v.split();
            low.narrow(high)
        };
        let [u, v] = open.trial;
        let (low, high) = self.start.speed([single(u), single(v)], single(open.last), here.single).widen();
        low.combine(high)
    }

    /// The same for two lots at once.
    #[inline(always)]
    fn starts<S: Simd>(&self, here: &AtNode<T>, first: &Open<S>, last: &Open<S>) -> [Lanes<S>; 2] {
        let trial = [first.trial[0].narrow(last.trial[0]), first.trial[1].narrow(last.trial[1])];
        self.start.speed(trial, first.last.narrow(last.last), here.single).widen().into()
    }

    /// The root of a cell that is begun.
    #[inline(always)]
    fn finish<S: Simd>(
        &self,
        node: &Node,
        here: &AtNode<T>,
        (open, start): (&Open<S>, Lanes<S>),
        lot: &mut March<S, T>,
    ) {
        let (given, cell) = ((here.yielding, here.keep), Cell::new(open.trial, open.last));
        let near = cell.last_step(&self.law, given, cell.near(&self.law, given, start));
        self.close(node, here, (&cell, &near), lot);
    }

    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "only starts are in single precision")]
    fn at_node(&self, node: &Node) -> AtNode<T> {
        let yielding = self.yielding.map(|c| c * node.over_reach);
        let over = (self.memory + node.memory_reach).recip();
        let mut by_input = [([0.0; 2], 0.0); T];
        for (by, varied) in by_input.iter_mut().zip(&self.varied) {
            let [x, y] = varied.yielding;
            let keep = varied.memory * node.memory_reach * over * over;
            *by = ([x.eps * node.over_reach, y.eps * node.over_reach], keep);
        }
        let (keep, [x, y]) = (self.memory * over, yielding);
        let pull = [x * node.over_sine, y * node.over_sine];
        AtNode { yielding, keep, pull, single: ([x as f32, y as f32], keep as f32), by_input }
    }

    /// The slip of the strip, and the weakening that belongs to the rigid slip at its leading edge.
    #[inline(always)]
    fn enter<S: Simd>(&self, lot: &mut March<S, T>) {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (self.slip.longitudinal, self.slip.lateral);
        let (y, zero) = (lot.y, Lanes::splat(lot.y.token(), 0.0));
        let y2 = y * y;
        lot.chord = ((-y + 1.0) * (y + 1.0)).max(0.0).sqrt();
        lot.along = fused(-y, fused(y, alpha, beta), gamma);
        let (across, edge) = (fused(y2, epsilon, delta), lot.chord * -self.direction);
        let turn = edge * sigma;
        let v = across + turn;
        let speed = (lot.along * lot.along + v * v).max(1e-200).sqrt();
        let over = Lanes::splat(y.token(), 1.0) / (speed * 0.5 + (self.taken_up + f64::MIN_POSITIVE));
        let sticking = over * self.taken_up;
        lot.across = [across, turn, turn * sticking];
        let at = At::new(&self.law, speed);
        lot.weakening = self.entering(at.rising_and_lost(&self.law)[1]);
        lot.traction = [[zero; 3]; 2];
        lot.sums = [zero; 5];
        for (tangent, varied) in lot.tangents.iter_mut().zip(&self.varied) {
            for (slip, [one, linear, square]) in tangent.slip.iter_mut().zip(&varied.slip) {
                *slip = y * *linear + y2 * *square + *one;
            }
            (tangent.traction, tangent.sums) = ([[zero; 3]; 2], [zero; 5]);
            tangent.slip[2] *= edge;
            let [du, dv, turn] = tangent.slip;
            let change = (lot.along * du + v * (dv + turn)) / speed;
            let [_, lost] = law_change(&self.law, &varied.law, &at, speed);
            let by_speed = at.past.select(at.slope * -self.law.over_peak, zero);
            tangent.weakening = self.entering(lost + by_speed * change);
            let by_sticking = (speed * varied.taken_up - change * self.taken_up) * over * over * 0.5;
            tangent.mean = fused(by_sticking, edge * sigma, sticking * turn);
        }
    }

    /// Parts of the first differences of what is the same at and before the leading edge.
    #[inline(always)]
    fn entering<S: Simd>(&self, edge: Lanes<S>) -> Coming<S> {
        let [a, b, c] = self.grid.entering;
        [edge * a, edge * b, edge * c]
    }

    #[inline(always)]
    fn open<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &March<S, T>) -> Open<S> {
        let ([along, across], [one, cos, mean]) = (&lot.traction, lot.across);
        let v = fused(mean, node.mean, fused(cos, node.cos, one));
        let trial = [fused(along[0], here.pull[0], lot.along), fused(across[0], here.pull[1], v)];
        Open { trial, last: lot.weakening[0].min(1.0) }
    }

    #[inline(always)]
    fn close<S: Simd>(&self, node: &Node, here: &AtNode<T>, (cell, near): (&Cell<S>, &Near<S>), lot: &mut March<S, T>) {
        let root = cell.root(&self.law, here.keep, near);
        let ([along, across], of) = (root.direction, &root.of);
        let size = of.value * node.sin;
        let traction = [along * size, across * size];
        add_forces(&mut lot.sums, node, traction);
        add_power(&mut lot.sums, node, [of.value * root.speed, root.speed]);
        if T > 0 {
            let around = cell.around(&self.law, here.yielding, near, &root);
            let carried = [lot.traction[0][0], lot.traction[1][0]];
            let solved = Solved { node, cell, root: &root, around: &around, carried };
            let response = Response::new(&solved, (here.yielding, here.keep), &self.law);
            for k in 0..T {
                self.tangent(here, k, lot, &solved, &response);
            }
        }
        for (coming, traction) in lot.traction.iter_mut().zip(traction) {
            pass_on(coming, node, traction);
        }
        pass_on(&mut lot.weakening, node, root.weakening);
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
        let tangent = &mut lot.tangents[k];
        let Solved { node, root, around, .. } = *solved;
        let (of, a) = (&root.of, root.direction);
        let [du, dv, turn] = tangent.slip;
        let v = fused(turn, node.cos, fused(tangent.mean, node.mean, dv));
        let mut trial =
            [fused(tangent.traction[0][0], here.pull[0], du), fused(tangent.traction[1][0], here.pull[1], v)];
        let mut weakening = tangent.weakening[0] * here.keep;
        // Of κ at the same slip and weakening.
        let mut kappa = Lanes::splat(lot.y.token(), 0.0);
        if k >= OF_SLIP {
            let (by_yielding, by_keep) = here.by_input[k];
            let [_, lost] = around.at.rising_and_lost(&self.law);
            let [by_rising, by_lost] = law_change(&self.law, &self.varied[k].law, &around.at, root.speed);
            weakening += (solved.cell.last - lost) * by_keep + by_lost * (1.0 - here.keep);
            kappa = by_rising * (-root.weakening + 1.0);
            for (i, trial) in trial.iter_mut().enumerate() {
                let yielded = solved.carried[i] * node.over_sine - a[i] * of.value;
                *trial += yielded * by_yielding[i] - a[i] * kappa * here.yielding[i];
            }
        }
        let speed = response.speed(trial, weakening);
        let mut traction = response.traction(trial, weakening, speed);
        if k >= OF_MOTION {
            let plain = kappa * node.sin;
            traction = [fused(a[0], plain, traction[0]), fused(a[1], plain, traction[1])];
            let power = (kappa + response.coefficient(weakening, speed)) * root.speed + of.value * speed;
            add_power(&mut tangent.sums, node, [power, speed]);
        }
        add_forces(&mut tangent.sums, node, traction);
        pass_on(&mut tangent.weakening, node, response.weakening(weakening, speed));
        for (coming, traction) in tangent.traction.iter_mut().zip(traction) {
            pass_on(coming, node, traction);
        }
    }
}

/// Adds what is now known to the next three differences.
#[inline(always)]
fn pass_on<S: Simd>(coming: &mut Coming<S>, node: &Node, known: Lanes<S>) {
    let [a, b, c] = node.next;
    *coming = [fused(known, a, coming[1]), fused(known, b, coming[2]), known * c];
}

#[inline(always)]
fn add_forces<S: Simd>(sums: &mut StripSums<S>, node: &Node, [fx, fy]: [Lanes<S>; 2]) {
    sums[0] = fused(fx, node.weight, sums[0]);
    sums[1] = fused(fy, node.weight, sums[1]);
    sums[2] = fused(fy, node.weight * node.cos, sums[2]);
}

#[inline(always)]
fn add_power<S: Simd>(sums: &mut StripSums<S>, node: &Node, terms: [Lanes<S>; 2]) {
    for (sum, term) in sums[3..].iter_mut().zip(terms) {
        *sum = fused(term, node.weight * node.sin, *sum);
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
    let slip = speed * law.scale;
    let inner = slip * law.curve.b + law.curve.a;
    let by_curve = at.e * by.a.eps + slip * at.decay * (inner * -by.c.eps + by.b.eps);
    let plain = by_curve + speed * at.slope * (varied.scale.eps / law.scale);
    let lost = plain * -law.over_peak + at.plain * (peak * law.over_peak * law.over_peak);
    [at.past.select(Lanes::splat(speed.token(), peak), plain), at.past.select(lost, zero)]
}
