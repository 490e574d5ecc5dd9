//! The beam element: Timoshenko's, two nodes, with rotary inertia and the gyroscopic moments of its rotation.
//!
//! ```text
//! plane x–z: x, φ = θ_y;   plane y–z: y, φ = −θ_x;   Φ = 12 E I/(κ G A l²)
//! K = E I/((1 + Φ) l³) [12, 6l, −12, 6l; 6l, (4 + Φ) l², −6l, (2 − Φ) l²; …]
//! gyroscopic, rotation ω about +z:  plane x: + 2 ω R (y, −θ_x)',   plane y: − 2 ω R (x, θ_y)'
//! ```
//! R is the matrix of rotary inertia. The rows of mass and rotary inertia are Przemieniecki's (Theory of Matrix
//! Structural Analysis, 1968, section 11.6). An element that is conical has the mean properties along its length.

use crate::section::{Material, Section};
use nalgebra::{Matrix4, SMatrix};

/// Freedoms of a node: x, y, z, tilt about X, tilt about Y.
pub const FREEDOMS: usize = 5;
/// Matrix of an element over the freedoms of its two nodes.
pub(crate) type ElementMatrix = SMatrix<f64, 10, 10>;

/// A piece of shaft between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Element {
    /// Length, m.
    pub length: f64,
    /// Section at the node with the smaller z.
    pub start: Section,
    /// Section at the node with the larger z.
    pub end: Section,
    /// Material.
    pub material: Material,
}

/// Places and weights of Gauss and Legendre's rule with three points on 0 to 1: exact for the fourth powers of a cone.
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

impl Element {
    /// Mean of a property along the element.
    fn mean(&self, of: impl Fn(&Section) -> f64) -> f64 {
        GAUSS.iter().map(|(at, weight)| weight * of(&self.start.towards(&self.end, *at))).sum()
    }

    /// Mean area, m².
    pub fn area(&self) -> f64 {
        self.mean(Section::area)
    }

    /// Mean second moment of area, m⁴.
    pub fn second_moment(&self) -> f64 {
        self.mean(Section::second_moment)
    }

    /// Mass, kg.
    pub fn mass(&self) -> f64 {
        self.material.density * self.area() * self.length
    }

    /// Shear flexibility over bending flexibility, Φ.
    fn shear_share(&self) -> f64 {
        let Material { young, shear, .. } = self.material;
        let coefficient = self.mean(|section| section.shear_coefficient(self.material.poisson()));
        12.0 * young * self.second_moment() / (coefficient * shear * self.area() * self.length.powi(2))
    }

    pub(crate) fn stiffness(&self) -> ElementMatrix {
        let (l, p) = (self.length, self.shear_share());
        let unit = self.material.young * self.second_moment() / ((1.0 + p) * l.powi(3));
        let bending = symmetric(l, [12.0, 6.0, -12.0, 6.0, 4.0 + p, -6.0, 2.0 - p, 12.0, -6.0, 4.0 + p]) * unit;
        let mut matrix = in_planes(&bending);
        along(&mut matrix, Axial::SPRING * (self.material.young * self.area() / l));
        matrix
    }

    pub(crate) fn mass_matrix(&self) -> ElementMatrix {
        let (l, p) = (self.length, self.shear_share());
        let unit = self.mass() / (1.0 + p).powi(2);
        let m1 = 13.0 / 35.0 + 0.7 * p + p * p / 3.0;
        let m2 = 11.0 / 210.0 + 11.0 / 120.0 * p + p * p / 24.0;
        let m3 = 9.0 / 70.0 + 0.3 * p + p * p / 6.0;
        let m4 = -(13.0 / 420.0 + 3.0 / 40.0 * p + p * p / 24.0);
        let m5 = 1.0 / 105.0 + p / 60.0 + p * p / 120.0;
        let m6 = -(1.0 / 140.0 + p / 60.0 + p * p / 120.0);
        let moving = symmetric(l, [m1, m2, m3, m4, m5, -m4, m6, m1, -m2, m5]) * unit;
        let mut matrix = in_planes(&(moving + self.rotary()));
        along(&mut matrix, Axial::MASS * (self.mass() / 6.0));
        matrix
    }

    /// Rotary inertia in one plane.
    fn rotary(&self) -> Matrix4<f64> {
        let (l, p) = (self.length, self.shear_share());
        let unit = self.material.density * self.second_moment() / (l * (1.0 + p).powi(2));
        let r1 = 1.2;
        let r2 = 0.1 - 0.5 * p;
        let r3 = 2.0 / 15.0 + p / 6.0 + p * p / 3.0;
        let r4 = -1.0 / 30.0 - p / 6.0 + p * p / 6.0;
        symmetric(l, [r1, r2, -r1, r2, r3, -r2, r4, r1, -r2, r3]) * unit
    }

    /// Gyroscopic matrix for a rotation of 1 rad/s.
    pub(crate) fn gyroscopic(&self) -> ElementMatrix {
        let rotary = self.rotary() * 2.0;
        let mut matrix = ElementMatrix::zeros();
        for (i, (row_x, row_y, row_sign)) in PLANE.into_iter().enumerate() {
            for (j, (column_x, column_y, column_sign)) in PLANE.into_iter().enumerate() {
                matrix[(row_x, column_y)] += rotary[(i, j)] * column_sign;
                matrix[(row_y, column_x)] -= rotary[(i, j)] * row_sign;
            }
        }
        matrix
    }
}

/// Freedoms of one plane in the element's order: place in plane x–z, place in plane y–z, sign there.
const PLANE: [(usize, usize, f64); 4] = [(0, 1, 1.0), (4, 3, -1.0), (5, 6, 1.0), (9, 8, -1.0)];

/// The same matrix in both planes.
fn in_planes(plane: &Matrix4<f64>) -> ElementMatrix {
    let mut matrix = ElementMatrix::zeros();
    for (i, (row_x, row_y, row_sign)) in PLANE.into_iter().enumerate() {
        for (j, (column_x, column_y, column_sign)) in PLANE.into_iter().enumerate() {
            matrix[(row_x, column_x)] += plane[(i, j)];
            matrix[(row_y, column_y)] += plane[(i, j)] * row_sign * column_sign;
        }
    }
    matrix
}

/// The axial freedoms of an element.
struct Axial;

impl Axial {
    const SPRING: nalgebra::Matrix2<f64> = nalgebra::Matrix2::new(1.0, -1.0, -1.0, 1.0);
    const MASS: nalgebra::Matrix2<f64> = nalgebra::Matrix2::new(2.0, 1.0, 1.0, 2.0);
}

fn along(matrix: &mut ElementMatrix, axial: nalgebra::Matrix2<f64>) {
    for (i, row) in [2, 7].into_iter().enumerate() {
        for (j, column) in [2, 7].into_iter().enumerate() {
            matrix[(row, column)] += axial[(i, j)];
        }
    }
}

/// A symmetric matrix over (displacement, slope) of two nodes from its upper triangle by rows, slopes times the length.
fn symmetric(length: f64, [a, b, c, d, e, f, g, h, i, j]: [f64; 10]) -> Matrix4<f64> {
    let l = length;
    let (b, d, f, i) = (b * l, d * l, f * l, i * l);
    let (e, g, j) = (e * l * l, g * l * l, j * l * l);
    Matrix4::new(a, b, c, d, b, e, f, g, c, f, h, i, d, g, i, j)
}
