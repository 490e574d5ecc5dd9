//! Natural modes of a shaft that turns: M u'' + (C + ω G) u' + K u = 0.
//!
//! With M = L Lᵀ and y = Lᵀ u the equations are those of unit masses, y'' + D y' + S y = 0, whose eigenvalues are those
//! of [0, w; −S/w, −D] for any w; w² is of the size of S, so that the matrix is balanced.

use crate::element::FREEDOMS;
use crate::error::ShaftError;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use serde::Serialize;
use std::f64::consts::TAU;

/// Which way the shaft whirls in a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Whirl {
    /// With the rotation.
    Forward,
    /// Against it.
    Backward,
    /// In a plane, to and fro, or some parts with and some against the rotation.
    Mixed,
    /// Along the axis.
    Axial,
}

impl Whirl {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Forward => "forward",
            Self::Backward => "backward",
            Self::Mixed => "mixed",
            Self::Axial => "axial",
        }
    }
}

/// One natural mode.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mode {
    /// Frequency of the damped oscillation, Hz.
    pub frequency_hz: f64,
    /// Damping ratio −Re λ/|λ|; below 0 where the mode grows.
    pub damping_ratio: f64,
    /// Sense of whirl.
    pub whirl: Whirl,
    /// Amplitudes of each node along x, y, z over the largest of all.
    pub shape: Vec<[f64; 3]>,
    /// The same with their phases: real and imaginary part of x, y, z.
    #[serde(skip)]
    pub motion: Vec<[[f64; 2]; 3]>,
}

/// Matrices of a shaft with its supports, linear about an equilibrium.
#[derive(Debug, Clone)]
pub struct LinearShaft {
    /// Mass, kg and kg m².
    pub mass: Mat<f64>,
    /// Damping, N s/m and N m s/rad.
    pub damping: Mat<f64>,
    /// Gyroscopic matrix of 1 rad/s, kg m².
    pub gyroscopic: Mat<f64>,
    /// Stiffness, N/m and N m/rad.
    pub stiffness: Mat<f64>,
}

/// Frequency below which a motion counts as one without resistance, over the highest one: rounding splits a double root
/// at 0 by the square root of its own size.
const RIGID: f64 = 1e-6;
/// Share of the area of its orbits that a mode must go round one way to be forward or backward.
const ONE_WAY: f64 = 0.5;
/// Largest share of an orbit's square that is area where a node moves to and fro.
const FLAT: f64 = 1e-6;

impl LinearShaft {
    /// Modes at a speed of rotation in rad/s, by growing frequency; motions that meet no resistance and those that
    /// creep are left out.
    ///
    /// # Errors
    /// [`ShaftError::Massless`], [`ShaftError::Size`] and [`ShaftError::Eigenvalues`].
    pub fn modes(&self, speed: f64) -> Result<Vec<Mode>, ShaftError> {
        let n = self.mass.nrows();
        for matrix in [&self.damping, &self.gyroscopic, &self.stiffness] {
            if matrix.nrows() != n || matrix.ncols() != n {
                return Err(ShaftError::Size { found: matrix.nrows(), expected: n });
            }
        }
        let factors = self.mass.llt(Side::Lower).map_err(|_| ShaftError::Massless)?;
        let lower = factors.L().to_owned();
        let unit_mass = |matrix: &Mat<f64>| {
            let half = lower_solve(&lower, matrix);
            lower_solve(&lower, &half.transpose().to_owned()).transpose().to_owned()
        };
        let stiffness = unit_mass(&self.stiffness);
        let damping = unit_mass(&(&self.damping + speed * &self.gyroscopic));
        let largest = (0..n).map(|k| stiffness[(k, k)].abs()).fold(0.0, f64::max);
        let scale = largest.sqrt().max(f64::MIN_POSITIVE);
        let first_order = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => 0.0,
            (true, false) => f64::from(u8::from(i == j - n)) * scale,
            (false, true) => -stiffness[(i - n, j)] / scale,
            (false, false) => -damping[(i - n, j - n)],
        });
        let eigen = first_order.eigen().map_err(|_| ShaftError::Eigenvalues)?;
        let (values, vectors) = (eigen.S(), eigen.U());
        let mut modes = Vec::new();
        for k in 0..2 * n {
            let value = values[k];
            if value.im <= RIGID * scale || !value.im.is_finite() {
                continue;
            }
            let parts = Mat::from_fn(n, 2, |i, part| if part == 0 { vectors[(i, k)].re } else { vectors[(i, k)].im });
            let motion = factors_upper_solve(&lower, &parts);
            modes.push(mode((value.re, value.im), &motion, speed));
        }
        modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
        Ok(modes)
    }

    /// Displacements of all freedoms (real and imaginary part) under forces that swing at a frequency (rad/s) while the
    /// shaft turns at a speed. Forces of which there are fewer than freedoms are on the first of them.
    ///
    /// # Errors
    /// [`ShaftError::Size`].
    pub fn response(&self, speed: f64, frequency: f64, force: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, ShaftError> {
        let n = self.mass.nrows();
        if force.len() > n {
            return Err(ShaftError::Size { found: force.len(), expected: n });
        }
        // [K − ω² M, −ω D; ω D, K − ω² M] (re, im) = (re, im).
        let real = |i: usize, j: usize| self.stiffness[(i, j)] - frequency.powi(2) * self.mass[(i, j)];
        let damping = |i: usize, j: usize| frequency * (self.damping[(i, j)] + speed * self.gyroscopic[(i, j)]);
        let whole = Mat::from_fn(2 * n, 2 * n, |i, j| match (i < n, j < n) {
            (true, true) => real(i, j),
            (true, false) => -damping(i, j - n),
            (false, true) => damping(i - n, j),
            (false, false) => real(i - n, j - n),
        });
        let right = Mat::from_fn(2 * n, 1, |i, _| force.get(i % n).map_or(0.0, |parts| parts[i / n]));
        let solved = whole.partial_piv_lu().solve(&right);
        Ok((0..n).map(|i| [solved[(i, 0)], solved[(i + n, 0)]]).collect())
    }
}

/// L⁻¹ A.
fn lower_solve(lower: &Mat<f64>, matrix: &Mat<f64>) -> Mat<f64> {
    let mut solved = matrix.clone();
    faer::linalg::triangular_solve::solve_lower_triangular_in_place(lower.as_ref(), solved.as_mut(), faer::Par::Seq);
    solved
}

/// L⁻ᵀ A.
fn factors_upper_solve(lower: &Mat<f64>, matrix: &Mat<f64>) -> Mat<f64> {
    let mut solved = matrix.clone();
    faer::linalg::triangular_solve::solve_upper_triangular_in_place(lower.transpose(), solved.as_mut(), faer::Par::Seq);
    solved
}

fn mode((re, im): (f64, f64), motion: &Mat<f64>, speed: f64) -> Mode {
    let nodes = motion.nrows() / FREEDOMS;
    let at = |node: usize, k: usize| [motion[(FREEDOMS * node + k, 0)], motion[(FREEDOMS * node + k, 1)]];
    let size = |[re, im]: [f64; 2]| re.hypot(im);
    let all: Vec<[[f64; 2]; 3]> = (0..nodes).map(|node| std::array::from_fn(|k| at(node, k))).collect();
    let largest = all.iter().flatten().map(|&v| size(v)).fold(f64::MIN_POSITIVE, f64::max);
    // With e^{iωt}: x Re, y Im … an orbit's area, positive where it runs from x to y.
    let (mut round, mut unsigned, mut square, mut axial) = (0.0, 0.0, 0.0, 0.0);
    for [x, y, z] in &all {
        let area = x[1] * y[0] - x[0] * y[1];
        round += area;
        unsigned += area.abs();
        square += size(*x).powi(2) + size(*y).powi(2);
        axial += size(*z).powi(2);
    }
    let whirl = if axial > square {
        Whirl::Axial
    } else if unsigned <= FLAT * square || round.abs() < ONE_WAY * unsigned || speed == 0.0 {
        Whirl::Mixed
    } else if round * speed > 0.0 {
        Whirl::Forward
    } else {
        Whirl::Backward
    };
    Mode {
        frequency_hz: im / TAU,
        damping_ratio: -re / re.hypot(im),
        whirl,
        shape: all.iter().map(|node| node.map(|v| size(v) / largest)).collect(),
        motion: all.iter().map(|node| node.map(|v| v.map(|part| part / largest))).collect(),
    }
}
