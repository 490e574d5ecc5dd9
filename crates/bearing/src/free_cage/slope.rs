//! How a force and moment on a cage change with its velocities: films and friction are stiff, an implicit step asks.

use super::{CagePose, FreeCage, Wrench};
use crate::vectors::{add, cross, dot, scaled};

/// A velocity that a force depends on: linear in the velocity of the centre of mass and in the angular velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gauge {
    /// Its change by each velocity of the centre of mass.
    pub velocity: [f64; 3],
    /// Its change by each angular velocity, m.
    pub omega: [f64; 3],
}

impl Gauge {
    /// The velocity in a direction of the point of the cage at an arm (m) from the centre of mass.
    pub fn of_point(direction: [f64; 3], arm: [f64; 3]) -> Self {
        Self { velocity: direction, omega: cross(arm, direction) }
    }

    /// The angular velocity about a direction.
    pub fn of_turning(direction: [f64; 3]) -> Self {
        Self { velocity: [0.0; 3], omega: direction }
    }
}

/// Slopes of force (x, y, z) and moment (x, y, z) about the centre of mass, row by row, by velocity and angular
/// velocity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WrenchSlope(pub [[f64; 6]; 6]);

impl WrenchSlope {
    /// Adds what a force at an arm (m) from the centre of mass and a moment beside it gain by a gauge.
    pub fn add(&mut self, gauge: &Gauge, arm: [f64; 3], (force, moment): ([f64; 3], [f64; 3])) {
        let moment = add(moment, cross(arm, force));
        let ([a, b, c], [d, e, f]) = (gauge.velocity, gauge.omega);
        let by = [a, b, c, d, e, f];
        for k in 0..3 {
            self.0[k].iter_mut().zip(by).for_each(|(slope, by)| *slope += force[k] * by);
            self.0[3 + k].iter_mut().zip(by).for_each(|(slope, by)| *slope += moment[k] * by);
        }
    }
}

impl FreeCage {
    /// Slopes of the accelerations (x, y, z; about x, y, z) by one velocity and angular velocity after the other, under
    /// a wrench with slopes of its own. `inertia` is that about the axis, kg m².
    pub fn slopes_of_rates(&self, pose: &CagePose, wrench: &WrenchSlope, inertia: f64) -> [[f64; 6]; 6] {
        let (omega, n) = (pose.omega, pose.axes[2]);
        let (spin, about, excess) = (dot(omega, n), cross(omega, n), self.transverse_inertia - inertia);
        std::array::from_fn(|column| {
            let of = |first: usize| [0, 1, 2].map(|k| wrench.0[first + k][column]);
            let (force, mut moment) = (of(0), of(3));
            if column >= 3 {
                let unit = [3, 4, 5].map(|k| f64::from(u8::from(k == column)));
                let gyroscopic = add(scaled(cross(unit, n), spin), scaled(about, dot(unit, n)));
                moment = add(moment, scaled(gyroscopic, excess));
            }
            let ([x, y, z], [a, b, c]) = self.response(pose, &Wrench { force, moment }, inertia);
            [x, y, z, a, b, c]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{INERTIA, cage, film, land, pose};
    use super::*;
    use crate::free_cage::CageLand;
    use crate::races::Side;
    use crate::state::RingState;
    use tribodyn_fluid::FilmExtent;

    /// The slopes of a land against differences of its force and moment: pressed edges, film torn and full, laminar and
    /// turbulent; and those of the accelerations, gyroscopic moment included.
    #[test]
    fn identity_slopes_of_a_land_are_those_of_its_wrench() {
        for (side, film) in Side::BOTH.into_iter().flat_map(|side| {
            [None, Some(film(FilmExtent::Half)), Some(film(FilmExtent::Full))].map(|film| (side, film))
        }) {
            let land = CageLand { axial: 2e-3, ..land(side, film) };
            let cage = FreeCage { unbalance: 3e-5, ..cage(vec![land]) };
            let ring = RingState { tilt: [3e-4, -2e-4], velocity: [0.05, -0.02, 0.01], ..RingState::centred(900.0) };
            for place in [[1.2e-4, 0.9e-4, 1e-5], [5e-5, -2e-5, 0.0]] {
                let pose = pose(&cage, [0.4, 380.0], place, [0.6, 0.3, -0.1], [5.0, -9.0], [4e-3, 1e-3]);
                let load = land.load(&pose, (&ring, 7e-4));
                let slopes = cage.slopes_of_rates(&pose, &load.slope, INERTIA);
                let accelerations = |column: usize, by: f64| {
                    let mut pose = pose;
                    if column < 3 {
                        pose.velocity[column] += by
                    } else {
                        pose.omega[column - 3] += by
                    }
                    let ([_, _, _, x, y, z, a, b, ..], c) =
                        cage.rates(&pose, &land.load(&pose, (&ring, 7e-4)).on_cage, INERTIA);
                    [x, y, z, a, b, c]
                };
                for (column, slopes) in slopes.iter().enumerate() {
                    let by = if column < 3 { 1e-5 } else { 1e-3 };
                    let (after, before) = (accelerations(column, by), accelerations(column, -by));
                    let exact: [f64; 6] = std::array::from_fn(|k| (after[k] - before[k]) / (2.0 * by));
                    let size = exact.iter().fold(1.0, |most: f64, slope| most.max(slope.abs()));
                    for (row, exact) in exact.iter().enumerate() {
                        let error = (slopes[row] - exact).abs();
                        assert!(error < 1e-5 * size, "{side:?} {film:?} {row} {column}: {error:e} of {exact:e}");
                    }
                }
            }
        }
    }
}
