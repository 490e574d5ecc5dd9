//! The shaft about an equilibrium, for modes and for what swings.

use crate::element::FREEDOMS;
use crate::equilibrium::Equilibrium;
use crate::error::ShaftError;
use crate::modes::LinearShaft;
use crate::ring::Held;
use crate::system::System;
use faer::Mat;
use faer::linalg::solvers::Solve;

impl System<'_> {
    /// Masses, damping and stiffness about an equilibrium, over the freedoms of the nodes, then of seats with a mass.
    /// Seats without one follow at once and drop out. `damping` is that of each bearing along x, y, z (N s/m), none
    /// where it is empty.
    ///
    /// # Errors
    /// [`ShaftError::Size`].
    pub fn linearised(&self, at: &Equilibrium, damping: &[[f64; 3]]) -> Result<LinearShaft, ShaftError> {
        let held: Vec<Held> =
            at.stiffnesses.iter().map(|&stiffness| Held { force: [0.0; FREEDOMS], stiffness }).collect();
        let tangent = self.tangent(&self.linear(), &held, &[0.0; FREEDOMS]);
        let edge = FREEDOMS * self.shaft.nodes();
        let mut kept: Vec<usize> = (0..edge).collect();
        let mut dropped = Vec::new();
        let mut masses = Vec::new();
        for (index, support) in self.supports.iter().enumerate() {
            for k in 0..FREEDOMS {
                let row = self.seat(index) + k;
                match support.seat.mass {
                    _ if self.is_held(index, k) => {}
                    Some(mass) if k < 3 => {
                        kept.push(row);
                        masses.push(mass);
                    }
                    _ => dropped.push(row),
                }
            }
        }
        // A freedom that nothing holds and nothing moves is not there.
        dropped.retain(|&row| tangent[(row, row)] > 0.0);
        let stiffness = condensed(&tangent, &kept, &dropped);
        let n = kept.len();
        let wider =
            |matrix: Mat<f64>| Mat::from_fn(n, n, |i, j| if i < edge && j < edge { matrix[(i, j)] } else { 0.0 });
        let mut mass = wider(self.shaft.mass_matrix());
        masses.iter().enumerate().for_each(|(k, value)| mass[(edge + k, edge + k)] = *value);
        let mut damper = Mat::zeros(n, n);
        for (index, (support, damping)) in self.supports.iter().zip(damping).enumerate() {
            for (k, value) in damping.iter().enumerate() {
                let node = FREEDOMS * support.node + k;
                let seat = kept.iter().position(|&row| row == self.seat(index) + k);
                damper[(node, node)] += value;
                if let Some(seat) = seat {
                    damper[(seat, seat)] += value;
                    damper[(node, seat)] -= value;
                    damper[(seat, node)] -= value;
                }
            }
        }
        Ok(LinearShaft { mass, damping: damper, gyroscopic: wider(self.shaft.gyroscopic()), stiffness })
    }
}

/// K_kk − K_kd K_dd⁻¹ K_dk.
fn condensed(matrix: &Mat<f64>, kept: &[usize], dropped: &[usize]) -> Mat<f64> {
    let part = |rows: &[usize], columns: &[usize]| {
        Mat::from_fn(rows.len(), columns.len(), |i, j| matrix[(rows[i], columns[j])])
    };
    let whole = part(kept, kept);
    if dropped.is_empty() {
        return whole;
    }
    let through = part(dropped, dropped).partial_piv_lu().solve(&part(dropped, kept));
    whole - part(kept, dropped) * through
}
