//! Collocation at Radau's points: a polynomial on each interval that meets the equations there, stiffly accurate and
//! L-stable (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section IV.5).

/// Radau's three right points, the derivatives there of the polynomial through them and the beginning, and the weights
/// of their quadrature: fifth order at the ends of intervals.
#[derive(Debug, Clone, Copy)]
pub struct Radau {
    /// Places of the points in the interval, from 0 to 1; the last is its end.
    pub points: [f64; Self::STAGES],
    /// `slope[i][k]`: derivative at point i over the value at point k less that at the beginning.
    pub slope: [[f64; Self::STAGES]; Self::STAGES],
    /// Weights of the points in an integral over the interval.
    pub weights: [f64; Self::STAGES],
}

impl Radau {
    /// Points of an interval; its degree.
    pub const STAGES: usize = 3;

    /// The points with what follows from them.
    #[allow(clippy::new_without_default)] // a rule has no settings
    pub fn new() -> Self {
        let root = 6f64.sqrt();
        let points = [(4.0 - root) / 10.0, (4.0 + root) / 10.0, 1.0];
        let slope = std::array::from_fn(|i| std::array::from_fn(|k| lagrange_slope(&points, k, points[i])));
        Self { points, slope, weights: [(16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0] }
    }

    /// Shares of the beginning and of the points in the polynomial's value at `x` of the interval.
    pub fn shares(&self, x: f64) -> [f64; Self::STAGES + 1] {
        let node = |k: usize| if k == 0 { 0.0 } else { self.points[k - 1] };
        let others = |k: usize| (0..=Self::STAGES).filter(move |&j| j != k);
        std::array::from_fn(|k| others(k).map(|j| (x - node(j)) / (node(k) - node(j))).product())
    }
}

/// Derivative at `x` of the polynomial that is one at point k and zero at the others and at the beginning.
fn lagrange_slope(points: &[f64; Radau::STAGES], k: usize, x: f64) -> f64 {
    let nodes: [f64; Radau::STAGES + 1] = std::array::from_fn(|k| if k == 0 { 0.0 } else { points[k - 1] });
    let others = |skip: usize| (0..=Radau::STAGES).filter(move |&j| j != k + 1 && j != skip);
    let scale: f64 = others(usize::MAX).map(|j| nodes[k + 1] - nodes[j]).product();
    let sum: f64 = others(usize::MAX).map(|left| others(left).map(|j| x - nodes[j]).product::<f64>()).sum();
    sum / scale
}
