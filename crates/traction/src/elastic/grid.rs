//! Strips and cells of the patch.

use crate::TractionError;
use crate::quadrature::gauss_legendre;
use fearless_simd::Level;
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

/// The strips and cells of a [`FastsimRule`], worked out.
///
/// A strip has half length ℓ and its cells stand at x = −ℓ cos θ from the leading edge, θ = iπ/N. There both solutions
/// of a strip are trigonometric polynomials: 1 − cos θ where it sticks under constant slip, sin θ where it slides under
/// a Hertz pressure. The two-step backward difference of θ is fitted to them,
/// ```text
/// q'(θ_i) = (q_i − A q_(i−1) + B q_(i−2))/k,   A = (2 + 2 cos h)/(1 + 2 cos h),   B = 1/(1 + 2 cos h),
/// k = 2 sin h/(1 + 2 cos h),                    h = π/N
/// ```
/// and becomes the usual one of second order as h → 0. The first cell, without a second predecessor, takes A = B = 0
/// and k = tan(h/2), exact for 1 − cos θ.
#[derive(Debug, Clone)]
pub struct Fastsim {
    pub(super) rule: FastsimRule,
    /// (τ, w) on [0, 1] across the patch.
    pub(super) across: Vec<(f64, f64)>,
    pub(super) nodes: Vec<Node>,
    /// h.
    pub(super) spacing: f64,
    pub(super) level: Level,
}

/// One place along every strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    /// cos θ and sin θ.
    pub(super) cos: f64,
    pub(super) sin: f64,
    /// A and B.
    pub(super) previous: [f64; 2],
    /// A and B for what is not zero at the leading edge: 1 and 0 in the first cell.
    pub(super) remembered: [f64; 2],
    /// k.
    pub(super) reach: f64,
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
        let (sine, cosine) = spacing.sin_cos();
        let base = 1.0 + 2.0 * cosine;
        let node = |i: usize| {
            let (sin, cos) = (spacing * i as f64).sin_cos();
            if i == 1 || rule.cells == 2 {
                Node { cos, sin, previous: [0.0; 2], remembered: [1.0, 0.0], reach: (0.5 * spacing).tan() }
            } else {
                let previous = [(2.0 + 2.0 * cosine) / base, base.recip()];
                Node { cos, sin, previous, remembered: previous, reach: 2.0 * sine / base }
            }
        };
        let across = gauss_legendre(2 * rule.across).into_iter().map(|(t, w)| (0.5 * (1.0 + t), 0.5 * w)).collect();
        Ok(Self { rule, across, nodes: (1..rule.cells).map(node).collect(), spacing, level: Level::new() })
    }

    /// The rule that it was made from.
    pub fn rule(&self) -> FastsimRule {
        self.rule
    }
}
