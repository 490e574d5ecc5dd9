//! The nodes of a patch rule in lanes of eight, and the walk over them.

use super::elementary::{exp, ln};
use super::lanes::{LANES, Lanes, Mask, fused};
use crate::quadrature::Nodes;
use crate::strips::{AlongNode, SMALLEST_WIDTH, SPINLESS, panels};
use crate::{Quadrature, SlipField};
use fearless_simd::prelude::*;

/// Sums over the nodes.
pub(crate) trait Kernel<S: Simd> {
    /// Adds a block of nodes.
    fn block(&mut self, block: &Block<S>);
}

/// Rows in a block, and nodes in one of its rows. The work on a node is one long chain of dependent operations: a block
/// is passed through in stages, so that the chains of its nodes run side by side.
pub(crate) const ROWS: usize = 2;
pub(crate) const NODES: usize = 4;

/// Some rows of nodes; a row is a line of constant Y, on which the longitudinal slip is constant.
pub(crate) struct Block<S: Simd> {
    pub(crate) y: [Lanes<S>; ROWS],
    /// X and the weight of the nodes, row by row.
    pub(crate) x: [[Lanes<S>; NODES]; ROWS],
    pub(crate) w: [[Lanes<S>; NODES]; ROWS],
    /// Number of these in use.
    pub(crate) rows: usize,
    pub(crate) nodes: usize,
}

impl<S: Simd> Block<S> {
    #[inline(always)]
    fn new(simd: S) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        Self { y: [zero; ROWS], x: [[zero; NODES]; ROWS], w: [[zero; NODES]; ROWS], rows: 0, nodes: 0 }
    }
}

/// The nodes of a rule, eight to a lane group; numbers left over carry no weight.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Layout {
    /// (X₁, X₂, Y, w): two nodes of the same Y and weight.
    Paired(Vec<[[f64; LANES]; 4]>),
    /// Strips across the groove.
    Strips(Strips),
}

/// Tables of the split strips.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Strips {
    /// The strips of one, two and three panels.
    across: [Vec<Across>; PANELS],
    along: Vec<AlongNode>,
}

/// Two cuts make three panels at most.
const PANELS: usize = 3;

/// Eight strips across the groove.
#[derive(Debug, Clone, PartialEq)]
struct Across {
    /// Which panel; none for lanes that are left over.
    panel: [f64; LANES],
    /// Share of the panel's length, and the derivative of this share times the node's weight.
    share: [f64; LANES],
    slope: [f64; LANES],
}

impl Across {
    /// All strips of so many panels.
    fn of(panels: usize, across: &[(f64, f64)]) -> Vec<Self> {
        let strips: Vec<_> =
            (0..panels).flat_map(|panel| across.iter().map(move |node| (panel as f64, *node))).collect();
        let lot = |lot: &[(f64, (f64, f64))]| {
            let mut lanes = Self { panel: [PANELS as f64; LANES], share: [0.0; LANES], slope: [0.0; LANES] };
            for (k, &(panel, (t, w))) in lot.iter().enumerate() {
                lanes.panel[k] = panel;
                lanes.share[k] = t * t * (3.0 - 2.0 * t);
                lanes.slope[k] = 6.0 * t * (1.0 - t) * w;
            }
            lanes
        };
        strips.chunks(LANES).map(lot).collect()
    }

    /// Y, and the width of the strip times the rule's weight; zero in lanes that are left over.
    #[inline(always)]
    fn places<S: Simd>(&self, simd: S, spans: &[[f64; 2]]) -> [Lanes<S>; 2] {
        let zero = Lanes::splat(simd, 0.0);
        let (panel, mut start, mut length) = (Lanes::simd_from(simd, self.panel), zero, zero);
        for (k, &[from, long]) in spans.iter().enumerate() {
            let here = panel.simd_eq(k as f64);
            start = here.select(Lanes::splat(simd, from), start);
            length = here.select(Lanes::splat(simd, long), length);
        }
        [start + length * Lanes::simd_from(simd, self.share), length * Lanes::simd_from(simd, self.slope)]
    }
}

impl Layout {
    pub(crate) fn new(quadrature: &Quadrature) -> Self {
        match quadrature.nodes() {
            Nodes::Fixed(points) => Self::Paired(paired(points)),
            Nodes::Strips { across, along } => Self::Strips(Strips {
                across: [1, 2, 3].map(|panels| Across::of(panels, across)),
                along: along.clone(),
            }),
        }
    }

    /// Most groups of eight nodes.
    pub(crate) fn groups(&self) -> usize {
        match self {
            Self::Paired(groups) => 2 * groups.len(),
            Self::Strips(strips) => {
                let along: usize = strips.along.iter().map(AlongNode::multiplicity).sum();
                strips.across.iter().map(Vec::len).max().unwrap_or(0) * along
            }
        }
    }

    /// Feeds every node to the kernel.
    #[inline(always)]
    pub(crate) fn walk<S: Simd, K: Kernel<S>>(&self, simd: S, slip: &SlipField, kernel: &mut K) {
        match self {
            Self::Paired(groups) => {
                let mut block = Block::new(simd);
                block.nodes = 2;
                for chunk in groups.chunks(ROWS) {
                    block.rows = chunk.len();
                    for (i, group) in chunk.iter().enumerate() {
                        let [first, second, y, w] = *group;
                        block.y[i] = Lanes::simd_from(simd, y);
                        block.x[i][0] = Lanes::simd_from(simd, first);
                        block.x[i][1] = Lanes::simd_from(simd, second);
                        block.w[i][0] = Lanes::simd_from(simd, w);
                        block.w[i][1] = block.w[i][0];
                    }
                    kernel.block(&block);
                }
            }
            Self::Strips(strips) => strips.walk(simd, slip, kernel),
        }
    }
}

/// Two nodes of the same Y and weight make a pair: the polar rules have such nodes at ±X where the number of angles is
/// even. A node without a partner is paired with itself at half its weight.
fn paired(points: &[[f64; 3]]) -> Vec<[[f64; LANES]; 4]> {
    // Equal but for rounding of sines and cosines.
    const SAME: f64 = 1e-14;
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| p[1].total_cmp(&q[1]));
    let mut taken = vec![false; sorted.len()];
    let mut rows = Vec::with_capacity(sorted.len().div_ceil(2));
    for (i, &[x, y, w]) in sorted.iter().enumerate() {
        if std::mem::replace(&mut taken[i], true) {
            continue;
        }
        let partner = (i + 1..sorted.len())
            .take_while(|&j| sorted[j][1] - y <= SAME)
            .find(|&j| !taken[j] && (sorted[j][2] - w).abs() <= SAME * w);
        rows.push(match partner {
            Some(j) => {
                taken[j] = true;
                [x, sorted[j][0], y, w]
            }
            None => [x, x, y, 0.5 * w],
        });
    }
    rows.chunks(LANES)
        .map(|chunk| std::array::from_fn(|k| std::array::from_fn(|lane| chunk.get(lane).map_or(0.0, |row| row[k]))))
        .collect()
}

impl Strips {
    #[inline(always)]
    fn walk<S: Simd, K: Kernel<S>>(&self, simd: S, slip: &SlipField, kernel: &mut K) {
        let mut spans = [[0.0; 2]; PANELS];
        let mut count: usize = 0;
        for (span, panel) in spans.iter_mut().zip(panels(slip.longitudinal)) {
            *span = [panel.start, panel.end - panel.start];
            count += 1;
        }
        let Some(across) = count.checked_sub(1).and_then(|k| self.across.get(k)) else { return };
        let mut block = Block::new(simd);
        let mut maps = [Map::nothing(simd); ROWS];
        for lots in across.chunks(ROWS) {
            block.rows = lots.len();
            let maps = &mut maps[..block.rows];
            for ((map, place), lot) in maps.iter_mut().zip(&mut block.y).zip(lots) {
                [*place, map.share] = lot.places(simd, &spans[..count]);
                map.locate(slip, *place);
            }
            for map in maps.iter_mut() {
                map.span();
            }
            for map in maps.iter_mut() {
                map.finish();
            }
            for nodes in self.along.chunks(NODES / 2) {
                block.nodes = nodes.iter().map(AlongNode::multiplicity).sum();
                for (i, map) in maps.iter().enumerate() {
                    map.nodes(nodes, &mut block.x[i], &mut block.w[i]);
                }
                kernel.block(&block);
            }
        }
    }
}

/// The map ξ = ξ_c + ε sinh(A t + B) of eight strips, as [`crate::strips::along_strip`] has it.
///
/// It is arranged for fewer roots and divisions: with U, D = d + √(d² + ε²) at the distances d of ξ_c to both ends,
/// exp(2A) = U D/ε² and exp(2B) = U/D.
///
/// Made in three stages, each over all rows of a block.
#[derive(Clone, Copy)]
struct Map<S: Simd> {
    /// Width of the strips times the rule's weight, later times 1 − Y².
    share: Lanes<S>,
    chord: Lanes<S>,
    /// Lanes that keep Chebyshev's nodes, for want of spin.
    plain: Mask<S>,
    centre: Lanes<S>,
    /// ε².
    width2: Lanes<S>,
    /// U and D, later ½ε exp(B) and ½ε exp(−B).
    rising: Lanes<S>,
    falling: Lanes<S>,
    /// A.
    half_span: Lanes<S>,
}

impl<S: Simd> Map<S> {
    #[inline(always)]
    fn nothing(simd: S) -> Self {
        let z = Lanes::splat(simd, 0.0);
        let plain = z.simd_lt(z);
        Self { share: z, chord: z, plain, centre: z, width2: z, rising: z, falling: z, half_span: z }
    }

    /// Centre and width.
    #[inline(always)]
    fn locate(&mut self, slip: &SlipField, y: Lanes<S>) {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (slip.longitudinal, slip.lateral);
        // Rounding may place a strip at the very end outside the patch.
        let squared = ((-y + 1.0) * (y + 1.0)).max(0.0);
        let y2 = y * y;
        let along = fused(-y, fused(y, alpha, beta), gamma);
        let offset = fused(y2, epsilon, delta);
        let (along2, offset2, q2) = (along * along, offset * offset, squared * (sigma * sigma));
        self.plain = q2.simd_le((along2 + offset2) * SPINLESS) | q2.simd_lt(1e-60);
        // Offset by the sign of q, which is that of the spin.
        let signed = if sigma > 0.0 { -offset } else { offset };
        self.centre = signed / fused(q2, q2, offset2 * offset2).sqrt().sqrt();
        self.chord = squared.sqrt();
        self.share *= squared;
        let inverse = Lanes::splat(y.token(), 1.0) / (q2 * squared);
        let q2_inverse = inverse * squared;
        let outside = fused(signed * (self.chord * sigma.abs()), q2_inverse, -self.centre);
        let least = inverse * q2 * (SMALLEST_WIDTH * SMALLEST_WIDTH);
        self.width2 = fused(along2, q2_inverse, fused(outside, outside, least));
    }

    /// U and D.
    #[inline(always)]
    fn span(&mut self) {
        let (right, left) = (-self.centre + 1.0, self.centre + 1.0);
        self.rising = right + fused(right, right, self.width2).sqrt();
        self.falling = left + fused(left, left, self.width2).sqrt();
    }

    #[inline(always)]
    fn finish(&mut self) {
        let product = self.rising * self.falling;
        let inverse = Lanes::splat(product.token(), 0.5) / (product * self.width2).sqrt();
        let half = self.width2 * inverse;
        self.half_span = ln(product * inverse * 2.0);
        self.rising *= half;
        self.falling *= half;
    }

    /// X and w of the nodes at ±t for each t.
    #[inline(always)]
    fn nodes(&self, along: &[AlongNode], x: &mut [Lanes<S>; NODES], w: &mut [Lanes<S>; NODES]) {
        let mut free = x.iter_mut().zip(w);
        let mut put = |rising: Lanes<S>, falling: Lanes<S>, t: f64, node: &AlongNode| {
            if let Some((x, w)) = free.next() {
                (*x, *w) = self.at(rising, falling, t, node);
            }
        };
        for node in along {
            if node.t > 0.0 {
                let stretch = exp(self.half_span * node.t);
                let inverse = Lanes::splat(stretch.token(), 1.0) / stretch;
                put(self.rising * stretch, self.falling * inverse, node.t, node);
                put(self.rising * inverse, self.falling * stretch, -node.t, node);
            } else {
                put(self.rising, self.falling, 0.0, node);
            }
        }
    }

    #[inline(always)]
    fn at(&self, rising: Lanes<S>, falling: Lanes<S>, t: f64, node: &AlongNode) -> (Lanes<S>, Lanes<S>) {
        let xi = self.centre + (rising - falling);
        let edge = ((-xi + 1.0) * (xi + 1.0)).max(0.0).sqrt();
        let w = edge * self.half_span * ((rising + falling) * node.edge_weight);
        let plain = |value: f64| Lanes::splat(xi.token(), value);
        let xi = self.plain.select(plain(t), xi);
        (self.chord * xi, self.share * self.plain.select(plain(node.weight), w))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PatchRule;

    #[test]
    fn identity_pairs_hold_every_node_once() {
        for (radial, count) in [(1usize, 1usize), (2, 3), (3, 7), (4, 8), (2, 10), (10, 40)] {
            for rule in [
                PatchRule::PolarMidpoint { radial, circumferential: count },
                PatchRule::GaussJacobi { radial, angles: count },
            ] {
                let Layout::Paired(groups) = Layout::new(&Quadrature::new(rule).unwrap()) else {
                    unreachable!("polar rules have fixed nodes")
                };
                let rows: usize = groups.iter().map(|g| g[3].iter().filter(|&&w| w > 0.0).count()).sum();
                // Nodes at X = 0 stand alone: two in a ring.
                assert!(2 * rows <= radial * (count + 2) || count % 2 == 1, "{rule:?}: {rows}");
                let (mut ours, mut plain) = ([0.0; 4], [0.0; 4]);
                let moments = |x: f64, y: f64, w: f64| [w, w * x, w * y, w * x * y * y];
                Quadrature::new(rule)
                    .unwrap()
                    .for_each(&SlipField { longitudinal: [0.0; 3], lateral: [0.0; 3] }, |x, y, w| {
                        moments(x, y, w).iter().zip(&mut plain).for_each(|(m, sum)| *sum += m)
                    });
                for [x1, x2, y, w] in groups {
                    for lane in 0..LANES {
                        for x in [x1[lane], x2[lane]] {
                            moments(x, y[lane], w[lane]).iter().zip(&mut ours).for_each(|(m, sum)| *sum += m);
                        }
                    }
                }
                assert!(ours.iter().zip(plain).all(|(a, b)| (a - b).abs() < 1e-14), "{rule:?}: {ours:?} {plain:?}");
            }
        }
    }
}
