//! One-dimensional Gauss rules and the patch rules built from them.

use crate::strips::{AlongNode, along_strip, panels};
use crate::{PatchRule, Scalar, SlipField, TractionError};
use std::f64::consts::PI;

/// Nodes and weights of the `count`-point Gauss–Legendre rule on [−1, 1], by Newton on the Legendre polynomial.
pub(crate) fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    (0..count)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..50 {
                let (mut below, mut value) = (1.0, x);
                for k in 2..=count {
                    let k = k as f64;
                    (below, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * below) / k);
                }
                slope = n * (x * value - below) / (x * x - 1.0);
                let step = value / slope;
                x -= step;
                if step.abs() < 1e-16 {
                    break;
                }
            }
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// A patch rule with its nodes worked out, ready for use in a solver's loop.
///
/// In the unit disc X = x/b (rolling), Y = y/a (across the groove) a rule stands for
/// ∬ g(X, Y) √(1 − X² − Y²) dX dY ≈ Σ w g(X, Y).
#[derive(Debug, Clone, PartialEq)]
pub struct Quadrature {
    rule: PatchRule,
    nodes: Nodes,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Nodes {
    /// (X, Y, w), the same for every contact.
    Fixed(Vec<[f64; 3]>),
    /// (τ, w) on [0, 1] across the groove, and the nodes along rolling.
    Strips { across: Vec<(f64, f64)>, along: Vec<AlongNode> },
}

impl Quadrature {
    /// Works out the nodes of a rule.
    ///
    /// # Errors
    /// [`TractionError::NoPoints`] for a count of zero.
    pub fn new(rule: PatchRule) -> Result<Self, TractionError> {
        let nodes = match rule {
            PatchRule::PolarMidpoint { radial, circumferential } => polar_midpoint(radial, circumferential),
            PatchRule::GaussJacobi { radial, angles } => gauss_jacobi(radial, angles),
            PatchRule::SplitStrip { across, along } => Nodes::Strips {
                across: gauss_legendre(across).into_iter().map(|(t, w)| (0.5 * (1.0 + t), 0.5 * w)).collect(),
                along: AlongNode::rule(along),
            },
        };
        let empty = match &nodes {
            Nodes::Fixed(points) => points.is_empty(),
            Nodes::Strips { across, along } => across.is_empty() || along.is_empty(),
        };
        if empty { Err(TractionError::NoPoints) } else { Ok(Self { rule, nodes }) }
    }

    /// The rule that the nodes belong to.
    pub fn rule(&self) -> PatchRule {
        self.rule
    }

    pub(crate) fn nodes(&self) -> &Nodes {
        &self.nodes
    }

    /// Calls `point(X, Y, w)` for each node; `slip` places the strips of [`PatchRule::SplitStrip`].
    pub fn for_each<D: Scalar>(&self, slip: &SlipField<D>, mut point: impl FnMut(D, D, D)) {
        match &self.nodes {
            Nodes::Fixed(points) => {
                for &[x, y, w] in points {
                    point(D::from(x), D::from(y), D::from(w));
                }
            }
            Nodes::Strips { across, along } => {
                for panel in panels(slip.longitudinal) {
                    for &(t, weight) in across {
                        let (y, stretch) = panel.at(t);
                        let squared = (-y + 1.0) * (y + 1.0);
                        if squared.re() > 0.0 {
                            let chord = squared.sqrt();
                            let share = squared * stretch * weight;
                            along_strip(along, slip, y, chord, |xi, w| point(chord * xi, y, share * w));
                        }
                    }
                }
            }
        }
    }

    /// Number of points for a contact with this slip.
    pub fn point_count(&self, slip: &SlipField<f64>) -> usize {
        match &self.nodes {
            Nodes::Fixed(points) => points.len(),
            Nodes::Strips { across, along } => {
                let strips = panels(slip.longitudinal).count() * across.len();
                strips * along.iter().map(AlongNode::multiplicity).sum::<usize>()
            }
        }
    }
}

/// The paper's rule: R × N cells of equal height and angle, the integrand at each cell's middle.
fn polar_midpoint(radial: usize, circumferential: usize) -> Nodes {
    let (dr, da) = (1.0 / radial as f64, 2.0 * PI / circumferential as f64);
    let mut points = Vec::with_capacity(radial * circumferential);
    for i in 0..radial {
        let r = (i as f64 + 0.5) * dr;
        let w = (1.0 - r * r).sqrt() * r * dr * da;
        points.extend(angles(circumferential, 0.5).map(|(c, s)| [r * c, r * s, w]));
    }
    Nodes::Fixed(points)
}

/// Gauss–Jacobi in u = r² with weight √(1−u). With u = 1 − z² it is the half z > 0 of a Gauss–Legendre rule with
/// 2 `radial` + 1 points and weight z², whose middle point drops out.
///
/// Every other ring is turned by half an angle: the error of too few angles changes its sign from ring to ring and
/// mostly cancels (3 × 8 points on the contacts of the tests at 1 per m/s: 1.6e-4 instead of 1.7e-3 unturned).
fn gauss_jacobi(radial: usize, count: usize) -> Nodes {
    let da = 2.0 * PI / count as f64;
    let mut points = Vec::with_capacity(radial * count);
    for (ring, (z, weight)) in gauss_legendre(2 * radial + 1).into_iter().take(radial).enumerate() {
        let r = ((1.0 - z) * (1.0 + z)).sqrt();
        let offset = if ring % 2 == 0 { 0.5 } else { 0.0 };
        points.extend(angles(count, offset).map(|(c, s)| [r * c, r * s, weight * z * z * da]));
    }
    Nodes::Fixed(points)
}

/// Cosine and sine of `count` equispaced angles, the first at `offset` spacings.
fn angles(count: usize, offset: f64) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(move |j| {
        let (sin, cos) = (2.0 * PI * (j as f64 + offset) / count as f64).sin_cos();
        (cos, sin)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without slip along y the strips keep Chebyshev's nodes, which are exact for polynomials.
    fn integral(rule: PatchRule, longitudinal: [f64; 3], g: impl Fn(f64, f64) -> f64) -> f64 {
        with_lateral_slip(rule, longitudinal, [0.0; 3], g)
    }

    fn with_lateral_slip(
        rule: PatchRule,
        longitudinal: [f64; 3],
        lateral: [f64; 3],
        g: impl Fn(f64, f64) -> f64,
    ) -> f64 {
        let mut sum = 0.0;
        Quadrature::new(rule).unwrap().for_each(&SlipField { longitudinal, lateral }, |x, y, w| sum += w * g(x, y));
        sum
    }

    #[test]
    fn identity_gauss_legendre_is_exact_for_polynomials() {
        for n in [1usize, 2, 3, 5, 10, 40] {
            let rule = gauss_legendre(n);
            for power in 0..2 * n {
                let exact = if power % 2 == 0 { 2.0 / (power as f64 + 1.0) } else { 0.0 };
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(power as i32)).sum();
                assert!((sum - exact).abs() < 1e-14, "{n} points, power {power}: {sum}");
            }
        }
    }

    #[test]
    fn limit_moments_of_the_hertz_pressure() {
        // ∬ √(1−r²) = 2π/3, ∬ Y² √(1−r²) = 2π/15, ∬ X²Y² √(1−r²) = 2π/105.
        type Moment = (fn(f64, f64) -> f64, f64);
        let cases: [Moment; 3] =
            [(|_, _| 1.0, 2.0 / 3.0), (|_, y| y * y, 2.0 / 15.0), (|x, y| x * x * y * y, 2.0 / 105.0)];
        for slip in [[1.0, 0.0, 0.0], [0.1, 1.0, 0.0], [0.1, 0.2, 1.0], [-0.3, 0.1, 1.0], [0.0, 0.0, 0.0]] {
            for (g, share) in cases {
                let exact = share * PI;
                for rule in
                    [PatchRule::GaussJacobi { radial: 4, angles: 8 }, PatchRule::SplitStrip { across: 12, along: 4 }]
                {
                    let sum = integral(rule, slip, g);
                    assert!((sum - exact).abs() < 1e-13, "{rule:?} {slip:?}: {sum} {exact}");
                }
            }
        }
    }

    #[test]
    fn limit_midpoint_rule_is_of_order_three_halves_at_the_edge() {
        let error = |n| {
            (integral(PatchRule::PolarMidpoint { radial: n, circumferential: 8 }, [0.0; 3], |_, _| 1.0)
                - 2.0 * PI / 3.0)
                .abs()
        };
        let order = (error(20) / error(80)).log2() / 2.0;
        assert!((order - 1.5).abs() < 0.1, "order {order}");
    }

    #[test]
    fn limit_moments_with_concentrated_nodes_converge() {
        // The pole inside the strip, at its edge, outside, and at the centre; spin from strong to almost none.
        for lateral in [[0.1, 0.3, 0.0], [0.3, 0.3, 0.0], [-0.9, 0.2, 0.1], [0.0, 2.0, 0.0], [1.0, 2e-3, 0.0]] {
            let moment = |along| {
                let rule = PatchRule::SplitStrip { across: 16, along };
                with_lateral_slip(rule, [0.1, 1.0, 0.3], lateral, |x, y| 1.0 + x + x * x * y * y)
            };
            let exact = PI * (2.0 / 3.0 + 2.0 / 105.0);
            let [coarse, fine] = [3, 31].map(|along| (moment(along) - exact).abs() / exact);
            assert!(coarse < 3e-2 && fine < 1e-10, "{lateral:?}: {coarse:e} {fine:e}");
        }
    }

    #[test]
    fn identity_sum_does_not_jump_where_zeros_come_and_go() {
        let g = |slip: [f64; 3], lateral: [f64; 3]| {
            let rule = PatchRule::SplitStrip { across: 5, along: 3 };
            with_lateral_slip(rule, slip, lateral, |x, y| {
                let [u, v] = SlipField { longitudinal: slip, lateral }.at(x, y);
                u / u.hypot(v).max(1e-300)
            })
        };
        // A zero leaves at the edge; two zeros meet inside the patch. Without slip along y, with it, and with a strip
        // that leaves the concentrated nodes.
        for lateral in [[0.0; 3], [0.2, 0.4, 0.1], [0.4, 1e-9, 0.0]] {
            for (base, direction) in
                [([1.0, 1.0, 0.0], 0), ([0.75, 0.25, 0.5], 0), ([-0.125, 0.5, -0.5], 0), ([0.125, 0.5, -0.5], 0)]
            {
                let at = |step: f64| {
                    let mut slip = base;
                    slip[direction] += step;
                    g(slip, lateral)
                };
                assert!((at(1e-12) - at(-1e-12)).abs() < 1e-5, "{base:?}: {} {}", at(-1e-12), at(1e-12));
            }
        }
    }

    #[test]
    fn limit_no_points_and_unchosen_rules_are_refused() {
        assert_eq!(Quadrature::new(PatchRule::GaussJacobi { radial: 0, angles: 4 }), Err(TractionError::NoPoints));
    }
}
