//! Loads, springs and dampers of a ring that is free to tilt.

use tribodyn_bearing::{RingState, Tilt, TiltingRing};

/// A ring that is free to tilt.
#[derive(Debug, Clone)]
pub(crate) struct Tilting {
    pub body: TiltingRing,
    /// Moments on it about x and y over time; where the case holds a tilt, springs hold the ring there at the start.
    pub loads: [Tilt; 2],
    /// Tilts at which its springs carry nothing, but for those of its seat, rad.
    pub reference: [f64; 2],
}

/// Moment, powers and energy of loads, springs and dampers on a ring.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outside {
    /// Moment about x, y and z, N m.
    pub moment: [f64; 3],
    /// Power that the loads put in, W.
    pub put_in: f64,
    /// Power that the dampers take, W.
    pub lost: f64,
    /// Energy of the springs, J.
    pub energy: f64,
    /// Torque of the drive that turns a seat which stands askew, N m.
    pub drive: f64,
}

impl Tilting {
    pub fn new(body: TiltingRing, loads: [Tilt; 2]) -> Self {
        Self { body, loads, reference: [0.0; 2] }
    }

    /// Sets the springs for a start at tilts (rad) under moments of the ring on the balls about x and y, N m: those of
    /// a tilt that is held carry it, the others carry nothing.
    pub fn set_springs(&mut self, tilts: [f64; 2], on_balls: [f64; 2]) {
        for k in 0..2 {
            let held = matches!(self.loads[k], Tilt::Held(_));
            self.reference[k] = tilts[k] + if held { on_balls[k] / self.body.stiffness[k] } else { 0.0 };
        }
    }

    /// Tilts of the seat when the ring has turned by an angle, rad.
    pub fn seat(&self, angle: f64) -> [f64; 2] {
        let ([x, y], (sin, cos)) = (self.body.askew, angle.sin_cos());
        [x * cos - y * sin, x * sin + y * cos]
    }

    /// Loads, springs and dampers on the ring when it has turned by an angle, rad.
    pub fn outside(&self, (t, angle): (f64, f64), ring: &RingState, turning: [f64; 3]) -> Outside {
        let ([x, y], rates, [seat_x, seat_y]) = (ring.tilt, tilt_rates(ring, turning), self.seat(angle));
        let c = ring.axis()[2];
        let loads = self.loads.each_ref().map(|load| if let Tilt::Held(_) = load { 0.0 } else { load.at(t) });
        let (by_turn, seat) = ([-seat_y, seat_x], [seat_x, seat_y]);
        let stretch = [0, 1].map(|k| ring.tilt[k] - self.reference[k] - seat[k]);
        let stretching = [0, 1].map(|k| rates[k] - ring.speed * by_turn[k]);
        let held = [0, 1].map(|k| -self.body.stiffness[k] * stretch[k] - self.body.damping[k] * stretching[k]);
        // Moments that work on the rates of the tilts: θ_x' = ω_x c − ω_z θ_y, θ_y' = ω_y c + ω_z θ_x.
        Outside {
            moment: [loads[0] + held[0] * c, loads[1] + held[1] * c, held[1] * x - held[0] * y],
            put_in: loads[0] * turning[0] + loads[1] * turning[1],
            lost: (0..2).map(|k| self.body.damping[k] * stretching[k] * stretching[k]).sum(),
            energy: (0..2).map(|k| 0.5 * self.body.stiffness[k] * stretch[k] * stretch[k]).sum(),
            drive: held[0] * by_turn[0] + held[1] * by_turn[1],
        }
    }
}

/// Rates of a ring's tilts by its angular velocity across its axis, rad/s.
pub(crate) fn tilt_rates(ring: &RingState, [w_x, w_y, w_z]: [f64; 3]) -> [f64; 2] {
    let ([x, y], c) = (ring.tilt, ring.axis()[2]);
    [w_x * c - w_z * y, w_y * c + w_z * x]
}
