//! Kalker's creep coefficients of the linear theory of rolling contact.

use crate::{Scalar, TractionError};

/// Ratios of the shorter to the longer semi-axis of [`ALONG_SHORTER`] and [`ALONG_LONGER`].
const RATIOS: [f64; 10] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
/// Poisson's ratios of the columns of each coefficient.
const POISSON: [f64; 3] = [0.0, 0.25, 0.5];

/// C11, C22 and C23, each at the three Poisson's ratios.
type Row = [[f64; 3]; 3];

/// Rolling along the shorter semi-axis: Kalker 1990, table E.3, rows a/b = g.
#[allow(clippy::approx_constant, reason = "3.14 is a coefficient of the table")]
const ALONG_SHORTER: [Row; 10] = [
    [[2.51, 3.31, 4.85], [2.51, 2.52, 2.53], [0.334, 0.473, 0.731]],
    [[2.59, 3.37, 4.81], [2.59, 2.63, 2.66], [0.483, 0.603, 0.809]],
    [[2.68, 3.44, 4.8], [2.68, 2.75, 2.81], [0.607, 0.715, 0.889]],
    [[2.78, 3.53, 4.82], [2.78, 2.88, 2.98], [0.72, 0.823, 0.977]],
    [[2.88, 3.62, 4.83], [2.88, 3.01, 3.14], [0.827, 0.929, 1.07]],
    [[2.98, 3.72, 4.91], [2.98, 3.14, 3.31], [0.93, 1.03, 1.18]],
    [[3.09, 3.81, 4.97], [3.09, 3.28, 3.48], [1.03, 1.14, 1.29]],
    [[3.19, 3.91, 5.05], [3.19, 3.41, 3.65], [1.13, 1.25, 1.4]],
    [[3.29, 4.01, 5.12], [3.29, 3.54, 3.82], [1.23, 1.36, 1.51]],
    [[3.4, 4.12, 5.2], [3.4, 3.67, 3.98], [1.33, 1.47, 1.63]],
];

/// Rolling along the longer semi-axis: Kalker 1990, table E.3, rows b/a = g.
const ALONG_LONGER: [Row; 10] = [
    [[10.7, 11.7, 12.9], [10.7, 12.8, 16.0], [12.2, 14.6, 18.0]],
    [[6.96, 7.78, 8.82], [6.96, 8.14, 9.79], [5.72, 6.63, 7.89]],
    [[5.57, 6.34, 7.34], [5.57, 6.4, 7.51], [3.79, 4.32, 5.01]],
    [[4.84, 5.57, 6.57], [4.84, 5.48, 6.31], [2.88, 3.24, 3.7]],
    [[4.37, 5.1, 6.11], [4.37, 4.9, 5.56], [2.35, 2.62, 2.96]],
    [[4.06, 4.78, 5.8], [4.06, 4.5, 5.04], [2.01, 2.23, 2.5]],
    [[3.82, 4.54, 5.58], [3.82, 4.21, 4.67], [1.76, 1.95, 2.18]],
    [[3.65, 4.36, 5.42], [3.65, 3.99, 4.39], [1.58, 1.75, 1.94]],
    [[3.51, 4.22, 5.3], [3.51, 3.81, 4.16], [1.44, 1.59, 1.77]],
    [[3.4, 4.12, 5.2], [3.4, 3.67, 3.98], [1.33, 1.47, 1.63]],
];

/// Points of the splines: both tables, with the circle once.
const NODES: usize = 2 * RATIOS.len() - 1;

/// Creep coefficients of one ellipse.
///
/// With c² the product of the semi-axes, G the shear modulus and creepages of the rigid surfaces:
/// F_x = −G c² C11 ξ_x, F_y = −G c² C22 ξ_y − G c³ C23 φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepCoefficients<D = f64> {
    /// C11, longitudinal.
    pub longitudinal: D,
    /// C22, lateral.
    pub lateral: D,
    /// C23, lateral force by spin.
    pub spin: D,
}

/// The coefficients over the axis ratio at one Poisson's ratio, smooth (twice differentiable).
///
/// Parabolas through the table's three Poisson's ratios; then natural cubic splines of ln C over the logarithm of the
/// axis ratio, straight beyond the ratios of 0.1 and 10 at which the table ends. At 0.05 C11 and C22 are within 2 % of
/// the line contact's π²/(4 (1 − ν)) and π²/4 (tested).
///
/// Source: J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990,
/// doi:10.1007/978-94-015-7889-9, table E.3 (`fixtures/reference/kalker1990`).
#[derive(Debug, Clone, PartialEq)]
pub struct KalkerCoefficients {
    /// Logarithm of semi-axis along rolling over semi-axis across.
    abscissas: [f64; NODES],
    splines: [Spline; 3],
}

/// Values and second derivatives at the nodes.
#[derive(Debug, Clone, PartialEq)]
struct Spline {
    values: [f64; NODES],
    bends: [f64; NODES],
}

impl KalkerCoefficients {
    /// The coefficients at Poisson's ratio `poisson_ratio`.
    ///
    /// # Errors
    /// [`TractionError::PoissonRatio`] outside 0 to 0.5.
    pub fn new(poisson_ratio: f64) -> Result<Self, TractionError> {
        if !(0.0..=0.5).contains(&poisson_ratio) {
            return Err(TractionError::PoissonRatio { value: poisson_ratio });
        }
        let longer = (0..RATIOS.len() - 1).rev();
        let rows = ALONG_SHORTER.iter().chain(longer.clone().map(|i| &ALONG_LONGER[i]));
        let ratios = RATIOS.into_iter().chain(longer.map(|i| RATIOS[i].recip()));
        let (mut abscissas, mut values) = ([0.0; NODES], [[0.0; NODES]; 3]);
        for (i, (ratio, row)) in ratios.zip(rows).enumerate() {
            abscissas[i] = ratio.ln();
            for (values, by_poisson) in values.iter_mut().zip(row) {
                values[i] = parabola(by_poisson, poisson_ratio).ln();
            }
        }
        let splines = values.map(|values| Spline { bends: natural_bends(&abscissas, &values), values });
        Ok(Self { abscissas, splines })
    }

    /// The coefficients of an ellipse with `axis_ratio` the semi-axis along rolling over the semi-axis across.
    pub fn at<D: Scalar>(&self, axis_ratio: D) -> CreepCoefficients<D> {
        let [longitudinal, lateral, spin] = self.logarithms(axis_ratio).map(|logarithm| logarithm.exp());
        CreepCoefficients { longitudinal, lateral, spin }
    }

    /// Logarithms of the coefficients.
    pub(super) fn logarithms<D: Scalar>(&self, axis_ratio: D) -> [D; 3] {
        let u = axis_ratio.ln();
        let inner = &self.abscissas[1..NODES - 1];
        let piece = inner.iter().take_while(|&&node| node < u.re()).count();
        self.splines.each_ref().map(|spline| spline.value(&self.abscissas, piece, u))
    }
}

/// Lagrange's parabola through the three Poisson's ratios.
fn parabola(values: &[f64; 3], at: f64) -> f64 {
    let [p, q, r] = POISSON;
    values[0] * (at - q) * (at - r) / ((p - q) * (p - r))
        + values[1] * (at - p) * (at - r) / ((q - p) * (q - r))
        + values[2] * (at - p) * (at - q) / ((r - p) * (r - q))
}

/// Second derivatives of the natural cubic spline, by elimination in its tridiagonal system.
fn natural_bends(x: &[f64; NODES], y: &[f64; NODES]) -> [f64; NODES] {
    let (mut upper, mut bends) = ([0.0; NODES], [0.0; NODES]);
    for i in 1..NODES - 1 {
        let (left, right) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        let load = 6.0 * ((y[i + 1] - y[i]) / right - (y[i] - y[i - 1]) / left);
        let pivot = 2.0 * (left + right) - left * upper[i - 1];
        upper[i] = right / pivot;
        bends[i] = (load - left * bends[i - 1]) / pivot;
    }
    for i in (1..NODES - 1).rev() {
        bends[i] -= upper[i] * bends[i + 1];
    }
    bends
}

impl Spline {
    /// The value in the piece that begins at a node.
    fn value<D: Scalar>(&self, x: &[f64; NODES], piece: usize, at: D) -> D {
        let (values, bends) = (&self.values, &self.bends);
        let (left, right) = (x[piece], x[piece + 1]);
        let width = right - left;
        let rise = (values[piece + 1] - values[piece]) / width;
        let (start, end) = (
            rise - width * (2.0 * bends[piece] + bends[piece + 1]) / 6.0,
            rise + width * (bends[piece] + 2.0 * bends[piece + 1]) / 6.0,
        );
        if at.re() < left {
            return (at - left) * start + values[piece];
        }
        if at.re() > right {
            return (at - right) * end + values[piece + 1];
        }
        let from_left = at - left;
        let cubic = (bends[piece + 1] - bends[piece]) / (6.0 * width);
        ((from_left * cubic + 0.5 * bends[piece]) * from_left + start) * from_left + values[piece]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_dual::Dual64;

    #[test]
    fn paper_kalker_1990_table_comes_back() {
        let table = include_str!("../../../../fixtures/reference/kalker1990/creep-coefficients.csv");
        let mut rows = 0;
        for line in table.lines().filter(|line| !line.starts_with('#')).skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |column: usize| cells[column].parse::<f64>().unwrap();
            let ratio = if cells[0] == "a/b" { number(1) } else { number(1).recip() };
            for (k, poisson) in POISSON.into_iter().enumerate() {
                let c = KalkerCoefficients::new(poisson).unwrap().at(ratio);
                for (ours, column) in [(c.longitudinal, 2), (c.lateral, 5), (c.spin, 8)] {
                    assert!((ours / number(column + k) - 1.0).abs() < 1e-13, "{line}: {ours}");
                }
            }
            rows += 1;
        }
        assert_eq!(rows, 20);
    }

    #[test]
    fn identity_coefficients_and_slopes_are_continuous() {
        let table = KalkerCoefficients::new(0.3).unwrap();
        let at = |ratio: f64| {
            let c = table.at(Dual64::from(ratio).derivative());
            [c.longitudinal, c.lateral, c.spin].map(|c| [c.re, c.eps * ratio])
        };
        for ratio in RATIOS.into_iter().flat_map(|g| [g, g.recip()]) {
            for (below, above) in at(ratio * (1.0 - 1e-10)).into_iter().zip(at(ratio * (1.0 + 1e-10))) {
                assert!((below[0] - above[0]).abs() < 1e-7 && (below[1] - above[1]).abs() < 1e-7, "{ratio}");
            }
        }
        let h = 1e-6;
        let difference = (at(0.137 * (1.0 + h))[2][0] - at(0.137 * (1.0 - h))[2][0]) / (2.0 * h);
        assert!((at(0.137)[2][1] - difference).abs() < 1e-8);
    }

    #[test]
    fn limit_line_contact() {
        use std::f64::consts::PI;
        for poisson in [0.0, 0.25, 0.5] {
            let c = KalkerCoefficients::new(poisson).unwrap().at(0.05);
            assert!((c.longitudinal / (PI * PI / (4.0 * (1.0 - poisson))) - 1.0).abs() < 0.02, "{poisson}: {c:?}");
            assert!((c.lateral / (PI * PI / 4.0) - 1.0).abs() < 0.02, "{poisson}: {c:?}");
        }
    }

    #[test]
    fn limit_impossible_poisson_ratios_are_refused() {
        for value in [-0.1, 0.6, f64::NAN] {
            assert!(matches!(KalkerCoefficients::new(value), Err(TractionError::PoissonRatio { .. })));
        }
    }
}
