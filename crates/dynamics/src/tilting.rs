//! Loads, springs and dampers of an inner ring that is free to tilt.

use tribodyn_bearing::{RingState, Tilt, TiltingRing};

/// An inner ring that is free to tilt.
#[derive(Debug, Clone)]
pub(crate) struct Tilting {
    pub body: TiltingRing,
    /// Moments on it about x and y over time.
    pub loads: [Tilt; 2],
    /// Tilts at which its springs carry nothing, rad.
    pub reference: [f64; 2],
}

impl Tilting {
    pub fn new(body: TiltingRing, loads: [Tilt; 2]) -> Self {
        Self { body, loads, reference: [0.0; 2] }
    }

    /// Moment about x, y and z on the ring by loads, springs and dampers, N m, their power put in and lost, W, and the
    /// energy of the springs, J.
    pub fn outside(&self, t: f64, ring: &RingState, turning: [f64; 3]) -> ([f64; 3], [f64; 3]) {
        let ([x, y], rates) = (ring.tilt, tilt_rates(ring, turning));
        let c = ring.axis()[2];
        let loads = [0, 1].map(|k| self.loads[k].at(t));
        let stretch = [0, 1].map(|k| ring.tilt[k] - self.reference[k]);
        let held = [0, 1].map(|k| -self.body.stiffness[k] * stretch[k] - self.body.damping[k] * rates[k]);
        // Moments that work on the rates of the tilts: θ_x' = ω_x c − ω_z θ_y, θ_y' = ω_y c + ω_z θ_x.
        let moment = [loads[0] + held[0] * c, loads[1] + held[1] * c, held[1] * x - held[0] * y];
        let put_in = loads[0] * turning[0] + loads[1] * turning[1];
        let lost = (0..2).map(|k| self.body.damping[k] * rates[k] * rates[k]).sum();
        let energy = (0..2).map(|k| 0.5 * self.body.stiffness[k] * stretch[k] * stretch[k]).sum();
        (moment, [put_in, lost, energy])
    }
}

/// Rates of a ring's tilts by its angular velocity across its axis, rad/s.
pub(crate) fn tilt_rates(ring: &RingState, [w_x, w_y, w_z]: [f64; 3]) -> [f64; 2] {
    let ([x, y], c) = (ring.tilt, ring.axis()[2]);
    [w_x * c - w_z * y, w_y * c + w_z * x]
}
