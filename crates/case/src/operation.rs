//! From a case to an operating point of its bearing.

use crate::{Case, Tilt, Translation};
use tribodyn_bearing::{Cage, OperatingPoint, RingFreedom, SolverSettings};

impl Case {
    /// The case's operating point; where loads or speeds are tables in time, their last row, the steady state.
    pub fn operating_point(&self) -> OperatingPoint {
        self.operating_point_at(f64::INFINITY)
    }

    /// The case's operating point with the loads and speeds of a time in s.
    pub fn operating_point_at(&self, time: f64) -> OperatingPoint {
        let translation = |t: &Translation| match t {
            Translation::Held(x) => RingFreedom::Held(*x),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        let tilt = |t: &Tilt| match t {
            Tilt::Held(angle) => RingFreedom::Held(*angle),
            loaded => RingFreedom::Loaded(loaded.at(time)),
        };
        let (r, cage, numerics) = (&self.ring, &self.cage, &self.numerics);
        OperatingPoint {
            ring: [translation(&r.x), translation(&r.y), translation(&r.z), tilt(&r.tilt_x), tilt(&r.tilt_y)],
            inner_speed: self.speed.inner.at(time),
            outer_speed: self.speed.outer.at(time),
            patch: self.traction.patch,
            cage: Cage {
                pocket_gap: cage.pocket_gap,
                pocket_stiffness: cage.pocket_stiffness,
                drag_torque: cage.drag_torque,
            },
            numerics: SolverSettings {
                tolerance: numerics.tolerance,
                max_iterations: numerics.max_iterations,
                centrifugal_at_free_pitch: numerics.centrifugal_at_free_pitch,
                race_control: numerics.race_control,
            },
        }
    }
}
