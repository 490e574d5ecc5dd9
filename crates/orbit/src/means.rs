//! Means over the turn of what a ball does.

use crate::system::{Evaluation, RING};
use tribodyn_bearing::Side;

/// Means over the turn, or sums over balls, of what they do.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Means {
    /// Torque on the cage, N m.
    pub cage: f64,
    pub ring: [f64; RING],
    pub torque: f64,
    pub friction: [f64; 2],
    pub fluid: f64,
    pub pocket: f64,
}

impl Means {
    /// Adds a ball with a weight.
    pub fn add(&mut self, e: &Evaluation, weight: f64) {
        self.cage += weight * e.cage_torque;
        self.ring.iter_mut().zip(e.ring).for_each(|(sum, f)| *sum += weight * f);
        self.torque += weight * e.torque;
        for side in Side::BOTH {
            self.friction[side as usize] += weight * e.loads.contacts[side].traction.power;
        }
        let churning: f64 = e.friction.churning.iter().zip(e.state.angular_velocity).map(|(m, w)| m * w).sum();
        self.fluid += weight * (e.friction.drag * e.loads.orbit_radius * e.state.orbital_speed - churning);
        self.pocket += weight * (e.friction.pocket.friction_power + e.friction.pocket.damping_power);
    }
}
