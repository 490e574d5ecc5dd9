//! Settings of the solver.

/// Settings of the solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitSettings {
    /// Largest error of an interval, over a tenth of the elastic approach under the mean load of a ball, 0.001 of the
    /// orbital speed and 0.001 of the angular velocity: the mesh follows from it.
    pub mesh_error: f64,
    /// Largest relative residual of any balance.
    pub tolerance: f64,
    /// Damping ratio ζ of the ball–race contacts that the orbit has at least.
    pub contact_damping: f64,
    /// Damping of the pockets that the orbit has at least, as χ of Hunt and Crossley times a hundredth of the orbital
    /// velocity.
    pub pocket_damping: f64,
}

impl Default for OrbitSettings {
    /// Intervals good to 5e-3 of the approach and 5e-5 of the speeds, 1e-10; damping that ends the bouncing of idle
    /// balls, which has no part in a mean: at a χ v of 10 a ball keeps a tenth of the velocity with which it meets the
    /// wall.
    fn default() -> Self {
        Self { mesh_error: 5e-2, tolerance: 1e-10, contact_damping: 0.1, pocket_damping: 10.0 }
    }
}
