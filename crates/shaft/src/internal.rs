//! Forces and moments within the shaft, and the stresses that they bring about.

use crate::element::FREEDOMS;
use crate::ring::Vector;
use crate::rotor::Shaft;
use crate::section::Section;

/// Forces at a cut that the part of the shaft beyond it (at larger z) exerts on the part before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Place, m.
    pub position: f64,
    /// Section just there.
    pub section: Section,
    /// Shear forces along x and y and axial force (N), bending moments about X and Y (N m).
    pub force: Vector,
}

impl Shaft {
    /// Cuts at both ends of every element, for displacements of the nodes.
    pub fn cuts(&self, nodes: &[Vector]) -> Vec<[Cut; 2]> {
        let positions = self.positions();
        let all = self.elements().iter().enumerate();
        all.map(|(index, element)| {
            let ends: Vec<f64> = nodes[index].iter().chain(&nodes[index + 1]).copied().collect();
            let stiffness = element.stiffness();
            let on_element: Vec<f64> =
                (0..2 * FREEDOMS).map(|i| (0..2 * FREEDOMS).map(|j| stiffness[(i, j)] * ends[j]).sum()).collect();
            // At the start the element itself lies beyond the cut.
            let at_start = std::array::from_fn(|k| -on_element[k]);
            let at_end = std::array::from_fn(|k| on_element[FREEDOMS + k]);
            [
                Cut { position: positions[index], section: element.start, force: at_start },
                Cut { position: positions[index + 1], section: element.end, force: at_end },
            ]
        })
        .collect()
    }
}

impl Cut {
    /// Bending moment in any plane, N m.
    pub fn bending_moment(&self) -> f64 {
        self.force[3].hypot(self.force[4])
    }

    /// Bending stress at the surface, Pa.
    pub fn bending_stress(&self) -> f64 {
        self.bending_moment() * 0.5 * self.section.outer / self.section.second_moment()
    }

    /// Axial stress, Pa.
    pub fn axial_stress(&self) -> f64 {
        self.force[2] / self.section.area()
    }

    /// Shear stress at the surface under a torque (N m), Pa.
    pub fn torsion_stress(&self, torque: f64) -> f64 {
        torque * 0.25 * self.section.outer / self.section.second_moment()
    }

    /// Equivalent stress of von Mises at the surface under a torque (N m), Pa: nominal, without notches.
    pub fn equivalent_stress(&self, torque: f64) -> f64 {
        let normal = self.bending_stress() + self.axial_stress().abs();
        (normal.powi(2) + 3.0 * self.torsion_stress(torque).powi(2)).sqrt()
    }
}
