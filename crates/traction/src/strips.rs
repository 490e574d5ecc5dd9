//! Strips across the contact patch: cut where the longitudinal slip vanishes, their nodes drawn to the pole of the
//! slip.

use crate::{Scalar, SlipField};
use std::f64::consts::PI;

/// A panel of strips between two cuts, its nodes graded quadratically towards both ends.
pub(crate) struct Panel<D> {
    pub(crate) start: D,
    pub(crate) end: D,
}

impl<D: Scalar> Panel<D> {
    /// Y and dY/dτ at τ in [0, 1].
    pub(crate) fn at(&self, t: f64) -> (D, D) {
        let length = self.end - self.start;
        (self.start + length * (t * t * (3.0 - 2.0 * t)), length * (6.0 * t * (1.0 - t)))
    }
}

/// Cuts the patch where the longitudinal slip γ − β Y − α Y² vanishes; where it vanishes nowhere, at its smallest
/// magnitude.
///
/// Every end is graded alike and a panel without length drops out, so the sum does not jump when a zero enters the
/// patch at its edge or two zeros meet: a solver needs that more than the last digit of the rule. Grading that fades
/// with the distance of the zero from the end was tried and is not worth its code (docs/patch-rules.md).
pub(crate) fn panels<D: Scalar>(longitudinal: [D; 3]) -> impl Iterator<Item = Panel<D>> {
    let inside = |y: &D| y.re() > -1.0 && y.re() < 1.0;
    let [first, second] = cuts(longitudinal).map(|cut| cut.filter(inside));
    let (low, high) = (-D::one(), D::one());
    let ends = [Some(low), first, second, Some(high)];
    let mut start = low;
    ends.into_iter().flatten().skip(1).filter_map(move |end| {
        let panel = Panel { start, end };
        start = end;
        ((panel.end - panel.start).re() > 0.0).then_some(panel)
    })
}

/// Real roots of γ − β Y − α Y², the lower first, without cancellation; where there are none, the vertex, at which the
/// magnitude is smallest.
fn cuts<D: Scalar>([gamma, beta, alpha]: [D; 3]) -> [Option<D>; 2] {
    let size = gamma.re().abs().max(beta.re().abs());
    if alpha.re().abs() <= 1e-14 * size {
        return [(beta.re() != 0.0).then(|| gamma / beta), None];
    }
    let discriminant = beta * beta + alpha * gamma * 4.0;
    if discriminant.re() <= 0.0 {
        return [Some(-beta / (alpha * 2.0)), None];
    }
    let root = discriminant.sqrt();
    let q = if beta.re() >= 0.0 { (beta + root) * -0.5 } else { (beta - root) * -0.5 };
    // Roots of α Y² + β Y − γ: q/α and −γ/q.
    let (first, second) = (q / alpha, -gamma / q);
    if first.re() < second.re() { [Some(first), Some(second)] } else { [Some(second), Some(first)] }
}

/// A node of the Chebyshev rule of the second kind, ∫ g √(1−t²) dt over [−1, 1], at t ≥ 0; it stands for −t too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AlongNode {
    pub(crate) t: f64,
    /// The rule's weight.
    pub(crate) weight: f64,
    /// The weight over √(1−t²).
    pub(crate) edge_weight: f64,
}

impl AlongNode {
    /// The nodes of the rule with `count` points.
    pub(crate) fn rule(count: usize) -> Vec<Self> {
        let spacing = PI / (count as f64 + 1.0);
        (1..=count.div_ceil(2))
            .map(|j| {
                let (sin, cos) = (spacing * j as f64).sin_cos();
                let t = if 2 * j == count + 1 { 0.0 } else { cos };
                Self { t, weight: spacing * sin * sin, edge_weight: spacing * sin }
            })
            .collect()
    }

    /// Number of points it stands for.
    pub(crate) fn multiplicity(&self) -> usize {
        if self.t > 0.0 { 2 } else { 1 }
    }
}

/// Smallest width of the concentration, in semi-axes along rolling. Without it the few nodes of a strip next to a cut
/// would crowd within a distance at which the curve κ(s) has long made the integrand smooth. Between 0.05 and 0.1 the
/// errors hardly change; at a slip scale of 22 per m/s 0.2 loses a factor of 3 to 6 with 10 and more nodes across.
pub(crate) const SMALLEST_WIDTH: f64 = 0.07;

/// Square of q/|Δv| below which a strip keeps Chebyshev's nodes: the map differs from the identity by as little.
pub(crate) const SPINLESS: f64 = 1e-6;

/// Calls `point(ξ, w)` for the nodes of the strip at `y`, with ∫ g √(1−ξ²) dξ ≈ Σ w g.
///
/// On a strip Δv_y = v_0 + q ξ varies and Δv_x does not, so |Δv| has its branch points at ξ_0 ± i |Δv_x/q|, ξ_0 =
/// −v_0/q: close to the strip wherever it passes the pole about which the patch spins. The map ξ = ξ_0 + ε sinh(A t +
/// B), ξ(±1) = ±1, moves them away (Tee and Trefethen, SIAM J. Sci. Comput. 28 (2006) 1798, doi:10.1137/050641296); for
/// large ε it is the identity. √((1−ξ²)/(1−t²)) is smooth, so the rule for the weight √(1−t²) still holds.
pub(crate) fn along_strip<D: Scalar>(
    nodes: &[AlongNode],
    slip: &SlipField<D>,
    y: D,
    chord: D,
    mut point: impl FnMut(D, D),
) {
    let Some(map) = Concentration::new(slip, y, chord) else {
        for node in nodes {
            point(D::from(node.t), D::from(node.weight));
            if node.t > 0.0 {
                point(D::from(-node.t), D::from(node.weight));
            }
        }
        return;
    };
    for node in nodes {
        let stretch = (map.half_span * node.t).exp();
        let (xi, w) = map.at(stretch * map.shift);
        point(xi, w * node.edge_weight);
        if node.t > 0.0 {
            let (xi, w) = map.at(map.shift / stretch);
            point(xi, w * node.edge_weight);
        }
    }
}

/// ξ = ξ_c + ε sinh(A t + B).
struct Concentration<D> {
    centre: D,
    width: D,
    /// A.
    half_span: D,
    /// exp(B).
    shift: D,
}

impl<D: Scalar> Concentration<D> {
    fn new(slip: &SlipField<D>, y: D, chord: D) -> Option<Self> {
        let ([gamma, beta, alpha], [delta, sigma, epsilon]) = (slip.longitudinal, slip.lateral);
        let along = gamma - y * (beta + alpha * y);
        let (offset, q) = (delta + epsilon * y * y, sigma * chord);
        let (along2, offset2, q2) = (along * along, offset * offset, q * q);
        if q2.re() <= SPINLESS * (along2 + offset2).re() || q2.re() < 1e-60 {
            return None;
        }
        // The pole drawn into the strip without a kink; by how much widens the concentration.
        let size = (q2 * q2 + offset2 * offset2).sqrt().sqrt();
        let centre = if q.re() > 0.0 { -offset / size } else { offset / size };
        let outside = -offset / q - centre;
        let narrowest = chord.recip() * SMALLEST_WIDTH;
        let width = (along2 / q2 + outside * outside + narrowest * narrowest).sqrt();
        // exp(asinh) of the distances to both ends.
        let [up, down] = [-centre + 1.0, centre + 1.0].map(|distance| {
            let ratio = distance / width;
            ratio + (ratio * ratio + 1.0).sqrt()
        });
        Some(Self { centre, width, half_span: (up * down).ln() * 0.5, shift: (up / down).sqrt() })
    }

    /// ξ and √(1−ξ²) dξ/dt from exp(A t + B).
    fn at(&self, exponential: D) -> (D, D) {
        let inverse = exponential.recip();
        let xi = self.centre + self.width * (exponential - inverse) * 0.5;
        let squared = (-xi + 1.0) * (xi + 1.0);
        let edge = if squared.re() > 0.0 { squared.sqrt() } else { D::zero() };
        (xi, edge * self.half_span * self.width * (exponential + inverse) * 0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_cuts_lie_on_the_zeros() {
        for slip in [[0.1f64, 1.0, 0.3], [-0.05, 0.2, -1.0], [0.5, -0.1, 1.0], [0.02, 1e-9, 0.9]] {
            let [gamma, beta, alpha] = slip;
            for root in cuts::<f64>(slip).into_iter().flatten() {
                assert!((gamma - beta * root - alpha * root * root).abs() < 1e-15 * (1.0 + root.abs()).powi(2));
            }
        }
    }

    #[test]
    fn identity_concentration_ends_at_the_edge_and_fades_without_spin() {
        let map = |spin: f64| {
            let slip = SlipField { longitudinal: [0.02, 0.3, 0.1], lateral: [0.1, spin, 0.0] };
            Concentration::new(&slip, 0.1, 0.9)
        };
        for spin in [-2.0, -0.3, -0.05, 0.05, 0.3, 2.0] {
            let map = map(spin).unwrap();
            for sign in [-1.0, 1.0] {
                let (xi, _) = map.at((sign * map.half_span).exp() * map.shift);
                assert!((xi - sign).abs() < 1e-13, "{spin}: {xi}");
            }
        }
        // Just above the threshold the map is the identity but for the square of the ratio.
        let faint = map(1.2e-4).unwrap();
        let (xi, _) = faint.at((0.5 * faint.half_span).exp() * faint.shift);
        assert!((xi - 0.5).abs() < 1e-3, "{xi}");
        assert!(map(1e-5).is_none() && map(0.0).is_none());
    }

    #[test]
    fn identity_chebyshev_nodes_are_exact_for_polynomials() {
        // ∫ t² √(1−t²) dt = π/8.
        for count in [2usize, 3, 8, 9] {
            let rule = AlongNode::rule(count);
            assert_eq!(rule.iter().map(AlongNode::multiplicity).sum::<usize>(), count);
            let sum: f64 = rule.iter().map(|n| n.multiplicity() as f64 * n.weight * n.t * n.t).sum();
            assert!((sum - PI / 8.0).abs() < 1e-15, "{count}: {sum}");
        }
    }
}
