//! The nodes of a patch rule in lanes of four, and the walk over them.

use super::elementary::{exp, ln};
use crate::quadrature::Nodes;
use crate::strips::{AlongNode, SMALLEST_WIDTH, SPINLESS, panels};
use crate::{Quadrature, SlipField};
use fearless_simd::{f64x4, mask64x4, prelude::*};

/// What is summed over the nodes. A row is a line of constant Y, on which the longitudinal slip is constant.
pub(super) trait Kernel<S: Simd> {
    /// The sums of one row.
    type Row;
    /// Starts a row at Y.
    fn open(&self, y: f64x4<S>) -> Self::Row;
    /// Adds the node X with weight w.
    fn point(&self, row: &mut Self::Row, x: f64x4<S>, w: f64x4<S>);
    /// Adds the row to the integrals.
    fn close(&mut self, row: Self::Row);
}

/// The nodes of a rule, four to a lane group; numbers left over carry no weight.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Layout {
    /// (X₁, X₂, Y, w): two nodes of the same Y and weight.
    Paired(Vec<[[f64; 4]; 4]>),
    /// Strips across the groove.
    Strips(Strips),
}

/// Tables of the split strips.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strips {
    /// Share of the panel's length at a node across, and the derivative of this share times the node's weight.
    across: Vec<[f64; 2]>,
    along: Vec<AlongNode>,
}

impl Layout {
    pub(super) fn new(quadrature: &Quadrature) -> Self {
        match quadrature.nodes() {
            Nodes::Fixed(points) => Self::Paired(paired(points)),
            Nodes::Strips { across, along } => Self::Strips(Strips {
                across: across.iter().map(|&(t, w)| [t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) * w]).collect(),
                along: along.clone(),
            }),
        }
    }

    /// Feeds every node to the kernel.
    #[inline(always)]
    pub(super) fn walk<S: Simd, K: Kernel<S>>(&self, simd: S, slip: &SlipField, kernel: &mut K) {
        match self {
            Self::Paired(groups) => {
                for group in groups {
                    let [first, second, y, w] = group.map(|lanes| f64x4::simd_from(simd, lanes));
                    let mut row = kernel.open(y);
                    kernel.point(&mut row, first, w);
                    kernel.point(&mut row, second, w);
                    kernel.close(row);
                }
            }
            Self::Strips(strips) => strips.walk(simd, slip, kernel),
        }
    }
}

/// Two nodes of the same Y and weight make a pair: the polar rules have such nodes at ±X where the number of angles is
/// even. A node without a partner is paired with itself at half its weight.
fn paired(points: &[[f64; 3]]) -> Vec<[[f64; 4]; 4]> {
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
    rows.chunks(4)
        .map(|chunk| std::array::from_fn(|k| std::array::from_fn(|lane| chunk.get(lane).map_or(0.0, |row| row[k]))))
        .collect()
}

impl Strips {
    #[inline(always)]
    fn walk<S: Simd, K: Kernel<S>>(&self, simd: S, slip: &SlipField, kernel: &mut K) {
        // Two cuts make three panels at most.
        let mut spans = [[0.0; 2]; 3];
        let mut count = 0;
        for (span, panel) in spans.iter_mut().zip(panels(slip.longitudinal)) {
            *span = [panel.start, panel.end - panel.start];
            count += 1;
        }
        let mut strips = spans[..count].iter().flat_map(|&span| self.across.iter().map(move |&node| (span, node)));
        for _ in 0..(count * self.across.len()).div_ceil(4) {
            let (mut y, mut share) = ([0.0; 4], [0.0; 4]);
            for lane in 0..4 {
                if let Some(([start, length], [grade, slope])) = strips.next() {
                    y[lane] = start + length * grade;
                    share[lane] = length * slope;
                }
            }
            self.group(slip, f64x4::simd_from(simd, y), f64x4::simd_from(simd, share), kernel);
        }
    }

    /// Four strips at once; `share` is their width times the rule's weight.
    #[inline(always)]
    fn group<S: Simd, K: Kernel<S>>(&self, slip: &SlipField, y: f64x4<S>, share: f64x4<S>, kernel: &mut K) {
        // Rounding may place a strip at the very end outside the patch.
        let squared = ((-y + 1.0) * (y + 1.0)).max(0.0);
        let (chord, share) = (squared.sqrt(), squared * share);
        let map = Map::new(slip, y, squared, chord);
        let mut row = kernel.open(y);
        for node in &self.along {
            let nodes = if node.t > 0.0 { map.pair(node) } else { [map.middle(node); 2] };
            let [(xi, w), (mirror, other)] = nodes;
            kernel.point(&mut row, chord * xi, share * w);
            if node.t > 0.0 {
                kernel.point(&mut row, chord * mirror, share * other);
            }
        }
        kernel.close(row);
    }
}

/// The map ξ = ξ_c + ε sinh(A t + B) of four strips, as [`crate::strips::along_strip`] has it, arranged for fewer roots
/// and divisions: with U, D = d + √(d² + ε²) at the distances d of ξ_c to both ends, exp(2A) = U D/ε² and exp(2B) = U/D.
struct Map<S: Simd> {
    /// Lanes that keep Chebyshev's nodes, for want of spin.
    plain: mask64x4<S>,
    centre: f64x4<S>,
    half_span: f64x4<S>,
    /// ½ε exp(B) and ½ε exp(−B).
    rising: f64x4<S>,
    falling: f64x4<S>,
}

impl<S: Simd> Map<S> {
    #[inline(always)]
    fn new(slip: &SlipField, y: f64x4<S>, squared: f64x4<S>, chord: f64x4<S>) -> Self {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (slip.longitudinal, slip.lateral);
        let along = -(y * (y * alpha + beta)) + gamma;
        let (offset, q) = (y * y * epsilon + delta, chord * sigma);
        let (along2, offset2, q2) = (along * along, offset * offset, q * q);
        let plain = q2.simd_le((along2 + offset2) * SPINLESS) | q2.simd_lt(1e-60);
        // offset/|q| by the sign of q, which is that of the spin.
        let signed = if sigma > 0.0 { -offset } else { offset };
        let centre = signed / (q2 * q2 + offset2 * offset2).sqrt().sqrt();
        let both = f64x4::splat(y.token(), 1.0) / (q2 * squared);
        let q2_inverse = both * squared;
        let outside = signed * (chord * sigma.abs()) * q2_inverse - centre;
        let narrowest2 = both * q2 * (SMALLEST_WIDTH * SMALLEST_WIDTH);
        let width2 = along2 * q2_inverse + outside * outside + narrowest2;
        let width = width2.sqrt();
        let (right, left) = (-centre + 1.0, centre + 1.0);
        let up = right + (right * right + width2).sqrt();
        let down = left + (left * left + width2).sqrt();
        let product = up * down;
        let root = product.sqrt();
        let inverse = f64x4::splat(y.token(), 0.5) / (root * width);
        let half = width2 * inverse;
        Self { plain, centre, half_span: ln(product * inverse * 2.0), rising: up * half, falling: down * half }
    }

    /// ξ and w of the nodes at ±t.
    #[inline(always)]
    fn pair(&self, node: &AlongNode) -> [(f64x4<S>, f64x4<S>); 2] {
        let stretch = exp(self.half_span * node.t);
        let inverse = f64x4::splat(stretch.token(), 1.0) / stretch;
        [
            self.at(self.rising * stretch, self.falling * inverse, node.t, node),
            self.at(self.rising * inverse, self.falling * stretch, -node.t, node),
        ]
    }

    /// The same at t = 0.
    #[inline(always)]
    fn middle(&self, node: &AlongNode) -> (f64x4<S>, f64x4<S>) {
        self.at(self.rising, self.falling, 0.0, node)
    }

    #[inline(always)]
    fn at(&self, rising: f64x4<S>, falling: f64x4<S>, t: f64, node: &AlongNode) -> (f64x4<S>, f64x4<S>) {
        let xi = self.centre + (rising - falling);
        let edge = ((-xi + 1.0) * (xi + 1.0)).max(0.0).sqrt();
        let w = edge * self.half_span * ((rising + falling) * node.edge_weight);
        let plain = |value: f64| f64x4::splat(xi.token(), value);
        (self.plain.select(plain(t), xi), self.plain.select(plain(node.weight), w))
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
                if count % 2 == 0 {
                    assert_eq!(2 * rows, radial * count, "{rule:?}");
                }
                let (mut ours, mut plain) = ([0.0; 4], [0.0; 4]);
                let moments = |x: f64, y: f64, w: f64| [w, w * x, w * y, w * x * y * y];
                Quadrature::new(rule)
                    .unwrap()
                    .for_each(&SlipField { longitudinal: [0.0; 3], lateral: [0.0; 3] }, |x, y, w| {
                        moments(x, y, w).iter().zip(&mut plain).for_each(|(m, sum)| *sum += m)
                    });
                for [x1, x2, y, w] in groups {
                    for lane in 0..4 {
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
