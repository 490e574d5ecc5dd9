//! An inner ring that is free to tilt, with what turns with it: a rigid body of revolution.
//!
//! ```text
//! I_t dω/dt = M − I_p Ω ω × e    ω across the axis e, M the moment across it about the ring's centre
//! de/dt = ω × e                  e = (θ_y, −θ_x, sqrt(1 − θ_x² − θ_y²))
//! ```
//!
//! The drive keeps the speed Ω about e, so that ω stays across it; it may change in time.

use crate::forces::{BodyForces, Sums};
use crate::machine::Machine;
use crate::tilting::tilt_rates;
use tribodyn_bearing::RingState;
use tribodyn_bearing::vectors::dot;

impl Machine {
    /// Tilts of the inner ring at a state (rad), and its angular velocity across its axis where it is free to tilt.
    pub fn tilt_at(&self, y: &[f64]) -> ([f64; 2], Option<[f64; 3]>) {
        let Some(&[tilt_x, tilt_y, w_x, w_y]) = y.get(self.layout.tilt()).and_then(|y| y.first_chunk::<4>()) else {
            return (self.tilt, None);
        };
        let axis = RingState { tilt: [tilt_x, tilt_y], ..RingState::centred(0.0) }.axis();
        let along = -(w_x * axis[0] + w_y * axis[1]) / axis[2];
        ([tilt_x, tilt_y], Some([w_x, w_y, along]))
    }

    /// Moment about x and y on a ring that is free to tilt by its own turning, −I_p Ω ω × e, N m.
    pub fn gyroscopic_moment(&self, ring: &RingState) -> [f64; 2] {
        let (Some(tilting), Some([w_x, w_y, w_z])) = (&self.tilting, ring.turning) else { return [0.0; 2] };
        let ([e_x, e_y, e_z], spin) = (ring.axis(), tilting.body.polar_inertia * ring.speed);
        [-spin * (w_y * e_z - w_z * e_y), -spin * (w_z * e_x - w_x * e_z)]
    }

    /// Rates, powers and energy of a ring that is free to tilt.
    pub fn tilting_body(&self, t: f64, ring: &RingState, sums: &Sums, f: &mut BodyForces) {
        let (Some(tilting), Some(turning)) = (&self.tilting, ring.turning) else { return };
        let inertia = tilting.body.transverse_inertia;
        let (outside, [put_in, lost, energy]) = tilting.outside(t, ring, turning);
        let moment = [0, 1, 2].map(|k| outside[k] - sums.moment[k]);
        let axis = ring.axis();
        let along = dot(moment, axis);
        let gyroscopic = self.gyroscopic_moment(ring);
        let about = [0, 1].map(|k| (moment[k] - along * axis[k] + gyroscopic[k]) / inertia);
        let [x, y] = tilt_rates(ring, turning);
        f.tilt = Some([x, y, about[0], about[1]]);
        f.load_power += put_in;
        f.support_loss += lost;
        f.energy += energy + 0.5 * inertia * dot(turning, turning);
    }

    /// Moves the tilts of a ring on over a time, s, by the rates in its middle.
    pub fn glide_tilt(&self, y: &mut [f64], h: f64) {
        if self.tilting.is_none() {
            return;
        }
        let at = self.layout.tilt().start;
        let rates = |y: &[f64]| {
            let (tilt, turning) = self.tilt_at(y);
            tilt_rates(&RingState { tilt, ..RingState::centred(0.0) }, turning.unwrap_or_default())
        };
        let start = [y[at], y[at + 1]];
        let first = rates(y);
        (0..2).for_each(|k| y[at + k] = start[k] + 0.5 * h * first[k]);
        let middle = rates(y);
        (0..2).for_each(|k| y[at + k] = start[k] + h * middle[k]);
    }

    /// Puts a ring that is free to tilt where it stands at the start, its springs without stretch.
    pub fn start_tilt(&mut self, state: &mut [f64]) {
        let Some(tilting) = &mut self.tilting else { return };
        tilting.reference = self.tilt;
        let at = self.layout.tilt().start;
        state[at..at + 2].copy_from_slice(&self.tilt);
    }
}
