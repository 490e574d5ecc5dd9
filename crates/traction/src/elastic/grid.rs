//! Strips and cells of the patch.

use crate::TractionError;
use crate::fast::lanes::LANES;
use crate::quadrature::gauss_legendre;
use fearless_simd::Level;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

/// Division of the patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FastsimRule {
    /// Strips (Gauss–Legendre nodes) across the groove for each of the two lines of pure rolling that a groove can
    /// have: twice as many altogether, wherever the lines are.
    pub across: usize,
    /// Cells along a strip.
    pub cells: usize,
}

/// Crowding of the cells to the leading edge, where traction turns from sticking to sliding. Between 0.7 and 0.9 errors
/// hardly change; at 1, without a crowd, eight cells err up to one and a half times as much.
const CROWDING: f64 = 0.75;

/// The strips and cells of a [`FastsimRule`], worked out.
///
/// A strip has half length ℓ and its cells stand at x = −ℓ cos θ from the leading edge, with tan(θ/2) =
/// 0.75 tan(φ/2), φ = iπ/N. Over θ both solutions of a strip are trigonometric polynomials: 1 − cos θ where it
/// sticks under constant slip, sin θ where it slides under a Hertz pressure. Derivatives are backward differences of
/// third order, exact for 1, cos θ, sin θ and θ,
/// ```text
/// q'(θ_i) = (q_i − Σ_j A_j q_(i−j))/k,   j = 1, 2, 3
/// ```
/// of second order in the second cell. In the first k = tan(θ/2), exact for the 1 − cos θ of traction; what does not
/// start from zero has k = θ there.
///
/// The slip of a cell is that of a place between its node, exact where the strip slides, and the mean over its
/// difference, exact where it sticks.
#[derive(Debug, Clone)]
pub struct Fastsim {
    pub(super) rule: FastsimRule,
    /// (τ, w) on [0, 1] across the patch.
    pub(super) across: Vec<(f64, f64)>,
    /// The same in lanes; those left over have no weight.
    pub(super) lots: Vec<[[f64; LANES]; 2]>,
    pub(super) nodes: Vec<Node>,
    /// As [`Node::next`], of what has been as it is at the leading edge for ever.
    pub(super) entering: [f64; 3],
    pub(super) level: Level,
}

/// One place along every strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// cos θ and sin θ.
    pub(super) cos: f64,
    pub(super) sin: f64,
    /// 1/sin θ.
    pub(super) over_sine: f64,
    /// cos θ of the mean slip over the difference less that here: ∫ cos θ sin θ dθ has its difference over sin θ.
    pub(super) mean: f64,
    /// Weight of the traction here in the integral along the strip.
    pub(super) weight: f64,
    /// A of what is here in the differences of the next three nodes.
    pub(super) next: [f64; 3],
    /// 1/k, and k of what does not start from zero at the leading edge.
    pub(super) over_reach: f64,
    pub(super) memory_reach: f64,
}

impl Node {
    /// The last of the places θ from the leading edge, with dφ sin θ/sin φ as its share of dθ, and its A of the last
    /// three nodes.
    fn new(places: &[f64], share: f64) -> (Self, [f64; 3]) {
        let last = places.len() - 1;
        let angle = places[last];
        let (sin, cos) = angle.sin_cos();
        let (over_reach, previous) = match places {
            [_, _] => ((0.5 * angle).tan().recip(), [1.0, 0.0, 0.0]),
            _ => difference(places),
        };
        // Half of sin² θ is ∫ cos θ sin θ dθ.
        let integral = |back: usize| if back > last { 0.0 } else { 0.5 * places[last - back].sin().powi(2) };
        let carried: f64 = previous.iter().zip(1..).map(|(a, back)| a * integral(back)).sum();
        let mean = (integral(0) - carried) * over_reach / sin;
        let node = Self {
            cos,
            sin,
            over_sine: sin.recip(),
            mean: mean - cos,
            weight: share * sin,
            next: [0.0; 3],
            over_reach,
            memory_reach: if last == 1 { angle } else { over_reach.recip() },
        };
        (node, previous)
    }
}

/// 1/k and A of the backward difference at the last of at least three places, over up to three before it.
fn difference(places: &[f64]) -> (f64, [f64; 3]) {
    let last = places.len() - 1;
    let back = last.min(3);
    // Weights of the values at the places, last first, from what they must be exact for: from the last place, so that
    // nothing is lost where places are close.
    let exact: [fn(f64) -> f64; 4] = [|_| 1.0, f64::sin, |x| 2.0 * (0.5 * x).sin().powi(2), |x| x - x.sin()];
    let rows = DMatrix::from_fn(back + 1, back + 1, |k, j| exact[k](places[last - j] - places[last]));
    let slopes = DVector::from_fn(back + 1, |k, _| if k == 1 { 1.0 } else { 0.0 });
    let weights = rows.lu().solve(&slopes).unwrap_or_else(|| unreachable!("places differ, within half a turn"));
    let weight = |j: usize| weights.get(j).copied().unwrap_or_default();
    (weight(0), [1, 2, 3].map(|j| -weight(j) / weight(0)))
}

impl Fastsim {
    /// Works out the strips and cells.
    ///
    /// # Errors
    /// [`TractionError::NoPoints`] without strips, or with fewer than two cells: tractions stand between cells.
    pub fn new(rule: FastsimRule) -> Result<Self, TractionError> {
        if rule.across == 0 || rule.cells < 2 {
            return Err(TractionError::NoPoints);
        }
        let spacing = PI / rule.cells as f64;
        let place = |i: usize| 2.0 * (CROWDING * (0.5 * spacing * i as f64).tan()).atan();
        let places: Vec<f64> = (0..rule.cells).map(place).collect();
        let node = |i: usize| Node::new(&places[..=i], spacing * places[i].sin() / (spacing * i as f64).sin());
        let across: Vec<_> =
            gauss_legendre(2 * rule.across).into_iter().map(|(t, w)| (0.5 * (1.0 + t), 0.5 * w)).collect();
        let lots = across.chunks(LANES).map(|lot| {
            // Once more the last strip, which needs nothing of its own.
            let lane = |k: usize| lot.get(k).copied().unwrap_or((lot[lot.len() - 1].0, 0.0));
            [std::array::from_fn(|k| lane(k).0), std::array::from_fn(|k| lane(k).1)]
        });
        let lots = lots.collect();
        let (mut nodes, previous): (Vec<_>, Vec<_>) = (1..rule.cells).map(node).unzip();
        let of = |i: usize, back: usize| previous.get(i).map_or(0.0, |a: &[f64; 3]| a[back]);
        for (i, node) in nodes.iter_mut().enumerate() {
            node.next = [0, 1, 2].map(|back| of(i + back + 1, back));
        }
        // Before the first node all is as at the leading edge.
        let entering = [0, 1, 2].map(|i| (i..3).map(|back| of(i, back)).sum());
        Ok(Self { rule, across, lots, nodes, entering, level: Level::new() })
    }

    /// The rule that it was made from.
    pub fn rule(&self) -> FastsimRule {
        self.rule
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_differences_are_exact_for_what_they_are_fitted_to() {
        let grid = Fastsim::new(FastsimRule { across: 1, cells: 9 }).unwrap();
        let angles: Vec<f64> = std::iter::once(0.0).chain(grid.nodes.iter().map(|n| n.sin.atan2(n.cos))).collect();
        let values: [fn(f64) -> f64; 4] = [|_| 1.0, f64::sin, |x| -x.cos(), |x| x];
        let slopes: [fn(f64) -> f64; 4] = [|_| 0.0, f64::cos, f64::sin, |_| 1.0];
        for (i, node) in grid.nodes.iter().enumerate().skip(1) {
            for (value, slope) in values.iter().zip(slopes).take(if i == 1 { 3 } else { 4 }) {
                let mut carried = 0.0;
                for back in 0..3 {
                    carried += match i.checked_sub(back + 1) {
                        Some(last) => grid.nodes[last].next[back] * value(angles[last + 1]),
                        None => 0.0,
                    };
                }
                // What the leading edge has in the second and third difference, where it is not zero.
                let edge = grid.entering.get(i).copied().unwrap_or_default();
                let ours = (value(angles[i + 1]) - carried - edge * value(angles[0])) * node.over_reach;
                assert!((ours - slope(angles[i + 1])).abs() < 1e-12, "{i}: {ours}");
            }
        }
        let length: f64 = grid.nodes.iter().map(|n| n.weight * n.sin).sum();
        assert!((length - 0.5 * PI).abs() < 1e-4, "{length}");
    }
}
