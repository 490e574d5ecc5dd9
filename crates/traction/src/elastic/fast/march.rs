//! The march of eight strips from leading to trailing edge, with their first derivatives.

use super::cell::{At, Cell, Coefficient, Direction};
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
const USUAL: usize = 3;

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
            // Fewer steps are hardly ever enough.
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
        (lot.cell.speed, lot.cell.before) = (zero, zero);
        for (tangent, varied) in lot.tangents.iter_mut().zip(&self.varied) {
            tangent.slip = varied.slip.map(|[one, linear, square]| y * linear + y2 * square + one);
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
        lot.cell.open(trial, remembered(node, &lot.weakening).min(1.0));
    }

    #[inline(always)]
    fn close<S: Simd>(&self, node: &Node, here: &AtNode<T>, lot: &mut March<S, T>) {
        let zero = Lanes::splat(lot.y.token(), 0.0);
        lot.cell.speed = lot.cell.rest.select(zero, lot.cell.speed);
        let [value, weakening] = lot.cell.found;
        let weakening = lot.cell.rest.select(lot.cell.last * here.keep, weakening);
        let mut of = Coefficient { value, slope: zero, weakening };
        // Derivatives need the curve's slope as well.
        let at = (T > 0).then(|| At::new(&self.law, lot.cell.speed));
        if let Some(at) = &at {
            of.slope = lot.cell.coefficient(&self.law, at, here.keep).slope;
        }
        let mut direction = lot.cell.direction(&of, here.yielding);
        direction.a = direction.a.map(|a| lot.cell.rest.select(zero, a));
        let traction = direction.a.map(|a| a * of.value * node.sin);
        let x = lot.chord * (-self.direction * node.cos);
        let weight = self.grid.spacing * node.sin;
        let power = of.value * lot.cell.speed;
        add(&mut lot.sums, x, traction, [power, lot.cell.speed], [weight, weight * node.sin]);
        if let Some(at) = &at {
            let one = Lanes::splat(zero.token(), 1.0);
            // At rest traction follows slip by the initial slope.
            let initial = (-of.weakening + 1.0) * self.law.initial_slope();
            let solved = Solved {
                at,
                of: &of,
                direction: &direction,
                carried: carried(node, &lot.traction),
                x,
                over_rise: one / direction.rise,
                still: here.yielding.map(|c| initial / (initial * c + 1.0)),
            };
            for k in 0..T {
                self.tangent(node, here, k, lot, &solved, weight);
            }
        }
        lot.traction = [traction, lot.traction[0]];
        lot.weakening = [of.weakening, lot.weakening[0]];
    }

    /// Derivatives of a solved cell over input `k`.
    #[inline(always)]
    fn tangent<S: Simd>(
        &self,
        node: &Node,
        here: &AtNode<T>,
        k: usize,
        lot: &mut March<S, T>,
        solved: &Solved<'_, S>,
        weight: f64,
    ) {
        let (cell, tangent) = (&lot.cell, &mut lot.tangents[k]);
        let Solved { at, of, direction: Direction { a, inverse, .. }, carried: before, x, .. } = *solved;
        let zero = Lanes::splat(x.token(), 0.0);
        let (by_yielding, by_keep) = here.by_input[k];
        let [du, dv, turn] = tangent.slip;
        let rigid = [du, dv + x * turn];
        let change = carried(node, &tangent.traction);
        let over_sine = node.sin.recip();
        let trial: [Lanes<S>; 2] =
            std::array::from_fn(|i| rigid[i] + (change[i] * here.yielding[i] + before[i] * by_yielding[i]) * over_sine);
        let [rising, lost] = at.rising_and_lost(&self.law);
        let [by_rising, by_lost] = law_change(&self.law, &self.varied[k].law, at, cell.speed);
        let fresh = 1.0 - here.keep;
        let weakening =
            remembered(node, &tangent.weakening) * here.keep + (cell.last - lost) * by_keep + by_lost * fresh;
        let kappa = by_rising * (-of.weakening + 1.0) - rising * weakening;
        let push: [Lanes<S>; 2] =
            std::array::from_fn(|i| trial[i] - a[i] * (of.value * by_yielding[i] + kappa * here.yielding[i]));
        let speed = (a[0] * inverse[0] * push[0] + a[1] * inverse[1] * push[1]) * solved.over_rise;
        let speed = cell.rest.select(zero, speed);
        let kappa = kappa + of.slope * speed;
        let traction: [Lanes<S>; 2] = std::array::from_fn(|i| {
            let turned = inverse[i] * (push[i] - a[i] * (of.slope * here.yielding[i] + 1.0) * speed);
            cell.rest.select(solved.still[i] * trial[i], kappa * a[i] + of.value * turned) * node.sin
        });
        let by_speed = at.past.select(at.slope * (-fresh * self.law.over_peak), zero);
        tangent.weakening = [weakening + by_speed * speed, tangent.weakening[0]];
        let power = kappa * cell.speed + of.value * speed;
        add(&mut tangent.sums, x, traction, [power, speed], [weight, weight * node.sin]);
        tangent.traction = [traction, tangent.traction[0]];
    }
}

/// A solved cell.
#[derive(Clone, Copy)]
struct Solved<'a, S: Simd> {
    at: &'a At<S>,
    of: &'a Coefficient<S>,
    direction: &'a Direction<S>,
    carried: [Lanes<S>; 2],
    x: Lanes<S>,
    over_rise: Lanes<S>,
    /// Traction over trial slip where nothing slips.
    still: [Lanes<S>; 2],
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
fn add<S: Simd>(
    sums: &mut StripSums<S>,
    x: Lanes<S>,
    [fx, fy]: [Lanes<S>; 2],
    [power, wear]: [Lanes<S>; 2],
    [weight, with_pressure]: [f64; 2],
) {
    let fy = fy * weight;
    let terms = [fx * weight, fy, x * fy, power * with_pressure, wear * with_pressure];
    for (sum, term) in sums.iter_mut().zip(terms) {
        *sum += term;
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
