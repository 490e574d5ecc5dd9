//! Stresses below the middle of an elliptic contact without friction.
//!
//! A half-space that carries Hertz's pressure p₀ √(1 − x²/a² − y²/b²) has, on the axis below the middle at a depth z,
//! the principal stresses σ_x, σ_y, σ_z along the axes of the ellipse. With the potentials of the pressure (K. L.
//! Johnson, Contact Mechanics, 1985, chapter 3.3) they are integrals over t from z to infinity,
//!
//! σ_x/p₀ = a b ∫ [ −2ν z/t² + (z − (1 − 2ν)(t − z))/(a² + t²) ] dt/√((a² + t²)(b² + t²)),
//!
//! σ_y with a and b changed over, and σ_z = −p₀/√((1 + z²/a²)(1 + z²/b²)). Compression is negative.

use crate::Ellipse;

/// Where the material below a contact is stressed most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Subsurface {
    /// Largest shear stress below the middle of the contact, half the difference of the principal stresses, Pa.
    pub max_shear: f64,
    /// Its depth, m.
    pub max_shear_depth: f64,
    /// Von Mises stress at that depth, Pa.
    pub von_mises: f64,
}

/// Nodes and weights of Gauss and Legendre, five points.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
/// Panels of the integrals, even in ln t.
const PANELS: usize = 80;
/// Upper end of the integrals over the semi-major axis: what is left out falls with its square.
const FAR: f64 = 1e6;
/// Depths over the semi-minor axis between which the largest shear stress lies: at 0.48 below a circle, at 0.79 below a
/// line.
const DEPTHS: [f64; 2] = [0.2, 1.2];
/// Part of the interval that golden-section search keeps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Ellipse<f64> {
    /// The largest shear stress below the middle, for a body of this Poisson's ratio; none without load.
    pub fn subsurface(&self, poisson: f64) -> Option<Subsurface> {
        let (a, b, pressure) = (self.semi_major, self.semi_minor, self.peak_pressure);
        if !(b > 0.0 && a.is_finite() && pressure > 0.0 && pressure.is_finite()) {
            return None;
        }
        let ratio = a / b;
        let shear = |depth: f64| {
            let s = stresses(ratio, depth, poisson);
            0.5 * (s.iter().fold(f64::MIN, |m, v| m.max(*v)) - s.iter().fold(f64::MAX, |m, v| m.min(*v)))
        };
        let [mut low, mut high] = DEPTHS;
        for _ in 0..60 {
            let width = GOLDEN * (high - low);
            if shear(high - width) > shear(low + width) {
                high = low + width;
            } else {
                low = high - width;
            }
        }
        let depth = 0.5 * (low + high);
        let [x, y, z] = stresses(ratio, depth, poisson);
        let von_mises = (0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2))).sqrt();
        Some(Subsurface {
            max_shear: shear(depth) * pressure,
            max_shear_depth: depth * b,
            von_mises: von_mises * pressure,
        })
    }
}

/// Stresses over p₀ along the major axis, the minor axis and the depth, with b = 1 and a the ratio of the axes.
fn stresses(ratio: f64, depth: f64, poisson: f64) -> [f64; 3] {
    let (from, to) = (depth.ln(), (FAR * ratio).ln());
    let half = 0.5 * (to - from) / PANELS as f64;
    let (major, minor) = (ratio * ratio, 1.0);
    let mut sum = [0.0; 2];
    for panel in 0..PANELS {
        for (node, weight) in GAUSS {
            let u = from + half * ((2 * panel) as f64 + 1.0 + node);
            let t = u.exp();
            let root = ((major + t * t) * (minor + t * t)).sqrt();
            let element = weight * half * t / root;
            let squeezed = -2.0 * poisson * depth / (t * t);
            let spread = depth - (1.0 - 2.0 * poisson) * (t - depth);
            sum[0] += element * (squeezed + spread / (major + t * t));
            sum[1] += element * (squeezed + spread / (minor + t * t));
        }
    }
    let normal = -1.0 / ((1.0 + depth * depth / major) * (1.0 + depth * depth)).sqrt();
    [ratio * sum[0], ratio * sum[1], normal]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MajorAxis;

    fn close(found: f64, expected: f64, relative: f64) {
        assert!((found / expected - 1.0).abs() < relative, "{found} instead of {expected}");
    }

    fn below(ratio: f64, poisson: f64) -> Subsurface {
        let ellipse =
            Ellipse { semi_major: ratio, semi_minor: 1.0, peak_pressure: 1.0, major_axis: MajorAxis::Lateral };
        ellipse.subsurface(poisson).unwrap()
    }

    /// σ_r/p₀ = −(1 + ν)(1 − ζ arctan 1/ζ) + 1/(2(1 + ζ²)), σ_z/p₀ = −1/(1 + ζ²).
    #[test]
    fn limit_below_a_circle_the_stresses_are_the_closed_ones() {
        for poisson in [0.0, 0.25, 0.3, 0.5] {
            for depth in [0.05, 0.3, 0.48, 1.0, 3.0] {
                let expected =
                    -(1.0 + poisson) * (1.0 - depth * (1.0_f64 / depth).atan()) + 0.5 / (1.0 + depth * depth);
                let [x, y, z] = stresses(1.0, depth, poisson);
                assert!((x - expected).abs() < 1e-9 && (y - expected).abs() < 1e-9, "{x} {y} {expected}");
                close(z, -1.0 / (1.0 + depth * depth), 1e-14);
            }
        }
    }

    /// Below a line: σ_y/p₀ = −((1 + 2ζ²)/√(1 + ζ²) − 2ζ), σ_z/p₀ = −1/√(1 + ζ²), σ_x = ν(σ_y + σ_z).
    #[test]
    fn limit_below_a_long_ellipse_the_stresses_are_those_of_a_line() {
        for depth in [0.2, 0.786, 2.0] {
            let root = (1.0_f64 + depth * depth).sqrt();
            let across = -((1.0 + 2.0 * depth * depth) / root - 2.0 * depth);
            let [x, y, z] = stresses(1e7, depth, 0.3);
            assert!((y - across).abs() < 1e-6 && (z + 1.0 / root).abs() < 1e-6, "{y} {z}");
            assert!((x - 0.3 * (across - 1.0 / root)).abs() < 1e-6, "{x}");
        }
        let line = below(1e7, 0.3);
        close(line.max_shear, 0.3003, 1e-3);
        close(line.max_shear_depth, 0.7862, 1e-3);
    }

    /// K. L. Johnson, Contact Mechanics, 1985, table 4.1: largest shear stress over p₀ and its depth over b for axis
    /// ratios b/a, ν = 0.3; depths are printed to half a hundredth.
    #[test]
    fn paper_largest_shear_stress_of_elliptic_contacts() {
        for (axis_ratio, depth, shear) in
            [(0.2, 0.745, 0.322), (0.4, 0.665, 0.325), (0.6, 0.590, 0.323), (0.8, 0.530, 0.317), (1.0, 0.480, 0.310)]
        {
            let found = below(1.0 / axis_ratio, 0.3);
            assert!((found.max_shear - shear).abs() < 1e-3, "{axis_ratio}: {found:?}");
            assert!((found.max_shear_depth - depth).abs() < 7e-3, "{axis_ratio}: {found:?}");
        }
        // Below a circle von Mises' stress is twice the shear stress, as two of the three stresses are equal.
        let circle = below(1.0, 0.3);
        close(circle.von_mises, 2.0 * circle.max_shear, 1e-9);
    }

    #[test]
    fn identity_stresses_go_with_pressure_and_size() {
        let one = below(3.0, 0.3);
        let large = Ellipse { semi_major: 6e-3, semi_minor: 2e-3, peak_pressure: 2e9, major_axis: MajorAxis::Rolling };
        let large = large.subsurface(0.3).unwrap();
        close(large.max_shear, 2e9 * one.max_shear, 1e-12);
        close(large.max_shear_depth, 2e-3 * one.max_shear_depth, 1e-9);
        let none = Ellipse { semi_major: 0.0, semi_minor: 0.0, peak_pressure: 0.0, major_axis: MajorAxis::Rolling };
        assert_eq!(none.subsurface(0.3), None);
    }
}
