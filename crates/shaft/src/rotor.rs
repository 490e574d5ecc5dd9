//! A shaft of beam elements with its discs, and its matrices.

use crate::element::{Element, ElementMatrix, FREEDOMS};
use crate::error::ShaftError;
use faer::Mat;

/// A rigid disc on a node: a gear, a pulley, an impeller.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Node, from 0.
    pub node: usize,
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about a diameter through the node, kg m².
    pub transverse_inertia: f64,
    /// Moment of inertia about the shaft's axis, kg m².
    pub polar_inertia: f64,
}

/// A shaft along z, its first node at z = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    elements: Vec<Element>,
    discs: Vec<Disc>,
    inextensible: bool,
}

/// Axial stiffness of an inextensible shaft over that of its elements: more would drown the forces in rounding.
const INEXTENSIBLE: f64 = 1e5;

impl Shaft {
    /// From its elements in the order of z, and discs on its nodes.
    ///
    /// # Errors
    /// [`ShaftError::Element`] for a length, diameter or material that no beam has, [`ShaftError::Node`] for a disc on
    /// a node that is not there.
    pub fn new(elements: Vec<Element>, discs: Vec<Disc>) -> Result<Self, ShaftError> {
        let positive = |v: f64| v.is_finite() && v > 0.0;
        for (index, element) in elements.iter().enumerate() {
            let refuse = |quantity, value| Err(ShaftError::Element { index, quantity, value });
            if !positive(element.length) {
                return refuse("length", element.length);
            }
            for section in [element.start, element.end] {
                if !(positive(section.outer) && section.inner >= 0.0 && section.inner < section.outer) {
                    return refuse("outer diameter over inner diameter", section.outer / section.inner);
                }
            }
            let material = element.material;
            if !(positive(material.young) && positive(material.shear) && positive(material.density)) {
                return refuse("Young's modulus", material.young);
            }
        }
        let shaft = Self { elements, discs, inextensible: false };
        match shaft.discs.iter().find(|disc| disc.node >= shaft.nodes()) {
            Some(disc) => Err(ShaftError::Node { node: disc.node, nodes: shaft.nodes() }),
            None => Ok(shaft),
        }
    }

    /// The same shaft without elasticity along z, as it is where all nodes share one axial freedom.
    #[must_use]
    pub fn inextensible(self) -> Self {
        Self { inextensible: true, ..self }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.elements.len() + 1
    }

    /// Elements in the order of z.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// Discs.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// z of each node, m.
    pub fn positions(&self) -> Vec<f64> {
        let mut at = vec![0.0];
        for element in &self.elements {
            at.push(at[at.len() - 1] + element.length);
        }
        at
    }

    /// Mass with discs, kg.
    pub fn mass(&self) -> f64 {
        self.elements.iter().map(Element::mass).sum::<f64>() + self.discs.iter().map(|disc| disc.mass).sum::<f64>()
    }

    /// Stiffness of the free shaft over all nodes' x, y, z (N/m) and tilts about X, Y (N m/rad).
    pub fn stiffness(&self) -> Mat<f64> {
        self.assembled(|element| {
            let mut matrix = element.stiffness();
            if self.inextensible {
                let along = [2, FREEDOMS + 2];
                along.into_iter().for_each(|i| along.into_iter().for_each(|j| matrix[(i, j)] *= INEXTENSIBLE));
            }
            matrix
        })
    }

    /// Consistent mass matrix with rotary inertia and discs, kg and kg m².
    pub fn mass_matrix(&self) -> Mat<f64> {
        let mut matrix = self.assembled(Element::mass_matrix);
        for disc in &self.discs {
            let at = FREEDOMS * disc.node;
            (0..3).for_each(|k| matrix[(at + k, at + k)] += disc.mass);
            (3..FREEDOMS).for_each(|k| matrix[(at + k, at + k)] += disc.transverse_inertia);
        }
        matrix
    }

    /// Gyroscopic matrix for a rotation of 1 rad/s about +z, kg m².
    pub fn gyroscopic(&self) -> Mat<f64> {
        let mut matrix = self.assembled(Element::gyroscopic);
        for disc in &self.discs {
            let (x, y) = (FREEDOMS * disc.node + 3, FREEDOMS * disc.node + 4);
            matrix[(x, y)] += disc.polar_inertia;
            matrix[(y, x)] -= disc.polar_inertia;
        }
        matrix
    }

    fn assembled(&self, of: impl Fn(&Element) -> ElementMatrix) -> Mat<f64> {
        let n = FREEDOMS * self.nodes();
        let mut matrix = Mat::zeros(n, n);
        for (index, element) in self.elements.iter().enumerate() {
            let (part, at) = (of(element), FREEDOMS * index);
            for i in 0..2 * FREEDOMS {
                for j in 0..2 * FREEDOMS {
                    matrix[(at + i, at + j)] += part[(i, j)];
                }
            }
        }
        matrix
    }
}
